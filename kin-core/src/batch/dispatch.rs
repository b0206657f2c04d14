//! The widest vectors of the machine.
#![cfg_attr(
    all(feature = "std", target_arch = "x86_64"),
    expect(
        unsafe_code,
        reason = "a function compiled for some instructions may be called on a machine that has been found to have them"
    )
)]

use super::lanes::Element;

/// The number of lanes of the widest vectors, in double precision.
pub(super) const MOST_LANES: usize = 16;

/// The number of lanes of the widest vectors, in single precision.
#[cfg_attr(
    not(feature = "std"),
    expect(dead_code, reason = "verdicts need a store for each lane, and threads")
)]
pub(super) const MOST_SINGLES: usize = 16;

/// The vector instructions for a batch.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Vectors {
    /// The instructions for which the program was compiled.
    Compiled,
    /// AVX2 with fused multiply-add: four numbers per instruction, eight in single precision.
    Avx2,
    /// AVX-512: eight numbers per instruction, sixteen in single precision. Newton's method uses AVX2 in its place.
    Avx512,
}

impl Vectors {
    /// The widest vectors of this machine.
    #[inline]
    #[must_use]
    pub fn widest() -> Self {
        [Self::Avx512, Self::Avx2]
            .into_iter()
            .find(|vectors| vectors.are_there())
            .unwrap_or(Self::Compiled)
    }

    /// Whether this machine has these instructions.
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    #[inline]
    #[must_use]
    pub fn are_there(self) -> bool {
        use std::arch::is_x86_feature_detected as has;
        match self {
            Self::Compiled => true,
            Self::Avx2 => has!("avx2") && has!("fma"),
            Self::Avx512 => has!("avx512f") && has!("avx512dq") && has!("avx512vl") && Self::Avx2.are_there(),
        }
    }

    /// Whether this machine has these instructions.
    #[cfg(not(all(feature = "std", target_arch = "x86_64")))]
    #[inline]
    #[must_use]
    pub fn are_there(self) -> bool {
        self == Self::Compiled
    }

    /// Runs a kernel with these instructions, or with the compiled ones if this machine does not have them.
    pub(crate) fn run<K: Kernel>(self, kernel: K) -> K::Result {
        #[cfg(all(feature = "std", target_arch = "x86_64"))]
        if self.are_there() {
            match self {
                Self::Compiled => {}
                // SAFETY: `avx2` is an ordinary Rust function except for its `target_feature`: all it requires from its
                // caller is a machine with AVX2 and FMA. `are_there` has just tested this machine for both, and for an
                // operating system that saves their registers. Neither can disappear while the program runs.
                Self::Avx2 => return unsafe { avx2(kernel) },
                // SAFETY: a machine with AVX-512 has AVX2 and FMA: `are_there` tests for them as well.
                Self::Avx512 if const { matches!(K::AVX512, Some(Avx512::Not)) } => return unsafe { avx2(kernel) },
                // SAFETY: as above.
                Self::Avx512 if const { K::AVX512.is_none() } && kernel.avx512() == Avx512::Not => {
                    return unsafe { avx2(kernel) };
                }
                // SAFETY: as above, with AVX-512 F, DQ and VL, AVX2 and FMA: the five features for which `avx512` is
                // compiled, and for which `are_there` has just tested this machine.
                Self::Avx512 => return unsafe { avx512(kernel) },
            }
        }
        #[cfg(not(all(feature = "std", target_arch = "x86_64")))]
        let _ = self;
        compiled(kernel)
    }
}

/// The ways to use AVX-512.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Avx512 {
    /// Two vectors of double precision for each number, so that fewer steps wait for each other.
    SixteenLanes,
    /// One vector. The numbers of sixteen poses may fill the queue in which a processor keeps stores until the memory
    /// takes them. It waits then: on Zen 4, whose queue holds 32 stores of 512 bits, up to twice as long, where the
    /// columns do not fit into the caches.
    EightLanes,
    /// AVX2 in its place. Newton's method is slower in AVX-512: it waits for the slowest of more poses, and stores
    /// more.
    Not,
}

impl Avx512 {
    /// The way for a mechanism with so many assemblies, of whose pose so many numbers can be stored.
    pub(super) const fn of(assemblies: usize, numbers: usize) -> Self {
        if assemblies == 0 {
            Self::Not
        } else if numbers > 16 {
            Self::EightLanes
        } else {
            Self::SixteenLanes
        }
    }
}

/// Code that is compiled once for each kind of vectors. Everything it calls must be inlined, or it is compiled for the
/// narrowest vectors. Debug builds inline nothing: the results are the same, and the code is compiled in half the time.
pub trait Kernel {
    type Result;

    /// The numbers in its lanes.
    type Element: Element;

    /// The way in which it uses AVX-512. It is `None` if it is known only when the kernel runs.
    const AVX512: Option<Avx512> = Some(Avx512::SixteenLanes);

    /// The way in which this kernel uses AVX-512.
    #[inline]
    fn avx512(&self) -> Avx512 {
        Self::AVX512.unwrap_or(Avx512::SixteenLanes)
    }

    /// Runs the kernel in `W` lanes, with vectors of `BITS` bits.
    fn run<const W: usize, const BITS: usize>(self) -> Self::Result;
}

/// Not inlined: without optimisation every result has a separate slot on the stack, and this stack would be added to
/// that of the others.
#[inline(never)]
fn compiled<K: Kernel>(kernel: K) -> K::Result {
    K::Element::run::<K, 4, 8, 128>(kernel)
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx2,fma")]
fn avx2<K: Kernel>(kernel: K) -> K::Result {
    K::Element::run::<K, 8, 16, 256>(kernel)
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[expect(clippy::if_same_then_else, reason = "one of the conditions is a constant")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
fn avx512<K: Kernel>(kernel: K) -> K::Result {
    // in constants, so that only one of the two is compiled for a kernel whose way is known
    if const { matches!(K::AVX512, Some(Avx512::EightLanes)) } {
        K::Element::run::<K, { MOST_LANES / 2 }, MOST_SINGLES, 512>(kernel)
    } else if const { K::AVX512.is_none() } && kernel.avx512() == Avx512::EightLanes {
        K::Element::run::<K, { MOST_LANES / 2 }, MOST_SINGLES, 512>(kernel)
    } else {
        K::Element::run::<K, MOST_LANES, MOST_SINGLES, 512>(kernel)
    }
}
