//! A body in space whose pose is the unknowns of a block: three coordinates, and three angles of a product of elementary
//! rotations.
//!
//! With the position p and the rotation R, an equation has the form
//! c p·p + u·p + v·Rᵀp + Σ wᵢⱼ Rᵢⱼ + k = 0. A leg between two spherical joints is one, |p + R b - a|² = l², and so is a point
//! of the body on a plane. In the coordinates of E. Study six such equations have 40 solutions, against thousands of paths
//! for the cosines and sines of the angles.

use std::collections::BTreeMap;

use crate::algebra::{Expansion, Graph, Harmonic, Monomial, Node, Symbol, TrigonometricPolynomial, Variables};

/// The number of elements of a rotation matrix.
const ELEMENTS: usize = 9;

/// A body, and the coefficients of its equations.
pub(super) struct Body {
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
) -> Option<Body> {
    let equations: Vec<Equation> = polynomials
        .iter()
        .map(|polynomial| Equation::of(graph, polynomial, coordinates))
        .collect::<Option<_>>()?;
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    for angles in orders.map(|order| order.map(|place| angles[place])) {
        for axes in sequences() {
            let rotation = Rotation::new(graph, angles, axes);
            if let Some((coordinates, coefficients)) = coefficients(graph, &equations, &rotation, coordinates) {
                return Some(Body {
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
    equations: &[Equation],
    rotation: &Rotation,
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
    for place in 0..3 {
        if rows[place].is_none() {
            rows[place] = (0..3).find(|row| !rows.contains(&Some(*row)));
        }
    }
    let place_of = |axis: usize| rows.iter().position(|&row| row == Some(axis));
    let places = [place_of(0)?, place_of(1)?, place_of(2)?];
    let mut all = Vec::new();
    for (equation, (elements, constant, along)) in equations.iter().zip(&read) {
        let vector = |axis: usize| &along[places[axis]].0[3 * axis..3 * axis + 3];
        for component in 0..3 {
            for axis in 1..3 {
                let difference = graph.subtract(vector(axis)[component], vector(0)[component]);
                if !graph.vanishes(difference) {
                    return None;
                }
            }
        }
        all.push(equation.square);
        all.extend(places.map(|place| along[place].1));
        all.extend(vector(0));
        all.extend(elements);
        all.push(*constant);
    }
    Some((places.map(|place| coordinates[place]), all))
}

/// An equation, sorted by the powers of the coordinates.
struct Equation {
    /// The coefficient of p·p.
    square: Node,
    /// The coefficients of the three coordinates.
    along: [TrigonometricPolynomial; 3],
    /// What is free of them.
    constant: TrigonometricPolynomial,
}

impl Equation {
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
                    let place = coordinates.iter().position(|&known| known == unknown)?;
                    match power {
                        1 => &mut along[place],
                        2 if monomial.harmonic == Harmonic::One => {
                            squares[place] = coefficient;
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
struct Rotation {
    /// The monomials that occur in them.
    monomials: Vec<Monomial>,
    /// The coefficients of these monomials in each element, row by row.
    elements: Vec<Vec<f64>>,
    /// As many monomials as elements, by which combinations of the elements differ, and the combination of elements that
    /// has only the respective one of them.
    pivots: Vec<(usize, [f64; ELEMENTS])>,
}

impl Rotation {
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
        for (place, &value) in values.iter().enumerate() {
            let mut terms = vec![(value, -1.0)];
            terms.extend(
                elements
                    .iter()
                    .zip(&self.elements)
                    .map(|(&node, element)| (node, element[place])),
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
    for place in 0..rows.len() {
        // the coefficients are sums of a few fourths, so what cancels is exactly zero
        let Some(pivot) = rows[place].0.iter().position(|&value| value != 0.0) else {
            continue;
        };
        pivots.push(pivot);
        let inverse = 1.0 / rows[place].0[pivot];
        let scaled = |row: &[f64]| -> Vec<f64> { row.iter().map(|value| value * inverse).collect() };
        let own = (scaled(&rows[place].0), rows[place].1.map(|value| value * inverse));
        for (other, row) in rows.iter_mut().enumerate() {
            let factor = row.0[pivot];
            if other != place {
                let subtract = |(value, own): (&mut f64, &f64)| *value -= factor * own;
                row.0.iter_mut().zip(&own.0).for_each(subtract);
                row.1.iter_mut().zip(&own.1).for_each(subtract);
            }
        }
        rows[place] = own;
    }
    pivots
        .into_iter()
        .zip(rows.into_iter().map(|(_, shares)| shares))
        .collect()
}
