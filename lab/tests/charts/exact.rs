//! Where the bodies should be. Closed forms are held against the extrapolated reference, and that against
//! Kepler's equation and against itself at half the interval.

use std::f64::consts::TAU;

use fixstep::Ratio;

use crate::exact::{LOOKS, Places, flight, last_second, pair, swing, turn};
use crate::reference::{Acceleration, air, path, path_in, stars};
use crate::rotor::{BEARING, INERTIA, TORQUES};
use crate::scenes::{
    CLUSTER_SOFTENING, DRAG, GRAVITY, MASSES, PAIR_REST, PAIR_STIFFNESS, SOFTENING, STIFFNESS,
};
use crate::starts::{Dot, Plan, STARTS};

const SCENES: [&str; 7] = [
    "spring",
    "projectile",
    "quadratic",
    "kepler",
    "cluster",
    "pair",
    "rotor",
];
/// Of places up to some ten metres, after a thousand intervals in `f64`: each rounds by 7e-15 m at 32 m,
/// and the extrapolation by some ten times that. Far below the least error of a chart, 2e-8 m.
const BOUND: f64 = 1e-10;

/// Of the worlds one in so many is enough to hold two references against each other.
const SOME: usize = 4;

/// The largest distance.
fn apart(a: &Places, b: &Places) -> f64 {
    let distances = a
        .iter()
        .zip(b)
        .map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
    assert_eq!(a.len(), b.len());
    distances.fold(0.0, |worst, one| if one <= worst { worst } else { one })
}

/// The closed form at every look of every world, against the reference.
fn check(scene: &'static str, closed: fn(&[Dot], f64) -> Places, acceleration: &Acceleration) {
    let plan = Plan::of(scene);
    for world in plan.worlds.iter().step_by(SOME) {
        let stepped = path(world, acceleration, LOOKS, LOOKS * plan.seconds);
        for (tick, places) in stepped.iter().enumerate() {
            let error = apart(places, &closed(world, tick as f64 / f64::from(LOOKS)));
            assert!(error <= BOUND, "{scene}, tick {tick}: {error:e}");
        }
    }
}

#[test]
fn closed_forms_obey_their_laws() {
    let [k, drag, gravity] = [STIFFNESS, DRAG, GRAVITY].map(Ratio::to_f64);
    check("spring", swing, &move |x, _| {
        x.iter().map(|x| x.map(|x| -k * x)).collect()
    });
    let falling = move |v: &[f64; 2]| [-drag * v[0], gravity - drag * v[1]];
    check("projectile", flight, &move |_, v| {
        v.iter().map(falling).collect()
    });
    let [rest, k, a, b] = [PAIR_REST, PAIR_STIFFNESS, MASSES[0], MASSES[1]].map(Ratio::to_f64);
    check("pair", pair, &move |x, _| {
        let d = [x[1][0] - x[0][0], x[1][1] - x[0][1]];
        let length = d[0].hypot(d[1]);
        let force = d.map(|d| k * (length - rest) * d / length);
        vec![force.map(|f| f / a), force.map(|f| -f / b)]
    });
    // I ω' = M - c ω, and a turn is 2π.
    let [drag, inertia] = [BEARING, INERTIA].map(Ratio::to_f64);
    let slowed = move |(torque, v): (Ratio, &[f64; 2])| {
        let torque = torque.to_f64() - drag * TAU * v[0];
        [torque / inertia / TAU, 0.0]
    };
    check("rotor", turn, &move |_, v| {
        TORQUES.into_iter().zip(v).map(slowed).collect()
    });
}

/// Without softening two stars follow Kepler's equation: `E - e sin E = t` from the closest point, half of
/// `(cos E - e, sqrt(1 - e²) sin E)` each.
#[test]
fn the_reference_follows_kepler() {
    let e: f64 = 0.6;
    let star = |sign: f64| Dot {
        x: [sign * (1.0 - e) / 2.0, 0.0],
        v: [0.0, sign * ((1.0 + e) / (1.0 - e)).sqrt() / 2.0],
        mass: 1.0,
    };
    let stepped = path(
        &[star(1.0), star(-1.0)],
        &|x, v| stars(0.0, x, v),
        LOOKS,
        12 * LOOKS,
    );
    for (tick, places) in stepped.iter().enumerate() {
        let mean = (tick as f64 / f64::from(LOOKS)).rem_euclid(TAU);
        let newton = |at: f64| at - (at - e * at.sin() - mean) / (1.0 - e * at.cos());
        let (sin, cos) = (0..60).fold(TAU / 2.0, |at, _| newton(at)).sin_cos();
        let half = [(cos - e) / 2.0, (1.0 - e * e).sqrt() * sin / 2.0];
        let error = apart(places, &vec![half, half.map(|x| -x)]);
        assert!(error <= BOUND, "tick {tick}: {error:e}");
    }
}

/// At half the interval an error of order 16 is 65,000 times smaller: the difference is the error.
#[test]
fn the_reference_agrees_with_half_its_interval() {
    let [near, far] = [SOFTENING, CLUSTER_SOFTENING].map(Ratio::to_f64);
    let laws: [(&str, &Acceleration); 3] = [
        ("quadratic", &air),
        ("kepler", &move |x, v| stars(near, x, v)),
        ("cluster", &move |x, v| stars(far, x, v)),
    ];
    for (scene, law) in laws {
        let plan = Plan::of(scene);
        for world in plan.worlds.iter().step_by(SOME) {
            let ends = [4, 8].map(|n| path_in(n, world, law, LOOKS, LOOKS * plan.seconds));
            let error = apart(&ends[0][ends[0].len() - 1], &ends[1][ends[1].len() - 1]);
            assert!(error <= BOUND, "{scene}: {error:e}");
            let looks = last_second(scene, world, plan.seconds);
            assert_eq!(looks[..], ends[0][ends[0].len() - looks.len()..]);
        }
    }
}

/// A nanometre at the start stays below a micrometre: a chart of a chaotic scene would show luck.
#[test]
fn no_scene_of_stars_is_chaotic() {
    for scene in ["kepler", "cluster"] {
        let plan = Plan::of(scene);
        for world in &plan.worlds {
            let mut moved = world.clone();
            moved[0].x[0] += 1e-9;
            let [a, b] = [world, &moved].map(|world| last_second(scene, world, plan.seconds));
            for (a, b) in a.iter().zip(&b) {
                let grown = apart(a, b);
                assert!(grown <= 1e-6, "{scene}: {grown:e}");
            }
        }
    }
}

// Falls are farthest at the end, and all others within some metres.
#[test]
fn starts_are_exact_in_every_number_type_and_paths_in_range() {
    for scene in SCENES {
        let plan = Plan::of(scene);
        let bodies: usize = plan.worlds.iter().map(Vec::len).sum();
        let starts = if plan.alone {
            bodies
        } else {
            plan.worlds.len()
        };
        assert_eq!(starts, STARTS, "{scene}");
        for world in &plan.worlds {
            for number in world.iter().flat_map(|dot| [dot.x, dot.v]).flatten() {
                let units = number * 65536.0;
                assert!(
                    units == units.round() && units.abs() < f64::from(1 << 23),
                    "{scene}"
                );
            }
            let looks = last_second(scene, world, plan.seconds).into_iter();
            let inside = |place: &[f64; 2]| place.iter().all(|x| x.abs() < 127.0);
            assert!(looks.flatten().all(|place| inside(&place)), "{scene}");
        }
    }
}
