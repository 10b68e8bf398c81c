//! A described scene in the real types: what the adviser speaks about and never runs.

use fixstep::fixed::FixedI32;
use fixstep::fixed::types::extra::{U20, U21, U22, U23, U24, U25, U26, U27, U28, U29, U30, U31};
use fixstep::{Error, Point, RangeChecked, Scalar, Step, TimeStep, World};

use crate::described::{Described, ROOM};
use crate::flight::{Plan, Seen, Track};

/// What a flight shows.
pub struct Flown {
    pub track: Track,
    /// Whether any sum has reached the end of the range, ever.
    pub marked: bool,
}

impl<S: Scalar> Seen for RangeChecked<Point<S>> {}

pub fn fly<S: Scalar>(
    scene: &Described,
    plan: &Plan,
    step: &impl TimeStep<S>,
) -> Result<Flown, Error> {
    let mut world = World::<RangeChecked<Point<S>>, ROOM>::new();
    let mut forces = scene.build(&mut world, RangeChecked::new)?;
    let track = plan.fly(&mut world, &mut forces, step)?;
    let marked = world.bodies().iter().any(RangeChecked::was_outside);
    let outside = world.out_of_range().next().is_some();
    Ok(Flown {
        track,
        marked: marked || outside,
    })
}

macro_rules! types {
    ($($fraction:literal $bits:ident),*) => {
        /// In the type with that many fractional bits; `None` where it is none of these.
        pub fn fly_in(fraction: u32, scene: &Described, plan: &Plan) -> Option<Result<Flown, Error>> {
            match fraction {
                $($fraction => Some(Step::hz(plan.rate).and_then(|step| fly::<FixedI32<$bits>>(scene, plan, &step))),)*
                _ => None,
            }
        }
    };
}

types!(
    20 U20, 21 U21, 22 U22, 23 U23, 24 U24, 25 U25, 26 U26, 27 U27, 28 U28, 29 U29, 30 U30,
    31 U31
);
