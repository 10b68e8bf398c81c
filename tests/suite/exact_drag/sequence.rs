//! When drags act, and in which order: each in one part after the kicks or in two halves around them,
//! the second half backwards, in every kind of list.

use crate::support::*;
use fixstep::{Body, Force, Frame, Now, Part, Point, Step, TimeStep, World, heapless};
use std::cell::RefCell;

/// What a method has called.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Call {
    Field,
    Couple,
    Damp(u32, Part),
}

use Call::{Couple, Damp, Field};
use Part::{FirstHalf, SecondHalf, Whole};

thread_local! {
    static CALLS: RefCell<Vec<Call>> = const { RefCell::new(vec![]) };
}

fn note(call: Call) {
    CALLS.with_borrow_mut(|calls| calls.push(call));
}

/// A drag that notes when it acts.
#[derive(Clone, Copy, Debug)]
struct Drag(u32);

impl<B: Body> Force<B> for Drag {
    const COUPLES: bool = false;

    fn damp<H: TimeStep<B::S>>(&mut self, _: &Now<H>, part: Part, _: &mut B) {
        note(Damp(self.0, part));
    }
}

/// A force that notes when it kicks, from one body or from all.
struct Kick<const ALL: bool>;

impl<B: Body, const ALL: bool> Force<B> for Kick<ALL> {
    const COUPLES: bool = ALL;

    fn couple<H: TimeStep<B::S>>(&mut self, _: &Now<H>, _: &mut Frame<B>) {
        if ALL {
            note(Couple);
        }
    }

    fn field<H: TimeStep<B::S>>(&mut self, _: &Now<H>, _: &B, _: &mut B) {
        if !ALL {
            note(Field);
        }
    }
}

/// The calls of one step of a world of one.
fn calls(scheme: Scheme, mut forces: impl Force<Point<f32>>) -> Vec<Call> {
    let mut world: World<Point<f32>, 1> = world([point([0.0; 2], [1.0, 0.0], 1.0)]);
    world.step(&mut scheme.method(), &mut forces, &Step::hz(60).unwrap());
    CALLS.take()
}

/// Drags 1 to n, in that order and back, around one kick.
fn around(scheme: Scheme, n: u32, kick: Call) -> Vec<Call> {
    let part = |part, i| Damp(i, part);
    match super::parts(scheme) {
        1 => [kick]
            .into_iter()
            .chain((1..=n).map(|i| part(Whole, i)))
            .collect(),
        _ => {
            let first = (1..=n).map(|i| part(FirstHalf, i));
            let second = (1..=n).rev().map(|i| part(SecondHalf, i));
            first.chain([kick]).chain(second).collect()
        }
    }
}

#[test]
fn drags_act_after_the_kick_or_half_before_and_half_after() {
    for scheme in SCHEMES {
        assert_eq!(
            calls(scheme, (Kick::<false>, Drag(1))),
            around(scheme, 1, Field)
        );
        assert_eq!(
            calls(scheme, (Drag(1), Kick::<false>)),
            around(scheme, 1, Field)
        );
        assert_eq!(
            calls(scheme, (Kick::<true>, Drag(1))),
            around(scheme, 1, Couple)
        );
        assert_eq!(
            calls(scheme, (Drag(1), Kick::<true>, Drag(2))),
            around(scheme, 2, Couple)
        );
    }
}

#[test]
fn the_second_half_goes_backwards_in_every_list() {
    let drags = [1, 2, 3].map(Drag);
    let [a, b, c] = drags;
    for scheme in SCHEMES {
        let of = |n| around(scheme, n, Field);
        let kick = Kick::<false>;
        assert_eq!(calls(scheme, (kick, a, b)), of(2));
        assert_eq!(calls(scheme, (Kick::<false>, drags)), of(3));
        let list: heapless::Vec<Drag, 4> = drags.into_iter().collect();
        assert_eq!(calls(scheme, (list, Kick::<false>)), of(3));
        assert_eq!(
            calls(scheme, (Some(a), None::<Drag>, Kick::<false>, &mut Drag(2))),
            of(2)
        );
        assert_eq!(calls(scheme, (a, (b, c), Kick::<false>)), of(3));
        assert_eq!(calls(scheme, (a, b, c, Drag(4), Kick::<false>)), of(4));
        assert_eq!(
            calls(scheme, (Kick::<false>, a, b, c, Drag(4), Drag(5))),
            of(5)
        );
    }
}

/// The stage by hand is what a method does.
#[test]
fn the_stage_damps_every_body() {
    let mut bodies = [1.0, 2.0].map(|v| point::<f32>([0.0; 2], [v, 0.0], 1.0));
    let now = Now::start(&Step::<f32>::hz(60).unwrap(), 0);
    fixstep::integrate::damp(&mut bodies, &mut [Drag(1), Drag(2)], &now, Whole);
    let both = [Damp(1, Whole), Damp(2, Whole)];
    assert_eq!(CALLS.take(), [both, both].concat());
}
