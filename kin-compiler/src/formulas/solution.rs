//! The solution of each block, line by line.

use std::collections::{BTreeMap, BTreeSet};

use super::expression::Expressions;
use super::name::Name;
use super::names::NotationNames;
use super::rates::{Residuals, change_over};
use super::term::{DisplayLine, Notation};
use crate::algebra::{Function, Graph, Node, Symbol};
use crate::structure::{Arm, Block, ClosedForm, ComplexNode, Method, Part};

/// The solutions of parts. The names that they introduce hold for one part each.
pub(super) struct Solutions<'a> {
    pub(super) graph: &'a mut Graph,
    pub(super) names: &'a NotationNames,
    pub(super) residuals: &'a Residuals<'a>,
    /// The results that later formulas of the same part use.
    results: BTreeMap<Symbol, Name>,
}

impl<'a> Solutions<'a> {
    pub(super) const fn new(graph: &'a mut Graph, names: &'a NotationNames, residuals: &'a Residuals<'a>) -> Self {
        Self {
            graph,
            names,
            residuals,
            results: BTreeMap::new(),
        }
    }

    /// The formulas that solve a block.
    pub(super) fn block(&mut self, block: &Block) -> Vec<DisplayLine> {
        let mut lines = Vec::new();
        for part in &block.parts {
            self.results.clear();
            lines.extend(self.part(part));
        }
        lines
    }

    fn part(&mut self, part: &Part) -> Vec<DisplayLine> {
        match &part.method {
            Method::Closed(form) => self.closed(form),
            Method::Newton { residuals, .. } => self.newton(&part.unknowns, residuals),
        }
    }

    fn closed(&mut self, form: &ClosedForm) -> Vec<DisplayLine> {
        match form {
            ClosedForm::Linear {
                unknown,
                coefficient,
                right,
            } => {
                let quotient = self.graph.divide(*right, *coefficient);
                vec![DisplayLine::equation(self.unknown(*unknown), self.scalar(quotient))]
            }
            ClosedForm::SquareRoot { unknown, square } => {
                vec![DisplayLine::equation(
                    self.unknown(*unknown),
                    Notation::Either(Box::new(self.scalar(*square).root())),
                )]
            }
            ClosedForm::Quadratic { unknown, a, b, c } => self.quadratic(*unknown, [*a, *b, *c]),
            ClosedForm::InverseCosine { unknown, radius, width } => {
                let ratio = self.graph.divide(*width, *radius);
                let angle = Notation::Call("arccos", vec![self.scalar(ratio)]);
                vec![DisplayLine::equation(
                    self.unknown(*unknown),
                    Notation::Either(Box::new(angle)),
                )]
            }
            ClosedForm::InverseSine {
                unknown,
                radius,
                height,
            } => {
                let ratio = self.graph.divide(*height, *radius);
                let angle = Notation::Call("arcsin", vec![self.scalar(ratio)]);
                let other = Notation::Pi.minus(angle.clone());
                vec![
                    DisplayLine::equation(self.unknown(*unknown), angle),
                    DisplayLine::equation(
                        Notation::product([Notation::Words("or"), self.unknown(*unknown)]),
                        other,
                    ),
                ]
            }
            ClosedForm::CosineSine { unknown, a, b, c } => self.cosine_and_sine(*unknown, [*a, *b, *c]),
            ClosedForm::Inverse {
                function,
                value,
                result,
                then,
                ..
            } => {
                let name = self.names.fresh('y');
                let inverted = inverted(*function, self.scalar(*value));
                self.results.insert(*result, name.clone());
                let mut lines = vec![DisplayLine::equation(Notation::Name(name), inverted)];
                lines.extend(self.closed(then));
                lines
            }
            ClosedForm::EvenInverse {
                function,
                unknown,
                value,
                result,
                coefficient,
                right,
                ..
            } => {
                let name = self.names.fresh('y');
                let inverted = inverted(*function, self.scalar(*value));
                self.results.insert(*result, name.clone());
                let quotient = self.graph.divide(*right, *coefficient);
                vec![
                    DisplayLine::equation(Notation::Name(name), Notation::Either(Box::new(inverted))),
                    DisplayLine::equation(self.unknown(*unknown), self.scalar(quotient)),
                ]
            }
            ClosedForm::LinearPair {
                unknowns,
                matrix,
                right,
            } => self.linear(unknowns, matrix.iter().map(<[Node; 2]>::as_slice), right),
            ClosedForm::LinearSystem {
                unknowns,
                matrix,
                right,
            } => self.linear(unknowns, matrix.iter().map(Vec::as_slice), right),
            ClosedForm::TwoAngles { arms, target, .. } => self.two_angles(arms, *target),
            ClosedForm::AngleLength {
                length,
                arm,
                direction,
                target,
                ..
            } => self.angle_and_length(*length, arm, *direction, *target),
            ClosedForm::Direction { arm, target, .. } => {
                let [d] = self.fresh(['d']);
                vec![
                    DisplayLine::equation(self.arm(arm), d.clone()),
                    self.definition(d.clone(), &[target.re, target.im]),
                    self.angle_of(arm, d),
                ]
            }
            ClosedForm::Polar {
                length,
                angle,
                mirrored,
                offset,
                target,
            } => self.polar([*length, *angle], *mirrored, *offset, *target),
        }
    }

    /// Σ entry · x = right, row by row.
    fn linear<'n>(
        &self,
        unknowns: &[usize],
        matrix: impl Iterator<Item = &'n [Node]>,
        right: &[Node],
    ) -> Vec<DisplayLine> {
        matrix
            .zip(right)
            .map(|(row, &right)| {
                let terms = row
                    .iter()
                    .zip(unknowns)
                    .filter(|(entry, _)| !self.graph.is_zero(**entry));
                let left =
                    terms.map(|(&entry, &unknown)| Notation::product([self.scalar(entry), self.unknown(unknown)]));
                DisplayLine::equation(Notation::sum(left.collect::<Vec<_>>()), self.scalar(right))
            })
            .collect()
    }

    /// x = (-b ± √(b² - 4 a c)) / (2 a)
    fn quadratic(&self, unknown: usize, coefficients: [Node; 3]) -> Vec<DisplayLine> {
        let [a, b, c] = self.fresh(['a', 'b', 'c']);
        let x = self.unknown(unknown);

        let product = Notation::product([Notation::Number(4.0), a.clone(), c.clone()]);
        let root = b.clone().squared().minus(product).root();
        let equation = Notation::sum([
            Notation::product([a.clone(), x.clone().squared()]),
            Notation::product([b.clone(), x.clone()]),
            c.clone(),
        ]);
        let solution = Notation::Sum(vec![b.clone().negative(), Notation::Either(Box::new(root))])
            .over(Notation::product([Notation::Number(2.0), a.clone()]));
        let mut lines = vec![DisplayLine::equation(equation, Notation::Number(0.0))];
        let named = [a, b, c].into_iter().zip(coefficients);
        lines.extend(named.map(|(name, value)| self.definition(name, &[value])));

        lines.push(DisplayLine::equation(x, solution));
        lines
    }

    /// The solution of a cos x + b sin x = c: x = atan2(b, a) ± arccos(c / √(a² + b²)).
    fn cosine_and_sine(&self, unknown: usize, coefficients: [Node; 3]) -> Vec<DisplayLine> {
        let [a, b, c] = self.fresh(['a', 'b', 'c']);
        let x = self.unknown(unknown);

        let equation = Notation::sum([
            Notation::product([a.clone(), Notation::Call("cos", vec![x.clone()])]),
            Notation::product([b.clone(), Notation::Call("sin", vec![x.clone()])]),
        ]);
        let radius = Notation::sum([a.clone().squared(), b.clone().squared()]).root();
        let solution = Notation::Sum(vec![
            Notation::Call("atan2", vec![b.clone(), a.clone()]),
            Notation::Either(Box::new(Notation::Call("arccos", vec![c.clone().over(radius)]))),
        ]);
        let mut lines = vec![DisplayLine::equation(equation, c.clone())];
        let named = [a, b, c].into_iter().zip(coefficients);
        lines.extend(named.map(|(name, value)| self.definition(name, &[value])));

        lines.push(DisplayLine::equation(x, solution));
        lines
    }

    /// Two circles meet: v + w = d with the lengths of v and w. With k = |d|² + |v|² - |w|², v is
    /// d (k ± i √(4 |v|² |d|² - k²)) / (2 |d|²).
    fn two_angles(&mut self, arms: &[Arm; 2], target: ComplexNode) -> Vec<DisplayLine> {
        let [d, k] = self.fresh(['d', 'k']);
        let [first, second] = [&arms[0], &arms[1]].map(|arm| self.arm(arm));
        let [square_of_arm, other] = [&arms[0], &arms[1]].map(|arm| self.square(arm.factor));
        let square = d.clone().norm().squared();
        let radicand = Notation::product([Notation::Number(4.0), square_of_arm.clone(), square.clone()])
            .minus(k.clone().squared());
        let rotated = Notation::Sum(vec![
            k.clone(),
            Notation::Either(Box::new(Notation::product([Notation::Imaginary, radicand.root()]))),
        ]);
        let solution =
            Notation::product([d.clone(), rotated]).over(Notation::product([Notation::Number(2.0), square.clone()]));
        let rest = d.clone().minus(first.clone());
        let excess = if square_of_arm == other {
            square
        } else {
            Notation::sum([square, square_of_arm]).minus(other)
        };

        // the opposite of a link that is subtracted
        let last = match &second {
            Notation::Negative(link) => DisplayLine::equation((**link).clone(), first.clone().minus(d.clone())),
            _ => DisplayLine::equation(second.clone(), rest),
        };
        vec![
            DisplayLine::equation(Notation::sum([first.clone(), second]), d.clone()),
            self.definition(d, &[target.re, target.im]),
            DisplayLine::equation(k, excess),
            DisplayLine::equation(first, solution),
            last,
        ]
    }

    /// A circle meets a line: v + x u = d with the length of v. With k = u · d, x is
    /// (k ± √(k² - |u|² (|d|² - |v|²))) / |u|².
    fn angle_and_length(
        &mut self,
        length: usize,
        arm: &Arm,
        direction: ComplexNode,
        target: ComplexNode,
    ) -> Vec<DisplayLine> {
        let [d, u, k] = self.fresh(['d', 'u', 'k']);
        let (link, x) = (self.arm(arm), self.unknown(length));
        let square_of_arm = self.square(arm.factor);
        let difference = d.clone().norm().squared().minus(square_of_arm);
        let slide = u.clone().norm().squared();
        let radicand = k
            .clone()
            .squared()
            .minus(Notation::product([slide.clone(), difference]));
        let solution = Notation::Sum(vec![k.clone(), Notation::Either(Box::new(radicand.root()))]).over(slide);
        let travel = Notation::product([x.clone(), u.clone()]);
        vec![
            DisplayLine::equation(Notation::sum([link.clone(), travel.clone()]), d.clone()),
            self.definition(d.clone(), &[target.re, target.im]),
            self.definition(u.clone(), &[direction.re, direction.im]),
            DisplayLine::equation(k, Notation::Dot(Box::new(u), Box::new(d.clone()))),
            DisplayLine::equation(x, solution),
            DisplayLine::equation(link, d.minus(travel)),
        ]
    }

    /// A length and its direction: (x + o) e^(iθ) = d.
    fn polar(
        &self,
        [length, angle]: [usize; 2],
        is_mirrored: bool,
        offset: ComplexNode,
        target: ComplexNode,
    ) -> Vec<DisplayLine> {
        let [d] = self.fresh(['d']);
        let (x, theta) = (self.unknown(length), self.unknown(angle));
        let rotated = if is_mirrored {
            theta.clone().negative()
        } else {
            theta.clone()
        };
        let [along, beside] = [offset.re, offset.im].map(|part| self.scalar(part));
        let whole = Notation::sum([x.clone(), self.complex(offset)]);
        let radicand = match &beside {
            Notation::Number(0.0) => None,
            beside => Some(d.clone().norm().squared().minus(beside.clone().squared())),
        };
        let root = radicand.map_or_else(|| d.clone().norm(), Notation::root);
        let root = Notation::Either(Box::new(root));
        let solution = match along {
            Notation::Number(0.0) => root,
            along => Notation::Sum(vec![along.negative(), root]),
        };
        let direction = Notation::Call("arg", vec![d.clone().over(whole.clone())]);
        vec![
            DisplayLine::equation(Notation::product([whole, Notation::direction(rotated)]), d.clone()),
            self.definition(d, &[target.re, target.im]),
            DisplayLine::equation(x, solution),
            DisplayLine::equation(theta, if is_mirrored { direction.negative() } else { direction }),
        ]
    }

    /// The linear equations of a step of Newton's method.
    fn newton(&mut self, unknowns: &[usize], residuals: &[Node]) -> Vec<DisplayLine> {
        let indices: Vec<Option<usize>> = residuals
            .iter()
            .map(|&residual| self.residuals.index_of(residual))
            .collect();
        let known: Vec<usize> = indices.iter().copied().flatten().collect();
        let mut lines = self.residuals.definitions(&known);
        for (index, (&residual, known_index)) in residuals.iter().zip(&indices).enumerate() {
            let name = if let Some(known_index) = known_index {
                self.residuals.name(*known_index)
            } else {
                // an equation that an earlier part has changed
                let name = self.names.fresh('g');
                let name = if residuals.len() == 1 {
                    name
                } else {
                    name.indexed((index + 1).to_string())
                };
                lines.push(self.definition(Notation::Name(name.clone()), &[residual]));
                name
            };
            let steps: Vec<Notation> = unknowns
                .iter()
                .filter(|&&unknown| self.graph.contains(residual, Symbol::Unknown(unknown)))
                .map(|&unknown| {
                    let unknown = self.names.unknown(unknown).clone();
                    Notation::product([change_over(&name, &unknown), Notation::Change('Δ', unknown)])
                })
                .collect();
            lines.push(DisplayLine::equation(
                Notation::sum(steps),
                Notation::Name(name).negative(),
            ));
        }
        lines
    }

    /// The angle of a link whose vector is known.
    fn angle_of(&mut self, arm: &Arm, vector: Notation) -> DisplayLine {
        let angle = arm.angle.node(self.graph);
        let angle = self.scalar(angle);
        let direction = Notation::Call("arg", vec![vector.over(self.complex(arm.factor))]);
        DisplayLine::equation(angle, if arm.mirrored { direction.negative() } else { direction })
    }

    /// The vector of a link.
    fn arm(&mut self, arm: &Arm) -> Notation {
        let angle = arm.angle.node(self.graph);
        let angle = self.scalar(angle);
        let direction = Notation::direction(if arm.mirrored { angle.negative() } else { angle });
        Notation::product([self.complex(arm.factor), direction])
    }

    /// The square of a vector's length.
    fn square(&self, vector: ComplexNode) -> Notation {
        let real = if vector.is_real(self.graph) {
            vector.re
        } else if self.graph.is_zero(vector.re) {
            vector.im
        } else {
            return self.complex(vector).norm().squared();
        };
        match self.scalar(real) {
            Notation::Negative(of) => of.squared(),
            other => other.squared(),
        }
    }

    fn unknown(&self, index: usize) -> Notation {
        Notation::Name(self.names.unknown(index).clone())
    }

    fn fresh<const COUNT: usize>(&self, letters: [char; COUNT]) -> [Notation; COUNT] {
        letters.map(|letter| Notation::Name(self.names.fresh(letter)))
    }

    fn expressions(&self) -> Expressions<'_> {
        Expressions {
            graph: self.graph,
            names: self.names,
            results: &self.results,
        }
    }

    /// The definition of a name: a scalar, or a vector of the plane by its two parts.
    fn definition(&self, name: Notation, parts: &[Node]) -> DisplayLine {
        let value = match *parts {
            [re, im] => self.expressions().complex(re, im),
            _ => parts.first().and_then(|&part| self.expressions().scalar(part)),
        };
        let value = value.unwrap_or_else(|| match &name {
            Notation::Name(name) => self.dependence(name.clone(), parts),
            _ => Notation::Dots,
        });
        DisplayLine::equation(name, value)
    }

    /// A scalar, or the quantities that it depends on if it is too long to be read.
    fn scalar(&self, node: Node) -> Notation {
        self.expressions()
            .scalar(node)
            .unwrap_or_else(|| self.dependence(self.names.fresh('h'), &[node]))
    }

    /// A vector of the plane, or the quantities that it depends on if it is too long to be read.
    fn complex(&self, vector: ComplexNode) -> Notation {
        let term = self.expressions().complex(vector.re, vector.im);
        term.unwrap_or_else(|| self.dependence(self.names.fresh('h'), &[vector.re, vector.im]))
    }

    /// An expression that is too long to be read, as a function of the inputs and unknowns that it contains.
    fn dependence(&self, name: Name, nodes: &[Node]) -> Notation {
        let reachable = self.graph.reachable(nodes).into_iter();
        let contained: BTreeSet<Symbol> = reachable.filter_map(|node| self.graph.as_symbol(node)).collect();
        let varying = contained
            .into_iter()
            .filter(|symbol| !matches!(symbol, Symbol::Parameter(_)));
        let names =
            varying.filter_map(|symbol| self.names.symbol(symbol).or_else(|| self.results.get(&symbol).cloned()));
        let names: Vec<Notation> = names.map(Notation::Name).collect();
        if names.is_empty() {
            Notation::Words("constant")
        } else {
            Notation::Function(name, names)
        }
    }
}

/// The argument of a function with a known value.
fn inverted(function: Function, value: Notation) -> Notation {
    match function.undone_by() {
        Some(inverse) => Notation::Call(inverse, vec![value]),
        // the square root
        None => value.squared(),
    }
}
