//! The body of a scene that is only looked at: it tells positions from velocities from impulses, which
//! its numbers cannot.

use fixstep::{Body, Point, Scalar, TimeStep, Vec2};

use crate::notes::{Role, note};
use crate::recorded::Recorded;

/// A point that moves as any point does and notes what each verb brings and leaves.
#[derive(Clone, Copy, Debug)]
pub struct Noted(Point<Recorded>);

fn both(role: Role, v: Vec2<Recorded>) {
    note(role, v.x.0);
    note(role, v.y.0);
}

impl Noted {
    fn has_moved(&self) {
        both(Role::Position, self.0.position());
    }

    fn is_faster(&self) {
        both(Role::Velocity, self.0.velocity());
    }
}

impl From<Point<Recorded>> for Noted {
    fn from(point: Point<Recorded>) -> Noted {
        let noted = Noted(point);
        noted.has_moved();
        noted.is_faster();
        noted
    }
}

impl Body for Noted {
    type S = Recorded;
    type Spin = fixstep::spin::NoSpin;

    fn position(&self) -> Vec2<Recorded> {
        self.0.position()
    }

    fn velocity(&self) -> Vec2<Recorded> {
        self.0.velocity()
    }

    fn inv_mass(&self) -> <Recorded as Scalar>::InvMass {
        self.0.inv_mass()
    }

    fn kick(&mut self, dv: Vec2<Recorded>) {
        both(Role::Kick, dv);
        self.0.kick(dv);
        self.is_faster();
    }

    fn kick_y(&mut self, dv: Recorded) {
        note(Role::Kick, dv.0);
        self.0.kick_y(dv);
        self.is_faster();
    }

    fn push(&mut self, impulse: Vec2<Recorded>) {
        both(Role::Impulse, impulse);
        let before = self.0.velocity().to_f64();
        self.0.push(impulse);
        let after = self.0.velocity().to_f64();
        note(Role::Kick, after.x - before.x);
        note(Role::Kick, after.y - before.y);
        self.is_faster();
    }

    fn shift(&mut self, dx: Vec2<Recorded>) {
        self.0.shift(dx);
        self.has_moved();
    }

    fn drift(&mut self, step: &impl TimeStep<Recorded>) {
        self.0.drift(step);
        self.has_moved();
    }

    fn drift_half(&mut self, step: &impl TimeStep<Recorded>) {
        self.0.drift_half(step);
        self.has_moved();
    }
}
