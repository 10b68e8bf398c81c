//! A spin with a remainder, under each method: an angle goes on by all of it.

use fixstep::{CarryAngular, Rotating, World};

use super::*;

const STEPS: u64 = 20_000;

/// Spin and remainder in units of 2^-15 of the scalar's, with the last word of the state.
fn kept<C: Centre<S: Grid>>(body: &Rigid<C>) -> i64 {
    let mut rest = 0;
    body.write_state(&mut |word| rest = word);
    ((body.spin().units() as i64) << 15) + (rest as u16 as i16) as i64
}

/// At 1/64 s a product of a spin of `2^-15` units with `h` has all its bits. The five shares of `Pefrl` add up to
/// `h` but for their roundings, 2^-31 of each, and each product may be rounded to 2^-65 turns twice, for spin
/// and remainder.
fn check<S: Grid + CarryAngular>(spin: f64, round: f64) {
    let fraction = S::unit(0.0).log2();
    for scheme in ALL_SCHEMES {
        let mut body = spinning::<Carried<S>>(spin);
        body.push_angular(scalar(round));
        let kept = kept(&body);
        assert_ne!(kept % (1 << 15), 0, "no remainder");
        let (mut world, step) = (World::<_, 1>::new(), DyadicStep::<S, 1, 6>::new().unwrap());
        world.add(body).unwrap();
        let mut method = scheme.method();
        (0..STEPS).for_each(|_| world.step(&mut method, &mut (), &step));
        // Units of 2^-64 turns in a unit of the spin: 2^(64 - 15 - 6) of the scalar's unit.
        let unit = 1_i128 << (43 + fraction as i32);
        let exact = (kept as i128 * unit * STEPS as i128) as u64;
        let error = apart(all_bits(&world.bodies()[0]), exact).abs();
        let turns = kept as f64 * unit as f64 * STEPS as f64 / TURN;
        let bound = match scheme {
            Scheme::Pefrl => STEPS as f64 * 10.0 * 0.5 / TURN + turns.abs() * 2.0_f64.powi(-30),
            _ => 0.0,
        };
        println!(
            "{} {scheme:?}: {turns:.3} turns, off by {error:.1e}",
            S::name()
        );
        assert!(error <= bound, "{} {scheme:?}: {error:e}", S::name());
    }
}

#[test]
fn an_angle_goes_on_by_a_spin_and_its_remainder() {
    check::<I16F16>(0.3, 1.23e-2);
    check::<I16F16>(-2.3, 0.57);
    check::<I8F24>(0.3, 1.23e-2);
}
