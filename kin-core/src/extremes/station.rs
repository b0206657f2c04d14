//! A pose of a sweep from which quantities are found as series.

use super::ExtremesError;
use super::answer::Answer;
use super::at::At;
use super::margin::Margins;
use crate::failure::SolveError;
use crate::mechanism::Mechanism;
use crate::motion::Motion;
use crate::number::series::Series;
use crate::number::{Number, Row};
use crate::quantity::{Dimension, Quantity};
use crate::solve::nearest_turn;
use crate::sweep::{Local, OutputsOf, READ, TERMS, by_time, composed};

/// The terms from which the derivatives up to snap are read, each with its own series.
const UP_TO_SNAP: usize = SNAP + TERMS;
const SNAP: usize = 4;

/// A pose of a sweep with unwrapped angles, and the motion of the inputs there.
///
/// A quantity called by its name needs positions only: over a series in the variable of the sweep, they have all its derivatives. So the
/// solvers of rates are compiled in long numbers only where a closure asks for a typed pose.
#[derive(Clone, Copy)]
pub struct SweepStation<M: Mechanism> {
    pub(super) mechanism: M,
    /// The inputs, with their derivatives with respect to the variable.
    pub(super) inputs: M::Inputs<Motion<f64, READ>>,
    /// The unknowns, with unwrapped angles.
    pub(super) unknowns: M::Unknowns<f64>,
    /// The outputs, with unwrapped angles.
    pub(super) outputs: OutputsOf<M, f64>,
    /// The change of the variable for each unit of time.
    pub(super) rate: f64,
    /// The variable as a series in the parameter.
    pub(super) variable: Local,
}

/// A position in series of the variable.
struct SeriesPosition<M: Mechanism, const N: usize> {
    mechanism: M::With<Series<N>>,
    inputs: <M::With<Series<N>> as Mechanism>::Inputs<Series<N>>,
    unknowns: <M::With<Series<N>> as Mechanism>::Unknowns<Series<N>>,
}

impl<M: Mechanism<Scalar = f64>> SweepStation<M> {
    /// The typed pose, as the solvers of a mechanism find it: of the same dimensions, or of others that change with the variable.
    pub(super) fn pose(&self, changed: Option<&M::With<Local>>) -> Result<At<M>, SolveError> {
        let mechanism = changed.map_or_else(|| self.mechanism.convert(Local::constant), |changed| *changed);
        let near = Row::from_fn(|unknown| Local::constant(self.unknowns[unknown]));
        let inputs = Row::from_fn(|input| Row::from_fn(|order| self.by_time(self.inputs[input].as_ref(), order)));
        Ok(At {
            mechanism,
            pose: mechanism.solve_motion_near(inputs, near)?,
            inputs,
            near,
            outputs: self.outputs,
            source: changed.is_none().then_some(*self),
        })
    }

    /// The value of an expression of the typed pose.
    pub(super) fn answer<A: Answer>(
        &self,
        changed: Option<&M::With<Local>>,
        quantity: impl Fn(&At<M>) -> A,
    ) -> Result<Local, ExtremesError> {
        let at = self.variable.real();
        let pose = self.pose(changed).map_err(|_| ExtremesError::Gap { at })?;
        quantity(&pose).answer().map_err(|error| ExtremesError::Load {
            at,
            error: alloc::boxed::Box::new(error),
        })
    }

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
        self.by_time(self.inputs[index].as_ref(), order)
    }

    /// A derivative of an unknown.
    pub(super) fn unknown(&self, index: usize, order: usize) -> Result<Local, SolveError> {
        if order <= SNAP {
            let value = self.position::<UP_TO_SNAP>()?.unknowns[index];
            Ok(self.by_time(&value.derivatives(), order))
        } else {
            let value = self.position::<READ>()?.unknowns[index];
            Ok(self.by_time(&value.derivatives(), order))
        }
    }

    /// A derivative of an output.
    pub(super) fn output(&self, index: usize, order: usize) -> Result<Local, SolveError> {
        if order <= SNAP {
            let value = self.position::<UP_TO_SNAP>()?.output(index, self.outputs[index]);
            Ok(self.by_time(&value.derivatives(), order))
        } else {
            let value = self.position::<READ>()?.output(index, self.outputs[index]);
            Ok(self.by_time(&value.derivatives(), order))
        }
    }

    /// The margins and the transmission angles of all dyads.
    pub(super) fn margins(&self) -> Result<Margins<M::With<Local>>, SolveError> {
        let position = self.position::<UP_TO_SNAP>()?;
        Ok(Margins {
            mechanism: self.mechanism.convert(Local::constant),
            inputs: Row::from_fn(|input| self.input(input, 0)),
            unknowns: Row::from_fn(|unknown| self.by_time(&position.unknowns[unknown].derivatives(), 0)),
        })
    }

    fn position<const N: usize>(&self) -> Result<SeriesPosition<M, N>, SolveError> {
        let mechanism: M::With<Series<N>> = self.mechanism.convert(Series::constant);
        let inputs = Row::from_fn(|input| {
            let motion = self.inputs[input];
            Series::from_derivatives(core::array::from_fn(|order| motion[order]))
        });
        let near = Row::from_fn(|unknown| Series::constant(self.unknowns[unknown]));
        let found = mechanism.solve_position_near(inputs, near)?;
        let unknowns = Row::from_fn(|unknown| {
            let quantity = M::DESCRIPTION.unknowns[unknown];
            unwrapped(quantity, found[unknown], self.unknowns[unknown])
        });
        Ok(SeriesPosition {
            mechanism,
            inputs,
            unknowns,
        })
    }

    /// A derivative with respect to time as a series in the parameter, from those with respect to the variable.
    fn by_time(&self, derivatives: &[f64], order: usize) -> Local {
        composed(by_time(derivatives, order, self.rate), self.variable)
    }
}

impl<M: Mechanism, const N: usize> SeriesPosition<M, N> {
    fn output(&self, index: usize, near: f64) -> Series<N> {
        let outputs = self.mechanism.outputs_at(self.inputs, self.unknowns);
        unwrapped(M::DESCRIPTION.outputs[index], outputs[index], near)
    }
}

/// A value on the turn nearest to another one, if it is an angle.
fn unwrapped<const N: usize>(quantity: Quantity, value: Series<N>, near: f64) -> Series<N> {
    match quantity.dimension {
        Dimension::Angle => nearest_turn(value, Series::constant(near)),
        _ => value,
    }
}
