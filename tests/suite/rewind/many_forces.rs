//! Every force that goes back, in every kind of list.

use fixstep::fixed::types::{I8F24, I16F16};
use fixstep::{
    AllBodies, AllPairs, Anchor, Exact, Gravity, GravityY, Pairs, Pefrl, PerBody, PositionOnly,
    Push, Spring, Time, Vec2, Window, heapless,
};

use super::*;
use crate::support::{Format, point, ratio, spread, vector};

fn spring<S: Scalar>(length: f64, stiffness: f64) -> Spring<S> {
    Spring::new(ratio(length), ratio(stiffness), 0).unwrap()
}

/// Up to 3 N along x, by the time and by whether the body is left of the origin.
fn tide<S: Scalar>() -> impl FnMut(Time, &RangeChecked<Point<S>>) -> Vec2<S> {
    let table: [Vec2<S>; 31] =
        std::array::from_fn(|i| vector(6.0 * spread(i) - 3.0, spread(i + 50) - 0.5));
    move |time, body| {
        let push = table[(time.half_ticks() % 31) as usize];
        if body.position().x < S::ZERO {
            push
        } else {
            -push
        }
    }
}

/// Draws each body to the next in a ring.
fn ring<S: Scalar>(_: Time, all: &[RangeChecked<Point<S>>], i: usize) -> Vec2<S> {
    all[(i + 1) % all.len()].position() - all[i].position()
}

fn forces<S: Scalar>([a, b, c]: [BodyId; 3]) -> impl Reversible<RangeChecked<Point<S>>> {
    let anchor = |body, x, y, k: f64| Anchor::new(body, vector(x, y), ratio(k), 0).unwrap();
    let mut pushes = heapless::Vec::<Push<S>, 4>::new();
    pushes.push(Push::new(a, vector(0.3, 0.7))).unwrap();
    pushes.push(Push::new(c, vector(-1.9, 0.1))).unwrap();
    (
        Gravity::new(vector(0.37, -9.81)),
        [
            anchor(a, -2.0, 1.0, 23.0),
            anchor(b, 0.5, 2.0, 11.0),
            anchor(c, 2.0, 0.0, 17.0),
        ],
        (
            Pairs::new(spring(1.3, 7.1), [[a, b], [c, b]]),
            AllPairs(spring(2.1, 3.3)),
        ),
        Window::new(
            1000..4000,
            (
                Push::new(b, vector(-2.9, 0.71)),
                GravityY::new(ratio(1.7)).unwrap(),
            ),
        ),
        (
            PositionOnly(PerBody(tide())),
            PositionOnly(AllBodies::<_, S, 3>::new(ring)),
        ),
        (
            pushes,
            Some(GravityY::new(ratio(-0.3)).unwrap()),
            None::<Push<S>>,
        ),
    )
}

fn returns<S: Format + Exact>(
    way: &str,
    start: u64,
    mut method: impl Rewinds<RangeChecked<Point<S>>, 3>,
    step: &impl TimeStep<S>,
) {
    let name = format!("{}, {way}", S::name());
    let of = |i: usize| {
        let at = spread(10 * start as usize + i);
        point(
            [4.0 * at - 2.0, 1.0 - at],
            [2.0 - 5.0 * at, at],
            0.4 + i as f64,
        )
    };
    let mut world = watched([of(0), of(1), of(2)]);
    let [a, b, c] = world.ids() else {
        unreachable!()
    };
    let mut forces = forces([*a, *b, *c]);
    there_and_back(
        &name,
        &mut world,
        &mut method,
        &mut &mut forces,
        step,
        [support::long(10_000), support::long(100)],
    );
}

#[test]
fn i16f16_returns() {
    every_way!(returns::<I16F16>, 1);
}

#[test]
fn i8f24_returns() {
    every_way!(returns::<I8F24>, 5);
}

#[test]
fn pefrl_returns() {
    let (hz, dyadic) = (
        Step::hz(60).unwrap(),
        DyadicStep::<I8F24, 1, 6>::new().unwrap(),
    );
    returns::<I16F16>("Pefrl, 1/60", 17, Pefrl::new(), &hz);
    returns::<I8F24>("Pefrl, 1/64", 18, Pefrl::new(), &dyadic);
}

/// An impulse by hand between two steps, undone by the opposite one at its tick.
#[test]
fn an_impulse_by_hand_is_undone_by_its_opposite() {
    let step = Step::<I16F16>::hz(60).unwrap();
    for start in 0..16 {
        let at = spread(start);
        let ball: Point<I16F16> = point([at, 2.0], [3.0 * at, -1.0], 0.3 + at);
        let mut world = watched([ball]);
        let (id, began) = (world.ids()[0], state(&world));
        let mut gravity = GravityY::new(ratio(-9.81)).unwrap();
        let impulse = vector(0.7 - at, 3.0 * at);
        (0..50).for_each(|_| world.step(&mut Verlet, &mut gravity, &step));
        let free = state(&world);
        world.get_mut(id).unwrap().push(impulse);
        assert_ne!(state(&world), free);
        (0..50).for_each(|_| world.step(&mut Verlet, &mut gravity, &step));
        let mut back = |world: &mut World<_, 1>| {
            (0..50).for_each(|_| world.step_back(&mut Verlet, &mut gravity, &step).unwrap());
        };
        back(&mut world);
        world.get_mut(id).unwrap().push(-impulse);
        assert_eq!(state(&world), free);
        back(&mut world);
        assert_eq!(state(&world), began);
    }
}
