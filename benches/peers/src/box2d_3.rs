//! box2d-rust: Box2D 3.1 in Rust.

use std::f64::consts::TAU;

use box2d_rust::BodyId;
use box2d_rust::body::{
    body_apply_force_to_center, body_get_linear_velocity, body_get_position, body_set_mass_data,
    create_body,
};
use box2d_rust::collision::MassData;
use box2d_rust::joint::create_distance_joint;
use box2d_rust::math_functions::Vec2;
use box2d_rust::types::{
    BodyDef, BodyType, WorldDef, default_body_def, default_distance_joint_def, default_world_def,
};
use box2d_rust::world::{World, world_step};

use crate::engine::{Engine, Scene, Setting, setting};
use crate::problem::{HERTZ, Kind, LENGTH, State};

pub struct Box2d3;

const SETTINGS: [Setting; 5] = [
    setting("4 substeps", [4, 0]),
    setting("1 substep", [1, 0]),
    setting("2 substeps", [2, 0]),
    setting("8 substeps", [8, 0]),
    setting("16 substeps", [16, 0]),
];

impl Engine for Box2d3 {
    fn name(&self) -> &'static str {
        "box2d-rust 1.4.0 (Box2D 3.1)"
    }

    fn settings(&self, _: Kind) -> &'static [Setting] {
        &SETTINGS
    }

    fn build(&self, kind: Kind, setting: &Setting, rate: u32) -> Box<dyn Scene> {
        let mut world = World::new(&WorldDef {
            gravity: vector([0.0, -kind.gravity()]),
            enable_sleep: false,
            ..default_world_def()
        });
        let anchor = create_body(&mut world, &default_body_def());
        let bodies = kind
            .starts()
            .iter()
            .map(|start| {
                let body = add(&mut world, kind, start);
                if matches!(kind, Kind::OwnSpring | Kind::DampedSpring) {
                    tie(&mut world, kind, [anchor, body]);
                }
                body
            })
            .collect();
        Box::new(Run {
            kind,
            world,
            bodies,
            dt: 1.0 / rate as f32,
            substeps: setting.counts[0] as i32,
        })
    }
}

fn vector(v: [f64; 2]) -> Vec2 {
    Vec2 {
        x: v[0] as f32,
        y: v[1] as f32,
    }
}

fn add(world: &mut World, kind: Kind, start: &State) -> BodyId {
    let definition = BodyDef {
        type_: BodyType::Dynamic,
        position: vector(start.at),
        linear_velocity: vector(start.speed),
        linear_damping: kind.drag() as f32,
        enable_sleep: false,
        ..default_body_def()
    };
    let body = create_body(world, &definition);
    let mass = MassData {
        mass: 1.0,
        center: vector([0.0, 0.0]),
        rotational_inertia: 1.0,
    };
    body_set_mass_data(world, body, mass);
    body
}

fn tie(world: &mut World, kind: Kind, [anchor, body]: [BodyId; 2]) {
    let mut definition = default_distance_joint_def();
    definition.base.body_id_a = anchor;
    definition.base.body_id_b = body;
    definition.length = LENGTH as f32;
    definition.enable_spring = true;
    definition.hertz = HERTZ as f32;
    definition.damping_ratio = kind.damping_ratio() as f32;
    create_distance_joint(world, &definition);
}

struct Run {
    kind: Kind,
    world: World,
    bodies: Vec<BodyId>,
    dt: f32,
    substeps: i32,
}

impl Scene for Run {
    fn advance(&mut self, steps: u32) {
        let stiffness = ((TAU * HERTZ) * (TAU * HERTZ)) as f32;
        for _ in 0..steps {
            if self.kind == Kind::UserSpring {
                for &body in &self.bodies {
                    let at = body_get_position(&self.world, body);
                    let force = Vec2 {
                        x: -stiffness * at.x,
                        y: -stiffness * at.y,
                    };
                    body_apply_force_to_center(&mut self.world, body, force, true);
                }
            }
            world_step(&mut self.world, self.dt, self.substeps);
        }
    }

    fn states(&self) -> Vec<State> {
        self.bodies
            .iter()
            .map(|&body| {
                let at = body_get_position(&self.world, body);
                let speed = body_get_linear_velocity(&self.world, body);
                State {
                    at: [at.x.into(), at.y.into()],
                    speed: [speed.x.into(), speed.y.into()],
                }
            })
            .collect()
    }
}
