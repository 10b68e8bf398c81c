//! Scenes whose answer is known to the unit: at the very end of a range, with headroom, beyond all types.

use fixstep::Vec2;

use crate::advise::{Question, USUAL, Verdict};
use crate::described::Described;
use crate::notes::Role;
use crate::report;
use crate::scene::Start;
use crate::scenes::{ask, best, measured, question};

fn resting(x: f64) -> Described {
    let (position, velocity) = (Vec2::new(x, 0.0), Vec2::ZERO);
    Described {
        bodies: vec![Start {
            position,
            velocity,
            mass: 1.0,
        }],
        ..Described::default()
    }
}

// An I8F24 ends at 2^31 - 1 units, which counts as outside: two units below 128 m is the last place inside.
#[test]
fn a_unit_decides() {
    let unit = (-24.0_f64).exp2();
    for (x, fraction) in [
        (128.0 - 2.0 * unit, 24),
        (128.0 - unit, 23),
        (128.0, 23),
        (256.0 - 4.0 * unit, 23),
        (256.0 - unit, 22),
    ] {
        for x in [x, -x] {
            let advice = ask(&resting(x), &question(1.0));
            assert_eq!(best(&advice), fraction, "{x}");
        }
    }
}

// Thrown up at v, by Verlet without error: an apex v²/2g of 127.99 m and of 128.01 m, g = 1 m/s².
#[test]
fn an_apex_decides() {
    for (apex, fraction) in [(127.99_f64, 24), (128.01, 23)] {
        let mut thrown = resting(0.0);
        thrown.gravity = Some(Vec2::new(0.0, -1.0));
        thrown.bodies[0].velocity.y = (2.0 * apex).sqrt();
        let advice = ask(&thrown, &question(20.0));
        assert_eq!(best(&advice), fraction, "{apex}");
        assert_eq!(advice.first(), Some(Role::Position));
        let (flown, _) = measured(&thrown, &advice.question.plan, 24).unwrap();
        assert_eq!(flown.marked, fraction != 24);
    }
}

#[test]
fn headroom_is_left_where_it_is_asked_for() {
    let asked = Question {
        headroom: 1.0,
        beside: USUAL,
        ..question(1.0)
    };
    let advice = ask(&resting(100.0), &asked);
    assert_eq!(best(&advice), 23);
    let of = |fraction| advice.formats.iter().find(|f| f.fraction == fraction);
    assert!(matches!(of(24).unwrap().verdict, Verdict::Tight(_)));
    assert!(matches!(of(16).unwrap().verdict, Verdict::Fits(_)));
}

#[test]
fn what_no_type_holds_gets_none() {
    let advice = ask(&resting(2e9), &question(1.0));
    assert!(advice.best.is_none());
    assert!(report::report("far away", &advice).contains("No type of 32 bits"));
}
