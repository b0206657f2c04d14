//! The triangular factors of a small square matrix.

use crate::failure::Failure;
use crate::number::Row;
use crate::solve::Scalar;
use crate::solve::check::doubt::{decisive, size};
use crate::solve::check::{Check, Measure, Real};

const QUANTITY: &str = "Jacobian of a block without closed form";

/// The largest multiplier. One pose has multipliers of at most 1, because each pivot is the largest entry of its
/// column. A number that holds several poses takes the pivots of one of them; the others follow as long as this costs
/// them little more than a digit.
const LARGEST_MULTIPLIER: f64 = 16.0;

/// The triangular factors of a matrix, ready for any number of right-hand sides.
///
/// Rows and columns are scaled by powers of two, which is exact, until the largest entry of each lies between 1 and 2.
/// Then rows are exchanged so that each pivot is the largest of its column. The result therefore does not depend on the
/// units of equations and unknowns. This is Gaussian elimination with partial pivoting (N. J. Higham, *Accuracy and
/// Stability of Numerical Algorithms*, 2nd edition, SIAM 2002, chapters 7 and 9).
///
/// We do not use a library for linear algebra, because entries may be any [`Scalar`]: the derivatives of dual numbers
/// and series pass through, while real parts choose the pivots. nalgebra factorises only matrices over real and complex
/// fields, and it would be a heavy dependency for a default build.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Factors<T, const N: usize> {
    /// The entries row by row: multipliers below the diagonal, pivots on the diagonal, the remaining entries to the
    /// right.
    entries: [[T; N]; N],
    /// The row of the matrix from which each row came.
    origins: [usize; N],
    /// The powers of two by which the rows of the matrix were multiplied.
    row_exponents: [i32; N],
    /// The powers of two by which the columns were multiplied.
    column_exponents: [i32; N],
    /// Whether an odd number of pairs of rows was exchanged.
    odd: bool,
    /// The largest sum of magnitudes along a row of the scaled matrix.
    norm: f64,
}

/// Factorises a matrix, given row by row, into triangular factors.
///
/// The cost is about N³/3 multiplications and as many additions.
///
/// # Errors
/// [`Failure::Singular`] if a pivot of the scaled matrix is at most 2 N ε times its largest entry, where ε is the
/// distance from 1 to the next number: rounding of the entries alone can make such a pivot zero. [`Failure::NotFinite`]
/// if an entry is not finite.
///
/// ```
/// use kin_core::solve;
///
/// let factors = solve::factor([[0.0, 2.0], [0.5, 1.5]])?;
/// assert_eq!(factors.solve([4.0, 2.5]), [-1.0, 2.0]);
/// assert_eq!(factors.determinant(), -1.0);
///
/// // 0.1 * 0.6 and 0.2 * 0.3 differ by rounding alone
/// assert!(solve::factor([[0.1, 0.2], [0.3, 0.6]]).is_err());
/// # Ok::<(), kin_core::Failure>(())
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn factor<T: Scalar, const N: usize>(matrix: [[T; N]; N]) -> Result<Factors<T, N>, Failure> {
    T::factored(matrix)
}

/// [`factor`] for entries known to a relative error of `epsilon`. Their type may be more precise than that.
pub(super) fn factor_to<T: Scalar, const N: usize>(
    entries: [[T; N]; N],
    epsilon: f64,
) -> Result<Factors<T, N>, Failure> {
    factor_here(entries, epsilon)
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn factor_here<T: Scalar, const N: usize>(
    mut entries: [[T; N]; N],
    epsilon: f64,
) -> Result<Factors<T, N>, Failure> {
    if !entries.iter().flatten().all(|entry| entry.is_finite()) {
        return Err(Failure::not_finite(QUANTITY));
    }
    let (mut row_exponents, mut column_exponents, mut origins) = ([0; N], [0; N], [0; N]);
    level(&mut entries, &mut row_exponents, &mut column_exponents);
    let norm = row_norm(&entries);
    let Elimination { odd, singular } = eliminate(&mut entries, &mut origins, epsilon);
    let factors = Factors {
        entries,
        origins,
        row_exponents,
        column_exponents,
        odd,
        norm,
    };
    if singular {
        let determinant = factors.determinant().leading();
        return Err(if determinant.is_finite() {
            Failure::Singular { determinant }
        } else {
            Failure::not_finite(QUANTITY)
        });
    }
    Ok(factors)
}

/// Multiplies rows and then columns by powers of two until the largest entry of each lies between 1 and 2.
///
/// This function and those below take `rows.len()` leading columns of each row: the matrix is square.
#[cfg_attr(not(debug_assertions), inline(always))]
fn level<T: Scalar, R: Row<T>>(rows: &mut [R], row_exponents: &mut [i32], column_exponents: &mut [i32]) {
    let count = rows.len();
    for (row, exponent) in rows.iter_mut().zip(row_exponents) {
        let entries = &mut row.as_mut()[..count];
        *exponent = levelling::<T>(entries.iter());
        for entry in entries {
            *entry = *entry * power_of_two(*exponent);
        }
    }
    for (column, exponent) in column_exponents.iter_mut().enumerate().take(count) {
        *exponent = levelling::<T>(rows.iter().map(|row| &row[column]));
        for row in &mut *rows {
            let entry = &mut row[column];
            *entry = *entry * power_of_two(*exponent);
        }
    }
}

/// The properties of a matrix that its elimination shows.
struct Elimination {
    /// Whether an odd number of pairs of rows was exchanged.
    odd: bool,
    /// Whether a pivot is zero up to rounding.
    singular: bool,
}

/// Transforms a levelled matrix into its triangular factors, and records the row from which each row came. The
/// elimination stops at a pivot that is exactly zero.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminate<T: Scalar, R: Row<T>>(rows: &mut [R], origins: &mut [usize], epsilon: f64) -> Elimination {
    let count = rows.len();
    for (row, origin) in origins.iter_mut().enumerate() {
        *origin = row;
    }
    let mut largest = largest_of(rows.iter().flat_map(|row| &row.as_ref()[..count]));
    // The entries of one pose are levelled. The entries of other poses are levelled only if their dimensions are
    // similar.
    let mut levels = T::constant(0.0);
    if T::DOUBT > 0.0 {
        for entry in rows.iter().flat_map(|row| &row.as_ref()[..count]) {
            levels = T::measured(LargestSize {
                size: levels,
                number: *entry,
            });
        }
    }
    let (mut odd, mut singular) = (false, false);
    for step in 0..count {
        let best = T::pivot(rows, step);
        if best != step {
            rows.swap(best, step);
            origins.swap(best, step);
            odd = !odd;
        }
        let pivot = decisive(rows[step][step], || [levels]);
        rows[step][step] = pivot;
        let pivot_row = rows[step];
        let pivot_row = &pivot_row.as_ref()[..count];
        let size = pivot.leading().abs();
        singular |= size.is_nan() || size <= 2.0 * number(count) * epsilon * largest;
        if size == 0.0 {
            break;
        }
        for row in &mut rows[step + 1..] {
            let entries = &mut row.as_mut()[step..count];
            let multiplier = entries[0] / pivot;
            let multiplier = multiplier.provided(Multiplier(multiplier)).unwrap_or(multiplier);
            entries[0] = multiplier;
            for (entry, above) in entries[1..].iter_mut().zip(&pivot_row[step + 1..]) {
                *entry = *entry - multiplier * *above;
            }
            largest = largest.max(largest_of(entries[1..].iter()));
        }
    }
    Elimination { odd, singular }
}

/// The solution for a right-hand side given in the order of the original rows.
#[cfg_attr(not(debug_assertions), inline(always))]
fn substitute<T: Scalar, R: Row<T>>(
    rows: &[R],
    origins: &[usize],
    row_exponents: &[i32],
    column_exponents: &[i32],
    right: &[T],
    solution: &mut [T],
) {
    let count = rows.len();
    for (row, entries) in rows.iter().enumerate() {
        let origin = origins[row];
        let mut sum = right[origin] * power_of_two(row_exponents[origin]);
        for (factor, known) in entries.as_ref()[..row].iter().zip(&*solution) {
            sum = sum - *factor * *known;
        }
        solution[row] = sum;
    }
    for (row, entries) in rows.iter().enumerate().rev() {
        let entries = &entries.as_ref()[..count];
        let mut sum = solution[row];
        for (factor, known) in entries[row + 1..].iter().zip(&solution[row + 1..]) {
            sum = sum - *factor * *known;
        }
        solution[row] = sum / entries[row];
    }
    for (entry, exponent) in solution.iter_mut().zip(column_exponents).take(count) {
        *entry = *entry * power_of_two(*exponent);
    }
}

impl<T: Scalar, const N: usize> Factors<T, N> {
    /// The solution of `matrix · x = right`. It takes N² + N multiplications, 2 N of them by powers of two, N² - N
    /// additions and N divisions.
    ///
    /// The solution is not finite if `right` is not, or if it exceeds the range of the number type.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn solve(&self, right: [T; N]) -> [T; N] {
        T::substituted(self, right)
    }

    /// [`solve`](Self::solve) for a number that holds values.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn solve_here(&self, right: [T; N]) -> [T; N] {
        let mut solution = right;
        substitute(
            &self.entries,
            &self.origins,
            &self.row_exponents,
            &self.column_exponents,
            &right,
            &mut solution,
        );
        solution
    }

    /// Factors of a number without a value: every entry stands for the whole matrix.
    #[cfg(feature = "tape")]
    pub(crate) fn standing_for(system: T) -> Self {
        Self {
            entries: [[system; N]; N],
            origins: [0; N],
            row_exponents: [0; N],
            column_exponents: [0; N],
            odd: false,
            norm: 0.0,
        }
    }

    /// The number that stands for the whole matrix.
    #[cfg(feature = "tape")]
    pub(crate) fn stands_for(&self) -> T {
        self.entries[0][0]
    }

    /// The determinant of the matrix. It is infinite or zero if it exceeds the range of the number type.
    #[must_use]
    pub fn determinant(&self) -> T {
        let mut exponent = self.exponent();
        let mut product = self.pivots();
        // Multiply in steps that the type can represent, so that only a determinant out of range overflows.
        while exponent != 0 {
            let step = exponent.clamp(-range::<T>(), range::<T>());
            product = product * power_of_two(step);
            exponent -= step;
        }
        product
    }

    /// The condition number of the scaled matrix in the maximum norm: the factor by which a relative change of its
    /// entries is magnified in the solution. The best value is 1. From 1/ε on, no digit of the solution is right.
    ///
    /// It is computed from the inverse of the real parts, with N³ multiplications.
    #[must_use]
    pub fn condition(&self) -> f64 {
        let mut sums = [0.0; N];
        let real = Factors {
            entries: self.entries.map(|row| row.map(Scalar::leading)),
            row_exponents: [0; N],
            column_exponents: [0; N],
            origins: self.origins,
            odd: self.odd,
            norm: self.norm,
        };
        for column in 0..N {
            for (sum, entry) in sums.iter_mut().zip(real.solve(unit(column))) {
                *sum += entry.abs();
            }
        }
        self.norm * sums.into_iter().fold(0.0, f64::max)
    }

    /// The product of the pivots with the sign of the row exchanges, which is the determinant of the scaled matrix.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn pivots(&self) -> T {
        let sign = T::constant(if self.odd { -1.0 } else { 1.0 });
        (0..N).fold(sign, |product, step| product * self.entries[step][step])
    }

    /// The exponent of the power of two that turns that product into the determinant.
    fn exponent(&self) -> i32 {
        -(self.row_exponents.iter().sum::<i32>() + self.column_exponents.iter().sum::<i32>())
    }
}

impl<T: Scalar, const N: usize> Factors<T, N> {
    /// The determinant divided by that of another matrix, without overflow in between.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn determinant_relative_to(&self, other: &Self) -> T {
        let exponent = (self.exponent() - other.exponent()).clamp(-range::<T>(), range::<T>());
        self.pivots() / other.pivots() * power_of_two(exponent)
    }
}

impl<const N: usize> Factors<f64, N> {
    /// Skeel's condition number, the largest row sum of |matrix⁻¹| · |matrix|: the factor by which relative rounding
    /// errors in the terms of each equation are magnified in the solution, in the given units of the unknowns. The
    /// units of the equations do not matter. (R. D. Skeel, Scaling for numerical stability in Gaussian elimination,
    /// Journal of the ACM 26, 1979, 494-526.)
    pub(super) fn amplification(&self, matrix: &[[f64; N]; N]) -> f64 {
        let mut sums = [0.0; N];
        for (column, row) in matrix.iter().enumerate() {
            let size: f64 = row.iter().map(|entry| entry.abs()).sum();
            for (sum, entry) in sums.iter_mut().zip(self.solve(unit(column))) {
                *sum += entry.abs() * size;
            }
        }
        sums.into_iter().fold(0.0, f64::max)
    }
}

fn unit<const N: usize>(index: usize) -> [f64; N] {
    core::array::from_fn(|place| if place == index { 1.0 } else { 0.0 })
}

fn largest_of<'a, T: Scalar>(entries: impl Iterator<Item = &'a T>) -> f64 {
    entries.fold(0.0, |largest, entry| entry.leading().abs().max(largest))
}

fn row_norm<T: Scalar, const N: usize>(matrix: &[[T; N]; N]) -> f64 {
    matrix
        .iter()
        .map(|row| row.iter().map(|entry| entry.leading().abs()).sum())
        .fold(0.0, f64::max)
}

/// The exponent of the power of two that scales the largest entry to between 1 and 2.
fn levelling<'a, T: Scalar>(entries: impl Iterator<Item = &'a T>) -> i32 {
    let largest = largest_of(entries);
    if largest == 0.0 {
        return 0;
    }
    (-exponent_of(largest)).clamp(-range::<T>(), range::<T>())
}

/// The largest exponent for which both the power of two and its reciprocal have full precision in the type.
pub(crate) fn range<T: Scalar>() -> i32 {
    -exponent_of(T::SMALLEST) - 6
}

/// The exponent of the largest power of two that does not exceed a positive number.
pub(crate) fn exponent_of(value: f64) -> i32 {
    let field = (value.to_bits() >> 52) & 0x7ff;
    i32::try_from(field).map_or(0, |field| field - 1023)
}

/// The power of two with an exponent within the [range] of the type.
pub(super) fn power_of_two<T: Scalar>(exponent: i32) -> T {
    let field = u64::try_from(exponent + 1023).unwrap_or(0);
    T::constant(f64::from_bits(field << 52))
}

#[expect(clippy::cast_precision_loss, reason = "the number of unknowns of a block is small")]
const fn number(count: usize) -> f64 {
    count as f64
}

/// Whether the multiplier of a row is small, that is, whether the pivot is not much smaller than the entry below it.
#[derive(Clone, Copy)]
struct Multiplier<T>(T);

impl<T: Scalar> Check<T, 1, 1> for Multiplier<T> {
    fn name(&self) -> &'static str {
        "pivot"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.0]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [multiplier]: [R; 1]) -> [R::Truth; 1] {
        [multiplier.magnitude().is_at_most(R::of(LARGEST_MULTIPLIER))]
    }

    fn margin(&self) -> T {
        T::constant(LARGEST_MULTIPLIER) - size(self.0)
    }
}

/// The larger of a given size and the magnitude of a number.
#[derive(Clone, Copy)]
struct LargestSize<T> {
    size: T,
    number: T,
}

impl<T: Scalar> Measure<T, 2> for LargestSize<T> {
    fn name(&self) -> &'static str {
        "largest entry"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        [self.size, self.number]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measure<R: Real>(&self, [largest, number]: [R; 2]) -> R {
        let size = number.magnitude();
        R::choose(size.exceeds(largest), || size, || largest)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};
    use proptest::prelude::*;
    use proptest::test_runner::TestCaseResult;

    use super::factor;
    use crate::failure::Failure;
    use crate::number::{Number, series::Series};
    use crate::solve::strategies::coordinate;

    fn matrix<const N: usize>() -> impl Strategy<Value = [[f64; N]; N]> {
        proptest::collection::vec(coordinate(), N * N)
            .prop_map(|entries| core::array::from_fn(|row| core::array::from_fn(|column| entries[row * N + column])))
    }

    fn vector<const N: usize>() -> impl Strategy<Value = [f64; N]> {
        proptest::collection::vec(-1.0..1.0_f64, N).prop_map(|entries| core::array::from_fn(|row| entries[row]))
    }

    /// Compares a known solution with ours and with that of nalgebra's factors.
    fn agrees<const N: usize>(a: [[f64; N]; N], x: [f64; N]) -> TestCaseResult
    where
        nalgebra::Const<N>: nalgebra::DimMin<nalgebra::Const<N>, Output = nalgebra::Const<N>>,
    {
        let theirs = SMatrix::<f64, N, N>::from_fn(|row, column| a[row][column]);
        let right = theirs * SVector::<f64, N>::from(x);
        let Ok(factors) = factor(a) else {
            // If we refuse the matrix, the triangular factors of the matrix with level rows must have a small pivot
            // too.
            let rows = SMatrix::<f64, N, N>::from_fn(|row, column| {
                a[row][column] / a[row].iter().fold(0.0, |size: f64, entry| entry.abs().max(size))
            });
            let columns = SMatrix::<f64, N, N>::from_fn(|row, column| rows[(row, column)] / rows.column(column).amax());
            let upper = columns.lu().u();
            let (smallest, largest) = (upper.diagonal().abs().min(), upper.amax());
            prop_assert!(smallest <= 16.0 * f64::EPSILON * super::number(N) * largest);
            return Ok(());
        };
        let solution = factors.solve(right.into());
        // The backward error: the residual is rounding of the terms, whatever the condition.
        let residual = right - theirs * SVector::<f64, N>::from(solution);
        for row in 0..N {
            let terms: f64 = (0..N).map(|column| (a[row][column] * solution[column]).abs()).sum();
            let growth: f64 = (0..N)
                .map(|other| {
                    // Rows with different units do not mix, so compare after scaling the rows.
                    let scale = |row: usize| a[row].iter().fold(0.0, |size: f64, entry| entry.abs().max(size));
                    let terms: f64 = (0..N).map(|column| (a[other][column] * solution[column]).abs()).sum();
                    terms / scale(other) * scale(row)
                })
                .sum();
            let tolerance = 16.0 * f64::EPSILON * super::number(N) * (terms + growth);
            prop_assert!(residual[row].abs() <= tolerance, "{} > {tolerance}", residual[row]);
        }
        let condition = factors.condition();
        prop_assert!(condition >= 1.0);
        // In the scaled unknowns, the two solutions differ by ε times the condition.
        let scaled = |entry: f64, column: usize| entry * 2.0_f64.powi(-factors.column_exponents[column]);
        let size = (0..N).map(|column| scaled(x[column], column).abs()).fold(0.0, f64::max);
        let tolerance = 16.0 * f64::EPSILON * super::number(N * N) * condition * size;
        for column in 0..N {
            let error = scaled(solution[column] - x[column], column).abs();
            prop_assert!(error <= tolerance, "{error} > {tolerance}");
        }
        // nalgebra does not scale, so compare its determinant on the scaled matrix.
        let levelled = SMatrix::<f64, N, N>::from_fn(|row, column| {
            a[row][column] * 2.0_f64.powi(factors.row_exponents[row] + factors.column_exponents[column])
        });
        let lu = levelled.lu();
        let error = (factors.pivots() - lu.determinant()).abs();
        prop_assert!(error <= 16.0 * f64::EPSILON * super::number(N * N) * condition * lu.determinant().abs());
        let inverse = lu.try_inverse().expect("it is regular");
        let norm = |matrix: SMatrix<f64, N, N>| matrix.row_iter().map(|row| row.abs().sum()).fold(0.0, f64::max);
        let expected = norm(levelled) * norm(inverse);
        prop_assert!((condition / expected - 1.0).abs() <= 16.0 * f64::EPSILON * super::number(N * N) * condition);
        Ok(())
    }

    proptest! {
        #[test]
        fn two_agree(a in matrix::<2>(), x in vector()) { agrees(a, x)?; }

        #[test]
        fn three_agree(a in matrix::<3>(), x in vector()) { agrees(a, x)?; }

        #[test]
        fn six_agree(a in matrix::<6>(), x in vector()) { agrees(a, x)?; }

        #[test]
        fn a_row_that_is_a_sum_of_others_is_singular(a in matrix::<3>(), weights in vector::<2>()) {
            let mut a = a;
            a[2] = core::array::from_fn(|column| weights[0] * a[0][column] + weights[1] * a[1][column]);
            match factor(a) {
                Err(failure) => {
                    let is_singular = matches!(failure, Failure::Singular { .. });
                    prop_assert!(is_singular, "{}", failure);
                }
                // Where the sum cancels, its rounding error is large compared with the rest.
                Ok(factors) => prop_assert!(factors.condition() >= 1e10),
            }
        }
    }

    #[test]
    fn units_do_not_matter() {
        let plain = [[1.0, 2.0, 3.0], [4.0, 5.0, 7.0], [1.0, -1.0, 1.0]];
        let expected = factor(plain).unwrap();
        for exponent in [-900, -300, -20, 20, 300, 900] {
            let unit = 2.0_f64.powi(exponent);
            let mut rows = plain;
            rows[1] = rows[1].map(|entry| entry * unit);
            let factors = factor(rows).unwrap();
            assert_eq!(factors.condition(), expected.condition());
            assert_eq!(factors.solve([6.0, 16.0 * unit, 1.0]), expected.solve([6.0, 16.0, 1.0]));
            assert_eq!(factors.determinant(), expected.determinant() * unit);
            let columns = plain.map(|row| [row[0], row[1], row[2] * unit]);
            assert_eq!(factor(columns).unwrap().condition(), expected.condition());
        }
        // The determinant is within the range of numbers, but the product of two pivots is not.
        let extreme = factor([[1e300_f64, 0.0, 0.0], [0.0, 1e300, 0.0], [0.0, 0.0, 1e-300]]).unwrap();
        assert!((extreme.determinant() / 1e300 - 1.0).abs() < 1e-15);
        let single = factor([[1e-38_f32, 0.0], [0.0, 1e38]]).unwrap();
        assert!((single.determinant() - 1.0).abs() <= 2.0 * f32::EPSILON);
        assert!((1.0..2.0).contains(&single.condition()));
    }

    #[test]
    fn derivatives_go_through() {
        // [[1 + t, t], [t, 2]] x = [1, t], by Cramer's rule.
        type Third = Series<3>;
        let t = Third::from_coefficients([0.0, 1.0, 0.0]);
        let one = Third::constant(1.0);
        let two = Third::constant(2.0);
        let factors = factor([[one + t, t], [t, two]]).unwrap();
        let determinant = (one + t) * two - t * t;
        let expected = [(two - t * t) / determinant, ((one + t) * t - t) / determinant];
        for (actual, expected) in factors.solve([one, t]).into_iter().zip(expected) {
            for (actual, expected) in actual.coefficients().into_iter().zip(expected.coefficients()) {
                assert!((actual - expected).abs() <= 4.0 * f64::EPSILON);
            }
        }
        assert_eq!(factors.determinant(), determinant);
    }

    #[test]
    fn singular_matrices_are_refused() {
        assert_eq!(factor([[0.0]]), Err(Failure::Singular { determinant: 0.0 }));
        assert_eq!(
            factor([[1.0, 2.0], [2.0, 4.0]]),
            Err(Failure::Singular { determinant: 0.0 })
        );
        assert!(
            matches!(factor([[0.1, 0.2], [0.3, 0.6]]), Err(Failure::Singular { determinant }) if determinant.abs() < 1e-16)
        );
        assert!(factor([[1.0, 0.0], [0.0, 1e-30]]).is_ok());
        assert!(factor([[1.0_f32, 1.0], [1.0, 1.0 + f32::EPSILON]]).is_err());
        assert!(factor([[1.0_f64, 1.0], [1.0, 1.0 + f64::from(f32::EPSILON)]]).is_ok());
    }

    /// A pivot of two rows must exceed 4 ε times the largest entry; with entries of 7/4 that is 7 ε.
    #[test]
    fn rounding_of_the_largest_entry_is_what_a_pivot_must_exceed() {
        let with_pivot = |units: f64| factor([[1.75, 1.75], [1.75, 1.75 + units * f64::EPSILON]]);
        for units in [1.0, 4.0, 7.0, -6.0] {
            assert!(
                matches!(with_pivot(units), Err(Failure::Singular { .. })),
                "{units} units of rounding"
            );
        }
        for units in [9.0, -9.0, 100.0] {
            assert!(with_pivot(units).is_ok(), "{units} units of rounding");
        }
    }

    #[test]
    fn what_is_not_finite_is_refused() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for place in 0..4 {
                let mut entries = [2.0, 1.0, 1.0, 3.0];
                entries[place] = value;
                let [a, b, c, d] = entries;
                assert!(matches!(factor([[a, b], [c, d]]), Err(Failure::NotFinite { .. })));
            }
        }
        let broken = Series::from_coefficients([1.0, f64::NAN]);
        assert!(matches!(factor([[broken]]), Err(Failure::NotFinite { .. })));
    }
}
