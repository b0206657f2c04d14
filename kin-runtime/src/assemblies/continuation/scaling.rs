//! Units for variables and equations that give all terms the size one.

use num_traits::Float;

use super::system::BorrowedSystem;

/// The number of bits by which a term must be smaller than the largest term of its equation to count as rounding.
const NEGLIGIBLE: f64 = 44.0;

/// The weight by which, of all equally good scales, those closest to one are preferred.
const PREFERENCE: f64 = 1e-6;

/// Scales, which are powers of two: the units of the variables, and the factors of the equations.
#[derive(Clone, Debug)]
pub(super) struct Scales<const M: usize> {
    pub(super) variables: [f64; M],
    pub(super) equations: [f64; M],
}

/// The scales with the smallest sum of squared logarithms of all coefficients (A. P. Morgan, *Solving Polynomial
/// Systems Using Continuation for Engineering and Scientific Problems*, 1987, chapter 5). They are powers of two, so
/// scaling does not round.
pub(super) fn scales<const M: usize>(system: &BorrowedSystem<'_, M>, coefficients: &[f64]) -> Scales<M> {
    let every = fit(system, coefficients, &[0.0; M], &[f64::NEG_INFINITY; M]);
    // Only now that lengths of all units can be compared is it clear which terms are rounding.
    let most = largest_terms(system, coefficients, &every);
    let variables = fit(system, coefficients, &every, &most).map(Float::round);
    let equations = largest_terms(system, coefficients, &variables).map(|most| -Float::round(most));
    Scales {
        variables: variables.map(power_of_two),
        equations: equations.map(power_of_two),
    }
}

/// The power of two, limited to a range in which squares and cubes do not overflow.
fn power_of_two(exponent: f64) -> f64 {
    Float::exp2(exponent.clamp(-250.0, 250.0))
}

/// The binary logarithm of a term in which all variables equal their scale.
fn size<const M: usize>(powers: &[(u16, u8)], coefficient: f64, variables: &[f64; M]) -> f64 {
    powers
        .iter()
        .fold(Float::log2(Float::abs(coefficient)), |sum, &(variable, power)| {
            sum + f64::from(power) * variables[usize::from(variable)]
        })
}

fn largest_terms<const M: usize>(
    system: &BorrowedSystem<'_, M>,
    coefficients: &[f64],
    variables: &[f64; M],
) -> [f64; M] {
    let mut most = [f64::NEG_INFINITY; M];
    for term in system.terms() {
        let most = &mut most[usize::from(term.equation)];
        *most = most.max(size(
            term.powers,
            coefficients[usize::from(term.coefficient)],
            variables,
        ));
    }
    most
}

/// The logarithms of the units of the variables. Terms that are negligible compared with `most`, in the units
/// `compared`, are left out.
fn fit<const M: usize>(
    system: &BorrowedSystem<'_, M>,
    coefficients: &[f64],
    compared: &[f64; M],
    most: &[f64; M],
) -> [f64; M] {
    // These are the normal equations. Eliminating the scale of each equation has subtracted the mean.
    let mut matrix = [[0.0; M]; M];
    let mut right = [0.0; M];
    let mut terms = system.terms().iter().peekable();
    while let Some(&first) = terms.peek() {
        let (mut count, mut sum, mut powers_sum) = (0.0, 0.0, [0.0; M]);
        while let Some(term) = terms.next_if(|term| term.equation == first.equation) {
            let coefficient = coefficients[usize::from(term.coefficient)];
            let bits = size(&[], coefficient, compared);
            let small = size(term.powers, coefficient, compared) < most[usize::from(term.equation)] - NEGLIGIBLE;
            if coefficient == 0.0 || small {
                continue;
            }
            count += 1.0;
            sum += bits;
            for &(variable, power) in term.powers {
                let (row, power) = (usize::from(variable), f64::from(power));
                powers_sum[row] += power;
                right[row] -= power * bits;
                for &(variable, other) in term.powers {
                    matrix[row][usize::from(variable)] += power * f64::from(other);
                }
            }
        }
        if count > 0.0 {
            for row in 0..M {
                let mean = powers_sum[row] / count;
                right[row] += mean * sum;
                for (entry, other) in matrix[row].iter_mut().zip(&powers_sum) {
                    *entry -= mean * other;
                }
            }
        }
    }
    for (row, entries) in matrix.iter_mut().enumerate() {
        entries[row] += PREFERENCE;
    }
    // The matrix is positive definite, so elimination needs no row exchanges.
    for column in 0..M {
        let pivot = matrix[column];
        for row in column + 1..M {
            let factor = matrix[row][column] / pivot[column];
            for (entry, from) in matrix[row].iter_mut().zip(&pivot) {
                *entry -= factor * from;
            }
            right[row] -= factor * right[column];
        }
    }
    for row in (0..M).rev() {
        let known = (row + 1..M).fold(0.0, |sum, other| sum + matrix[row][other] * right[other]);
        right[row] = (right[row] - known) / matrix[row][row];
    }
    right
}

#[cfg(test)]
mod tests {
    use super::super::system::{PolynomialSystem, Term};
    use super::scales;

    const CIRCLES: PolynomialSystem<2> = PolynomialSystem::new(&[
        Term::new(0, 0, &[(0, 2)]),
        Term::new(0, 0, &[(1, 2)]),
        Term::new(0, 1, &[]),
        Term::new(1, 2, &[(0, 1)]),
        Term::new(1, 3, &[(1, 1)]),
        Term::new(1, 4, &[]),
    ]);

    #[test]
    fn lengths_get_their_own_unit() {
        for unit in [1e-6, 1.0, 1e6] {
            let scales = scales(&CIRCLES, &[1.0, -9.0 * unit * unit, 1.0, 1.0, -4.0 * unit]);
            for variable in scales.variables {
                assert!((0.5..8.0).contains(&(variable / unit)), "{variable} for {unit}");
            }
            let constant = 9.0 * unit * unit * scales.equations[0];
            assert!((1e-2..2.0).contains(&constant), "{constant} for {unit}");
        }
    }

    #[test]
    fn rounding_has_no_say() {
        let clean = scales(&CIRCLES, &[1.0, -9.0, 1.0, 0.0, -2.0]);
        let noisy = scales(&CIRCLES, &[1.0, -9.0, 1.0, 1e-17, -2.0]);
        assert_eq!(clean.variables, noisy.variables);
        assert_eq!(clean.equations, noisy.equations);
    }
}
