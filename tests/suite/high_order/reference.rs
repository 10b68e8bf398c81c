//! Both methods against themselves, written out in `f64` for all bodies at once: four evaluations of
//! one function, no bodies, no kicks and no shares. Forces of time, of velocity and between bodies.

use fixstep::{
    AllBodies, Anchor, BodyId, Force, Gravity, LinearDrag, Pairs, PerBody, Point, Scalar, Spring,
    Step, Time, Vec2, World, dec, vec2,
};

use super::support::*;

const N: usize = 3;
const MASSES: [f64; N] = [1.5, 0.8, 3.0];
const H: f64 = 1.0 / 20.0;

type Scene = World<Point<f64>, N>;

/// Positions, then velocities.
type State = [[f64; 2]; 2 * N];

fn scene() -> Scene {
    world([
        point([1.25, 2.1], [0.3, -0.7], MASSES[0]),
        point([-2.3, 0.4], [-1.1, 0.9], MASSES[1]),
        point([0.6, -1.7], [2.2, 0.1], MASSES[2]),
    ])
}

fn state(world: &Scene) -> State {
    std::array::from_fn(|i| {
        let body = &world.bodies()[i % N];
        let v = if i < N {
            body.position()
        } else {
            body.velocity()
        };
        v.array()
    })
}

/// Bends a path, pushes by the clock and brakes by the square.
fn wind(t: f64, x: [f64; 2], v: [f64; 2]) -> [f64; 2] {
    [
        (2.0 * t).sin() - 0.3 * v[1] - 0.1 * v[0] * v[0].abs(),
        0.5 * (3.0 * t).cos() + 0.4 * v[0] - 0.2 * x[1] * x[0],
    ]
}

/// `bends`: whether forces of velocity and of time take part.
fn accelerations(s: &State, t: f64, bends: bool) -> [[f64; 2]; N] {
    let on = f64::from(u8::from(bends));
    let (d, u) = (minus(s[1], s[0]), minus(s[4], s[3]));
    let length = d[0].hypot(d[1]);
    let closing = (d[0] * u[0] + d[1] * u[1]) / length;
    let along = (5.0 * (length - 1.2) + on * 0.6 * closing) / length;
    std::array::from_fn(|i| {
        let (x, v, gust) = (s[i], s[i + N], wind(t, s[i], s[i + N]));
        std::array::from_fn(|axis| {
            let spring = [along, -along, 0.0][i] * d[axis];
            let home = [0.5, 1.0][axis] - x[axis];
            let anchor = [0.0, 0.0, 7.0][i] * home;
            let chase = 0.7 * (s[(i + 1) % N][axis] - x[axis]);
            let fields = on * (gust[axis] - 0.35 * v[axis]);
            [0.2, -0.9][axis] + (spring + anchor + chase + fields) / MASSES[i]
        })
    })
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// `s + by d`
fn plus(s: &State, d: &State, by: f64) -> State {
    std::array::from_fn(|i| std::array::from_fn(|axis| s[i][axis] + by * d[i][axis]))
}

fn rate(s: &State, t: f64, bends: bool) -> State {
    let a = accelerations(s, t, bends);
    std::array::from_fn(|i| if i < N { s[i + N] } else { a[i - N] })
}

fn rk4(s: &State, t: f64, bends: bool) -> State {
    let a = rate(s, t, bends);
    let b = rate(&plus(s, &a, H / 2.0), t + H / 2.0, bends);
    let c = rate(&plus(s, &b, H / 2.0), t + H / 2.0, bends);
    let d = rate(&plus(s, &c, H), t + H, bends);
    let weighted = [(a, 1.0), (b, 2.0), (c, 2.0), (d, 1.0)];
    weighted
        .iter()
        .fold(*s, |s, (slope, weight)| plus(&s, slope, weight * H / 6.0))
}

fn pefrl(s: &State, t: f64, bends: bool) -> State {
    let (xi, lambda, chi) = (
        0.1786178958448091,
        -0.2123418310626054,
        -0.066_264_582_669_818_5,
    );
    let drifts = [xi, chi, 1.0 - 2.0 * (chi + xi), chi, xi];
    let kicks = [0.5 - lambda, lambda, lambda, 0.5 - lambda, 0.0];
    let mut s = *s;
    for (drift, kick) in drifts.into_iter().zip(kicks) {
        let mut slope = rate(&s, t, bends);
        slope[N..].fill([0.0; 2]);
        s = plus(&s, &slope, drift * H);
        let mut slope = rate(&s, t + H / 2.0, bends);
        slope[..N].fill([0.0; 2]);
        s = plus(&s, &slope, kick * H);
    }
    s
}

/// The forces of `accelerations`, from the crate.
fn forces(ids: &[BodyId], bends: bool) -> impl Force<Point<f64>> + use<> {
    let damping = if bends { dec!(0.6) } else { dec!(0) };
    let spring = Spring::new(dec!(1.2), 5, damping).unwrap();
    let gust = move |time: Time, body: &Point<f64>| {
        let t = time.elapsed().unwrap().to_f64();
        let [x, y] = wind(t, body.position().array(), body.velocity().array());
        Vec2::new(x, y)
    };
    let chase = |_: Time, all: &[Point<f64>], i: usize| {
        (all[(i + 1) % N].position() - all[i].position()).map(|d| d.times(0.7))
    };
    let home = vec2(dec!(0.5), 1).unwrap();
    let fields = bends.then(|| (PerBody(gust), LinearDrag::new(dec!(0.35)).unwrap()));
    (
        fields,
        Pairs::new(spring, [[ids[0], ids[1]]]),
        Gravity::new(vec2(dec!(0.2), dec!(-0.9)).unwrap()),
        Anchor::new(ids[2], home, 7, 0).unwrap(),
        AllBodies::<_, f64, N>::new(chase),
    )
}

/// The largest difference of any coordinate in ten seconds.
fn off(scheme: Scheme, bends: bool, next: impl Fn(&State, f64, bool) -> State) -> f64 {
    let mut world = scene();
    let mut forces = forces(world.ids(), bends);
    let (mut method, step) = (scheme.method(), Step::hz(20).unwrap());
    let (mut expected, mut worst) = (state(&world), 0.0);
    for tick in 0..200 {
        world.step(&mut method, &mut forces, &step);
        expected = next(&expected, f64::from(tick) * H, bends);
        let made = state(&world);
        let differences = made.iter().flatten().zip(expected.iter().flatten());
        let largest: Vec<_> = differences.map(|(a, b)| (a - b).abs()).collect();
        worst = maximum(&[worst, maximum(&largest)]);
    }
    println!("{scheme:?}, forces of velocity and time {bends}: off by {worst:.1e}");
    worst
}

/// Some hundred roundings a step of 1e-16 of numbers up to 10, for 200 steps, tripled by a motion in which
/// close paths part: 1e-10 leaves room, and any other method is off by more than 1e-6.
#[test]
fn rk4_is_what_it_says() {
    for bends in [false, true] {
        let error = off(Scheme::Rk4, bends, rk4);
        assert!(error <= 1e-10, "{error}");
    }
    let other = off(Scheme::Pefrl, false, rk4);
    assert!(
        other > 1e-6,
        "the scene does not tell methods apart: {other}"
    );
}

#[test]
fn pefrl_is_what_it_says() {
    let error = off(Scheme::Pefrl, false, pefrl);
    assert!(error <= 1e-10, "{error}");
}
