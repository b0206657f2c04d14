//! A body in space whose pose is the unknowns of a block: three coordinates, and three angles of a product of
//! elementary rotations.
//!
//! With the position p and the rotation R, an equation has the form
//! c p·p + u·p + v·Rᵀp + Σ wᵢⱼ Rᵢⱼ + k = 0. A leg between two spherical joints is one, |p + R b - a|² = l², and so is a
//! point of the body on a plane. In the coordinates of E. Study six such equations have 40 solutions, against thousands
//! of paths for the cosines and sines of the angles.

use std::collections::BTreeMap;

use crate::algebra::{Expansion, Graph, Harmonic, Monomial, Node, Symbol, TrigonometricPolynomial, Variables};

/// The number of elements of a rotation matrix.
const ELEMENTS: usize = 9;

/// A body, and the coefficients of its equations.
pub(super) struct MovingBody {
    /// The unknown coordinates along x, y and z.
    pub(super) coordinates: [usize; 3],
    /// The unknown angles, in the order of the product, and the axes of their rotations.
    pub(super) angles: [usize; 3],
    pub(super) axes: [usize; 3],
    /// The coefficients of each equation: c, u, v, w row by row, and k.
    pub(super) coefficients: Vec<Node>,
}

/// Recognises the six equations of a body.
pub(super) fn body(
    graph: &mut Graph,
    polynomials: &[TrigonometricPolynomial],
    coordinates: [usize; 3],
    angles: [usize; 3],
) -> Option<MovingBody> {
    let equations: Vec<PoseEquation> = polynomials
        .iter()
        .map(|polynomial| PoseEquation::of(graph, polynomial, coordinates))
        .collect::<Option<_>>()?;
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    for angles in orders.map(|order| order.map(|axis| angles[axis])) {
        for axes in sequences() {
            let rotation = RotationElements::new(graph, angles, axes);
            if let Some((coordinates, coefficients)) = coefficients(graph, &equations, &rotation, coordinates) {
                return Some(MovingBody {
                    coordinates,
                    angles,
                    axes,
                    coefficients,
                });
            }
        }
    }
    None
}

/// The axes of three rotations that give all rotations: no axis follows itself.
fn sequences() -> impl Iterator<Item = [usize; 3]> {
    (0..27)
        .map(|number| [number / 9, number / 3 % 3, number % 3])
        .filter(|[first, second, third]| first != second && second != third)
}

/// The coordinates along x, y and z, and the coefficients of all equations, if these are equations of a body with the
/// given rotation.
fn coefficients(
    graph: &mut Graph,
    equations: &[PoseEquation],
    rotation: &RotationElements,
    coordinates: [usize; 3],
) -> Option<([usize; 3], Vec<Node>)> {
    let zero = graph.zero();
    let mut rows = [None; 3];
    let mut read = Vec::new();
    for equation in equations {
        let (elements, constant) = rotation.combination(graph, &equation.constant)?;
        // a coordinate is multiplied by a row of the rotation matrix times a vector of the body
        let mut along = Vec::new();
        for (row, factor) in rows.iter_mut().zip(&equation.along) {
            let (elements, constant) = rotation.combination(graph, factor)?;
            let occurring = (0..3).filter(|row| elements[3 * row..3 * row + 3].iter().any(|&element| element != zero));
            for occurs in occurring {
                if *row.get_or_insert(occurs) != occurs {
                    return None;
                }
            }
            along.push((elements, constant));
        }
        read.push((elements, constant, along));
    }
    // without vectors of the body, the coordinates are along x, y and z in any order
    for row in 0..3 {
        if rows[row].is_none() {
            rows[row] = (0..3).find(|other| !rows.contains(&Some(*other)));
        }
    }
    let place_of = |axis: usize| rows.iter().position(|&row| row == Some(axis));
    let indices = [place_of(0)?, place_of(1)?, place_of(2)?];
    let mut all = Vec::new();
    for (equation, (elements, constant, along)) in equations.iter().zip(&read) {
        let vector = |axis: usize| &along[indices[axis]].0[3 * axis..3 * axis + 3];
        for component in 0..3 {
            for axis in 1..3 {
                let difference = graph.subtract(vector(axis)[component], vector(0)[component]);
                if !graph.vanishes(difference) {
                    return None;
                }
            }
        }
        all.push(equation.square);
        all.extend(indices.map(|index| along[index].1));
        all.extend(vector(0));
        all.extend(elements);
        all.push(*constant);
    }
    Some((indices.map(|index| coordinates[index]), all))
}

/// An equation, sorted by the powers of the coordinates.
struct PoseEquation {
    /// The coefficient of p·p.
    square: Node,
    /// The coefficients of the three coordinates.
    along: [TrigonometricPolynomial; 3],
    /// What is free of them.
    constant: TrigonometricPolynomial,
}

impl PoseEquation {
    fn of(graph: &mut Graph, polynomial: &TrigonometricPolynomial, coordinates: [usize; 3]) -> Option<Self> {
        let mut squares = [graph.zero(); 3];
        let mut along: [TrigonometricPolynomial; 3] = Default::default();
        let mut constant = TrigonometricPolynomial::default();
        for (monomial, &coefficient) in &polynomial.0 {
            let free = Monomial {
                powers: BTreeMap::new(),
                harmonic: monomial.harmonic.clone(),
            };
            let mut powers = monomial.powers.iter();
            let part = match (powers.next(), powers.next()) {
                (None, _) => &mut constant,
                (Some((&atom, &power)), None) => {
                    let Some(Symbol::Unknown(unknown)) = graph.as_symbol(atom) else {
                        return None;
                    };
                    let index = coordinates.iter().position(|&known| known == unknown)?;
                    match power {
                        1 => &mut along[index],
                        2 if monomial.harmonic == Harmonic::One => {
                            squares[index] = coefficient;
                            continue;
                        }
                        _ => return None,
                    }
                }
                _ => return None,
            };
            part.0.insert(free, coefficient);
        }
        let [square, others @ ..] = squares;
        others.iter().all(|&other| other == square).then_some(Self {
            square,
            along,
            constant,
        })
    }
}

/// The elements of a rotation matrix as trigonometric polynomials of its angles.
struct RotationElements {
    /// The monomials that occur in them.
    monomials: Vec<Monomial>,
    /// The coefficients of these monomials in each element, row by row.
    elements: Vec<Vec<f64>>,
    /// As many monomials as elements, by which combinations of the elements differ, and the combination of elements
    /// that has only the respective one of them.
    pivots: Vec<(usize, [f64; ELEMENTS])>,
}

impl RotationElements {
    fn new(graph: &mut Graph, angles: [usize; 3], axes: [usize; 3]) -> Self {
        let (zero, one) = (graph.zero(), graph.one());
        let mut product: Option<Vec<Node>> = None;
        for (&angle, axis) in angles.iter().zip(axes) {
            let angle = graph.symbol(Symbol::Unknown(angle));
            let (cosine, sine) = (graph.cosine(angle), graph.sine(angle));
            let minus_sine = graph.negate(sine);
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            let mut factor = vec![zero; ELEMENTS];
            factor[4 * axis] = one;
            (factor[4 * next], factor[4 * last]) = (cosine, cosine);
            (factor[3 * last + next], factor[3 * next + last]) = (sine, minus_sine);
            product = Some(match product {
                None => factor,
                Some(before) => (0..ELEMENTS)
                    .map(|element| {
                        let terms = [0, 1, 2].map(|inner| {
                            graph.multiply(before[element / 3 * 3 + inner], factor[3 * inner + element % 3])
                        });
                        graph.sum(&terms)
                    })
                    .collect(),
            });
        }
        let expanded: Vec<TrigonometricPolynomial> = product
            .unwrap_or_default()
            .into_iter()
            .map(|element| Expansion::new(graph, Variables::Unknowns(&angles)).equation(element))
            .collect();
        let mut monomials: Vec<Monomial> = expanded.iter().flat_map(|element| element.0.keys().cloned()).collect();
        monomials.sort();
        monomials.dedup();
        let elements: Vec<Vec<f64>> = expanded
            .iter()
            .map(|element| {
                let number = |monomial| element.0.get(monomial).and_then(|&value| graph.as_number(value));
                monomials
                    .iter()
                    .map(|monomial| number(monomial).unwrap_or(0.0))
                    .collect()
            })
            .collect();
        let pivots = pivots(&elements);
        Self {
            monomials,
            elements,
            pivots,
        }
    }

    /// The coefficients of the elements in a combination of them, and what it has besides; `None` if it is none.
    fn combination(&self, graph: &mut Graph, polynomial: &TrigonometricPolynomial) -> Option<([Node; ELEMENTS], Node)> {
        let is_known = |monomial: &Monomial| *monomial == Monomial::one() || self.monomials.contains(monomial);
        if !polynomial.0.keys().all(is_known) {
            return None;
        }
        let values: Vec<Node> = self
            .monomials
            .iter()
            .map(|monomial| polynomial.coefficient(graph, monomial))
            .collect();
        let elements = core::array::from_fn(|element| {
            let shares = self.pivots.iter();
            let terms: Vec<(Node, f64)> = shares
                .map(|(monomial, shares)| (values[*monomial], shares[element]))
                .collect();
            let coefficient = graph.linear(0.0, &terms);
            if graph.vanishes(coefficient) {
                graph.zero()
            } else {
                coefficient
            }
        });
        for (index, &value) in values.iter().enumerate() {
            let mut terms = vec![(value, -1.0)];
            terms.extend(
                elements
                    .iter()
                    .zip(&self.elements)
                    .map(|(&node, element)| (node, element[index])),
            );
            let rest = graph.linear(0.0, &terms);
            if !graph.vanishes(rest) {
                return None;
            }
        }
        Some((elements, polynomial.free_term(graph)))
    }
}

/// Gauss-Jordan elimination of the elements' coefficients: the monomial of each pivot, and the combination of elements
/// that has it with the coefficient 1 and no other pivot.
fn pivots(elements: &[Vec<f64>]) -> Vec<(usize, [f64; ELEMENTS])> {
    let mut rows: Vec<(Vec<f64>, [f64; ELEMENTS])> = elements
        .iter()
        .enumerate()
        .map(|(element, row)| {
            (
                row.clone(),
                core::array::from_fn(|other| f64::from(u8::from(other == element))),
            )
        })
        .collect();
    let mut pivots = Vec::new();
    for pivot_row in 0..rows.len() {
        // the coefficients are sums of a few fourths, so what cancels is exactly zero
        let Some(pivot) = rows[pivot_row].0.iter().position(|&value| value != 0.0) else {
            continue;
        };
        pivots.push(pivot);
        let inverse = 1.0 / rows[pivot_row].0[pivot];
        let scaled = |row: &[f64]| -> Vec<f64> { row.iter().map(|value| value * inverse).collect() };
        let reduced = (
            scaled(&rows[pivot_row].0),
            rows[pivot_row].1.map(|value| value * inverse),
        );
        for (other, row) in rows.iter_mut().enumerate() {
            let factor = row.0[pivot];
            if other != pivot_row {
                let subtract = |(value, reduced): (&mut f64, &f64)| *value -= factor * reduced;
                row.0.iter_mut().zip(&reduced.0).for_each(subtract);
                row.1.iter_mut().zip(&reduced.1).for_each(subtract);
            }
        }
        rows[pivot_row] = reduced;
    }
    pivots
        .into_iter()
        .zip(rows.into_iter().map(|(_, shares)| shares))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{MovingBody, body, sequences};
    use crate::algebra::{Expansion, Graph, Node, Symbol, TrigonometricPolynomial, Variables};

    type Vector = [Node; 3];

    /// A vector rotated about an axis.
    fn rotated(graph: &mut Graph, axis: usize, angle: Node, vector: Vector) -> Vector {
        let (cosine, sine) = (graph.cosine(angle), graph.sine(angle));
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut result = vector;
        for (axis_of_result, first, other, sign) in [(next, next, last, -1.0), (last, last, next, 1.0)] {
            let along = graph.multiply(cosine, vector[first]);
            let across = graph.multiply(sine, vector[other]);
            result[axis_of_result] = graph.linear(0.0, &[(along, 1.0), (across, sign)]);
        }
        result
    }

    /// The unknowns are x, y and z in the order `coordinates`, and angles in the order `angles`. Five points of the
    /// body have a given distance from points of the ground, and one lies on a plane.
    fn equations(
        graph: &mut Graph,
        coordinates: [usize; 3],
        angles: [usize; 3],
        axes: [usize; 3],
    ) -> Vec<TrigonometricPolynomial> {
        let unknowns = [0, 1, 2, 3, 4, 5];
        (0..6)
            .map(|leg| {
                let [on_body, on_ground] =
                    [0, 3].map(|first| [0, 1, 2].map(|part| graph.symbol(Symbol::Parameter(7 * leg + first + part))));
                let length = graph.symbol(Symbol::Parameter(7 * leg + 6));
                let mut point = on_body;
                for (angle, axis) in angles.into_iter().zip(axes).rev() {
                    let angle = graph.symbol(Symbol::Unknown(angle));
                    point = rotated(graph, axis, angle, point);
                }
                let mut sum = vec![];
                for part in 0..3 {
                    let coordinate = graph.symbol(Symbol::Unknown(coordinates[part]));
                    let along = graph.linear(0.0, &[(coordinate, 1.0), (point[part], 1.0)]);
                    sum.push(if leg == 5 {
                        graph.multiply(on_ground[part], along)
                    } else {
                        let difference = graph.subtract(along, on_ground[part]);
                        graph.power(difference, 2)
                    });
                }
                let distance = graph.power(length, 2);
                let whole = graph.sum(&sum);
                let equation = graph.subtract(whole, distance);
                Expansion::new(graph, Variables::Unknowns(&unknowns)).equation(equation)
            })
            .collect()
    }

    /// For every sequence of axes, the coefficients give the values of the equations. The axes may have other names
    /// than in the equations.
    #[test]
    fn the_coefficients_are_those_of_the_equations() {
        for (number, axes) in sequences().enumerate() {
            let mut graph = Graph::new();
            let (coordinates, angles) = (
                [[0, 4, 2], [4, 2, 0]][number % 2],
                [[1, 3, 5], [5, 1, 3]][number / 2 % 2],
            );
            let polynomials = equations(&mut graph, coordinates, angles, axes);
            let body = body(&mut graph, &polynomials, [0, 2, 4], [1, 3, 5]).expect("it is a body");
            assert_values(&mut graph, &polynomials, &body);
        }
    }

    fn assert_values(graph: &mut Graph, polynomials: &[TrigonometricPolynomial], body: &MovingBody) {
        let symbols = |symbol: Symbol| match symbol {
            Symbol::Unknown(unknown) => [0.3, -0.7, 1.1, 2.1, -0.4, 0.9][unknown],
            Symbol::Parameter(number) => (f64::from(u8::try_from(number).unwrap()) * 0.77).sin(),
            _ => panic!("there are no other symbols"),
        };
        let position = body.coordinates.map(|unknown| symbols(Symbol::Unknown(unknown)));
        let column = |graph: &mut Graph, column: usize| -> [f64; 3] {
            let (zero, one) = (graph.zero(), graph.one());
            let mut vector = [zero; 3];
            vector[column] = one;
            for (angle, axis) in body.angles.into_iter().zip(body.axes).rev() {
                let angle = graph.symbol(Symbol::Unknown(angle));
                vector = rotated(graph, axis, angle, vector);
            }
            vector.map(|part| graph.evaluate(part, &symbols))
        };
        let columns = [0, 1, 2].map(|index| column(graph, index));
        let dot = |a: [f64; 3], b: [f64; 3]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        let mut factors = vec![dot(position, position)];
        factors.extend(position);
        factors.extend(columns.map(|column| dot(column, position)));
        factors.extend([0, 1, 2].iter().flat_map(|&row| columns.map(|column| column[row])));
        factors.push(1.0);
        for (polynomial, coefficients) in polynomials.iter().zip(body.coefficients.chunks(factors.len())) {
            let equation = polynomial.node(graph);
            let expected = graph.evaluate(equation, &symbols);
            let terms = coefficients.iter().zip(&factors);
            let sum: f64 = terms
                .map(|(&coefficient, factor)| graph.evaluate(coefficient, &symbols) * factor)
                .sum();
            // a hundred terms of about one
            assert!(
                (sum - expected).abs() < 100.0 * f64::EPSILON,
                "{:?}: {sum} and not {expected}",
                body.axes
            );
        }
    }

    /// A coordinate that is counted backwards, squares that differ and an angle that rotates twice as far are no body.
    #[test]
    fn other_equations_are_none() {
        let mut graph = Graph::new();
        let polynomials = equations(&mut graph, [0, 2, 4], [1, 3, 5], [2, 1, 0]);
        let mut is_body = |change: &dyn Fn(&mut Graph, usize, Node) -> Node| {
            let mut replacements = std::collections::BTreeMap::new();
            for unknown in 0..6 {
                let node = graph.symbol(Symbol::Unknown(unknown));
                replacements.insert(node, change(&mut graph, unknown, node));
            }
            let changed: Vec<TrigonometricPolynomial> = polynomials
                .iter()
                .map(|polynomial| {
                    let equation = polynomial.node(&mut graph);
                    let equation = graph.substitute(equation, &mut replacements);
                    Expansion::new(&mut graph, Variables::Unknowns(&[0, 1, 2, 3, 4, 5])).equation(equation)
                })
                .collect();
            body(&mut graph, &changed, [0, 2, 4], [1, 3, 5]).is_some()
        };
        assert!(is_body(&|_, _, node| node));
        assert!(!is_body(&|graph, unknown, node| if unknown == 2 {
            graph.negate(node)
        } else {
            node
        }));
        assert!(!is_body(&|graph, unknown, node| if unknown == 2 {
            graph.scale(2.0, node)
        } else {
            node
        }));
        assert!(!is_body(&|graph, unknown, node| if unknown == 3 {
            graph.scale(2.0, node)
        } else {
            node
        }));
    }
}
