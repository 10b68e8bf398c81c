//! An outline in whole numbers: its vertices, and the sums for the area and inertia of a polygon.
//!
//! **Width.** The origin is the middle of the box around the outline, so no digits are lost far away.
//! An outline that is moved, mirrored, rotated by 90° or started at another vertex gives the same bits.
//! Coordinates are whole units of the coarsest power of two that holds them all. If they need more than
//! [`BITS`] they are rounded, as may happen in floats and in 64-bit fixed point. A corner is then off by
//! `2^-41` of the box. The relative error of a square's area is `2^-39`. It is n times as large if the
//! outline is n times as long as wide: below 1e-9 for all n up to 250. In the last sum the bracket is
//! rounded to what 127 bits can hold, by at most as much. Up to 30 bits it is not rounded.

use super::Shape;
use crate::error::Error;
use crate::ratio::Ratio;
use crate::scalar::Rational;
use crate::vec2::Vec2;

/// A coordinate is at most 2 to this power, so that `|sum(C (r1 + r2))| <= 6 (2^41)² 2^40 < 2^125`.
const BITS: u32 = 40;

const FLAT: Error = Error::Degenerate { shape: "polygon" };
const BEYOND: Error = Error::NotFinite { field: "vertices" };

/// The vertices, and how they become whole numbers.
pub(super) struct Outline<'a, S> {
    vertices: &'a [Vec2<S>],
    /// Vertices are first read in units of 2 to this power.
    fine: i32,
    /// Twice the middle of the box, in those units.
    middle: [i128; 2],
    /// Half such a unit times 2 to this power is the unit of coordinates from the middle.
    shift: u32,
    /// Bits that coordinates need.
    bits: u32,
}

impl<'a, S: Rational> Outline<'a, S> {
    pub(super) fn new(vertices: &'a [Vec2<S>]) -> Result<Outline<'a, S>, Error> {
        if vertices.is_empty() {
            return Err(Error::Empty { field: "vertices" });
        }
        let mut outline = Outline {
            vertices,
            fine: highest_bit(vertices)? - 120,
            middle: [0; 2],
            shift: 0,
            bits: 0,
        };
        let (mut low, mut high) = ([i128::MAX; 2], [i128::MIN; 2]);
        for vertex in vertices {
            for ((low, high), at) in low.iter_mut().zip(&mut high).zip(outline.read(vertex)) {
                (*low, *high) = (at.min(*low), at.max(*high));
            }
        }
        outline.middle = [low[0] + high[0], low[1] + high[1]];
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        let used = outline.corners().fold(0, |used, [x, y]| used | x | y);
        let wide = 128 - size.leading_zeros();
        outline.shift = used.trailing_zeros().max(wide.saturating_sub(BITS));
        outline.bits = wide.saturating_sub(outline.shift);
        if wide as i32 + outline.fine > 32 {
            return Err(BEYOND);
        }
        Ok(outline)
    }

    /// A vertex in fine units, below `2^120`.
    #[inline(never)]
    fn read(&self, vertex: &Vec2<S>) -> [i128; 2] {
        vertex.array().map(|value| {
            let (mantissa, exponent) = value.binary().unwrap_or_default();
            let mantissa = i128::from(mantissa);
            match exponent - self.fine {
                up @ 0..=127 => mantissa << up,
                down @ -127..0 => rounded(mantissa, down.unsigned_abs()),
                _ => 0,
            }
        })
    }

    /// The vertices relative to the middle of the box: at most `2^40` once `shift` is set.
    fn corners(&self) -> impl DoubleEndedIterator<Item = [i128; 2]> {
        self.vertices.iter().map(|vertex| {
            let [x, y] = self.read(vertex);
            [2 * x - self.middle[0], 2 * y - self.middle[1]].map(|at| rounded(at, self.shift))
        })
    }

    /// C is below `2^82` and the bracket below `6 * 2^80`, so the bracket is rounded to fit the product.
    /// Sums of an outline that crosses itself may wrap. All others are integrals over the box, below `2^127`.
    pub(super) fn sums(&self) -> Sums {
        let mut sums = Sums {
            dropped: (4 * self.bits).saturating_sub(121),
            ..Sums::default()
        };
        let mut from = self.corners().next_back().unwrap_or_default();
        for to in self.corners() {
            let cross = product(from[0], to[1]) - product(from[1], to[0]);
            sums.area = sums.area.wrapping_add(cross);
            let mut bracket = 0;
            for ((a, b), moment) in from.into_iter().zip(to).zip(&mut sums.moment) {
                *moment = moment.wrapping_add(product(cross, a + b));
                bracket += product(a, a + b) + product(b, b);
            }
            let part = product(cross, rounded(bracket, sums.dropped));
            sums.inertia = sums.inertia.wrapping_add(part);
            from = to;
        }
        sums
    }

    pub(super) fn measured(&self, sums: Sums) -> Result<Shape<S>, Error> {
        if sums.area == 0 {
            return Err(FLAT);
        }
        let shape = self.shape(sums.turned_left());
        match shape.ok_or(BEYOND)? {
            shape if shape.area.num() > 0 && shape.inertia_per_mass.num() > 0 => Ok(shape),
            _ => Err(FLAT),
        }
    }

    /// `None` if 62 bits cannot hold it; the area of `sums` is positive.
    fn shape(&self, sums: Sums) -> Option<Shape<S>> {
        let (half, unit) = (self.fine - 1, self.fine - 1 + self.shift as i32);
        let area = sums.area.unsigned_abs();
        let signed = |value: i128, den, exponent| {
            let size = Ratio::scaled(value.unsigned_abs(), den, exponent)?;
            size.signed(value < 0, false)
        };
        let (mut centre, mut steps) = ([S::ZERO; 2], Ratio::ZERO);
        for ((place, moment), middle) in centre.iter_mut().zip(sums.moment).zip(self.middle) {
            let offset = signed(moment, 3 * area, unit)?;
            *place = S::ratio(signed(middle, 1, half)?.and(offset)?)?;
            steps = steps.and(offset.square()?)?;
        }
        let about_middle = signed(sums.inertia, 6 * area, 2 * unit + sums.dropped as i32)?;
        Some(Shape {
            area: Ratio::scaled(area, 2, 2 * unit)?,
            centre: Vec2::new(centre[0], centre[1]),
            inertia_per_mass: about_middle.less(steps)?,
        })
    }

    /// The first corner that is straight or bends the wrong way, or that begins a second revolution.
    /// Each revolution has one run of edges that go up, or level to the right.
    pub(super) fn first_bad_corner(&self, left: bool) -> Option<usize> {
        let minus = |a: [i128; 2], b: [i128; 2]| [a[0] - b[0], a[1] - b[1]];
        let goes_up = |edge: [i128; 2]| edge[1] > 0 || edge[1] == 0 && edge[0] > 0;
        let (first, last) = (self.corners().next()?, self.corners().next_back()?);
        let (mut at, mut edge, mut turns) = (first, minus(first, last), 0);
        for (corner, to) in self.corners().skip(1).chain([first]).enumerate() {
            let next = minus(to, at);
            let cross = product(edge[0], next[1]) - product(edge[1], next[0]);
            turns += u32::from(goes_up(next) && !goes_up(edge));
            if cross == 0 || (cross > 0) != left || turns > 1 {
                return Some(corner);
            }
            (at, edge) = (to, next);
        }
        None
    }
}

/// Twice the area and its moments; the last one divided by 2 to the power of `dropped`.
#[derive(Default)]
pub(super) struct Sums {
    pub(super) area: i128,
    moment: [i128; 2],
    inertia: i128,
    dropped: u32,
}

impl Sums {
    /// The sums for the direction that gives a positive area.
    fn turned_left(self) -> Sums {
        if self.area >= 0 {
            return self;
        }
        Sums {
            area: -self.area,
            moment: self.moment.map(i128::wrapping_neg),
            inertia: self.inertia.wrapping_neg(),
            ..self
        }
    }
}

/// The least e with all coordinates below `2^e`; zero if all are zero.
fn highest_bit<S: Rational>(vertices: &[Vec2<S>]) -> Result<i32, Error> {
    let mut highest = None;
    for value in vertices.iter().flat_map(|vertex| vertex.array()) {
        let (mantissa, exponent) = value.binary().ok_or(BEYOND)?;
        let bits = 64 - mantissa.unsigned_abs().leading_zeros() as i32;
        if bits > 0 {
            highest = highest.max(Some(bits + exponent));
        }
    }
    Ok(highest.unwrap_or(0))
}

/// `value / 2^shift`, nearest, ties away from zero.
#[inline(never)]
fn rounded(value: i128, shift: u32) -> i128 {
    let Some(below) = shift.checked_sub(1) else {
        return value;
    };
    let size = ((value.unsigned_abs() >> below) + 1) >> 1;
    if value < 0 {
        -(size as i128)
    } else {
        size as i128
    }
}

/// Not inlined: on a core without a long multiply each copy takes hundreds of bytes.
#[inline(never)]
fn product(a: i128, b: i128) -> i128 {
    a * b
}
