//! box2d-rs: Box2D 2.4.1 in Rust. It has no substeps; iterations matter to joints only.

use std::f64::consts::TAU;
use std::rc::Rc;

use box2d_rs::b2_body::{B2body, B2bodyDef, B2bodyType, BodyPtr};
use box2d_rs::b2_joint::B2JointDefEnum;
use box2d_rs::b2_math::B2vec2;
use box2d_rs::b2_shape::B2massData;
use box2d_rs::b2_world::{B2world, B2worldPtr};
use box2d_rs::b2rs_common::UserDataType;
use box2d_rs::joints::b2_distance_joint::B2distanceJointDef;

use crate::engine::{Engine, Scene, Setting, setting};
use crate::problem::{HERTZ, Kind, LENGTH, State};

pub struct Box2d2;

/// Nothing is attached to bodies.
#[derive(Clone, Default)]
struct Nothing;

impl UserDataType for Nothing {
    type Fixture = ();
    type Body = ();
    type Joint = ();
}

const SETTINGS: [Setting; 5] = [
    setting("8 and 3 iterations", [8, 3]), // it has no default; a usual choice
    setting("1 and 1 iterations", [1, 1]),
    setting("2 and 1 iterations", [2, 1]),
    setting("4 and 2 iterations", [4, 2]),
    setting("16 and 6 iterations", [16, 6]),
];

impl Engine for Box2d2 {
    fn name(&self) -> &'static str {
        "box2d-rs 0.0.4 (Box2D 2.4.1)"
    }

    fn settings(&self, _: Kind) -> &'static [Setting] {
        &SETTINGS
    }

    fn build(&self, kind: Kind, setting: &Setting, rate: u32) -> Box<dyn Scene> {
        let world = B2world::<Nothing>::new(vector([0.0, -kind.gravity()]));
        world.borrow_mut().set_allow_sleeping(false);
        let anchor = B2world::create_body(Rc::clone(&world), &B2bodyDef::default());
        let bodies = kind
            .starts()
            .iter()
            .map(|start| {
                let body = add(&world, kind, start);
                if matches!(kind, Kind::OwnSpring | Kind::DampedSpring) {
                    tie(&world, kind, [&anchor, &body]);
                }
                body
            })
            .collect();
        Box::new(Run {
            kind,
            world,
            bodies,
            dt: 1.0 / rate as f32,
            iterations: setting.counts.map(|n| n as i32),
        })
    }
}

fn vector(v: [f64; 2]) -> B2vec2 {
    B2vec2::new(v[0] as f32, v[1] as f32)
}

fn add(world: &B2worldPtr<Nothing>, kind: Kind, start: &State) -> BodyPtr<Nothing> {
    let definition = B2bodyDef {
        body_type: B2bodyType::B2DynamicBody,
        position: vector(start.at),
        linear_velocity: vector(start.speed),
        linear_damping: kind.drag() as f32,
        allow_sleep: false,
        ..Default::default()
    };
    let body = B2world::create_body(Rc::clone(world), &definition);
    body.borrow_mut().set_mass_data(&B2massData {
        mass: 1.0,
        center: vector([0.0, 0.0]),
        i: 1.0,
    });
    body
}

fn tie(world: &B2worldPtr<Nothing>, kind: Kind, [anchor, body]: [&BodyPtr<Nothing>; 2]) {
    let omega = TAU * HERTZ;
    let mut definition = B2distanceJointDef::<Nothing>::default();
    definition.base.body_a = Some(Rc::clone(anchor));
    definition.base.body_b = Some(Rc::clone(body));
    definition.length = LENGTH as f32;
    definition.stiffness = (omega * omega) as f32;
    definition.damping = (2.0 * kind.damping_ratio() * omega) as f32;
    world
        .borrow_mut()
        .create_joint(&B2JointDefEnum::DistanceJoint(definition));
}

struct Run {
    kind: Kind,
    world: B2worldPtr<Nothing>,
    bodies: Vec<BodyPtr<Nothing>>,
    dt: f32,
    iterations: [i32; 2],
}

/// What the caller does before a step.
fn pull(body: &mut B2body<Nothing>, stiffness: f32) {
    let at = body.get_position();
    body.apply_force_to_center(B2vec2::new(-stiffness * at.x, -stiffness * at.y), true);
}

impl Scene for Run {
    fn advance(&mut self, steps: u32) {
        let stiffness = ((TAU * HERTZ) * (TAU * HERTZ)) as f32;
        let [velocities, positions] = self.iterations;
        for _ in 0..steps {
            if self.kind == Kind::UserSpring {
                for body in &self.bodies {
                    pull(&mut body.borrow_mut(), stiffness);
                }
            }
            self.world.borrow_mut().step(self.dt, velocities, positions);
        }
    }

    fn states(&self) -> Vec<State> {
        self.bodies
            .iter()
            .map(|body| {
                let body = body.borrow();
                let (at, speed) = (body.get_position(), body.get_linear_velocity());
                State {
                    at: [at.x.into(), at.y.into()],
                    speed: [speed.x.into(), speed.y.into()],
                }
            })
            .collect()
    }
}
