//! Friction between the equations of equilibrium and its own.

use alloc::vec;
use alloc::vec::Vec;

use super::ReactionError;
use super::action::Exertion;
use super::coulomb::{self, Contact, Measure, Unsolved};
use super::equations::{Equations, Solution, Unknown};
use super::frames::along_axis;
use super::friction::{ActingFriction, Friction};
use super::pose_number::SinglePose;
use crate::number::Number;
use crate::number::series::SeriesOf;

impl<S: SinglePose, const N: usize> Equations<'_, SeriesOf<S, N>> {
    /// The forces with friction, from those without it and from what a unit of the friction of each joint changes in
    /// them.
    pub(super) fn with_friction(
        &self,
        unknowns: &[Unknown],
        mut values: Vec<SeriesOf<S, N>>,
        is_undetermined: &[bool],
        responses: &[Vec<SeriesOf<S, N>>],
    ) -> Result<Solution<N, S>, ReactionError> {
        let undetermined = self.undetermined_connections(unknowns, is_undetermined);
        if let Some(acting) = self
            .frictions
            .iter()
            .find(|acting| undetermined.contains(&acting.connection))
        {
            let name = |connection: usize| self.connections[connection].name.clone();
            return Err(ReactionError::Undetermined {
                reaction: name(acting.connection),
                all: undetermined.into_iter().map(name).collect(),
            });
        }
        if !responses.iter().flatten().all(|value| value.is_finite()) {
            return Err(ReactionError::NotFinite);
        }
        let found = self.coulomb(unknowns, &values, responses)?;
        for (response, load) in responses.iter().zip(&found.loads) {
            for (value, change) in values.iter_mut().zip(response) {
                *value = *value + *change * *load;
            }
        }
        if !values.iter().all(|value| value.is_finite()) {
            return Err(ReactionError::NotFinite);
        }
        let mut solution = self.solution(unknowns, &values, is_undetermined);
        self.add_friction(&mut solution, &found);
        Ok(solution)
    }

    /// What a unit of friction lacks on all bodies: the opposite of its own forces.
    pub(super) fn resisting(&self, acting: &ActingFriction<SeriesOf<S, N>>) -> Vec<SeriesOf<S, N>> {
        let own = &self.connections[acting.connection];
        let sense = SeriesOf::constant(acting.sense);
        self.flat_column(&match own.slide {
            None => Exertion::of_couple([own.on, own.by], along_axis(2).scale(sense)),
            Some(slide) => self.of_force(acting.connection, self.moved.along(slide).scale(sense)),
        })
    }

    /// The friction that belongs to the forces which it changes.
    fn coulomb(
        &self,
        unknowns: &[Unknown],
        values: &[SeriesOf<S, N>],
        responses: &[Vec<SeriesOf<S, N>>],
    ) -> Result<coulomb::FrictionLoads<N, S>, ReactionError> {
        let contact = |acting: &ActingFriction<SeriesOf<S, N>>| {
            // the weight of an unknown in the two parts of the force
            let weight = |unknown: &Unknown| match (*unknown, acting.friction) {
                (own, _) if own.connection() != Some(acting.connection) => [0.0; 2],
                (Unknown::Pin { axis: 0, .. }, Friction::Pin { coefficient, radius }) => [coefficient * radius, 0.0],
                (Unknown::Pin { .. }, Friction::Pin { coefficient, radius }) => [0.0, coefficient * radius],
                (Unknown::Normal { .. }, friction) => [friction.coefficient(), 0.0],
                (
                    Unknown::Moment { .. },
                    Friction::Slide {
                        coefficient,
                        length: Some(length),
                    },
                ) => [0.0, coefficient * 2.0 / length],
                _ => [0.0; 2],
            };
            let parts = |values: &[SeriesOf<S, N>]| {
                let mut parts = vec![SeriesOf::constant(0.0); 2];
                for (unknown, value) in unknowns.iter().zip(values) {
                    for (part, weight) in parts.iter_mut().zip(weight(unknown)) {
                        *part = *part + SeriesOf::constant(weight) * *value;
                    }
                }
                parts
            };
            Contact {
                // two forces N/2 ± M/L have the sizes |N| or 2 |M|/L together, the larger one of both
                measure: match acting.friction {
                    Friction::Pin { .. } => Measure::Length,
                    Friction::Slide { .. } => Measure::Largest,
                },
                bare: parts(values),
                changes: responses.iter().map(|response| parts(response)).collect(),
            }
        };
        let contacts: Vec<Contact<SeriesOf<S, N>>> = self.frictions.iter().map(contact).collect();
        let names = |contacts: Vec<usize>| {
            let names = contacts.into_iter().map(|contact| self.frictions[contact].connection);
            names
                .map(|connection| self.connections[connection].name.clone())
                .collect()
        };
        coulomb::solve(&contacts, self.parity).map_err(|error| match error {
            Unsolved::Locked { share, contacts } => ReactionError::Locked {
                share,
                reactions: names(contacts),
            },
            Unsolved::Slow { steps, contraction } => ReactionError::FrictionUnsolved { steps, contraction },
        })
    }

    /// Adds friction to the forces and moments of connections, which are what both bodies exert on each other.
    fn add_friction(&self, solution: &mut Solution<N, S>, found: &coulomb::FrictionLoads<N, S>) {
        solution.contraction = found.contraction;
        for (acting, load) in self.frictions.iter().zip(&found.loads) {
            let connection = acting.connection;
            let own = SeriesOf::constant(-acting.sense) * *load;
            solution.frictions[connection] = own;
            solution.heat = solution.heat - own * acting.rate;
            solution.begun_heat += load.real() * acting.speed.abs();
            match self.connections[connection].slide {
                None => solution.moments[connection].add(along_axis(2), Some(own)),
                Some(slide) => solution.forces[connection].add(self.moved.along(slide), Some(own)),
            }
        }
    }

    /// The connections whose forces equilibrium does not determine.
    fn undetermined_connections(&self, unknowns: &[Unknown], is_undetermined: &[bool]) -> Vec<usize> {
        let is_undetermined = |connection: &usize| {
            let mut own = unknowns.iter().zip(is_undetermined);
            own.any(|(unknown, is_undetermined)| *is_undetermined && unknown.connection() == Some(*connection))
        };
        (0..self.connections.len()).filter(is_undetermined).collect()
    }
}
