//! How a step multiplies the state of a spring and of a braked body, for every method, against the
//! closed forms of its header; and the limits that follow.
//!
//! ```text
//! spring, q = h ω      radius of the 2 x 2 matrix of one step in (x, v / ω)
//! Euler                sqrt(1 + q²)
//! ConstantAcceleration sqrt(1 + q²/2), while its roots are not real
//! SemiImplicitEuler, Verlet    trace 2 - q², determinant 1
//! Rk4                  |1 + iq - q²/2 - iq³/6 + q⁴/24|
//! Pefrl                product of its nine shears
//! ```

use fixstep::{LinearDrag, Point, Step, World};

use super::support::*;

type Matrix = [[f64; 2]; 2];

fn product(a: Matrix, b: Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[i][0] * b[0][j] + a[i][1] * b[1][j]))
}

/// Largest magnitude of an eigenvalue.
fn radius(m: Matrix) -> f64 {
    let half = (m[0][0] + m[1][1]) / 2.0;
    let determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    let square = half * half - determinant;
    if square < 0.0 {
        determinant.sqrt()
    } else {
        half.abs() + square.sqrt()
    }
}

/// The matrix of one step as made: x starts at (1, 0), y at (0, 1).
fn measured(scheme: Scheme, q: f64) -> Matrix {
    let omega = 60.0 * q;
    let mut world: World<Point<f64>, 1> = world([point([1.0, 0.0], [0.0, omega], 1.0)]);
    let mut anchor = anchors(&world, [omega * omega]);
    world.step(&mut scheme.method(), &mut anchor, &Step::hz(60).unwrap());
    let (x, v) = (world.bodies()[0].position(), world.bodies()[0].velocity());
    [[x.x, x.y], [v.x / omega, v.y / omega]]
}

const XI: f64 = 0.1786178958448091;
const LAMBDA: f64 = -0.2123418310626054;
const CHI: f64 = -0.066_264_582_669_818_5;

/// Drifts and kicks in their order.
const DRIFTS: [f64; 5] = [XI, CHI, 1.0 - 2.0 * (CHI + XI), CHI, XI];
const KICKS: [f64; 4] = [0.5 - LAMBDA, LAMBDA, LAMBDA, 0.5 - LAMBDA];

fn pefrl(q: f64) -> Matrix {
    let drift = |share: f64| [[1.0, share * q], [0.0, 1.0]];
    let kick = |share: f64| [[1.0, 0.0], [-share * q, 1.0]];
    let pairs = DRIFTS.iter().zip(KICKS);
    let all = pairs.fold([[1.0, 0.0], [0.0, 1.0]], |m, (&d, k)| {
        product(kick(k), product(drift(d), m))
    });
    product(drift(XI), all)
}

fn closed(scheme: Scheme, q: f64) -> f64 {
    let square = q * q;
    match scheme {
        Scheme::Euler => (1.0 + square).sqrt(),
        Scheme::ConstantAcceleration => (1.0 + square / 2.0).sqrt(),
        Scheme::SemiImplicitEuler | Scheme::Verlet => radius([[2.0 - square, -1.0], [1.0, 0.0]]),
        Scheme::Rk4 => (1.0 - square / 2.0 + square * square / 24.0).hypot(q - q * square / 6.0),
        Scheme::Pefrl => radius(pefrl(q)),
    }
}

/// Rounding: some 40 operations on numbers of a few units. Where two eigenvalues meet, near the limits, a
/// radius takes the root of that; the grid comes no closer to one than 0.01, where it is 1e-12 again.
#[test]
fn springs_grow_by_the_closed_forms() {
    for scheme in ALL_SCHEMES {
        let last = if scheme == Scheme::ConstantAcceleration {
            2.5
        } else {
            3.2
        };
        let q = |i: usize| 0.05 + (last - 0.05) * (i as f64 + 0.13) / 32.0;
        let error = |i| (radius(measured(scheme, q(i))) - closed(scheme, q(i))).abs();
        let errors: [f64; 32] = std::array::from_fn(error);
        within(1e-11, &format!("{scheme:?} spring, radius"), &errors);
    }
}

/// The q at which the radius first passes 1, by bisection of the closed form.
fn limit(scheme: Scheme, [mut low, mut high]: [f64; 2]) -> f64 {
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        let stable = closed(scheme, middle) <= 1.0 + 1e-12;
        *(if stable { &mut low } else { &mut high }) = middle;
    }
    low
}

/// Below the limits nothing grows: 1e-9 is far above rounding and far below what is seen above them.
#[test]
fn springs_are_stable_up_to_their_limits() {
    let limits = [
        (Scheme::SemiImplicitEuler, 2.0),
        (Scheme::Verlet, 2.0),
        (Scheme::Rk4, 8.0_f64.sqrt()),
        (Scheme::Pefrl, limit(Scheme::Pefrl, [2.5, 3.2])),
    ];
    for (scheme, limit) in limits {
        println!("{scheme:?}: stable for h ω < {limit:.4}");
        let below = (1..=64).map(|i| limit * i as f64 / 64.0 - 1e-3);
        for q in below {
            let radius = radius(measured(scheme, q));
            assert!(radius <= 1.0 + 1e-9, "{scheme:?} at {q}: {radius}");
        }
        let above = radius(measured(scheme, limit + 1e-3));
        assert!(above > 1.0 + 1e-4, "{scheme:?}: {above}");
    }
    let pefrl = limits[3].1;
    assert!((2.989..2.990).contains(&pefrl), "{pefrl}");
    for scheme in [Scheme::Euler, Scheme::ConstantAcceleration] {
        assert!(radius(measured(scheme, 1e-3)) > 1.0 + 1e-7, "{scheme:?}");
    }
}

/// What is left of a velocity after a step under explicit drag, `z = k h / m`.
fn left(scheme: Scheme, z: f64) -> f64 {
    let mut world: World<Point<f64>, 1> = world([point([0.0; 2], [1.0, 0.0], 2.0)]);
    let mut drag = LinearDrag::new(ratio(z * 120.0)).unwrap();
    world.step(&mut scheme.method(), &mut drag, &Step::hz(60).unwrap());
    world.bodies()[0].velocity().x
}

fn closed_left(scheme: Scheme, z: f64) -> f64 {
    match scheme {
        Scheme::Rk4 => 1.0 - z * (1.0 - z / 2.0 * (1.0 - z / 3.0 * (1.0 - z / 4.0))),
        Scheme::Pefrl => KICKS.iter().map(|share| 1.0 - share * z).product(),
        _ => 1.0 - z,
    }
}

/// From 0 to the limits of the table: the root of `z/2 - z²/6 + z³/24 = 1` and the z at which the
/// factors of the kicks multiply to 1. Neither method of order 4 changes the sign of a velocity.
#[test]
fn explicit_drag_is_stable_up_to_its_limits() {
    for scheme in ALL_SCHEMES {
        let z = |i: usize| 3.0 * (i as f64 + 0.5) / 32.0;
        let error = |i| (left(scheme, z(i)) - closed_left(scheme, z(i))).abs();
        let errors: [f64; 32] = std::array::from_fn(error);
        within(1e-14, &format!("{scheme:?} drag, factor"), &errors);
        let limit = match scheme {
            Scheme::Rk4 => 2.7853,
            Scheme::Pefrl => 2.3415,
            _ => 2.0,
        };
        for i in 1..=64 {
            let left = left(scheme, (limit - 1e-3) * i as f64 / 64.0);
            assert!(left.abs() < 1.0, "{scheme:?}: {left}");
            assert!(!super::ORDER_4.contains(&scheme) || left > -1e-14);
        }
        let above = left(scheme, limit + 1e-3);
        assert!(above.abs() > 1.0, "{scheme:?}: {above}");
    }
}
