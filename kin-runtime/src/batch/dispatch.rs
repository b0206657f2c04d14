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
    /// AVX-512: eight numbers per instruction, sixteen in single precision. A processor that works on them in halves
    /// uses AVX2 in its place where that is faster.
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
                Self::Avx512 if works_in_halves() && kernel.is_slow_in_halves() => return unsafe { avx2(kernel) },
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

/// Whether this machine works on 512 bits in halves, as Zen 4 does. The processors after it have AVX-VNNI. Older ones
/// of Intel do not, and count as such.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
fn works_in_halves() -> bool {
    !std::arch::is_x86_feature_detected!("avxvnni")
}

/// Whether a batch takes longer in AVX-512 than in AVX2 where a processor [works in halves](works_in_halves): of a
/// mechanism with so many assemblies, with so many numbers stored for each of so many poses.
///
/// Newton's method waits for the slowest of more poses then. And the queue in which Zen 4 keeps stores until the memory
/// takes them holds 32 of 512 bits: it is full of the numbers of sixteen poses where these do not fit into the caches.
pub(super) const fn is_slow_in_halves(assemblies: usize, numbers: usize, poses: usize) -> bool {
    const QUEUED: usize = 16;
    const CACHED: usize = 1 << 17;
    assemblies == 0 || numbers > QUEUED && numbers * poses > CACHED
}

/// Code that is compiled once for each kind of vectors. Everything it calls must be inlined, or it is compiled for the
/// narrowest vectors. Debug builds inline nothing: the results are the same, and the code is compiled in half the time.
pub trait Kernel {
    type Result;

    /// The numbers in its lanes.
    type Element: Element;

    /// Whether this kernel takes longer in AVX-512 than in AVX2 where a processor works on 512 bits in halves.
    #[inline]
    fn is_slow_in_halves(&self) -> bool {
        false
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

/// Two vectors of double precision for each number, so that fewer steps wait for each other.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
fn avx512<K: Kernel>(kernel: K) -> K::Result {
    K::Element::run::<K, MOST_LANES, MOST_SINGLES, 512>(kernel)
}
