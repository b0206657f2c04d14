//! Sensitivities of any mechanism, by numbers that carry a derivative.

use core::fmt;

use crate::failure::SolveError;
use crate::mechanism::{Mechanism, Partials, Pose};
use crate::number::{Number, Row, series::Series};

/// A value and its first-order change.
type FirstOrder = Series<2>;

/// The outputs of a mechanism whose numbers carry a change.
type Outputs<M, V> = <<<M as Mechanism>::With<FirstOrder> as Mechanism>::Pose as Pose>::Outputs<V>;

/// The partial derivatives of a motion with respect to one parameter, as [`Mechanism::sensitivities_at`] returns them.
/// They are read by the methods of [`Partials`].
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

/// Computes [`Mechanism::sensitivities_at`].
pub(super) fn sensitivities_at<M: Mechanism<Scalar = f64>>(
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
    for (index, partial) in partials.as_mut().iter_mut().enumerate() {
        let mut next = 0;
        let changed = mechanism.convert(|value| {
            next += 1;
            FirstOrder::from_coefficients([value, if next == index + 1 { 1.0 } else { 0.0 }])
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
