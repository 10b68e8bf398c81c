//! Total masses, weights far apart, the ends of the range, and what is refused.

use fixstep::{Error, Point};

use super::*;

fn ratio(num: i64, den: u64) -> Ratio {
    Ratio::new(num, den).unwrap()
}

fn at<S: Scalar>(x: S, mass: Ratio) -> PointMass<S> {
    PointMass {
        position: Vec2::new(x, x.negated()),
        velocity: Vec2::new(x.negated(), x),
        mass,
    }
}

/// A set of these masses, all at rest at the origin.
fn of<S: Scalar>(masses: &[Ratio]) -> Result<CentreOfMass<S>, Error> {
    CentreOfMass::new(&masses.iter().map(|&m| at(S::ZERO, m)).collect::<Vec<_>>())
}

#[test]
fn the_total_of_decimals_and_fractions_is_exact() {
    let mut random = Random(5);
    for kind in [0, 1] {
        for n in (1..=16).flat_map(|n| [n; 100]) {
            let set = set::<f32>(kind, n, &mut random);
            let den = KINDS[kind].1;
            let sum: i128 = set.iter().map(|p| whole(p.mass, den)).sum();
            let exact = ratio(sum as i64, den as u64);
            assert_eq!(CentreOfMass::new(&set).unwrap().mass, exact);
        }
    }
    let ten = of::<f32>(&[dec!(0.1); 10]).unwrap();
    assert_eq!(ten.mass, dec!(1));
    assert_eq!(
        of::<f32>(&[dec!(0.001), dec!(2000000)]).unwrap().mass,
        dec!(2000000.001)
    );
}

// Denominators that share nothing soon need more than 62 bits. The total is then off by 2^-32 of
// itself for each sum at most, and where that cannot be, refused: 2 10^8 kg leave the denominator
// 34 bits, 2 10^9 kg but 31.
#[test]
fn a_total_that_does_not_fit_is_near_or_refused() {
    let primes = [1_000_003, 998_244_353, 1_000_000_007, 2_147_483_647];
    let masses = |kg: i64| primes.map(|p| ratio(kg * p as i64 + 1, p));
    for kg in [0, 1, 1000, 50_000_000] {
        let total = of::<f32>(&masses(kg)).unwrap().mass;
        // Summed apart: 10^7 and a part of 10^-9 would lose the part in an `f64`.
        let parts: f64 = primes.iter().map(|&p| 1.0 / p as f64).sum();
        let (num, den) = (i128::from(total.num()), i128::from(total.den()));
        let off = (num - i128::from(4 * kg) * den) as f64 / den as f64 - parts;
        let error = off.abs() / (4.0 * kg as f64 + parts);
        println!("{kg} kg: {error:e} of itself off");
        assert!(error <= 4.0 * 2.0_f64.powi(-32));
    }
    let (field, large) = ("mass", masses(1_000_000_000));
    let value = large[1];
    assert_eq!(of::<f32>(&large), Err(Error::OutOfRange { field, value }));
}

// The gram weighs 5e-10 of the whole: 1.07 units at the end of the range. The lighter ones have
// weights that no coefficient holds and move the centre by less than half a unit, which is added.
#[test]
fn a_gram_beside_2000_tons_has_its_weight() {
    fn check<S: Anywhere + Grid>(light: Ratio, den: i128, allowed: f64) {
        let heavy = at(S::of_units(-1_234_567), ratio(2_000_000, 1));
        for end in [i32::MAX, -i32::MAX] {
            let set = vec![at(S::of_units(end), light), heavy];
            let all = CentreOfMass::new(&set).unwrap();
            let error = off(all.position.x, sums(&set, den, |p| p.position.x), 0.0);
            println!("{} {light} kg: {error:.3} units", S::name());
            assert!(error <= allowed, "{error} > {allowed}");
            let turned: Set<S> = set.iter().rev().copied().collect();
            assert_eq!(CentreOfMass::new(&turned), Ok(all));
            assert!(all.point().is_ok());
        }
    }
    // Two products of half a unit; 2^-31 of either weight's share.
    check::<I16F16>(dec!(0.001), 1000, 1.01);
    check::<I8F24>(dec!(0.001), 1000, 1.01);
    // One product, and less than half a unit left out.
    check::<I16F16>(dec!(0.0001), 10_000, 1.01);
    check::<I8F24>(ratio(1, 1 << 40), 1 << 40, 1.01);
}

#[test]
fn points_at_the_ends_of_the_range_stay_in_it() {
    fn check<S: Grid>() {
        let mut random = Random(9);
        for n in (1..=16).flat_map(|n| [n; 100]) {
            let masses: Vec<_> = (0..n).map(|i| mass(i % 3, &mut random)).collect();
            for (end, sign) in [(i32::MAX, 1), (-i32::MAX, -1)] {
                let set: Vec<_> = masses.iter().map(|&m| at(S::of_units(end), m)).collect();
                let all = CentreOfMass::new(&set).unwrap();
                // n products of half a unit, and a unit for the weights.
                let [r, v] = [all.position, all.velocity];
                for centre in [r.x, r.y.negated(), v.x.negated(), v.y] {
                    let units = i64::from(centre.units()) * sign;
                    assert!(
                        units >= i64::from(i32::MAX) - n as i64 / 2 - 2,
                        "{n}: {units}"
                    );
                }
            }
        }
    }
    check::<I16F16>();
    check::<I12F20>();
    check::<I8F24>();
    check::<I20F12>();
}

#[test]
fn a_total_that_a_point_holds_is_its_mass() {
    let all = of::<I16F16>(&[ratio(1_000_000, 1); 2]).unwrap();
    assert_eq!(all.point(), Point::new(Vec2::ZERO, Vec2::ZERO, 2_000_000));
    let ends = [f32::MAX, f32::MIN, f32::MIN_POSITIVE, -0.0];
    assert!(CentreOfMass::new(&ends.map(|x| at(x, dec!(1)))).is_ok());
}
