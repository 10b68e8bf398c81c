//! A scene of bodies that turn: a wheel that a motor drives in its bearing, and a bar on a spring that holds
//! it by one end. Seen from above, without gravity.

use fixstep::rigid::torque::{Attached, SpinDrag, Torque};
use fixstep::{
    Angular, BodyId, Decay, Error, Pairs, Point, Ratio, Rigid, Rotating, Scalar, Spring, Vec2,
    World, dec, vec2,
};

use crate::described::ROOM;

/// What one may want otherwise.
#[derive(Clone, Copy, Debug)]
pub struct Rotor {
    /// Of the motor, N m. It ends at 1.59 turns/s for each.
    pub torque: Ratio,
    /// Of the wheel at the start, turns/s.
    pub spin: Ratio,
}

/// Of the command line: from rest to 8 turns/s.
pub const ROTOR: Rotor = Rotor {
    torque: dec!(5),
    spin: dec!(0),
};
pub const NAME: &str = "rotor";
pub const TITLE: &str = "rotor: a motor drives a wheel in its bearing; beside it a bar on a spring";
pub const SECONDS: f64 = 8.0;

pub type Forces<S> = (Torque<S>, SpinDrag<S>, Pairs<Attached<S>, [[BodyId; 2]; 1]>);

impl Rotor {
    /// Puts the bodies into `world`, each as `body` makes it of one that turns.
    pub fn build<B: Rotating<S: Angular + Decay>>(
        &self,
        world: &mut World<B, ROOM>,
        body: impl Fn(Rigid<Point<B::S>>) -> B,
    ) -> Result<Forces<B::S>, Error> {
        // 0.2 kg m² against 0.1 N m s: a time constant of 2 s.
        let wheel = Point::new(vec2(dec!(-3.75), 0)?, Vec2::ZERO, 3)?;
        let wheel = Rigid::new(wheel, dec!(0.2))?.with_spin(self.spin)?;
        let bar = Point::new(
            vec2(dec!(1.5), dec!(0.5))?,
            vec2(1, dec!(-0.75))?,
            dec!(1.5),
        )?;
        let bar = Rigid::new(bar, dec!(0.125))?.with_spin(dec!(0.25))?;
        let [wheel, bar] = [world.add(body(wheel))?, world.add(body(bar))?];
        let post = world.add(body(Rigid::static_at(vec2(dec!(0.5), 0)?)?))?;
        let spring = Attached {
            spring: Spring::new(1, 20, dec!(0.25))?,
            at: [vec2(dec!(0.5), 0)?, Vec2::ZERO],
        };
        let (field, value) = ("torque", self.torque);
        let torque = B::S::ratio(value).ok_or(Error::OutOfRange { field, value })?;
        let motor = Torque {
            body: wheel,
            torque,
        };
        let held = Pairs::new(spring, [[bar, post]]);
        Ok((motor, SpinDrag::new(dec!(0.1))?, held))
    }
}
