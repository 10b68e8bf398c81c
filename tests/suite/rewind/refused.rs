//! What types cannot tell: the start of time, and dampers. A refusal changes nothing.

use fixstep::fixed::types::I16F16;
use fixstep::{AllPairs, Anchor, GravityY, Pairs, RewindError, Spring, Window, dec, heapless};

use super::*;
use crate::support::{point, vector};

type Scene = World<RangeChecked<Point<I16F16>>, 2>;

fn scene() -> (Scene, [BodyId; 2]) {
    let of = |x: f64| point([x, 0.0], [1.0, x], 1.0);
    let world = watched([of(-1.0), of(2.0)]);
    let [a, b] = world.ids() else { unreachable!() };
    let ids = [*a, *b];
    (world, ids)
}

/// Ten steps, and what the first step back says; the state is the same after a refusal.
fn answer(mut forces: impl Reversible<RangeChecked<Point<I16F16>>>) -> Result<(), RewindError> {
    let (mut world, step) = (scene().0, Step::hz(60).unwrap());
    (0..9).for_each(|_| world.step(&mut Verlet, &mut forces, &step));
    let before = state(&world);
    world.step(&mut Verlet, &mut forces, &step);
    let end = state(&world);
    let answer = world.step_back(&mut Verlet, &mut forces, &step);
    assert_eq!(state(&world), if answer.is_ok() { before } else { end });
    answer
}

#[test]
fn there_is_nothing_before_tick_0() {
    let (mut world, step) = (scene().0, Step::hz(60).unwrap());
    let began = state(&world);
    let mut gravity = GravityY::new(-8).unwrap();
    for _ in 0..2 {
        let refused = world.step_back(&mut Verlet, &mut gravity, &step);
        assert_eq!(refused, Err(RewindError::AtStart));
        assert_eq!(state(&world), began);
        world.step(&mut Verlet, &mut gravity, &step);
        assert_eq!(world.step_back(&mut Verlet, &mut gravity, &step), Ok(()));
    }
}

#[test]
fn a_damper_is_found_wherever_it_stands() {
    let (_, [a, b]) = scene();
    let damped = |force| Err(RewindError::Damped { force });
    let anchor = |c| Anchor::new(a, vector(1.0, 1.0), 5, c).unwrap();
    let spring = |c| Spring::new(1, 5, c).unwrap();
    let still = || GravityY::new(-8).unwrap();
    // The smallest damping that a coefficient holds counts too.
    let least = fixstep::Ratio::new(1, 1 << 32).unwrap();
    assert_eq!(answer(anchor(dec!(0))), Ok(()));
    assert_eq!(answer(anchor(least)), damped("Anchor"));
    assert_eq!(answer(Pairs::new(spring(dec!(0)), [[a, b]])), Ok(()));
    assert_eq!(
        answer(Pairs::new(spring(least), [[a, b]])),
        damped("Spring")
    );
    assert_eq!(answer(AllPairs(spring(dec!(0.1)))), damped("Spring"));
    assert_eq!(answer([anchor(dec!(0)), anchor(dec!(2))]), damped("Anchor"));
    assert_eq!(answer(Some(anchor(dec!(2)))), damped("Anchor"));
    assert_eq!(answer(None::<Anchor<I16F16>>), Ok(()));
    let mut lent = anchor(dec!(2));
    assert_eq!(answer((&mut lent,)), damped("Anchor"));
    let mut list = heapless::Vec::<_, 2>::new();
    list.push(anchor(dec!(2))).unwrap();
    assert_eq!(answer(list), damped("Anchor"));
    assert_eq!(answer((still(), (), anchor(dec!(2)))), damped("Anchor"));
    assert_eq!(
        answer((still(), still(), still(), still(), still(), anchor(dec!(2)))),
        damped("Anchor")
    );
}

// Ten steps are made, 0 to 9: the last decides.
#[test]
fn a_damper_in_a_window_counts_while_it_is_open() {
    let (_, [a, _]) = scene();
    let anchor = || Anchor::new(a, vector(1.0, 1.0), 5, 1).unwrap();
    let damped = Err(RewindError::Damped { force: "Anchor" });
    assert_eq!(answer(Window::new(9..10, anchor())), damped);
    assert_eq!(answer(Window::new(0..9, anchor())), Ok(()));
    assert_eq!(answer(Window::new(10..99, anchor())), Ok(()));
}

#[test]
fn messages_name_the_body_and_the_force() {
    let (_, [_, body]) = scene();
    let errors = [
        (RewindError::AtStart, "tick 0"),
        (RewindError::Saturated { body }, "body 1 "),
        (
            RewindError::Damped { force: "Spring" },
            "Spring has damping",
        ),
    ];
    for (error, part) in errors {
        let text = error.to_string();
        assert!(text.contains(part), "{text}");
        assert!(text.len() < 80 && !text.contains('\n'), "{text}");
    }
}
