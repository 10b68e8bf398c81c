//! A method that fuses stages gives the bits of the stages, and a method that says that all forces
//! act from one instant takes them all from there.

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12, I32F32};
use fixstep::integrate::{drift, drift_half, kick};
use fixstep::time::Now;
use fixstep::{
    AllBodies, AllPairs, Anchor, Body, BodyId, ConstantAcceleration, Euler, Force, Gravity,
    LinearDrag, Method, Pairs, PerBody, Point, Pull, Push, QuadraticDrag, Rk4, Scalar,
    SemiImplicitEuler, Spring, Step, Time, TimeStep, Vec2, Verlet, Window, World, dec, vec2,
};

const N: usize = 3;

type Scene<S> = World<Point<S>, N>;

/// Three bodies, and their ids.
fn scene<S: Scalar>() -> (Scene<S>, [BodyId; N]) {
    let mut world = World::new();
    let mut add = |x, y, u, v, mass| {
        let (position, velocity) = (vec2(x, y).unwrap(), vec2(u, v).unwrap());
        world
            .add(Point::new(position, velocity, mass).unwrap())
            .unwrap()
    };
    let ids = [
        add(dec!(1.25), dec!(2.1), dec!(0.3), dec!(-0.7), dec!(1.5)),
        add(dec!(-2.3), dec!(0.4), dec!(-1.1), dec!(0.9), dec!(0.8)),
        add(dec!(0.6), dec!(-1.7), dec!(2.2), dec!(0.1), dec!(3)),
    ];
    (world, ids)
}

fn gravity<S: Scalar>() -> Gravity<S> {
    Gravity::new(vec2(dec!(0.2), dec!(-0.9)).unwrap())
}

fn drag<S: Scalar>() -> LinearDrag<S> {
    LinearDrag::new(dec!(0.35)).unwrap()
}

fn air<S: Scalar>() -> QuadraticDrag<S> {
    QuadraticDrag::new(dec!(0.12)).unwrap()
}

fn pull<S: Scalar>() -> AllPairs<Pull<S>> {
    AllPairs(Pull::new(2, dec!(0.4)).unwrap())
}

/// For a part of the run.
fn push<S: Scalar>(body: BodyId) -> Window<Push<S>> {
    Window::new(
        20..150,
        Push::new(body, vec2(dec!(0.7), dec!(-1.3)).unwrap()),
    )
}

fn anchor<S: Scalar>(body: BodyId) -> Anchor<S> {
    Anchor::new(body, vec2(dec!(0.5), 1).unwrap(), 7, dec!(0.4)).unwrap()
}

fn spring<S: Scalar>(bodies: [BodyId; 2]) -> Pairs<Spring<S>, [[BodyId; 2]; 1]> {
    Pairs::new(
        Spring::new(dec!(1.2), dec!(5), dec!(0.6)).unwrap(),
        [bodies],
    )
}

/// Pushes outwards in every other step; which ones tells the start of a step from its middle.
fn pulse<S: Scalar, B: Body<S = S>>() -> PerBody<impl FnMut(Time, &B) -> Vec2<S>> {
    PerBody(|time: Time, body: &B| match time.half_ticks() % 4 {
        0 | 3 => body.position(),
        _ => Vec2::ZERO,
    })
}

struct KickThenDrift;

impl<B: Body, const M: usize> Method<B, M> for KickThenDrift {
    fn step<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        let now = Now::start(step, tick);
        kick(ids, bodies, forces, &now);
        drift(bodies, &now);
    }
}

struct DriftKickDrift;

impl<B: Body, const M: usize> Method<B, M> for DriftKickDrift {
    fn step<F: Force<B>, H: TimeStep<B::S>>(
        &mut self,
        ids: &[BodyId],
        bodies: &mut [B],
        forces: &mut F,
        step: &H,
        tick: u64,
    ) {
        let now = Now::middle(step, tick);
        drift_half(bodies, &now);
        kick(ids, bodies, forces, &now);
        drift_half(bodies, &now);
    }
}

/// The hash after each of some steps.
fn hashes<S: Scalar>(
    method: &mut impl Method<Point<S>, N>,
    forces: &mut impl Force<Point<S>>,
) -> Vec<u64> {
    let (mut world, step) = (scene::<S>().0, Step::hz(60).unwrap());
    let hash = |_| {
        world.step(method, forces, &step);
        world.state_hash()
    };
    (0..200).map(hash).collect()
}

fn fused_is_staged<S: Scalar>() {
    let [a, b, c] = scene::<S>().1;
    let alone = || (gravity::<S>(), drag::<S>(), air::<S>(), pulse());
    let coupled = || {
        (
            gravity::<S>(),
            drag::<S>(),
            [spring([a, b]), spring([c, a])],
            anchor::<S>(c),
            (pull::<S>(), push::<S>(b), air::<S>()),
        )
    };

    assert_eq!(
        hashes(&mut SemiImplicitEuler, &mut alone()),
        hashes(&mut KickThenDrift, &mut alone())
    );
    assert_eq!(
        hashes(&mut SemiImplicitEuler, &mut coupled()),
        hashes(&mut KickThenDrift, &mut coupled())
    );
    assert_eq!(
        hashes(&mut Verlet, &mut alone()),
        hashes(&mut DriftKickDrift, &mut alone())
    );
    assert_eq!(
        hashes(&mut Verlet, &mut coupled()),
        hashes(&mut DriftKickDrift, &mut coupled())
    );
    assert_ne!(
        hashes(&mut Verlet, &mut alone()),
        hashes(&mut KickThenDrift, &mut alone())
    );
}

#[test]
fn fused_methods_give_the_bits_of_their_stages() {
    fused_is_staged::<f32>();
    fused_is_staged::<f64>();
    fused_is_staged::<I8F24>();
    fused_is_staged::<I12F20>();
    fused_is_staged::<I16F16>();
    fused_is_staged::<I20F12>();
    fused_is_staged::<I32F32>();
}

/// Position and velocity.
type State = [(Vec2<f64>, Vec2<f64>); N];

fn times(v: Vec2<f64>, factor: f64) -> Vec2<f64> {
    Vec2::new(v.x * factor, v.y * factor)
}

/// Accelerations by gravity, drag, an anchor on the last body and a spring between the first two,
/// written out.
fn accelerations(state: &State) -> [Vec2<f64>; N] {
    let [(x1, v1), (x2, v2), (x3, v3)] = *state;
    let (d, u) = (x2 - x1, v2 - v1);
    let length = (d.x * d.x + d.y * d.y).sqrt();
    let pull = 5.0 * (length - 1.2) + 0.6 * (u.x * d.x + u.y * d.y) / length;
    let along = times(d, pull / length);
    let home = times(Vec2::new(0.5, 1.0) - x3, 7.0) - times(v3, 0.4);
    let force = [
        along - times(v1, 0.35),
        -along - times(v2, 0.35),
        home - times(v3, 0.35),
    ];
    let masses = [1.5, 0.8, 3.0];
    [0, 1, 2].map(|i| times(force[i], 1.0 / masses[i]) + Vec2::new(0.2, -0.9))
}

/// `x' = x + h ((1 - share) v + share v')`
fn reference(state: &State, h: f64, share: f64) -> State {
    let a = accelerations(state);
    [0, 1, 2].map(|i| {
        let (x, v) = state[i];
        let next = v + times(a[i], h);
        (
            x + times(v, h * (1.0 - share)) + times(next, h * share),
            next,
        )
    })
}

fn state(world: &Scene<f64>) -> State {
    [0, 1, 2].map(|i| (world.bodies()[i].position(), world.bodies()[i].velocity()))
}

fn distance(a: &State, b: &State) -> f64 {
    let of = |i: usize| (a[i].0 - b[i].0).length() + (a[i].1 - b[i].1).length();
    [0, 1, 2].map(of).into_iter().sum()
}

/// How far the method gets from the recomputation in 60 steps.
fn off(mut method: impl Method<Point<f64>, N>, share: f64) -> f64 {
    let (mut world, [a, b, c]) = scene::<f64>();
    let mut forces = (drag(), spring([a, b]), gravity(), anchor(c));
    let mut expected = state(&world);
    for _ in 0..60 {
        world.step(&mut method, &mut forces, &Step::hz(60).unwrap());
        expected = reference(&expected, 1.0 / 60.0, share);
    }
    distance(&state(&world), &expected)
}

#[test]
fn all_forces_act_from_one_instant() {
    let euler = off(Euler::<Point<f64>, N>::new(), 0.0);
    assert!(euler < 1e-12, "{euler}");
    let constant = off(ConstantAcceleration::<Point<f64>, N>::new(), 0.5);
    assert!(constant < 1e-12, "{constant}");
    let split = off(SemiImplicitEuler, 1.0);
    assert!(
        split > 1e-4,
        "the scene does not tell one instant from two: {split}"
    );
}

/// The velocity of the next body.
fn next<S: Scalar>(_: Time, all: &[Point<S>], i: usize) -> Vec2<S> {
    all[(i + 1) % N].velocity()
}

fn order_does_not_matter<S: Scalar, M: Method<Point<S>, N>>(method: impl Fn() -> M) {
    let [a, b, c] = scene::<S>().1;
    let (g, s, d, k) = (
        gravity::<S>(),
        spring::<S>([a, b]),
        drag::<S>(),
        anchor::<S>(c),
    );
    let all = AllBodies::<_, S, N>::new(next::<S>);
    let more = || (pull::<S>(), push::<S>(b), air::<S>());
    let expected = hashes(&mut method(), &mut (g, s, d, all, k, more()));
    assert_eq!(
        hashes(&mut method(), &mut (more(), k, all, d, s, g)),
        expected
    );
    assert_eq!(
        hashes(&mut method(), &mut (d, k, more(), g, all, s)),
        expected
    );
}

#[test]
fn the_order_of_forces_does_not_matter() {
    order_does_not_matter::<I16F16, _>(Euler::new);
    order_does_not_matter::<I8F24, _>(Euler::new);
    order_does_not_matter::<I16F16, _>(ConstantAcceleration::new);
    order_does_not_matter::<I32F32, _>(ConstantAcceleration::new);
    order_does_not_matter::<I16F16, _>(Rk4::new);
    order_does_not_matter::<I8F24, _>(Rk4::new);
}
