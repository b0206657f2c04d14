//! One angle from its cosine or its sine.

use super::refusal::refusal;
use super::root::Root;
use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::solve::Scalar;
use crate::solve::check::doubt::{least, size};
use crate::solve::check::regular::ordinary_from;
use crate::solve::check::{Check, Real};

/// The height of a link of the given radius and width: y of (x, y) = `radius` (cos φ, sin φ), given x.
///
/// All lengths share one unit. [`Assembly::Open`] has a positive sine, so the height has the sign of the radius.
///
/// It takes 4 operations: 2 additions, 1 multiplication, 1 square root; and one change of sign in the crossed assembly.
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin |radius| - |width|, [`Failure::Singular`] if the margin is zero,
/// [`Failure::NotFinite`].
///
/// ```
/// use kin_core::{Assembly, solve};
///
/// let height = solve::inverse_cosine(3.0_f64, 5.0, Assembly::Open)?.value;
/// assert!((height - 4.0).abs() < 1e-15);
/// # Ok::<(), kin_core::Failure>(())
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn inverse_cosine<T: Scalar>(width: T, radius: T, assembly: Assembly) -> Result<Root<T>, Failure> {
    other(width, radius, assembly, "length of a link or its given width")
}

/// The width of a link of the given radius and height: x of (x, y) = `radius` (cos φ, sin φ), given y.
///
/// All lengths share one unit. [`Assembly::Open`] has a positive cosine, so the width has the sign of the radius.
///
/// It takes 4 operations, as [`inverse_cosine`] does.
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin |radius| - |height|, [`Failure::Singular`] if the margin is zero,
/// [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn inverse_sine<T: Scalar>(height: T, radius: T, assembly: Assembly) -> Result<Root<T>, Failure> {
    other(height, radius, assembly, "length of a link or its given height")
}

/// The other leg of the right-angled triangle whose hypotenuse is the radius.
#[cfg_attr(not(debug_assertions), inline(always))]
fn other<T: Scalar>(known: T, radius: T, assembly: Assembly, quantity: &'static str) -> Result<Root<T>, Failure> {
    // The factors keep precision at angles where the known leg is almost as long as the radius.
    let square = (radius - known) * (radius + known);
    let reach = Reach {
        square,
        least: least(|| radius * radius),
        radius,
        known,
    };
    let Some(square) = square.provided(reach) else {
        return Err(T::refused(|| {
            too_short(known.real(), radius.real(), T::EPSILON, quantity)
        }));
    };
    let leg = Root::of(square, assembly);
    Ok(Root {
        value: leg.value.times_sign_of(radius),
        ..leg
    })
}

/// Whether a link is longer than one of its coordinates.
#[derive(Clone, Copy)]
struct Reach<T> {
    square: T,
    least: T,
    radius: T,
    known: T,
}

impl<T: Scalar> Check<T, 2, 2> for Reach<T> {
    fn name(&self) -> &'static str {
        "reach of a link"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        [self.square, self.least]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [square, least]: [R; 2]) -> [R::Truth; 2] {
        ordinary_from(square, least, T::SMALLEST_DIVISOR)
    }

    fn margin(&self) -> T {
        size(self.radius) - size(self.known)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shortfall(&self, _: T) -> Option<[T; 2]> {
        let (radius, known) = (size(self.radius), size(self.known));
        Some([radius - known, radius + known])
    }
}

#[cold]
#[inline(never)]
fn too_short(known: f64, radius: f64, epsilon: f64, quantity: &'static str) -> Failure {
    refusal(radius.abs() - known.abs(), radius.abs(), epsilon, 0.0, quantity)
}

#[cfg(test)]
mod tests {
    use super::{inverse_cosine, inverse_sine};
    use crate::assembly::Assembly;
    use crate::failure::Failure;

    #[test]
    fn the_other_leg_has_the_sign_of_the_assembly_and_of_the_radius() {
        for assembly in Assembly::BOTH {
            for radius in [3.0_f64, -3.0, 1e-100, -1e100] {
                for known in [-0.999_f64, -0.6, 0.0, 0.3, 1.0 - 1e-15] {
                    let by_cosine = inverse_cosine(known * radius, radius, assembly).unwrap();
                    let by_sine = inverse_sine(known * radius, radius, assembly).unwrap();
                    assert_eq!(by_cosine, by_sine);
                    let other = by_sine.value / radius;
                    assert!((other * other + known * known - 1.0).abs() < 4.0 * f64::EPSILON);
                    assert_eq!(Assembly::from_sign(other), assembly);
                }
            }
        }
    }

    #[test]
    fn limits_and_what_lies_beyond() {
        for solve in [inverse_cosine::<f64>, inverse_sine::<f64>] {
            for radius in [2.0, -2.0] {
                for known in [1.0, -1.0, 1.0 + f64::EPSILON] {
                    assert_eq!(
                        solve(2.0 * known, radius, Assembly::Open),
                        Err(Failure::Singular { determinant: 0.0 })
                    );
                }
                assert_eq!(
                    solve(-2.5, radius, Assembly::Open),
                    Err(Failure::OutOfReach { margin: -0.5 })
                );
            }
            assert_eq!(
                solve(0.0, 0.0, Assembly::Open),
                Err(Failure::Singular { determinant: 0.0 })
            );
            for (known, radius) in [
                (f64::NAN, 1.0),
                (0.5, f64::NAN),
                (0.5, f64::INFINITY),
                (f64::INFINITY, 1.0),
            ] {
                assert!(matches!(
                    solve(known, radius, Assembly::Open),
                    Err(Failure::NotFinite { .. })
                ));
            }
        }
    }
}
