//! What a run writes down: for each quantity the largest magnitude, and how often each power of two.
//!
//! The smallest magnitude that matters is the power of two below which one note in sixteen lies. A motion
//! to and fro passes through zero, so its least value says nothing; a sine is below a tenth of its height
//! one time in sixteen. Zeros are not counted.

use std::cell::RefCell;

/// What a number is in the step that makes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// A part of a position, m.
    Position,
    /// A part of a velocity, m/s.
    Velocity,
    /// What a spring hands to its two bodies, kg m/s.
    Impulse,
    /// A change of velocity by one force in one step, m/s.
    Kick,
    /// A spin, turns/s.
    Spin,
    /// What a force hands to a body that turns as a number: a torque, N m, or an angular impulse.
    Torque,
    /// A change of spin by one force in one step, turns/s.
    Twist,
    /// What one force in one step does to a spin, kg m²/s: no number of the type, but what others make.
    Moment,
    /// A length or a speed made of two parts.
    Length,
    /// What is left of one number less another.
    Difference,
    /// A sum that is no state.
    Sum,
    /// A product or a quotient.
    Product,
    /// A constant of the scene: it does not saturate, it is refused.
    Constant,
    /// A squared length: twice as wide as the type.
    Square,
    /// A coefficient: it has a binary point of its own.
    Coefficient,
}

impl Role {
    /// All, in the order in which they are blamed when several are as large.
    pub const ALL: [Role; 15] = [
        Role::Position,
        Role::Velocity,
        Role::Impulse,
        Role::Kick,
        Role::Spin,
        Role::Torque,
        Role::Twist,
        Role::Moment,
        Role::Length,
        Role::Difference,
        Role::Sum,
        Role::Product,
        Role::Constant,
        Role::Square,
        Role::Coefficient,
    ];

    /// What it is called when it is to blame.
    pub fn name(self) -> &'static str {
        match self {
            Role::Position => "position",
            Role::Velocity => "velocity",
            Role::Impulse => "impulse",
            Role::Kick => "kick",
            Role::Spin => "spin",
            Role::Torque => "torque",
            Role::Twist => "change of spin",
            Role::Moment => "angular impulse",
            Role::Length => "length",
            Role::Difference => "difference",
            Role::Sum => "sum",
            Role::Product => "product",
            Role::Constant => "constant",
            Role::Square => "squared length",
            Role::Coefficient => "coefficient",
        }
    }
}

/// Powers of two from `2^-64`.
const BINS: usize = 128;
const LEAST: i32 = -64;

/// The notes of one quantity.
#[derive(Clone, Copy, Debug)]
pub struct Quantity {
    /// The largest magnitude; infinite where one was no number.
    pub largest: f64,
    counts: [u32; BINS],
}

impl Quantity {
    const NONE: Quantity = Quantity {
        largest: 0.0,
        counts: [0; BINS],
    };

    fn note(&mut self, value: f64) {
        let magnitude = value.abs();
        if magnitude == 0.0 {
            return;
        }
        if magnitude > self.largest {
            self.largest = magnitude;
        }
        if !magnitude.is_finite() {
            self.largest = f64::INFINITY;
            return;
        }
        let exponent = (magnitude.to_bits() >> 52) as i32 - 1023;
        let bin = (exponent - LEAST).clamp(0, BINS as i32 - 1) as usize;
        self.counts[bin] = self.counts[bin].saturating_add(1);
    }

    /// The smallest magnitude that matters; zero where there was none.
    pub fn smallest(&self) -> f64 {
        let all: u64 = self.counts.iter().map(|&count| u64::from(count)).sum();
        let mut below = 0;
        for (exponent, &count) in (LEAST..).zip(&self.counts) {
            below += u64::from(count);
            if 16 * below > all {
                return f64::from(exponent).exp2();
            }
        }
        0.0
    }
}

/// The notes of a run.
#[derive(Clone, Debug)]
pub struct Notes([Quantity; Role::ALL.len()]);

impl Notes {
    const NONE: Notes = Notes([Quantity::NONE; Role::ALL.len()]);

    /// The notes of one quantity.
    pub fn of(&self, role: Role) -> &Quantity {
        &self.0[role as usize]
    }

    /// How far the type must reach for this quantity; zero for what it need not hold. A sum of
    /// products ends at `2^62` square units, the square of the type's own end.
    pub fn reach(&self, role: Role) -> f64 {
        match role {
            Role::Coefficient | Role::Moment => 0.0,
            Role::Square => self.of(role).largest.sqrt(),
            _ => self.of(role).largest,
        }
    }

    /// The quantity that needs the widest range, and how wide.
    pub fn widest(&self) -> (Role, f64) {
        self.widest_of(&Role::ALL)
    }

    /// The same of what can never be held back: state, which stays at the end of the range, and
    /// constants. Whatever else saturates may do no harm, as the closing speed of an undamped spring.
    pub fn widest_held(&self) -> (Role, f64) {
        self.widest_of(&[Role::Position, Role::Velocity, Role::Spin, Role::Constant])
    }

    fn widest_of(&self, roles: &[Role]) -> (Role, f64) {
        let mut widest = (Role::Position, 0.0);
        for &role in roles {
            let reach = self.reach(role);
            if reach > widest.1 {
                widest = (role, reach);
            }
        }
        widest
    }
}

thread_local! {
    static NOTES: RefCell<Notes> = const { RefCell::new(Notes::NONE) };
}

/// Writes one value down.
pub fn note(role: Role, value: f64) {
    NOTES.with_borrow_mut(|notes| notes.0[role as usize].note(value));
}

/// The notes of `run`, on a page of its own.
pub fn of<R>(run: impl FnOnce() -> R) -> (R, Notes) {
    let before = NOTES.replace(Notes::NONE);
    let result = run();
    (result, NOTES.replace(before))
}
