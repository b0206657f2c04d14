//! Errors of the engine, in units of rounding times the condition.

use std::fmt;

use kin_core::Mechanism;
use kin_precise::Number;

use super::closure::Given;
use super::solution::{Solution, Stray, solution};

/// A number that cannot be told from zero: the reference has 77 digits, and finds zeros by differences.
const NOTHING: f64 = 1e-100;

/// The worst errors of a mechanism, order by order.
#[derive(Clone, Debug)]
pub struct Errors {
    /// The mechanism's name.
    pub name: &'static str,
    /// How many poses there were.
    pub poses: usize,
    /// The largest error of any unknown, in units of rounding times the condition.
    pub worst: Vec<f64>,
    /// Where it was.
    pub places: Vec<String>,
}

impl Errors {
    /// Before the first pose.
    #[must_use]
    pub fn new<M: Mechanism>() -> Self {
        let count = M::DESCRIPTION.order + 1;
        Self {
            name: M::DESCRIPTION.name,
            poses: 0,
            worst: vec![0.0; count],
            places: vec![String::new(); count],
        }
    }

    /// Holds motions of the unknowns, computed in numbers that are rounded by `epsilon`, against the reference.
    ///
    /// # Errors
    /// If there is no reference.
    pub fn hold<M: Mechanism>(
        &mut self,
        given: &Given,
        motions: &[Vec<f64>],
        epsilon: f64,
        place: &str,
    ) -> Result<(), Stray> {
        let position: Vec<f64> = motions.iter().map(|motion| motion[0]).collect();
        let reference = solution::<M>(given, &position)?;
        self.hold_to::<M>(&reference, given, motions, epsilon, place);
        Ok(())
    }

    /// The same against a reference that is known: that of the same pose, as it was solved in another way.
    pub fn hold_to<M: Mechanism>(
        &mut self,
        reference: &Solution,
        given: &Given,
        motions: &[Vec<f64>],
        epsilon: f64,
        place: &str,
    ) {
        self.poses += 1;
        for (index, motion) in motions.iter().enumerate() {
            for (order, value) in motion.iter().enumerate() {
                let error = &Number::exactly(*value) - &reference.motions[index][order];
                let error = error.nearest().abs();
                let unit = epsilon * reference.conditions[index][order];
                // what is exact is so where there is no unit, too
                let units = if error <= NOTHING { 0.0 } else { error / unit };
                if units > self.worst[order] {
                    self.worst[order] = units;
                    self.places[order] = format!(
                        "{} of {place}: {value:e}, error {error:.1e}, unit {unit:.1e}; {given:?}",
                        M::DESCRIPTION.unknowns[index].name,
                    );
                }
            }
        }
    }

    /// The row of a table, every error rounded up to a tenth.
    #[must_use]
    pub fn row(&self) -> String {
        let errors: Vec<String> = self
            .worst
            .iter()
            .map(|worst| format!("{:.1}", (worst * 10.0).ceil() / 10.0))
            .collect();
        format!("{} {}", self.name, errors.join(" "))
    }
}

impl fmt::Display for Errors {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(formatter, "{} {} poses", self.row(), self.poses)?;
        for (order, place) in self.places.iter().enumerate() {
            writeln!(formatter, "    order {order}: {:.2}, {place}", self.worst[order])?;
        }
        Ok(())
    }
}
