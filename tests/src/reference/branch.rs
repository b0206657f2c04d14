//! One assembly of a mechanism along its first input, and the places on it that are hard.

use kin_core::{Motion, Pose as _};

use crate::mechanisms::cases::{Inputs, ThroughSnap};

/// An assembly with the first input running free.
#[derive(Clone, Copy)]
pub(super) struct Branch<M: ThroughSnap> {
    pub(super) mechanism: M,
    pub(super) assembly: M::Assembly,
    pub(super) inputs: Inputs<M>,
}

/// The answer of the solver at a value of the input.
#[derive(Clone)]
struct Station {
    value: f64,
    /// Motions of the unknowns, none where the mechanism does not close.
    unknowns: Option<Vec<[f64; 5]>>,
}

impl<M: ThroughSnap> Branch<M> {
    /// The inputs with the first at a value.
    pub(super) fn at(&self, value: f64) -> Inputs<M> {
        let mut inputs = self.inputs;
        let mut motion = inputs[0].derivatives();
        motion[0] = value;
        inputs[0] = Motion::new(motion);
        inputs
    }

    /// Motions of the unknowns.
    pub(super) fn unknowns(&self, inputs: Inputs<M>) -> Option<Vec<[f64; 5]>> {
        let pose = self.mechanism.solve(inputs, self.assembly).ok()?;
        Some(
            pose.unknown_motions()
                .as_ref()
                .iter()
                .map(Motion::derivatives)
                .collect(),
        )
    }

    fn station(&self, value: f64) -> Station {
        Station {
            value,
            unknowns: self.unknowns(self.at(value)),
        }
    }

    /// Pairs of neighbours at values of the input.
    fn neighbours(&self, values: &[f64]) -> Vec<(Station, Station)> {
        let stations: Vec<Station> = values.iter().map(|value| self.station(*value)).collect();
        stations
            .windows(2)
            .map(|pair| (pair[0].clone(), pair[1].clone()))
            .collect()
    }

    /// The last values of the input at which the mechanism closes, each with the direction back inside.
    pub(super) fn limits(&self, values: &[f64]) -> Vec<(f64, f64)> {
        self.neighbours(values)
            .into_iter()
            .filter_map(|(one, other)| match (&one.unknowns, &other.unknowns) {
                (Some(_), None) => Some((one.value, other.value)),
                (None, Some(_)) => Some((other.value, one.value)),
                _ => None,
            })
            .map(|(inside, outside)| {
                let limit = halved(inside, outside, |value| self.station(value).unknowns.is_some());
                (limit, (inside - outside).signum())
            })
            .collect()
    }

    /// Values of the input at which an unknown turns back.
    pub(super) fn dead_points(&self, values: &[f64]) -> Vec<f64> {
        self.neighbours(values)
            .into_iter()
            .filter_map(|(one, other)| {
                let (before, after) = (one.unknowns?, other.unknowns?);
                let advances = |unknowns: &[[f64; 5]], index: usize| unknowns[index][1] > 0.0;
                let index = (0..before.len()).find(|index| advances(&before, *index) != advances(&after, *index))?;
                Some(halved(one.value, other.value, |value| {
                    let unknowns = self.station(value).unknowns;
                    unknowns.is_some_and(|unknowns| advances(&unknowns, index) == advances(&before, index))
                }))
            })
            .collect()
    }
}

/// The last number at which something holds, between one where it does and one where it does not.
fn halved(mut inside: f64, mut outside: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (inside + outside);
        if holds(middle) {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    inside
}
