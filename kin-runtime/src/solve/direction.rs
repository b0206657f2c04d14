//! The angle of a vector whose length is known.

use crate::solve::Scalar;

/// The angle of the unit vector u with `(x, y)` = `length` u: the same as `atan2(y, x)`, in -π ..= π, for a positive
/// length.
///
/// The length may be negative, like that of a slide in the crossed assembly; u then points against the vector. Any
/// positive multiple of the vector gives the same angle, because the arctangent needs no unit vector. Lengths may have
/// any common unit; the angle is in radians.
///
/// ```
/// use core::f64::consts::FRAC_PI_2;
/// use kin_core::solve;
///
/// assert_eq!(solve::direction(3.0, 0.0, 3.0), FRAC_PI_2);
/// assert_eq!(solve::direction(3.0, 0.0, -3.0), -FRAC_PI_2);
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn direction<T: Scalar>(y: T, x: T, length: T) -> T {
    y.times_sign_of(length).atan2(x.times_sign_of(length))
}

/// [`direction`] of two vectors, for less than twice the cost.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn directions<T: Scalar>(y: [T; 2], x: [T; 2], length: [T; 2]) -> [T; 2] {
    let upright = |part: [T; 2]| [part[0].times_sign_of(length[0]), part[1].times_sign_of(length[1])];
    T::atan2_of_two(upright(y), upright(x))
}

#[cfg(test)]
mod tests {
    use super::{direction, directions};
    use crate::number::Number;

    #[test]
    fn a_negative_length_turns_the_direction_round() {
        for angle in [-3.0_f64, -1.0, 0.0, 0.5, 2.0, 3.1] {
            let (sine, cosine) = Number::sin_cos(angle);
            for length in [0.1, 2.0, -0.1, -2.0] {
                let found = direction(length * sine, length * cosine, length);
                assert!((found - angle).abs() < 1e-15, "{angle} {length}");
                let both = directions(
                    [length * sine, length * cosine],
                    [length * cosine, -length * sine],
                    [length, length],
                );
                assert_eq!(both[0], found);
                assert!((both[1] - found - core::f64::consts::FRAC_PI_2).sin().abs() < 1e-15);
            }
        }
    }
}
