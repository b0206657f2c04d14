//! A pose of a sweep from which quantities are found as series.

use alloc::vec;
use alloc::vec::Vec;

use super::ExtremesError;
use super::margin::{DyadFunctions, Margins};
use crate::any::{NearOver, Of, OutputsOver, SkeletonOver};
use crate::failure::SolveError;
use crate::law::Side;
use crate::load::{Change, EFFORT_ENTRIES, NamedLoads, NamedMotion};
use crate::mechanism::{Description, Jacobian, Mechanism};
use crate::number::series::Series;
use crate::number::{Changing, Number, NumberRow};
use crate::quantity::{Dimension, Quantity};
use crate::reaction::{NamedReactions, Plan, ReactionFunctions, ReactionPlace, ReactionQuantity, Reactions};
use crate::solve::{Scalar, unwrap_near};
use crate::sweep::{Local, READ, TERMS, by_time, composed};

/// The terms from which the derivatives up to snap are read, each as a separate series.
const UP_TO_SNAP: usize = SNAP + TERMS;
const SNAP: usize = 4;

/// A quantity called by its name needs positions only: over a series in the variable of the sweep, they have all its
/// derivatives. So the solvers of rates are compiled in long numbers only where a closure asks for a typed pose.
pub trait NamedFunctions:
    PositionFunctions<Series<UP_TO_SNAP>> + PositionFunctions<Series<READ>> + DyadFunctions
{
}

impl<F: PositionFunctions<Series<UP_TO_SNAP>> + PositionFunctions<Series<READ>> + DyadFunctions> NamedFunctions for F {}

/// What the dependence of a quantity on the dimensions, and forces, need beside: positions in series that change with a
/// dimension or an input, and the points of the skeleton.
pub trait ChangedFunctions:
    NamedFunctions
    + PositionFunctions<Changing<Series<UP_TO_SNAP>>>
    + SkeletonOver<Changing<Series<UP_TO_SNAP>>>
    + ReactionFunctions
{
    /// The same in longer series, if the mechanism has derivatives above snap.
    fn above_snap(&self) -> Option<&dyn PositionFunctions<Changing<Series<READ>>>>;
}

impl<M: Mechanism<Scalar = f64>> ChangedFunctions for Of<M> {
    fn above_snap(&self) -> Option<&dyn PositionFunctions<Changing<Series<READ>>>> {
        // in a constant, so that it is not compiled for most mechanisms
        if const { M::DESCRIPTION.order > SNAP } {
            Some(self)
        } else {
            None
        }
    }
}

/// Positions and outputs in numbers of one type.
pub trait PositionFunctions<T>: NearOver<T> + OutputsOver<T> {}

impl<T, F: NearOver<T> + OutputsOver<T>> PositionFunctions<T> for F {}

/// A number in which a position has its derivatives with respect to the variable of a sweep.
pub(super) trait SeriesNumber: Scalar {
    /// The number with the first of these derivatives.
    fn from_motion(motion: &[f64]) -> Self;

    /// A dimension, whose change is 1 if it is the one with which all others change.
    fn changing(value: f64, changes: bool) -> Self;
}

impl<const N: usize> SeriesNumber for Series<N> {
    fn from_motion(motion: &[f64]) -> Self {
        Self::from_derivatives(core::array::from_fn(|order| motion[order]))
    }

    fn changing(value: f64, _: bool) -> Self {
        Self::constant(value)
    }
}

impl<const N: usize> SeriesNumber for Changing<Series<N>> {
    fn from_motion(motion: &[f64]) -> Self {
        Self::new(Series::from_motion(motion), Series::constant(0.0))
    }

    fn changing(value: f64, changes: bool) -> Self {
        Self::new(Series::constant(value), Series::constant(f64::from(u8::from(changes))))
    }
}

/// A pose of a sweep with unwrapped angles, and the motion of the inputs there.
#[derive(Clone)]
pub struct SweepStation<'s> {
    pub(super) description: &'s Description<'s>,
    pub(super) parameters: NumberRow,
    /// The inputs, each with its derivatives with respect to the variable.
    pub(super) inputs: Vec<f64>,
    /// The unknowns, with unwrapped angles.
    pub(super) unknowns: NumberRow,
    /// The outputs, with unwrapped angles.
    pub(super) outputs: NumberRow,
    /// The change of the variable for each unit of time.
    pub(super) rate: f64,
    /// The side from which it is approached.
    pub(super) side: Side,
    /// The variable as a series in the parameter.
    pub(super) variable: Local,
}

/// A position in series of the variable: parameters, inputs, what the unknowns are near, and the unknowns, one after
/// the other.
struct SeriesPosition<T> {
    numbers: Vec<T>,
    counts: [usize; 3],
}

impl<T> SeriesPosition<T> {
    fn parts(&mut self) -> [&mut [T]; 4] {
        let [parameters, inputs, unknowns] = self.counts;
        let (parameters, rest) = self.numbers.split_at_mut(parameters);
        let (inputs, rest) = rest.split_at_mut(inputs);
        let (near, unknowns) = rest.split_at_mut(unknowns);
        [parameters, inputs, near, unknowns]
    }

    fn unknowns(&self) -> &[T] {
        &self.numbers[self.numbers.len() - self.counts[2]..]
    }
}

/// Which result of a mechanism is meant, by its index.
#[derive(Clone, Copy, Debug)]
pub(super) enum ResultIndex {
    Unknown(usize),
    Output(usize),
}

impl SweepStation<'_> {
    /// The value of a quantity, which must be finite.
    pub(super) fn finite(&self, value: Local) -> Result<Local, ExtremesError> {
        if Number::is_finite(value) {
            Ok(value)
        } else {
            Err(ExtremesError::NotFinite {
                at: self.variable.real(),
            })
        }
    }

    /// A derivative of an input.
    pub(super) fn input(&self, index: usize, order: usize) -> Local {
        self.by_time(&self.inputs[index * READ..(index + 1) * READ], order)
    }

    /// A derivative of an unknown or of an output.
    pub(super) fn result(
        &self,
        functions: &dyn NamedFunctions,
        index: ResultIndex,
        order: usize,
    ) -> Result<Local, SolveError> {
        if order <= SNAP {
            let value = self.series::<Series<UP_TO_SNAP>>(functions, index, None)?;
            Ok(self.by_time(&value.derivatives(), order))
        } else {
            let value = self.series::<Series<READ>>(functions, index, None)?;
            Ok(self.by_time(&value.derivatives(), order))
        }
    }

    /// The change of a derivative of an unknown or of an output with a dimension.
    pub(super) fn change(
        &self,
        functions: &dyn ChangedFunctions,
        index: ResultIndex,
        order: usize,
        dimension: usize,
    ) -> Result<Local, SolveError> {
        match functions.above_snap() {
            Some(longer) if order > SNAP => {
                let value = self.series::<Changing<Series<READ>>>(longer, index, Some(dimension))?;
                Ok(self.by_time(&value.change.derivatives(), order))
            }
            _ => {
                let value = self.series::<Changing<Series<UP_TO_SNAP>>>(functions, index, Some(dimension))?;
                Ok(self.by_time(&value.change.derivatives(), order))
            }
        }
    }

    /// The margins and the transmission angles of all dyads.
    pub(super) fn margins<'f>(&'f self, functions: &'f dyn NamedFunctions) -> Result<Margins<'f>, SolveError> {
        let position = self.position::<Series<UP_TO_SNAP>>(functions, |_, value| Series::constant(value))?;
        let inputs = 0..self.description.inputs.len();
        let unknowns = position.unknowns().iter();
        Ok(Margins {
            functions,
            description: self.description,
            parameters: self.parameters.iter().copied().map(Local::constant).collect(),
            inputs: inputs.map(|input| self.input(input, 0)).collect(),
            unknowns: unknowns
                .map(|unknown| self.by_time(&unknown.derivatives(), 0))
                .collect(),
        })
    }

    /// The Jacobian of results, of dimensions that may change with the parameter in which the variable is a series.
    pub(super) fn jacobian(
        &self,
        functions: &dyn ChangedFunctions,
        rows: &[usize],
        parameters: &[Local],
    ) -> Result<Jacobian<Local>, SolveError> {
        type Number = Changing<Series<UP_TO_SNAP>>;
        let (unknown_count, input_count) = (self.unknowns.len(), self.description.inputs.len());
        let mut columns = Vec::with_capacity(input_count);
        for moved in 0..input_count {
            let inputs = (0..input_count).map(|input| {
                let rate = f64::from(u8::from(input == moved));
                Number::new(self.input(input, 0).resized(), Series::constant(rate))
            });
            let still = parameters
                .iter()
                .map(|value| Number::new(value.resized(), Series::ZERO));
            let mut position = self.position_at::<Number>(functions, still, inputs)?;
            let [parameters, inputs, _, unknowns] = position.parts();
            let mut outputs = vec![Number::constant(0.0); self.outputs.len()];
            if rows.iter().any(|row| *row >= unknown_count) {
                functions.outputs(parameters, inputs, unknowns, &mut outputs);
            }
            let mut results = unknowns.to_vec();
            results.extend(outputs);
            columns.push(results);
        }
        let entry = |row: usize, column: usize| columns[column][rows[row]].change.resized();
        Ok(Jacobian::from_fn(rows.len(), input_count, entry))
    }

    /// The effort of the drive of an input under loads, with its rates.
    pub(super) fn effort(
        &self,
        functions: &dyn ChangedFunctions,
        loads: &NamedLoads,
        moved: usize,
    ) -> Result<[Local; EFFORT_ENTRIES], ExtremesError> {
        type Number = Changing<Series<UP_TO_SNAP>>;
        let at = self.variable.real();
        let still = self.parameters.iter().copied().map(Number::constant);
        let inputs = self.inputs.chunks_exact(READ).enumerate().map(|(input, motion)| {
            let rate = f64::from(u8::from(input == moved));
            Number::new(Series::from_motion(motion), Series::constant(rate))
        });
        let found = self.position_at::<Number>(functions, still, inputs);
        let mut position = found.map_err(|_| ExtremesError::Gap { at })?;
        let [parameters, inputs, _, unknowns] = position.parts();
        let mut outputs = vec![Number::constant(0.0); self.outputs.len()];
        functions.outputs(parameters, inputs, unknowns, &mut outputs);
        for (index, output) in outputs.iter_mut().enumerate() {
            *output = unwrapped(self.description.outputs[index], *output, self.outputs[index]);
        }
        let by_time = |quantity: Number| -> NamedMotion<Local> {
            let (value, change) = (quantity.value.derivatives(), quantity.change.derivatives());
            core::array::from_fn(|order| Change::new(self.by_time(&value, order), self.by_time(&change, order)))
        };
        let all = [&*parameters, &*inputs, &*unknowns, &outputs].into_iter().flatten();
        let quantities: Vec<NamedMotion<Local>> = all.map(|quantity| by_time(*quantity)).collect();
        let mut points: Vec<[NamedMotion<Local>; 3]> = Vec::new();
        if loads.has_bodies() {
            let mut all: Vec<[Number; 3]> = Vec::new();
            let coordinate = |point: &[Number], axis: usize| point.get(axis).copied().unwrap_or(Number::constant(0.0));
            let mut add = |point: &[Number]| all.push([0, 1, 2].map(|axis| coordinate(point, axis)));
            SkeletonOver::<Number>::skeleton_points(functions, parameters, inputs, unknowns, &mut add);
            let joints = all.len() - functions.outline().slides.len();
            for direction in &mut all[joints..] {
                let square = direction
                    .iter()
                    .fold(Number::constant(0.0), |sum, part| sum + *part * *part);
                let length = square.sqrt();
                *direction = direction.map(|part| part / length);
            }
            points.extend(all.into_iter().map(|point| point.map(by_time)));
        }
        let effort = loads.effort(&quantities, &points, functions.is_space());
        effort.map_err(|error| ExtremesError::of_loads(at, error))
    }

    fn reaction_place<'p>(&'p self, functions: &'p dyn ChangedFunctions) -> ReactionPlace<'p> {
        ReactionPlace {
            functions,
            parameters: &self.parameters,
            inputs: self.inputs.chunks_exact(READ).map(Series::from_motion).collect(),
            unknowns: &self.unknowns,
            outputs: &self.outputs,
            rate: self.rate,
            side: self.side,
        }
    }

    /// The forces in all joints.
    pub(super) fn reactions(
        &self,
        functions: &dyn ChangedFunctions,
        reactions: &NamedReactions<'_>,
        plan: &mut Option<Plan>,
    ) -> Result<Reactions, ExtremesError> {
        let found = reactions.found(&self.reaction_place(functions), Some(plan));
        found.map_err(|error| ExtremesError::of_reaction(self.variable.real(), error))
    }

    /// The change of a force in a joint, an effort or a power, or of one of its rates, with a dimension.
    pub(super) fn change_of_reaction(
        &self,
        functions: &dyn ChangedFunctions,
        reactions: &NamedReactions<'_>,
        plan: &mut Option<Plan<Changing<f64>>>,
        (quantity, order): (ReactionQuantity, usize),
        dimension: usize,
    ) -> Result<Local, ExtremesError> {
        let change = reactions.change(&self.reaction_place(functions), plan, quantity, dimension);
        let change = change.map_err(|error| ExtremesError::of_reaction(self.variable.real(), error))?;
        Ok(self.by_time(&change.derivatives(), order))
    }

    /// A force in a joint, an effort or a power, or one of its rates.
    pub(super) fn reaction(
        &self,
        functions: &dyn ChangedFunctions,
        reactions: &NamedReactions<'_>,
        plan: &mut Option<Plan>,
        quantity: ReactionQuantity,
        order: usize,
    ) -> Result<Local, ExtremesError> {
        let found = reactions.quantity(&self.reaction_place(functions), plan, quantity);
        let found = found.map_err(|error| ExtremesError::of_reaction(self.variable.real(), error))?;
        Ok(self.by_time(&found.derivatives(), order))
    }

    /// The speed of the motion in a joint with friction, by its place among them.
    pub(super) fn joint_speed(
        &self,
        functions: &dyn ChangedFunctions,
        reactions: &NamedReactions<'_>,
        joint: usize,
    ) -> Result<Local, ExtremesError> {
        let found = reactions.joint_speed(&self.reaction_place(functions), joint);
        let found = found.map_err(|error| ExtremesError::of_reaction(self.variable.real(), error))?;
        Ok(self.by_time(&found.derivatives(), 0))
    }

    /// [`margins`](Self::margins) of dimensions that change with the parameter in which the variable is a series.
    pub(super) fn changed_margins<'f>(
        &'f self,
        functions: &'f dyn NamedFunctions,
        changed: &[Local],
    ) -> Result<Margins<'f>, SolveError> {
        let inputs: Vec<Local> = (0..self.description.inputs.len())
            .map(|input| self.input(input, 0))
            .collect();
        let position = self.position_at::<Series<UP_TO_SNAP>>(
            functions,
            changed.iter().map(Series::resized),
            inputs.iter().map(Series::resized),
        )?;
        Ok(Margins {
            functions,
            description: self.description,
            parameters: changed.to_vec(),
            inputs,
            unknowns: position.unknowns().iter().map(Series::resized).collect(),
        })
    }

    /// The position of dimensions that are `parameter(index, value)`.
    fn position<T: SeriesNumber>(
        &self,
        functions: &dyn PositionFunctions<T>,
        parameter: impl Fn(usize, f64) -> T,
    ) -> Result<SeriesPosition<T>, SolveError> {
        let parameters = self.parameters.iter().enumerate();
        let parameters = parameters.map(|(index, value)| parameter(index, *value));
        self.position_at(
            functions,
            parameters,
            self.inputs.chunks_exact(READ).map(T::from_motion),
        )
    }

    fn position_at<T: SeriesNumber>(
        &self,
        functions: &dyn PositionFunctions<T>,
        parameters: impl Iterator<Item = T>,
        inputs: impl Iterator<Item = T>,
    ) -> Result<SeriesPosition<T>, SolveError> {
        let near = || self.unknowns.iter().copied().map(T::constant);
        let mut position = SeriesPosition {
            numbers: parameters.chain(inputs).chain(near()).chain(near()).collect(),
            counts: [
                self.parameters.len(),
                self.description.inputs.len(),
                self.unknowns.len(),
            ],
        };
        let [parameters, inputs, near, unknowns] = position.parts();
        functions.position_near(parameters, inputs, near, unknowns)?;
        for (index, unknown) in unknowns.iter_mut().enumerate() {
            *unknown = unwrapped(self.description.unknowns[index], *unknown, self.unknowns[index]);
        }
        Ok(position)
    }

    /// An unknown or an output, whose change may be that with a dimension.
    fn series<T: SeriesNumber>(
        &self,
        functions: &dyn PositionFunctions<T>,
        index: ResultIndex,
        changed: Option<usize>,
    ) -> Result<T, SolveError> {
        let mut position = self.position(functions, |dimension, value| {
            T::changing(value, changed == Some(dimension))
        })?;
        let output = match index {
            ResultIndex::Unknown(unknown) => return Ok(position.unknowns()[unknown]),
            ResultIndex::Output(output) => output,
        };
        let [parameters, inputs, _, unknowns] = position.parts();
        let mut outputs = vec![T::constant(0.0); self.outputs.len()];
        functions.outputs(parameters, inputs, unknowns, &mut outputs);
        let quantity = self.description.outputs[output];
        Ok(unwrapped(quantity, outputs[output], self.outputs[output]))
    }

    /// A derivative with respect to time as a series in the parameter, from those with respect to the variable.
    pub(super) fn by_time(&self, derivatives: &[f64], order: usize) -> Local {
        composed(by_time(derivatives, order, self.rate), self.variable)
    }
}

/// A value, if it is an angle unwrapped to the closest to another one.
fn unwrapped<T: Scalar>(quantity: Quantity<'_>, value: T, near: f64) -> T {
    match quantity.dimension {
        Dimension::Angle => unwrap_near(value, T::constant(near)),
        _ => value,
    }
}
