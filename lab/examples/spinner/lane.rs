//! The five bodies: what each is, how it starts, and how it is pushed.

use std::f64::consts::TAU;

use fixstep::mass::{polygon, rectangle};
use fixstep::rigid::Centre;
use fixstep::{Angle, Error, Point, Ratio, Rigid, Rotating, Vec2, dec, vec2};

/// Steps a second.
pub const RATE: u32 = 120;
/// How many are made: 7.5 s.
pub const TICKS: u32 = 900;
/// Of box and gear, kg.
pub const MASS: Ratio = dec!(2);
/// Of the box, m.
pub const SIDES: [Ratio; 2] = [dec!(0.8), dec!(0.5)];
/// The push, along x, kg m/s.
pub const PUSH: Ratio = dec!(3);
/// The line in which it acts, m above the centre.
pub const BELOW: Ratio = dec!(-0.12);
/// Of the air on the spin, N m s.
pub const SPIN_DRAG: Ratio = dec!(0.05);
/// Velocity of the driven box along x, m/s: that of the pushed ones.
pub const DRIVEN_SPEED: Ratio = dec!(1.5);
/// And its spin, turns/s.
pub const DRIVEN_SPIN: Ratio = dec!(0.2);
/// Of the thruster, N along x of the gear.
pub const THRUST: Ratio = dec!(3);
/// Where it is, m above the middle of the gear, in its own axes.
pub const NOZZLE: Ratio = dec!(-0.25);
/// Ticks for which it burns: 2 s.
pub const BURN: u32 = 240;
/// Angle at which the gear starts, to fly off along x, degrees.
pub const GEAR_START: i32 = -45;

/// One body, in a world of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lane {
    Through,
    OffCentre,
    Braked,
    Driven,
    Gear,
}

impl Lane {
    pub const ALL: [Lane; 5] = [
        Lane::Through,
        Lane::OffCentre,
        Lane::Braked,
        Lane::Driven,
        Lane::Gear,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Lane::Through => "box, pushed through its centre",
            Lane::OffCentre => "the same push 12 cm below",
            Lane::Braked => "the same, with drag on its spin",
            Lane::Driven => "kinematic box: no push changes it",
            Lane::Gear => "gear with a thruster off its centre",
        }
    }

    /// Before it is pushed.
    pub fn start<C: Centre + From<Point<C::S>>>(self) -> Result<Rigid<C>, Error> {
        match self {
            Lane::Driven => {
                Rigid::kinematic(Vec2::ZERO, vec2(DRIVEN_SPEED, 0)?)?.with_spin(DRIVEN_SPIN)
            }
            Lane::Gear => {
                let centre = Point::new(Vec2::ZERO, Vec2::ZERO, MASS)?;
                let gear = Rigid::new(centre.into(), self.inertia()?)?;
                Ok(gear.with_angle(Angle::degrees(GEAR_START)))
            }
            Lane::Through | Lane::OffCentre | Lane::Braked => {
                let properties = rectangle(SIDES[0], SIDES[1])?.with_mass(MASS)?;
                Rigid::from_properties(&properties, Vec2::ZERO)
            }
        }
    }

    /// The impulse at the start: none for the gear, which burns.
    pub fn push<C: Centre>(self, body: &mut Rigid<C>) -> Result<(), Error> {
        let below = match self {
            Lane::Gear => return Ok(()),
            Lane::Through => Ratio::ZERO,
            Lane::OffCentre | Lane::Braked | Lane::Driven => BELOW,
        };
        let point = body.position() + vec2(0, below)?;
        body.push_at(point, vec2(PUSH, 0)?);
        Ok(())
    }

    /// About its centre, kg m². Of the gear by corners in `f64`, whatever numbers it flies in.
    pub fn inertia(self) -> Result<Ratio, Error> {
        let shape = match self {
            Lane::Gear => polygon(&gear_outline())?,
            _ => rectangle::<f64>(SIDES[0], SIDES[1])?,
        };
        Ok(shape.with_mass(MASS)?.inertia())
    }

    /// Its outline, in its own axes, m.
    pub fn outline(self) -> Vec<Vec2<f64>> {
        match self {
            Lane::Gear => gear_outline(),
            _ => {
                let [x, y] = SIDES.map(|side| side.to_f64() / 2.0);
                [[x, y], [-x, y], [-x, -y], [x, -y]]
                    .map(|[x, y]| Vec2::new(x, y))
                    .to_vec()
            }
        }
    }
}

/// Twelve teeth.
fn gear_outline() -> Vec<Vec2<f64>> {
    const CORNERS: u32 = 48;
    let corner = |i: u32| {
        let (sin, cos) = (TAU * (f64::from(i) - 0.5) / f64::from(CORNERS)).sin_cos();
        let radius = if i % 4 < 2 { 0.45 } else { 0.37 };
        Vec2::new(radius * cos, radius * sin)
    };
    (0..CORNERS).map(corner).collect()
}
