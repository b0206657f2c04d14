//! How forces change with a dimension, at a place that stays.
//!
//! The same equations are solved in numbers that carry their derivatives by the dimension, so these are as exact as the
//! forces.

use alloc::boxed::Box;
use alloc::string::ToString;
use alloc::vec::Vec;

use super::pose_number::{changes, with_change};
use super::{CHANGE, MovedMechanism, MovedNumber, Moving, NamedReactions, Plan};
use super::{ReactionError, ReactionPlace, ReactionQuantity};
use crate::number::series::Series;
use crate::number::{Changing, Number as _};

impl NamedReactions<'_> {
    /// The change of a quantity with a dimension, as a series in the variable. The plan is kept for other dimensions.
    pub(crate) fn change(
        &self,
        place: &ReactionPlace<'_>,
        plan: &mut Option<Plan<Changing<f64>>>,
        quantity: ReactionQuantity,
        dimension: usize,
    ) -> Result<MovedNumber, ReactionError> {
        self.check_beside(place, dimension)?;
        let moving = self.changing(place, dimension)?;
        let solution = self.solved_in_motion(place, moving, Some(plan))?.solution;
        Ok(changes(self.of_solution(place, &solution, quantity)?))
    }

    /// The mechanism while a dimension changes.
    fn changing(&self, place: &ReactionPlace<'_>, dimension: usize) -> Result<Moving<Changing<f64>>, ReactionError> {
        let parameters = place.parameters.iter().enumerate().map(|(index, value)| {
            let change = f64::from(u8::from(index == dimension));
            Changing::new(Series::constant(*value), Series::constant(change))
        });
        let inputs = place.inputs.iter().map(|motion| Changing::new(*motion, Series::ZERO));
        let (parameters, inputs): (Vec<_>, Vec<_>) = (parameters.collect(), inputs.collect());
        let moved = MovedMechanism::near(place.functions, &parameters, &inputs, place.unknowns, place.outputs)?;
        let moved = moved.map(with_change);
        let frames = moved.frames(&place.functions.outline(), &self.connections)?;
        Ok((moved, frames))
    }

    /// Bodies must be rigid, and contacts roll, with another value of the dimension too. Otherwise the forces belong to
    /// this one value, and have no derivative.
    fn check_beside(&self, place: &ReactionPlace<'_>, dimension: usize) -> Result<(), ReactionError> {
        let value = place.parameters[dimension];
        let step = if value == 0.0 { CHANGE } else { CHANGE * value };
        let beside = |step: f64| {
            let mut parameters = place.parameters.to_vec();
            parameters[dimension] += step;
            self.touching(place, &parameters)
        };
        // the other side, where the mechanism does not close on the first one
        let found = match beside(step) {
            Err(ReactionError::Solve(_)) => beside(-step),
            found => found,
        };
        match found {
            Ok(_) | Err(ReactionError::Solve(_)) => Ok(()),
            Err(error) => Err(ReactionError::ThisDesignOnly {
                dimension: place.functions.description().parameters[dimension].name.to_string(),
                reason: Box::new(error),
            }),
        }
    }
}
