//! Bodies that turn, and what they refuse.

use fixstep::rigid::torque::SpinDrag;
use fixstep::{Angular, Carried, Rigid, Scalar};

use super::*;

fn centre<S: Scalar>() -> Point<S> {
    Point::new(vec2(0, 0).unwrap(), vec2(0, 0).unwrap(), 1).unwrap()
}

pub fn inertia_of_nothing() -> Errors {
    vec![
        refused(Rigid::new(centre::<I16F16>(), 0)),
        refused(Rigid::new(centre::<f32>(), dec!(-0.5))),
        refused(Rigid::new(Carried::from(centre::<I8F24>()), -1)),
    ]
}

// In 32 bits 1 / 2πI must lie below 2^30, and in a fraction it must not be zero.
pub fn inertia_beyond() -> Errors {
    let huge = Ratio::new(1 << 62, 1).unwrap();
    assert!(Rigid::new(centre::<I16F16>(), dec!(0.00000000015)).is_ok());
    vec![
        refused(Rigid::new(centre::<I16F16>(), dec!(0.00000000014))),
        refused(Rigid::new(centre::<I16F16>(), huge)),
    ]
}

pub fn spin_beyond() -> Errors {
    vec![
        refused(Rigid::locked(centre::<I8F24>()).with_spin(128)),
        refused(Rigid::locked(centre::<I16F16>()).with_spin(-40_000)),
    ]
}

fn not_finite<S: Angular>(nan: S) -> Errors {
    let mut body = Rigid::locked(centre::<S>()).with_spin(1).unwrap();
    let before = body;
    let errors = vec![
        refused(body.set_spin(nan)),
        refused(body.teleport(Vec2::new(nan, nan))),
        refused(body.set_velocity(Vec2::new(S::ZERO, nan))),
        refused(Rigid::<Point<S>>::kinematic(
            Vec2::ZERO,
            Vec2::new(nan, S::ZERO),
        )),
        refused(Rigid::<Point<S>>::static_at(Vec2::new(nan, S::ZERO))),
    ];
    assert_eq!(body, before);
    errors
}

pub fn nan_state() -> Errors {
    [not_finite(f32::NAN), not_finite(f64::INFINITY)].concat()
}

pub fn drag_below_zero() -> Errors {
    vec![
        refused(SpinDrag::<I16F16>::new(-1)),
        refused(SpinDrag::<f32>::new(dec!(-0.1))),
    ]
}
