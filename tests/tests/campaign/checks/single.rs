//! Single precision finds what double precision finds for the same rounded numbers.

use std::f64::consts::TAU;

use kin_core::Dimension;
use kin_core::any::AssemblyChoice;

use super::pose::ALLOWED;
use super::{Campaign, Solved};
use crate::draw::Family;
use crate::topology::{Problem, Rates};

/// The ε of single precision.
const EPSILON: f64 = f32::EPSILON as f64;

#[expect(clippy::cast_possible_truncation, reason = "rounding is what is wanted")]
fn rounded(value: f64) -> f64 {
    f64::from(value as f32)
}

fn rounded_rates(rates: Rates) -> Rates {
    rates.map(rounded)
}

impl Campaign {
    /// Solves a pose once more in both precisions.
    pub(super) fn in_single_precision(&mut self, solved: &Solved, family: Family) {
        if !matches!(family, Family::Ordinary | Family::Scaled | Family::Aligned) || solved.result.is_err() {
            return;
        }
        let problem = Problem {
            parameters: solved.problem.parameters.iter().copied().map(rounded).collect(),
            inputs: solved.problem.inputs.iter().copied().map(rounded_rates).collect(),
        };
        let assembly = match &solved.assembly {
            AssemblyChoice::Near(near) => AssemblyChoice::Near(near.iter().copied().map(rounded).collect()),
            AssemblyChoice::Index(index) => AssemblyChoice::Index(*index),
        };
        let wide = self.solve(&problem, assembly);
        let Ok(pose) = &wide.result else {
            return;
        };
        let Some(units) = pose.known(EPSILON) else {
            return;
        };
        let found = match self.topology.solve_single(&problem, &wide.assembly) {
            Ok(found) => found,
            Err(error) => {
                // The range of single precision ends where powers of scaled lengths begin.
                if family == Family::Ordinary {
                    let what = format!("refused: {error}; condition {:e}", units.condition);
                    self.find("single", what, &problem, &wide.assembly);
                }
                return;
            }
        };
        self.tally.singles += 1;
        if !found.is_finite() {
            self.find("single", format!("not finite: {found:?}"), &problem, &wide.assembly);
        }
        let description = self.topology.description();
        for (place, (narrow, wide_rates)) in found.unknowns.iter().zip(&pose.found.unknowns).enumerate() {
            for order in 0..narrow.len() {
                let mut difference = narrow[order] - wide_rates[order];
                if order == 0 && description.unknowns[place].dimension == Dimension::Angle {
                    difference -= TAU * (difference / TAU).round();
                }
                // Beyond the smallest numbers of single precision, nothing is left to be compared.
                let unit = EPSILON * units.conditions[place][order] + f64::from(f32::MIN_POSITIVE);
                let error = difference.abs() / unit;
                self.tally.single = self.tally.single.max(error);
                if error > ALLOWED {
                    let what = format!(
                        "order {order} of {} is {} for {}, {error:.1} units; condition {:e}",
                        description.unknowns[place].name, narrow[order], wide_rates[order], units.condition
                    );
                    self.find("single", what, &problem, &wide.assembly);
                }
            }
        }
    }
}
