//! One angle by its cosine or its sine.

use super::diagnosis::{ordinary, refusal};
use crate::{Assembly, Failure, Plane, Scalar};

/// The unit vector (cos x, sin x) with the given cosine. [`Assembly::Open`] has a positive sine.
///
/// 4 operations: 2 additions, 1 multiplication, 1 square root; a change of sign more in the crossed assembly.
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin 1 - |cosine|, [`Failure::Singular`] if that is zero, [`Failure::NotFinite`].
///
/// ```
/// use kin_core::{Assembly, solve};
///
/// let u = solve::inverse_cosine(0.6, Assembly::Open)?;
/// assert!((u.y - 0.8f64).abs() < 1e-15);
/// # Ok::<(), kin_core::Failure>(())
/// ```
#[inline(always)]
pub fn inverse_cosine<T: Scalar>(cosine: T, assembly: Assembly) -> Result<Plane<T>, Failure> {
    let sine = other(cosine, assembly, "cosine of the unknown angle")?;
    Ok(Plane::new(cosine, sine))
}

/// The unit vector (cos x, sin x) with the given sine. [`Assembly::Open`] has a positive cosine.
///
/// 4 operations, as for [`inverse_cosine`].
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin 1 - |sine|, [`Failure::Singular`] if that is zero, [`Failure::NotFinite`].
#[inline(always)]
pub fn inverse_sine<T: Scalar>(sine: T, assembly: Assembly) -> Result<Plane<T>, Failure> {
    let cosine = other(sine, assembly, "sine of the unknown angle")?;
    Ok(Plane::new(cosine, sine))
}

/// The other coordinate of a unit vector.
#[inline(always)]
fn other<T: Scalar>(known: T, assembly: Assembly, quantity: &'static str) -> Result<T, Failure> {
    let one = T::constant(1.0);
    // In factors, for the sake of the angles near which the known coordinate is 1.
    let square = (one - known) * (one + known);
    let Some(square) = square.provided([square], |[square]| ordinary(square, T::SMALLEST)) else {
        return Err(beyond_one(known.real(), T::EPSILON, quantity));
    };
    Ok(assembly.signed(square.sqrt()))
}

#[cold]
#[inline(never)]
fn beyond_one(known: f64, epsilon: f64, quantity: &'static str) -> Failure {
    refusal(1.0 - known.abs(), 1.0, epsilon, 0.0, quantity)
}

#[cfg(test)]
mod tests {
    use super::{inverse_cosine, inverse_sine};
    use crate::{Assembly, Failure};

    #[test]
    fn the_other_coordinate_has_the_sign_of_the_assembly() {
        for assembly in Assembly::BOTH {
            for known in [-0.999_f64, -0.6, 0.0, 0.3, 1.0 - 1e-15] {
                let by_cosine = inverse_cosine(known, assembly).unwrap();
                let by_sine = inverse_sine(known, assembly).unwrap();
                assert_eq!((by_cosine.x, by_cosine.y), (by_sine.y, by_sine.x));
                assert!((by_cosine.norm_squared() - 1.0).abs() < 4.0 * f64::EPSILON);
                assert_eq!(Assembly::from_sign(by_cosine.y), assembly);
            }
        }
    }

    #[test]
    fn limits_and_what_lies_beyond() {
        for solve in [inverse_cosine::<f64>, inverse_sine::<f64>] {
            for known in [1.0, -1.0, 1.0 + f64::EPSILON] {
                assert_eq!(
                    solve(known, Assembly::Open),
                    Err(Failure::Singular { determinant: 0.0 })
                );
            }
            assert_eq!(solve(-1.5, Assembly::Open), Err(Failure::OutOfReach { margin: -0.5 }));
            assert!(matches!(
                solve(f64::NAN, Assembly::Open),
                Err(Failure::NotFinite { .. })
            ));
        }
    }
}
