//! Poses to be held against the reference: scattered ones, and hard ones.

use std::f64::consts::{FRAC_PI_2, PI};

use kin_core::{Dimension, Motion, Quantity, Row};

use super::branch::Branch;
use crate::mechanisms::cases::{Case, Inputs, ThroughSnap};
use crate::random::Random;

/// Poses scattered over the range of the inputs.
const SCATTERED: usize = 12;
/// Poses of a mechanism of another size.
const SCALED: usize = 6;
/// Steps in which the first input's range is searched.
const STEPS: i32 = 48;
/// Assemblies in which it is searched.
const BRANCHES: usize = 3;
/// Limit positions and dead points at most.
const LIMITS: usize = 3;
const DEAD_POINTS: usize = 4;

/// The difficulty of a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Nothing.
    Scattered,
    /// The driving angle is zero, almost zero, or whole right angles.
    RightAngle,
    /// All lengths are a million times as large.
    Huge,
    /// All lengths are a millionth.
    Tiny,
    /// A limit position is near.
    NearLimit,
    /// An unknown stands still.
    DeadPoint,
}

/// A pose as the engine solves it.
#[derive(Clone)]
pub struct Pose<M: ThroughSnap> {
    /// Its difficulty.
    pub kind: Kind,
    /// The mechanism.
    pub mechanism: M,
    /// Its inputs.
    pub inputs: Inputs<M>,
    /// Which of several solutions.
    pub assembly: M::Assembly,
    /// Motions of the unknowns.
    pub unknowns: Vec<[f64; 5]>,
}

/// Scattered and hard poses of a mechanism.
#[must_use]
pub fn poses<M: ThroughSnap>(case: &Case) -> Vec<Pose<M>> {
    let mut search = Search {
        case: *case,
        random: Random::new(M::DESCRIPTION.name.bytes().map(u64::from).sum()),
        found: Vec::new(),
    };
    search.scattered();
    search.right_angles();
    search.scaled(Kind::Huge, 1e6);
    search.scaled(Kind::Tiny, 1e-6);
    search.hard_places();
    search.found
}

struct Search<M: ThroughSnap> {
    case: Case,
    random: Random,
    found: Vec<Pose<M>>,
}

impl<M: ThroughSnap> Search<M> {
    /// An assembly that closes: named ones are tried from a number on, others by random guesses.
    fn branch(&mut self, mechanism: M, inputs: Inputs<M>, from: usize) -> Option<Branch<M>> {
        let count = M::ASSEMBLY_COUNT;
        let values = M::Inputs::from_fn(|index| inputs[index].value());
        let largest = |largest: f64, value: &f64| largest.max(value.abs());
        let length = self.case.parameters.iter().fold(0.0, largest);
        (0..count.max(20)).find_map(|index| {
            let assembly = if count > 0 {
                M::assembly((from + index) % count)?
            } else {
                let guess = M::Unknowns::from_fn(|index| match M::DESCRIPTION.unknowns[index].dimension {
                    Dimension::Length => self.random.between(-length, length),
                    _ => self.random.between(-PI, PI),
                });
                let position = mechanism.position_near(values, guess).ok()?;
                mechanism.assembly_at(values, position)
            };
            let branch = Branch {
                mechanism,
                assembly,
                inputs,
            };
            branch.unknowns(inputs).map(|_| branch)
        })
    }

    /// Adds the pose of a branch, if it closes there.
    fn add(&mut self, kind: Kind, branch: &Branch<M>, inputs: Inputs<M>) -> bool {
        let Some(unknowns) = branch.unknowns(inputs) else {
            return false;
        };
        self.found.push(Pose {
            kind,
            mechanism: branch.mechanism,
            inputs,
            assembly: branch.assembly,
            unknowns,
        });
        true
    }

    fn inputs(&mut self) -> Inputs<M> {
        let fraction = self.random.between(0.0, 1.0);
        self.case.inputs::<M>(fraction, &mut self.random)
    }

    fn scattered(&mut self) {
        let mut added = 0;
        for attempt in 0..4 * SCATTERED {
            let mechanism = self.case.varied(&mut self.random);
            let inputs = self.inputs();
            if let Some(branch) = self.branch(mechanism, inputs, attempt) {
                added += usize::from(self.add(Kind::Scattered, &branch, inputs));
            }
            if added == SCATTERED {
                break;
            }
        }
    }

    fn right_angles(&mut self) {
        if M::DESCRIPTION.inputs[0].dimension != Dimension::Angle {
            return;
        }
        for (index, angle) in [0.0, 1e-9, FRAC_PI_2, -FRAC_PI_2, PI].into_iter().enumerate() {
            let mut inputs = self.inputs();
            inputs[0] = Motion::new(self.random.motion(angle));
            if let Some(branch) = self.branch(self.case.mechanism(), inputs, index) {
                self.add(Kind::RightAngle, &branch, inputs);
            }
        }
    }

    /// The scattered poses in another size.
    fn scaled(&mut self, kind: Kind, scale: f64) {
        let scale = |quantity: Quantity| {
            if quantity.dimension == Dimension::Length {
                scale
            } else {
                1.0
            }
        };
        let usual: Vec<Pose<M>> = self.found.iter().take(SCALED).cloned().collect();
        for usual in usual {
            let parameters = usual.mechanism.parameters();
            let mechanism = M::from_parameters(M::Parameters::from_fn(|index| {
                parameters[index] * scale(M::DESCRIPTION.parameters[index])
            }));
            let inputs: Inputs<M> = M::Inputs::from_fn(|index| {
                usual.inputs[index].map(|value| value * scale(M::DESCRIPTION.inputs[index]))
            });
            let assembly = if M::ASSEMBLY_COUNT > 0 {
                usual.assembly
            } else {
                let near =
                    M::Unknowns::from_fn(|index| usual.unknowns[index][0] * scale(M::DESCRIPTION.unknowns[index]));
                mechanism.assembly_at(M::Inputs::from_fn(|index| inputs[index].value()), near)
            };
            let branch = Branch {
                mechanism,
                assembly,
                inputs,
            };
            self.add(kind, &branch, inputs);
        }
    }

    /// Limit positions and dead points, along the first input's range and a quarter beyond either end.
    fn hard_places(&mut self) {
        let (low, high) = self.case.inputs[0];
        let values: Vec<f64> = (0..=STEPS)
            .map(|step| low + (high - low) * (1.5 * f64::from(step) / f64::from(STEPS) - 0.25))
            .collect();
        let (mut limits, mut dead_points) = (0, 0);
        for from in 0..BRANCHES {
            let inputs = self.inputs();
            let Some(branch) = self.branch(self.case.mechanism(), inputs, from) else {
                continue;
            };
            for (limit, inwards) in branch.limits(&values).into_iter().take(LIMITS - limits) {
                limits += 1;
                for distance in [1e-2, 1e-4, 1e-6, 1e-8] {
                    self.add(Kind::NearLimit, &branch, branch.at(limit + distance * inwards));
                }
            }
            for value in branch.dead_points(&values).into_iter().take(DEAD_POINTS - dead_points) {
                dead_points += 1;
                self.add(Kind::DeadPoint, &branch, branch.at(value));
            }
        }
    }
}
