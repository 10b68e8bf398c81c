//! The body of a scene that is only looked at: it tells positions from velocities from impulses, which
//! its numbers cannot.

use fixstep::{Angle, Body, Point, Rigid, Rotating, Scalar, TimeStep, Vec2};

use crate::flight::Seen;
use crate::notes::{Role, note};
use crate::recorded::{Rate, Recorded};

/// A body that moves and turns as any does and notes what each verb brings and leaves. One that was a point
/// does not turn.
#[derive(Clone, Copy, Debug)]
pub struct Noted(Rigid<Point<Recorded>>);

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

    /// Whether a torque can turn it.
    pub fn can_turn(&self) -> bool {
        self.0.inv_inertia().0 != 0.0
    }

    /// Notes what `change` does to its spin.
    fn spun(&mut self, change: impl FnOnce(&mut Rigid<Point<Recorded>>)) {
        let before = self.0.spin().0;
        change(&mut self.0);
        let (after, per_spin) = (self.0.spin().0, self.0.inv_inertia().0);
        note(Role::Twist, after - before);
        note(Role::Spin, after);
        if per_spin != 0.0 {
            note(Role::Moment, (after - before) / per_spin);
        }
    }
}

impl From<Point<Recorded>> for Noted {
    fn from(point: Point<Recorded>) -> Noted {
        Rigid::locked(point).into()
    }
}

impl From<Rigid<Point<Recorded>>> for Noted {
    fn from(body: Rigid<Point<Recorded>>) -> Noted {
        let noted = Noted(body);
        noted.has_moved();
        noted.is_faster();
        note(Role::Spin, body.spin().0);
        noted
    }
}

impl Seen for Noted {
    fn turns(&self) -> f64 {
        self.0.angle().to_f64()
    }
}

impl Body for Noted {
    type S = Recorded;
    type Spin = Recorded;

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

    fn spin(&self) -> Recorded {
        self.0.spin()
    }

    fn twist(&mut self, change: Recorded) {
        self.spun(|body| body.twist(change));
    }

    fn drift_angle(&mut self, step: &impl TimeStep<Recorded>) {
        self.0.drift_angle(step);
    }

    fn drift_angle_half(&mut self, step: &impl TimeStep<Recorded>) {
        self.0.drift_angle_half(step);
    }

    fn drift_angle_by(&mut self, factor: Rate) {
        self.0.drift_angle_by(factor);
    }

    fn rotate_by(&mut self, spin: Recorded, factor: Rate) {
        self.0.rotate_by(spin, factor);
    }

    fn has_infinite_mass(&self) -> bool {
        self.0.has_infinite_mass()
    }
}

impl Rotating for Noted {
    fn angle(&self) -> Angle<Recorded> {
        self.0.angle()
    }

    fn turns_per_second(&self) -> Recorded {
        self.0.spin()
    }

    fn inv_inertia(&self) -> Rate {
        self.0.inv_inertia()
    }

    fn twist_by(&mut self, value: Recorded, factor: Rate) {
        note(Role::Torque, value.0);
        self.spun(|body| body.twist_by(value, factor));
    }

    fn spin_up(&mut self, change: Recorded) {
        self.twist(change);
    }

    fn damp_spin(&mut self, loss: Rate) {
        self.spun(|body| body.damp_spin(loss));
    }

    fn push_off(&mut self, arm: Vec2<Recorded>, impulse: Vec2<Recorded>) {
        both(Role::Impulse, impulse);
        let before = self.0.velocity().to_f64();
        self.spun(|body| body.push_off(arm, impulse));
        let after = self.0.velocity().to_f64();
        note(Role::Kick, after.x - before.x);
        note(Role::Kick, after.y - before.y);
        self.is_faster();
    }
}
