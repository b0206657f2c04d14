//! The forces that loads cause, and questions to them along a sweep.

use kin_core::extremes::{AskedQuantity, ExtremeKind, ExtremesError, QuantityAlong, QuantitySource};
use kin_core::linkage::{AnyLinkage, AnySweep};
use kin_core::load::NamedLoads;
use kin_core::reaction::{Friction, NamedReactions, ReactionError, ReactionPart};
use kin_core::sweep::SmoothDrive;

/// What is stated of joints and drives.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Stated {
    /// The friction of joints, by the names of their forces.
    pub(crate) frictions: Vec<(String, Friction)>,
    /// The bodies that drives turn or push, behind the names of their inputs.
    pub(crate) drives: Vec<(String, String)>,
    /// The signs of the rates with which inputs are about to move where all of them rest.
    pub(crate) senses: Vec<(String, f64)>,
}

impl Stated {
    /// The forces in joints.
    pub(crate) fn reactions<'m>(
        &self,
        linkage: &AnyLinkage<'m>,
        loads: &NamedLoads,
    ) -> Result<NamedReactions<'m>, Box<ReactionError>> {
        let mut reactions = linkage.reactions(loads)?;
        for (input, body) in &self.drives {
            reactions = reactions.driving(input, body)?;
        }
        let reactions = reactions.frictions(self.frictions.iter().cloned())?;
        if self.senses.is_empty() {
            return Ok(reactions);
        }
        let sense = |name: &str| {
            self.senses
                .iter()
                .find(|(own, _)| own == name)
                .map_or(0.0, |(_, sense)| *sense)
        };
        let inputs = linkage.description().inputs.iter();
        Ok(reactions.about_to_move(&inputs.map(|input| sense(input.name)).collect::<Vec<_>>()))
    }

    pub(crate) fn has_friction(&self) -> bool {
        !self.frictions.is_empty()
    }
}

/// A force that loads cause.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Force {
    /// The effort of the drive of an input.
    Effort(usize),
    /// The power of the drive of an input.
    #[cfg_attr(not(feature = "program"), expect(dead_code, reason = "pages have no powers"))]
    Power(usize),
    /// A part of the force in a joint.
    Reaction(String, ReactionPart),
    /// The power that friction turns into heat.
    #[cfg_attr(not(feature = "program"), expect(dead_code, reason = "pages have no heat"))]
    Heat,
}

/// What forces follow from.
#[derive(Clone, Copy)]
pub(crate) struct Causes<'c> {
    pub(crate) loads: &'c NamedLoads,
    /// The forces in joints, if they are known.
    pub(crate) reactions: Option<&'c NamedReactions<'c>>,
    /// Whether friction is stated. Then efforts depend on the forces in joints.
    pub(crate) has_friction: bool,
}

impl Causes<'_> {
    /// The answer to a question about a force or one of its rates; none if it depends on forces in joints that are not
    /// known.
    pub(crate) fn ask<D: SmoothDrive, Q: ForceQuestion>(
        self,
        force: &Force,
        order: usize,
        sweep: &AnySweep<'_, D>,
        question: &Q,
    ) -> Option<Q::Answer> {
        let Self {
            loads,
            reactions,
            has_friction,
        } = self;
        Some(match force {
            Force::Effort(input) if has_friction => {
                question.ask(&sweep.of_effort_with_friction(reactions?, *input, order))
            }
            Force::Effort(input) => question.ask(&sweep.of_effort(loads, *input, order)),
            Force::Power(input) if has_friction => question.ask(&sweep.of_power_with_friction(reactions?, *input)),
            Force::Power(input) => question.ask(&sweep.of_power(loads, *input)),
            Force::Reaction(name, part) => question.ask(&sweep.of_reaction(reactions?, name, *part, order)),
            Force::Heat => question.ask(&sweep.of_heat(reactions?, order)),
        })
    }
}

/// A question to a force along a sweep.
pub(crate) trait ForceQuestion {
    type Answer;

    fn ask<S: QuantitySource, Q: AskedQuantity<S>>(&self, quantity: &QuantityAlong<'_, S, Q>) -> Self::Answer;
}

/// An extreme value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reached {
    /// The value, or `None` if it grows beyond all bounds.
    pub(crate) value: Option<f64>,
    /// The place.
    pub(crate) at: f64,
    /// Whether the mechanism closes no further there.
    pub(crate) is_limit: bool,
}

/// What is the value that is largest in size?
pub(crate) struct OfPeak;

impl ForceQuestion for OfPeak {
    type Answer = Result<Reached, ExtremesError>;

    fn ask<S: QuantitySource, Q: AskedQuantity<S>>(&self, quantity: &QuantityAlong<'_, S, Q>) -> Self::Answer {
        let (value, at, is_limit) = match quantity.peak() {
            Ok(peak) => (Some(peak.value), peak.at, peak.kind == ExtremeKind::Limit),
            Err(ExtremesError::Unbounded { at }) => (None, at, false),
            Err(error) => return Err(error),
        };
        Ok(Reached { value, at, is_limit })
    }
}

/// What are the values in the rows?
pub(crate) struct OfRows;

impl ForceQuestion for OfRows {
    type Answer = Result<Vec<f64>, ExtremesError>;

    fn ask<S: QuantitySource, Q: AskedQuantity<S>>(&self, quantity: &QuantityAlong<'_, S, Q>) -> Self::Answer {
        quantity.column()
    }
}
