//! The answer on one screen.

use std::fmt::Write;

use crate::advise::{Advice, Expected, Format, Verdict, range};
use crate::flight::Scheme;
use crate::notes::Role;

/// Instructions of a step at 1/60 s and at 1/64 s, on M0+ and M4F: an `I16F16` under gravity, from the
/// table of the README.
pub const PRICES: [(Scheme, [f64; 2], [f64; 2]); 2] = [
    (Scheme::SemiImplicitEuler, [64.6, 15.1], [29.0, 18.4]),
    (Scheme::Verlet, [93.8, 19.4], [39.7, 24.9]),
];

/// The whole report.
pub fn report(title: &str, advice: &Advice) -> String {
    let plan = &advice.question.plan;
    let mut text = format!(
        "{title}\n{} s at {} Hz by {:?}\n{}\n{:<16} {:>10} {:>10}\n",
        (1e3 * plan.seconds).round() / 1e3,
        plan.rate.to_f64(),
        plan.method,
        answer(advice),
        "",
        "largest",
        "smallest"
    );
    let rate = plan.rate.to_f64();
    let rows = [
        ("position, m", Role::Position, 1.0),
        ("velocity, m/s", Role::Velocity, 1.0),
        ("acceleration", Role::Kick, rate),
        ("impulse, kg m/s", Role::Impulse, 1.0),
        ("spin, turns/s", Role::Spin, 1.0),
        ("spin-up", Role::Twist, rate),
        ("torque, N m", Role::Moment, rate),
        ("impulse, kg m²/s", Role::Moment, 1.0),
        ("squared length", Role::Square, 1.0),
        ("coefficient", Role::Coefficient, 1.0),
    ];
    for (name, role, unit) in rows {
        let quantity = advice.notes.of(role);
        if quantity.largest > 0.0 {
            let [most, least] = [quantity.largest, quantity.smallest()].map(|q| q * unit);
            let _ = writeln!(text, "{name:<16} {most:>10.2e} {least:>10.1e}");
        }
    }
    let _ = writeln!(
        text,
        "\n{:<8} {:>9} {:>8} {:>9} {:>9} {:>9}",
        "type", "range", "unit", "headroom", "error, m", "worst, m"
    );
    for format in &advice.formats {
        text.push_str(&line(advice, format));
    }
    text.push_str(&conclusion(advice));
    text
}

/// `I8F24` and the like.
pub fn name(fraction: u32) -> String {
    format!("I{}F{fraction}", 32 - fraction)
}

fn line(advice: &Advice, format: &Format) -> String {
    let figures = |Expected { median, worst }| match advice.is_sensitive() {
        true => format!("{:>9} {:>9}", "?", "?"),
        false => format!("{median:>9.1e} {worst:>9.1e}"),
    };
    let is_best = advice
        .best
        .is_some_and(|best| best.fraction == format.fraction);
    let verdict = match format.verdict {
        Verdict::Saturates(Role::Constant) => format!("{:>9} {:>9}  refuses a constant", "-", "-"),
        Verdict::Saturates(role) => format!("{:>9} {:>9}  {} saturates", "-", "-", role.name()),
        Verdict::Tight(error) => format!("{}  less headroom than asked", figures(error)),
        Verdict::Fits(error) if advice.is_sensitive() || error.worst <= advice.question.bears => {
            format!(
                "{}{}",
                figures(error),
                if is_best { "  <- take" } else { "" }
            )
        }
        Verdict::Fits(error) => {
            let mark = if is_best { "  <- the finest, but" } else { " " };
            format!(
                "{}{mark} misses {:.1e}",
                figures(error),
                advice.question.bears
            )
        }
    };
    let (name, unit) = (name(format.fraction), (-f64::from(format.fraction)).exp2());
    let (range, headroom) = (range(format.fraction), format.headroom);
    format!("{name:<8} {range:>9.1} {unit:>8.1e} {headroom:>9.1} {verdict}\n")
}

/// The answer in a sentence, and where the table below it is explained.
fn answer(advice: &Advice) -> String {
    let Some(best) = advice.best else {
        return "No type of 32 bits holds this scene.".into();
    };
    let error = match best.verdict {
        Verdict::Fits(_) if advice.is_sensitive() => "its error cannot be told".into(),
        Verdict::Fits(error) => format!(
            "it ends {:.1e} m off, {:.1e} m at worst",
            error.median, error.worst
        ),
        _ => "it has less headroom than asked".into(),
    };
    let first = match advice.first() {
        Some(role) => format!(" The {} saturates first.", role.name()),
        None => String::new(),
    };
    format!("Take {}: {error}.{first}", name(best.fraction))
}

fn conclusion(advice: &Advice) -> String {
    let (first, reach) = advice.notes.widest();
    let Some(best) = advice.best else {
        return format!(
            "\nNo type of 32 bits holds it: {} is {reach:.2e}\n",
            first.name()
        );
    };
    let mut text = "\n".to_string();
    if let Some(role) = advice.first() {
        let reach = advice.notes.reach(role);
        let _ = writeln!(text, "first to saturate  {}, at {reach:.3e}", role.name());
    }
    let plan = &advice.question.plan;
    // Half a unit in a drift; Verlet has two drifts of half a step each.
    let drifts = if plan.method == Scheme::Verlet {
        1.0
    } else {
        0.5
    };
    let still = drifts * plan.rate.to_f64() * (-f64::from(best.fraction)).exp2();
    let _ = writeln!(text, "stands still       below {still:.1e} m/s");
    if advice.is_sensitive() {
        let _ = writeln!(
            text,
            "sensitive          spreads small changes {:.0} times as far as free motion:\n\
             \x20                  the error cannot be told",
            advice.spread
        );
    }
    if let (Some((shift, error)), Verdict::Fits(now)) = (advice.dyadic, best.verdict) {
        text.push_str(&rate(advice, shift, error.median / now.median));
    }
    text
}

/// What a dyadic step changes.
fn rate(advice: &Advice, shift: u32, error: f64) -> String {
    let (plan, hz) = (&advice.question.plan, f64::from(shift).exp2());
    let mut text = format!("dyadic rate        1/{hz} s: ");
    if !advice.is_sensitive() && error.is_finite() {
        let _ = write!(text, "{error:.2} times the error; ");
    }
    let Some((_, step, dyadic)) = PRICES.iter().find(|price| price.0 == plan.method) else {
        return text;
    };
    let per_second = |i: usize| (step[i] * plan.rate.to_f64(), dyadic[i] * hz);
    let ([before, after], [fast, faster]) = (per_second(0).into(), per_second(1).into());
    let _ = writeln!(
        text,
        "instructions a body and second, gravity alone:\n\
         \x20                  M0+ {before:.0} -> {after:.0}, M4F {fast:.0} -> {faster:.0}; \
         take it on a core without long multiply"
    );
    text
}
