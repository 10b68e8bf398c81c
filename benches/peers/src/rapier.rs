//! rapier2d: the count of solver iterations is that of its substeps.

use std::f64::consts::TAU;

use rapier2d::prelude::*;

use crate::engine::{Engine, Scene, Setting, setting};
use crate::problem::{HERTZ, Kind, LENGTH, State};

pub struct Rapier;

const FREE: [Setting; 5] = [
    setting("4 substeps", [4, 1]),
    setting("1 substep", [1, 1]),
    setting("2 substeps", [2, 1]),
    setting("8 substeps", [8, 1]),
    setting("16 substeps", [16, 1]),
];

/// A joint is solved in more passes than one; the second kind of them can be left out.
const JOINED: [Setting; 10] = [
    setting("4 substeps", [4, 1]),
    setting("1 substep", [1, 1]),
    setting("2 substeps", [2, 1]),
    setting("8 substeps", [8, 1]),
    setting("16 substeps", [16, 1]),
    setting("4 substeps, no stabilisation", [4, 0]),
    setting("1 substep, no stabilisation", [1, 0]),
    setting("2 substeps, no stabilisation", [2, 0]),
    setting("8 substeps, no stabilisation", [8, 0]),
    setting("16 substeps, no stabilisation", [16, 0]),
];

impl Engine for Rapier {
    fn name(&self) -> &'static str {
        "rapier2d 0.36.1"
    }

    fn settings(&self, kind: Kind) -> &'static [Setting] {
        match kind {
            Kind::OwnSpring | Kind::DampedSpring => &JOINED,
            _ => &FREE,
        }
    }

    fn build(&self, kind: Kind, setting: &Setting, rate: u32) -> Box<dyn Scene> {
        let [substeps, stabilisation] = setting.counts;
        let parameters = IntegrationParameters {
            dt: 1.0 / rate as f32,
            num_solver_iterations: substeps,
            num_internal_stabilization_iterations: stabilisation,
            ..Default::default()
        };
        let mut bodies = RigidBodySet::new();
        let mut joints = ImpulseJointSet::new();
        let anchor = bodies.insert(RigidBodyBuilder::fixed());
        let handles = kind
            .starts()
            .iter()
            .map(|start| {
                let body = bodies.insert(body(kind, start));
                if matches!(kind, Kind::OwnSpring | Kind::DampedSpring) {
                    joints.insert(anchor, body, spring(kind), true);
                }
                body
            })
            .collect();
        Box::new(Run {
            kind,
            parameters,
            bodies,
            joints,
            handles,
            pipeline: PhysicsPipeline::new(),
            islands: IslandManager::new(),
            broad_phase: BroadPhaseBvh::new(),
            narrow_phase: NarrowPhase::new(),
            colliders: ColliderSet::new(),
            multibody_joints: MultibodyJointSet::new(),
            soft_bodies: SoftBodySet::new(),
            ccd: CCDSolver::new(),
        })
    }
}

fn body(kind: Kind, start: &State) -> RigidBody {
    RigidBodyBuilder::dynamic()
        .additional_mass(1.0)
        .can_sleep(false)
        .linear_damping(kind.drag() as f32)
        .translation(Vector::new(start.at[0] as f32, start.at[1] as f32))
        .linvel(Vector::new(start.speed[0] as f32, start.speed[1] as f32))
        .build()
}

fn spring(kind: Kind) -> SpringJoint {
    let omega = TAU * HERTZ;
    let damping = 2.0 * kind.damping_ratio() * omega;
    SpringJointBuilder::new(LENGTH as f32, (omega * omega) as f32, damping as f32).build()
}

struct Run {
    kind: Kind,
    parameters: IntegrationParameters,
    bodies: RigidBodySet,
    joints: ImpulseJointSet,
    handles: Vec<RigidBodyHandle>,
    pipeline: PhysicsPipeline,
    islands: IslandManager,
    broad_phase: BroadPhaseBvh,
    narrow_phase: NarrowPhase,
    colliders: ColliderSet,
    multibody_joints: MultibodyJointSet,
    soft_bodies: SoftBodySet,
    ccd: CCDSolver,
}

impl Scene for Run {
    fn advance(&mut self, steps: u32) {
        let gravity = Vector::new(0.0, -self.kind.gravity() as f32);
        let stiffness = ((TAU * HERTZ) * (TAU * HERTZ)) as f32;
        for _ in 0..steps {
            if self.kind == Kind::UserSpring {
                for &handle in &self.handles {
                    let body = &mut self.bodies[handle];
                    body.reset_forces(true);
                    body.add_force(body.translation() * -stiffness, true);
                }
            }
            self.pipeline.step(
                gravity,
                &self.parameters,
                &mut self.islands,
                &mut self.broad_phase,
                &mut self.narrow_phase,
                &mut self.bodies,
                &mut self.colliders,
                &mut self.joints,
                &mut self.multibody_joints,
                &mut self.soft_bodies,
                &mut self.ccd,
                &(),
                &(),
            );
        }
    }

    fn states(&self) -> Vec<State> {
        self.handles
            .iter()
            .map(|&handle| {
                let (at, speed) = (
                    self.bodies[handle].translation(),
                    self.bodies[handle].linvel(),
                );
                State {
                    at: [at.x.into(), at.y.into()],
                    speed: [speed.x.into(), speed.y.into()],
                }
            })
            .collect()
    }
}
