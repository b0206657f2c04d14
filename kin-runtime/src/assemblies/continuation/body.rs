//! All poses of a body in space that six equations hold.
//!
//! The Study coordinates x and y of a pose, two quaternions, give its rotation as that of the quaternion x, and its
//! position as 2 y x̄ / |x|². They fulfil x·y = 0, and common factors do not matter. An equation
//! c p·p + u·p + v·Rᵀp + Σ wᵢⱼ Rᵢⱼ + k = 0, times |x|², is
//!
//! 4 c y·y + 2 u·(y x̄) + 2 v·(x̄ y) + Σ wᵢⱼ |x|² Rᵢⱼ(x) + k |x|² = 0,
//!
//! of second degree. The seven equations have 40 solutions with x ≠ 0 if their coefficients are general, whatever u, v
//! and w are (M. Husty, *An algorithm for solving the direct kinematics of general Stewart-Gough platforms*, Mechanism
//! and Machine Theory 31 (1996) 365-380; C. W. Wampler, *Forward displacement analysis of general six-in-parallel SPS
//! (Stewart) platform manipulators using soma coordinates*, the same 31 (1996) 331-337). So the start system is a known
//! member of this family with its 40 solutions, and no path leads to the other solutions, x = 0.

use core::ops::Neg;

use num_traits::Float;

use super::complex::Complex;
use super::homotopy::KnownSystem;
use super::known_poses::POSES;
use super::outcome::{PathCounts, Solution, Unsuitable};
use super::scaling::Scales;
use super::sequence;
use super::system::{PolynomialSystem, Term};
use super::{AllSolutions, solutions};

/// The number of equations of a body.
const EQUATIONS: usize = STUDY as usize;
/// The numbers of the equation x·y = 0 and of the form that is one, after those of the body.
const STUDY: u16 = 6;
const FORM: u16 = 7;
/// The number of coefficients of an equation: c, u, v, w and k.
const COEFFICIENTS: usize = 17;
/// The number of Study coordinates.
const COORDINATES: usize = 8;
/// The number of independent coefficients of the terms of an equation.
const MONOMIALS: usize = 17;
/// The number of coefficients in the table for one equation: six occur with both signs.
const TABLED: u16 = 23;
/// The index of the [constants](CONSTANTS), after the coefficients of all equations.
const CONSTANT: u16 = STUDY * TABLED;
/// The part of an equation that is rounding if the other equations leave no more of it.
const DEPENDENT: f64 = 1e-10;
/// The number of the pseudorandom coefficients of the known body. Of the first eleven it is the one whose poses are
/// determined best.
const KNOWN: u64 = 8;
/// The numbers of its equations among those coefficients.
const KNOWN_FORMS: [u8; EQUATIONS] = [0, 1, 2, 3, 4, 5];
/// The coefficients of the form of x that is equal to one. A rotation orthogonal to it would count as infinite, so they
/// are none of the numbers that rotations have in use.
const PATCH: [f64; 4] = [0.743_1, 0.376_4, -0.478_9, 0.281_7];

/// The terms of an equation, with the indices of their coefficients. The last six coefficients are those of the indices
/// 1 to 6 with the other sign.
const OF_EQUATION: [Term; 26] = [
    Term::new(0, 0, &[(4, 2)]),
    Term::new(0, 0, &[(5, 2)]),
    Term::new(0, 0, &[(6, 2)]),
    Term::new(0, 0, &[(7, 2)]),
    // The vector x₀ y - y₀ x.
    Term::new(0, 1, &[(0, 1), (5, 1)]),
    Term::new(0, 2, &[(0, 1), (6, 1)]),
    Term::new(0, 3, &[(0, 1), (7, 1)]),
    Term::new(0, 17, &[(1, 1), (4, 1)]),
    Term::new(0, 18, &[(2, 1), (4, 1)]),
    Term::new(0, 19, &[(3, 1), (4, 1)]),
    // The vector x × y.
    Term::new(0, 4, &[(2, 1), (7, 1)]),
    Term::new(0, 5, &[(3, 1), (5, 1)]),
    Term::new(0, 6, &[(1, 1), (6, 1)]),
    Term::new(0, 20, &[(3, 1), (6, 1)]),
    Term::new(0, 21, &[(1, 1), (7, 1)]),
    Term::new(0, 22, &[(2, 1), (5, 1)]),
    Term::new(0, 7, &[(0, 2)]),
    Term::new(0, 8, &[(0, 1), (1, 1)]),
    Term::new(0, 9, &[(0, 1), (2, 1)]),
    Term::new(0, 10, &[(0, 1), (3, 1)]),
    Term::new(0, 11, &[(1, 2)]),
    Term::new(0, 12, &[(1, 1), (2, 1)]),
    Term::new(0, 13, &[(1, 1), (3, 1)]),
    Term::new(0, 14, &[(2, 2)]),
    Term::new(0, 15, &[(2, 1), (3, 1)]),
    Term::new(0, 16, &[(3, 2)]),
];
/// The terms of the other equations.
const FURTHER: [Term; 9] = [
    Term::new(STUDY, CONSTANT, &[(0, 1), (4, 1)]),
    Term::new(STUDY, CONSTANT, &[(1, 1), (5, 1)]),
    Term::new(STUDY, CONSTANT, &[(2, 1), (6, 1)]),
    Term::new(STUDY, CONSTANT, &[(3, 1), (7, 1)]),
    Term::new(FORM, CONSTANT + 1, &[(0, 1)]),
    Term::new(FORM, CONSTANT + 2, &[(1, 1)]),
    Term::new(FORM, CONSTANT + 3, &[(2, 1)]),
    Term::new(FORM, CONSTANT + 4, &[(3, 1)]),
    Term::new(FORM, CONSTANT + 5, &[]),
];
/// The coefficients of the other equations.
const CONSTANTS: [f64; 6] = [1.0, PATCH[0], PATCH[1], PATCH[2], PATCH[3], -1.0];
/// The terms of all equations.
const TERMS: [Term; EQUATIONS * OF_EQUATION.len() + FURTHER.len()] = {
    let mut terms = [FURTHER[0]; EQUATIONS * OF_EQUATION.len() + FURTHER.len()];
    let (mut index, mut equation) = (0, 0);
    while equation < STUDY {
        let mut term = 0;
        while term < OF_EQUATION.len() {
            let Term {
                coefficient, powers, ..
            } = OF_EQUATION[term];
            terms[index] = Term::new(equation, equation * TABLED + coefficient, powers);
            (index, term) = (index + 1, term + 1);
        }
        equation += 1;
    }
    let mut further = 0;
    while further < FURTHER.len() {
        terms[index] = FURTHER[further];
        (index, further) = (index + 1, further + 1);
    }
    terms
};
const SYSTEM: PolynomialSystem<COORDINATES> = PolynomialSystem::new(&TERMS);

/// The equations of a body in space, whose unknowns are three coordinates and the three angles of a product of
/// elementary rotations.
///
/// Six equations c p·p + u·p + v·Rᵀp + Σ wᵢⱼ Rᵢⱼ + k = 0 determine the position p and the rotation R. Their
/// coefficients are given one equation after another, in the order c, u, v, w row by row, k.
///
/// The variables of a solution are p, and then cosine and sine of each angle in the order of the product. Each of up to
/// 40 poses is passed on with both of its triples of angles.
#[derive(Clone, Copy, Debug)]
pub struct BodySystem {
    axes: [usize; 3],
}

impl BodySystem {
    /// The system with rotations about these axes, the first factor of the product first: 0 for x, 1 for y, 2 for z.
    /// No axis follows itself; such a system is [unsuitable](Unsuitable::Table).
    #[must_use]
    pub const fn new(axes: [usize; 3]) -> Self {
        Self { axes }
    }

    /// Cosines and sines of the angles of a rotation, in both triples that give it.
    fn angles(&self, rotation: &[[f64; 3]; 3]) -> [[[f64; 2]; 3]; 2] {
        let [first, middle, last] = self.axes;
        let (beside_first, beside_last) = (3 - first - middle, 3 - middle - last);
        let [orientation, last_orientation] =
            [[first, middle], [middle, last]].map(|[before, after]| if (before + 1) % 3 == after { 1.0 } else { -1.0 });
        // The rotation about the first axis brings the last axis into the plane that is normal to the middle axis.
        let across = [orientation * rotation[beside_first][last], -rotation[middle][last]];
        let length = Float::hypot(across[0], across[1]);
        [1.0, -1.0].map(|side: f64| {
            // If the last axis is along the first, any first angle will do.
            let [cosine, sine] = if length == 0.0 {
                [1.0, 0.0]
            } else {
                across.map(|part| side * part / length)
            };
            // The product of the other two factors.
            let mut rest = *rotation;
            for column in 0..3 {
                let [along, beside] = [middle, beside_first].map(|row| rotation[row][column]);
                rest[middle][column] = cosine * along + orientation * sine * beside;
                rest[beside_first][column] = cosine * beside - orientation * sine * along;
            }
            [
                [cosine, sine],
                [rest[last][last], last_orientation * rest[beside_last][last]],
                [rest[middle][middle], last_orientation * rest[middle][beside_last]],
            ]
        })
    }
}

impl AllSolutions<9> for BodySystem {
    /// Passes on each of up to 40 poses with both of its triples of angles. The 40 paths take about 0.05 s. There is
    /// always room for them: they need about 40 kB of the stack, whatever `PATHS` is.
    fn real_solutions<const PATHS: usize>(
        &self,
        coefficients: &[f64],
        mut found: impl FnMut(Solution<9>),
    ) -> Result<PathCounts, Unsuitable> {
        let [first, middle, last] = self.axes;
        let gives_all_rotations = first != middle && middle != last && self.axes.iter().all(|axis| *axis < 3);
        let (given, rest) = coefficients.as_chunks::<COEFFICIENTS>();
        let given: &[[f64; COEFFICIENTS]; EQUATIONS] = given.try_into().map_err(|_| Unsuitable::Table)?;
        if !gives_all_rotations || !rest.is_empty() {
            return Err(Unsuitable::Table);
        }
        if let Some(coefficient) = coefficients.iter().position(|value| !value.is_finite()) {
            return Err(Unsuitable::NotFinite { coefficient });
        }
        let unit = unit(given);
        let mut equations = [[0.0; MONOMIALS]; EQUATIONS];
        for (equation, (equation_in_unit, given)) in equations.iter_mut().zip(given).enumerate() {
            *equation_in_unit = scaled(given, unit).ok_or(Unsuitable::NoVariable { equation })?;
        }
        separate(&mut equations);
        let known_equations: [[Complex; MONOMIALS]; EQUATIONS] =
            KNOWN_FORMS.map(|form| core::array::from_fn(|entry| sequence::entry(KNOWN, form, entry)));
        let known = KnownSystem {
            coefficients: &tabled(&known_equations, Complex::real),
            points: &POSES.map(|pose| {
                let entry = |index: usize| Complex::new(f64::from(pose[2 * index]), f64::from(pose[2 * index + 1]));
                let x: [Complex; COORDINATES] = core::array::from_fn(entry);
                let parts = PATCH.iter().zip(&x);
                (x, parts.fold(Complex::ZERO, |sum, (share, x)| sum + x.scale(*share)))
            }),
        };
        let scales = Scales {
            variables: [1.0; COORDINATES],
            equations: [1.0; COORDINATES],
        };
        solutions::<COORDINATES, { POSES.len() }>(
            &SYSTEM,
            &tabled(&equations, |value| value),
            &[2, 2, 2, 2, 2, 2, 2, 1],
            &scales,
            Some(known),
            |solution| {
                let (position, rotation) = pose(&solution.values);
                let [x, y, z] = position.map(|part| part * unit);
                for [[c1, s1], [c2, s2], [c3, s3]] in self.angles(&rotation) {
                    found(Solution {
                        values: [x, y, z, c1, s1, c2, s2, c3, s3],
                        multiplicity: solution.multiplicity,
                        condition: solution.condition,
                    });
                }
            },
        )
    }
}

/// The position and the rotation of a pose.
fn pose(&[x0, x1, x2, x3, y0, y1, y2, y3]: &[f64; COORDINATES]) -> ([f64; 3], [[f64; 3]; 3]) {
    let inverse = 1.0 / (x0 * x0 + x1 * x1 + x2 * x2 + x3 * x3);
    let position = [
        x0 * y1 - y0 * x1 + x2 * y3 - x3 * y2,
        x0 * y2 - y0 * x2 + x3 * y1 - x1 * y3,
        x0 * y3 - y0 * x3 + x1 * y2 - x2 * y1,
    ];
    let rotation = [
        [
            0.5 * (x0 * x0 + x1 * x1 - x2 * x2 - x3 * x3),
            x1 * x2 - x0 * x3,
            x1 * x3 + x0 * x2,
        ],
        [
            x1 * x2 + x0 * x3,
            0.5 * (x0 * x0 - x1 * x1 + x2 * x2 - x3 * x3),
            x2 * x3 - x0 * x1,
        ],
        [
            x1 * x3 - x0 * x2,
            x2 * x3 + x0 * x1,
            0.5 * (x0 * x0 - x1 * x1 - x2 * x2 + x3 * x3),
        ],
    ];
    (
        position.map(|part| 2.0 * inverse * part),
        rotation.map(|row| row.map(|element| 2.0 * inverse * element)),
    )
}

/// A power of two of about the size of the lengths.
fn unit(equations: &[[f64; COEFFICIENTS]; EQUATIONS]) -> f64 {
    let largest = |range: core::ops::Range<usize>| {
        equations
            .iter()
            .flat_map(|equation| &equation[range.clone()])
            .fold(0.0_f64, |most, value| most.max(value.abs()))
    };
    // In this order the coefficients belong to powers of the position, from the second down.
    let [squares, lengths, constants] = [largest(0..1), largest(1..7), largest(7..COEFFICIENTS)];
    let of_squares = Float::sqrt(constants / squares).max(lengths / squares);
    let unit = if squares > 0.0 { of_squares } else { constants / lengths };
    if unit > 0.0 && unit.is_finite() {
        Float::exp2(Float::round(Float::log2(unit)))
    } else {
        1.0
    }
}

/// The coefficients of the monomials of an equation, divided by the largest; `None` if all are zero.
fn scaled(
    &[
        c,
        u0,
        u1,
        u2,
        v0,
        v1,
        v2,
        w00,
        w01,
        w02,
        w10,
        w11,
        w12,
        w20,
        w21,
        w22,
        k,
    ]: &[f64; COEFFICIENTS],
    unit: f64,
) -> Option<[f64; MONOMIALS]> {
    let length = 2.0 * unit;
    let coefficients = [
        length * length * c,
        length * (u0 + v0),
        length * (u1 + v1),
        length * (u2 + v2),
        length * (u0 - v0),
        length * (u1 - v1),
        length * (u2 - v2),
        k + w00 + w11 + w22,
        2.0 * (w21 - w12),
        2.0 * (w02 - w20),
        2.0 * (w10 - w01),
        k + w00 - w11 - w22,
        2.0 * (w01 + w10),
        2.0 * (w02 + w20),
        k - w00 + w11 - w22,
        2.0 * (w12 + w21),
        k - w00 - w11 + w22,
    ];
    let largest = coefficients.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    (largest > 0.0).then(|| coefficients.map(|value| value / largest))
}

/// Replaces equations by their differences with multiples of those before: the equations of long legs are nearly the
/// same, their differences are not. Equations that follow from others stay as they are.
fn separate(equations: &mut [[f64; MONOMIALS]; EQUATIONS]) {
    for index in 0..EQUATIONS {
        let (before, equation) = equations.split_at_mut(index);
        let equation = &mut equation[0];
        let dot = |a: &[f64; MONOMIALS], b: &[f64; MONOMIALS]| a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b);
        let mut rest = *equation;
        // Once loses digits.
        for _ in 0..2 {
            for unit in &*before {
                let along = dot(&rest, unit) / dot(unit, unit);
                rest.iter_mut()
                    .zip(unit)
                    .for_each(|(value, unit)| *value -= along * unit);
            }
        }
        let (length, whole) = (Float::sqrt(dot(&rest, &rest)), Float::sqrt(dot(equation, equation)));
        if length > DEPENDENT * whole {
            *equation = rest.map(|value| value / length);
        }
    }
}

/// The coefficients of the table: those of each equation, of which six occur with both signs, and the constants.
fn tabled<C: Copy + Neg<Output = C>>(
    equations: &[[C; MONOMIALS]; EQUATIONS],
    constant: impl Fn(f64) -> C,
) -> [C; CONSTANT as usize + CONSTANTS.len()] {
    core::array::from_fn(|index| {
        let (equation, coefficient) = (index / usize::from(TABLED), index % usize::from(TABLED));
        let Some(coefficients) = equations.get(equation) else {
            return constant(CONSTANTS[index - usize::from(CONSTANT)]);
        };
        let other_sign = || -coefficients[coefficient + 1 - MONOMIALS];
        coefficients.get(coefficient).copied().unwrap_or_else(other_sign)
    })
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::super::sequence::FixedSequence;
    use super::super::{AllSolutions, PathCounts, real_solutions};
    use super::{BodySystem, COEFFICIENTS, EQUATIONS, SYSTEM, scaled, tabled, unit};

    type Matrix = [[f64; 3]; 3];

    /// General coefficients, not those of legs.
    fn general(random: &mut FixedSequence) -> [[f64; COEFFICIENTS]; EQUATIONS] {
        [(); EQUATIONS].map(|()| [(); COEFFICIENTS].map(|()| 2.0 * random.fraction() - 1.0))
    }

    fn sequences() -> impl Iterator<Item = [usize; 3]> {
        (0..27)
            .map(|number| [number / 9, number / 3 % 3, number % 3])
            .filter(|[first, middle, last]| first != middle && middle != last)
    }

    /// The product of elementary rotations with the given cosines and sines.
    fn rotation(axes: [usize; 3], angles: &[[f64; 2]; 3]) -> Matrix {
        let mut product = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for (axis, [cosine, sine]) in axes.into_iter().zip(angles) {
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            for row in &mut product {
                [row[next], row[last]] = [
                    cosine * row[next] + sine * row[last],
                    cosine * row[last] - sine * row[next],
                ];
            }
        }
        product
    }

    /// The value of an equation of a pose, and the sum of the moduli of its terms.
    fn value(equation: &[f64; COEFFICIENTS], position: [f64; 3], rotation: &Matrix) -> [f64; 2] {
        let rotated = |column: usize| (0..3).map(|row| rotation[row][column] * position[row]).sum::<f64>();
        let square = position.iter().map(|part| part * part).sum();
        let factors = [square]
            .into_iter()
            .chain(position)
            .chain((0..3).map(rotated))
            .chain(rotation.iter().flatten().copied())
            .chain([1.0]);
        let terms = equation
            .iter()
            .zip(factors)
            .map(|(coefficient, factor)| coefficient * factor);
        terms.fold([0.0; 2], |[sum, size], term| [sum + term, size + term.abs()])
    }

    /// The product of the degrees is 128. Of these paths, as many as there are known poses do not lead to x = 0.
    #[test]
    fn there_are_as_many_solutions_as_known_poses() {
        let equations = general(&mut FixedSequence::new(7));
        let unit = unit(&equations);
        let scaled = equations.map(|equation| scaled(&equation, unit).expect("it is not zero"));
        let mut real = 0;
        let every = real_solutions::<8, 128>(&SYSTEM, &tabled(&scaled, |value| value), |_| real += 1);
        let solutions = BodySystem::new([2, 1, 0]).real_solutions::<80>(equations.as_flattened(), |_| {});
        let expected = PathCounts {
            paths: 128,
            regular: 40,
            real,
            at_infinity: 88,
            ..PathCounts::default()
        };
        assert_eq!(every, Ok(expected));
        assert!(real > 0);
        let (paths, at_infinity) = (40, 0);
        assert_eq!(
            solutions,
            Ok(PathCounts {
                paths,
                at_infinity,
                ..expected
            })
        );
    }

    /// Every pose fulfils the equations in any unit of length, and is given by two triples of angles.
    #[test]
    fn poses_fulfil_the_equations() {
        let mut random = FixedSequence::new(9);
        let mut all = 0;
        for (axes, length) in [([2, 1, 0], 1.0), ([0, 2, 0], 1e3), ([1, 2, 0], 1e-6)] {
            let mut equations = general(&mut random);
            for equation in &mut equations {
                equation[0] /= length * length;
                equation[1..7].iter_mut().for_each(|value| *value /= length);
            }
            let mut found = Vec::new();
            let counts = BodySystem::new(axes)
                .real_solutions::<80>(equations.as_flattened(), |solution| found.push(solution))
                .expect("it is a system");
            assert_eq!((counts.regular, counts.is_complete()), (40, true));
            assert_eq!(found.len(), 2 * counts.real);
            for solution in found {
                let [x, y, z, c1, s1, c2, s2, c3, s3] = solution.values;
                let rotation = rotation(axes, &[[c1, s1], [c2, s2], [c3, s3]]);
                for equation in &equations {
                    let [sum, size] = value(equation, [x, y, z], &rotation);
                    // Rounding is magnified by the condition, and by a few operations.
                    let bound = 16.0 * f64::EPSILON * solution.condition * size;
                    assert!(sum.abs() <= bound, "{axes:?}: {sum:e} above {bound:e}");
                }
                all += 1;
            }
        }
        assert!(all > 8, "{all} are too few to decide");
    }

    /// Both triples give the rotation for every sequence of axes, also where only the sum or the difference of the
    /// first and the last angle is determined.
    #[test]
    fn a_rotation_has_two_triples_of_angles() {
        let mut random = FixedSequence::new(3);
        for axes in sequences() {
            let locked = usize::from(axes[0] != axes[2]);
            for middle in [None, Some(0.0), Some(core::f64::consts::FRAC_PI_2), Some(1e-9)] {
                let mut angles = [(); 3].map(|()| 6.0 * random.fraction() - 3.0);
                angles[1] = middle.unwrap_or(angles[1]);
                let given = angles.map(|angle| [angle.cos(), angle.sin()]);
                let expected = rotation(axes, &given);
                let triples = BodySystem::new(axes).angles(&expected);
                for triple in &triples {
                    let found = rotation(axes, triple);
                    for (found, expected) in found.as_flattened().iter().zip(expected.as_flattened()) {
                        assert!((found - expected).abs() <= 8.0 * f64::EPSILON, "{axes:?}: {angles:?}");
                    }
                }
                if middle.is_none() {
                    let is_given = |triple: &[[f64; 2]; 3]| {
                        let parts = triple.as_flattened().iter().zip(given.as_flattened());
                        parts.map(|(found, given)| (found - given).abs()).fold(0.0, f64::max)
                    };
                    let distances = triples.each_ref().map(is_given);
                    // The middle angle is far from where the triples meet.
                    assert!(given[1][1 - locked].abs() > 0.02, "{angles:?}");
                    assert!(
                        distances.iter().any(|distance| *distance < 1e-12),
                        "{axes:?}: {angles:?}"
                    );
                    assert!(
                        distances.iter().any(|distance| *distance > 0.01),
                        "{axes:?}: {angles:?}"
                    );
                }
            }
        }
    }

    /// Coefficients that are too few, not finite or all zero are refused.
    #[test]
    fn what_is_no_body_is_refused() {
        use super::Unsuitable::{NoVariable, NotFinite, Table};

        let system = BodySystem::new([2, 1, 0]);
        let refused = |coefficients: &[f64]| system.real_solutions::<80>(coefficients, |_| {}).unwrap_err();
        let mut equations = general(&mut FixedSequence::new(1));
        assert_eq!(refused(equations[1..].as_flattened()), Table);
        assert_eq!(refused(&equations.as_flattened()[1..]), Table);
        for axes in [[0, 0, 1], [0, 1, 1], [0, 1, 3]] {
            let solved = BodySystem::new(axes).real_solutions::<80>(equations.as_flattened(), |_| {});
            assert_eq!(solved, Err(Table));
        }
        equations[4] = [0.0; COEFFICIENTS];
        assert_eq!(refused(equations.as_flattened()), NoVariable { equation: 4 });
        equations[1][3] = f64::INFINITY;
        assert_eq!(refused(equations.as_flattened()), NotFinite { coefficient: 20 });
    }
}
