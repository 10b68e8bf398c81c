//! The matrix of one step, measured by stepping unit starts, against the exact flow.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{ExactSpring, Ratio, Step, Vec2, dec};

use crate::exact_spring::flow::{Double, Matrix, step_of};
use crate::exact_spring::rounding::is_fixed;
use crate::exact_spring::splitting::{SPLITTINGS, Splitting};
use crate::support::*;

const DAMPING: [Ratio; 13] = [
    dec!(0),
    dec!(0.01),
    dec!(0.1),
    dec!(0.5),
    dec!(0.9),
    dec!(0.99),
    dec!(0.999),
    dec!(1),
    dec!(1.001),
    dec!(1.01),
    dec!(1.1),
    dec!(2),
    dec!(5),
];

/// 64 values of ω h from 0.1 to 6 at 60 Hz, and whole quarters of a turn.
fn frequencies() -> impl Iterator<Item = Ratio> {
    let spaced =
        (0..64).map(|i| ratio((0.1 + 5.9 * i as f64 / 63.0) * 60.0 / std::f64::consts::TAU));
    spaced.chain([15, 30, 45, 60].map(Ratio::from))
}

/// The matrix of one step over (x, v/ω): along x a body starts from `x`, along y with `v`.
fn measured<S: Format>(
    mut scheme: Splitting,
    hertz: Ratio,
    zeta: Ratio,
    [x, v]: [f64; 2],
) -> [Matrix; 2] {
    let mut world = world([point::<S>([x, 0.0], [0.0, v], 1.0)]);
    let mut spring = ExactSpring::new(world.ids()[0], Vec2::ZERO, hertz, zeta).unwrap();
    let step = Step::<S>::hz(60).unwrap();
    world.step(&mut scheme, &mut spring, &step);
    let (omega, exact) = step_of(hertz, zeta, step.seconds());
    let body = world.bodies()[0];
    let (at, to) = (body.position().to_f64(), body.velocity().to_f64());
    let of = |value: f64, by: f64| Double::of(value) / Double::of(by);
    let measured = Matrix([
        [of(at.x, x), of(at.y, v) * omega],
        [of(to.x, x) / omega, of(to.y, v)],
    ]);
    [measured, exact]
}

/// The errors of the four entries, and of trace and determinant.
fn errors([measured, exact]: [Matrix; 2]) -> ([f64; 4], [f64; 2]) {
    let off = measured.less(&exact);
    let entries = [off.0[0][0], off.0[0][1], off.0[1][0], off.0[1][1]];
    let invariants = [off.trace(), measured.determinant() - exact.determinant()];
    let size = |error: Double| error.to_f64().abs();
    (entries.map(size), invariants.map(size))
}

/// A body of 1 (m, m/s) in floats; in fixed point the largest power of two for which the range has
/// room for ω x and for v, and twice that.
fn starts<S: Format>(hertz: Ratio) -> [f64; 2] {
    if !is_fixed::<S>() {
        return [1.0; 2];
    }
    let floor = |room: f64| room.log2().floor().exp2();
    let omega = std::f64::consts::TAU * hertz.to_f64();
    [
        floor(S::MAX.to_f64() / (4.0 * omega)),
        floor(S::MAX.to_f64() / 4.0),
    ]
}

/// Allowed error of an entry in one flow.
///
/// Floats: as asked. With u = 2^-53 or 2^-24 the gains `p11 - 1`, up to 2, are off by u and what is
/// added to 1 by u/2; two shears make `1 + α β` off by 2 u |α β|, and |α β| <= 1 as half a turn is taken
/// first. So entries are within 2.5 u, the determinant within 4 u. The trace of a turn, twice `1 + α β`,
/// may reach 5 u where cos θ is near 0: more than 2e-7 in `f32` for one frequency of 4000 that were
/// tried, and for none here.
///
/// Fixed point: along a row two products of half a unit in x, or one that is carried on by a
/// shear of at most 1/2: 1.25 units of x, of which a start of x is one part and a start of v/ω
/// another. Coefficients of 31 bits add at most ten roundings of their own.
fn allowed<S: Format>(hertz: Ratio) -> f64 {
    if !is_fixed::<S>() {
        return if S::COEFFICIENT > 1e-10 { 2e-7 } else { 1e-15 };
    }
    let ([x, v], omega) = (starts::<S>(hertz), std::f64::consts::TAU * hertz.to_f64());
    1.25 * S::unit(1.0) * (1.0 / x).max(omega / v) + 10.0 * S::COEFFICIENT / 3.0
}

/// Parts of what is allowed. `Verlet` makes two flows Q of half a step: an error E of one makes
/// `Q E + E Q`, and with |Q| <= 1 each entry of it, its trace and its share of the determinant are at most
/// `2 sqrt 2` times the largest of E: 3. In fixed point two entries make a trace, and the determinant
/// moves by at most `|P| |E| <= sqrt 2 * 2` entries: 3 as well.
fn check<S: Format>(scheme: Splitting) {
    let flows = if scheme == Splitting::Verlet {
        3.0
    } else {
        1.0
    };
    let sums = if is_fixed::<S>() { 3.0 } else { 1.0 };
    let (mut entries, mut invariants) = (Vec::new(), Vec::new());
    for hertz in frequencies() {
        let allowed = flows * allowed::<S>(hertz);
        for zeta in DAMPING {
            let off = errors(measured::<S>(scheme, hertz, zeta, starts::<S>(hertz)));
            entries.extend(off.0.map(|error| error / allowed));
            invariants.extend(off.1.map(|error| error / (sums * allowed)));
        }
    }
    let what = |part| format!("{} {scheme:?} {part}, of the allowance", S::name());
    within(1.0, &what("entries"), &entries);
    within(1.0, &what("trace, determinant"), &invariants);
}

#[test]
fn a_step_in_floats_is_the_exact_flow() {
    for scheme in SPLITTINGS {
        check::<f64>(scheme);
        check::<f32>(scheme);
    }
}

#[test]
fn a_step_in_fixed_point_is_the_exact_flow() {
    for scheme in SPLITTINGS {
        check::<I16F16>(scheme);
        check::<I12F20>(scheme);
        check::<I8F24>(scheme);
        check::<I20F12>(scheme);
    }
}
