//! Path, function and motion generation, and measured rows, as sums of squares over any mechanism.

use std::f64::consts::TAU;
use std::ops::RangeInclusive;
use std::sync::Arc;

use kin_core::Dimension;
use kin_core::any::Description;

use crate::adjustable::Adjustable;
use crate::error::ObjectiveError;
use crate::functions::{Change, FitFunctions};
use crate::quantity::{self, Traced};
use crate::term::{CustomTerm, Sense, Term, TermAt, Travel};

/// The numbers of a design that are no dimensions, in their order after the parameters. Their names differ from those
/// of parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(usize)]
pub(crate) enum Part {
    /// The placement of the mechanism's frame: x, y, and its angle of rotation.
    X,
    Y,
    Rotation,
    /// The input of a target is `phase + pace * given`.
    Phase,
    Pace,
    /// The wanted value of a function is `offset + scale * given`.
    Offset,
    Scale,
}

pub(crate) const PARTS: usize = 7;
pub(crate) const PART_NAMES: [&str; PARTS] = [
    "placed_x",
    "placed_y",
    "placed_turn",
    "input_phase",
    "input_pace",
    "value_offset",
    "value_scale",
];

/// The goal of the synthesis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Goal {
    Path,
    Motion,
    Function,
    /// Measured rows, in no order.
    Rows,
}

impl Goal {
    fn name(self) -> &'static str {
        match self {
            Self::Path => "a path",
            Self::Motion => "a motion",
            Self::Function => "a function",
            Self::Rows => "an objective of measured rows",
        }
    }
}

/// The values to be met at one input.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Target {
    /// The value of each traced quantity, where it is given.
    pub(crate) values: Vec<Option<f64>>,
    pub(crate) weight: f64,
    /// The moving input, up to phase and pace; it is sought where it is not given.
    pub(crate) input: Option<f64>,
    /// All inputs, where the other inputs do not stand as the objective gives them.
    pub(crate) others: Option<Vec<f64>>,
    /// The index among the inputs that are sought.
    pub(crate) sought: Option<usize>,
}

/// The range in which inputs of targets are sought, which may be a full revolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct InputRange {
    pub(crate) ends: [f64; 2],
    pub(crate) is_revolution: bool,
}

/// Targets with weights, the numbers that are sought, and the terms beside them. The [crate](crate) has an example.
///
/// The numbers that are sought have bounds: dimensions, the placement of the mechanism in the plane, the input of each
/// target, offsets and scales. The errors are evaluated with numbers that carry a derivative, so their partial
/// derivatives are exact but for rounding.
#[derive(Clone, Debug)]
pub struct Objective {
    pub(crate) functions: &'static dyn FitFunctions,
    pub(crate) goal: Goal,
    pub(crate) traced: Vec<Traced>,
    pub(crate) targets: Vec<Target>,
    pub(crate) parameters: Vec<Option<[f64; 2]>>,
    pub(crate) parts: [Adjustable; PARTS],
    pub(crate) range: InputRange,
    pub(crate) moving: usize,
    pub(crate) others: Vec<f64>,
    pub(crate) terms: Vec<Term>,
    pub(crate) custom_terms: Vec<CustomTerm>,
    pub(crate) travel: Travel,
    pub(crate) sense: Sense,
}

impl Objective {
    pub(crate) fn new(
        functions: &'static dyn FitFunctions,
        goal: Goal,
        traced: Vec<Traced>,
        targets: Vec<Target>,
    ) -> Result<Self, ObjectiveError> {
        let description = functions.description();
        // rows are reached from a known position; every other goal needs an assembly that holds for all dimensions
        if goal != Goal::Rows && functions.assembly_count() == 0 {
            let coupled = description.blocks.iter().find(|block| block.unknowns.contains(','));
            let block = coupled
                .or(description.blocks.first())
                .map_or("", |block| block.unknowns);
            return Err(ObjectiveError::NoClosedForm { block });
        }
        if targets.is_empty() {
            return Err(ObjectiveError::NoTargets);
        }
        for target in &targets {
            for value in target.values.iter().copied().flatten() {
                Adjustable::Fixed(value).checked("target")?;
            }
        }
        let [zero, one] = [0.0, 1.0].map(Adjustable::Fixed);
        Ok(Self {
            functions,
            goal,
            traced,
            targets,
            parameters: vec![None; description.parameters.len()],
            parts: [zero, zero, zero, zero, one, zero, one],
            range: InputRange {
                ends: [0.0, TAU],
                is_revolution: true,
            },
            moving: 0,
            others: vec![0.0; description.inputs.len()],
            terms: Vec::new(),
            custom_terms: Vec::new(),
            travel: Travel::default(),
            sense: Sense::default(),
        }
        .numbered())
    }

    /// Counts the inputs that are sought.
    fn numbered(mut self) -> Self {
        let mut count = 0..;
        for target in &mut self.targets {
            target.sought = if target.input.is_none() { count.next() } else { None };
        }
        self
    }

    pub(crate) fn description(&self) -> &'static Description<'static> {
        self.functions.description()
    }

    /// Path generation: a point of the plane, an output by its name, is to pass the targets in their order. The input
    /// of each target is sought over a full revolution, unless [`prescribed`](Self::prescribed) gives it or
    /// [`within`](Self::within) a range.
    ///
    /// # Errors
    /// [`ObjectiveError`], if there is no such point, no target, or a block without closed form.
    pub fn path(
        functions: &'static dyn FitFunctions,
        point: &str,
        targets: impl IntoIterator<Item = [f64; 2]>,
    ) -> Result<Self, ObjectiveError> {
        let traced = Traced::point(functions.description(), point)?.to_vec();
        Self::new(functions, Goal::Path, traced, plain(targets))
    }

    /// Motion generation: a body, by a point on it and an angle that turns with it, is to pass the targets x, y and
    /// angle (rad) in their order. An error of one radian counts as much as an error of the length `radian`. Inputs are
    /// as for [`path`](Self::path).
    ///
    /// # Errors
    /// As for [`path`](Self::path), and if the quantity `angle` is no angle.
    pub fn motion(
        functions: &'static dyn FitFunctions,
        point: &str,
        angle: &str,
        radian: f64,
        targets: impl IntoIterator<Item = [f64; 3]>,
    ) -> Result<Self, ObjectiveError> {
        let mut traced = Traced::point(functions.description(), point)?.to_vec();
        let turning = Traced::find(functions.description(), angle, "unknown or output")?;
        if turning.dimension != Dimension::Angle {
            return Err(ObjectiveError::WrongDimension {
                name: angle.to_owned(),
                wanted: "angle",
            });
        }
        Adjustable::Fixed(radian).checked("radian")?;
        traced.push(Traced {
            unit: radian,
            ..turning
        });
        Self::new(functions, Goal::Motion, traced, plain(targets))
    }

    /// Function generation: an unknown or a scalar output is to be a function of the input, given by pairs. A pair is
    /// an input and the value there, or numbers from which [`phase`](Self::phase), [`pace`](Self::pace),
    /// [`offset`](Self::offset) and [`scale`](Self::scale) make them: `value = offset + scale * y` at `input = phase +
    /// pace * x`. Angles are compared up to whole revolutions.
    ///
    /// # Errors
    /// [`ObjectiveError`], if there is no such quantity, no pair, or a block without closed form.
    pub fn function(
        functions: &'static dyn FitFunctions,
        quantity: &str,
        pairs: impl IntoIterator<Item = [f64; 2]>,
    ) -> Result<Self, ObjectiveError> {
        let traced = vec![Traced::find(functions.description(), quantity, "unknown or output")?];
        let (inputs, values): (Vec<f64>, Vec<[f64; 1]>) = pairs.into_iter().map(|[x, y]| (x, [y])).unzip();
        Self::new(functions, Goal::Function, traced, plain(values))?.prescribed(inputs)
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
        for (target, input) in self.targets.iter_mut().zip(inputs) {
            target.input = Some(input);
        }
        Ok(self.numbered())
    }

    /// The range in which the inputs of the targets are sought.
    ///
    /// # Errors
    /// [`ObjectiveError::NotInOrder`], or [`ObjectiveError::NoSuchPart`] if the inputs are given.
    pub fn within(mut self, range: RangeInclusive<f64>) -> Result<Self, ObjectiveError> {
        let range = [*range.start(), *range.end()];
        Adjustable::Free(range).checked("range of the input")?;
        if !self.has_free_inputs() {
            return Err(ObjectiveError::NoSuchPart {
                part: "range of inputs",
                goal: "an objective whose inputs are given",
            });
        }
        self.range = InputRange {
            ends: range,
            is_revolution: false,
        };
        Ok(self)
    }

    /// Whether the input of a target is sought.
    pub(crate) fn has_free_inputs(&self) -> bool {
        self.targets.iter().any(|target| target.input.is_none())
    }

    pub(crate) fn same_count(&self, list: &'static str, given: usize) -> Result<(), ObjectiveError> {
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

    /// Lets a dimension change between bounds. Other dimensions keep the values of the candidate.
    ///
    /// # Errors
    /// [`ObjectiveError::NoSuchQuantity`], or the bounds are not in order.
    pub fn bounds(mut self, parameter: &str, range: RangeInclusive<f64>) -> Result<Self, ObjectiveError> {
        let index = quantity::index(self.description().parameters, parameter, "parameter")?;
        let bounds = [*range.start(), *range.end()];
        Adjustable::Free(bounds).checked(parameter)?;
        self.parameters[index] = Some(bounds);
        Ok(self)
    }

    /// The placement of the mechanism in the plane of the targets: the coordinates of the origin of its frame, and the
    /// angle of rotation of that frame (rad). Each is a number, or bounds between which it is sought. Without this
    /// call, the frame of the mechanism is that of the targets.
    ///
    /// # Errors
    /// [`ObjectiveError::NoSuchPart`] for a function, or bounds that are not in order.
    pub fn placement(
        mut self,
        x: impl Into<Adjustable>,
        y: impl Into<Adjustable>,
        rotation: impl Into<Adjustable>,
    ) -> Result<Self, ObjectiveError> {
        if !self.goal.is_placed() {
            return Err(ObjectiveError::NoSuchPart {
                part: "placement",
                goal: self.goal.name(),
            });
        }
        self.set(Part::X, x.into())?;
        self.set(Part::Y, y.into())?;
        self.set(Part::Rotation, rotation.into())?;
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
        if self.has_free_inputs() {
            return Err(ObjectiveError::NoSuchPart {
                part,
                goal: "an objective whose inputs are sought",
            });
        }
        Ok(())
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
        for (target, weight) in self.targets.iter_mut().zip(weights) {
            Adjustable::Fixed(weight).checked("weight")?;
            target.weight = weight;
        }
        Ok(self)
    }

    /// Adds a term beside the targets.
    #[must_use]
    pub fn term(mut self, term: Term) -> Self {
        self.terms.push(term);
        self
    }

    /// Adds a custom term: a function that gives rows of the sum of squares, or `None` where the mechanism does not
    /// close. The function calculates with [`Change`], a number that carries a derivative.
    ///
    /// ```
    /// use kin_core::any::Of;
    /// use kin_core::library::FourBar;
    /// use kin_fit::{Change, Objective};
    ///
    /// // the rocker shall be twice as long as the crank
    /// let objective = Objective::function(Of::<FourBar>::FUNCTIONS, "theta4", [[0.5, 1.0], [1.0, 1.2]])?
    ///     .bounds("r4", 40.0..=80.0)?
    ///     .custom_term(|at| {
    ///         let [_, r2, _, r4] = [0, 1, 2, 3].map(|index| at.parameters()[index]);
    ///         Some([r4 - Change::new(2.0, 0.0) * r2])
    ///     });
    /// # assert_eq!(objective.target_count(), 2);
    /// # Ok::<(), kin_fit::ObjectiveError>(())
    /// ```
    #[must_use]
    pub fn custom_term<const N: usize>(
        mut self,
        rows: impl Fn(&TermAt<'_>) -> Option<[Change; N]> + Send + Sync + 'static,
    ) -> Self {
        self.custom_terms.push(CustomTerm {
            count: N,
            rows: Arc::new(move |at| rows(at).map(Vec::from)),
        });
        self
    }

    /// Sets the part of the motion that must close and keep to the terms; otherwise from the first target to the last.
    #[must_use]
    pub fn travel(mut self, travel: Travel) -> Self {
        self.travel = travel;
        self
    }

    /// Sets the direction of the input in which the targets follow each other; otherwise either direction.
    #[must_use]
    pub fn sense(mut self, sense: Sense) -> Self {
        self.sense = sense;
        self
    }

    /// Sets the input that moves; otherwise the first input.
    ///
    /// # Errors
    /// [`ObjectiveError::NoSuchQuantity`].
    pub fn moving(mut self, input: &str) -> Result<Self, ObjectiveError> {
        self.moving = quantity::index(self.description().inputs, input, "input")?;
        Ok(self)
    }

    /// Sets the value at which another input stands; otherwise zero.
    ///
    /// # Errors
    /// [`ObjectiveError::NoSuchQuantity`], or a number that is not finite.
    pub fn standing(mut self, input: &str, value: f64) -> Result<Self, ObjectiveError> {
        let index = quantity::index(self.description().inputs, input, "input")?;
        Adjustable::Fixed(value).checked(input)?;
        self.others[index] = value;
        Ok(self)
    }

    /// The number of targets.
    #[must_use]
    pub fn target_count(&self) -> usize {
        self.targets.len()
    }

    /// The name of the input that moves.
    #[must_use]
    pub fn moving_input(&self) -> &'static str {
        self.description().inputs[self.moving].name
    }

    /// The names of the quantities that are compared with the targets.
    pub fn quantities(&self) -> impl Iterator<Item = &'static str> {
        self.traced.iter().map(|traced| traced.name)
    }
}

impl Goal {
    /// Whether a frame of the mechanism stands in the plane of the targets.
    pub(crate) fn is_placed(self) -> bool {
        matches!(self, Self::Path | Self::Motion)
    }
}

/// Targets whose values are all given.
fn plain<const N: usize>(targets: impl IntoIterator<Item = [f64; N]>) -> Vec<Target> {
    let target = |values: [f64; N]| Target {
        values: values.map(Some).to_vec(),
        weight: 1.0,
        input: None,
        others: None,
        sought: None,
    };
    targets.into_iter().map(target).collect()
}
