//! How well a dyad passes on force.

use crate::number::Number;
use crate::quantity::Name;

/// The transmission angle of a dyad: the angle at which its two links meet.
///
/// For two links joined by a revolute joint (RRR), it is the angle between the lines from that joint to the joints at
/// their other ends. For a link and a slider (RRP), the slider stands for a link of infinite length at right angles to
/// its line: it is the angle between the line from the slider's joint to the link's other end, and the normal to the
/// left of the direction in which that joint moves as the sought length grows. Both are in 0 ..= π. At a right angle
/// the force along one link drives the other best; at 0 and at π, where the links lie on one line, it does not drive it
/// at all, and the position is singular.
///
/// H. Alt, *Der Übertragungswinkel und seine Bedeutung für das Konstruieren periodischer Getriebe*, Werkstattstechnik
/// 26 (1932), pages 61 to 64; R. S. Hartenberg and J. Denavit, *Kinematic Synthesis of Linkages*, McGraw-Hill 1964. The
/// literature gives the angle itself or the smaller of it and its supplement: here, `angle` is the one and
/// [`folded`](Self::folded) the other.
///
/// A mechanism gives those of all its dyads by a generated method, if the declaration says `with transmission_angles;`.
///
/// ```
/// use kin_core::prelude::*;
///
/// mechanism! {
///     pub struct FourBar { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
///     input theta2: Angle;
///     unknown theta3: Angle, theta4: Angle;
///     r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
///     with transmission_angles;
/// }
///
/// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let pose = linkage.position(65_f64.to_radians(), Assembly::Open)?;
/// let [transmission] = linkage.transmission_angles(&pose);
/// assert_eq!(transmission.block, "theta3, theta4");
/// // as by the law of cosines from the diagonal of crank and ground
/// assert!((transmission.angle.to_degrees() - 101.6763).abs() < 5e-5);
/// assert!((transmission.folded().to_degrees() - 78.3237).abs() < 5e-5);
/// assert!((transmission.deviation().to_degrees() - 11.6763).abs() < 5e-5);
/// # Ok::<(), SolveError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransmissionAngle<T = f64> {
    /// The unknowns of the dyad, separated by commas.
    pub block: Name,
    /// The angle, 0 ..= π.
    pub angle: T,
}

impl<T: Number> TransmissionAngle<T> {
    /// From a positive multiple of the angle's sine, whose sign is not looked at, and the same multiple of its cosine.
    #[doc(hidden)]
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn of(block: impl Into<Name>, across: T, along: T) -> Self {
        let across = if across.real() < 0.0 { -across } else { across };
        Self {
            block: block.into(),
            angle: across.atan2(along),
        }
    }

    /// The smaller of the angle and its supplement, 0 ..= π/2.
    #[must_use]
    pub fn folded(&self) -> T {
        let supplement = T::constant(core::f64::consts::PI) - self.angle;
        if supplement.real() < self.angle.real() {
            supplement
        } else {
            self.angle
        }
    }

    /// By how much it deviates from a right angle, 0 ..= π/2. A rule of thumb keeps it below 50 degrees.
    #[must_use]
    pub fn deviation(&self) -> T {
        T::constant(core::f64::consts::FRAC_PI_2) - self.folded()
    }
}

#[cfg(test)]
mod tests {
    use super::TransmissionAngle;
    use core::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn angles_are_folded_once() {
        for (across, along, angle, folded) in [
            (1.0_f64, 0.0, FRAC_PI_2, FRAC_PI_2),
            (-2.0, 0.0, FRAC_PI_2, FRAC_PI_2),
            (0.0, 3.0, 0.0, 0.0),
            (0.0, -3.0, PI, 0.0),
            (-1.0, -1.0, 0.75 * PI, 0.25 * PI),
        ] {
            let transmission = TransmissionAngle::of("x, y", across, along);
            assert_eq!(transmission.angle, angle);
            assert!((transmission.folded() - folded).abs() <= PI * f64::EPSILON);
            assert_eq!(transmission.deviation(), FRAC_PI_2 - transmission.folded());
        }
    }
}
