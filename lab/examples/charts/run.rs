//! One scene with one kind of body: all its methods and forces, at several rates.
//!
//! The error of a start is the root mean square, over the looks of the last second and its bodies, of the
//! distance from where the body should be. A single instant could be one at which the error passes zero,
//! or a body turns and hides an error of phase. Of a rotor it is of the angle, in turns.

use fixstep::rigid::Centre;
use fixstep::{Body, Decay, Error, Force, Method, Point, Rigid, Step, World};

use crate::exact::{LOOKS, Places, last_second};
use crate::rotor::Rotor;
use crate::scenes::{ROOM, Room, Scene, Visitor};
use crate::starts::{Dot, Plan};
use crate::subject::Subject;

/// One method with one way to state the forces, at one rate.
pub struct Outcome {
    pub method: &'static str,
    pub forces: &'static str,
    pub body: &'static str,
    pub rate: u32,
    /// Of each start, m or turns; infinite where a body left the range on its way.
    pub errors: Vec<f64>,
}

/// The plan and where its bodies should be.
pub struct Course {
    pub plan: Plan,
    truth: Vec<Vec<Places>>,
}

impl Course {
    pub fn new(plan: Plan) -> Course {
        let exact = |world: &Vec<Dot>| last_second(plan.scene, world, plan.seconds);
        let truth = plan.worlds.iter().map(exact).collect();
        Course { plan, truth }
    }

    /// All runs of a scene with one kind of body.
    pub fn run<T: Scene, B>(&self, body: &'static str, rates: &[u32]) -> Result<Vec<Outcome>, Error>
    where
        B: Body<S: Decay> + From<Point<B::S>>,
    {
        let mut runner = self.runner(T::BODIES, body, rates, Subject::moving())?;
        T::show::<B, _>(&mut runner)?;
        Ok(runner.found)
    }

    /// The same of the rotor, whose bodies turn.
    pub fn run_rotor<C>(&self, body: &'static str, rates: &[u32]) -> Result<Vec<Outcome>, Error>
    where
        C: Centre<S: Decay> + From<Point<C::S>>,
    {
        let mut runner = self.runner(Rotor::BODIES, body, rates, Subject::<Rigid<C>>::turning())?;
        Rotor::show::<C, _>(&mut runner)?;
        Ok(runner.found)
    }

    fn runner<'a, B>(
        &'a self,
        bodies: usize,
        body: &'static str,
        rates: &'a [u32],
        subject: Subject<B>,
    ) -> Result<Runner<'a, B>, Error> {
        let mut worlds = self.plan.worlds.iter();
        if worlds.any(|world| world.len() != bodies) {
            return Err(Error::Empty { field: "bodies" });
        }
        Ok(Runner {
            course: self,
            body,
            rates,
            subject,
            found: Vec::new(),
        })
    }
}

struct Runner<'a, B> {
    course: &'a Course,
    body: &'static str,
    rates: &'a [u32],
    subject: Subject<B>,
    found: Vec<Outcome>,
}

/// Makes method and forces for a world and steps it as often as `legs` says, until that has no more. False
/// where a body left the range.
type Fly<'a, B> = &'a dyn Fn(
    &mut Room<B>,
    &Step<<B as Body>::S>,
    &mut dyn FnMut(&Room<B>) -> Option<u32>,
) -> Result<bool, Error>;

impl<B: Body> Visitor<B> for Runner<'_, B> {
    // All that knows method and forces is in the closure: what is around it is compiled once for a body.
    fn run<M, F>(
        &mut self,
        method: &'static str,
        forces: &'static str,
        new: fn() -> M,
        build: fn(&Room<B>) -> Result<F, Error>,
    ) -> Result<(), Error>
    where
        M: Method<B, ROOM>,
        F: Force<B>,
    {
        let course = self.course;
        for &rate in self.rates {
            let errors = course.errors(rate, &self.subject, &|world, step, legs| {
                let (mut stages, mut acting) = (new(), build(world)?);
                while let Some(steps) = legs(world) {
                    for _ in 0..steps {
                        world.step(&mut stages, &mut acting, step);
                        if world.out_of_range().next().is_some() {
                            return Ok(false);
                        }
                    }
                }
                Ok(true)
            })?;
            self.found.push(Outcome {
                method,
                forces,
                body: self.body,
                rate,
                errors,
            });
        }
        Ok(())
    }
}

impl Course {
    /// Of each start.
    fn errors<B: Body>(
        &self,
        rate: u32,
        subject: &Subject<B>,
        fly: Fly<B>,
    ) -> Result<Vec<f64>, Error> {
        let mut errors = Vec::new();
        for (start, truth) in self.plan.worlds.iter().zip(&self.truth) {
            let squares = self.squares((start, truth), rate, subject, fly)?;
            match self.plan.alone {
                true => errors.extend(squares.iter().map(|square| square.sqrt())),
                false => {
                    let sum: f64 = squares.iter().sum();
                    errors.push((sum / squares.len() as f64).sqrt());
                }
            }
        }
        Ok(errors)
    }

    /// Mean squares of each body's distances; infinite in a world that left the range.
    fn squares<B: Body>(
        &self,
        (start, truth): (&[Dot], &[Places]),
        rate: u32,
        subject: &Subject<B>,
        fly: Fly<B>,
    ) -> Result<Vec<f64>, Error> {
        let mut world = World::new();
        for dot in start {
            world.add((subject.start)(dot)?)?;
        }
        let mut sums = vec![0.0; start.len()];
        let mut looks = 0;
        let inside = fly(&mut world, &Step::hz(rate as i32)?, &mut |world| {
            // Before the first look there is the way to it.
            looks += 1;
            if looks == 1 {
                return Some(rate * (self.plan.seconds - 1));
            }
            let places = &truth[looks - 2];
            for ((sum, body), at) in sums.iter_mut().zip(world.bodies()).zip(places) {
                *sum += (subject.square)(body, at);
            }
            (looks <= truth.len()).then_some(rate / LOOKS)
        })?;
        let mean = |sum: &f64| match inside {
            true => sum / truth.len() as f64,
            false => f64::INFINITY,
        };
        Ok(sums.iter().map(mean).collect())
    }
}
