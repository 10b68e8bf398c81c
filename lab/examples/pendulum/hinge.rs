//! A hinge of the scene's own: a pin through one body.
//!
//! ```text
//! u  = v + ω×r                  how fast forces tear the body off the pin; r from its centre to the pin
//! ω' = ω - μ r×u / I            μ = I m / (I + m r²)
//! θ' = θ + h ω'
//! x' = pin - R(θ') r0           v' = -ω'×R(θ') r0
//! ```
//!
//! The pin pushes until it is at rest, and only what it pushes across r turns the body: there the body answers
//! like a mass of μ. It is the law of angular momentum about the pin, whose own push has no arm there.
//!
//! A hinge is a flow: it moves its body in place of the drift. As the angle alone is integrated and the centre
//! is put where the pin has it, nothing drifts off that had to be pulled back. In exact numbers it is
//! the method itself on `θ'' = -m g |r| / (I + m r²) sin θ`.

use fixstep::force::{Force, Frame, Part};
use fixstep::time::Now;
use fixstep::{BodyId, Error, Ratio, Rotating, Scalar, TimeStep, Vec2};

type Coef<S> = <S as Scalar>::Coef;

/// Holds a point of one body on a pin, about which it turns freely.
#[derive(Clone, Copy, Debug)]
pub struct Hinge<S: Scalar> {
    body: BodyId,
    /// Where the pin is, m.
    pin: Vec2<S>,
    /// Where the body has its hole, in its own axes, m.
    hole: Vec2<S>,
    /// μ, kg.
    mass: Coef<S>,
}

impl<S: Scalar> Hinge<S> {
    /// `mass` is `I m / (I + m r²)`, kg: what the body weighs to one who pushes at the hole, across the arm.
    pub fn new(
        body: BodyId,
        pin: Vec2<S>,
        hole: Vec2<S>,
        mass: impl Into<Ratio>,
    ) -> Result<Hinge<S>, Error> {
        let (field, value) = ("mass", mass.into());
        let mass = fixstep::force::coefficient::<S>(field, value)?;
        Ok(Hinge {
            body,
            pin,
            hole,
            mass,
        })
    }

    /// Takes from the body what tears it off the pin. The moment of u is rounded, not `μ u`: u is nearly `g h`
    /// in every step, and rounded alike in each would make another gravity, here by 4e-5 of it in an `I16F16`.
    fn stop<B: Rotating<S = S>>(&self, body: &mut B) {
        let arm = body.rotation().rotate(self.hole);
        let slip = body.velocity_off(arm);
        let per_inertia = S::product(self.mass, body.inv_inertia());
        body.twist_by(S::narrow(arm.cross(-slip)), per_inertia);
    }

    /// Puts the hole on the pin, at rest. All sums are exact in fixed point: u is zero to the bit.
    pub fn hold<B: Rotating<S = S>>(&self, body: &mut B) {
        body.shift(self.pin - body.to_world(self.hole));
        let arm = body.rotation().rotate(self.hole);
        body.kick(-body.velocity_off(arm));
    }
}

impl<B: Rotating> Force<B> for Hinge<B::S> {
    const COUPLES: bool = false;
    const FLOWS: bool = true;

    fn flow<H: TimeStep<B::S>>(
        &mut self,
        now: &Now<H>,
        part: Part,
        frame: &mut Frame<B>,
        moved: &mut [bool],
    ) {
        let Some((index, _)) = frame.find(self.body) else {
            return;
        };
        let (Some(moved), Some(body)) = (moved.get_mut(index), frame.live_at(index)) else {
            return;
        };
        if !std::mem::replace(moved, true) {
            self.stop(body);
            match part {
                Part::Whole => body.drift_angle(&now.step),
                Part::FirstHalf | Part::SecondHalf => body.drift_angle_half(&now.step),
            }
            self.hold(body);
        }
    }
}
