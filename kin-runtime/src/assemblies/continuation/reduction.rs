//! The variables that the equations of first degree leave free.

use num_traits::Float;

use super::complex::Complex;
use super::scaling::Scales;
use super::system::BorrowedSystem;

/// The largest remainder of a dependent linear equation, after the other equations are subtracted from it.
const DEPENDENT: f64 = 1e-12;

/// Homogeneous coordinates X₀, X₁ ... of the variables x₁ = X₁/X₀ ..., as linear forms of fewer coordinates.
///
/// The equations of degree one are homogeneous linear equations in X₀, X₁ ..., and their solutions form a linear space.
/// The new coordinates belong to an orthonormal basis of this space. There are `free + 1` of them. Only their ratios
/// matter, so one coordinate, the pinned one, is kept equal to one. Any coordinate can be pinned.
#[derive(Clone, Debug)]
pub(super) struct Coordinates<const M: usize> {
    /// The number of coordinates without the pinned one.
    pub(super) free: usize,
    /// The shares of the free coordinates in X₁ ..., in the units of the variables.
    pub(super) basis: [[f64; M]; M],
    /// The share of the pinned coordinate in X₁ ....
    pub(super) pinned: [f64; M],
    /// The shares of the free coordinates in X₀.
    pub(super) infinity: [f64; M],
    /// The share of the pinned coordinate in X₀.
    pub(super) infinity_pinned: f64,
    /// The inverse units of the variables.
    pub(super) inverse_units: [f64; M],
}

impl<const M: usize> Coordinates<M> {
    /// Pins the coordinate at `index`. The coordinate that was pinned takes its index among the free ones.
    pub(super) fn exchange(&mut self, index: usize) {
        for (row, pinned) in self.basis.iter_mut().zip(&mut self.pinned) {
            core::mem::swap(&mut row[index], pinned);
        }
        core::mem::swap(&mut self.infinity[index], &mut self.infinity_pinned);
    }

    /// The free coordinates of a point X₁ ... and X₀ that fulfils the equations of degree one, for units of one.
    pub(super) fn of(&self, (x, infinity): &([Complex; M], Complex)) -> [Complex; M] {
        let sum = |share: &dyn Fn(usize) -> f64, of_infinity: f64| {
            x.iter()
                .enumerate()
                .fold(infinity.scale(of_infinity), |sum, (variable, x)| {
                    sum + x.scale(share(variable))
                })
        };
        let inverse = sum(&|variable| self.pinned[variable], self.infinity_pinned).inverse();
        core::array::from_fn(|index| sum(&|variable| self.basis[variable][index], self.infinity[index]) * inverse)
    }

    /// Converts a linear form of X₀ and some of X₁ ... into a form of the free coordinates and the pinned one. Returns
    /// the coefficient of the pinned coordinate.
    #[inline]
    pub(super) fn restrict(
        &self,
        support: &[usize],
        along: &[Complex; M],
        infinity: Complex,
        form: &mut [Complex; M],
    ) -> Complex {
        let form = &mut form[..self.free];
        for (entry, share) in form.iter_mut().zip(&self.infinity) {
            *entry = infinity.scale(*share);
        }
        let mut pinned = infinity.scale(self.infinity_pinned);
        for &variable in support {
            let slope = along[variable];
            for (entry, share) in form.iter_mut().zip(&self.basis[variable]) {
                *entry += slope.scale(*share);
            }
            pinned += slope.scale(self.pinned[variable]);
        }
        pinned
    }
}

/// A vector with the components X₁ ... and X₀.
#[derive(Clone, Copy)]
struct Vector<const M: usize>([f64; M], f64);

impl<const M: usize> Vector<M> {
    const ZERO: Self = Self([0.0; M], 0.0);

    fn dot(&self, other: &Self) -> f64 {
        self.0
            .iter()
            .zip(&other.0)
            .fold(self.1 * other.1, |sum, (a, b)| sum + a * b)
    }

    fn norm(&self) -> f64 {
        Float::sqrt(self.dot(self))
    }

    fn scale(&mut self, factor: f64) {
        for entry in &mut self.0 {
            *entry *= factor;
        }
        self.1 *= factor;
    }

    /// Subtracts the component along a unit vector.
    fn remove(&mut self, unit: &Self) {
        let along = self.dot(unit);
        for (entry, unit) in self.0.iter_mut().zip(&unit.0) {
            *entry -= along * unit;
        }
        self.1 -= along * unit.1;
    }

    fn entry(&mut self, index: usize) -> &mut f64 {
        self.0.get_mut(index).unwrap_or(&mut self.1)
    }
}

/// The coordinates that remain after the equations of degree one.
///
/// # Errors
/// Returns the index of an equation that follows from the others or contradicts them.
pub(super) fn reduce<const M: usize>(
    system: &BorrowedSystem<'_, M>,
    coefficients: &[f64],
    degrees: &[u8; M],
    scales: &Scales<M>,
) -> Result<Coordinates<M>, usize> {
    let mut normals = [Vector::<M>::ZERO; M];
    for term in system.terms() {
        let equation = usize::from(term.equation);
        if degrees[equation] != 1 {
            continue;
        }
        let coefficient = coefficients[usize::from(term.coefficient)] * scales.equations[equation];
        if let [(variable, _)] = *term.powers {
            let variable = usize::from(variable);
            // The coefficient of a term of higher degree is zero here.
            normals[equation].0[variable] += coefficient * scales.variables[variable];
        } else if term.powers.is_empty() {
            normals[equation].1 += coefficient;
        }
    }
    // Build an orthonormal basis of the normals, longest remaining one first. Subtract twice, because once loses
    // digits.
    let mut used = [false; M];
    let mut linear = 0;
    for (equation, &degree) in degrees.iter().enumerate() {
        if degree == 1 {
            let norm = normals[equation].norm();
            normals[equation].scale(1.0 / norm);
            linear += 1;
        }
    }
    let mut order = [0; M];
    for index in 0..linear {
        let mut best = (0, -1.0);
        for (equation, &degree) in degrees.iter().enumerate() {
            if degree == 1 && !used[equation] {
                let norm = normals[equation].norm();
                // A NaN norm is taken at once, and detected later.
                if norm.is_nan() || norm > best.1 {
                    best = (equation, norm);
                }
            }
        }
        let (equation, norm) = best;
        if norm.is_nan() || norm <= DEPENDENT {
            return Err(equation);
        }
        used[equation] = true;
        order[index] = equation;
        let mut unit = normals[equation];
        unit.scale(1.0 / norm);
        for &earlier in &order[..index] {
            unit.remove(&normals[earlier]);
        }
        unit.scale(1.0 / unit.norm());
        normals[equation] = unit;
        for (other, normal) in normals.iter_mut().enumerate() {
            if degrees[other] == 1 && !used[other] {
                normal.remove(&unit);
            }
        }
    }
    let free = system.variables() - linear;
    let mut coordinates = Coordinates {
        free,
        basis: [[0.0; M]; M],
        pinned: [0.0; M],
        infinity: [0.0; M],
        infinity_pinned: 0.0,
        inverse_units: scales.variables.map(|unit| 1.0 / unit),
    };
    // For each axis, the square of its part outside the vectors found so far.
    let mut left = Vector([1.0; M], 1.0);
    left.0[system.variables()..].fill(-1.0);
    let exclude = |left: &mut Vector<M>, unit: &Vector<M>| {
        for (left, entry) in left.0.iter_mut().zip(&unit.0) {
            *left -= entry * entry;
        }
        left.1 -= unit.1 * unit.1;
    };
    for &equation in &order[..linear] {
        exclude(&mut left, &normals[equation]);
    }
    let mut found = [Vector::<M>::ZERO; M];
    for index in 0..=free {
        let (mut axis, mut most) = (M, left.1);
        for (candidate, &left) in left.0.iter().enumerate() {
            if left > most {
                (axis, most) = (candidate, left);
            }
        }
        let mut unit = Vector::<M>::ZERO;
        *unit.entry(axis) = 1.0;
        for _ in 0..2 {
            for &equation in &order[..linear] {
                unit.remove(&normals[equation]);
            }
            for earlier in &found[..index] {
                unit.remove(earlier);
            }
            unit.scale(1.0 / unit.norm());
        }
        exclude(&mut left, &unit);
        *left.entry(axis) = -1.0;
        for variable in 0..M {
            let entry = unit.0[variable] * scales.variables[variable];
            if index < free {
                coordinates.basis[variable][index] = entry;
            } else {
                coordinates.pinned[variable] = entry;
            }
        }
        if index < free {
            found[index] = unit;
            coordinates.infinity[index] = unit.1;
        } else {
            coordinates.infinity_pinned = unit.1;
        }
    }
    Ok(coordinates)
}
