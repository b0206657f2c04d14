//! Path, function and motion generation as sums of squares, over any mechanism with closed forms.
//!
//! An [`Objective`] holds targets for a point, for a point with an angle, or for one quantity. It also says which
//! numbers are sought, and between which bounds: dimensions, the placement of the mechanism in the plane, the input of
//! each target, offsets and scales. Its errors are differentiated by numbers that carry a derivative, so the partial
//! derivatives are exact but for rounding.
//!
//! ```
//! use kin_core::prelude::*;
//! use kin_search::objective::{Candidate, Objective};
//!
//! mechanism! {
//!     /// A four-bar linkage with a point of its coupler.
//!     struct Coupler { r1: Length, r2: Length, r3: Length, r4: Length, along: Length, beside: Length }
//!     input theta2: Angle;
//!     unknown theta3: Angle, theta4: Angle;
//!     r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
//!     output point: Point = r2 * cis(theta2) + vec2(along, beside) * cis(theta3);
//! }
//!
//! let objective = Objective::<Coupler>::path("point", [[0.4, 1.1], [0.0, 1.3], [-0.6, 1.2]])?
//!     .prescribed([0.5, 1.0, 1.5])?
//!     .bounds("r2", 0.1..=0.6)?
//!     .bounds("r3", 1.0..=3.0)?;
//! let linkage = Coupler { r1: 2.0, r2: 0.5, r3: 1.8, r4: 1.5, along: 0.4, beside: 0.9 };
//! let design = objective.design(&Candidate::new(linkage, Assembly::Open))?;
//! let misfit = objective.misfit(&design).expect("it closes at all targets");
//! assert!(misfit.largest < 1.0);
//! # Ok::<(), kin_search::objective::ObjectiveError>(())
//! ```

mod adjustable;
mod design;
mod error;
mod margins;
mod order;
mod quantity;
mod rows;
mod term;

pub use adjustable::Adjustable;
pub use design::{Candidate, Design, Misfit};
pub use error::ObjectiveError;
pub use term::{Sense, Term, Travel};

#[cfg(feature = "refine")]
pub(crate) use margins::{driver_turns, grashof};
#[cfg(feature = "refine")]
pub(crate) use quantity::Place;

use std::f64::consts::TAU;
use std::marker::PhantomData;
use std::ops::RangeInclusive;

use kin_core::{Dimension, Mechanism};

pub(crate) use quantity::Traced;

/// The numbers of a design that are no dimensions, in their order after the parameters. Their names are not those of
/// parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(usize)]
pub(crate) enum Part {
    /// The placement of the mechanism's own frame: x, y, and the angle by which it is turned.
    X,
    Y,
    Turn,
    /// The input of a target is `phase + pace * given`.
    Phase,
    Pace,
    /// The wanted value of a function is `offset + scale * given`.
    Offset,
    Scale,
}

pub(crate) const PARTS: usize = 7;
const PART_NAMES: [&str; PARTS] = [
    "placed_x",
    "placed_y",
    "placed_turn",
    "input_phase",
    "input_pace",
    "value_offset",
    "value_scale",
];

/// What is to be generated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Goal {
    Path,
    Motion,
    Function,
}

impl Goal {
    fn name(self) -> &'static str {
        match self {
            Self::Path => "a path",
            Self::Motion => "a motion",
            Self::Function => "a function",
        }
    }
}

/// The inputs of the targets.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Timing {
    /// Sought in a range, which may be a turn that closes in itself.
    Free { range: [f64; 2], is_turn: bool },
    /// Given, up to phase and pace.
    Prescribed(Vec<f64>),
}

/// Targets with weights, what is sought, and the terms beside them. The [module](self) has an example.
#[derive(Clone, Debug)]
pub struct Objective<M: Mechanism> {
    pub(crate) goal: Goal,
    pub(crate) traced: Vec<Traced>,
    /// For each target the value of each traced quantity.
    pub(crate) targets: Vec<Vec<f64>>,
    pub(crate) weights: Vec<f64>,
    /// The length that an error of one radian counts in a motion.
    pub(crate) radian: f64,
    pub(crate) parameters: Vec<Option<[f64; 2]>>,
    pub(crate) parts: [Adjustable; PARTS],
    pub(crate) timing: Timing,
    pub(crate) moving: usize,
    pub(crate) others: Vec<f64>,
    pub(crate) terms: Vec<Term>,
    pub(crate) travel: Travel,
    pub(crate) sense: Sense,
    mechanism: PhantomData<fn() -> M>,
}

impl<M: Mechanism<Scalar = f64>> Objective<M> {
    fn new(goal: Goal, traced: Vec<Traced>, targets: Vec<Vec<f64>>, timing: Timing) -> Result<Self, ObjectiveError> {
        let description = M::DESCRIPTION;
        if M::ASSEMBLY_COUNT == 0 {
            let coupled = description.blocks.iter().find(|block| block.unknowns.contains(','));
            let block = coupled
                .or(description.blocks.first())
                .map_or("", |block| block.unknowns);
            return Err(ObjectiveError::NoClosedForm { block });
        }
        if targets.is_empty() {
            return Err(ObjectiveError::NoTargets);
        }
        for value in targets.iter().flatten() {
            Adjustable::Fixed(*value).checked("target")?;
        }
        let [zero, one] = [0.0, 1.0].map(Adjustable::Fixed);
        Ok(Self {
            goal,
            traced,
            weights: vec![1.0; targets.len()],
            targets,
            radian: 1.0,
            parameters: vec![None; description.parameters.len()],
            parts: [zero, zero, zero, zero, one, zero, one],
            timing,
            moving: 0,
            others: vec![0.0; description.inputs.len()],
            terms: Vec::new(),
            travel: Travel::default(),
            sense: Sense::default(),
            mechanism: PhantomData,
        })
    }

    /// Path generation: a point of the plane, an output by its name, is to pass the targets in their order. The input
    /// of each target is sought over a full turn, unless [`prescribed`](Self::prescribed) gives it or
    /// [`within`](Self::within) a range.
    ///
    /// # Errors
    /// [`ObjectiveError`], if there is no such point, no target, or a block without closed form.
    pub fn path(point: &str, targets: impl IntoIterator<Item = [f64; 2]>) -> Result<Self, ObjectiveError> {
        let traced = Traced::point::<M>(point)?.to_vec();
        let targets = targets.into_iter().map(Vec::from).collect();
        Self::new(Goal::Path, traced, targets, Self::turn())
    }

    /// Motion generation: a body, by a point on it and an angle that turns with it, is to pass the targets x, y and
    /// angle (rad) in their order. An error of one radian counts as much as one of the length `radian`. Inputs as for
    /// [`path`](Self::path).
    ///
    /// # Errors
    /// As for [`path`](Self::path), and if the quantity `angle` is none.
    pub fn motion(
        point: &str,
        angle: &str,
        radian: f64,
        targets: impl IntoIterator<Item = [f64; 3]>,
    ) -> Result<Self, ObjectiveError> {
        let mut traced = Traced::point::<M>(point)?.to_vec();
        let turning = Traced::find::<M>(angle, "unknown or output")?;
        if turning.dimension != Dimension::Angle {
            return Err(ObjectiveError::WrongDimension {
                name: angle.to_owned(),
                wanted: "angle",
            });
        }
        traced.push(turning);
        Adjustable::Fixed(radian).checked("radian")?;
        let targets = targets.into_iter().map(Vec::from).collect();
        let objective = Self::new(Goal::Motion, traced, targets, Self::turn())?;
        Ok(Self { radian, ..objective })
    }

    /// Function generation: an unknown or a scalar output is to be a function of the input, given by pairs. A pair is
    /// an input and the value there, or numbers from which [`phase`](Self::phase), [`pace`](Self::pace),
    /// [`offset`](Self::offset) and [`scale`](Self::scale) make them: `value = offset + scale * y` at
    /// `input = phase + pace * x`. Angles are compared up to whole turns.
    ///
    /// # Errors
    /// [`ObjectiveError`], if there is no such quantity, no pair, or a block without closed form.
    pub fn function(quantity: &str, pairs: impl IntoIterator<Item = [f64; 2]>) -> Result<Self, ObjectiveError> {
        let traced = vec![Traced::find::<M>(quantity, "unknown or output")?];
        let (inputs, targets) = pairs.into_iter().map(|[x, y]| (x, vec![y])).unzip();
        Self::new(Goal::Function, traced, targets, Timing::Prescribed(Vec::new()))?.prescribed::<Vec<f64>>(inputs)
    }

    fn turn() -> Timing {
        Timing::Free {
            range: [0.0, TAU],
            is_turn: true,
        }
    }

    /// The inputs of the targets, one for each. With a free [`phase`](Self::phase) only their differences are given.
    ///
    /// # Errors
    /// [`ObjectiveError::WrongCount`], or one of them is not finite.
    pub fn prescribed<I: IntoIterator<Item = f64>>(mut self, inputs: I) -> Result<Self, ObjectiveError> {
        let inputs: Vec<f64> = inputs.into_iter().collect();
        self.same_count("inputs", inputs.len())?;
        for input in &inputs {
            Adjustable::Fixed(*input).checked("input")?;
        }
        self.timing = Timing::Prescribed(inputs);
        Ok(self)
    }

    /// The range in which the inputs of the targets are sought.
    ///
    /// # Errors
    /// [`ObjectiveError::NotInOrder`], or [`ObjectiveError::NoSuchPart`] if the inputs are given.
    pub fn within(mut self, range: RangeInclusive<f64>) -> Result<Self, ObjectiveError> {
        let range = [*range.start(), *range.end()];
        Adjustable::Free(range).checked("range of the input")?;
        if let Timing::Prescribed(_) = self.timing {
            return Err(ObjectiveError::NoSuchPart {
                part: "range of inputs",
                goal: "an objective whose inputs are given",
            });
        }
        self.timing = Timing::Free { range, is_turn: false };
        Ok(self)
    }

    fn same_count(&self, list: &'static str, given: usize) -> Result<(), ObjectiveError> {
        let targets = self.targets.len();
        if given == targets {
            Ok(())
        } else {
            Err(ObjectiveError::WrongCount {
                list,
                given,
                wanted: targets,
            })
        }
    }

    /// Lets a dimension change between bounds. All others keep the values of the candidate.
    ///
    /// # Errors
    /// [`ObjectiveError::NoSuchQuantity`], or the bounds are not in order.
    pub fn bounds(mut self, parameter: &str, range: RangeInclusive<f64>) -> Result<Self, ObjectiveError> {
        let index = quantity::index(M::DESCRIPTION.parameters, parameter, "parameter")?;
        let bounds = [*range.start(), *range.end()];
        Adjustable::Free(bounds).checked(parameter)?;
        self.parameters[index] = Some(bounds);
        Ok(self)
    }

    /// Where the mechanism stands in the plane of the targets: the place of the origin of its own frame, and the angle
    /// (rad) by which that frame is turned. Each is a number, or bounds between which it is sought. Without this call
    /// the two frames are the same.
    ///
    /// # Errors
    /// [`ObjectiveError::NoSuchPart`] for a function, or bounds that are not in order.
    pub fn placement(
        mut self,
        x: impl Into<Adjustable>,
        y: impl Into<Adjustable>,
        turn: impl Into<Adjustable>,
    ) -> Result<Self, ObjectiveError> {
        if self.goal == Goal::Function {
            return Err(ObjectiveError::NoSuchPart {
                part: "placement",
                goal: self.goal.name(),
            });
        }
        self.set(Part::X, x.into())?;
        self.set(Part::Y, y.into())?;
        self.set(Part::Turn, turn.into())?;
        Ok(self)
    }

    fn set(&mut self, part: Part, value: Adjustable) -> Result<(), ObjectiveError> {
        self.parts[part as usize] = value.checked(PART_NAMES[part as usize])?;
        Ok(())
    }

    /// The number that is added to the given inputs.
    ///
    /// # Errors
    /// [`ObjectiveError::NoSuchPart`] if the inputs are not given, or bounds that are not in order.
    pub fn phase(mut self, phase: impl Into<Adjustable>) -> Result<Self, ObjectiveError> {
        self.given_inputs("phase")?;
        self.set(Part::Phase, phase.into())?;
        Ok(self)
    }

    /// The number by which the given inputs are multiplied.
    ///
    /// # Errors
    /// As for [`phase`](Self::phase).
    pub fn pace(mut self, pace: impl Into<Adjustable>) -> Result<Self, ObjectiveError> {
        self.given_inputs("pace")?;
        self.set(Part::Pace, pace.into())?;
        Ok(self)
    }

    fn given_inputs(&self, part: &'static str) -> Result<(), ObjectiveError> {
        match self.timing {
            Timing::Prescribed(_) => Ok(()),
            Timing::Free { .. } => Err(ObjectiveError::NoSuchPart {
                part,
                goal: "an objective whose inputs are sought",
            }),
        }
    }

    /// The number that is added to the values of a function.
    ///
    /// # Errors
    /// [`ObjectiveError::NoSuchPart`] for other goals, or bounds that are not in order.
    pub fn offset(mut self, offset: impl Into<Adjustable>) -> Result<Self, ObjectiveError> {
        self.function_only("offset")?;
        self.set(Part::Offset, offset.into())?;
        Ok(self)
    }

    /// The number by which the values of a function are multiplied.
    ///
    /// # Errors
    /// As for [`offset`](Self::offset).
    pub fn scale(mut self, scale: impl Into<Adjustable>) -> Result<Self, ObjectiveError> {
        self.function_only("scale")?;
        self.set(Part::Scale, scale.into())?;
        Ok(self)
    }

    fn function_only(&self, part: &'static str) -> Result<(), ObjectiveError> {
        if self.goal == Goal::Function {
            Ok(())
        } else {
            Err(ObjectiveError::NoSuchPart {
                part,
                goal: self.goal.name(),
            })
        }
    }

    /// The weight of each target, by which its errors are multiplied; otherwise 1.
    ///
    /// # Errors
    /// [`ObjectiveError::WrongCount`], or one of them is not finite.
    pub fn weights(mut self, weights: impl IntoIterator<Item = f64>) -> Result<Self, ObjectiveError> {
        let weights: Vec<f64> = weights.into_iter().collect();
        self.same_count("weights", weights.len())?;
        for weight in &weights {
            Adjustable::Fixed(*weight).checked("weight")?;
        }
        self.weights = weights;
        Ok(self)
    }

    /// Adds a term beside the targets.
    #[must_use]
    pub fn term(mut self, term: Term) -> Self {
        self.terms.push(term);
        self
    }

    /// Which part of the motion must close and keep to the terms; otherwise from the first target to the last.
    #[must_use]
    pub fn travel(mut self, travel: Travel) -> Self {
        self.travel = travel;
        self
    }

    /// In which direction of the input the targets follow each other; otherwise in either.
    #[must_use]
    pub fn sense(mut self, sense: Sense) -> Self {
        self.sense = sense;
        self
    }

    /// The input that moves; otherwise the first one.
    ///
    /// # Errors
    /// [`ObjectiveError::NoSuchQuantity`].
    pub fn moving(mut self, input: &str) -> Result<Self, ObjectiveError> {
        self.moving = quantity::index(M::DESCRIPTION.inputs, input, "input")?;
        Ok(self)
    }

    /// Where the other inputs stand; otherwise at zero. The entry of the moving input is not looked at.
    #[must_use]
    pub fn at(mut self, inputs: M::Inputs<f64>) -> Self {
        self.others = inputs.as_ref().to_vec();
        self
    }

    /// Where one of the other inputs stands; otherwise at zero.
    ///
    /// # Errors
    /// [`ObjectiveError::NoSuchQuantity`], or a number that is not finite.
    pub fn standing(mut self, input: &str, value: f64) -> Result<Self, ObjectiveError> {
        let index = quantity::index(M::DESCRIPTION.inputs, input, "input")?;
        Adjustable::Fixed(value).checked(input)?;
        self.others[index] = value;
        Ok(self)
    }

    /// The number of targets.
    #[must_use]
    pub fn target_count(&self) -> usize {
        self.targets.len()
    }

    /// The names of the quantities that are compared with the targets.
    pub fn quantities(&self) -> impl Iterator<Item = &'static str> {
        self.traced.iter().map(|traced| traced.name)
    }
}
