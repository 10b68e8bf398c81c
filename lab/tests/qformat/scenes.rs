//! What a scene is asked, and what really happens in it.

use fixstep::fixed::types::I8F24;
use fixstep::{DyadicStep, Error, Ratio, Step, World};

use crate::advise::{Advice, Question, advise};
use crate::described::{Described, Forces, ROOM};
use crate::flight::{Plan, Scheme};
use crate::noted::Noted;
use crate::real::{self, Flown};
use crate::recorded::Recorded;

/// At 60 Hz by Verlet, with no more headroom than the scene itself needs.
pub fn question(seconds: f64) -> Question {
    Question {
        plan: Plan {
            method: Scheme::Verlet,
            rate: Ratio::new(60, 1).unwrap(),
            seconds,
            circle: None,
        },
        bears: 1e-3,
        headroom: 0.0,
        beside: &[],
    }
}

pub fn ask(scene: &Described, question: &Question) -> Advice {
    let build = |world: &mut World<Noted, ROOM>| -> Result<Forces<Recorded>, Error> {
        scene.build(world, Noted::from)
    };
    advise(&build, question).unwrap()
}

/// The type that is recommended, by its fractional bits.
pub fn best(advice: &Advice) -> u32 {
    advice.best.unwrap().fraction
}

/// How far the type with that many fractional bits is from `f64`; `None` where it refuses the scene.
pub fn measured(scene: &Described, plan: &Plan, fraction: u32) -> Option<(Flown, f64)> {
    let reference = real::fly::<f64>(scene, plan, &Step::hz(plan.rate).unwrap()).unwrap();
    let flown = real::fly_in(fraction, scene, plan).expect("a type that the tests name");
    let flown = flown.ok()?;
    let error = plan.apart(&flown.track, &reference.track);
    Some((flown, error))
}

/// The same for an `I8F24` at 1/64 s.
pub fn measured_dyadic(scene: &Described, plan: &Plan) -> f64 {
    let rate = Ratio::new(64, 1).unwrap();
    let plan = Plan { rate, ..*plan };
    let step = DyadicStep::<f64, 1, 6>::new().unwrap();
    let reference = real::fly::<f64>(scene, &plan, &step).unwrap();
    let step = DyadicStep::<I8F24, 1, 6>::new().unwrap();
    let flown = real::fly::<I8F24>(scene, &plan, &step).unwrap();
    plan.apart(&flown.track, &reference.track)
}
