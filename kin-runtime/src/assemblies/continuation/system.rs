//! Systems of polynomial equations as tables.

use super::complex::Complex;
use super::sequence;

/// One term of one equation: a coefficient times powers of variables.
pub type Term = BorrowedTerm<'static>;

/// A [`Term`] whose powers may be found at run time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BorrowedTerm<'a> {
    /// The index of its equation.
    pub equation: u16,
    /// The index of its coefficient.
    pub coefficient: u16,
    /// The index and power of each variable in the term. Each variable occurs once, and its power is not zero.
    pub powers: &'a [(u16, u8)],
}

impl<'a> BorrowedTerm<'a> {
    /// A term of an equation, with its coefficient and the powers of its variables.
    #[must_use]
    pub const fn new(equation: u16, coefficient: u16, powers: &'a [(u16, u8)]) -> Self {
        Self {
            equation,
            coefficient,
            powers,
        }
    }

    /// The sum of the powers.
    pub(super) const fn degree(&self) -> u32 {
        let (mut degree, mut index) = (0, 0);
        while index < self.powers.len() {
            degree += self.powers[index].1 as u32;
            index += 1;
        }
        degree
    }
}

/// As many polynomial equations as variables, `M`. The sum of the terms of each equation is zero.
///
/// The table contains everything known at compile time. The coefficients depend on dimensions and inputs, and are given
/// when the system is solved.
///
/// ```
/// use kin_core::continuation::{PolynomialSystem, Term};
///
/// // a x² + b y + c = 0 and d x y + e = 0
/// const SYSTEM: PolynomialSystem<2> = PolynomialSystem::new(&[
///     Term::new(0, 0, &[(0, 2)]),
///     Term::new(0, 1, &[(1, 1)]),
///     Term::new(0, 2, &[]),
///     Term::new(1, 3, &[(0, 1), (1, 1)]),
///     Term::new(1, 4, &[]),
/// ]);
/// assert_eq!(SYSTEM.paths(), 4);
/// ```
pub type PolynomialSystem<const M: usize> = BorrowedSystem<'static, M>;

/// A [`PolynomialSystem`] whose table may be made at run time. There is room for `M` variables.
#[derive(Clone, Copy, Debug)]
pub struct BorrowedSystem<'a, const M: usize> {
    terms: &'a [BorrowedTerm<'a>],
    pairs: &'a [[u16; 2]],
    variables: usize,
}

impl<'a, const M: usize> BorrowedSystem<'a, M> {
    /// The system with these terms, sorted by equation.
    #[must_use]
    pub const fn new(terms: &'a [BorrowedTerm<'a>]) -> Self {
        Self {
            terms,
            pairs: &[],
            variables: M,
        }
    }

    /// The same system with fewer variables than there is room for. The further values of a solution are zero.
    #[must_use]
    pub const fn with_variables(self, variables: usize) -> Self {
        Self {
            variables: if variables < M { variables } else { M },
            ..self
        }
    }

    /// The number of variables, and of equations.
    pub(super) const fn variables(&self) -> usize {
        self.variables
    }

    /// The same system, with pairs of variables that are the coordinates of a vector in the plane.
    ///
    /// Like the cosine and the sine of an angle, x and y are then replaced by x + i y and x - i y where an equation of
    /// high degree has half of its degree in each kind.
    #[must_use]
    pub const fn with_pairs(self, pairs: &'a [[u16; 2]]) -> Self {
        Self { pairs, ..self }
    }

    /// The terms.
    #[must_use]
    pub const fn terms(&self) -> &'a [BorrowedTerm<'a>] {
        self.terms
    }

    /// The largest number of paths to the solutions, which is the product of the degrees of the equations.
    ///
    /// By Bézout's theorem the system has at most this many isolated solutions. Often there are fewer paths.
    #[must_use]
    pub const fn paths(&self) -> usize {
        let (mut paths, mut equation) = (1_usize, 0);
        while equation < self.variables {
            let (mut degree, mut index) = (0, 0);
            while index < self.terms.len() {
                let term = &self.terms[index];
                if term.equation as usize == equation && term.degree() > degree {
                    degree = term.degree();
                }
                index += 1;
            }
            paths = paths.saturating_mul(degree as usize);
            equation += 1;
        }
        paths
    }

    /// The degree of each equation, not counting terms with the coefficient zero; zero beyond the last equation.
    pub(super) fn degrees(&self, coefficients: &[f64]) -> [u8; M] {
        let mut degrees = [0; M];
        for term in self.terms {
            if coefficients[usize::from(term.coefficient)] != 0.0 {
                let degree = term.powers.iter().fold(0, |sum, &(_, power)| sum + power);
                let most = &mut degrees[usize::from(term.equation)];
                *most = degree.max(*most);
            }
        }
        degrees
    }

    /// The index of the first term of an equation, and the index after its last.
    pub(super) fn range(&self, equation: usize) -> [usize; 2] {
        let first = self.terms.partition_point(|term| usize::from(term.equation) < equation);
        let end = self
            .terms
            .partition_point(|term| usize::from(term.equation) <= equation);
        [first, end]
    }

    /// The terms of an equation that are not zero, and their coefficients.
    fn present<'b>(
        &'b self,
        [first, end]: [usize; 2],
        coefficients: &'b [f64],
    ) -> impl Iterator<Item = (f64, &'a [(u16, u8)])> + 'b {
        self.terms[first..end].iter().filter_map(|term| {
            let coefficient = coefficients[usize::from(term.coefficient)];
            (coefficient != 0.0).then_some((coefficient, term.powers))
        })
    }

    /// The variables that occur in an equation, in ascending order, and their number.
    pub(super) fn support(&self, range: [usize; 2], coefficients: &[f64]) -> ([usize; M], usize) {
        let mut occurs = [false; M];
        for (_, powers) in self.present(range, coefficients) {
            for &(variable, _) in powers {
                occurs[usize::from(variable)] = true;
            }
        }
        let (mut support, mut occurring) = ([0; M], 0);
        for (variable, _) in occurs.iter().enumerate().filter(|(_, occurs)| **occurs) {
            support[occurring] = variable;
            occurring += 1;
        }
        (support, occurring)
    }

    /// Whether an equation has two variables and second degree, and its terms of second degree are a multiple of the
    /// sum of their squares.
    pub(super) fn is_circle(&self, range: [usize; 2], coefficients: &[f64]) -> bool {
        let mut squares = (0, None);
        for (coefficient, powers) in self.present(range, coefficients) {
            match *powers {
                [(_, 2)] if squares.1.is_none_or(|known| known == coefficient) => {
                    squares = (squares.0 + 1, Some(coefficient));
                }
                [] | [(_, 1)] => {}
                _ => return false,
            }
        }
        squares.0 == 2 && self.support(range, coefficients).1 == 2
    }

    /// The variables in the first and in the second linear form of an equation that is a sum of products of such forms.
    /// Variables are counted among those that occur in the equation.
    ///
    /// The variables are coloured so that the two variables of each product differ. Variables that occur in no product
    /// have both colours. If there is no such colouring, all variables have both.
    pub(super) fn members(
        &self,
        range: [usize; 2],
        coefficients: &[f64],
        support: &[usize],
        degree: u8,
    ) -> [[bool; 2]; M] {
        let mut members = [[true; 2]; M];
        let both = members;
        if degree != 2 {
            return both;
        }
        let position = |variable: u16| support.iter().position(|&known| known == usize::from(variable));
        let products = || {
            self.present(range, coefficients)
                .filter_map(|(_, powers)| match *powers {
                    [(first, 1), (second, 1)] => Some([position(first)?, position(second)?]),
                    _ => None,
                })
        };
        let squares = self
            .present(range, coefficients)
            .any(|(_, powers)| matches!(powers, [(_, 2)]));
        if squares {
            return both;
        }
        for seed in 0..support.len() {
            if members[seed] != [true; 2] || !products().any(|pair| pair.contains(&seed)) {
                continue;
            }
            members[seed] = [true, false];
            // Each sweep colours at least one more connected variable.
            for _ in 0..support.len() {
                for [first, second] in products() {
                    for (known, other) in [(first, second), (second, first)] {
                        if members[known] == [true; 2] {
                            continue;
                        }
                        let [in_first, in_second] = members[known];
                        let opposite = [in_second, in_first];
                        if members[other] == [true; 2] {
                            members[other] = opposite;
                        } else if members[other] != opposite {
                            return both;
                        }
                    }
                }
            }
        }
        members
    }

    /// The isotropic coordinates of an equation, if they bound it better than its degree does.
    ///
    /// Variables c and s that lie on a common circle have the isotropic coordinates c + i s and c - i s. The
    /// determinant of the Jacobian of plane loops has half of its degree in the coordinates of the first kind, and half
    /// in those of the second. For each variable of the equation, the result is the number of its circle, and whether
    /// it is the second variable there. It is `None` if a variable lies on no circle, or if the degree is not divided
    /// in this way.
    pub(super) fn isotropic(
        &self,
        range: [usize; 2],
        coefficients: &[f64],
        support: &[usize],
        degree: u8,
    ) -> Option<[(usize, bool); M]> {
        if degree < 4 || !degree.is_multiple_of(2) {
            return None;
        }
        let mut roles = [None; M];
        for equation in 0..self.variables {
            let circle = self.range(equation);
            if circle != range && self.is_circle(circle, coefficients) {
                let (pair, _) = self.support(circle, coefficients);
                for (side, variable) in pair[..2].iter().enumerate() {
                    if let Some(position) = support.iter().position(|known| known == variable) {
                        roles[position] = Some((equation, side == 1));
                    }
                }
            }
        }
        for (number, pair) in self.pairs.iter().enumerate() {
            for (side, variable) in pair.iter().enumerate() {
                if let Some(position) = support.iter().position(|known| *known == usize::from(*variable)) {
                    roles[position] = Some((self.variables + number, side == 1));
                }
            }
        }
        let mut known = [(0, false); M];
        for (known, role) in known.iter_mut().zip(&roles[..support.len()]) {
            *known = (*role)?;
        }
        // The coefficients of the powers of λ, if all coordinates of the first kind are multiplied by λ: the sums over
        // its roots of unity.
        let points = f64::from(degree) + 1.0;
        let root_of_unity = |count: f64| Complex::unit(core::f64::consts::TAU * count / points);
        let value = |factor: Complex| {
            let variable = |variable: u16| {
                let position = support.iter().position(|known| *known == usize::from(variable));
                let (circle, is_second) = position.map_or((0, false), |position| known[position]);
                let [first, second] = [0, 1].map(|form| sequence::entry(1, form, circle));
                let first = factor * first;
                if is_second {
                    (first - second) * Complex::new(0.0, -0.5)
                } else {
                    (first + second).scale(0.5)
                }
            };
            self.present(range, coefficients)
                .fold(Complex::ZERO, |sum, (coefficient, powers)| {
                    let product = powers
                        .iter()
                        .fold(Complex::real(coefficient), |product, &(factor, power)| {
                            product * variable(factor).power(power)
                        });
                    sum + product
                })
        };
        let (mut largest, mut beyond) = (0.0_f64, 0.0_f64);
        for power in 0..=degree {
            let sum = (0..=degree).map(f64::from).fold(Complex::ZERO, |sum, point| {
                sum + value(root_of_unity(point)) * root_of_unity(-point * f64::from(power))
            });
            largest = largest.max(sum.norm());
            if power > degree / 2 {
                beyond = beyond.max(sum.norm());
            }
        }
        (beyond <= 1e-10 * largest).then_some(known)
    }

    /// Whether the equations are in order, all indices of the table exist, and no degree exceeds the largest that can
    /// be counted.
    pub(super) fn fits(&self, coefficients: usize) -> bool {
        self.terms.is_sorted_by_key(|term| term.equation)
            && self.terms.iter().all(|term| {
                usize::from(term.equation) < self.variables
                    && usize::from(term.coefficient) < coefficients
                    && u8::try_from(term.degree()).is_ok()
                    && term
                        .powers
                        .iter()
                        .all(|&(variable, power)| usize::from(variable) < self.variables && power > 0)
            })
    }
}

#[cfg(test)]
mod tests {
    use super::{PolynomialSystem, Term};

    fn term(equation: u16, powers: &'static [(u16, u8)]) -> Term {
        Term {
            equation,
            coefficient: equation,
            powers,
        }
    }

    #[test]
    fn circles_are_known() {
        for (powers, circle) in [
            ([[(0, 2)].as_slice(), &[(3, 2)], &[(3, 1)], &[]], true),
            ([&[(0, 2)], &[(3, 2)], &[(2, 1)], &[]], false),
            ([&[(0, 2)], &[(0, 1), (3, 1)], &[(3, 2)], &[]], false),
            ([&[(0, 2)], &[(3, 1)], &[(0, 1)], &[]], false),
        ] {
            let terms = std::vec::Vec::from(powers.map(|powers| term(0, std::boxed::Box::leak(powers.into()))));
            let system = PolynomialSystem::<4>::new(terms.leak());
            assert_eq!(system.is_circle(system.range(0), &[1.0]), circle, "{powers:?}");
        }
    }

    #[test]
    fn products_are_divided() {
        // The equation r c + q s + t, and a triangle.
        const SYSTEM: PolynomialSystem<6> = PolynomialSystem::new(&[
            Term::new(0, 0, &[(0, 1), (1, 1)]),
            Term::new(0, 0, &[(0, 1), (4, 1)]),
            Term::new(0, 0, &[(2, 1), (3, 1)]),
            Term::new(0, 0, &[(5, 1)]),
            Term::new(1, 0, &[(0, 1), (1, 1)]),
            Term::new(1, 0, &[(1, 1), (2, 1)]),
            Term::new(1, 0, &[(0, 1), (2, 1)]),
        ]);
        let members = |equation| {
            let range = SYSTEM.range(equation);
            let (support, occurring) = SYSTEM.support(range, &[1.0]);
            SYSTEM.members(range, &[1.0], &support[..occurring], 2)
        };
        let (first, second) = ([true, false], [false, true]);
        assert_eq!(members(0), [first, second, first, second, second, [true; 2]]);
        assert_eq!(members(1), [[true; 2]; 6]);
    }
}
