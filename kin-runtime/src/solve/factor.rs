//! The triangular factors of a small square matrix.

use crate::failure::Failure;
use crate::solve::Scalar;
use crate::solve::check::doubt::{decisive_in, size};
use crate::solve::check::{Check, Real, RowMeasure};

const QUANTITY: &str = "Jacobian of a block without closed form";

/// The largest multiplier. One pose has multipliers of at most 1, because each pivot is the largest entry of its
/// column. A number that holds several poses takes the pivots of one of them; the others follow as long as this costs
/// them little more than a digit.
const LARGEST_MULTIPLIER: f64 = 16.0;

/// The triangular factors of a matrix, ready for any number of right-hand sides.
///
/// Rows and columns are scaled by powers of two, which is exact, until the largest entry of each lies between 2 and 4.
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
    rows: [FactorRow; N],
    elimination: Elimination,
    /// For the condition.
    matrix: [[T; N]; N],
}

/// What was done with a row of a matrix, and with the column of the same number, to find its triangular factors.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FactorRow {
    /// The row of the matrix from which this row of the factors came.
    origin: usize,
    /// The power of two by which this row of the matrix was multiplied.
    row_scale: f64,
    /// The power of two by which this column was multiplied.
    column_scale: f64,
}

/// By which powers of two the rows and columns of a matrix are scaled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scaling {
    /// By those that bring the largest entry of each to between 2 and 4.
    New,
    /// By those of a matrix before, of which the entries differ little.
    Kept,
}

/// What an elimination leaves beside the factors.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Elimination {
    /// Whether an odd number of pairs of rows was exchanged.
    pub(crate) is_odd: bool,
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
    let (mut entries, mut rows) = (matrix, [FactorRow::default(); N]);
    let elimination = factor_in(entries.as_flattened_mut(), &mut rows)?;
    Ok(Factors {
        entries,
        rows,
        elimination,
        matrix,
    })
}

/// [`factor`] of a matrix of any size, given row by row in `entries`, which the factors replace. `rows` has as many
/// elements as the matrix has rows.
///
/// # Errors
/// As for [`factor`].
#[doc(hidden)]
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn factor_in<T: Scalar>(entries: &mut [T], rows: &mut [FactorRow]) -> Result<Elimination, Failure> {
    T::factored(entries, rows)
}

/// [`factor_in`] for a number that holds one pose, and for one that keeps its poses apart.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn checked_factors<T: Scalar>(entries: &mut [T], rows: &mut [FactorRow]) -> Result<Elimination, Failure> {
    if !T::are_finite(entries) {
        return Err(Failure::not_finite(QUANTITY));
    }
    factor_to(entries, rows, T::EPSILON, Scaling::New)
}

/// [`Factors::solve`] with factors that [`factor_in`] has found.
#[doc(hidden)]
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn substitute_in<T: Scalar>(entries: &[T], rows: &[FactorRow], right: &[T], solution: &mut [T]) {
    T::substituted(entries, rows, right, solution);
}

/// [`factor_in`] for entries that are finite and known to a relative error of `epsilon`. Their type may be more precise
/// than that.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn factor_to<T: Scalar>(
    entries: &mut [T],
    rows: &mut [FactorRow],
    epsilon: f64,
    scaling: Scaling,
) -> Result<Elimination, Failure> {
    match scaling {
        Scaling::New => level(entries, rows),
        Scaling::Kept => scale(entries, rows),
    }
    let (is_odd, is_singular) = eliminate(entries, rows, epsilon);
    if is_singular {
        let determinant = Determinant::of(entries, rows, is_odd).value().leading();
        return Err(if determinant.is_finite() {
            Failure::Singular { determinant }
        } else {
            Failure::not_finite(QUANTITY)
        });
    }
    Ok(Elimination { is_odd })
}

/// Multiplies rows and then columns by powers of two until the largest entry of each lies between 2 and 4.
#[cfg_attr(not(debug_assertions), inline(always))]
fn level<T: Scalar>(entries: &mut [T], rows: &mut [FactorRow]) {
    let count = rows.len();
    for (entries, row) in entries.chunks_exact_mut(count.max(1)).zip(&mut *rows) {
        row.row_scale = levelling::<T>(largest_of(entries.iter()));
        for entry in entries {
            *entry = *entry * T::constant(row.row_scale);
        }
    }
    for (column, row) in rows.iter_mut().enumerate() {
        let column = || (0..count).map(|row| row * count + column);
        row.column_scale = levelling::<T>(largest_of(column().map(|index| &entries[index])));
        for index in column() {
            entries[index] = entries[index] * T::constant(row.column_scale);
        }
    }
}

/// Multiplies rows and columns by the powers of two that are recorded.
#[cfg_attr(not(debug_assertions), inline(always))]
fn scale<T: Scalar>(entries: &mut [T], rows: &[FactorRow]) {
    for (entries, row) in entries.chunks_exact_mut(rows.len().max(1)).zip(rows) {
        for (entry, column) in entries.iter_mut().zip(rows) {
            *entry = *entry * T::constant(row.row_scale) * T::constant(column.column_scale);
        }
    }
}

/// Transforms a levelled matrix into its triangular factors, and records the row from which each row came. The
/// elimination stops at a pivot that is exactly zero.
///
/// It returns whether an odd number of pairs of rows was exchanged, and whether a pivot is zero up to rounding.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminate<T: Scalar>(entries: &mut [T], rows: &mut [FactorRow], epsilon: f64) -> (bool, bool) {
    let count = rows.len();
    for (number, row) in rows.iter_mut().enumerate() {
        row.origin = number;
    }
    let mut largest = largest_of(entries.iter());
    // The entries of one pose are levelled. The entries of other poses are levelled only if their dimensions are
    // similar.
    let mut levels = T::constant(0.0);
    if T::DOUBT > 0.0 {
        levels = T::measured_over(LargestSize, entries.len(), |index| entries[index]);
    }
    let (mut is_odd, mut is_singular) = (false, false);
    for step in 0..count {
        let best = T::pivot(entries, count, step);
        if best != step {
            for column in 0..count {
                entries.swap(best * count + column, step * count + column);
            }
            (rows[best].origin, rows[step].origin) = (rows[step].origin, rows[best].origin);
            is_odd = !is_odd;
        }
        let (above, below) = entries.split_at_mut((step + 1) * count);
        let pivot_row = &mut above[step * count..];
        let pivot = decisive_in(pivot_row[step], &[levels]);
        pivot_row[step] = pivot;
        let size = pivot.leading().abs();
        is_singular |= size.is_nan() || size <= 2.0 * number(count) * epsilon * largest;
        if size == 0.0 {
            break;
        }
        for row in below.chunks_exact_mut(count) {
            let multiplier = row[step] / pivot;
            let multiplier = multiplier.provided(Multiplier(multiplier)).unwrap_or(multiplier);
            row[step] = multiplier;
            let rest = &mut row[step + 1..];
            for (entry, above) in rest.iter_mut().zip(&pivot_row[step + 1..]) {
                *entry = *entry - multiplier * *above;
            }
            largest = larger(largest, largest_of(rest.iter()));
        }
    }
    (is_odd, is_singular)
}

/// The solution for a right-hand side given in the order of the original rows. `scale` makes a number of a power of
/// two, or is one for the solution of the scaled matrix.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn substitute<T: Scalar>(
    entries: &[T],
    rows: &[FactorRow],
    scale: impl Fn(f64) -> T,
    right: &[T],
    solution: &mut [T],
) {
    let count = rows.len();
    let each = || entries.chunks_exact(count.max(1)).enumerate();
    for (number, entries) in each() {
        let origin = rows[number].origin;
        let mut sum = right[origin] * scale(rows[origin].row_scale);
        for (factor, known) in entries[..number].iter().zip(&*solution) {
            sum = sum - *factor * *known;
        }
        solution[number] = sum;
    }
    for (number, entries) in each().rev() {
        let mut sum = solution[number];
        for (factor, known) in entries[number + 1..].iter().zip(&solution[number + 1..]) {
            sum = sum - *factor * *known;
        }
        solution[number] = sum / entries[number];
    }
    for (entry, row) in solution.iter_mut().zip(rows) {
        *entry = *entry * scale(row.column_scale);
    }
}

/// A determinant as a product of pivots and a power of two, neither of which overflows for a scaled matrix.
#[derive(Clone, Copy)]
pub(crate) struct Determinant<T> {
    /// The product of the pivots with the sign of the row exchanges, which is the determinant of the scaled matrix.
    pivots: T,
    exponent: i32,
}

impl<T: Scalar> Determinant<T> {
    /// The determinant of the matrix with these factors.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn of(entries: &[T], rows: &[FactorRow], is_odd: bool) -> Self {
        let (mut pivots, mut exponent) = (T::constant(if is_odd { -1.0 } else { 1.0 }), 0);
        for (number, row) in rows.iter().enumerate() {
            pivots = pivots * entries[number * rows.len() + number];
            exponent -= exponent_of(row.row_scale) + exponent_of(row.column_scale);
        }
        Self { pivots, exponent }
    }

    /// The determinant. It is infinite or zero if it exceeds the range of the number type.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn value(self) -> T {
        let Self { pivots, mut exponent } = self;
        let mut product = pivots;
        // Multiply in steps that the type can represent, so that only a determinant out of range overflows.
        while exponent != 0 {
            let step = exponent.clamp(-range::<T>(), range::<T>());
            product = product * power_of_two(step);
            exponent -= step;
        }
        product
    }

    /// The determinant divided by that of another matrix, without overflow in between.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn relative_to(self, other: Self) -> T {
        let exponent = (self.exponent - other.exponent).clamp(-range::<T>(), range::<T>());
        self.pivots / other.pivots * power_of_two(exponent)
    }
}

/// Three vectors of the length of a matrix, for [`condition`] and [`amplification`].
pub(super) type Scratch<'m> = [&'m mut [f64]; 3];

/// See [`Factors::condition`].
pub(super) fn condition(entries: &[f64], rows: &[FactorRow], matrix: &[f64], scratch: Scratch<'_>) -> f64 {
    scaled_norm(matrix, rows) * largest_row_sum(entries, rows, |_| 1.0, |_| 1.0, scratch)
}

/// Skeel's condition number, the largest row sum of |matrix⁻¹| · |matrix|: the factor by which relative rounding
/// errors in the terms of each equation are magnified in the solution, in the given units of the unknowns. The
/// units of the equations do not matter. (R. D. Skeel, Scaling for numerical stability in Gaussian elimination,
/// Journal of the ACM 26, 1979, 494-526.)
pub(super) fn amplification(entries: &[f64], rows: &[FactorRow], matrix: &[f64], scratch: Scratch<'_>) -> f64 {
    let count = rows.len();
    let size = |row: usize| matrix[row * count..][..count].iter().map(|entry| entry.abs()).sum();
    largest_row_sum(entries, rows, |scale| scale, size, scratch)
}

/// The largest sum of magnitudes along a row of the inverse, each times the weight of its column.
fn largest_row_sum(
    entries: &[f64],
    rows: &[FactorRow],
    scale: impl Fn(f64) -> f64,
    weight: impl Fn(usize) -> f64,
    [unit, solution, sums]: Scratch<'_>,
) -> f64 {
    sums.fill(0.0);
    for column in 0..rows.len() {
        unit.fill(0.0);
        unit[column] = 1.0;
        substitute(entries, rows, &scale, unit, solution);
        let weight = weight(column);
        for (sum, entry) in sums.iter_mut().zip(&*solution) {
            *sum += entry.abs() * weight;
        }
    }
    sums.iter().copied().fold(0.0, f64::max)
}

impl<T: Scalar, const N: usize> Factors<T, N> {
    /// The solution of `matrix · x = right`. It takes N² + N multiplications, 2 N of them by powers of two, N² - N
    /// additions and N divisions.
    ///
    /// The solution is not finite if `right` is not, or if it exceeds the range of the number type.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn solve(&self, right: [T; N]) -> [T; N] {
        let mut solution = right;
        substitute_in(self.entries.as_flattened(), &self.rows, &right, &mut solution);
        solution
    }

    /// The determinant of the matrix. It is infinite or zero if it exceeds the range of the number type.
    #[must_use]
    pub fn determinant(&self) -> T {
        Determinant::of(self.entries.as_flattened(), &self.rows, self.elimination.is_odd).value()
    }

    /// The condition number of the scaled matrix in the maximum norm: the factor by which a relative change of its
    /// entries is magnified in the solution. The best value is 1. From 1/ε on, no digit of the solution is right.
    ///
    /// It is computed from the inverse of the real parts, with N³ multiplications.
    #[must_use]
    pub fn condition(&self) -> f64 {
        let [entries, matrix] = [self.entries, self.matrix].map(|matrix| matrix.map(|row| row.map(Scalar::leading)));
        let scratch: Scratch<'_> = [&mut [0.0; N], &mut [0.0; N], &mut [0.0; N]];
        condition(entries.as_flattened(), &self.rows, matrix.as_flattened(), scratch)
    }
}

/// The larger of two numbers, the first if one of them is not a number. This is one instruction, unlike [`f64::max`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn larger<E: PartialOrd>(one: E, other: E) -> E {
    if other > one { other } else { one }
}

/// The largest magnitude of some numbers.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn largest_of<'a, T: Scalar>(entries: impl Iterator<Item = &'a T>) -> f64 {
    entries.fold(0.0, |largest, entry| larger(largest, entry.leading().abs()))
}

/// The largest sum of magnitudes along a row of a matrix, after its rows and columns have been scaled.
fn scaled_norm(matrix: &[f64], rows: &[FactorRow]) -> f64 {
    let count = rows.len();
    let sum = |row: usize| -> f64 {
        let scaled = (0..count)
            .map(|column| (matrix[row * count + column] * rows[row].row_scale * rows[column].column_scale).abs());
        scaled.sum()
    };
    (0..count).map(sum).fold(0.0, f64::max)
}

/// The power of two that scales a positive number to between 2 and 4, as far as both it and its reciprocal have full
/// precision in the type. It is any power of two for zero.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn levelling<T: Scalar>(largest: f64) -> f64 {
    let limits = [-range::<T>(), range::<T>()].map(power_of_two::<f64>);
    let largest = largest.clamp(limits[0], limits[1]);
    // the complement of an exponent's field is that of its negative, plus one
    f64::from_bits(!largest.to_bits() & f64::INFINITY.to_bits())
}

/// The largest exponent for which both the power of two and its reciprocal have full precision in the type.
pub(crate) fn range<T: Scalar>() -> i32 {
    -exponent_of(T::SMALLEST_DIVISOR) - 6
}

/// The exponent of the largest power of two that does not exceed a positive number.
#[cfg_attr(not(debug_assertions), inline(always))]
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

/// The largest magnitude of the numbers of each pose.
#[derive(Clone, Copy)]
struct LargestSize;

impl RowMeasure for LargestSize {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn start<R: Real>() -> R {
        R::of(0.0)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn with<R: Real>(largest: R, number: R) -> R {
        let size = number.magnitude();
        R::choose(size.exceeds(largest), || size, || largest)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};
    use proptest::prelude::*;
    use proptest::test_runner::TestCaseResult;

    use super::{Determinant, FactorRow, Scaling, factor, factor_in, factor_to, levelling, substitute_in};
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
        let scaled = |entry: f64, column: usize| entry / factors.rows[column].column_scale;
        let size = (0..N).map(|column| scaled(x[column], column).abs()).fold(0.0, f64::max);
        let tolerance = 16.0 * f64::EPSILON * super::number(N * N) * condition * size;
        for column in 0..N {
            let error = scaled(solution[column] - x[column], column).abs();
            prop_assert!(error <= tolerance, "{error} > {tolerance}");
        }
        // nalgebra does not scale, so compare its determinant on the scaled matrix.
        let levelled = SMatrix::<f64, N, N>::from_fn(|row, column| {
            a[row][column] * factors.rows[row].row_scale * factors.rows[column].column_scale
        });
        let lu = levelled.lu();
        let Determinant { pivots, .. } = Determinant::of(
            factors.entries.as_flattened(),
            &factors.rows,
            factors.elimination.is_odd,
        );
        let error = (pivots - lu.determinant()).abs();
        prop_assert!(error <= 16.0 * f64::EPSILON * super::number(N * N) * condition * lu.determinant().abs());
        let inverse = lu.try_inverse().expect("it is regular");
        let norm = |matrix: SMatrix<f64, N, N>| matrix.row_iter().map(|row| row.abs().sum()).fold(0.0, f64::max);
        let expected = norm(levelled) * norm(inverse);
        prop_assert!((condition / expected - 1.0).abs() <= 16.0 * f64::EPSILON * super::number(N * N) * condition);
        Ok(())
    }

    #[test]
    fn a_power_of_two_scales_to_between_two_and_four() {
        for value in [1e-300, 3e-38, 0.7, 1.0, 1.999, 2.0, 2.001, 123.0, 3e38, 1e300] {
            let scale = levelling::<f64>(value);
            assert!((2.0..4.0).contains(&(scale * value)), "{value} {scale}");
            assert_eq!(1.0 / (1.0 / scale), scale);
        }
        // beyond the limits the scale and its reciprocal stay ordinary numbers
        for value in [0.0, 5e-324, f64::MAX] {
            let scale = levelling::<f64>(value);
            assert!(scale.is_normal() && (1.0 / scale).is_normal(), "{value} {scale}");
        }
        assert_eq!(levelling::<f32>(1e-300), levelling::<f32>(0.0));
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

    /// The scales of another matrix change no bit as long as the pivots stay.
    #[test]
    fn scales_of_a_similar_matrix_do_not_matter() {
        for unit in [1.0, 1e-150, 1e150] {
            let matrix =
                [[15.0, 2.0, 3.0], [4.0, 13.0, -5.0], [1.0, -1.0, 7.0]].map(|row| row.map(|entry| unit * entry));
            let similar = matrix.map(|row| row.map(|entry| 1.3 * entry + 0.1 * unit));
            let expected = factor(similar).unwrap();
            let mut rows = [FactorRow::default(); 3];
            factor_in(matrix.clone().as_flattened_mut(), &mut rows).unwrap();
            let mut entries = similar;
            let elimination = factor_to(entries.as_flattened_mut(), &mut rows, f64::EPSILON, Scaling::Kept).unwrap();
            let right = [6.0, 16.0, 1.0];
            let mut solution = [0.0; 3];
            substitute_in(entries.as_flattened(), &rows, &right, &mut solution);
            assert_eq!(solution, expected.solve(right));
            let determinant = Determinant::of(entries.as_flattened(), &rows, elimination.is_odd);
            assert_eq!(determinant.value(), expected.determinant());
        }
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
        assert!(matches!(
            factor([[0.1, 0.2], [0.3, 0.6]]),
            Err(Failure::Singular { determinant }) if determinant.abs() < 1e-16
        ));
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
            for index in 0..4 {
                let mut entries = [2.0, 1.0, 1.0, 3.0];
                entries[index] = value;
                let [a, b, c, d] = entries;
                assert!(matches!(factor([[a, b], [c, d]]), Err(Failure::NotFinite { .. })));
            }
        }
        let broken = Series::from_coefficients([1.0, f64::NAN]);
        assert!(matches!(factor([[broken]]), Err(Failure::NotFinite { .. })));
    }
}
