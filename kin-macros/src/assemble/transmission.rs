//! The angle at which the two links of a dyad meet.

use super::choice::{between, vector};
use crate::expr::{Graph, Node};
use crate::structure::{ClosedForm, Part, Solution};

/// Sine and cosine of a transmission angle, times one positive factor. The sign of the sine has no meaning.
pub(crate) struct Transmission {
    pub(crate) across: Node,
    pub(crate) along: Node,
}

/// Whether a part is a dyad that has one.
pub(crate) fn has_transmission(part: &Part) -> bool {
    matches!(
        part.solution,
        Solution::Closed(ClosedForm::TwoAngles { .. } | ClosedForm::AngleLength { .. })
    )
}

/// That of a dyad; `None` for other parts.
///
/// Two links v₁ and v₂, one behind the other, meet at the angle between -v₁ and v₂. A link v and a slider with v + x d = constant
/// meet at that between -v and the normal i (-d), as the joint at the end of v moves by -d when x grows.
pub(crate) fn transmission(graph: &mut Graph, part: &Part) -> Option<Transmission> {
    let Solution::Closed(form) = &part.solution else {
        return None;
    };
    match form {
        ClosedForm::TwoAngles {
            arms: [first, second], ..
        } => {
            let (ratio, turn) = between(graph, first, second);
            let product = ratio.times(graph, turn);
            let along = graph.negate(product.re);
            Some(Transmission {
                across: product.im,
                along,
            })
        }
        ClosedForm::AngleLength { arm, direction, .. } => {
            let vector = vector(graph, arm);
            let product = vector.conjugate(graph).times(graph, *direction);
            // i d in place of d turns the product by a quarter
            let along = graph.negate(product.im);
            Some(Transmission {
                across: product.re,
                along,
            })
        }
        _ => None,
    }
}
