//! The closed form of each block as steps.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use super::choice;
use super::reciprocals::KnownRoot;
use super::units::Units;
use crate::algebra::{Graph, InverseFunction, Node, NodeKind, Symbol};
use crate::derive::Regularity;
use crate::passes::Passes;
use crate::program::{Choice, DeclaredRange, FormArgument, Mode, Names, Solver, Stage, Step};
use crate::structure::{Block, ClosedForm, ComplexNode, Method, Part};

/// The steps that find the position, the directions and roots that they make known, and the remaining choices.
pub(crate) struct PositionSteps {
    pub(crate) stage: Stage<Node>,
    pub(crate) units: Units,
    /// The values that the position finds to be nonzero.
    pub(crate) nonzero: Vec<Node>,
    pub(crate) roots: Vec<KnownRoot>,
    pub(crate) choices: Vec<Choice>,
}

/// The state of assembling.
pub(super) struct Builder<'a> {
    pub(super) graph: &'a mut Graph,
    pub(super) names: &'a mut Names,
    pub(super) steps: Vec<Step<Node>>,
    pub(super) units: Units,
    /// The divisors that closed forms find to be nonzero.
    pub(super) nonzero: Vec<Node>,
    /// The roots that closed forms take.
    pub(super) roots: Vec<KnownRoot>,
}

/// Converts blocks into steps that find one position.
pub(crate) fn assemble(
    graph: &mut Graph,
    names: &mut Names,
    blocks: &[Block],
    ranges: &BTreeMap<usize, DeclaredRange>,
    jacobians: &[Regularity],
    passes: Passes,
) -> PositionSteps {
    steps(graph, names, blocks, ranges, Some(jacobians), passes)
}

/// Converts blocks into steps that go through all positions; `None` if a block's equations are not algebraic.
pub(crate) fn assemble_every(
    graph: &mut Graph,
    names: &mut Names,
    blocks: &[Block],
    ranges: &BTreeMap<usize, DeclaredRange>,
    passes: Passes,
) -> Option<Stage<Node>> {
    let is_algebraic = blocks.iter().all(|block| !block.is_coupled() || block.all.is_some());
    is_algebraic.then(|| steps(graph, names, blocks, ranges, None, passes).stage)
}

/// The steps that find one position, or all positions if no Jacobians are given.
fn steps(
    graph: &mut Graph,
    names: &mut Names,
    blocks: &[Block],
    ranges: &BTreeMap<usize, DeclaredRange>,
    jacobians: Option<&[Regularity]>,
    passes: Passes,
) -> PositionSteps {
    let mut builder = Builder {
        graph,
        names,
        steps: Vec::new(),
        units: Units::new(passes),
        nonzero: Vec::new(),
        roots: Vec::new(),
    };
    let mut choices = Vec::new();
    let mut assemblies = 0;
    for (index, block) in blocks.iter().enumerate() {
        let jacobian = jacobians.map(|jacobians| &jacobians[index]);
        if let (None, Some(all)) = (jacobian, &block.all) {
            builder.every(index, choices.len(), all);
            choices.extend(block.parts.iter().map(|_| Choice {
                mode: Mode::Only,
                orientation: None,
            }));
            continue;
        }
        for (index, part) in block.parts.iter().enumerate() {
            let number = choices.len();
            let orientation = choice::orientation(builder.graph, part);
            let mode = choice::mode(builder.graph, part, ranges, &mut assemblies);
            builder.steps.push(Step::Open { part: number, mode });
            choices.push(Choice { mode, orientation });
            match &part.method {
                Method::Closed(form) => builder.form(form, jacobian),
                Method::Newton { residuals, .. } => builder.newton(number, &part.unknowns, residuals),
            }
            builder.bounds(part, ranges);
            if let Some(jacobian) = jacobian
                && index + 1 == block.parts.len()
                && block.check_jacobian
            {
                builder.regular(jacobian);
            }
            builder.steps.push(Step::Close { part: number });
        }
    }
    PositionSteps {
        stage: Stage::new(builder.steps),
        units: builder.units,
        nonzero: builder.nonzero,
        roots: builder.roots,
        choices,
    }
}

impl Builder<'_> {
    /// Checks that a block's Jacobian is regular, after all of the block's unknowns are found.
    fn regular(&mut self, jacobian: &Regularity) {
        let step = match jacobian {
            Regularity::Determinant(determinant) => Step::Regular {
                value: self.known(*determinant),
            },
            Regularity::Factors { factors, matrix } => Step::Factor {
                symbol: *factors,
                matrix: matrix
                    .iter()
                    .map(|row| row.iter().map(|&entry| self.known(entry)).collect())
                    .collect(),
            },
        };
        self.steps.push(step);
    }

    /// Moves the unknowns of a part, just found, to the requested revolution or into the declared range.
    fn bounds(&mut self, part: &Part, ranges: &BTreeMap<usize, DeclaredRange>) {
        for &unknown in &part.unknowns {
            let angle = Symbol::Unknown(unknown);
            let is_periodic = self
                .steps
                .iter()
                .any(|step| matches!(step, Step::Angle { symbol, .. } if *symbol == angle));
            let principal = -PI..=PI;
            let wraps = is_periodic
                && ranges
                    .get(&unknown)
                    .is_some_and(|limits| !(principal.contains(&limits.low) && principal.contains(&limits.high)));
            self.steps.push(Step::Bound {
                unknown,
                is_periodic,
                wraps,
            });
        }
    }

    pub(super) fn known(&mut self, node: Node) -> Node {
        self.units.rewrite(self.graph, node)
    }

    pub(super) fn known_complex(&mut self, value: ComplexNode) -> ComplexNode {
        ComplexNode::new(self.known(value.re), self.known(value.im))
    }

    /// Names a value, so that later expressions refer to the name and not to the formula.
    pub(super) fn define(&mut self, wish: &str, node: Node) -> Node {
        if self.graph.as_symbol(node).is_some() || self.graph.as_number(node).is_some() {
            return node;
        }
        let (symbol, result) = self.graph.new_step();
        self.names.name(symbol, wish);
        self.steps.push(Step::Define { symbol, value: node });
        result
    }

    pub(super) fn define_complex(&mut self, wish: &str, value: ComplexNode) -> ComplexNode {
        ComplexNode::new(
            self.define(&format!("{wish}_x"), value.re),
            self.define(&format!("{wish}_y"), value.im),
        )
    }

    pub(super) fn fresh(&mut self, wish: &str) -> (Symbol, Node) {
        let (symbol, node) = self.graph.new_step();
        self.names.name(symbol, wish);
        (symbol, node)
    }

    pub(super) fn fresh_plane(&mut self, wish: &str) -> ([Symbol; 2], ComplexNode) {
        let ((x, x_node), (y, y_node)) = (self.fresh(&format!("{wish}_x")), self.fresh(&format!("{wish}_y")));
        ([x, y], ComplexNode::new(x_node, y_node))
    }

    pub(super) fn unknown_name(&self, unknown: usize) -> String {
        self.names.of(Symbol::Unknown(unknown)).to_owned()
    }

    pub(super) fn solve(&mut self, solver: Solver, arguments: Vec<FormArgument<Node>>, results: Vec<Symbol>) {
        self.steps.push(Step::Solve {
            solver,
            arguments,
            results: results.into_iter().map(Some).collect(),
        });
    }

    /// Solves a closed form of a block with this Jacobian.
    pub(super) fn form(&mut self, form: &ClosedForm, jacobian: Option<&Regularity>) {
        match form {
            ClosedForm::Linear {
                unknown,
                coefficient,
                right,
            } => self.linear(*unknown, *coefficient, *right),
            ClosedForm::SquareRoot { unknown, square } => {
                let square = self.known(*square);
                self.solve(
                    Solver::SquareRoot,
                    vec![FormArgument::Scalar(square)],
                    vec![Symbol::Unknown(*unknown)],
                );
            }
            ClosedForm::Quadratic { unknown, a, b, c } => {
                let arguments = [*a, *b, *c].map(|node| FormArgument::Scalar(self.known(node))).to_vec();
                self.solve(Solver::Quadratic, arguments, vec![Symbol::Unknown(*unknown)]);
            }
            ClosedForm::InverseCosine { unknown, radius, width } => {
                let (known, found) = self.inverse_circular(Solver::InverseCosine, *unknown, *radius, *width);
                self.turn_vector(*unknown, *radius, ComplexNode::new(known, found));
            }
            ClosedForm::InverseSine {
                unknown,
                radius,
                height,
            } => {
                let (known, found) = self.inverse_circular(Solver::InverseSine, *unknown, *radius, *height);
                self.turn_vector(*unknown, *radius, ComplexNode::new(found, known));
            }
            ClosedForm::CosineSine { unknown, a, b, c } => self.cosine_sine(*unknown, [*a, *b, *c], jacobian),
            ClosedForm::Inverse {
                inverse,
                value,
                result,
                then,
                ..
            } => {
                self.inverse(*inverse, *value, *result);
                self.form(then, jacobian);
            }
            ClosedForm::EvenInverse {
                inverse,
                unknown,
                value,
                result,
                growth,
                coefficient,
                right,
                ..
            } => {
                self.names.name(*result, "inverse");
                let arguments = [*value, *growth].map(|node| FormArgument::Scalar(self.known(node)));
                self.solve(Solver::EvenInverse(inverse), arguments.to_vec(), vec![*result]);
                self.linear(*unknown, *coefficient, *right);
            }
            ClosedForm::LinearPair {
                unknowns,
                matrix,
                right,
            } => {
                let matrix = matrix.map(|row| row.map(|entry| self.known(entry)));
                let right = right.map(|entry| self.known(entry));
                self.solve(
                    Solver::LinearPair,
                    vec![FormArgument::Matrix(matrix), FormArgument::Pair(right)],
                    unknowns.iter().map(|&unknown| Symbol::Unknown(unknown)).collect(),
                );
            }
            ClosedForm::LinearSystem {
                unknowns,
                matrix,
                right,
            } => self.linear_system(unknowns, matrix, right),
            ClosedForm::TwoAngles { unknowns, arms, target } => self.two_angles(*unknowns, arms, *target),
            ClosedForm::AngleLength {
                angle,
                length,
                arm,
                direction,
                target,
            } => {
                self.angle_length(*angle, *length, arm, *direction, *target);
            }
            ClosedForm::Direction { unknown, arm, target } => self.direction(*unknown, arm, *target),
            ClosedForm::Polar {
                length,
                angle,
                mirrored,
                offset,
                target,
            } => {
                self.polar(*length, *angle, *mirrored, *offset, *target);
            }
        }
    }

    /// Solves a cos x + b sin x = c. The derivative by x is the opposite of the root.
    fn cosine_sine(&mut self, unknown: usize, [a, b, c]: [Node; 3], jacobian: Option<&Regularity>) {
        let size = match [a, b].map(|node| self.graph.amplitude(node)) {
            [Some(a), Some(b)] => a + b,
            // nothing is known of lengths
            _ => 0.0,
        };
        let mut arguments = [a, b, c].map(|node| FormArgument::Scalar(self.known(node))).to_vec();
        arguments.push(FormArgument::Known(size));
        let name = self.unknown_name(unknown);
        let ([x, y], unit) = self.fresh_plane(&name);
        let (root, value) = self.fresh(&format!("{name}_root"));
        let (root_squared, square) = self.fresh(&format!("{name}_root_squared"));
        self.solve(Solver::CosineSine, arguments, vec![x, y, root, root_squared]);
        self.turn(unknown, unit);
        let angle = self.graph.symbol(Symbol::Unknown(unknown));
        let (cosine, sine) = (self.graph.cosine(angle), self.graph.sine(angle));
        let [by_sine, by_cosine] = [(a, sine), (b, cosine)].map(|(part, unit)| self.graph.multiply(part, unit));
        let slope = self.graph.subtract(by_sine, by_cosine);
        if let Some(&Regularity::Determinant(determinant)) = jacobian
            && let Some(multiple) = self.graph.multiple(determinant, slope)
        {
            let determinant = self.known(determinant);
            let (coefficient, base) = self.graph.split_coefficient(determinant);
            self.learn_root(KnownRoot {
                base,
                value,
                square,
                factor: coefficient / multiple,
                names: ["inverse_square".to_owned(), format!("inverse_{name}_root")],
            });
        } else {
            self.nonzero.push(square);
        }
    }

    fn linear(&mut self, unknown: usize, coefficient: Node, right: Node) {
        let symbol = Symbol::Unknown(unknown);
        if self.graph.constant_value(coefficient).is_some() {
            let value = self.graph.divide(right, coefficient);
            let angle = self.graph.symbol(symbol);
            self.units.learn_combination(angle, value);
            let node = self.known(value);
            self.steps.push(Step::Define { symbol, value: node });
        } else {
            let arguments = vec![
                FormArgument::Scalar(self.known(coefficient)),
                FormArgument::Scalar(self.known(right)),
            ];
            self.solve(Solver::Linear, arguments, vec![symbol]);
        }
    }

    fn linear_system(&mut self, unknowns: &[usize], matrix: &[Vec<Node>], right: &[Node]) {
        let (symbol, factors) = self.fresh("factors");
        let matrix = matrix
            .iter()
            .map(|row| row.iter().map(|&entry| self.known(entry)).collect())
            .collect();
        let right = right.iter().map(|&entry| self.known(entry)).collect();
        let solution: Vec<(Symbol, Node)> = unknowns
            .iter()
            .map(|&unknown| {
                let name = self.unknown_name(unknown);
                self.fresh(&format!("{name}_solution"))
            })
            .collect();
        self.steps.push(Step::Factor { symbol, matrix });
        self.steps.push(Step::Substitute {
            factors,
            right,
            results: solution.iter().map(|&(symbol, _)| symbol).collect(),
        });
        for (&unknown, (_, value)) in unknowns.iter().zip(solution) {
            self.steps.push(Step::Define {
                symbol: Symbol::Unknown(unknown),
                value,
            });
        }
    }

    /// Adds the step that finds one coordinate of a link from the other. Returns both coordinates, the given one first.
    fn inverse_circular(&mut self, solver: Solver, unknown: usize, radius: Node, coordinate: Node) -> (Node, Node) {
        let (radius, mut given) = (self.known(radius), self.known(coordinate));
        let wish = self.link_name(radius, &self.unknown_name(unknown));
        let [wished, other] = match solver {
            Solver::InverseCosine => ["x", "y"],
            _ => ["y", "x"],
        };
        // leave a product as it is: its factors may cancel, or occur elsewhere
        if matches!(self.graph.kind(given), NodeKind::Sum(..)) {
            given = self.define(&format!("{wish}_{wished}"), given);
        }
        let (symbol, found) = self.fresh(&format!("{wish}_{other}"));
        let square = self.root(symbol, found);
        let arguments = vec![FormArgument::Scalar(given), FormArgument::Scalar(radius)];
        self.solve(solver, arguments, vec![symbol, square]);
        (given, found)
    }

    /// A symbol for the square of a root that a closed form is about to take.
    pub(super) fn root(&mut self, symbol: Symbol, value: Node) -> Symbol {
        let name = self.names.of(symbol).to_owned();
        let (symbol, square) = self.fresh(&format!("{name}_squared"));
        self.learn_root(KnownRoot {
            base: value,
            value,
            square,
            factor: 1.0,
            names: [format!("inverse_{name}_squared"), format!("inverse_{name}")],
        });
        symbol
    }

    /// Records a root and that its square is nonzero.
    pub(super) fn learn_root(&mut self, root: KnownRoot) {
        self.nonzero.push(root.square);
        self.roots.push(root);
    }

    /// Finds the unknown angle of a link whose vector is known.
    pub(super) fn turn_vector(&mut self, unknown: usize, length: Node, vector: ComplexNode) {
        let length = self.known(length);
        self.nonzero.push(length);
        let angle = self.graph.symbol(Symbol::Unknown(unknown));
        let divisor = ComplexNode::new(length, self.graph.zero());
        let unit = vector.over(self.graph, divisor);
        self.units.learn_direction(angle, unit);
        self.push_angle(unknown, vector, length);
    }

    /// Finds the unknown angle of a unit vector.
    pub(super) fn turn(&mut self, unknown: usize, unit: ComplexNode) {
        let angle = self.graph.symbol(Symbol::Unknown(unknown));
        self.units.learn_direction(angle, unit);
        let length = self.graph.one();
        self.steps.push(Step::Angle {
            symbol: Symbol::Unknown(unknown),
            x: unit.re,
            y: unit.im,
            length: Some(length),
        });
    }

    /// Finds the argument of a function from the function's value.
    fn inverse(&mut self, inverse: InverseFunction, value: Node, result: Symbol) {
        let value = self.known(value);
        self.names.name(result, "inverse");
        match inverse {
            InverseFunction::Elementary(function) => {
                let node = self.graph.call(function, &[value]);
                self.steps.push(Step::Define {
                    symbol: result,
                    value: node,
                });
            }
            InverseFunction::Checked(function) => {
                self.solve(
                    Solver::Inverse(function),
                    vec![FormArgument::Scalar(value)],
                    vec![result],
                );
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;
    use quote::quote;

    use super::*;
    use crate::testing::sound;

    /// A function of an unknown is inverted by the closed form of its inverse. An inverse that is defined everywhere
    /// needs no closed form.
    #[test]
    fn functions_are_inverted_by_their_inverses() {
        let names = |function: TokenStream| -> Vec<&str> {
            let declared = sound(quote! {
                struct Inverse { a: Scalar }
                input t: Scalar;
                unknown x: Scalar;
                #function(x) == a * t;
            });
            let steps = &declared.solvers(Passes::ALL).motion.stages[0].steps;
            let solvers = steps.iter().filter_map(|step| match step {
                Step::Solve { solver, .. } => Some(*solver),
                _ => None,
            });
            solvers
                .filter(|solver| *solver != Solver::Linear)
                .map(Solver::name)
                .collect()
        };
        for (function, expected) in [
            (quote!(sqrt), vec!["square_of_root"]),
            (quote!(asin), vec!["sine_of_arc"]),
            (quote!(acos), vec!["cosine_of_arc"]),
            (quote!(atan), vec!["tangent_of_arc"]),
            (quote!(sinh), vec![]),
            (quote!(cosh), vec!["inverse_hyperbolic_cosine"]),
            (quote!(tanh), vec!["area_hyperbolic_tangent"]),
            (quote!(asinh), vec![]),
            (quote!(acosh), vec!["hyperbolic_cosine_of_area"]),
            (quote!(atanh), vec![]),
            (quote!(exp), vec!["logarithm"]),
            (quote!(ln), vec![]),
        ] {
            assert_eq!(names(function.clone()), expected, "{function}");
        }
    }
}
