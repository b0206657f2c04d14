//! The mechanisms of the library, as declared.

use std::fs;

use proc_macro2::{TokenStream, TokenTree};

use super::{Sound, sound};
use crate::passes::Passes;
use crate::program::{Cost, Solvers};

/// A mechanism of the library.
pub(crate) struct Declared {
    pub(crate) name: String,
    pub(crate) declaration: TokenStream,
    sound: Sound,
}

impl Declared {
    fn new(declaration: TokenStream) -> Self {
        let mut tokens = declaration.clone().into_iter();
        let is_struct = |token: &TokenTree| matches!(token, TokenTree::Ident(word) if word == "struct");
        assert!(
            tokens.any(|token| is_struct(&token)),
            "a declaration declares a structure"
        );
        Self {
            name: tokens.next().expect("it has a name").to_string(),
            sound: sound(declaration.clone()),
            declaration,
        }
    }

    pub(crate) fn solvers(&self, passes: Passes) -> Solvers {
        self.sound.solvers(passes)
    }

    /// The cost from the position to the snap, with a single iteration of Newton's method.
    pub(crate) fn cost(&self, passes: Passes) -> Cost {
        self.solvers(passes).motion.cost()
    }
}

/// The mechanisms of the library, in the order of its files.
pub(crate) fn library() -> Vec<Declared> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../kin-core/src/library");
    let mut paths: Vec<_> = fs::read_dir(folder)
        .expect("there is a library")
        .map(|entry| entry.expect("it can be read").path())
        .collect();
    paths.sort_unstable();
    let mut library = Vec::new();
    for path in paths {
        let text = fs::read_to_string(path).expect("it is text");
        for item in syn::parse_file(&text).expect("it is Rust").items {
            if let syn::Item::Macro(item) = item
                && item
                    .mac
                    .path
                    .segments
                    .last()
                    .is_some_and(|last| last.ident == "mechanism")
            {
                library.push(Declared::new(item.mac.tokens));
            }
        }
    }
    library
}
