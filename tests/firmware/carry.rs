//! Prototypes of bodies that keep what a drift rounds away, to see what they cost beside a compact
//! point. They take part in any scene through [`Body`]; `h` is fixed at 1/60 s.

use fixstep::fixed::types::I16F16;
use fixstep::scalar::Factor;
use fixstep::{Body, Point, Scalar, TimeStep, Vec2};

/// Fixed point: positions with 32 more bits, so that `h v` is added without rounding. 32 bytes.
#[derive(Clone, Copy)]
pub struct Carried {
    position: [i64; 2],
    velocity: Vec2<I16F16>,
    inv_mass: <I16F16 as Scalar>::InvMass,
}

/// `2^32 / 60`, rounded.
const H: i32 = 71_582_788;

impl From<Point<I16F16>> for Carried {
    fn from(point: Point<I16F16>) -> Carried {
        Carried {
            position: point.position().array().map(|x| (x.to_bits() as i64) << 32),
            velocity: point.velocity(),
            inv_mass: point.inv_mass(),
        }
    }
}

impl Carried {
    fn advance(&mut self, h: i64) {
        let [x, y] = &mut self.position;
        *x = x.saturating_add(self.velocity.x.to_bits() as i64 * h);
        *y = y.saturating_add(self.velocity.y.to_bits() as i64 * h);
    }
}

impl Body for Carried {
    type S = I16F16;

    fn position(&self) -> Vec2<I16F16> {
        let [x, y] = self.position.map(|x| I16F16::from_bits((x >> 32) as i32));
        Vec2::new(x, y)
    }

    fn velocity(&self) -> Vec2<I16F16> {
        self.velocity
    }

    fn inv_mass(&self) -> <I16F16 as Scalar>::InvMass {
        self.inv_mass
    }

    fn kick(&mut self, dv: Vec2<I16F16>) {
        self.velocity += dv;
    }

    fn kick_y(&mut self, dv: I16F16) {
        self.velocity.y = self.velocity.y.plus(dv);
    }

    fn push(&mut self, impulse: Vec2<I16F16>) {
        self.velocity += impulse.map(|j| self.inv_mass.of(j));
    }

    fn write_state(&self, write: &mut impl FnMut(u64)) {
        self.position.iter().for_each(|x| write(*x as u64));
        self.velocity.array().iter().for_each(|v| write(v.bits()));
    }

    fn shift(&mut self, dx: Vec2<I16F16>) {
        for (x, d) in self.position.iter_mut().zip(dx.array()) {
            *x = x.saturating_add((d.to_bits() as i64) << 32);
        }
    }

    fn drift(&mut self, _: &impl TimeStep<I16F16>) {
        self.advance(H as i64);
    }

    fn drift_half(&mut self, _: &impl TimeStep<I16F16>) {
        self.advance(H as i64 / 2);
    }
}

/// `f32` with the compensation of Kahan's sum for the position. 28 bytes.
#[derive(Clone, Copy)]
pub struct Compensated {
    position: [f32; 2],
    lost: [f32; 2],
    velocity: Vec2<f32>,
    inv_mass: f32,
}

impl From<Point<f32>> for Compensated {
    fn from(point: Point<f32>) -> Compensated {
        Compensated {
            position: point.position().array(),
            lost: [0.0; 2],
            velocity: point.velocity(),
            inv_mass: point.inv_mass(),
        }
    }
}

impl Compensated {
    fn advance(&mut self, moved: [f32; 2]) {
        for ((x, lost), moved) in self.position.iter_mut().zip(&mut self.lost).zip(moved) {
            let wanted = moved - *lost;
            let sum = *x + wanted;
            *lost = (sum - *x) - wanted;
            *x = sum;
        }
    }
}

impl Body for Compensated {
    type S = f32;

    fn position(&self) -> Vec2<f32> {
        Vec2::new(self.position[0], self.position[1])
    }

    fn velocity(&self) -> Vec2<f32> {
        self.velocity
    }

    fn inv_mass(&self) -> f32 {
        self.inv_mass
    }

    fn kick(&mut self, dv: Vec2<f32>) {
        self.velocity += dv;
    }

    fn kick_y(&mut self, dv: f32) {
        self.velocity.y += dv;
    }

    fn push(&mut self, impulse: Vec2<f32>) {
        self.velocity += impulse.map(|j| self.inv_mass * j);
    }

    fn write_state(&self, write: &mut impl FnMut(u64)) {
        for part in [self.position, self.lost, self.velocity.array()] {
            part.iter().for_each(|x| write(x.bits()));
        }
    }

    fn shift(&mut self, dx: Vec2<f32>) {
        self.advance(dx.array());
    }

    fn drift(&mut self, step: &impl TimeStep<f32>) {
        self.advance(self.velocity.array().map(|v| step.of(v)));
    }

    fn drift_half(&mut self, step: &impl TimeStep<f32>) {
        self.advance(self.velocity.array().map(|v| step.half_of(v)));
    }
}
