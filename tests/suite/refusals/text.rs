//! Numbers that cannot be read, and what the errors say.

use std::error::Error as _;

use super::*;
use fixstep::Stale;
use fixstep::ratio::RatioError;

#[test]
fn ratios() {
    let refused = Err(RatioError::NotANumber { field: "ratio" });
    let beyond = (1 << 62) + 1;
    for (num, den) in [
        (1, 0),
        (0, 0),
        (1, beyond as u64),
        (beyond, 1),
        (-beyond, 1),
        (i64::MIN, 1),
    ] {
        assert_eq!(Ratio::new(num, den), refused);
    }
    assert!(Ratio::new(-(1 << 62), 1 << 62).is_ok());
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 2.0_f64.powi(62)] {
        assert_eq!(
            Ratio::from_f64(value),
            Err(RatioError::NotFinite { field: "value" })
        );
    }
    assert_eq!(Ratio::from_f64(-0.375).unwrap().to_f64(), -0.375);
}

#[test]
fn decimals() {
    let digits_19 = "1234567890123456789";
    for bad in [
        "", "-", ".", "--1", "1-", "1..2", "1e9", "0x10", "+1", "1.f", ".-5", digits_19,
    ] {
        assert_eq!(
            Ratio::parse(bad),
            Err(RatioError::NotANumber { field: "decimal" }),
            "{bad:?}"
        );
    }
    for (good, num, den) in [
        ("-9.81", -981, 100),
        ("1_000", 1000, 1),
        (".5", 5, 10),
        ("-.5", -5, 10),
        ("7.", 7, 1),
        ("123456789012345678", 123_456_789_012_345_678, 1),
        ("0.00000000000000001", 1, 100_000_000_000_000_000),
    ] {
        assert_eq!(Ratio::parse(good), Ratio::new(num, den), "{good:?}");
    }
}

#[test]
fn messages_name_field_and_value_in_one_line() {
    let value = dec!(-9.81);
    for (error, value) in [
        (
            Error::NotPositive {
                field: "mass",
                value,
            },
            "-981/100",
        ),
        (
            Error::Negative {
                field: "mass",
                value,
            },
            "-981/100",
        ),
        (
            Error::OutOfRange {
                field: "mass",
                value,
            },
            "-981/100",
        ),
        (
            Error::RoundsToZero {
                field: "mass",
                value: ratio(7, 1),
            },
            " 7 ",
        ),
        (Error::NotFinite { field: "mass" }, "NaN"),
        (Error::NotANumber { field: "mass" }, "not a number"),
    ] {
        let text = error.to_string();
        assert!(text.starts_with("mass ") && text.contains(value), "{text}");
        assert!(text.len() < 80 && !text.contains('\n'), "{text}");
        assert!(error.source().is_none());
    }
}

#[test]
fn messages_differ() {
    let (field, value) = ("mass", dec!(1));
    let light = Point::new(Vec2::ZERO, Vec2::ZERO, 1).unwrap();
    let texts = [
        Error::NotPositive { field, value }.to_string(),
        Error::Negative { field, value }.to_string(),
        Error::OutOfRange { field, value }.to_string(),
        Error::RoundsToZero { field, value }.to_string(),
        Error::NotFinite { field }.to_string(),
        Error::NotANumber { field }.to_string(),
        World::<Point<f32>, 0>::new()
            .add(light)
            .unwrap_err()
            .to_string(),
        Stale(with_a_gap().1).to_string(),
        Error::Empty { field }.to_string(),
        Error::Degenerate { shape: field }.to_string(),
        Error::NotConvex { vertex: 3 }.to_string(),
    ];
    for (i, text) in texts.iter().enumerate() {
        assert!(!texts[..i].contains(text), "{text}");
    }
}

#[test]
fn a_full_world_is_an_error_with_the_body_inside() {
    let point = point::<I16F16>(1).unwrap();
    let full = World::<_, 0>::new().add(point).unwrap_err();
    let error: &dyn std::error::Error = &full;
    assert!(!error.to_string().contains('\n'));
    assert_eq!((full.body, full.capacity), (point, 0));
}
