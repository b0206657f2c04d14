//! A track ends where the solver finds the same assembly, or at a place where something is singular, after so many
//! steps.

use std::f64::consts::TAU;

use kin_core::any::AssemblyChoice;
use kin_core::{Dimension, Failure, TrackError, TrackLimit};
use kin_tests::counting::Calls;

use super::pose::ALLOWED;
use super::{Campaign, Solved, most_condition};
use crate::draw::Family;
use crate::topology::at_rest;
use crate::unit::{determinants, units};
use kin_tests::random::Random;

/// More than this one track must not ask for, however extreme the proportions.
const MOST: Calls = Calls {
    solutions: 1_000,
    closures: 50_000,
};

/// The part of the way by which two places are on either side of another one.
const ASIDE: f64 = 1e-9;

/// A pole is where an unknown has grown by this factor.
const FAR: f64 = 1e3;

/// A determinant at an obstacle is smaller than this part of what the terms of the equations make of it: the unknowns
/// are known to the root of ε there.
const SINGULAR: f64 = 1e-5;

impl Campaign {
    /// Tracks a pose to inputs at random.
    pub(super) fn track(&mut self, solved: &Solved, family: Family, random: &mut Random) {
        let Ok(pose) = &solved.result else {
            return;
        };
        let description = self.topology.description();
        let start = pose.found.position();
        let mut to: Vec<f64> = solved.problem.values();
        for (value, quantity) in to.iter_mut().zip(description.inputs) {
            if quantity.dimension == Dimension::Angle {
                *value += random.between(-TAU, TAU);
            } else {
                *value *= random.between(0.5, 1.5);
            }
        }
        self.current = (solved.problem.clone(), solved.assembly.clone());
        let (ending, steps) = self.topology.track(&solved.problem, &start, &to);
        self.tally.end(&ending, steps);
        if steps.solutions > MOST.solutions || steps.closures > MOST.closures {
            self.find_track("steps", &format!("{steps:?}"), solved, &to);
        }
        match &ending {
            Ok(end) => self.has_arrived(solved, &to, end),
            Err(TrackError::TurningPoint(place) | TrackError::ChangePoint(place)) => {
                let rates: Vec<_> = place.unknowns.iter().copied().map(at_rest).collect();
                let determinants = determinants(&self.topology, &solved.problem.at(&place.inputs), &rates);
                let is_singular = determinants.iter().any(|determinant| determinant.abs() <= SINGULAR);
                if !is_on_the_way(place) || (!is_singular && family != Family::Spread) {
                    self.find_track(
                        "obstacle",
                        &format!("{ending:?}, determinants {determinants:?}"),
                        solved,
                        &to,
                    );
                }
            }
            Err(TrackError::Pole(place)) => {
                let is_far = |(before, after): (&f64, &f64)| after.abs() > FAR * before.abs();
                if !is_on_the_way(place) || !start.iter().zip(&place.unknowns).any(is_far) {
                    self.find_track("pole", &format!("{ending:?}"), solved, &to);
                }
            }
            // The domain of a function, or the range of an unknown, may end on the way.
            Err(TrackError::Failed(error))
                if matches!(
                    error.failure,
                    Failure::OutsideDomain { .. } | Failure::OutOfRange { .. }
                ) => {}
            Err(TrackError::Failed(error)) => {
                if family == Family::Ordinary {
                    self.find_track("track failed", &error.to_string(), solved, &to);
                }
            }
            Err(TrackError::Lost(halt)) => {
                if family == Family::Ordinary && !self.jumps(solved, &halt.inputs, &to) {
                    self.find_track("track lost", &format!("{ending:?}"), solved, &to);
                }
            }
            Err(_) => self.find_track("steps", &format!("{ending:?}"), solved, &to),
        }
    }

    /// Whether the position on one side of a place is another one than that on the other, as of the angle of `atan2`.
    fn jumps(&self, solved: &Solved, there: &[f64], to: &[f64]) -> bool {
        let from = solved.problem.values();
        let position = |step: f64| {
            let way = there.iter().zip(from.iter().zip(to));
            let inputs: Vec<f64> = way.map(|(there, (from, to))| there + step * (to - from)).collect();
            self.topology
                .position(&solved.problem.at(&inputs), &solved.assembly)
                .ok()
        };
        let (Some(before), Some(after)) = (position(-ASIDE), position(ASIDE)) else {
            return false;
        };
        before
            .iter()
            .zip(after)
            .any(|(before, after)| (before - after).abs() > 1.0)
    }

    fn has_arrived(&mut self, solved: &Solved, to: &[f64], end: &[f64]) {
        let problem = solved.problem.at(to);
        let rates: Vec<_> = end.iter().copied().map(at_rest).collect();
        let units =
            units(&self.topology, &problem, &rates).filter(|units| units.condition <= most_condition(f64::EPSILON));
        let Some(units) = units else {
            return;
        };
        for (correction, condition) in units.corrections.iter().zip(&units.conditions) {
            if correction[0] > ALLOWED * f64::EPSILON * condition[0] {
                self.find_track(
                    "track",
                    &format!("{end:?} does not close: {:e}", correction[0]),
                    solved,
                    to,
                );
            }
        }
        match &solved.assembly {
            AssemblyChoice::Index(_) => match self.topology.position(&problem, &solved.assembly) {
                Ok(direct) => {
                    // Carried round by whole turns; what depends on the turn, as a rack or a gear does, is elsewhere
                    // then, and nothing but the assembly is known.
                    let quantities = self.topology.description().unknowns;
                    let pairs = || end.iter().zip(&direct).zip(quantities);
                    let turned = |own: f64, other: f64| TAU * ((own - other) / TAU).round();
                    let is_turned = pairs().any(|((own, other), quantity)| {
                        quantity.dimension == Dimension::Angle && turned(*own, *other) != 0.0
                    });
                    if is_turned {
                        let told = self.topology.assembly_at(&problem, end);
                        if solved.assembly != told.map_or(AssemblyChoice::Near(Vec::new()), AssemblyChoice::Index) {
                            self.find_track("track", &format!("{end:?} is of assembly {told:?}"), solved, to);
                        }
                        return;
                    }
                    for (((own, other), _), condition) in pairs().zip(&units.conditions) {
                        if (own - other).abs() > ALLOWED * f64::EPSILON * condition[0] {
                            let what = format!("{end:?} for {direct:?}, condition {:e}", units.condition);
                            self.find_track("track", &what, solved, to);
                            return;
                        }
                    }
                }
                Err(error) => self.find_track("track", &format!("{end:?}, where solve says {error}"), solved, to),
            },
            AssemblyChoice::Near(_) => {
                let Ok(pose) = &solved.result else {
                    return;
                };
                let before = determinants(&self.topology, &solved.problem, &pose.found.unknowns);
                for (before, after) in before.iter().zip(&units.determinants) {
                    if before * after < 0.0 {
                        let what = format!("{end:?}: a determinant of {before:e} becomes {after:e}");
                        self.find_track("track", &what, solved, to);
                    }
                }
            }
        }
    }

    fn find_track(&mut self, check: &'static str, what: &str, solved: &Solved, to: &[f64]) {
        let start = solved
            .result
            .as_ref()
            .map(|pose| pose.found.position())
            .unwrap_or_default();
        let what = format!("from {start:?} to inputs {to:?}: {what}");
        self.find(check, what, &solved.problem, &solved.assembly);
    }
}

fn is_on_the_way(place: &TrackLimit<Vec<f64>, Vec<f64>>) -> bool {
    (0.0..=1.0).contains(&place.fraction) && place.unknowns.iter().all(|value| value.is_finite())
}
