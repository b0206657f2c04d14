//! The dyads of a mechanism and their transmission angles.

use super::{Block, ClosedForm, Method, Part};
use crate::algebra::{Graph, Node, Symbol};

/// A dyad of two links, or of a link and a slider, and its transmission angle.
pub(crate) struct Dyad {
    /// The unknowns that the dyad determines, ascending.
    pub(crate) unknowns: Vec<usize>,
    pub(crate) kind: DyadKind,
    /// The sine of the angle, times a positive factor. Its sign has no meaning.
    pub(crate) across: Node,
    /// The angle's cosine times the same factor.
    pub(crate) along: Node,
}

/// The joints of a dyad.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum DyadKind {
    TwoLinks,
    LinkAndSlider,
}

impl DyadKind {
    /// The name of the dyad in documentation.
    pub(crate) fn description(self) -> &'static str {
        match self {
            Self::TwoLinks => "two links (RRR dyad)",
            Self::LinkAndSlider => "link and slider (RRP dyad)",
        }
    }
}

/// All dyads, in the order in which they are solved. The equations are `residual == 0`, by index.
///
/// Two links v₁ and v₂, one after the other, meet at the angle between -v₁ and v₂. A link v and a slider with v + x d =
/// constant meet at the angle between -v and the normal i (-d), because the joint at the end of v moves by -d when x
/// grows.
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
                let (ratio, rotation) = first.turn_to(graph, second);
                let product = ratio.times(graph, rotation);
                let along = graph.negate(product.re);
                dyads.push(Dyad {
                    unknowns: part.unknowns.clone(),
                    kind: DyadKind::TwoLinks,
                    across: product.im,
                    along,
                });
            }
            Method::Closed(ClosedForm::AngleLength { arm, direction, .. }) => {
                let vector = arm.vector(graph);
                let product = vector.conjugate(graph).times(graph, *direction);
                // i d instead of d rotates the product by a right angle
                let along = graph.negate(product.im);
                dyads.push(Dyad {
                    unknowns: part.unknowns.clone(),
                    kind: DyadKind::LinkAndSlider,
                    across: product.re,
                    along,
                });
            }
            _ => dyads.extend(slider_on_an_axis(graph, residuals, blocks, block).map(|slider| slider.dyad(graph))),
        }
    }
    dyads
}

/// A link and a slider on one of the axes, solved one after the other. One part of the loop contains the link's angle
/// alone, the other part contains the slider's travel as well.
pub(super) struct AxisSlider {
    pub(super) angle: usize,
    pub(super) travel: usize,
    /// The residual of the part with the angle alone.
    pub(super) across: Node,
    /// The residual of the part with the travel.
    pub(super) along: Node,
    /// The first and the second derivative of `across` with respect to the angle.
    pub(super) slope: Node,
    pub(super) bend: Node,
    /// Whether the equation of `along` comes first.
    is_along_first: bool,
}

impl AxisSlider {
    fn dyad(&self, graph: &mut Graph) -> Dyad {
        let coefficient = graph.partial(self.along, Symbol::Unknown(self.travel));
        let normal = graph.multiply(self.bend, coefficient);
        let mut unknowns = vec![self.angle, self.travel];
        unknowns.sort_unstable();
        Dyad {
            unknowns,
            kind: DyadKind::LinkAndSlider,
            across: graph.multiply(self.slope, coefficient),
            // x comes before y
            along: if self.is_along_first {
                graph.negate(normal)
            } else {
                normal
            },
        }
    }
}

/// The link and the slider on an axis of which a block finds the angle.
///
/// The part with the angle alone is, up to a constant, the link's component normal to the slide. Its derivative is the
/// component along the slide, which the other part has to contain. Its second derivative is its opposite.
pub(super) fn slider_on_an_axis(
    graph: &mut Graph,
    residuals: &[Node],
    blocks: &[Block],
    block: &Block,
) -> Option<AxisSlider> {
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
        return Some(AxisSlider {
            angle: *angle,
            travel: *travel,
            across: residuals[*equation],
            along: residuals[*partner],
            slope,
            bend,
            is_along_first: partner < equation,
        });
    }
    None
}
