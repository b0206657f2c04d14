//! The edge of where a mechanism closes, to the last bit: the hardest place for everything.

use kin_core::Dimension;

use super::{Campaign, Solved};
use crate::draw::choice;
use crate::topology::Problem;
use kin_tests::random::Random;

/// Halvings until two numbers are neighbours, and some more.
const HALVINGS: usize = 80;

impl Campaign {
    /// Poses within a few units in the last place of an input where the mechanism ceases to close, if there is such a
    /// place.
    pub(super) fn edges(&mut self, solved: &Solved, random: &mut Random) -> Vec<Solved> {
        let (Ok(_), false) = (&solved.result, solved.problem.inputs.is_empty()) else {
            return Vec::new();
        };
        let (topology, assembly) = (self.topology, solved.assembly.clone());
        let place = choice(random, solved.problem.inputs.len());
        let with = |value: f64| {
            let mut problem = solved.problem.clone();
            problem.inputs[place][0] = value;
            problem
        };
        let closes = |value: f64| topology.position(&with(value), &assembly).is_ok();
        let mut inside = solved.problem.inputs[place][0];
        let is_angle = topology.description().inputs[place].dimension == Dimension::Angle;
        let beyond = (0..8)
            .map(|_| {
                if is_angle {
                    inside + random.between(-3.2, 3.2)
                } else {
                    inside * random.between(-4.0, 4.0)
                }
            })
            .find(|value| !closes(*value));
        let Some(mut outside) = beyond else {
            return Vec::new();
        };
        for _ in 0..HALVINGS {
            let middle = inside + (outside - inside) / 2.0;
            if closes(middle) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        let problems: Vec<Problem> = [
            inside.next_down().next_down(),
            inside.next_down(),
            inside,
            inside.next_up(),
            inside.next_up().next_up(),
        ]
        .into_iter()
        .map(with)
        .collect();
        problems
            .iter()
            .map(|problem| self.solve(problem, assembly.clone()))
            .collect()
    }
}
