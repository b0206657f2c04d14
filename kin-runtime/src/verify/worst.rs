//! The worst errors of a verification.

use core::fmt;
use std::format;
use std::string::String;
use std::vec;
use std::vec::Vec;

use super::functions::VerifiedFunctions;
use super::motions::flat;
use super::{Gauge, Inputs, allowed};
use crate::any::{AssemblyChoice, Named, Of, PositionChoice};
use crate::mechanism::Mechanism;
use crate::quantity::Quantity;

/// The reference for a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Oracle {
    /// Differentiation of the position solution, for the unknowns.
    Differentiation,
    /// The residuals of the equations with the motions put into them.
    Closure,
    /// Differentiation of the position solution, for the outputs.
    Outputs,
}

impl Oracle {
    const ALL: [Self; 3] = [Self::Differentiation, Self::Closure, Self::Outputs];
}

impl fmt::Display for Oracle {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Differentiation => "differentiation",
            Self::Closure => "closure",
            Self::Outputs => "outputs",
        })
    }
}

/// The error that was largest compared with the [`allowed`] error at its order, and where it occurred.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The oracle that found it.
    pub oracle: Oracle,
    /// The name of the unknown, equation or output.
    pub quantity: String,
    /// The order of the derivative.
    pub order: usize,
    /// The error in units of the [`Gauge`].
    pub error: f64,
    /// The parameters, the inputs with their derivatives, and the assembly.
    pub location: String,
}

impl fmt::Display for Finding {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            formatter,
            "{}, order {}, by {}: {:.3e} units at {}",
            self.quantity, self.order, self.oracle, self.error, self.location
        )
    }
}

/// The worst errors over any number of poses, order by order in units of the [`Gauge`], displayed as a table.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_core::verify::Worst;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let mut worst = Worst::default();
/// for step in -18..=18 {
///     let crank = Motion::from([0.1 * f64::from(step), -10.0, 2.0, -0.5, 0.3]);
///     worst.check(&linkage, [crank], Assembly::Open);
/// }
/// assert_eq!(worst.poses, 37);
/// assert!(worst.is_allowed(), "{worst}");
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Worst {
    /// The errors of the unknowns, compared with differentiation of the position solution.
    pub differentiation: Vec<f64>,
    /// The residuals of the equations.
    pub closure: Vec<f64>,
    /// The errors of the outputs, compared with differentiation of the position solution; empty if there are no
    /// outputs.
    pub outputs: Vec<f64>,
    /// The number of poses verified.
    pub poses: usize,
    /// The largest error compared with the allowed error.
    pub finding: Option<Finding>,
}

impl Worst {
    /// Solves the mechanism at one motion and compares the result with both oracles. Returns whether the mechanism
    /// closes there; a motion at which it does not close is skipped. A position that is found but cannot be
    /// differentiated counts as an infinite error.
    pub fn check<M: Mechanism<Scalar = f64>>(
        &mut self,
        mechanism: &M,
        inputs: Inputs<M>,
        assembly: M::Assembly,
    ) -> bool {
        let parameters = mechanism.parameters();
        let choice = AssemblyChoice::of::<M>(assembly);
        let inputs = flat(inputs.as_ref());
        self.check_any(Of::<M>::FUNCTIONS, parameters.as_ref(), &inputs, choice.position())
    }

    /// [`check`](Self::check) of a mechanism without its type.
    pub(super) fn check_any(
        &mut self,
        functions: &dyn VerifiedFunctions,
        parameters: &[f64],
        inputs: &[f64],
        choice: PositionChoice<'_, f64>,
    ) -> bool {
        let description = functions.description();
        let orders = description.order + 1;
        let [mut unknowns, mut outputs] =
            [description.unknowns, description.outputs].map(|all| vec![0.0; all.len() * orders]);
        let solved = functions.motion(parameters, inputs, choice, &mut unknowns, &mut outputs);
        if solved.is_err() {
            return false;
        }
        self.poses += 1;
        let location = || location(functions, parameters, inputs, choice);
        let gauge = Gauge::at(functions, parameters, inputs, &unknowns);
        for (index, left) in functions
            .left_over(parameters, inputs, &unknowns)
            .into_iter()
            .enumerate()
        {
            for (order, left) in left.into_iter().enumerate() {
                let error = units(left.abs(), gauge.equation(index, order));
                let name = || format!("scalar equation {}", index + 1);
                self.note(Oracle::Closure, order, error, name, location);
            }
        }
        let expected = match functions.differentiated(parameters, inputs, choice) {
            Ok(expected) => expected,
            Err(error) => {
                let error = Named::new(error, description);
                let name = || format!("{error} (on numbers that carry derivatives)");
                self.note(Oracle::Differentiation, 0, f64::INFINITY, name, location);
                return true;
            }
        };
        let motions = unknowns.chunks_exact(orders).zip(description.unknowns);
        for (index, ((motion, quantity), expected)) in motions.zip(&expected.unknowns).enumerate() {
            for (order, (value, other)) in motion.iter().zip(expected).enumerate() {
                let error = units((value - other).abs(), gauge.unknown(index, order));
                self.note(Oracle::Differentiation, order, error, || quantity.name.into(), location);
            }
        }
        let motions = outputs.chunks_exact(orders).zip(description.outputs);
        for ((motion, quantity), expected) in motions.zip(&expected.outputs) {
            for (order, (value, other)) in motion.iter().zip(expected).enumerate() {
                let error = units((value - other).abs(), gauge.output(quantity, motion, order));
                self.note(Oracle::Outputs, order, error, || quantity.name.into(), location);
            }
        }
        true
    }

    /// Whether every error is within the [`allowed`] number of units. This is also true if no pose was verified.
    #[must_use]
    pub fn is_allowed(&self) -> bool {
        Oracle::ALL.iter().all(|&oracle| {
            self.errors(oracle)
                .iter()
                .enumerate()
                .all(|(order, &error)| error <= allowed(order))
        })
    }

    /// The worst errors found by an oracle, order by order.
    #[must_use]
    pub fn errors(&self, oracle: Oracle) -> &[f64] {
        match oracle {
            Oracle::Differentiation => &self.differentiation,
            Oracle::Closure => &self.closure,
            Oracle::Outputs => &self.outputs,
        }
    }

    fn note(
        &mut self,
        oracle: Oracle,
        order: usize,
        error: f64,
        quantity: impl Fn() -> String,
        location: impl Fn() -> String,
    ) {
        let errors = match oracle {
            Oracle::Differentiation => &mut self.differentiation,
            Oracle::Closure => &mut self.closure,
            Oracle::Outputs => &mut self.outputs,
        };
        if errors.len() <= order {
            errors.resize(order + 1, 0.0);
        }
        errors[order] = larger(errors[order], error);
        let is_worst = self.finding.as_ref().is_none_or(|worst| {
            let (known, here) = (worst.error / allowed(worst.order), error / allowed(order));
            !known.is_nan() && (here.is_nan() || here > known)
        });
        if is_worst {
            self.finding = Some(Finding {
                oracle,
                quantity: quantity(),
                order,
                error,
                location: location(),
            });
        }
    }
}

impl fmt::Display for Worst {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let orders = self.differentiation.len().max(self.closure.len());
        write!(formatter, "{:15}", "order")?;
        for order in 0..orders {
            write!(formatter, " {order:>9}")?;
        }
        for oracle in Oracle::ALL {
            let errors = self.errors(oracle);
            if errors.is_empty() {
                continue;
            }
            write!(formatter, "\n{oracle:15}")?;
            for &error in errors {
                if error < 1e5 {
                    write!(formatter, " {error:9.3}")?;
                } else {
                    write!(formatter, " {error:9.1e}")?;
                }
            }
        }
        write!(formatter, "\n{:15}", "allowed")?;
        for order in 0..orders {
            write!(formatter, " {:9}", allowed(order))?;
        }
        Ok(())
    }
}

/// The location of a motion, with every number to the last digit.
fn location(
    functions: &dyn VerifiedFunctions,
    parameters: &[f64],
    inputs: &[f64],
    choice: PositionChoice<'_, f64>,
) -> String {
    let description = functions.description();
    let named = |quantity: &Quantity<'_>, value: String| format!("{} = {value}", quantity.name);
    let values = description.parameters.iter().zip(parameters);
    let mut parts: Vec<String> = values
        .map(|(quantity, value)| named(quantity, format!("{value:?}")))
        .collect();
    let inputs = description
        .inputs
        .iter()
        .zip(inputs.chunks_exact(description.order + 1));
    parts.extend(inputs.map(|(quantity, motion)| named(quantity, format!("{motion:?}"))));
    match choice {
        PositionChoice::Assembly(index) => match functions.assembly_name(index) {
            Some(name) if !name.is_empty() => parts.push(format!("assembly {name}")),
            _ => {}
        },
        PositionChoice::Near(near) => parts.push(format!("near {near:?}")),
    }
    parts.join(", ")
}

/// An error in units. An error of zero is zero units, even if the unit itself is zero, as for a rate at standstill.
fn units(error: f64, unit: f64) -> f64 {
    if error == 0.0 { 0.0 } else { error / unit }
}

/// The larger of two numbers, or NaN if one of them is NaN.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}
