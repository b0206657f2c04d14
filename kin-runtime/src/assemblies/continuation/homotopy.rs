//! The homotopy: a system that is deformed from one with known solutions into the one to be solved.

use num_traits::Float;

use super::complex::{Complex, largest};
use super::factors::ComplexFactors;
use super::reduction::Coordinates;
use super::scaling::Scales;
use super::sequence::{self, FixedSequence};
use super::system::BorrowedSystem;

/// H(X, t) = t γ G(X) + (1 - t) F(X), homogeneous in X, with a random γ of modulus one for each equation.
///
/// The known solutions belong to t = 1, the wanted ones to t = 0. G is a product of linear forms, chosen so that a sum
/// of such products with other coefficients gives F:
///
/// - For a(x² + y²) + b x + c y + d, the circle, the forms are x + i y - p and x - i y - q with random p, q.
/// - For an equation of second degree without squares whose variables can be divided into two sets, such that no
///   product has two variables of the same set, one form takes the first set and 1, the other the second set and 1,
///   with random coefficients.
/// - For an equation that has half of its degree in the coordinates c + i s of circles, and half in c - i s, half of
///   the forms take the first and half the second, each with 1 and random coefficients.
/// - For any other equation of degree d, there are d forms of all its variables and 1, with random coefficients.
///
/// If a [known](KnownSystem) system of the same family is given, G is that system instead.
#[derive(Clone, Debug)]
pub(super) struct Homotopy<'a, const M: usize> {
    system: &'a BorrowedSystem<'a, M>,
    coefficients: &'a [f64],
    coordinates: Coordinates<M>,
    /// The equations of degree two or more. There are as many as free coordinates.
    equations: [NonlinearEquation<M>; M],
    /// The number of the forms of coordinates that make the marks.
    number: u64,
    /// The forms of the equation of the highest degree.
    drawn: DrawnForms<M>,
    known: Option<KnownSystem<'a, M>>,
}

/// A system with the same terms as the one to be solved, and general coefficients, whose solutions are known. All terms
/// of the equations that are not of first degree are of second degree.
#[derive(Clone, Copy, Debug)]
pub(super) struct KnownSystem<'a, const M: usize> {
    pub(super) coefficients: &'a [Complex],
    /// The coordinates X₁ ... and X₀ of the solutions to a few digits, up to a factor.
    pub(super) points: &'a [([Complex; M], Complex)],
}

/// The linear forms of the start system for one equation, drawn once.
#[derive(Clone, Debug)]
struct DrawnForms<const M: usize> {
    /// The row of the equation.
    row: usize,
    /// The coefficients of the variables of the equation, and of X₀.
    forms: [([Complex; M], Complex); FACTORS],
}

/// The largest number of forms that are drawn once, and of variables in a term whose products are kept.
const FACTORS: usize = 8;

/// An equation of degree two or more.
#[derive(Clone, Copy, Debug)]
struct NonlinearEquation<const M: usize> {
    /// The index of its first term, and the index after its last.
    terms: [usize; 2],
    degree: u8,
    /// The factor of the equation.
    scale: f64,
    /// The variables that occur, and their number.
    support: [usize; M],
    occurring: usize,
    /// The number γ.
    gamma: Complex,
    start: Start<M>,
}

/// The linear forms whose product is G.
#[derive(Clone, Copy, Debug)]
enum Start<const M: usize> {
    /// The first two variables are the coordinates on a circle, and the constants are p and q.
    Circle {
        /// The unit of the variables.
        unit: f64,
        constants: [Complex; 2],
    },
    /// Random coefficients, drawn on demand because there is no room to store them all.
    Random {
        number: u64,
        /// The number of variables of the system.
        variables: usize,
        /// Whether each variable of the equation occurs in the first and in the second form. It occurs in all further
        /// forms.
        members: [[bool; 2]; M],
        /// The inverse units of the variables of the equation.
        inverse_units: [f64; M],
    },
    /// Random coefficients of isotropic coordinates: of the first kind in the forms with an even index, of the second
    /// kind in the others.
    Isotropic {
        number: u64,
        /// The number of variables of the system.
        variables: usize,
        /// The circle of each variable of the equation, and whether it is the second variable there.
        roles: [(usize, bool); M],
        /// The inverse unit of the variables.
        inverse_unit: f64,
    },
}

/// The system with its derivatives at one point.
#[derive(Clone, Debug)]
pub(super) struct Linearised<const M: usize> {
    /// The value of H.
    pub(super) value: [Complex; M],
    /// The rate ∂H/∂t.
    pub(super) rate: [Complex; M],
    /// The Jacobian ∂H/∂y, or its factors.
    pub(super) factors: ComplexFactors<M>,
}

impl<const M: usize> Linearised<M> {
    pub(super) const fn new() -> Self {
        Self {
            value: [Complex::ZERO; M],
            rate: [Complex::ZERO; M],
            factors: ComplexFactors::new(),
        }
    }
}

/// The value of a function of X, and its slopes.
#[derive(Clone, Copy)]
struct Slopes<const M: usize> {
    value: Complex,
    /// The slopes along the variables.
    along: [Complex; M],
    /// The slope along X₀.
    infinity: Complex,
}

impl<const M: usize> Slopes<M> {
    const ZERO: Self = Self {
        value: Complex::ZERO,
        along: [Complex::ZERO; M],
        infinity: Complex::ZERO,
    };

    /// Adds the slopes of a term along its variables, times the given power of X₀. Returns the term without that power.
    #[inline]
    fn add_term(&mut self, powers: &[(u16, u8)], coefficient: f64, x: &[Complex; M], lift: Complex) -> Complex {
        // The products of the factors before each one.
        let mut before = [Complex::real(coefficient); FACTORS + 1];
        for (index, &(variable, power)) in powers.iter().enumerate() {
            before[index + 1] = before[index] * x[usize::from(variable)].power(power);
        }
        let mut after = lift;
        for (index, &(variable, power)) in powers.iter().enumerate().rev() {
            let value = x[usize::from(variable)];
            let mut slope = before[index] * after;
            if power > 1 {
                slope = slope * value.power(power - 1).scale(f64::from(power));
            }
            self.along[usize::from(variable)] += slope;
            after = after * value.power(power);
        }
        before[powers.len()]
    }

    /// [`add_term`](Self::add_term) for any number of variables.
    #[cold]
    fn add_long_term(&mut self, powers: &[(u16, u8)], coefficient: f64, x: &[Complex; M], lift: Complex) -> Complex {
        let value = |(variable, power): (u16, u8)| x[usize::from(variable)].power(power);
        for (index, &(variable, power)) in powers.iter().enumerate() {
            let less = x[usize::from(variable)].power(power - 1);
            let others = powers.iter().enumerate().filter(|(other, _)| *other != index);
            let slope = others.fold(lift.scale(coefficient) * less, |slope, (_, &factor)| {
                slope * value(factor)
            });
            self.along[usize::from(variable)] += slope.scale(f64::from(power));
        }
        powers
            .iter()
            .fold(Complex::real(coefficient), |product, &factor| product * value(factor))
    }
}

impl<const M: usize> Start<M> {
    /// The coefficient of a variable in one of the factors. `index` counts the variables of the equation.
    #[inline]
    fn coefficient(&self, factor: u8, index: usize) -> Complex {
        match self {
            Self::Circle { unit, .. } => match (index, factor) {
                (0, _) => Complex::real(1.0 / unit),
                (_, 0) => Complex::new(0.0, 1.0 / unit),
                _ => Complex::new(0.0, -1.0 / unit),
            },
            Self::Random {
                number,
                members,
                inverse_units,
                ..
            } => {
                if members[index].get(usize::from(factor)).is_none_or(|member| *member) {
                    sequence::entry(*number, factor, index).scale(inverse_units[index])
                } else {
                    Complex::ZERO
                }
            }
            Self::Isotropic {
                number,
                roles,
                inverse_unit,
                ..
            } => {
                let (circle, is_second) = roles[index];
                let entry = sequence::entry(*number, factor, circle).scale(*inverse_unit);
                match (is_second, factor % 2) {
                    (false, _) => entry,
                    (true, 0) => entry * Complex::new(0.0, 1.0),
                    (true, _) => entry * Complex::new(0.0, -1.0),
                }
            }
        }
    }

    /// The coefficient of X₀ in one of the factors.
    #[inline]
    fn constant(&self, factor: u8) -> Complex {
        match self {
            Self::Circle { constants, .. } => constants[usize::from(factor.min(1))],
            Self::Random { number, variables, .. } | Self::Isotropic { number, variables, .. } => {
                sequence::entry(*number, factor, *variables)
            }
        }
    }
}

impl<const M: usize> NonlinearEquation<M> {
    const UNUSED: Self = Self {
        terms: [0; 2],
        degree: 0,
        scale: 0.0,
        support: [0; M],
        occurring: 0,
        gamma: Complex::ZERO,
        start: Start::Circle {
            unit: 1.0,
            constants: [Complex::ZERO; 2],
        },
    };

    /// One of the forms whose product is G.
    #[inline]
    fn factor(&self, factor: u8, x: &[Complex; M], infinity: Complex) -> Complex {
        self.support[..self.occurring]
            .iter()
            .enumerate()
            .fold(self.start.constant(factor) * infinity, |sum, (index, &variable)| {
                sum + self.start.coefficient(factor, index) * x[variable]
            })
    }

    /// Adds G times a factor, and its slopes times that factor, to `slopes`.
    #[inline]
    fn add_start(&self, x: &[Complex; M], infinity: Complex, times: Complex, slopes: &mut Slopes<M>) -> Complex {
        let mut product = Complex::ZERO;
        for factor in 0..self.degree {
            let mut others = Complex::ONE;
            for other in 0..self.degree {
                if other != factor {
                    others = others * self.factor(other, x, infinity);
                }
            }
            if factor == 0 {
                product = others * self.factor(0, x, infinity);
            }
            let others = others * times;
            slopes.infinity += others * self.start.constant(factor);
            for (index, &variable) in self.support[..self.occurring].iter().enumerate() {
                slopes.along[variable] += others * self.start.coefficient(factor, index);
            }
        }
        slopes.value += product * times;
        product
    }

    /// [`add_start`](Self::add_start) with forms that were drawn before.
    #[inline]
    fn add_drawn(
        &self,
        forms: &[([Complex; M], Complex)],
        x: &[Complex; M],
        infinity: Complex,
        times: Complex,
        slopes: &mut Slopes<M>,
    ) -> Complex {
        let support = &self.support[..self.occurring];
        let mut values = [Complex::ONE; FACTORS];
        let mut before = [Complex::ONE; FACTORS + 1];
        for (factor, (along, constant)) in forms.iter().enumerate() {
            let slopes_of_factor = support.iter().zip(along);
            values[factor] = slopes_of_factor.fold(*constant * infinity, |sum, (&variable, slope)| {
                sum + *slope * x[variable]
            });
            before[factor + 1] = before[factor] * values[factor];
        }
        let mut after = times;
        for (factor, (along, constant)) in forms.iter().enumerate().rev() {
            let others = before[factor] * after;
            slopes.infinity += others * *constant;
            for (&variable, slope) in support.iter().zip(along) {
                slopes.along[variable] += others * *slope;
            }
            after = after * values[factor];
        }
        let product = before[forms.len()];
        slopes.value += product * times;
        product
    }
}

impl<'a, const M: usize> Homotopy<'a, M> {
    pub(super) fn new(
        system: &'a BorrowedSystem<'a, M>,
        coefficients: &'a [f64],
        degrees: &[u8; M],
        scales: &Scales<M>,
        coordinates: Coordinates<M>,
        known: Option<KnownSystem<'a, M>>,
        number: u64,
    ) -> Self {
        let mut random = FixedSequence::new(number);
        let mut equations = [NonlinearEquation::UNUSED; M];
        let mut row = 0;
        for (equation, &degree) in degrees.iter().enumerate() {
            if degree > 1 {
                let terms = system.range(equation);
                let (support, occurring) = system.support(terms, coefficients);
                let inverse_units = core::array::from_fn(|index| 1.0 / scales.variables[support[index]]);
                equations[row] = NonlinearEquation {
                    terms,
                    degree,
                    scale: scales.equations[equation],
                    support,
                    occurring,
                    gamma: random.unit(),
                    start: if system.is_circle(terms, coefficients) {
                        Start::Circle {
                            unit: scales.variables[support[0]],
                            constants: [random.complex(), random.complex()],
                        }
                    } else if let Some(roles) = system.isotropic(terms, coefficients, &support[..occurring], degree) {
                        Start::Isotropic {
                            number: random.next(),
                            variables: system.variables(),
                            roles,
                            inverse_unit: inverse_units[0],
                        }
                    } else {
                        Start::Random {
                            number: random.next(),
                            variables: system.variables(),
                            members: system.members(terms, coefficients, &support[..occurring], degree),
                            inverse_units,
                        }
                    },
                };
                row += 1;
            }
        }
        let highest = equations[..row]
            .iter()
            .enumerate()
            .filter(|(_, equation)| usize::from(equation.degree) <= FACTORS)
            .max_by_key(|(_, equation)| equation.degree);
        let mut drawn = DrawnForms {
            row: M,
            forms: [([Complex::ZERO; M], Complex::ZERO); FACTORS],
        };
        if let Some((row, equation)) = highest.filter(|(_, equation)| equation.degree > 2) {
            drawn.row = row;
            for (factor, (along, constant)) in (0..equation.degree).zip(&mut drawn.forms) {
                *constant = equation.start.constant(factor);
                for (index, entry) in along[..equation.occurring].iter_mut().enumerate() {
                    *entry = equation.start.coefficient(factor, index);
                }
            }
        }
        Self {
            system,
            coefficients,
            coordinates,
            equations,
            number: random.next(),
            drawn,
            known,
        }
    }

    /// The number of coordinates that move.
    #[inline]
    pub(super) fn free(&self) -> usize {
        self.coordinates.free
    }

    /// The number of known solutions, or of ways to choose one factor of each equation.
    pub(super) fn choices(&self) -> usize {
        if let Some(known) = &self.known {
            return known.points.len();
        }
        self.equations[..self.free()].iter().fold(1, |choices, equation| {
            choices.saturating_mul(usize::from(equation.degree))
        })
    }

    /// The known solution with a number. Without a known system, it is the one at which one chosen factor of each
    /// equation is zero, if it exists and is finite.
    pub(super) fn start(&mut self, choice: usize, at: &mut Linearised<M>) -> Option<[Complex; M]> {
        let free = self.free();
        if let Some(known) = &self.known {
            return Some(self.coordinates.of(known.points.get(choice)?));
        }
        let mut rest = choice;
        for (row, equation) in self.equations[..free].iter().enumerate() {
            let degree = usize::from(equation.degree);
            let factor = u8::try_from(rest % degree).unwrap_or(0);
            rest /= degree;
            let mut slopes = Slopes::ZERO;
            slopes.infinity = equation.start.constant(factor);
            for (index, &variable) in equation.support[..equation.occurring].iter().enumerate() {
                slopes.along[variable] = equation.start.coefficient(factor, index);
            }
            at.value[row] = -self.coordinates.restrict(
                &equation.support[..equation.occurring],
                &slopes.along,
                slopes.infinity,
                &mut at.factors.rows[row],
            );
        }
        if !at.factors.factorise(free) {
            return None;
        }
        let mut point = at.value;
        at.factors.solve(free, &mut point);
        // The size of the inverse, which is the factor by which rounding of the forms is magnified.
        let mut sums = [0.0; M];
        for row in 0..free {
            let mut column = [Complex::ZERO; M];
            column[row] = Complex::ONE;
            at.factors.solve(free, &mut column);
            for (sum, entry) in sums.iter_mut().zip(&column[..free]) {
                *sum += entry.norm();
            }
        }
        let condition = sums[..free].iter().fold(1.0, |most: f64, &sum| most.max(sum));
        let size = self.size(&point).max(1.0);
        let (_, infinity) = self.homogeneous(&point);
        // If the forms contradict each other, their solution is at infinity.
        let finite = infinity.norm() > 1e3 * f64::EPSILON * condition * size;
        finite.then_some(point)
    }

    /// Pins the largest coordinate if it is much larger than the pinned one, and returns whether it did.
    pub(super) fn pin_largest(&mut self, point: &mut [Complex; M]) -> bool {
        let free = self.free();
        let (mut index, mut most) = (free, 4.0);
        for (candidate, value) in point[..free].iter().enumerate() {
            if value.norm_squared() > most {
                (index, most) = (candidate, value.norm_squared());
            }
        }
        if index == free {
            return false;
        }
        let inverse = point[index].inverse();
        for value in &mut point[..free] {
            *value = *value * inverse;
        }
        point[index] = inverse;
        self.coordinates.exchange(index);
        true
    }

    /// The coordinates X₁ ... and X₀ of a point.
    #[inline]
    pub(super) fn homogeneous(&self, point: &[Complex; M]) -> ([Complex; M], Complex) {
        let free = self.free();
        let sum = |shares: &[f64; M], pinned: f64| {
            shares[..free]
                .iter()
                .zip(&point[..free])
                .fold(Complex::real(pinned), |sum, (share, value)| sum + value.scale(*share))
        };
        let coordinates = &self.coordinates;
        let mut x = [Complex::ZERO; M];
        for (variable, x) in x[..self.system.variables()].iter_mut().enumerate() {
            *x = sum(&coordinates.basis[variable], coordinates.pinned[variable]);
        }
        (x, sum(&coordinates.infinity, coordinates.infinity_pinned))
    }

    /// Two numbers that do not depend on the choice of pinned coordinate, and differ from point to point.
    pub(super) fn marks(&self, point: &[Complex; M]) -> [Complex; 2] {
        let (x, infinity) = self.homogeneous(point);
        let [below, first, second] = [0, 1, 2].map(|form| {
            x.iter().zip(&self.coordinates.inverse_units).enumerate().fold(
                sequence::entry(self.number, form, self.system.variables()) * infinity,
                |sum, (variable, (x, inverse_unit))| {
                    sum + sequence::entry(self.number, form, variable) * x.scale(*inverse_unit)
                },
            )
        });
        let inverse = below.inverse();
        [first * inverse, second * inverse]
    }

    /// Evaluates H, its rate and its Jacobian.
    pub(super) fn evaluate(&self, point: &[Complex; M], t: Complex, at: &mut Linearised<M>) {
        let (x, infinity) = self.homogeneous(point);
        let rest = Complex::ONE - t;
        for (row, equation) in self.equations[..self.free()].iter().enumerate() {
            let mut slopes = Slopes::ZERO;
            let support = &equation.support[..equation.occurring];
            let times = t * equation.gamma;
            let [target, start] = if let Some(known) = &self.known {
                self.add_quadrics(known, equation, &x, [rest, times], &mut slopes)
            } else {
                self.add_target(equation, &x, infinity, &mut slopes);
                let target = slopes.value;
                slopes.value = rest * target;
                slopes.infinity = rest * slopes.infinity;
                for &variable in support {
                    slopes.along[variable] = rest * slopes.along[variable];
                }
                let start = if row == self.drawn.row {
                    let forms = &self.drawn.forms[..usize::from(equation.degree)];
                    equation.add_drawn(forms, &x, infinity, times, &mut slopes)
                } else {
                    equation.add_start(&x, infinity, times, &mut slopes)
                };
                [target, start]
            };
            at.value[row] = slopes.value;
            at.rate[row] = equation.gamma * start - target;
            self.coordinates
                .restrict(support, &slopes.along, slopes.infinity, &mut at.factors.rows[row]);
        }
    }

    /// Adds F and G of one equation, each times a factor, and their slopes. Returns F and G.
    #[inline]
    fn add_quadrics(
        &self,
        known: &KnownSystem<'_, M>,
        equation: &NonlinearEquation<M>,
        x: &[Complex; M],
        [rest, times]: [Complex; 2],
        slopes: &mut Slopes<M>,
    ) -> [Complex; 2] {
        let [first, end] = equation.terms;
        let [mut target, mut start] = [Complex::ZERO; 2];
        for term in &self.system.terms()[first..end] {
            let (Some(&(one, _)), Some(&(other, _))) = (term.powers.first(), term.powers.last()) else {
                continue;
            };
            let [one, other, index] = [one, other, term.coefficient].map(usize::from);
            let (coefficient_here, of_known) = (self.coefficients[index] * equation.scale, known.coefficients[index]);
            let product = x[one] * x[other];
            target += product.scale(coefficient_here);
            start += product * of_known;
            let coefficient = rest.scale(coefficient_here) + times * of_known;
            slopes.along[one] += coefficient * x[other];
            slopes.along[other] += coefficient * x[one];
        }
        slopes.value += rest * target + times * start;
        [target, start]
    }

    /// Adds F of one equation, and its slopes.
    #[inline]
    fn add_target(&self, equation: &NonlinearEquation<M>, x: &[Complex; M], infinity: Complex, slopes: &mut Slopes<M>) {
        let [first, end] = equation.terms;
        for term in &self.system.terms()[first..end] {
            let coefficient = self.coefficients[usize::from(term.coefficient)] * equation.scale;
            if coefficient == 0.0 {
                continue;
            }
            let degree = term.powers.iter().fold(0, |sum, &(_, power)| sum + power);
            let missing = equation.degree - degree;
            let product = if term.powers.len() <= FACTORS {
                slopes.add_term(term.powers, coefficient, x, infinity.power(missing))
            } else {
                slopes.add_long_term(term.powers, coefficient, x, infinity.power(missing))
            };
            if missing > 0 {
                let slope = product * infinity.power(missing - 1);
                slopes.infinity += slope.scale(f64::from(missing));
                slopes.value += slope * infinity;
            } else {
                slopes.value += product;
            }
        }
    }

    /// The sums of the moduli of the terms of each equation at t = 0. Rounding errors are proportional to them.
    pub(super) fn magnitudes(&self, point: &[Complex; M]) -> [f64; M] {
        let free = self.free();
        // A sum that makes up a variable is rounded relative to its largest share, not to itself.
        let sum = |shares: &[f64; M], pinned: f64| {
            shares[..free]
                .iter()
                .zip(point)
                .fold(pinned.abs(), |sum, (share, value)| sum + share.abs() * value.norm())
        };
        let coordinates = &self.coordinates;
        let infinity = sum(&coordinates.infinity, coordinates.infinity_pinned);
        let mut magnitudes = [0.0; M];
        for (magnitude, equation) in magnitudes.iter_mut().zip(&self.equations[..free]) {
            let [first, end] = equation.terms;
            for term in &self.system.terms()[first..end] {
                let coefficient = self.coefficients[usize::from(term.coefficient)] * equation.scale;
                if coefficient == 0.0 {
                    continue;
                }
                let degree = term.powers.iter().fold(0, |sum, &(_, power)| sum + power);
                let missing = i32::from(equation.degree - degree);
                *magnitude += term.powers.iter().fold(
                    coefficient.abs() * Float::powi(infinity, missing),
                    |size, &(variable, power)| {
                        let variable = usize::from(variable);
                        let x = sum(&coordinates.basis[variable], coordinates.pinned[variable]);
                        size * Float::powi(x, i32::from(power))
                    },
                );
            }
        }
        magnitudes
    }

    /// The largest modulus of the free coordinates.
    #[inline]
    pub(super) fn size(&self, step: &[Complex; M]) -> f64 {
        largest(&step[..self.free()])
    }
}
