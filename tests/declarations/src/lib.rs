//! Random declarations of mechanisms, for the tests of `mechanism!`.
//!
//! A declaration is text, as it would stand between the braces of the macro. Each kind and seed give the same one in
//! every run. A [`Sample`] is a sound one, as data too: its quantities, its residuals, and poses at which it closes.

mod adversarial;
mod closing;
mod damage;
mod formula;
mod measure;
mod names;
mod numbers;
mod random;
mod sample;
mod sound;
mod text;
mod value;
mod well_typed;

pub use adversarial::{FAMILIES, Family};
pub use closing::{Linearised, closed};
pub use random::Random;
pub use sample::{Dimension, Pose, Quantity, Sample, code};

use names::Naming;
use sound::Style;

/// The outcome that is expected of a declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A mechanism without mistakes: the macro must accept it.
    Sound,
    /// Grammar and dimensions are right; there may be no solution.
    WellTyped,
    /// A sound declaration with a few tokens changed.
    Damaged,
    /// Deep, wide, long, of large powers, of strange names and numbers.
    Adversarial,
}

impl Kind {
    /// Every kind.
    pub const ALL: [Self; 4] = [Self::Sound, Self::WellTyped, Self::Damaged, Self::Adversarial];

    /// In small letters.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Sound => "sound",
            Self::WellTyped => "well-typed",
            Self::Damaged => "damaged",
            Self::Adversarial => "adversarial",
        }
    }
}

/// How far declarations go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// So far that thousands are expanded in seconds.
    Small,
    /// As far as the macro should be able to follow.
    Full,
}

/// The declaration that belongs to a kind and a seed.
#[must_use]
pub fn declaration(kind: Kind, seed: u64, scale: Scale) -> String {
    let mut random = Random::new(seed);
    let random = &mut random;
    match kind {
        Kind::Sound => sound(random, scale),
        Kind::WellTyped => well_typed::declaration(random, scale),
        Kind::Damaged => {
            let whole = if random.one_in(4) {
                well_typed::declaration(random, scale)
            } else {
                sound(random, scale)
            };
            damage::damaged(random, &whole)
        }
        Kind::Adversarial => adversarial::declaration(random, scale),
    }
}

fn sound(random: &mut Random, scale: Scale) -> String {
    let (blocks, order) = match scale {
        Scale::Small => (2, 2),
        Scale::Full => (6, if random.one_in(6) { 12 } else { 5 }),
    };
    let style = Style {
        blocks,
        order,
        naming: if random.one_in(2) {
            Naming::Plain
        } else {
            Naming::Unusual
        },
        tests: true,
    };
    sound::declaration(random, "Mechanism", style).to_string()
}

#[cfg(test)]
mod tests {
    use super::{Kind, Scale, declaration};

    #[test]
    fn declarations_are_repeated_and_differ() {
        for kind in Kind::ALL {
            let all: Vec<String> = (0..50).map(|seed| declaration(kind, seed, Scale::Small)).collect();
            for (seed, first) in (0..).zip(&all) {
                assert_eq!(*first, declaration(kind, seed, Scale::Small));
            }
            let mut distinct = all;
            distinct.sort_unstable();
            distinct.dedup();
            assert!(distinct.len() > 40, "{kind:?}: {}", distinct.len());
        }
    }
}
