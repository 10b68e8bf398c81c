//! The charts' scene of bodies that turn: four motors, each against the drag of its own bearing. With the
//! exact factor, and with drag as a user may write it; the firmware prices the same file.
//!
//! ```text
//! I ω' = M - c ω      θ = s∞ t + (s0 - s∞) τ (1 - e^-t/τ)      s∞ = M / 2πc, τ = I/c
//! ```

use fixstep::rigid::Centre;
use fixstep::rigid::torque::{SpinDrag, Torque, Wrench};
use fixstep::{
    Angle, Body, Decay, Error, Factor, Force, PerBody, Point, Ratio, Rigid, Rk4, Scalar,
    SemiImplicitEuler, Time, Vec2, Verlet, dec, vec2,
};

use super::scenes::{Room, Visitor};

/// Moment of inertia, kg m², and drag of a bearing, N m s: a time constant of 2 s.
pub const INERTIA: Ratio = dec!(0.08);
pub const BEARING: Ratio = dec!(0.04);
/// The same drag for a turn, `2πc`.
const BEARING_A_TURN: Ratio = dec!(0.251_327_412_287_183);
/// What each motor gives, N m: whole units of every number type. They end at 2, 1, -1.5 and 2.5 turns/s.
pub const TORQUES: [Ratio; 4] = [dec!(0.5), dec!(0.25), dec!(-0.375), dec!(0.625)];

/// Four motors.
pub struct Rotor;

type Motors<S> = [Torque<S>; 4];
/// With what resists them.
type Against<F, C> = Result<(Motors<<C as Body>::S>, F), Error>;

impl Rotor {
    pub const NAME: &'static str = "rotor";
    pub const BODIES: usize = 4;

    /// A body at rest that turns: turns, turns/s.
    pub fn body<C>(angle: impl Into<Ratio>, spin: impl Into<Ratio>) -> Result<Rigid<C>, Error>
    where
        C: Centre + From<Point<C::S>>,
    {
        let centre = Point::new(vec2(0, 0)?, vec2(0, 0)?, 1)?;
        let body = Rigid::new(centre.into(), INERTIA)?.with_spin(spin)?;
        Ok(body.with_angle(Angle::turns(angle)))
    }

    /// All runs with one kind of body.
    pub fn show<C, V>(visitor: &mut V) -> Result<(), Error>
    where
        C: Centre<S: Decay> + From<Point<C::S>>,
        V: Visitor<Rigid<C>>,
    {
        let (semi, exact) = (|| SemiImplicitEuler, exact::<C>);
        visitor.run("SemiImplicitEuler", "SpinDrag", semi, exact)?;
        visitor.run("Verlet", "SpinDrag", || Verlet, exact)?;
        visitor.run("SemiImplicitEuler", "Wrench", semi, by_hand::<C>)?;
        visitor.run("Verlet", "Wrench", || Verlet, by_hand::<C>)?;
        visitor.run("Rk4", "Wrench", Rk4::new, by_hand::<C>)
    }
}

/// A motor for each body.
fn motors<B: Body>(world: &Room<B>) -> Result<Motors<B::S>, Error> {
    let &[a, b, c, d] = world.ids() else {
        return Err(Error::Empty { field: "bodies" });
    };
    let [m, n, o, p] = TORQUES;
    let motor = |body, value| -> Result<_, Error> {
        let field = "torque";
        let torque = B::S::ratio(value).ok_or(Error::OutOfRange { field, value })?;
        Ok(Torque { body, torque })
    };
    Ok([motor(a, m)?, motor(b, n)?, motor(c, o)?, motor(d, p)?])
}

fn exact<C>(world: &Room<Rigid<C>>) -> Against<SpinDrag<C::S>, C>
where
    C: Centre<S: Decay>,
{
    Ok((motors(world)?, SpinDrag::new(BEARING)?))
}

/// Drag as a function of the body: a torque of `-2πc s`.
fn by_hand<C: Centre>(world: &Room<Rigid<C>>) -> Against<impl Force<Rigid<C>> + use<C>, C> {
    let (field, value) = ("drag", BEARING_A_TURN);
    let drag = <C::S as Scalar>::Coef::new(value).ok_or(Error::OutOfRange { field, value })?;
    let torque = PerBody(move |_: Time, body: &Rigid<C>| Wrench {
        force: Vec2::ZERO,
        torque: drag.scale(body.spin()).negated(),
    });
    Ok((motors(world)?, torque))
}
