//! A digest of texts.

/// The 64 bit hash of Fowler, Noll and Vo (FNV-1a). The hashes of the standard library may differ between its versions.
pub(crate) fn digest(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    })
}
