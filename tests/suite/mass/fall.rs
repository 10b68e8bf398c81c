//! Eq. 11: under gravity a set falls as one body at its centre does.
//!
//! ```text
//! M a = sum(F)        both sides simulated: the points one by one, and the body of the set
//! ```
//!
//! The centre of the points is taken in `f64`: 1e-14 m, which no 32-bit type sees.

use fixstep::{GravityY, Point, Step, Verlet, World};

use super::*;

const TICKS: u32 = 120;
const SECONDS: f64 = TICKS as f64 / 60.0;

/// A loose set: up to 20 m apart, up to 6 m/s, of 1 to 20 kg in quarters.
fn loose<S: Format>(n: usize) -> Set<S> {
    let among = |i: usize, least: f64, most: f64| least + (most - least) * spread(31 * n + i);
    let one = |i: usize| PointMass {
        position: vector(among(i, -10.0, 10.0), among(i + 5, 30.0, 50.0)),
        velocity: vector(among(i + 9, -6.0, 6.0), among(i + 13, -6.0, 6.0)),
        mass: ratio((4.0 * among(i + 17, 1.0, 20.0)).round() / 4.0),
    };
    (0..n).map(one).collect()
}

/// Two seconds of free fall: each body's x, y and both velocities.
fn fallen<S: Format>(bodies: impl IntoIterator<Item = Point<S>>) -> Vec<[f64; 4]> {
    let mut gravity = GravityY::new(dec!(-9.81)).unwrap();
    let step = Step::<S>::hz(60).unwrap();
    let mut world = World::<_, 16>::new();
    bodies.into_iter().for_each(|body| {
        world.add(body).unwrap();
    });
    for _ in 0..TICKS {
        world.step(&mut Verlet, &mut gravity, &step);
    }
    let state = |b: &Point<S>| PARTS.map(|i| part(b.position(), b.velocity(), i).to_f64());
    world.bodies().iter().map(state).collect()
}

/// Between the body and the centre of the points: x, y, and both velocities, in units at the
/// largest that each may be: 50 m and 26 m/s.
fn apart<S: Format>(n: usize) -> [f64; 4] {
    let set = loose::<S>(n);
    let points = set
        .iter()
        .map(|p| Point::new(p.position, p.velocity, p.mass).unwrap());
    let points = fallen(points);
    let body = fallen([CentreOfMass::new(&set).unwrap().point().unwrap()])[0];
    let total: f64 = set.iter().map(|p| p.mass.to_f64()).sum();
    PARTS.map(|i| {
        let moments = set.iter().zip(&points).map(|(p, x)| p.mass.to_f64() * x[i]);
        let unit = S::unit(if i < 2 { 50.0 } else { 26.0 });
        (body[i] - moments.sum::<f64>() / total).abs() / unit
    })
}

/// Bounds in units for x, y and the velocities of `n` points.
fn falls_as_one_body<S: Format>(bounds: impl Fn(f64) -> [f64; 3]) {
    let (mut units, mut ratios) = (vec![], vec![]);
    for n in 1..=16 {
        let (apart, [x, y, v]) = (apart::<S>(n), bounds(n as f64));
        units.extend(apart);
        ratios.extend([apart[0] / x, apart[1] / y, apart[2] / v, apart[3] / v]);
    }
    println!("{} units at most", maximum(&units));
    within(1.0, &format!("{}, of the bound", S::name()), &ratios);
}

// The start is off by n/2 units, and one for the weights, in place and in velocity. Gravity gives
// all the same units. A steady x rounds alike in each of 240 drifts, half a unit on both sides; y
// passes through all fractions: variance 1/12 each, both sides, six standard deviations.
fn in_fixed_point<S: Format>() {
    let drifts = f64::from(2 * TICKS);
    falls_as_one_body::<S>(|n| {
        let start = n / 2.0 + 1.0;
        let place = start * (1.0 + SECONDS);
        [
            place + drifts,
            place + 6.0 * (2.0 * drifts / 12.0).sqrt(),
            start,
        ]
    });
}

// A float rounds its velocity in each kick as well, half a unit on both sides, which then moves it
// for a second on the mean.
fn in_floats<S: Format>() {
    let (drifts, kicks) = (f64::from(2 * TICKS), f64::from(TICKS));
    falls_as_one_body::<S>(|n| {
        let velocity = n + 1.0 + kicks;
        let place = n + 1.0 + drifts + velocity * SECONDS;
        [place, place, velocity]
    });
}

#[test]
fn a_set_falls_as_its_body_does() {
    in_floats::<f32>();
    in_fixed_point::<I16F16>();
    in_fixed_point::<I12F20>();
    in_fixed_point::<I8F24>();
    in_fixed_point::<I20F12>();
}
