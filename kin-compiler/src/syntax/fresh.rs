//! Names that nobody has written: those of abbreviations in the copies of a `for`, and of the parts of frames.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, TokenStream};

use crate::syntax::split;

/// The names that are taken, and the written names behind those that are not written.
#[derive(Default)]
pub(crate) struct FreshNames {
    taken: BTreeSet<String>,
    /// The number of copies that a name has so far.
    copies: BTreeMap<String, usize>,
    copied: BTreeMap<String, String>,
    of_frames: BTreeSet<String>,
    /// The names that mean something within one `for` alone.
    inner: BTreeSet<String>,
}

impl FreshNames {
    /// Takes all names in some tokens.
    pub(super) fn take(&mut self, tokens: &TokenStream) {
        split::mentioned_names(tokens, &mut self.taken);
    }

    /// The name of an abbreviation in one more copy: `leg_1`.
    pub(super) fn copy_of(&mut self, name: &Ident) -> Ident {
        let word = name.to_string();
        let count = self.copies.entry(word.clone()).or_default();
        *count += 1;
        let fresh = format!("{word}_{count}");
        let fresh = self.fresh(fresh, name);
        self.copied.insert(fresh.to_string(), word);
        fresh
    }

    /// The name of the part of a frame: `platform_origin`.
    pub(super) fn part_of_frame(&mut self, frame: &Ident, part: &str) -> Ident {
        let fresh = self.fresh(format!("{frame}_{part}"), frame);
        self.of_frames.insert(fresh.to_string());
        fresh
    }

    fn fresh(&mut self, mut wanted: String, written: &Ident) -> Ident {
        while !self.taken.insert(wanted.clone()) {
            wanted.push('_');
        }
        Ident::new(&wanted, written.span())
    }

    /// Remembers a name of a `for`, or of an abbreviation in it.
    pub(super) fn keep_inside(&mut self, name: &Ident) {
        self.inner.insert(name.to_string());
    }

    /// Whether a name means something within one `for` alone.
    pub(crate) fn is_inner(&self, name: &str) -> bool {
        self.inner.contains(name)
    }

    /// The name as it was written.
    pub(crate) fn written<'a>(&'a self, name: &'a str) -> &'a str {
        self.copied.get(name).map_or(name, String::as_str)
    }

    /// Whether it is the name of the part of a frame.
    pub(crate) fn is_of_frame(&self, name: &str) -> bool {
        self.of_frames.contains(name)
    }
}
