//! The angles at which the links of dyads meet.

use super::{Block, ClosedForm, Method, Part};
use crate::algebra::{Graph, Node, Symbol};

/// A dyad of two links, or of a link and a slider, and its transmission angle.
pub(crate) struct Dyad {
    /// The unknowns that it determines, ascending.
    pub(crate) unknowns: Vec<usize>,
    pub(crate) kind: Kind,
    /// The angle's sine times a positive factor, but for its sign, which has no meaning.
    pub(crate) across: Node,
    /// The angle's cosine times the same factor.
    pub(crate) along: Node,
}

/// The joints of a dyad.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    TwoLinks,
    LinkAndSlider,
}

impl Kind {
    /// What documentation calls it.
    pub(crate) fn description(self) -> &'static str {
        match self {
            Self::TwoLinks => "two links (RRR dyad)",
            Self::LinkAndSlider => "link and slider (RRP dyad)",
        }
    }
}

/// All dyads, in the order in which they are solved. Equations are `residual == 0`, by number.
///
/// Two links v₁ and v₂, one behind the other, meet at the angle between -v₁ and v₂. A link v and a slider with v + x d = constant
/// meet at that between -v and the normal i (-d), as the joint at the end of v moves by -d when x grows.
pub(crate) fn dyads(graph: &mut Graph, residuals: &[Node], blocks: &[Block]) -> Vec<Dyad> {
    let mut dyads = Vec::new();
    for (block, part) in blocks
        .iter()
        .flat_map(|block| block.parts.iter().map(move |part| (block, part)))
    {
        match &part.method {
            Method::Closed(ClosedForm::TwoAngles {
                arms: [first, second], ..
            }) => {
                let (ratio, turn) = first.turn_to(graph, second);
                let product = ratio.times(graph, turn);
                let along = graph.negate(product.re);
                dyads.push(Dyad {
                    unknowns: part.unknowns.clone(),
                    kind: Kind::TwoLinks,
                    across: product.im,
                    along,
                });
            }
            Method::Closed(ClosedForm::AngleLength { arm, direction, .. }) => {
                let vector = arm.vector(graph);
                let product = vector.conjugate(graph).times(graph, *direction);
                // i d in place of d turns the product by a quarter
                let along = graph.negate(product.im);
                dyads.push(Dyad {
                    unknowns: part.unknowns.clone(),
                    kind: Kind::LinkAndSlider,
                    across: product.re,
                    along,
                });
            }
            _ => dyads.extend(slider_on_an_axis(graph, residuals, blocks, block)),
        }
    }
    dyads
}

/// A link and a slider on one of the axes, which are solved one after the other: one part of the loop holds the link's angle
/// alone, the other one the slider's travel as well.
///
/// The part with the angle alone is, but for what is constant, the link's component normal to the slide; differentiated, it is
/// the component along the slide, which the other part has to hold, and differentiated again, its own opposite.
fn slider_on_an_axis(graph: &mut Graph, residuals: &[Node], blocks: &[Block], block: &Block) -> Option<Dyad> {
    let ([angle], [equation]) = (block.unknowns.as_slice(), block.equations.as_slice()) else {
        return None;
    };
    let symbol = Symbol::Unknown(*angle);
    let slope = graph.partial(residuals[*equation], symbol);
    let bend = graph.partial(slope, symbol);
    let third = graph.partial(bend, symbol);
    let opposite = graph.negate(third);
    if graph.is_zero(slope) || !graph.same(opposite, slope) {
        return None;
    }
    for other in blocks {
        let (
            [
                Part {
                    method: Method::Closed(ClosedForm::Linear { unknown: travel, .. }),
                    ..
                },
            ],
            [partner],
        ) = (other.parts.as_slice(), other.equations.as_slice())
        else {
            continue;
        };
        if !graph.contains(residuals[*partner], symbol) {
            continue;
        }
        let change = graph.partial(residuals[*partner], symbol);
        let mirrored = graph.negate(bend);
        if !graph.same(change, bend) && !graph.same(change, mirrored) {
            continue;
        }
        let coefficient = graph.partial(residuals[*partner], Symbol::Unknown(*travel));
        let normal = graph.multiply(bend, coefficient);
        let mut unknowns = vec![*angle, *travel];
        unknowns.sort_unstable();
        return Some(Dyad {
            unknowns,
            kind: Kind::LinkAndSlider,
            across: graph.multiply(slope, coefficient),
            // x comes before y
            along: if partner < equation {
                graph.negate(normal)
            } else {
                normal
            },
        });
    }
    None
}
