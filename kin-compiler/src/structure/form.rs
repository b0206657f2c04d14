//! The forms of blocks: dyads with the lengths of their links, and the crank that drives a dyad.

use std::collections::BTreeMap;

use super::dyads::AxisSlider;
use super::{Block, ClosedForm, ComplexNode, Method, dyads};
use crate::algebra::{Graph, Node, Symbol};

/// The form of a block, with vectors of the lengths that belong to it. A length that changes is `None`.
pub(crate) struct BlockForm {
    pub(crate) kind: BlockKind,
    /// The angle by which the crank rotates.
    pub(crate) driver: Option<Symbol>,
    pub(crate) lengths: Vec<Option<ComplexNode>>,
}

/// The kind of a block.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BlockKind {
    /// Lengths: ground, crank, coupler, rocker.
    FourBar,
    /// Lengths: both links.
    TwoLinks,
    /// Lengths: crank, coupler, offset.
    SliderCrank,
    /// Lengths: the link.
    LinkAndSlider,
    /// Lengths: ground, crank, offset.
    InvertedSliderCrank,
    /// Lengths: the offset.
    SliderOnLink,
    /// A link whose direction is known.
    PlacedLink,
    /// A linear equation.
    Linear,
    /// A quadratic equation.
    Quadratic,
    /// An equation in cosine and sine of one angle.
    CosineSine,
    /// An elementary function.
    Inverse,
    /// Coupled equations.
    Coupled,
}

/// A link that rotates about a fixed pivot by an angle that is known before the block is solved.
struct Crank {
    driver: Symbol,
    link: ComplexNode,
    /// The rest of the vector, which does not move.
    ground: ComplexNode,
}

/// The form of each block. The equations are `residual == 0`, by index.
pub(crate) fn block_forms(graph: &mut Graph, residuals: &[Node], blocks: &[Block]) -> Vec<BlockForm> {
    blocks
        .iter()
        .map(|block| block_form(graph, residuals, blocks, block))
        .collect()
}

fn block_form(graph: &mut Graph, residuals: &[Node], blocks: &[Block], block: &Block) -> BlockForm {
    let [part] = block.parts.as_slice() else {
        return BlockForm::plain(BlockKind::Coupled);
    };
    let Method::Closed(form) = &part.method else {
        return BlockForm::plain(BlockKind::Coupled);
    };
    if let Some(slider) = dyads::slider_on_an_axis(graph, residuals, blocks, block) {
        return on_an_axis(graph, &slider);
    }
    match form {
        ClosedForm::TwoAngles { arms, target, .. } => two_links(graph, arms.each_ref().map(|arm| arm.factor), *target),
        ClosedForm::AngleLength {
            arm, direction, target, ..
        } => link_and_slider(graph, arm.factor, *direction, *target),
        ClosedForm::Polar { offset, target, .. } => slider_on_link(graph, *offset, *target),
        ClosedForm::Direction { .. } => BlockForm::plain(BlockKind::PlacedLink),
        ClosedForm::Linear { .. } | ClosedForm::LinearPair { .. } | ClosedForm::LinearSystem { .. } => {
            BlockForm::plain(BlockKind::Linear)
        }
        ClosedForm::SquareRoot { .. } | ClosedForm::Quadratic { .. } => BlockForm::plain(BlockKind::Quadratic),
        ClosedForm::CosineSine { .. } => BlockForm::plain(BlockKind::CosineSine),
        ClosedForm::InverseCosine { .. }
        | ClosedForm::InverseSine { .. }
        | ClosedForm::Inverse { .. }
        | ClosedForm::EvenInverse { .. } => BlockForm::plain(BlockKind::Inverse),
    }
}

impl BlockForm {
    fn plain(kind: BlockKind) -> Self {
        Self {
            kind,
            driver: None,
            lengths: Vec::new(),
        }
    }

    /// A form with a crank if all its lengths are constant, otherwise the dyad alone.
    fn driven(
        kind: BlockKind,
        driver: Symbol,
        lengths: impl IntoIterator<Item = Option<ComplexNode>>,
        alone: Self,
    ) -> Self {
        let lengths: Vec<_> = lengths.into_iter().collect();
        if lengths.iter().any(Option::is_none) {
            return alone;
        }
        Self {
            kind,
            driver: Some(driver),
            lengths,
        }
    }
}

/// first + second = target.
fn two_links(graph: &mut Graph, arms: [ComplexNode; 2], target: ComplexNode) -> BlockForm {
    let links = arms.map(|arm| constant(graph, arm));
    let alone = BlockForm {
        lengths: links.to_vec(),
        ..BlockForm::plain(BlockKind::TwoLinks)
    };
    let Some(crank) = crank(graph, target) else {
        return alone;
    };
    // On the left side the crank has the opposite sign. The coupler stands on the crank's side of the equation.
    let across = [arms[0], arms[1], crank.link].map(|vector| is_negative(graph, vector));
    let [coupler, rocker] = if across[0] == across[2] && across[1] != across[2] {
        [links[1], links[0]]
    } else {
        links
    };
    let [ground, crank_link] = [crank.ground, crank.link].map(|vector| constant(graph, vector));
    let lengths = [ground, crank_link, coupler, rocker];
    BlockForm::driven(BlockKind::FourBar, crank.driver, lengths, alone)
}

/// arm + length · direction = target.
fn link_and_slider(graph: &mut Graph, arm: ComplexNode, direction: ComplexNode, target: ComplexNode) -> BlockForm {
    let link = constant(graph, arm);
    let alone = BlockForm {
        lengths: vec![link],
        ..BlockForm::plain(BlockKind::LinkAndSlider)
    };
    let Some(crank) = crank(graph, target) else {
        return alone;
    };
    if !graph.movers(&[direction.re, direction.im]).is_empty() {
        return alone;
    }
    let along = direction.conjugate(graph);
    let across = along.times(graph, crank.ground).im;
    let square = direction.norm_squared(graph);
    let one = graph.one();
    let offset = if graph.same(square, one) {
        Some(across)
    } else if graph.is_zero(direction.im) {
        Some(graph.divide(across, direction.re))
    } else if graph.is_zero(direction.re) {
        Some(graph.divide(across, direction.im))
    } else {
        None
    };
    let offset = offset.map(|offset| along_x(graph, offset));
    let lengths = [constant(graph, crank.link), link, offset];
    BlockForm::driven(BlockKind::SliderCrank, crank.driver, lengths, alone)
}

/// (length + offset) · cis(angle) = target.
fn slider_on_link(graph: &mut Graph, offset: ComplexNode, target: ComplexNode) -> BlockForm {
    let offset = constant(graph, offset).map(|offset| along_x(graph, offset.im));
    let alone = BlockForm {
        lengths: vec![offset],
        ..BlockForm::plain(BlockKind::SliderOnLink)
    };
    let Some(crank) = crank(graph, target) else {
        return alone;
    };
    let [ground, crank_link] = [crank.ground, crank.link].map(|vector| constant(graph, vector));
    let lengths = [ground, crank_link, offset];
    BlockForm::driven(BlockKind::InvertedSliderCrank, crank.driver, lengths, alone)
}

/// A link and a slider whose components are two blocks: `across` contains the angle alone, `along` the travel as well.
fn on_an_axis(graph: &mut Graph, slider: &AxisSlider) -> BlockForm {
    let whole = ComplexNode::new(slider.along, slider.across);
    let travel = Symbol::Unknown(slider.travel);
    let angle = Symbol::Unknown(slider.angle);
    let [slope, bend] = [slider.slope, slider.bend];
    let link = ComplexNode::new(graph.at_zero(slope, angle), graph.at_zero(bend, angle));
    let link = constant(graph, link);
    let alone = BlockForm {
        lengths: vec![link],
        ..BlockForm::plain(BlockKind::LinkAndSlider)
    };
    // the vector from the slider's line to the dyad's end: neither the travel nor the link
    let rest = [whole.re, whole.im].map(|node| {
        let first = graph.partial(node, angle);
        let second = graph.partial(first, angle);
        let without = graph.add(node, second);
        let without = graph.at_zero(without, travel);
        graph.at_zero(without, angle)
    });
    let rest = ComplexNode::new(rest[0], rest[1]);
    let Some(crank) = crank(graph, rest) else {
        return alone;
    };
    let coefficient = graph.partial(slider.along, travel);
    let one = graph.one();
    let opposite = graph.negate(one);
    let is_unit = graph.same(coefficient, one) || graph.same(coefficient, opposite);
    if !is_unit {
        return alone;
    }
    let offset = along_x(graph, crank.ground.im);
    let lengths = [constant(graph, crank.link), link, Some(offset)];
    BlockForm::driven(BlockKind::SliderCrank, crank.driver, lengths, alone)
}

/// The crank of a vector ground + link · cis(± driver) + constant, if nothing else moves.
fn crank(graph: &mut Graph, vector: ComplexNode) -> Option<Crank> {
    let movers: Vec<Symbol> = graph.movers(&[vector.re, vector.im]);
    let [driver @ (Symbol::Input(_) | Symbol::Unknown(_))] = movers[..] else {
        return None;
    };
    let parts = [vector.re, vector.im];
    let [re, im] = parts.map(|part| {
        let first = graph.partial(part, driver);
        [first, graph.partial(first, driver)]
    });
    // the first derivative of a rotating vector is the vector rotated by a right angle, to the left or to the right
    let opposites = [re[0], im[0]].map(|first| graph.negate(first));
    let is_left = graph.same(re[1], opposites[1]) && graph.same(im[1], re[0]);
    let is_right = graph.same(re[1], im[0]) && graph.same(im[1], opposites[0]);
    if !is_left && !is_right {
        return None;
    }
    let link = [re[1], im[1]].map(|second| {
        let opposite = graph.negate(second);
        graph.at_zero(opposite, driver)
    });
    let ground = [(parts[0], re[1]), (parts[1], im[1])].map(|(part, second)| {
        let rest = graph.add(part, second);
        graph.at_zero(rest, driver)
    });
    let (link, ground) = (
        ComplexNode::new(link[0], link[1]),
        ComplexNode::new(ground[0], ground[1]),
    );
    let is_fixed = graph.movers(&[link.re, link.im, ground.re, ground.im]).is_empty();
    let rotates = !graph.vanishes(link.re) || !graph.vanishes(link.im);
    (is_fixed && rotates).then_some(Crank { driver, link, ground })
}

/// A vector that depends on parameters alone, in the simplest form of the same length.
fn constant(graph: &mut Graph, vector: ComplexNode) -> Option<ComplexNode> {
    if !graph.movers(&[vector.re, vector.im]).is_empty() {
        return None;
    }
    let zero = graph.zero();
    let parts = [vector.re, vector.im].map(|part| if graph.vanishes(part) { zero } else { part });
    let vector = ComplexNode::new(parts[0], parts[1]);
    if graph.is_zero(vector.re) || graph.is_zero(vector.im) {
        return Some(vector);
    }
    // a link at a constant angle has a separate length
    let square = vector.norm_squared(graph);
    for symbol in graph.parameters_of(&[square]) {
        let length = graph.symbol(symbol);
        let square_of_length = graph.power(length, 2);
        if graph.same(square, square_of_length) {
            return Some(ComplexNode::new(length, zero));
        }
    }
    Some(vector)
}

fn along_x(graph: &mut Graph, length: Node) -> ComplexNode {
    let zero = graph.zero();
    ComplexNode::new(if graph.vanishes(length) { zero } else { length }, zero)
}

/// Whether a vector points backwards, for positive lengths.
fn is_negative(graph: &mut Graph, vector: ComplexNode) -> bool {
    let part = if graph.is_zero(vector.re) { vector.im } else { vector.re };
    graph.probes_negative(part)
}

impl Graph {
    /// The inputs and unknowns in some expressions.
    fn movers(&self, nodes: &[Node]) -> Vec<Symbol> {
        let symbols = self.reachable(nodes).into_iter();
        symbols
            .filter_map(|node| self.as_symbol(node))
            .filter(|symbol| !matches!(symbol, Symbol::Parameter(_)))
            .collect()
    }

    /// The parameters in some expressions.
    fn parameters_of(&self, nodes: &[Node]) -> Vec<Symbol> {
        let symbols = self.reachable(nodes).into_iter();
        symbols
            .filter_map(|node| self.as_symbol(node))
            .filter(|symbol| matches!(symbol, Symbol::Parameter(_)))
            .collect()
    }

    /// An expression with zero instead of a symbol.
    fn at_zero(&mut self, node: Node, symbol: Symbol) -> Node {
        let (symbol, zero) = (self.symbol(symbol), self.zero());
        self.substitute(node, &mut BTreeMap::from([(symbol, zero)]))
    }
}

#[cfg(test)]
mod tests {
    use quote::quote;

    use crate::expand::expand;
    use crate::passes::Passes;
    use crate::testing::sound;

    /// The solution of a function's inverse contains further symbols.
    #[test]
    fn forms_of_inverse_functions() {
        let declaration = quote! {
            struct RssrByLength { crank: Length, pivot: Point3, axis: Vector3, arm: Vector3, rod: Length }
            input theta: Angle;
            unknown phi: Angle;
            norm(rot_z(theta) * vec3(crank, 0, 0) - pivot - rot(axis, phi) * arm) == rod;
        };
        let solvers = sound(declaration.clone()).solvers(Passes::ALL);
        assert_eq!(solvers.lengths.forms.len(), 1);
        let tokens = expand(quote!((::kin_core) #declaration)).to_string();
        assert!(!tokens.contains("compile_error"), "{tokens}");
    }
}
