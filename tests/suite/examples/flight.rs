//! The flight of a ball in air, by a method of order 4 in f64: the reference of the cannon.

use crate::examples::cannon;

pub const G: f64 = 9.81;

/// How far a flight goes by a method of order 4 in f64, with a tenth of the example's step, so that
/// what it leaves is below a micrometre; and how far the example may end from it.
pub struct Flight {
    pub range: f64,
    pub bound: f64,
}

/// Verlet drifts by the mean of two velocities, which is of order 2, but its kick sees the drag of
/// the old velocity: v' = v + h f(v), with f = g - k|v|v. To first order in h that solves
/// dv/dt = f - h/2 f'f, so an error of the velocity starts at a rate of at most h/2 |f'||f|, where
/// |f'| = 2k|v|. It never grows: f' has no positive eigenvalue. Integrated along the path once it
/// bounds the error of the velocity, twice that of the position, which moves the point of impact
/// by (1 + vx/|vy|) times as much. Order 2 in h is left: the same once more times h k|v| < 1/100.
pub fn flight(degrees: u32, k: f64) -> Flight {
    let h = 1.0 / 60.0;
    let dt = h / 10.0;
    let ahead = |s: [f64; 4], d: [f64; 4], dt| std::array::from_fn(|i| s[i] + dt * d[i]);
    let rate = |[_, _, vx, vy]: [f64; 4]| {
        let drag = k * vx.hypot(vy);
        [vx, vy, -drag * vx, -G - drag * vy]
    };
    let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
    let mut state = [0.0, 0.0, cannon::SPEED * cos, cannon::SPEED * sin];
    let (mut velocity_error, mut position_error) = (0.0, 0.0);
    loop {
        let d1 = rate(state);
        let d2 = rate(ahead(state, d1, dt / 2.0));
        let d3 = rate(ahead(state, d2, dt / 2.0));
        let d4 = rate(ahead(state, d3, dt));
        let mean = std::array::from_fn(|i| (d1[i] + 2.0 * d2[i] + 2.0 * d3[i] + d4[i]) / 6.0);
        let next = ahead(state, mean, dt);
        let ([x, y, vx, vy], [_, _, ax, ay]) = (state, d1);
        velocity_error += dt * h * k * vx.hypot(vy) * ax.hypot(ay);
        position_error += dt * velocity_error;
        if next[1] < 0.0 {
            // The last piece is a parabola to 1e-6 m.
            let fall = (vy + (vy * vy - 2.0 * ay * y).sqrt()) / -ay;
            return Flight {
                range: x + vx * fall + ax * fall * fall / 2.0,
                bound: 1.01 * position_error * (1.0 - vx / vy),
            };
        }
        state = next;
    }
}
