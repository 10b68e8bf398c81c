//! `QuadraticDrag`: one step against `v - c |v| h / m v`.

use super::*;
use crate::support::{Format, maximum, point, ratio, spread, within};
use fixstep::QuadraticDrag;
use fixstep::scalar::Factor;

/// The body after one step of 1/60 s.
fn braked<S: Scalar>(body: Point<S>, drag: f64) -> Vec2<S> {
    let mut world = World::<_, 1>::new();
    world.add(body).unwrap();
    let mut force = QuadraticDrag::new(ratio(drag)).unwrap();
    world.step(&mut SemiImplicitEuler, &mut force, &Step::hz(60).unwrap());
    world.bodies()[0].velocity()
}

/// Start `i`: up to 30 m/s in any direction, 0.3 to 30 kg, drag of up to a half of `m / (h v)`.
fn start<S: Scalar>(i: usize) -> (Point<S>, f64) {
    let [vx, vy] = [0, 1].map(|k| 60.0 * (spread(3 * i + k) - 0.5));
    let mass = 0.3 * 100.0_f64.powf(spread(i + 500));
    (point([0.0; 2], [vx, vy], mass), mass * spread(i + 900))
}

/// The change of velocity is rounded once, to half a unit; in it the speed, to half a unit, and
/// `c h / m`, by `COEFFICIENT` and two products more. In floats that is 1.5 epsilons, a length of one,
/// two products and the change itself of a half: 4, as many as `8/3 COEFFICIENT`.
/// The reference rounds too.
fn check_step<S: Format>() {
    let errors: Vec<f64> = (0..4000)
        .map(|i| {
            let (body, drag) = start::<S>(i);
            let v = body.velocity().to_f64();
            let factor = drag / 60.0 * Factor::<S>::to_f64(body.inv_mass());
            let speed = v.length();
            let half = 0.5 * S::unit(speed);
            let (got, exact) = (
                braked(body, drag).to_f64(),
                v.map(|v| v - factor * speed * v),
            );
            let off = |got: f64, exact: f64, v: f64| {
                let change = factor * v.abs();
                let allowed = half * (1.0 + change) + 8.0 / 3.0 * S::COEFFICIENT * change * speed;
                (got - exact).abs() / (allowed + 2.0 * f64::EPSILON * v.abs())
            };
            maximum(&[off(got.x, exact.x, v.x), off(got.y, exact.y, v.y)])
        })
        .collect();
    within(
        1.0,
        &format!("{} quadratic drag, of its bound", S::name()),
        &errors,
    );
}

#[test]
fn quadratic_drag_is_v_less_c_speed_h_over_m_of_v() {
    check_step::<f32>();
    check_step::<f64>();
    check_step::<I16F16>();
    check_step::<I12F20>();
    check_step::<I8F24>();
    check_step::<I20F12>();
}

/// Mirrored, turned by a quarter: mirrored, turned. Below `c |v| h / m = 1` nothing turns round.
fn check_symmetry<S: Format>() {
    for i in 0..1000 {
        let (body, drag) = start::<S>(i);
        let turned = |signs: [bool; 2], swap: bool| {
            let part = |s: S, negate: bool| if negate { s.negated() } else { s };
            let v = body.velocity();
            let v = Vec2::new(part(v.x, signs[0]), part(v.y, signs[1]));
            let mut body = body;
            body.set_velocity(if swap { Vec2::new(v.y, v.x) } else { v })
                .unwrap();
            let v = braked(body, drag);
            let v = if swap { Vec2::new(v.y, v.x) } else { v };
            Vec2::new(part(v.x, signs[0]), part(v.y, signs[1]))
        };
        let (plain, before) = (turned([false; 2], false), body.velocity());
        for signs in [[true, false], [false, true], [true, true]] {
            assert_eq!(turned(signs, false), plain, "{} {i}", S::name());
            assert_eq!(turned(signs, true), plain, "{} {i}", S::name());
        }
        for (after, before) in plain.array().into_iter().zip(before.array()) {
            let (after, before) = (after.to_f64(), before.to_f64());
            let between = after * before >= 0.0 && after.abs() <= before.abs();
            assert!(between, "{} {i}: {before} became {after}", S::name());
        }
    }
}

#[test]
fn quadratic_drag_brakes_every_direction_alike() {
    check_symmetry::<f32>();
    check_symmetry::<f64>();
    check_symmetry::<I16F16>();
    check_symmetry::<I12F20>();
    check_symmetry::<I8F24>();
    check_symmetry::<I20F12>();
}

/// (3, 4) m/s has a speed of 5 to the bit: `5 c h / m` of 1/8 and 2 kg.
fn check_exact<S: Scalar>() {
    let mut world = World::<_, 1>::new();
    world.add(point::<S>([0.0; 2], [3.0, -4.0], 2.0)).unwrap();
    let mut drag = QuadraticDrag::new(dec!(0.8)).unwrap();
    world.step(&mut Euler::new(), &mut drag, &Sixteenth::new().unwrap());
    let v = world.bodies()[0].velocity().to_f64();
    // 1 - 0.8 * 5 / 16 / 2 = 0.875; 0.8 has 31 bits or 24.
    assert!(
        (v.x - 2.625).abs() <= 4e-7 && (v.y + 3.5).abs() <= 4e-7,
        "{v:?}"
    );
    assert_eq!(world.potential_energy(&drag), 0.0);
}

#[test]
fn quadratic_drag_by_hand() {
    check_exact::<f32>();
    check_exact::<f64>();
    check_exact::<I16F16>();
    check_exact::<I8F24>();
    assert!(QuadraticDrag::<I16F16>::new(dec!(-0.1)).is_err());
}

// Terminal speed sqrt(m g / c) = sqrt(2 * 8 / 0.25) = 8 m/s. At rest a step changes v by less than
// half a unit: c h/m (v² - 64) / unit < 1/2, so |v - 8| <= unit / (4 * 8 * c h / m), 15 units.
#[test]
fn a_fall_ends_at_the_terminal_speed() {
    let mut world = World::<_, 1>::new();
    world.add(point::<I16F16>([0.0; 2], [0.0; 2], 2.0)).unwrap();
    let mut forces = (
        GravityY::new(-8).unwrap(),
        QuadraticDrag::new(dec!(0.25)).unwrap(),
    );
    for _ in 0..1200 {
        world.step(&mut Verlet, &mut forces, &Step::hz(60).unwrap());
    }
    let v = world.bodies()[0].velocity().y;
    assert!(
        (v.to_num::<f64>() + 8.0).abs() <= 16.0 * 2.0_f64.powi(-16),
        "{v}"
    );
}
