//! Reciprocals of roots.
//!
//! Rates are divided by the determinants of their blocks, and the determinant of a closed form is, up to a factor, the
//! square root in it. 1 / √x = √x · (1 / x). In this form the division need not wait for the root, and the determinant
//! need not be computed from the vectors of the links.

use std::collections::{BTreeMap, BTreeSet};

use super::units::Units;
use crate::algebra::{Graph, Node, Symbol};
use crate::program::{Names, Stage, Step};

/// A root that a closed form has taken. The reciprocal of `base` is `factor * value / square`.
pub(crate) struct KnownRoot {
    pub(super) base: Node,
    pub(super) value: Node,
    pub(super) square: Node,
    pub(super) factor: f64,
    /// The names of `factor / square` and of the reciprocal.
    pub(super) names: [String; 2],
}

/// The reciprocals that rates may refer to, each with two definitions: the reciprocal of the square, and the reciprocal
/// itself.
#[derive(Default)]
pub(crate) struct Reciprocals(Vec<(Node, [(Symbol, Node); 2])>);

impl Reciprocals {
    /// Lets expressions that are rewritten from now on use these reciprocals and not divide by the roots.
    pub(crate) fn learn(graph: &mut Graph, names: &mut Names, units: &mut Units, roots: &[KnownRoot]) -> Self {
        let mut known = BTreeMap::new();
        let reciprocals = roots
            .iter()
            .map(|root| {
                let (of_square, quotient) = graph.new_step();
                let (symbol, value) = graph.new_step();
                names.name(of_square, &root.names[0]);
                names.name(symbol, &root.names[1]);
                let inverse = graph.power(root.square, -1);
                let inverse = graph.scale(root.factor.abs(), inverse);
                let product = graph.multiply(root.value, quotient);
                let (opposite_base, opposite) = (graph.negate(root.base), graph.negate(value));
                let [same, other] = if root.factor < 0.0 {
                    [opposite, value]
                } else {
                    [value, opposite]
                };
                known.insert(root.base, same);
                known.insert(opposite_base, other);
                (value, [(of_square, inverse), (symbol, product)])
            })
            .collect();
        units.learn_reciprocals(graph, known);
        Self(reciprocals)
    }

    /// Places the reciprocals that are used before the first step that uses them.
    pub(crate) fn insert_into(self, graph: &Graph, stages: &mut [Stage<Node>]) {
        let mut sought: BTreeMap<Node, [(Symbol, Node); 2]> = self.0.into_iter().collect();
        let mut seen = BTreeSet::new();
        for stage in stages {
            let mut steps = Vec::with_capacity(stage.steps.len());
            for step in std::mem::take(&mut stage.steps) {
                let mut pending = step.needs();
                while let Some(node) = pending.pop() {
                    if seen.insert(node) {
                        pending.extend(graph.operands(node));
                        let definitions = sought.remove(&node).into_iter().flatten();
                        steps.extend(definitions.map(|(symbol, value)| Step::Define { symbol, value }));
                    }
                }
                steps.push(step);
            }
            stage.steps = steps;
        }
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;
    use quote::quote;

    use crate::passes::Passes;
    use crate::program::Step;
    use crate::testing::declarations::{four_bar, inverted_slider_crank, slider_crank};
    use crate::testing::sound;

    /// A link about an inclined axis, the end of which stays at a height.
    fn inclined_crank() -> TokenStream {
        quote! {
            struct Inclined { arm: Vector, lift: Scalar }
            input height: Length;
            unknown phi: Angle;
            arm.x * cos(phi) + arm.y * sin(phi) == lift * height;
        }
    }

    /// Rates divide only by the square of a root, and only once.
    #[test]
    fn a_root_is_inverted_once_and_by_its_square() {
        for (declaration, of_square, reciprocal) in [
            (four_bar(), "double_inverse_square", "inverse_determinant"),
            (slider_crank(), "inverse_l_x_squared", "inverse_l_x"),
            (inverted_slider_crank(), "inverse_r4_squared", "inverse_r4"),
            (inclined_crank(), "inverse_square", "inverse_phi_root"),
        ] {
            let solvers = sound(declaration).solvers(Passes::ALL);
            let [_, velocity, later @ ..] = solvers.orders() else {
                unreachable!("there is a velocity");
            };
            let defined: Vec<&str> = velocity
                .steps
                .iter()
                .flat_map(Step::defines)
                .map(|symbol| solvers.names().of(symbol))
                .collect();
            assert_eq!(defined[..2], [of_square, reciprocal]);
            assert_eq!(velocity.cost.divisions, 1);
            assert!(later.iter().all(|stage| stage.cost.divisions == 0));
        }
    }
}
