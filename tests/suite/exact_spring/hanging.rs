//! A spring under gravity: one case, what its body does, and what rounding allows.

use std::fmt::Debug;

use fixstep::{Body, ExactSpring, Gravity, GravityY, Point, Ratio, TimeStep, Vec2};

use crate::exact_spring::flow::{Double, Matrix, flow, step_of};
use crate::exact_spring::rounding::{coefficient, is_fixed};
use crate::exact_spring::splitting::Splitting;
use crate::support::*;

pub const POINT: [f64; 2] = [0.75, 1.5];

/// One spring and one step: what it should do.
pub struct Case<S> {
    pub hertz: Ratio,
    pub zeta: Ratio,
    pub pull: Vec2<S>,
    pub omega: f64,
    pub seconds: f64,
    pub whole: Matrix,
    pub half: Matrix,
    pub rest: [f64; 2],
}

/// Frequency `i`, 0.3 to 27 Hz, under gravity along y, of even ones along x as well.
pub fn case<S: Format>(i: usize, zeta: Ratio, seconds: Ratio) -> Case<S> {
    let hertz = ratio(0.3 * 90.0_f64.powf(spread(i)));
    let pull = vector::<S>([1.3, 0.0][i % 2], -9.81);
    let (omega, whole) = step_of(hertz, zeta, seconds);
    let q = omega * Double::ratio(seconds) * Double::of(0.5);
    let g = pull.to_f64().array();
    let sag = |k: usize| (Double::of(g[k]) / (omega * omega)).to_f64();
    Case {
        hertz,
        zeta,
        pull,
        omega: omega.to_f64(),
        seconds: seconds.to_f64(),
        whole,
        half: flow(q, Double::ratio(zeta)),
        rest: [POINT[0] + sag(0), POINT[1] + sag(1)],
    }
}

impl<S: Format> Case<S> {
    /// Steps until a swing of 4 m is below a unit of any scalar: e^-45 at the slower rate.
    pub fn patience(&self) -> u32 {
        let zeta = self.zeta.to_f64();
        let faster = (zeta * zeta - 1.0).max(0.0).sqrt();
        (45.0 / ((zeta - faster) * self.omega * self.seconds)).ceil() as u32
    }

    /// Where the body is in the 256 steps after it has settled, and whether it stands still.
    pub fn hung<B>(&self, mut scheme: Splitting, step: &impl TimeStep<S>) -> ([f64; 2], bool)
    where
        B: Body<S = S> + From<Point<S>> + Debug + PartialEq,
    {
        let mut world = world([B::from(point(POINT, [0.0; 2], 1.37))]);
        let at = vector(POINT[0], POINT[1]);
        let spring = ExactSpring::new(world.ids()[0], at, self.hertz, self.zeta).unwrap();
        let g = self.pull.to_f64();
        let gravity_y = (g.x == 0.0).then(|| GravityY::new(ratio(g.y)).unwrap());
        let gravity = (g.x != 0.0).then(|| Gravity::new(self.pull));
        let mut forces = (gravity_y, spring.with_gravity(self.pull).unwrap(), gravity);
        for _ in 0..self.patience() {
            world.step(&mut scheme, &mut forces, step);
        }
        let (settled, mut off, mut still) = (world.bodies()[0], [0.0; 2], true);
        for _ in 0..256 {
            world.step(&mut scheme, &mut forces, step);
            let body = world.bodies()[0];
            let at = body.position().to_f64().array();
            off = std::array::from_fn(|k| maximum(&[off[k], (at[k] - self.rest[k]).abs()]));
            still &= body == settled;
        }
        (off, still)
    }

    /// What a body without remainders may be off by along axis `k`.
    ///
    /// In a step of one flow r is two half units in x and in v. Floats round the sums, at the size of
    /// where the body hangs and, in v, of the kick that comes and goes. Of two flows the first
    /// comes through the second. The point of rest itself is a product and a sum.
    pub fn allowed(&self, scheme: Splitting, k: usize) -> f64 {
        let rest = self.rest[k].abs().max(POINT[k]);
        let kick = self.pull.to_f64().array()[k].abs() * self.seconds;
        let x = S::unit(rest);
        let v = if is_fixed::<S>() {
            x
        } else {
            2.0 * S::unit(kick)
        };
        let once = [x, v / self.omega];
        let mut r = once;
        if scheme == Splitting::Verlet {
            let half = absolute(&self.half);
            r = std::array::from_fn(|i| once[i] + half[i][0] * once[0] + half[i][1] * once[1]);
        }
        let [x_of, v_of] = if self.zeta.to_f64() < 0.5 {
            self.kept_alive()
        } else {
            absolute(&self.whole.less(&Matrix::identity()).inverse())[0]
        };
        x_of * r[0] + v_of * r[1] + x + coefficient::<S>() * rest
    }

    /// The first row of `sum(|P^k|)`.
    fn kept_alive(&self) -> [f64; 2] {
        let (mut power, mut sum) = (Matrix::identity(), [0.0; 2]);
        for _ in 0..self.patience() {
            let row = absolute(&power)[0];
            sum = [sum[0] + row[0], sum[1] + row[1]];
            power = power.times(&self.whole);
        }
        sum
    }
}

fn absolute(matrix: &Matrix) -> [[f64; 2]; 2] {
    matrix.to_f64().map(|row| row.map(f64::abs))
}
