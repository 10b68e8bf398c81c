//! A scene flown in `f64`, and what types make of it.

use fixstep::{Error, Force, Step, World};

use crate::advise::{Expected, Format, Question, Verdict, range};
use crate::flight::{Dyadic, Plan, Track};
use crate::grid::{Grid, PHASES};
use crate::noted::Noted;
use crate::notes::{self, Notes, Role};

/// A scene that has been flown in `f64`.
pub struct Flown<'a, G> {
    build: &'a G,
    plan: &'a Plan,
    shift: Option<u32>,
    track: Track,
    pub notes: Notes,
}

impl<'a, G> Flown<'a, G> {
    /// Flies it; by a step of `1 / 2^shift` seconds if there is a shift.
    pub fn new<F: Force<Noted>, const N: usize>(
        build: &'a G,
        plan: &'a Plan,
        shift: Option<u32>,
    ) -> Result<Self, Error>
    where
        G: Fn(&mut World<Noted, N>) -> Result<F, Error>,
    {
        let (track, notes) = notes::of(|| Grid::NONE.during(|| flown(build, plan, shift)));
        Ok(Flown {
            build,
            plan,
            shift,
            track: track?,
            notes,
        })
    }

    /// The best type, the next finer one and those asked for, from coarse to fine.
    pub fn beside<F: Force<Noted>, const N: usize>(
        &self,
        best: Option<Format>,
        question: &Question,
    ) -> Result<Vec<Format>, Error>
    where
        G: Fn(&mut World<Noted, N>) -> Result<F, Error>,
    {
        let next = best.map(|best| best.fraction + 1);
        let others = question.beside.iter().copied().chain(next);
        let is_new =
            |&fraction: &u32| fraction < 32 && best.is_none_or(|best| best.fraction != fraction);
        let others = others.filter(is_new).map(|f| self.format(f, question));
        let mut all = others.collect::<Result<Vec<_>, _>>()?;
        all.extend(best);
        all.sort_by_key(|format| format.fraction);
        all.dedup_by_key(|format| format.fraction);
        Ok(all)
    }

    /// What a type makes of the scene.
    pub fn format<F: Force<Noted>, const N: usize>(
        &self,
        fraction: u32,
        question: &Question,
    ) -> Result<Format, Error>
    where
        G: Fn(&mut World<Noted, N>) -> Result<F, Error>,
    {
        let (mut role, mut reach) = self.notes.widest_held();
        let mut expected = None;
        if reach <= range(fraction) && self.is_the_same_within(fraction)? {
            let (error, on_grid) = self.expected(fraction)?;
            expected = Some(error);
            if on_grid.1 > reach {
                (role, reach) = on_grid;
            }
        } else {
            (role, reach) = self.notes.widest();
        }
        let headroom = (range(fraction) / reach).log2();
        let verdict = match expected {
            Some(error) if headroom >= question.headroom.max(0.0) => Verdict::Fits(error),
            Some(error) if headroom >= 0.0 => Verdict::Tight(error),
            _ => Verdict::Saturates(role),
        };
        Ok(Format {
            fraction,
            headroom,
            verdict,
        })
    }

    /// Whether the flight is the same in the range of a type, to the bit: what saturates does no harm.
    fn is_the_same_within<F: Force<Noted>, const N: usize>(
        &self,
        fraction: u32,
    ) -> Result<bool, Error>
    where
        G: Fn(&mut World<Noted, N>) -> Result<F, Error>,
    {
        if self.notes.widest().1 <= range(fraction) {
            return Ok(true);
        }
        let fly = || flown(self.build, self.plan, self.shift);
        let (track, notes) = notes::of(|| Grid::ending(fraction).during(fly));
        let held = notes.widest_held() == self.notes.widest_held();
        Ok(held && track? == self.track)
    }

    /// The expected error of a type, and what of its state reaches furthest in its flights.
    pub fn expected<F: Force<Noted>, const N: usize>(
        &self,
        fraction: u32,
    ) -> Result<(Expected, (Role, f64)), Error>
    where
        G: Fn(&mut World<Noted, N>) -> Result<F, Error>,
    {
        let mut errors = Vec::new();
        let mut widest = (Role::Position, 0.0);
        for i in 0..PHASES {
            let fly = || flown(self.build, self.plan, self.shift);
            let (track, notes) = notes::of(|| Grid::shifted(fraction, i).during(fly));
            errors.push(self.plan.apart(&track?, &self.track));
            if notes.widest_held().1 > widest.1 {
                widest = notes.widest_held();
            }
        }
        errors.sort_by(f64::total_cmp);
        let middle = errors.len() / 2;
        let (median, worst) = (
            0.5 * (errors[middle - 1] + errors[middle]),
            errors[errors.len() - 1],
        );
        Ok((Expected { median, worst }, widest))
    }
}

fn flown<F: Force<Noted>, const N: usize>(
    build: &impl Fn(&mut World<Noted, N>) -> Result<F, Error>,
    plan: &Plan,
    shift: Option<u32>,
) -> Result<Track, Error> {
    let mut world = World::new();
    let mut forces = build(&mut world)?;
    match shift {
        None => plan.fly(&mut world, &mut forces, &Step::hz(plan.rate)?),
        Some(shift) => plan.fly(&mut world, &mut forces, &Dyadic::new(shift)?),
    }
}
