//! Plane loops: two scalar equations that are the parts of one complex equation.
//!
//! The pair may have been typed as a vector equation, or as two scalar equations with sides, signs, order and even
//! factors changed. It is a loop if one row can be scaled, and the rows exchanged, so that the coefficients of every
//! cos φ, sin φ form a matrix [[p, -q], [q, p]], which multiplies by p + i q, or its mirror image.

use std::collections::BTreeSet;

use crate::algebra::{Angle, Graph, Harmonic, Monomial, Node, Symbol, TrigonometricPolynomial};
use crate::structure::{Arm, ClosedForm, ComplexNode};

/// A pair of rows: `rows[0] = 0` is the real part and `rows[1] = 0` the imaginary part of a loop.
struct RowPair<'a> {
    rows: [&'a TrigonometricPolynomial; 2],
    /// The factor of the second row.
    scale: Node,
}

/// A pair of rows read as a loop, with the factor of each term and whether its angle runs clockwise.
struct Reading<'a> {
    /// The distance from the usual way to write a loop.
    cost: usize,
    factors: Vec<(ComplexNode, bool)>,
    rows: RowPair<'a>,
}

/// cos φ and sin φ times a power product: one term of a rotating vector.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct TurningTerm {
    powers: Vec<(Node, i32)>,
    angle: Angle,
}

impl TurningTerm {
    fn monomials(&self) -> [Monomial; 2] {
        let powers = || self.powers.iter().copied().collect();
        [
            Monomial {
                powers: powers(),
                harmonic: Harmonic::Cosine(self.angle.clone()),
            },
            Monomial {
                powers: powers(),
                harmonic: Harmonic::Sine(self.angle.clone()),
            },
        ]
    }
}

pub(super) fn recognise(
    graph: &mut Graph,
    equations: [&TrigonometricPolynomial; 2],
    unknowns: [usize; 2],
) -> Option<ClosedForm> {
    let rotating_terms: Vec<TurningTerm> = equations
        .iter()
        .flat_map(|equation| equation.0.keys())
        .filter_map(|monomial| match &monomial.harmonic {
            Harmonic::One => None,
            Harmonic::Cosine(angle) | Harmonic::Sine(angle) => Some(TurningTerm {
                powers: monomial.powers.iter().map(|(&atom, &power)| (atom, power)).collect(),
                angle: angle.clone(),
            }),
        })
        .collect::<BTreeSet<_>>()
        .into_iter()
        .collect();
    let first = rotating_terms.first()?;
    let mut best: Option<Reading<'_>> = None;
    for swapped in [false, true] {
        for mirrored in [false, true] {
            let rows = if swapped {
                [equations[1], equations[0]]
            } else {
                equations
            };
            let Some(scale) = row_scale(graph, rows, first, mirrored) else {
                continue;
            };
            let rows = RowPair { rows, scale };
            let Some(factors) = rotating_terms
                .iter()
                .map(|term| rows.factor(graph, term))
                .collect::<Option<Vec<_>>>()
            else {
                continue;
            };
            // prefer real factors, then counter-clockwise angles, then the rows as typed. If as many angles run
            // clockwise as not, a loop must not be confused with its mirror image, which exchanges open and crossed
            let cost = factors
                .iter()
                .map(|(factor, mirrored)| 16 * usize::from(!factor.is_real(graph)) + 4 * usize::from(*mirrored))
                .sum::<usize>()
                + 2 * usize::from(!graph.is_one(rows.scale))
                + usize::from(swapped);
            if best.as_ref().is_none_or(|least| cost < least.cost) {
                best = Some(Reading { cost, factors, rows });
            }
        }
    }
    let Reading { factors, rows, .. } = best?;
    let arms: Vec<(TurningTerm, Arm)> = rotating_terms
        .into_iter()
        .zip(factors)
        .map(|(term, (factor, mirrored))| {
            let arm = Arm {
                angle: term.angle.clone(),
                mirrored,
                factor,
            };
            (term, arm)
        })
        .collect();
    two_angles(graph, &rows, &arms, unknowns)
        .or_else(|| angle_length(graph, &rows, &arms, unknowns))
        .or_else(|| polar(graph, &rows, &arms, unknowns))
}

/// The only link of a loop that rotates with an unknown, and the rest of the loop: arm + rest = 0. `None` if the
/// unknown occurs anywhere else in the equations.
pub(in crate::structure) fn arm(
    graph: &mut Graph,
    equations: [&TrigonometricPolynomial; 2],
    unknown: usize,
) -> Option<(Arm, ComplexNode)> {
    let angle = Angle(vec![(Symbol::Unknown(unknown), 1)]);
    let term = TurningTerm {
        powers: Vec::new(),
        angle: angle.clone(),
    };
    let monomials = term.monomials();
    let is_elsewhere = equations.iter().any(|equation| {
        let mut others = (*equation).clone();
        others.0.retain(|monomial, _| !monomials.contains(monomial));
        others.contains(graph, unknown)
    });
    if is_elsewhere {
        return None;
    }
    for swapped in [false, true] {
        for mirrored in [false, true] {
            let rows = if swapped {
                [equations[1], equations[0]]
            } else {
                equations
            };
            let Some(scale) = row_scale(graph, rows, &term, mirrored) else {
                continue;
            };
            let rows = RowPair { rows, scale };
            let Some((factor, mirrored)) = rows.factor(graph, &term) else {
                continue;
            };
            let [mut above, mut below] = rows.rows.map(Clone::clone);
            for polynomial in [&mut above, &mut below] {
                polynomial.0.retain(|monomial, _| !monomials.contains(monomial));
            }
            let (above, below) = (above.node(graph), below.node(graph));
            let rest = ComplexNode::new(above, graph.multiply(rows.scale, below));
            return Some((
                Arm {
                    angle,
                    mirrored,
                    factor,
                },
                rest,
            ));
        }
    }
    None
}

/// The factor of the second row with which the first term is a multiplication by a complex number.
fn row_scale(
    graph: &mut Graph,
    rows: [&TrigonometricPolynomial; 2],
    term: &TurningTerm,
    mirrored: bool,
) -> Option<Node> {
    let [cosine, sine] = term.monomials();
    let (cosine_above, sine_above) = (rows[0].coefficient(graph, &cosine), rows[0].coefficient(graph, &sine));
    let (cosine_below, sine_below) = (rows[1].coefficient(graph, &cosine), rows[1].coefficient(graph, &sine));
    // [[p, -q σ], [q, p σ]] with σ = ±1
    let (above, below) = if graph.is_zero(cosine_above) {
        (
            sine_above,
            if mirrored {
                cosine_below
            } else {
                graph.negate(cosine_below)
            },
        )
    } else {
        (
            cosine_above,
            if mirrored { graph.negate(sine_below) } else { sine_below },
        )
    };
    if graph.is_zero(above) || graph.is_zero(below) {
        return None;
    }
    if graph.same(above, below) {
        return Some(graph.one());
    }
    Some(graph.divide(above, below))
}

impl RowPair<'_> {
    fn entry(&self, graph: &mut Graph, row: usize, monomial: &Monomial) -> Node {
        let coefficient = self.rows[row].coefficient(graph, monomial);
        if row == 1 {
            graph.multiply(self.scale, coefficient)
        } else {
            coefficient
        }
    }

    fn complex(&self, graph: &mut Graph, monomial: &Monomial) -> ComplexNode {
        ComplexNode::new(self.entry(graph, 0, monomial), self.entry(graph, 1, monomial))
    }

    /// p + i q, and whether the angle runs clockwise, if the term is a rotating vector.
    fn factor(&self, graph: &mut Graph, term: &TurningTerm) -> Option<(ComplexNode, bool)> {
        let [cosine, sine] = term.monomials();
        let factor = self.complex(graph, &cosine);
        let rotated = self.complex(graph, &sine);
        let opposite = graph.negate(rotated.re);
        if graph.same(rotated.im, factor.re) && graph.same(opposite, factor.im) {
            return Some((factor, false));
        }
        let opposite = graph.negate(rotated.im);
        if graph.same(opposite, factor.re) && graph.same(rotated.re, factor.im) {
            return Some((factor, true));
        }
        None
    }

    /// The sum of the rotating vectors: minus the terms free of unknowns.
    fn target(&self, graph: &mut Graph) -> ComplexNode {
        let free = self.complex(graph, &Monomial::one());
        ComplexNode::new(graph.negate(free.re), graph.negate(free.im))
    }

    /// The monomials that contain unknowns but no sine or cosine.
    fn straight(&self) -> BTreeSet<&Monomial> {
        self.rows
            .iter()
            .flat_map(|row| row.0.keys())
            .filter(|monomial| monomial.harmonic == Harmonic::One && !monomial.powers.is_empty())
            .collect()
    }
}

/// A cis(φ) + B cis(ψ) = C.
fn two_angles(
    graph: &mut Graph,
    rows: &RowPair<'_>,
    arms: &[(TurningTerm, Arm)],
    unknowns: [usize; 2],
) -> Option<ClosedForm> {
    let [(first_term, first), (second_term, second)] = arms else {
        return None;
    };
    if !first_term.powers.is_empty() || !second_term.powers.is_empty() || !rows.straight().is_empty() {
        return None;
    }
    // the unknowns must follow from the two angles without a choice of whole revolutions
    let multiple = |arm: &Arm, unknown: usize| {
        arm.angle
            .0
            .iter()
            .find(|&&(symbol, _)| symbol == Symbol::Unknown(unknown))
            .map_or(0, |&(_, multiple)| multiple)
    };
    let determinant = multiple(first, unknowns[0]) * multiple(second, unknowns[1])
        - multiple(first, unknowns[1]) * multiple(second, unknowns[0]);
    if determinant.abs() != 1 {
        return None;
    }
    let target = rows.target(graph);
    Some(ClosedForm::TwoAngles {
        unknowns,
        arms: [first.clone(), second.clone()],
        target,
    })
}

/// The unknown that equals an arm's angle, and the other unknown. `None` if the angle is not a single unknown.
fn split_unknowns(arm: &Arm, unknowns: [usize; 2]) -> Option<(usize, usize)> {
    let [(Symbol::Unknown(angle), 1)] = arm.angle.0[..] else {
        return None;
    };
    let other = if angle == unknowns[0] { unknowns[1] } else { unknowns[0] };
    Some((angle, other))
}

/// A cis(φ) + s D = C.
fn angle_length(
    graph: &mut Graph,
    rows: &RowPair<'_>,
    arms: &[(TurningTerm, Arm)],
    unknowns: [usize; 2],
) -> Option<ClosedForm> {
    let [(term, arm)] = arms else {
        return None;
    };
    let (angle, length) = split_unknowns(arm, unknowns)?;
    let variable = graph.symbol(Symbol::Unknown(length));
    let slide = Monomial {
        powers: [(variable, 1)].into(),
        harmonic: Harmonic::One,
    };
    if !term.powers.is_empty() || rows.straight() != BTreeSet::from([&slide]) {
        return None;
    }
    let direction = rows.complex(graph, &slide);
    let target = rows.target(graph);
    Some(ClosedForm::AngleLength {
        angle,
        length,
        arm: arm.clone(),
        direction,
        target,
    })
}

/// (s D + E) cis(φ) = C.
fn polar(
    graph: &mut Graph,
    rows: &RowPair<'_>,
    arms: &[(TurningTerm, Arm)],
    unknowns: [usize; 2],
) -> Option<ClosedForm> {
    if !rows.straight().is_empty() {
        return None;
    }
    let (_, arm) = arms.first()?;
    let (angle, length) = split_unknowns(arm, unknowns)?;
    let variable = graph.symbol(Symbol::Unknown(length));
    let mut direction = None;
    let zero = graph.zero();
    let mut offset = ComplexNode::new(zero, zero);
    for (term, other) in arms {
        if other.angle != arm.angle || other.mirrored != arm.mirrored {
            return None;
        }
        match term.powers[..] {
            [] => offset = other.factor,
            [(atom, 1)] if atom == variable => direction = Some(other.factor),
            _ => return None,
        }
    }
    let direction = direction?;
    let target = rows.target(graph);
    Some(ClosedForm::Polar {
        length,
        angle,
        mirrored: arm.mirrored,
        offset: offset.over(graph, direction),
        target: target.over(graph, direction),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Expansion, Variables};

    /// The form of two equations for the first two unknowns.
    fn form(graph: &mut Graph, equations: [Node; 2]) -> Option<ClosedForm> {
        let [above, below] =
            equations.map(|equation| Expansion::new(graph, Variables::Unknowns(&[0, 1])).equation(equation));
        recognise(graph, [&above, &below], [0, 1])
    }

    struct Links {
        graph: Graph,
        /// Two lengths, and the components of the vector that they span.
        parameters: [Node; 4],
        unknowns: [Node; 2],
    }

    fn links() -> Links {
        let mut graph = Graph::new();
        Links {
            parameters: [0, 1, 2, 3].map(|index| graph.symbol(Symbol::Parameter(index))),
            unknowns: [0, 1].map(|index| graph.symbol(Symbol::Unknown(index))),
            graph,
        }
    }

    /// Σ length · cis(± angle) - (c + i d), with the signs in `senses`.
    fn loop_of(links: &mut Links, senses: [f64; 2]) -> [Node; 2] {
        let [a, b, c, d] = links.parameters;
        let graph = &mut links.graph;
        let cosines = links.unknowns.map(|angle| graph.cosine(angle));
        let sines = links.unknowns.map(|angle| graph.sine(angle));
        let above = [graph.multiply(a, cosines[0]), graph.multiply(b, cosines[1])];
        let below = [graph.multiply(a, sines[0]), graph.multiply(b, sines[1])];
        [
            graph.linear(0.0, &[(above[0], 1.0), (above[1], 1.0), (c, -1.0)]),
            graph.linear(0.0, &[(below[0], senses[0]), (below[1], senses[1]), (d, -1.0)]),
        ]
    }

    /// A loop is read as typed and not as its mirror image, which exchanges open and crossed.
    #[test]
    fn angles_keep_their_sense() {
        for senses in [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0]] {
            let mut links = links();
            let equations = loop_of(&mut links, senses);
            let [a, b, c, d] = links.parameters;
            let Some(ClosedForm::TwoAngles { arms, target, .. }) = form(&mut links.graph, equations) else {
                panic!("{senses:?}");
            };
            assert_eq!(arms.each_ref().map(|arm| arm.mirrored), senses.map(|sense| sense < 0.0));
            assert_eq!(arms.map(|arm| arm.factor.re), [a, b]);
            assert_eq!((target.re, target.im), (c, d));
        }
    }

    /// An offset may be added to a length that is found together with its angle.
    #[test]
    fn a_length_may_have_an_offset() {
        let Links {
            mut graph,
            parameters: [offset, factor, c, d],
            unknowns: [length, angle],
        } = links();
        let (cosine, sine) = (graph.cosine(angle), graph.sine(angle));
        let scaled = graph.multiply(factor, length);
        let whole = graph.add(scaled, offset);
        let equations = [(cosine, c), (sine, d)].map(|(part, end)| {
            let along = graph.multiply(whole, part);
            graph.subtract(along, end)
        });
        let Some(ClosedForm::Polar {
            offset: found, target, ..
        }) = form(&mut graph, equations)
        else {
            panic!("it is a vector with a length and an angle");
        };
        let expected = [offset, c, d].map(|part| graph.divide(part, factor));
        assert_eq!([found.re, target.re, target.im], expected);
        assert!(graph.is_zero(found.im));
    }
}
