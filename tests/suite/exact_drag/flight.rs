//! Closed forms: a flight against linear drag, and the spring that a force drives.

/// `[1 - exp(-x), (1 - exp(-x))/x, (x - 1 + exp(-x))/x²]` in `f64`, to 4 roundings of each: by a series up
/// to 1, where the differences would cancel.
pub fn decay(x: f64) -> [f64; 3] {
    let loss = -(-x).exp_m1();
    if x > 1.0 {
        let mean = loss / x;
        return [loss, mean, (1.0 - mean) / x];
    }
    let rest = (3..30)
        .rev()
        .fold(1.0, |sum, n| 1.0 - x / f64::from(n) * sum)
        / 2.0;
    [loss, 1.0 - x * rest, rest]
}

/// Position and velocity after `t` under `g`, for a rate `k / m`.
pub fn flight(rate: f64, t: f64, [x, v]: [f64; 2], g: f64) -> [f64; 2] {
    let [loss, mean, mean_loss] = decay(rate * t);
    let x = x + t * (mean * v + t * mean_loss * g);
    [x, v - loss * v + mean * t * g]
}

/// `x'' = -w² x - damping x' + push cos(drive t)`.
#[derive(Clone, Copy)]
pub struct Driven {
    pub w: f64,
    pub damping: f64,
    pub push: f64,
    pub drive: f64,
}

impl Driven {
    /// Position and velocity after `t`: the motion that stays, and one that fades.
    pub fn at(&self, t: f64, [x, v]: [f64; 2]) -> [f64; 2] {
        let (half, stiff) = (0.5 * self.damping, self.w.powi(2) - self.drive.powi(2));
        let size = stiff.powi(2) + (self.damping * self.drive).powi(2);
        let cosine = self.push * stiff / size;
        let sine = self.push * self.damping * self.drive / size;
        let turn = (self.w.powi(2) - half.powi(2)).sqrt();
        let one = x - cosine;
        let two = (v - self.drive * sine + half * one) / turn;
        let fade = (-half * t).exp();
        let (s, c) = (turn * t).sin_cos();
        let (fs, fc) = (self.drive * t).sin_cos();
        let fading = fade * (one * c + two * s);
        let turning = fade * turn * (two * c - one * s);
        [
            fading + cosine * fc + sine * fs,
            turning - half * fading + self.drive * (sine * fc - cosine * fs),
        ]
    }
}
