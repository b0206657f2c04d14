//! Sensitivities of any mechanism, by numbers that carry a derivative.

use core::fmt;

use crate::failure::SolveError;
use crate::mechanism::{Mechanism, Partials, Pose};
use crate::number::{Number, Row, series::Series};

/// A value and its first-order change.
type FirstOrder = Series<2>;

/// The outputs of a mechanism whose numbers carry a change.
type Outputs<M, V> = <<<M as Mechanism>::With<FirstOrder> as Mechanism>::Pose as Pose>::Outputs<V>;

/// The partial derivatives of a motion with respect to one parameter, as [`sensitivities_of`] returns them. They are read by
/// the methods of [`Partials`].
#[derive(Clone, Copy)]
pub struct PartialMotions<M: Mechanism> {
    unknowns: M::Unknowns<M::Motion<f64>>,
    outputs: Outputs<M, M::Motion<f64>>,
}

impl<M: Mechanism> fmt::Debug for PartialMotions<M> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let description = M::DESCRIPTION;
        let unknowns = description.unknowns.iter().zip(self.unknowns.as_ref());
        let outputs = description.outputs.iter().zip(self.outputs.as_ref());
        let mut shown = formatter.debug_struct("PartialMotions");
        for (quantity, motion) in unknowns.chain(outputs) {
            shown.field(quantity.name, &motion.as_ref());
        }
        shown.finish()
    }
}

impl<M: Mechanism> Partials for PartialMotions<M> {
    type Motion = M::Motion<f64>;
    type Unknowns<V: Copy> = M::Unknowns<V>;
    type Outputs<V: Copy> = Outputs<M, V>;

    fn unknown_partials(&self) -> M::Unknowns<M::Motion<f64>> {
        self.unknowns
    }

    fn output_partials(&self) -> Outputs<M, M::Motion<f64>> {
        self.outputs
    }
}

/// The partial derivatives of the motion of any mechanism with respect to each scalar parameter, in all its orders.
///
/// The mechanism is solved once for each parameter, with numbers that carry the derivative with respect to it. So no
/// mechanism has to request them, and they are exact but for rounding. A mechanism that is declared `with sensitivities;` has
/// straight-line code for them: see [`Sensitive`](crate::Sensitive), which is several times faster.
///
/// Entry n of a motion is the derivative of the n-th time derivative, in the unit of the unknown or output over the unit
/// of the parameter and over the n-th power of the unit of time.
///
/// # Errors
/// The errors of [`Mechanism::solve`] at these inputs and in this assembly.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_core::sensitivities_of;
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let crank = Motion::at_constant_speed(1.1, 10.0);
/// let by = sensitivities_of(&linkage, [crank], Assembly::Open)?;
/// // of the rocker's angular velocity, with respect to the length of the coupler
/// let [_, theta4] = by[2].unknown_partials();
/// let longer = FourBar { r3: 60.001, ..linkage };
/// let change = longer.solve(crank, Assembly::Open)?.theta4 - linkage.solve(crank, Assembly::Open)?.theta4;
/// assert!((theta4.velocity() - change.velocity() / 0.001).abs() < 1e-4);
/// # Ok::<(), SolveError>(())
/// ```
pub fn sensitivities_of<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: M::Inputs<M::Motion<f64>>,
    assembly: M::Assembly,
) -> Result<M::Parameters<PartialMotions<M>>, SolveError> {
    let zero = M::Motion::splat(0.0);
    let nothing = PartialMotions {
        unknowns: Row::splat(zero),
        outputs: Row::splat(zero),
    };
    let mut partials: M::Parameters<PartialMotions<M>> = Row::splat(nothing);
    let fixed =
        <<M::With<FirstOrder> as Mechanism>::Inputs<M::Motion<FirstOrder>> as Row<M::Motion<FirstOrder>>>::from_fn(
            |input| {
                let motion: M::Motion<f64> = inputs[input];
                Row::from_fn(|order| FirstOrder::constant(motion[order]))
            },
        );
    for (place, partial) in partials.as_mut().iter_mut().enumerate() {
        let mut next = 0;
        let changed = mechanism.convert(|value| {
            next += 1;
            FirstOrder::from_coefficients([value, if next == place + 1 { 1.0 } else { 0.0 }])
        });
        let pose = changed.solve(fixed, assembly)?;
        let change = |motion: &M::Motion<FirstOrder>| M::Motion::from_fn(|order| motion[order].coefficients()[1]);
        let (unknowns, outputs) = (pose.unknown_motions(), pose.output_motions());
        *partial = PartialMotions {
            unknowns: Row::from_fn(|unknown| change(&unknowns[unknown])),
            outputs: Row::from_fn(|output| change(&outputs[output])),
        };
    }
    Ok(partials)
}
