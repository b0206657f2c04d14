//! Expressions of the graph in the notation of the field.

use std::collections::BTreeMap;

use super::name::Name;
use super::names::NotationNames;
use super::term::Notation;
use super::typed::{complex, elementary};
use crate::algebra::{Function, Graph, Node, NodeKind, Symbol};
use crate::syntax::Axis;

/// The largest number of symbols of an expression that is printed.
const LARGEST: usize = 60;

/// The largest number of symbols of a coefficient that is printed.
const LARGEST_COEFFICIENT: usize = 30;

/// The largest divisors of a number that is printed as a fraction: of any kind, and among the powers of two.
const LARGEST_DIVISORS: [u32; 2] = [64, 1024];

/// The longest decimal number that is printed as it is, if it is a fraction.
const LONGEST_DECIMAL: usize = 5;

/// Converts expressions into terms.
pub(super) struct Expressions<'a> {
    pub(super) graph: &'a Graph,
    pub(super) names: &'a NotationNames,
    /// The names of results within a solution.
    pub(super) results: &'a BTreeMap<Symbol, Name>,
}

/// A number times factors, and the unit vector of an angle.
#[derive(Clone, PartialEq)]
struct TurningVector {
    coefficient: f64,
    factors: Vec<(Node, i32)>,
    /// The angle of the unit vector, if there is one.
    angle: Option<Node>,
    is_mirrored: bool,
    /// Whether there is a factor i.
    is_quarter: bool,
    /// The vector that a real and an imaginary part make up.
    vector: Option<Name>,
}

impl Expressions<'_> {
    /// A scalar; `None` if it is too long to be read.
    pub(super) fn scalar(&self, node: Node) -> Option<Notation> {
        let mut room = LARGEST;
        self.convert(node, &mut room)
    }

    /// A scalar that stands among others; `None` if it is too long to be read.
    pub(super) fn coefficient(&self, node: Node) -> Option<Notation> {
        let mut room = LARGEST_COEFFICIENT;
        self.convert(node, &mut room)
    }

    fn convert(&self, node: Node, room: &mut usize) -> Option<Notation> {
        *room = room.checked_sub(1)?;
        Some(match self.graph.kind(node) {
            NodeKind::Number(value) => number(value.get()),
            NodeKind::Pi => Notation::Pi,
            NodeKind::Symbol(symbol) => Notation::Name(self.name(*symbol)?),
            NodeKind::Sum(constant, terms) => {
                let mut sum = Vec::new();
                for &(node, coefficient) in terms {
                    let term = self.convert(node, room)?;
                    sum.push(scaled(coefficient.get(), term));
                }
                sum.push(number(constant.get()));
                positive_first(sum)
            }
            NodeKind::Product(factors) => self.factors(factors, room)?,
            NodeKind::Call(function, arguments) => {
                let arguments: Option<Vec<Notation>> =
                    arguments.iter().map(|&argument| self.convert(argument, room)).collect();
                elementary(*function, arguments?)
            }
        })
    }

    fn name(&self, symbol: Symbol) -> Option<Name> {
        self.results.get(&symbol).cloned().or_else(|| self.names.symbol(symbol))
    }

    /// A product of powers, as a quotient if some exponents are negative. Functions come last.
    fn factors(&self, factors: &[(Node, i32)], room: &mut usize) -> Option<Notation> {
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for &(node, exponent) in factors {
            let term = self.convert(node, room)?;
            let power = term.power(i32::try_from(exponent.unsigned_abs()).ok()?);
            if exponent > 0 { &mut above } else { &mut below }.push(power);
        }
        let product = functions_last(above);
        Some(if below.is_empty() {
            product
        } else {
            product.over(functions_last(below))
        })
    }

    /// A vector of the plane as a complex number; `None` if it is too long to be read. Sines and cosines with one
    /// factor become unit vectors, and the parts of a vector become the vector.
    pub(super) fn complex(&self, re: Node, im: Node) -> Option<Notation> {
        let (re, mut im) = (self.terms(re), self.terms(im));
        let (mut turning, mut real) = (Vec::new(), Vec::new());
        for (coefficient, factors) in re {
            match self.turning(coefficient, &factors, &mut im) {
                Some(found) => turning.push(found),
                None => real.push((coefficient, factors)),
            }
        }
        let plain = |(coefficient, factors), is_quarter| TurningVector {
            coefficient,
            factors,
            angle: None,
            is_mirrored: false,
            is_quarter,
            vector: None,
        };
        turning.extend(real.into_iter().map(|term| plain(term, false)));
        turning.extend(im.into_iter().map(|term| plain(term, true)));
        self.merge(&mut turning);

        let mut room = LARGEST;
        let (mut sum, mut imaginary) = (Vec::new(), Vec::new());
        for TurningVector {
            coefficient,
            factors,
            angle,
            is_mirrored,
            is_quarter,
            vector,
        } in turning
        {
            let mut parts = Vec::new();
            parts.extend((is_quarter && angle.is_some()).then_some(Notation::Imaginary));
            parts.push(self.factors(&factors, &mut room)?);
            parts.extend(vector.map(Notation::Name));
            if let Some(angle) = angle {
                let angle = self.convert(angle, &mut room)?;
                parts.push(Notation::direction(if is_mirrored { angle.negative() } else { angle }));
                sum.push(scaled(coefficient, Notation::product(parts)));
            } else if is_quarter {
                imaginary.push(scaled(coefficient, Notation::product(parts)));
            } else {
                sum.push(scaled(coefficient, Notation::product(parts)));
            }
        }
        sum.push(complex(Notation::Number(0.0), positive_first(imaginary)));
        Some(positive_first(sum))
    }

    /// The terms of a sum, each as a number and powers.
    fn terms(&self, node: Node) -> Vec<(f64, Vec<(Node, i32)>)> {
        let factors = |node: Node| match self.graph.kind(node) {
            NodeKind::Product(factors) => factors.clone(),
            _ => vec![(node, 1)],
        };
        match self.graph.kind(node) {
            NodeKind::Number(value) if value.get() == 0.0 => Vec::new(),
            NodeKind::Number(value) => vec![(value.get(), Vec::new())],
            NodeKind::Sum(constant, terms) => {
                let constant = (constant.get() != 0.0).then(|| (constant.get(), Vec::new()));
                terms
                    .iter()
                    .map(|&(term, coefficient)| (coefficient.get(), factors(term)))
                    .chain(constant)
                    .collect()
            }
            _ => vec![(1.0, factors(node))],
        }
    }

    /// A real part with a sine or a cosine, together with the imaginary part that makes it a unit vector.
    fn turning(
        &self,
        coefficient: f64,
        factors: &[(Node, i32)],
        imaginary: &mut Vec<(f64, Vec<(Node, i32)>)>,
    ) -> Option<TurningVector> {
        let without = |factors: &[(Node, i32)], factor: usize| {
            let mut rest = factors.to_vec();
            rest.remove(factor);
            rest
        };
        for (factor, &(node, exponent)) in factors.iter().enumerate() {
            let NodeKind::Call(function @ (Function::Sin | Function::Cos), arguments) = self.graph.kind(node) else {
                continue;
            };
            let (Some(partner), 1, &[angle]) = (function.partner(), exponent, arguments.as_slice()) else {
                continue;
            };
            let rest = without(factors, factor);
            let matching = imaginary.iter().enumerate().find_map(|(index, (other, factors))| {
                let is_partner = |&(node, exponent): &(Node, i32)| {
                    let NodeKind::Call(function, arguments) = self.graph.kind(node) else {
                        return false;
                    };
                    *function == partner && exponent == 1 && arguments.as_slice() == [angle]
                };
                let factor = factors.iter().position(is_partner)?;
                (other.abs() == coefficient.abs() && without(factors, factor) == rest).then_some((index, *other))
            });
            let Some((index, other)) = matching else { continue };
            imaginary.remove(index);
            // c (cos + i sin), c (cos - i sin), c (i cos - sin), c (i cos + sin)
            let is_quarter = *function == Function::Sin;
            return Some(TurningVector {
                coefficient: if is_quarter { other } else { coefficient },
                factors: rest,
                angle: Some(angle),
                is_mirrored: (other == coefficient) == is_quarter,
                is_quarter,
                vector: None,
            });
        }
        None
    }

    /// Joins the terms of a vector's two parts, `p_x + i p_y`.
    fn merge(&self, terms: &mut Vec<TurningVector>) {
        let part = |turning: &TurningVector, wanted: Axis| {
            turning
                .factors
                .iter()
                .enumerate()
                .find_map(|(factor, &(node, exponent))| {
                    let symbol = self.graph.as_symbol(node)?;
                    let (name, axis) = self.names.part(symbol)?;
                    let mut rest = turning.factors.clone();
                    rest.remove(factor);
                    (axis == wanted && exponent == 1).then(|| (name.clone(), rest))
                })
        };
        let mut first = 0;
        while first < terms.len() {
            let found = part(&terms[first], Axis::X).filter(|_| !terms[first].is_quarter);
            let joined = found.and_then(|(name, rest)| {
                let whole = TurningVector {
                    factors: rest,
                    vector: Some(name),
                    ..terms[first].clone()
                };
                let partner = terms.iter().position(|other| {
                    other.is_quarter
                        && part(other, Axis::Y).is_some_and(|(name, rest)| {
                            let other = TurningVector {
                                factors: rest,
                                vector: Some(name),
                                is_quarter: false,
                                ..other.clone()
                            };
                            other == whole
                        })
                })?;
                Some((whole, partner))
            });
            if let Some((whole, partner)) = joined {
                terms[first] = whole;
                terms.remove(partner);
                first -= usize::from(partner < first);
            }
            first += 1;
        }
    }
}

/// A number of either sign: short decimals as they are, others as fractions of small numbers where they are such.
fn number(value: f64) -> Notation {
    let size = value.abs();
    if size.to_string().len() > LONGEST_DECIMAL {
        let [all, powers_of_two] = LARGEST_DIVISORS;
        let is_allowed = |divisor: &u32| *divisor <= all || divisor.is_power_of_two();
        for divisor in (2..=powers_of_two).filter(is_allowed) {
            let dividend = (size * f64::from(divisor)).round();
            if dividend > 0.0 && dividend < 1e6 && dividend / f64::from(divisor) == size {
                let fraction = Notation::Number(dividend).over(Notation::Number(f64::from(divisor)));
                return if value < 0.0 { fraction.negative() } else { fraction };
            }
        }
    }
    Notation::number(value)
}

/// A number times a term. Fractions become one fraction, and signs are taken into sums of both signs.
fn scaled(coefficient: f64, term: Notation) -> Notation {
    let (mut above, mut below) = (Vec::new(), Vec::new());
    let inverse = 1.0 / coefficient.abs();
    match number(coefficient.abs()) {
        // a half rather than 0.5
        _ if [2.0, 4.0, 8.0].contains(&inverse) => below.push(Notation::Number(inverse)),
        Notation::Quotient(dividend, divisor) => {
            above.push(*dividend);
            below.push(*divisor);
        }
        number => above.push(number),
    }
    if coefficient == -1.0 {
        return opposite(term);
    }
    let (first, rest) = match term {
        Notation::Product(mut factors) if !below.is_empty() => (factors.remove(0), factors),
        other => (other, Vec::new()),
    };
    let rest = match first {
        Notation::Quotient(dividend, divisor) => {
            above.push(*dividend);
            below.push(*divisor);
            rest
        }
        first => {
            above.push(first);
            above.extend(rest);
            Vec::new()
        }
    };
    let fraction = Notation::product(above).over(Notation::product(below));
    let product = Notation::product([fraction].into_iter().chain(rest));
    if coefficient < 0.0 { product.negative() } else { product }
}

/// The opposite of a term. A sum of both signs changes its signs, and so does a fraction with such a sum above.
fn opposite(term: Notation) -> Notation {
    match term {
        Notation::Sum(terms) if terms.iter().any(|term| matches!(term, Notation::Negative(_))) => {
            positive_first(terms.into_iter().map(Notation::negative).collect())
        }
        Notation::Quotient(dividend, divisor) => opposite(*dividend).over(*divisor),
        other => other.negative(),
    }
}

/// A product with the functions behind all other factors, so that their arguments need no parentheses.
pub(super) fn functions_last(factors: Vec<Notation>) -> Notation {
    let is_function = |term: &Notation| match term {
        Notation::Call(..) => true,
        Notation::Power(base, _) => matches!(**base, Notation::Call(..)),
        _ => false,
    };
    let (functions, others): (Vec<Notation>, Vec<Notation>) = factors.into_iter().partition(is_function);
    Notation::product(others.into_iter().chain(functions))
}

/// A sum that begins with a positive term, if it has one.
fn positive_first(mut terms: Vec<Notation>) -> Notation {
    terms.retain(|term| *term != Notation::Number(0.0));
    if let Some(positive) = terms.iter().position(|term| !matches!(term, Notation::Negative(_))) {
        let first = terms.remove(positive);
        terms.insert(0, first);
    }
    Notation::sum(terms)
}
