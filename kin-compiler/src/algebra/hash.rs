//! A hash table for small keys. Look-ups of expressions are so frequent that the standard library's hash, made to
//! resist malicious keys, takes a considerable part of the time of an expansion.

use std::hash::{BuildHasherDefault, Hasher};

/// A hash table. As everywhere, its order must not reach the output.
pub(crate) type HashMap<Key, Value> = std::collections::HashMap<Key, Value, BuildHasherDefault<Mixer>>;

/// Multiplicative hashing of one word after the other (D. E. Knuth, *The Art of Computer Programming* 3, 2nd edition,
/// section 6.4).
#[derive(Clone, Copy, Default)]
pub(crate) struct Mixer(u64);

/// 2⁶⁴ divided by the golden ratio, made odd.
const MULTIPLIER: u64 = 0x9e37_79b9_7f4a_7c15;

impl Mixer {
    const fn mix(&mut self, word: u64) {
        self.0 = (self.0.rotate_left(5) ^ word).wrapping_mul(MULTIPLIER);
    }
}

impl Hasher for Mixer {
    fn finish(&self) -> u64 {
        // the table uses the low bits, and multiplication mixes the high bits best
        self.0 ^ (self.0 >> 32)
    }

    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.mix(u64::from_le_bytes(word));
        }
    }

    fn write_u8(&mut self, word: u8) {
        self.mix(u64::from(word));
    }

    fn write_u32(&mut self, word: u32) {
        self.mix(u64::from(word));
    }

    fn write_i32(&mut self, word: i32) {
        self.mix(u64::from(word.cast_unsigned()));
    }

    fn write_u64(&mut self, word: u64) {
        self.mix(word);
    }

    fn write_usize(&mut self, word: usize) {
        self.mix(word as u64);
    }

    fn write_isize(&mut self, word: isize) {
        self.mix(word.cast_unsigned() as u64);
    }
}
