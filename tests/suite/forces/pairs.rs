//! Who a force between two bodies acts on, and the potential of what acts.

use super::*;
use fixstep::scalar::Factor;
use fixstep::time::Now;
use fixstep::{AllPairs, BodyId, PairForce, Pairs, Pull, Push, heapless};

const N: usize = 5;

type Five<S> = World<Point<S>, N>;

/// Five bodies of 1 to 5 kg.
fn five<S: Scalar>() -> (Five<S>, [BodyId; N]) {
    let places = [[0, 0], [3, 1], [-2, 4], [1, -3], [-4, -2]];
    let mut world = World::new();
    let ids = [0, 1, 2, 3, 4].map(|i| {
        let body = point(places[i], [i as i32 - 2, 1], i as i32 + 1);
        world.add(body).unwrap()
    });
    (world, ids)
}

fn pull<S: Scalar>() -> Pull<S> {
    Pull::new(dec!(1.7), dec!(0.6)).unwrap()
}

/// State and potential energy after some steps.
fn outcome<S: Scalar, F: Force<Point<S>>>(
    mut method: impl Method<Point<S>, N>,
    make: impl FnOnce([BodyId; N]) -> F,
) -> (u64, u64) {
    let (mut world, ids) = five::<S>();
    let (mut forces, step) = (make(ids), Step::hz(60).unwrap());
    (0..200).for_each(|_| world.step(&mut method, &mut forces, &step));
    (
        world.state_hash(),
        world.potential_energy(&forces).to_bits(),
    )
}

/// Every two bodies, the later one in the outer loop.
fn every([a, b, c, d, e]: [BodyId; N]) -> [[BodyId; 2]; 10] {
    [
        [a, b],
        [a, c],
        [b, c],
        [a, d],
        [b, d],
        [c, d],
        [a, e],
        [b, e],
        [c, e],
        [d, e],
    ]
}

fn all_pairs<S: Scalar, M: Method<Point<S>, N>>(method: impl Fn() -> M) {
    let (all, _) = outcome::<S, _>(method(), |_| AllPairs(pull::<S>()));
    let (listed, _) = outcome::<S, _>(method(), |ids| Pairs::new(pull::<S>(), every(ids)));
    assert_eq!(all, listed);
    let (fewer, _) = outcome::<S, _>(method(), |ids| Pairs::new(pull::<S>(), [every(ids)[0]]));
    assert_ne!(all, fewer);
}

#[test]
fn all_pairs_are_a_list_of_all_pairs() {
    all_pairs::<f32, _>(|| Verlet);
    all_pairs::<f64, _>(Euler::new);
    all_pairs::<I16F16, _>(|| SemiImplicitEuler);
    all_pairs::<I8F24, _>(ConstantAcceleration::new);
    all_pairs::<I8F24, _>(|| Verlet);
}

#[test]
fn pairs_act_alike_in_any_list() {
    let law = pull::<f32>();
    let array = outcome(Verlet, |ids| Pairs::new(law, every(ids)));
    let list = |ids| {
        Pairs::new(
            law,
            heapless::Vec::<_, 16>::from_slice(&every(ids)).unwrap(),
        )
    };
    assert_eq!(outcome(Verlet, list), array);
    let ids = five::<f32>().1;
    let pairs = every(ids);
    assert_eq!(outcome(Verlet, |_| Pairs::new(law, &pairs[..])), array);
    let (one_by_one, _) = outcome(Verlet, |ids| every(ids).map(|pair| Pairs::new(law, [pair])));
    assert_eq!(one_by_one, array.0);
}

#[test]
fn pairs_that_are_no_pairs_do_nothing() {
    let (mut world, [a, b, c, d, e]) = five::<I16F16>();
    world.remove(c).unwrap();
    world.remove(e).unwrap();
    let mut other = world.clone();
    let odd = [[a, a], [a, c], [b, a], [c, e], [e, d], [d, d]];
    let mut some = Pairs::new(pull(), odd);
    let mut one = Pairs::new(pull(), [[b, a]]);
    for _ in 0..100 {
        world.step(&mut Verlet, &mut some, &Step::hz(60).unwrap());
        other.step(&mut Verlet, &mut one, &Step::hz(60).unwrap());
    }
    assert_eq!(world.state_hash(), other.state_hash());
    assert_eq!(world.potential_energy(&some), other.potential_energy(&one));
    assert_ne!(world.potential_energy(&one), 0.0);
    let none = Pairs::new(pull::<I16F16>(), heapless::Vec::<[BodyId; 2], 0>::new());
    assert_eq!(world.potential_energy(&none), 0.0);
}

/// Passes a quarter of the mass of the first body, as momentum along x; notes who met whom.
#[derive(Clone, Debug, Default)]
struct Trade {
    prepared: u32,
    met: Vec<[f64; 2]>,
}

impl<B: Body<S = f64>> PairForce<B> for Trade {
    fn prepare<H: TimeStep<f64>>(&mut self, _: &Now<H>) {
        self.prepared += 1;
    }

    fn act<H: TimeStep<f64>>(&mut self, now: &Now<H>, seen: [&B; 2], live: [&mut B; 2]) {
        assert_eq!(now.tick(), 0);
        let masses = seen.map(|body| 1.0 / Factor::<f64>::to_f64(body.inv_mass()));
        self.met.push(masses);
        let [first, second] = live;
        first.push(Vec2::new(masses[0] / 4.0, 0.0));
        second.push(Vec2::new(-masses[0] / 4.0, 0.0));
    }
}

// Each but the last gives a quarter of itself to all behind it: 1/4 m/s a pair, taken from others.
#[test]
fn a_pair_force_of_ones_own() {
    let (mut world, _) = five::<f64>();
    let before = world.momentum();
    let mut trade = AllPairs(Trade::default());
    world.step(
        &mut SemiImplicitEuler,
        &mut trade,
        &Sixteenth::new().unwrap(),
    );
    let pairs: Vec<[f64; 2]> = (1..5)
        .flat_map(|j| (0..j).map(move |i| [i as f64 + 1.0, j as f64 + 1.0]))
        .collect();
    assert_eq!((trade.0.prepared, &trade.0.met), (1, &pairs));
    for (i, v) in velocities(&world).into_iter().enumerate() {
        let (given, taken) = ((4 - i) as f64 / 4.0, (i * (i + 1) / 2) as f64 / 4.0);
        let exact = i as f64 - 2.0 + given - taken / (i + 1) as f64;
        assert!(
            (v[0] - exact).abs() < 1e-14 && v[1] == 1.0,
            "{i}: {v:?} {exact}"
        );
    }
    assert!((world.momentum() - before).length() < 1e-13);
    assert_eq!(world.potential_energy(&trade), 0.0);
}

/// `-dU/dx` by a difference over `2 δ`: off by `δ²/6` of the third derivative and by the roundings of
/// two energies, over `2 δ`.
fn slope(world: &Five<f64>, id: BodyId, force: &impl Force<Point<f64>>, delta: f64) -> [f64; 2] {
    let at = |dx: f64, dy: f64| {
        let mut world = world.clone();
        let body = world.get_mut(id).unwrap();
        let place = body.position() + Vec2::new(dx, dy);
        body.teleport(place).unwrap();
        world.potential_energy(force)
    };
    [
        at(-delta, 0.0) - at(delta, 0.0),
        at(0.0, -delta) - at(0.0, delta),
    ]
    .map(|d| d / (2.0 * delta))
}

// Third derivatives of 1/s are below 15/s⁴ with s >= 2 m here but for ε: G m1 m2 of at most 34 and 4
// pairs, 15 * 34 * 4 / 16 * δ²/6 = 3e-9 at δ = 1e-5. Energies of 100 J, each sum off by 1e-14: 1e-9.
#[test]
fn a_pull_is_the_slope_of_its_potential() {
    let (world, ids) = five::<f64>();
    let mut force = AllPairs(pull::<f64>());
    let mut moved = world.clone();
    moved.step(
        &mut SemiImplicitEuler,
        &mut force,
        &Sixteenth::new().unwrap(),
    );
    for (i, id) in ids.into_iter().enumerate() {
        let [before, after] = [&world, &moved].map(|w| w.get(id).unwrap().velocity());
        let change = (after - before)
            .map(|dv| 16.0 * (i + 1) as f64 * dv)
            .array();
        let exact = slope(&world, id, &force, 1e-5);
        for (f, exact) in change.into_iter().zip(exact) {
            assert!((f - exact).abs() <= 1e-8, "{i}: {f} {exact}");
        }
    }
}

// -F·x is linear: the difference is F but for the roundings.
#[test]
fn a_push_is_the_slope_of_its_potential() {
    let (world, ids) = five::<f64>();
    let push = Push::new(ids[2], Vec2::new(1.5, -7.0));
    assert_eq!(world.potential_energy(&push), -(1.5 * -2.0 - 7.0 * 4.0));
    assert_eq!(slope(&world, ids[2], &push, 0.25), [1.5, -7.0]);
    assert_eq!(slope(&world, ids[1], &push, 0.25), [0.0; 2]);
}

#[test]
fn a_pull_refuses_what_it_cannot_hold() {
    assert!(Pull::<I16F16>::new(dec!(-1), 1).is_err());
    assert!(Pull::<I16F16>::new(1, 0).is_err());
    assert!(Pull::<I16F16>::new(1, -1).is_err());
    assert!(Pull::<I16F16>::new(1, 40_000).is_err());
    assert!(Pull::<I16F16>::new(1, dec!(0.000001)).is_err());
    assert!(Pull::<f32>::new(1, dec!(0.00000000000001)).is_err());
    assert!(Pull::<f32>::new(0, dec!(0.001)).is_ok());
}
