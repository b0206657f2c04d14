//! The two ways of putting a dyad together.

mod near;

pub use near::{Guess, Near};

use core::fmt;

/// The two ways in which a dyad, two links and the joint between them, can be put together.
///
/// Given the two ends, the joint between the links can lie on either side of the line that joins
/// the ends: the two positions are mirror images. Which one it is, the *orientation* of the dyad,
/// is the sign of the determinant of its Jacobian; a mechanism cannot go over from one to the other without
/// passing through a singular position, where the links lie on one line. So the assembly is chosen once, when the
/// mechanism is put together, and kept for the whole of its motion.
///
/// | closure | `Open` |
/// |---|---|
/// | two links of known length | the second turns clockwise from the first: v₁ × v₂ < 0 |
/// | link and slider | the larger of the two travels |
/// | length in a sought direction | the length is positive |
/// | a cos x + b sin x = c | x is the larger of the two angles beside atan2(b, a) |
/// | quadratic or square root | the larger root |
///
/// ```
/// use kin_core::Assembly;
///
/// assert_eq!(Assembly::Open.mirrored(), Assembly::Crossed);
/// for assembly in Assembly::BOTH {
///     println!("{assembly}");
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Assembly {
    /// The assembly in which an ordinary four-bar linkage above its ground link does not cross itself.
    Open,
    /// Its mirror image.
    Crossed,
}

impl Assembly {
    /// Both assemblies.
    pub const BOTH: [Self; 2] = [Self::Open, Self::Crossed];

    /// The other one.
    #[inline]
    #[must_use]
    pub const fn mirrored(self) -> Self {
        match self {
            Self::Open => Self::Crossed,
            Self::Crossed => Self::Open,
        }
    }

    /// [`Open`](Self::Open) if `x` is positive or zero, [`Crossed`](Self::Crossed) if it is not.
    #[inline]
    #[must_use]
    pub fn from_sign(x: f64) -> Self {
        if x >= 0.0 { Self::Open } else { Self::Crossed }
    }
}

/// What a function gives for both assemblies, the open one first.
///
/// It is called in one place, so that it can become a part of its caller.
///
/// # Errors
/// Its own.
///
/// ```
/// use kin_core::{Assembly, Failure, solve};
///
/// let both = solve::both(|assembly| solve::square_root(9.0, assembly))?;
/// assert_eq!(both, (3.0, -3.0));
/// # Ok::<(), Failure>(())
/// ```
#[inline(always)]
pub fn both<R, E>(mut candidate: impl FnMut(Assembly) -> Result<R, E>) -> Result<(R, R), E> {
    let (mut assembly, mut open) = (Assembly::Open, None);
    loop {
        let found = candidate(assembly)?;
        match open {
            None => (open, assembly) = (Some(found), Assembly::Crossed),
            Some(open) => return Ok((open, found)),
        }
    }
}

impl fmt::Display for Assembly {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(match self {
            Self::Open => "open",
            Self::Crossed => "crossed",
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Assembly;
    use std::format;

    #[test]
    fn mirroring_twice_changes_nothing() {
        for assembly in Assembly::BOTH {
            assert_ne!(assembly.mirrored(), assembly);
            assert_eq!(assembly.mirrored().mirrored(), assembly);
        }
    }

    #[test]
    fn a_sign_tells_the_assembly() {
        assert_eq!(Assembly::from_sign(2.0), Assembly::Open);
        assert_eq!(Assembly::from_sign(0.0), Assembly::Open);
        assert_eq!(Assembly::from_sign(-2.0), Assembly::Crossed);
    }

    #[test]
    fn names() {
        assert_eq!(format!("{:>5}|{}", Assembly::Open, Assembly::Crossed), " open|crossed");
    }
}
