//! A pose that is found is finite, closes at every order, and is the position that the position solver finds; and one
//! that is there is found.

use kin_core::Failure;
use kin_core::any::AssemblyChoice;

use super::{Campaign, Pose, Solved};
use crate::bounded::TERMS;
use crate::topology::{Problem, at_rest};
use crate::unit::units;

/// How many units of ε times the condition a pose may be off. The unit counts each number and each operation of the
/// closure once; what the solvers calculate besides, and lose, is a few operations more for each of these.
pub(super) const ALLOWED: f64 = 8.0;

/// A position that is as well known as this must not be refused.
const WELL_KNOWN: f64 = 1e-9;

impl Campaign {
    /// Solves a problem, and looks at what is found.
    pub(super) fn solve(&mut self, problem: &Problem, assembly: AssemblyChoice) -> Solved {
        self.current = (problem.clone(), assembly.clone());
        let result = self.topology.solve(problem, &assembly);
        let position = self.topology.position(problem, &assembly);
        let result = match result {
            Err(error) => {
                self.tally.refuse(&error);
                Err(error)
            }
            Ok(found) => {
                self.tally.solved += 1;
                if !found.is_finite() {
                    self.find("finite", format!("{found:?}"), problem, &assembly);
                }
                if position.as_ref().ok() != Some(&found.position()) {
                    let what = format!("{position:?} alone, {:?} with rates", found.position());
                    self.find("position", what, problem, &assembly);
                }
                let units = units(&self.topology, problem, &found.unknowns);
                let pose = Pose { found, units };
                self.closes(problem, &assembly, &pose);
                self.is_of_its_assembly(problem, &assembly, &pose);
                Ok(pose)
            }
        };
        Solved {
            problem: problem.clone(),
            assembly,
            result,
        }
    }

    /// The closure vanishes at every order.
    fn closes(&mut self, problem: &Problem, assembly: &AssemblyChoice, pose: &Pose) {
        let Some(units) = pose.known(f64::EPSILON) else {
            self.tally.ill += 1;
            return;
        };
        for order in 0..TERMS {
            for (place, (correction, condition)) in units.corrections.iter().zip(&units.conditions).enumerate() {
                let error = correction[order] / (f64::EPSILON * condition[order]);
                if error > ALLOWED {
                    let name = self.topology.description().unknowns[place].name;
                    let what = format!(
                        "order {order} of {name} is off by {:e}, {error:.1} units; condition {:e}",
                        correction[order], units.condition
                    );
                    self.find("closure", what, problem, assembly);
                }
                self.tally.closure[order] = self.tally.closure[order].max(error);
            }
        }
    }

    /// A position that is known to close is found from there.
    pub(super) fn is_not_missed(&mut self, problem: &Problem, near: &[f64]) {
        let still = problem.at(&problem.values());
        let unknowns: Vec<_> = near.iter().copied().map(at_rest).collect();
        let Some(units) = units(&self.topology, &still, &unknowns) else {
            return;
        };
        if units.condition * f64::EPSILON > WELL_KNOWN {
            return;
        }
        let assembly = AssemblyChoice::Near(near.to_vec());
        self.current = (problem.clone(), assembly.clone());
        match self.topology.solve(&still, &assembly) {
            // A range excludes it.
            Err(error) if matches!(error.failure, Failure::OutOfRange { .. }) => {}
            Err(error) => {
                let what = format!("{error}; condition {:e}", units.condition);
                self.find("missed", what, problem, &assembly);
            }
            Ok(found) => {
                for (place, value) in near.iter().enumerate() {
                    let error = (found.unknowns[place][0] - value).abs() / (f64::EPSILON * units.conditions[place][0]);
                    if error > ALLOWED {
                        let what = format!(
                            "{:?} is {error:.1} units away; condition {:e}",
                            found.position(),
                            units.condition
                        );
                        self.find("elsewhere", what, problem, &assembly);
                        return;
                    }
                }
            }
        }
    }
}
