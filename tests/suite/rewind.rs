//! Worlds that go back: as many steps as they made, to the same bits; and what is refused.

use crate::support;

#[path = "rewind/floats.rs"]
mod floats;
#[path = "rewind/gravity.rs"]
mod gravity;
#[path = "rewind/many_forces.rs"]
mod many_forces;
#[path = "rewind/range_checked.rs"]
mod range_checked;
#[path = "rewind/refused.rs"]
mod refused;
#[path = "rewind/saturation.rs"]
mod saturation;

use fixstep::{
    Body, BodyId, DyadicStep, Point, RangeChecked, Reverse, Reversible, Rewinds, Scalar,
    SemiImplicitEuler, Step, TimeStep, Verlet, World,
};

/// All that a world holds, marks and masses too.
type State<B> = (u64, Vec<BodyId>, Vec<B>);

fn state<B: Body, const N: usize>(world: &World<B, N>) -> State<B> {
    (world.tick(), world.ids().to_vec(), world.bodies().to_vec())
}

/// A world whose bodies remember the end of the range.
fn watched<B: Body + std::fmt::Debug, const N: usize>(bodies: [B; N]) -> World<RangeChecked<B>, N> {
    support::world(bodies.map(RangeChecked::new))
}

/// Makes `steps` steps and undoes them. Every `every` of them the state is kept, and must be there
/// again on the way back.
fn there_and_back<B, const N: usize>(
    name: &str,
    world: &mut World<RangeChecked<B>, N>,
    method: &mut impl Rewinds<RangeChecked<B>, N>,
    forces: &mut impl Reversible<RangeChecked<B>>,
    step: &impl TimeStep<B::S>,
    [steps, every]: [u64; 2],
) where
    B: Reverse + PartialEq + std::fmt::Debug,
{
    let mut kept = Vec::new();
    for tick in 0..steps {
        if tick % every == 0 {
            kept.push(state(world));
        }
        world.step(method, forces, step);
    }
    // Nothing is shown by bodies that stand still, or come round by themselves.
    for (i, (_, _, bodies)) in kept.iter().enumerate() {
        assert!(kept[..i].iter().all(|before| before.2 != *bodies), "{name}");
    }
    for tick in (0..steps).rev() {
        let undone = world.step_back(method, forces, step);
        assert_eq!(undone, Ok(()), "{name}: tick {tick}");
        if tick % every == 0 {
            assert_eq!(Some(state(world)), kept.pop(), "{name}: tick {tick}");
        }
    }
    assert!(world.tick() == 0 && kept.is_empty());
}

/// Runs `$run` for both methods that go back and both kinds of step, with a number for each run.
macro_rules! every_way {
    ($run:ident::<$scalar:ty>, $first:expr) => {{
        let (hz, dyadic) = (
            Step::<$scalar>::hz(60).unwrap(),
            DyadicStep::<$scalar, 1, 6>::new().unwrap(),
        );
        $run("SemiImplicitEuler, 1/60", $first, SemiImplicitEuler, &hz);
        $run("Verlet, 1/60", $first + 1, Verlet, &hz);
        $run(
            "SemiImplicitEuler, 1/64",
            $first + 2,
            SemiImplicitEuler,
            &dyadic,
        );
        $run("Verlet, 1/64", $first + 3, Verlet, &dyadic);
    }};
}
use every_way;
