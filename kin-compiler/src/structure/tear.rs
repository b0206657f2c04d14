//! Tearing: as much of a block as possible is solved in closed form, and Newton's method solves the rest.
//!
//! The relations that are taken out leave no choice, so tearing adds no singular positions to those of the block:
//!
//! - An equation that is linear in an unknown, with a number as its coefficient, gives this unknown from the others.
//! - A link whose angle occurs in one loop only is replaced by its length: |C|² = |A|² for A cis(θ) = C. Its direction
//!   is that of C.
//!
//! The remaining equations may fall into smaller parts, or have a closed form. (The word "tearing" is G. Kron's:
//! "Diakoptics", 1963.)
//!
//! An unknown that is replaced by its relation hands its rounding errors on, [magnified](Growth) by the coefficients of
//! the relation. One relation replaced in another multiplies them: a chain `20 x₀ - x₁ = t`, `20 x₁ - x₀ - x₂ = k`, …
//! would be shot through from its first unknown. Links magnify nothing, because a direction depends on the vector
//! alone.

use std::collections::{BTreeMap, BTreeSet};

use super::growth::{CLOSED, COUPLED, CoefficientMagnitudes, Growth};
use super::matching::Matching;
use super::{ClosedForm, Method, Part, incidence, order, recognise, without_cancelling};
use crate::algebra::{Expansion, Graph, Node, Symbol, TrigonometricPolynomial, Variables};
use crate::work;

/// The parts into which equations fall, in the order in which they are solved.
///
/// As much as possible is taken out if closed forms solve the rest. Equations that need a guess anyway keep the
/// unknowns whose relations would magnify rounding, and Newton's method sees their equations as they are.
pub(super) fn parts(
    graph: &mut Graph,
    magnitudes: &CoefficientMagnitudes,
    equations: &[Node],
    unknowns: &[usize],
) -> Vec<Part> {
    let mut tearing = Tearing::new(magnitudes, f64::INFINITY);
    let parts = tearing.parts(graph, equations, unknowns);
    let is_closed = parts.iter().all(|part| matches!(part.method, Method::Closed(_)));
    if tearing.growth.get() <= COUPLED {
        return parts;
    }
    if is_closed && let Some(system) = recognise::linear_system(graph, equations, unknowns) {
        return vec![closed(unknowns.to_vec(), system)];
    }
    if is_closed && tearing.growth.get() <= CLOSED {
        return parts;
    }
    Tearing::new(magnitudes, COUPLED).parts(graph, equations, unknowns)
}

/// What is taken out of a block, and what that does to rounding errors.
struct Tearing<'a> {
    magnitudes: &'a CoefficientMagnitudes,
    /// The growth above which nothing is replaced by its relation.
    largest: f64,
    /// The growth through all relations so far.
    growth: Growth,
}

impl<'a> Tearing<'a> {
    fn new(magnitudes: &'a CoefficientMagnitudes, largest: f64) -> Self {
        Self {
            magnitudes,
            largest,
            growth: Growth::NONE,
        }
    }

    fn parts(&mut self, graph: &mut Graph, equations: &[Node], unknowns: &[usize]) -> Vec<Part> {
        let equations = &without_cancelling(graph, equations, Variables::Unknowns(unknowns));
        // renumbered within the block, because the matching counts from zero
        let incidence: Vec<BTreeSet<usize>> = incidence(graph, equations, Variables::Unknowns(unknowns))
            .into_iter()
            .map(|members| {
                members
                    .into_iter()
                    .filter_map(|unknown| unknowns.iter().position(|&other| other == unknown))
                    .collect()
            })
            .collect();
        let matching = Matching::of(&incidence, unknowns.len());
        if !matching.faults(&incidence).is_empty() {
            // an unknown cancelled when another was taken out: solve the equations as they are
            return vec![newton(equations, unknowns, false)];
        }
        let mut parts = Vec::new();
        for block in order::blocks(&incidence, &matching) {
            let mut members: Vec<usize> = block
                .iter()
                .map(|&equation| unknowns[matching.unknown_of(equation)])
                .collect();
            members.sort_unstable();
            let nodes: Vec<Node> = block.iter().map(|&equation| equations[equation]).collect();
            parts.extend(self.connected(graph, &nodes, &members));
        }
        parts
    }

    /// The parts of equations that cannot be ordered further.
    fn connected(&mut self, graph: &mut Graph, equations: &[Node], unknowns: &[usize]) -> Vec<Part> {
        let mut is_complete = true;
        let polynomials: Vec<TrigonometricPolynomial> = equations
            .iter()
            .map(|&equation| {
                let mut expansion = Expansion::new(graph, Variables::Unknowns(unknowns));
                let polynomial = expansion.equation(equation);
                is_complete &= expansion.is_complete();
                polynomial
            })
            .collect();
        if let Some(form) = recognise::closed_form(graph, &polynomials, unknowns) {
            return vec![closed(unknowns.to_vec(), form)];
        }
        if work::is_spent() {
            return vec![newton(equations, unknowns, true)];
        }
        let torn = self
            .relation(graph, equations, unknowns, linear_relation)
            .or_else(|| link(graph, equations, &polynomials, unknowns))
            .or_else(|| self.relation(graph, equations, unknowns, relation));
        let Some(Torn { rest, unknown, form }) = torn else {
            return vec![newton(equations, unknowns, !is_complete)];
        };
        let others: Vec<usize> = unknowns.iter().copied().filter(|&other| other != unknown).collect();
        let mut parts = self.parts(graph, &rest, &others);
        parts.push(closed(vec![unknown], form));
        parts
    }

    /// Takes out the first relation of a kind that does not magnify rounding errors too much.
    fn relation<K>(&mut self, graph: &mut Graph, equations: &[Node], unknowns: &[usize], kind: K) -> Option<Torn>
    where
        K: Fn(&mut Graph, Node, &[usize], &mut dyn FnMut(&mut Graph, usize, Node) -> bool) -> Option<(usize, Node)>,
    {
        equations.iter().enumerate().find_map(|(index, &equation)| {
            let mut grown = self.growth;
            let (unknown, coefficient) = kind(graph, equation, unknowns, &mut |graph, unknown, coefficient| {
                let others = unknowns.iter().copied().filter(|&other| other != unknown);
                grown = self
                    .growth
                    .through(graph, self.magnitudes, equation, (unknown, coefficient), others);
                grown.get() <= self.largest
            })?;
            self.growth = grown;
            Some(substituted(graph, equations, index, unknown, coefficient))
        })
    }
}

/// A block without its linear relations. The solutions of the remaining equations are those of the block.
pub(super) struct Whole {
    pub(super) equations: Vec<Node>,
    pub(super) unknowns: Vec<usize>,
    /// The relations that were taken out, in the order in which they are solved after the rest.
    pub(super) relations: Vec<ClosedForm>,
}

/// A block without the unknowns that linear relations give.
pub(super) fn whole(graph: &mut Graph, equations: &[Node], unknowns: &[usize]) -> Whole {
    let mut whole = Whole {
        equations: equations.to_vec(),
        unknowns: unknowns.to_vec(),
        relations: Vec::new(),
    };
    while whole.unknowns.len() > 1
        && !work::is_spent()
        && let Some(Torn { rest, unknown, form }) = whole.equations.iter().enumerate().find_map(|(index, &equation)| {
            let (unknown, coefficient) = linear_relation(graph, equation, &whole.unknowns, &mut |_, _, _| true)?;
            Some(substituted(graph, &whole.equations, index, unknown, coefficient))
        })
    {
        whole.equations = rest;
        whole.unknowns.retain(|&other| other != unknown);
        whole.relations.insert(0, form);
    }
    whole
}

/// The result of taking an unknown out: the remaining equations, and the relation that gives the unknown after they are
/// solved.
struct Torn {
    rest: Vec<Node>,
    unknown: usize,
    form: ClosedForm,
}

fn closed(unknowns: Vec<usize>, form: ClosedForm) -> Part {
    Part {
        unknowns,
        method: Method::Closed(form),
    }
}

fn newton(equations: &[Node], unknowns: &[usize], is_given_up: bool) -> Part {
    Part {
        unknowns: unknowns.to_vec(),
        method: Method::Newton {
            residuals: equations.to_vec(),
            is_given_up,
        },
    }
}

/// The unknown that an equation gives if the equation is linear in all of its unknowns, such as the relation of two
/// gears: the first one whose coefficient is 1 or -1, with the coefficient. `accepts` may refuse it.
fn linear_relation(
    graph: &mut Graph,
    equation: Node,
    unknowns: &[usize],
    accepts: &mut dyn FnMut(&mut Graph, usize, Node) -> bool,
) -> Option<(usize, Node)> {
    let partials: Vec<(usize, Node)> = unknowns
        .iter()
        .map(|&unknown| (unknown, graph.partial(equation, Symbol::Unknown(unknown))))
        .collect();
    let is_linear = partials.iter().all(|&(_, partial)| !graph.has_unknowns(partial));
    let (unknown, coefficient) = partials
        .into_iter()
        .find(|&(_, partial)| graph.as_number(partial).is_some_and(|number| number.abs() == 1.0))?;
    (is_linear && accepts(graph, unknown, coefficient)).then_some((unknown, coefficient))
}

/// The first unknown that an equation contains with a number as its coefficient, such as a length along an axis, and
/// that `accepts` does not refuse.
fn relation(
    graph: &mut Graph,
    equation: Node,
    unknowns: &[usize],
    accepts: &mut dyn FnMut(&mut Graph, usize, Node) -> bool,
) -> Option<(usize, Node)> {
    unknowns.iter().find_map(|&unknown| {
        let coefficient = graph.partial(equation, Symbol::Unknown(unknown));
        let is_number = graph.as_number(coefficient).is_some_and(|number| number != 0.0);
        (is_number && accepts(graph, unknown, coefficient)).then_some((unknown, coefficient))
    })
}

/// The other equations with an unknown replaced by its solution from one equation.
fn substituted(graph: &mut Graph, equations: &[Node], index: usize, unknown: usize, coefficient: Node) -> Torn {
    let unknown_node = graph.symbol(Symbol::Unknown(unknown));
    let term = graph.multiply(coefficient, unknown_node);
    let mut right = graph.subtract(term, equations[index]);
    if graph.contains(right, Symbol::Unknown(unknown)) {
        // the unknown does not cancel within a product that is not multiplied out; set it to zero there, because the
        // equation is linear in it
        let mut vanished = BTreeMap::from([(unknown_node, graph.zero())]);
        let others = graph.substitute(equations[index], &mut vanished);
        right = graph.negate(others);
    }
    let value = graph.divide(right, coefficient);
    let mut replacements = BTreeMap::from([(unknown_node, value)]);
    let rest = equations
        .iter()
        .enumerate()
        .filter(|&(other, _)| other != index)
        .map(|(_, &equation)| graph.substitute(equation, &mut replacements))
        .collect();
    Torn {
        rest,
        unknown,
        form: ClosedForm::Linear {
            unknown,
            coefficient,
            right,
        },
    }
}

/// Takes out a link whose angle occurs only in the two equations of one loop.
fn link(
    graph: &mut Graph,
    equations: &[Node],
    polynomials: &[TrigonometricPolynomial],
    unknowns: &[usize],
) -> Option<Torn> {
    for &unknown in unknowns {
        let indices: Vec<usize> = (0..equations.len())
            .filter(|&index| polynomials[index].contains(graph, unknown))
            .collect();
        let &[first, second] = indices.as_slice() else {
            continue;
        };
        let Some((arm, rest)) = recognise::arm(graph, [&polynomials[first], &polynomials[second]], unknown) else {
            continue;
        };
        let (spanned, length) = (rest.norm_squared(graph), arm.factor.norm_squared(graph));
        let mut others: Vec<Node> = Vec::new();
        for (index, &equation) in equations.iter().enumerate() {
            if index == first {
                others.push(graph.subtract(spanned, length));
            } else if index != second {
                others.push(equation);
            }
        }
        return Some(Torn {
            rest: others,
            unknown,
            form: ClosedForm::Direction {
                unknown,
                arm,
                target: rest.negated(graph),
            },
        });
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The relations of gears are taken out of a block, one after the other, until one unknown is left.
    #[test]
    fn linear_relations_are_taken_out_of_a_block() {
        let mut graph = Graph::new();
        let p = graph.symbol(Symbol::Parameter(0));
        let [x, y, z] = [3, 4, 5].map(|unknown| graph.symbol(Symbol::Unknown(unknown)));
        let (first, second) = (
            graph.linear(0.0, &[(x, 2.0), (y, -1.0), (p, 1.0)]),
            graph.linear(0.0, &[(y, 3.0), (z, 1.0)]),
        );
        let sines = [x, y, z].map(|angle| graph.sine(angle));
        let last = graph.linear(-1.0, &[(sines[0], 1.0), (sines[1], 1.0), (sines[2], 1.0)]);

        let taken = whole(&mut graph, &[first, last, second], &[3, 4, 5]);
        // y = 2 x + p, z = -3 y
        assert_eq!(taken.unknowns, [3]);
        assert!(matches!(
            taken.relations[..],
            [
                ClosedForm::Linear { unknown: 4, .. },
                ClosedForm::Linear { unknown: 5, .. }
            ] | [
                ClosedForm::Linear { unknown: 5, .. },
                ClosedForm::Linear { unknown: 4, .. }
            ]
        ));
        let y = graph.linear(0.0, &[(x, 2.0), (p, 1.0)]);
        let z = graph.scale(-3.0, y);
        let sines = [x, y, z].map(|angle| graph.sine(angle));
        let rest = graph.linear(-1.0, &[(sines[0], 1.0), (sines[1], 1.0), (sines[2], 1.0)]);
        assert_eq!(taken.equations, [rest]);

        // nothing is taken out of a block with one unknown
        let alone = whole(&mut graph, &[y], &[3]);
        assert_eq!((alone.unknowns, alone.relations.len()), (vec![3], 0));
    }
}
