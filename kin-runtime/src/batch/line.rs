//! Cache lines that are stored past the caches.
#![expect(
    unsafe_code,
    reason = "an instruction stores a part of a line by its address, on a machine that has it"
)]

use core::cell::Cell;

/// The bytes in a cache line.
pub(super) const LINE: usize = 64;

/// Whether vectors of so many bits can be stored past the caches, and are whole lines or halves of them. It is tested
/// in constants, so that stores past the caches are compiled for these vectors only.
pub(super) const fn have_lines(bits: usize) -> bool {
    cfg!(all(feature = "std", target_arch = "x86_64")) && bits >= 256
}

/// Stores a chunk past the caches, in vectors of `BITS` bits.
///
/// # Safety
/// The vectors [have lines](have_lines), and the machine has them. The chunk can be read. It consists of whole lines,
/// and its place starts with one.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) unsafe fn store_lines<const W: usize, const BITS: usize, E>(chunk: *const E, place: &[Cell<E>; W]) {
    debug_assert!(place.as_ptr().addr().is_multiple_of(LINE) && size_of_val(place).is_multiple_of(LINE));
    let mut byte = 0;
    while byte < size_of::<[E; W]>() {
        // SAFETY: the caller's. A vector lies between `byte`, a multiple of its size, and the end of the lines. The
        // place consists of cells, which may be changed.
        unsafe {
            let (from, to) = (chunk.byte_add(byte), place.as_ptr().byte_add(byte).cast_mut());
            if BITS == 512 {
                store_512(from.cast(), to.cast());
            } else {
                store_256(from.cast(), to.cast());
            }
        }
        byte += BITS / 8;
    }
}

/// Other machines have no such vectors.
#[cfg(not(all(feature = "std", target_arch = "x86_64")))]
pub(super) unsafe fn store_lines<const W: usize, const BITS: usize, E>(_: *const E, _: &[Cell<E>; W]) {}

/// # Safety
/// The machine has AVX-512, and the second address is that of a line.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[inline]
#[target_feature(enable = "avx512f")]
unsafe fn store_512(from: *const core::arch::x86_64::__m512i, to: *mut core::arch::x86_64::__m512i) {
    // SAFETY: the caller's
    unsafe { core::arch::x86_64::_mm512_stream_si512(to, from.read_unaligned()) }
}

/// # Safety
/// The machine has AVX2, and the second address is that of half a line.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[inline]
#[target_feature(enable = "avx2")]
unsafe fn store_256(from: *const core::arch::x86_64::__m256i, to: *mut core::arch::x86_64::__m256i) {
    // SAFETY: the caller's
    unsafe { core::arch::x86_64::_mm256_stream_si256(to, from.read_unaligned()) }
}

/// Orders the lines that have been stored past the caches before all later stores, as others may expect.
pub(super) fn fence() {
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    // SAFETY: every machine with vectors has this instruction.
    unsafe {
        core::arch::x86_64::_mm_sfence();
    }
}
