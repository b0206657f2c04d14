//! The two assemblies of a dyad.

mod given;
#[cfg(feature = "alloc")]
mod name;
mod near;

pub use given::IntoAssembly;
#[cfg(feature = "alloc")]
pub(crate) use name::assembly_name;
#[cfg(feature = "alloc")]
pub use name::assembly_named;
pub use near::{Guess, Near};

use core::fmt;

/// The two ways to assemble a dyad, which consists of two links and the joint between them.
///
/// Given its two ends, a dyad has two positions, which are mirror images: the joint lies on either side of the line
/// between the ends. Textbooks call an assembly a branch, circuit or configuration. The *orientation* of the dyad
/// distinguishes the two: it is the sign of the determinant of the Jacobian. A mechanism can change from one to the
/// other only through a singular position, where the links lie on one line. So the assembly is chosen once, when the
/// mechanism is built, and stays the same for the whole motion.
///
/// | closure | `Open` |
/// |---|---|
/// | two links of known length | the second is clockwise from the first: v₁ × v₂ < 0 |
/// | link and slider | the larger of the two travels |
/// | length in an unknown direction | the length is positive |
/// | a cos x + b sin x = c | x is the larger of the two angles around atan2(b, a) |
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
#[doc(alias = "branch")]
#[doc(alias = "circuit")]
#[doc(alias = "configuration")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Assembly {
    /// The assembly in which an ordinary four-bar linkage above its ground link does not cross itself.
    Open,
    /// The mirror image of [`Open`](Self::Open).
    Crossed,
}

impl Assembly {
    /// Both assemblies.
    pub const BOTH: [Self; 2] = [Self::Open, Self::Crossed];

    /// The other assembly.
    #[inline]
    #[must_use]
    pub const fn mirrored(self) -> Self {
        match self {
            Self::Open => Self::Crossed,
            Self::Crossed => Self::Open,
        }
    }

    /// The assembly of the sign of `x`: [`Open`](Self::Open) if `x` is positive or zero, otherwise
    /// [`Crossed`](Self::Crossed).
    #[inline]
    #[must_use]
    pub fn from_sign(x: f64) -> Self {
        if x >= 0.0 { Self::Open } else { Self::Crossed }
    }
}

/// The results of a function for both assemblies, the open one first.
///
/// The function is called at one site only, so that the compiler can inline it.
///
/// # Errors
/// The error of the function.
///
/// ```
/// use kin_core::{Assembly, Failure, solve};
///
/// let both = solve::both(|assembly| solve::square_root(9.0, assembly))?;
/// assert_eq!(both, (3.0, -3.0));
/// # Ok::<(), Failure>(())
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
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
