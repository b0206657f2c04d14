//! The link or slide that an input drives, found by the motion of the bodies when the input is moved a little.

use kin_core::prelude::*;
use kin_core::{Dimension, Outline};

use super::sweep::points_of;

/// The part of a mechanism that an input drives.
#[derive(Clone, Debug, PartialEq)]
pub enum Drive {
    /// A body rotates about a joint: the centre, a point of the body, and the direction in which the point moves.
    Rotation {
        /// The centre of rotation.
        centre: Space,
        /// A point of the body.
        arm: Space,
        /// The direction in which the point moves.
        forward: Space,
    },
    /// A body rotates relative to another about their joint: the centre, and a further joint of each body.
    Between {
        /// The joint.
        centre: Space,
        /// Points of the two bodies.
        arms: [Space; 2],
    },
    /// A joint is shifted along a line.
    Shift {
        /// The joint.
        joint: usize,
        /// The direction in which the joint moves.
        forward: Space,
    },
}

/// The step by which an input is moved.
const STEP: f64 = 1e-5;
/// The part of the step to which a motion has to agree.
const AGREEMENT: f64 = 1e-3;

/// The part that each input drives, where one can be found.
pub(super) fn drives<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: M::Inputs<f64>,
    unknowns: M::Unknowns<f64>,
) -> Vec<Drive> {
    let here = points_of(mechanism, inputs, unknowns);
    let mut drives = Vec::new();
    for (number, quantity) in M::DESCRIPTION.inputs.iter().enumerate() {
        let mut moved = inputs;
        if let Some(input) = moved.as_mut().get_mut(number) {
            *input += STEP;
        }
        let Ok(unknowns) = mechanism.position_near(moved, unknowns) else {
            continue;
        };
        let there = points_of(mechanism, moved, unknowns);
        let shifts: Vec<Space> = here
            .iter()
            .zip(&there)
            .map(|(&from, &to)| (to - from).scale(1.0 / STEP))
            .collect();
        let pair = Motions {
            outline: &M::OUTLINE,
            here: &here,
            shifts: &shifts,
        };
        drives.extend(match quantity.dimension {
            Dimension::Length => pair.shift(),
            Dimension::Angle | Dimension::Scalar => pair
                .rotation()
                .or_else(|| pair.floating_rotation())
                .or_else(|| pair.between()),
        });
    }
    drives
}

/// The velocities of joints and directions, per unit of an input.
struct Motions<'a> {
    outline: &'a Outline,
    here: &'a [Space],
    shifts: &'a [Space],
}

impl Motions<'_> {
    fn rotation(&self) -> Option<Drive> {
        for body in self.outline.bodies {
            let fixed: Vec<usize> = body
                .joints
                .iter()
                .copied()
                .filter(|&joint| self.shifts[joint].norm() < 1e-9)
                .collect();
            for &pivot in &fixed {
                for &joint in body.joints {
                    let arm = self.here[joint] - self.here[pivot];
                    // two fixed joints are an axis
                    let axis = fixed
                        .iter()
                        .find(|&&other| other != pivot)
                        .map(|&other| self.here[other] - self.here[pivot]);
                    let along = axis.map_or_else(Space::zero, |axis| axis.scale(arm.dot(axis) / axis.norm_squared()));
                    let arm = arm - along;
                    let forward = self.shifts[joint];
                    if arm.norm() > 1e-9 && (forward.norm() / arm.norm() - 1.0).abs() < AGREEMENT {
                        let centre = self.here[pivot] + along;
                        return Some(Drive::Rotation {
                            centre,
                            arm: self.here[joint],
                            forward,
                        });
                    }
                }
            }
        }
        None
    }

    /// The angular velocity of the line from one joint to another, in the plane.
    fn speed(&self, from: usize, to: usize) -> f64 {
        let (arm, shift) = (self.here[to] - self.here[from], self.shifts[to] - self.shifts[from]);
        (arm.x * shift.y - arm.y * shift.x) / arm.norm_squared()
    }

    /// A body without a fixed pivot that rotates as fast as the input.
    fn floating_rotation(&self) -> Option<Drive> {
        self.outline.bodies.iter().find_map(|body| {
            let [from, to, ..] = body.joints else { return None };
            let rotates = (self.speed(*from, *to).abs() - 1.0).abs() < AGREEMENT;
            rotates.then(|| Drive::Rotation {
                centre: self.here[*from],
                arm: self.here[*to],
                forward: self.shifts[*to] - self.shifts[*from],
            })
        })
    }

    fn between(&self) -> Option<Drive> {
        let bodies = self.outline.bodies;
        let speed = |from, to| self.speed(from, to);
        for (index, one) in bodies.iter().enumerate() {
            for other in &bodies[index + 1..] {
                let shared = one.joints.iter().copied().find(|joint| other.joints.contains(joint));
                let Some(shared) = shared else { continue };
                let end = |joints: &[usize]| joints.iter().copied().find(|&joint| joint != shared);
                if let (Some(first), Some(second)) = (end(one.joints), end(other.joints))
                    && ((speed(shared, first) - speed(shared, second)).abs() - 1.0).abs() < AGREEMENT
                {
                    let arms = [self.here[first], self.here[second]];
                    return Some(Drive::Between {
                        centre: self.here[shared],
                        arms,
                    });
                }
            }
        }
        None
    }

    fn shift(&self) -> Option<Drive> {
        let directions = &self.here[self.here.len() - self.outline.slides.len()..];
        for (slide, &direction) in self.outline.slides.iter().zip(directions) {
            let along = direction.scale(1.0 / direction.norm());
            if (self.shifts[slide.joint].dot(along).abs() - 1.0).abs() < AGREEMENT {
                let joint = slide.joint;
                return Some(Drive::Shift {
                    joint,
                    forward: along.scale(self.shifts[joint].dot(along)),
                });
            }
        }
        let count = self.here.len() - self.outline.slides.len();
        let shifts = self.shifts.iter().take(count).enumerate();
        let mut driven = shifts.filter(|(_, shift)| (shift.norm() - 1.0).abs() < AGREEMENT);
        let (joint, &forward) = driven.next()?;
        Some(Drive::Shift { joint, forward })
    }
}
