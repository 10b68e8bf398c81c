//! The whole comparison: every scene, method and scalar, on all cores, with a progress bar.
//!
//! Threads take scenes with a method from one list and put what they find in its own place, so the
//! order of the report does not depend on who was first.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use fixstep::fixed::types::{I8F24, I12F20, I16F16, I20F12};
use fixstep::{Error, Point, Scalar};
use indicatif::{ProgressBar, ProgressDrawTarget};

use crate::cli::{MethodName, Options, ScalarName};
use crate::compare::{Reference, Row, compare};
use crate::run::Plan;
use crate::scene::Scene;

/// One scene with one method in one scalar.
pub struct Case {
    pub scene: &'static Scene,
    pub method: MethodName,
    pub scalar: ScalarName,
    pub bytes_per_body: usize,
    /// A row for each tick, or why the scalar cannot hold the scene.
    pub rows: Result<Vec<Row>, Error>,
}

/// What a job finds, and what all jobs find together.
type Found = Result<Vec<Case>, Error>;

/// All cases, in the order of the options.
pub fn compare_all(options: &Options) -> Found {
    let jobs: Vec<(&'static Scene, MethodName)> = options
        .scene
        .iter()
        .flat_map(|&scene| options.method.iter().map(move |&method| (scene, method)))
        .collect();
    let progress = Progress::new(options);
    let next = AtomicUsize::new(0);
    let found: Vec<OnceLock<Found>> = jobs.iter().map(|_| OnceLock::new()).collect();
    let work = || {
        let take = || next.fetch_add(1, Ordering::Relaxed);
        while let Some((&job, place)) = jobs.iter().zip(&found).nth(take()) {
            place.get_or_init(|| fly_job(options, job, &progress));
        }
    };
    thread::scope(|scope| {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        (0..cores.min(jobs.len())).for_each(|_| drop(scope.spawn(work)));
    });
    progress.bar.finish_and_clear();
    let found = found.into_iter().filter_map(OnceLock::into_inner);
    Ok(found
        .collect::<Result<Vec<_>, _>>()?
        .into_iter()
        .flatten()
        .collect())
}

/// One scene and method in every scalar.
fn fly_job(
    options: &Options,
    (scene, method): (&'static Scene, MethodName),
    progress: &Progress,
) -> Found {
    let steps = scene.steps(options.hz, options.seconds);
    let ticks = ticks(steps);
    let (law, compare, rate) = (scene.law, scene.compare, options.hz);
    let plan = Plan {
        law,
        compare,
        method,
        rate,
        ticks: &ticks,
    };
    let reference = Reference::new(scene, &plan)?;
    let case = |&scalar: &ScalarName| {
        let case = in_scalar(scalar, scene, &plan, &reference);
        progress.add(steps);
        case
    };
    Ok(options.scalar.iter().map(case).collect())
}

fn in_scalar(
    scalar: ScalarName,
    scene: &'static Scene,
    plan: &Plan,
    reference: &Reference,
) -> Case {
    match scalar {
        ScalarName::F32 => case::<f32>(scalar, scene, plan, reference),
        ScalarName::I8F24 => case::<I8F24>(scalar, scene, plan, reference),
        ScalarName::I12F20 => case::<I12F20>(scalar, scene, plan, reference),
        ScalarName::I16F16 => case::<I16F16>(scalar, scene, plan, reference),
        ScalarName::I20F12 => case::<I20F12>(scalar, scene, plan, reference),
        ScalarName::F64 => case::<f64>(scalar, scene, plan, reference),
    }
}

fn case<S: Scalar>(
    scalar: ScalarName,
    scene: &'static Scene,
    plan: &Plan,
    reference: &Reference,
) -> Case {
    Case {
        scene,
        method: plan.method,
        scalar,
        bytes_per_body: size_of::<Point<S>>(),
        rows: compare::<S>(scene, plan, reference),
    }
}

/// Ticks to look at in a run of `steps`: about evenly on a logarithmic axis, with those of
/// [`marks`] among them.
fn ticks(steps: u64) -> Vec<u64> {
    const SAMPLES: u32 = 72;
    let at = |i: u32| {
        (steps as f64)
            .powf(f64::from(i) / f64::from(SAMPLES))
            .round() as u64
    };
    let mut ticks: Vec<u64> = (0..=SAMPLES).map(at).chain(marks(steps)).collect();
    ticks.sort_unstable();
    ticks.dedup();
    ticks
}

/// The ticks that the table shows: 1/100, 1/10, 1/3 and all of a run.
pub fn marks(steps: u64) -> [u64; 4] {
    [100, 10, 3, 1].map(|part| steps.div_ceil(part))
}

/// A bar on the terminal that appears after a second.
struct Progress {
    bar: ProgressBar,
    begin: Instant,
}

impl Progress {
    fn new(options: &Options) -> Self {
        let steps = options
            .scene
            .iter()
            .map(|scene| scene.steps(options.hz, options.seconds));
        let cases = options.method.len() * options.scalar.len();
        let length = steps.sum::<u64>() * cases as u64;
        let bar = ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::hidden());
        Progress {
            bar,
            begin: Instant::now(),
        }
    }

    fn add(&self, steps: u64) {
        if self.bar.is_hidden() && self.begin.elapsed() > Duration::from_secs(1) {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        self.bar.inc(steps);
    }
}
