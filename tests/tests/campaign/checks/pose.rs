//! A pose that is found is finite, closes at every order, and is the position that the position solver finds; and one that is there is found.

use std::f64::consts::TAU;

use kin_core::{Dimension, Failure};

use super::{Campaign, Pose, Solved};
use crate::engine::{Found, Guide, Problem, at_rest};
use crate::taylor::TERMS;
use crate::unit::units;

/// How many units of ε times the condition a pose may be off. The unit counts each number and each operation of the closure once; what
/// the solvers calculate besides, and lose, is a few operations more for each of these.
pub(super) const ALLOWED: f64 = 8.0;

/// A position that is as well known as this must not be refused.
const WELL_KNOWN: f64 = 1e-9;

impl Campaign<'_> {
    /// Solves a problem, and looks at what is found.
    pub(super) fn solve(&mut self, problem: &Problem, guide: Guide) -> Solved {
        self.current = (problem.clone(), guide.clone());
        let result = self.engine.solve(problem, &guide);
        let position = self.engine.position(problem, &guide);
        let result = match result {
            Err(error) => {
                self.tally.refuse(&error);
                Err(error)
            }
            Ok(found) => {
                self.tally.solved += 1;
                if !found.is_finite() {
                    self.find("finite", format!("{found:?}"), problem, &guide);
                }
                if position.as_ref().ok() != Some(&found.position()) {
                    let what = format!("{position:?} alone, {:?} with rates", found.position());
                    self.find("position", what, problem, &guide);
                }
                let units = units(self.engine, problem, &found.unknowns);
                let pose = Pose { found, units };
                self.closes(problem, &guide, &pose);
                self.is_of_its_assembly(problem, &guide, &pose);
                Ok(pose)
            }
        };
        Solved {
            problem: problem.clone(),
            guide,
            result,
        }
    }

    /// The closure vanishes at every order.
    fn closes(&mut self, problem: &Problem, guide: &Guide, pose: &Pose) {
        let Some(units) = pose.known(f64::EPSILON) else {
            self.tally.ill += 1;
            return;
        };
        for order in 0..TERMS {
            for (place, (correction, condition)) in units.corrections.iter().zip(&units.conditions).enumerate() {
                let error = correction[order] / (f64::EPSILON * condition[order]);
                if error > ALLOWED {
                    let name = self.engine.description().unknowns[place].name;
                    let what = format!(
                        "order {order} of {name} is off by {:e}, {error:.1} units; condition {:e}",
                        correction[order], units.condition
                    );
                    self.find("closure", what, problem, guide);
                }
                self.tally.closure[order] = self.tally.closure[order].max(error);
            }
        }
    }

    /// A position that is known to close is found from there.
    pub(super) fn is_not_missed(&mut self, problem: &Problem, near: &[f64]) {
        let still = problem.at(&problem.values());
        let unknowns: Vec<_> = near.iter().copied().map(at_rest).collect();
        let Some(units) = units(self.engine, &still, &unknowns) else {
            return;
        };
        if units.condition * f64::EPSILON > WELL_KNOWN {
            return;
        }
        let guide = Guide::Near(near.to_vec());
        self.current = (problem.clone(), guide.clone());
        match self.engine.solve(&still, &guide) {
            // A range excludes it.
            Err(error) if matches!(error.failure, Failure::OutOfRange { .. }) => {}
            Err(error) => {
                let what = format!("{error}; condition {:e}", units.condition);
                self.find("missed", what, problem, &guide);
            }
            Ok(found) => {
                for (place, value) in near.iter().enumerate() {
                    let difference = self.difference(&found, place, *value);
                    let error = difference.abs() / (f64::EPSILON * units.conditions[place][0]);
                    if error > ALLOWED {
                        let what = format!(
                            "{:?} is {error:.1} units away; condition {:e}",
                            found.position(),
                            units.condition
                        );
                        self.find("elsewhere", what, problem, &guide);
                        return;
                    }
                }
            }
        }
    }

    /// The difference of an unknown from a value; that of a direction without whole turns.
    pub(super) fn difference(&self, found: &Found, place: usize, value: f64) -> f64 {
        let difference = found.unknowns[place][0] - value;
        let is_angle = self.engine.description().unknowns[place].dimension == Dimension::Angle;
        if is_angle && found.sines[place].is_some() {
            difference - TAU * (difference / TAU).round()
        } else {
            difference
        }
    }
}
