//! The solution of each block, line by line.

use std::collections::{BTreeMap, BTreeSet};

use super::expression::Expressions;
use super::name::Name;
use super::names::Names;
use super::rates::{Residuals, change_over};
use super::term::{Line, Term};
use crate::algebra::{Function, Graph, Node, Symbol};
use crate::structure::{Arm, Block, ClosedForm, ComplexNode, Method, Part};

/// The solutions of parts. The names that they introduce hold for one part each.
pub(super) struct Solutions<'a> {
    pub(super) graph: &'a mut Graph,
    pub(super) names: &'a Names,
    pub(super) residuals: &'a Residuals<'a>,
    /// The results that later formulas of the same part use.
    results: BTreeMap<Symbol, Name>,
}

impl<'a> Solutions<'a> {
    pub(super) const fn new(graph: &'a mut Graph, names: &'a Names, residuals: &'a Residuals<'a>) -> Self {
        Self {
            graph,
            names,
            residuals,
            results: BTreeMap::new(),
        }
    }

    /// The formulas that solve a block.
    pub(super) fn block(&mut self, block: &Block) -> Vec<Line> {
        let mut lines = Vec::new();
        for part in &block.parts {
            self.results.clear();
            lines.extend(self.part(part));
        }
        lines
    }

    fn part(&mut self, part: &Part) -> Vec<Line> {
        match &part.method {
            Method::Closed(form) => self.closed(form),
            Method::Newton { residuals, .. } => self.newton(&part.unknowns, residuals),
        }
    }

    fn closed(&mut self, form: &ClosedForm) -> Vec<Line> {
        match form {
            ClosedForm::Linear {
                unknown,
                coefficient,
                right,
            } => {
                let quotient = self.graph.divide(*right, *coefficient);
                vec![Line::equation(self.unknown(*unknown), self.scalar(quotient))]
            }
            ClosedForm::SquareRoot { unknown, square } => {
                vec![Line::equation(
                    self.unknown(*unknown),
                    Term::Either(Box::new(self.scalar(*square).root())),
                )]
            }
            ClosedForm::Quadratic { unknown, a, b, c } => self.quadratic(*unknown, [*a, *b, *c]),
            ClosedForm::InverseCosine { unknown, radius, width } => {
                let ratio = self.graph.divide(*width, *radius);
                let angle = Term::Call("arccos", vec![self.scalar(ratio)]);
                vec![Line::equation(self.unknown(*unknown), Term::Either(Box::new(angle)))]
            }
            ClosedForm::InverseSine {
                unknown,
                radius,
                height,
            } => {
                let ratio = self.graph.divide(*height, *radius);
                let angle = Term::Call("arcsin", vec![self.scalar(ratio)]);
                let other = Term::Pi.minus(angle.clone());
                vec![
                    Line::equation(self.unknown(*unknown), angle),
                    Line::equation(Term::product([Term::Words("or"), self.unknown(*unknown)]), other),
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
                let mut lines = vec![Line::equation(Term::Name(name), inverted)];
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
                    Line::equation(Term::Name(name), Term::Either(Box::new(inverted))),
                    Line::equation(self.unknown(*unknown), self.scalar(quotient)),
                ]
            }
            ClosedForm::LinearPair {
                unknowns,
                matrix,
                right,
            } => matrix
                .iter()
                .zip(right)
                .map(|(row, &right)| {
                    let terms = row
                        .iter()
                        .zip(unknowns)
                        .filter(|(entry, _)| !self.graph.is_zero(**entry));
                    let left =
                        terms.map(|(&entry, &unknown)| Term::product([self.scalar(entry), self.unknown(unknown)]));
                    Line::equation(Term::sum(left.collect::<Vec<_>>()), self.scalar(right))
                })
                .collect(),
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
                    Line::equation(self.arm(arm), d.clone()),
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

    /// x = (-b ± √(b² - 4 a c)) / (2 a)
    fn quadratic(&self, unknown: usize, coefficients: [Node; 3]) -> Vec<Line> {
        let [a, b, c] = self.fresh(['a', 'b', 'c']);
        let x = self.unknown(unknown);

        let product = Term::product([Term::Number(4.0), a.clone(), c.clone()]);
        let root = b.clone().squared().minus(product).root();
        let equation = Term::sum([
            Term::product([a.clone(), x.clone().squared()]),
            Term::product([b.clone(), x.clone()]),
            c.clone(),
        ]);
        let solution = Term::Sum(vec![b.clone().negative(), Term::Either(Box::new(root))])
            .over(Term::product([Term::Number(2.0), a.clone()]));
        let mut lines = vec![Line::equation(equation, Term::Number(0.0))];
        let named = [a, b, c].into_iter().zip(coefficients);
        lines.extend(named.map(|(name, value)| self.definition(name, &[value])));

        lines.push(Line::equation(x, solution));
        lines
    }

    /// The solution of a cos x + b sin x = c: x = atan2(b, a) ± arccos(c / √(a² + b²)).
    fn cosine_and_sine(&self, unknown: usize, coefficients: [Node; 3]) -> Vec<Line> {
        let [a, b, c] = self.fresh(['a', 'b', 'c']);
        let x = self.unknown(unknown);

        let equation = Term::sum([
            Term::product([a.clone(), Term::Call("cos", vec![x.clone()])]),
            Term::product([b.clone(), Term::Call("sin", vec![x.clone()])]),
        ]);
        let radius = Term::sum([a.clone().squared(), b.clone().squared()]).root();
        let solution = Term::Sum(vec![
            Term::Call("atan2", vec![b.clone(), a.clone()]),
            Term::Either(Box::new(Term::Call("arccos", vec![c.clone().over(radius)]))),
        ]);
        let mut lines = vec![Line::equation(equation, c.clone())];
        let named = [a, b, c].into_iter().zip(coefficients);
        lines.extend(named.map(|(name, value)| self.definition(name, &[value])));

        lines.push(Line::equation(x, solution));
        lines
    }

    /// Two circles meet: v + w = d with the lengths of v and w. With k = |d|² + |v|² - |w|², v is
    /// d (k ± i √(4 |v|² |d|² - k²)) / (2 |d|²).
    fn two_angles(&mut self, arms: &[Arm; 2], target: ComplexNode) -> Vec<Line> {
        let [d, k] = self.fresh(['d', 'k']);
        let [first, second] = [&arms[0], &arms[1]].map(|arm| self.arm(arm));
        let [own, other] = [&arms[0], &arms[1]].map(|arm| self.square(arm.factor));
        let square = d.clone().norm().squared();
        let radicand = Term::product([Term::Number(4.0), own.clone(), square.clone()]).minus(k.clone().squared());
        let turned = Term::Sum(vec![
            k.clone(),
            Term::Either(Box::new(Term::product([Term::Imaginary, radicand.root()]))),
        ]);
        let solution = Term::product([d.clone(), turned]).over(Term::product([Term::Number(2.0), square.clone()]));
        let rest = d.clone().minus(first.clone());
        let excess = if own == other {
            square
        } else {
            Term::sum([square, own]).minus(other)
        };

        // the opposite of a link that is subtracted
        let last = match &second {
            Term::Negative(link) => Line::equation((**link).clone(), first.clone().minus(d.clone())),
            _ => Line::equation(second.clone(), rest),
        };
        vec![
            Line::equation(Term::sum([first.clone(), second]), d.clone()),
            self.definition(d, &[target.re, target.im]),
            Line::equation(k, excess),
            Line::equation(first, solution),
            last,
        ]
    }

    /// A circle meets a line: v + x u = d with the length of v. With k = u · d, x is
    /// (k ± √(k² - |u|² (|d|² - |v|²))) / |u|².
    fn angle_and_length(&mut self, length: usize, arm: &Arm, direction: ComplexNode, target: ComplexNode) -> Vec<Line> {
        let [d, u, k] = self.fresh(['d', 'u', 'k']);
        let (link, x) = (self.arm(arm), self.unknown(length));
        let own = self.square(arm.factor);
        let difference = d.clone().norm().squared().minus(own);
        let slide = u.clone().norm().squared();
        let radicand = k.clone().squared().minus(Term::product([slide.clone(), difference]));
        let solution = Term::Sum(vec![k.clone(), Term::Either(Box::new(radicand.root()))]).over(slide);
        let travel = Term::product([x.clone(), u.clone()]);
        vec![
            Line::equation(Term::sum([link.clone(), travel.clone()]), d.clone()),
            self.definition(d.clone(), &[target.re, target.im]),
            self.definition(u.clone(), &[direction.re, direction.im]),
            Line::equation(k, Term::Dot(Box::new(u), Box::new(d.clone()))),
            Line::equation(x, solution),
            Line::equation(link, d.minus(travel)),
        ]
    }

    /// A length and its direction: (x + o) e^(iθ) = d.
    fn polar(
        &self,
        [length, angle]: [usize; 2],
        is_mirrored: bool,
        offset: ComplexNode,
        target: ComplexNode,
    ) -> Vec<Line> {
        let [d] = self.fresh(['d']);
        let (x, theta) = (self.unknown(length), self.unknown(angle));
        let turned = if is_mirrored {
            theta.clone().negative()
        } else {
            theta.clone()
        };
        let [along, beside] = [offset.re, offset.im].map(|part| self.scalar(part));
        let whole = Term::sum([x.clone(), self.complex(offset)]);
        let radicand = match &beside {
            Term::Number(0.0) => None,
            beside => Some(d.clone().norm().squared().minus(beside.clone().squared())),
        };
        let root = radicand.map_or_else(|| d.clone().norm(), Term::root);
        let root = Term::Either(Box::new(root));
        let solution = match along {
            Term::Number(0.0) => root,
            along => Term::Sum(vec![along.negative(), root]),
        };
        let direction = Term::Call("arg", vec![d.clone().over(whole.clone())]);
        vec![
            Line::equation(Term::product([whole, Term::direction(turned)]), d.clone()),
            self.definition(d, &[target.re, target.im]),
            Line::equation(x, solution),
            Line::equation(theta, if is_mirrored { direction.negative() } else { direction }),
        ]
    }

    /// The linear equations of a step of Newton's method.
    fn newton(&mut self, unknowns: &[usize], residuals: &[Node]) -> Vec<Line> {
        let places: Vec<Option<usize>> = residuals
            .iter()
            .map(|&residual| self.residuals.place(residual))
            .collect();
        let known: Vec<usize> = places.iter().copied().flatten().collect();
        let mut lines = self.residuals.definitions(&known);
        for (index, (&residual, place)) in residuals.iter().zip(&places).enumerate() {
            let name = if let Some(place) = place {
                self.residuals.name(*place)
            } else {
                // an equation that an earlier part has changed
                let name = self.names.fresh('g');
                let name = if residuals.len() == 1 {
                    name
                } else {
                    name.indexed((index + 1).to_string())
                };
                lines.push(self.definition(Term::Name(name.clone()), &[residual]));
                name
            };
            let steps: Vec<Term> = unknowns
                .iter()
                .filter(|&&unknown| self.graph.contains(residual, Symbol::Unknown(unknown)))
                .map(|&unknown| {
                    let unknown = self.names.unknown(unknown).clone();
                    Term::product([change_over(&name, &unknown), Term::Change('Δ', unknown)])
                })
                .collect();
            lines.push(Line::equation(Term::sum(steps), Term::Name(name).negative()));
        }
        lines
    }

    /// The angle of a link whose vector is known.
    fn angle_of(&mut self, arm: &Arm, vector: Term) -> Line {
        let angle = arm.angle.node(self.graph);
        let angle = self.scalar(angle);
        let direction = Term::Call("arg", vec![vector.over(self.complex(arm.factor))]);
        Line::equation(angle, if arm.mirrored { direction.negative() } else { direction })
    }

    /// The vector of a link.
    fn arm(&mut self, arm: &Arm) -> Term {
        let angle = arm.angle.node(self.graph);
        let angle = self.scalar(angle);
        let direction = Term::direction(if arm.mirrored { angle.negative() } else { angle });
        Term::product([self.complex(arm.factor), direction])
    }

    /// The square of a vector's length.
    fn square(&self, vector: ComplexNode) -> Term {
        let real = if vector.is_real(self.graph) {
            vector.re
        } else if self.graph.is_zero(vector.re) {
            vector.im
        } else {
            return self.complex(vector).norm().squared();
        };
        match self.scalar(real) {
            Term::Negative(of) => of.squared(),
            other => other.squared(),
        }
    }

    fn unknown(&self, index: usize) -> Term {
        Term::Name(self.names.unknown(index).clone())
    }

    fn fresh<const COUNT: usize>(&self, letters: [char; COUNT]) -> [Term; COUNT] {
        letters.map(|letter| Term::Name(self.names.fresh(letter)))
    }

    fn expressions(&self) -> Expressions<'_> {
        Expressions {
            graph: self.graph,
            names: self.names,
            results: &self.results,
        }
    }

    /// The definition of a name: a scalar, or a vector of the plane by its two parts.
    fn definition(&self, name: Term, parts: &[Node]) -> Line {
        let value = match *parts {
            [re, im] => self.expressions().complex(re, im),
            _ => parts.first().and_then(|&part| self.expressions().scalar(part)),
        };
        let value = value.unwrap_or_else(|| match &name {
            Term::Name(name) => self.dependence(name.clone(), parts),
            _ => Term::Dots,
        });
        Line::equation(name, value)
    }

    /// A scalar, or the quantities that it depends on if it is too long to be read.
    fn scalar(&self, node: Node) -> Term {
        self.expressions()
            .scalar(node)
            .unwrap_or_else(|| self.dependence(self.names.fresh('h'), &[node]))
    }

    /// A vector of the plane, or the quantities that it depends on if it is too long to be read.
    fn complex(&self, vector: ComplexNode) -> Term {
        let term = self.expressions().complex(vector.re, vector.im);
        term.unwrap_or_else(|| self.dependence(self.names.fresh('h'), &[vector.re, vector.im]))
    }

    /// An expression that is too long to be read, as a function of the inputs and unknowns that it contains.
    fn dependence(&self, name: Name, nodes: &[Node]) -> Term {
        let reachable = self.graph.reachable(nodes).into_iter();
        let contained: BTreeSet<Symbol> = reachable.filter_map(|node| self.graph.as_symbol(node)).collect();
        let varying = contained
            .into_iter()
            .filter(|symbol| !matches!(symbol, Symbol::Parameter(_)));
        let names =
            varying.filter_map(|symbol| self.names.symbol(symbol).or_else(|| self.results.get(&symbol).cloned()));
        let names: Vec<Term> = names.map(Term::Name).collect();
        if names.is_empty() {
            Term::Words("constant")
        } else {
            Term::Function(name, names)
        }
    }
}

/// The argument of a function with a known value.
fn inverted(function: Function, value: Term) -> Term {
    match function.undone_by() {
        Some(inverse) => Term::Call(inverse, vec![value]),
        // the square root
        None => value.squared(),
    }
}
