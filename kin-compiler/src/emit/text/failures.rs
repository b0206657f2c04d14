//! Failures while a position is solved, with the block and the inputs.

use proc_macro2::TokenStream;
use quote::quote;

use super::super::compiled::Compiled;

impl Compiled<'_> {
    /// `.map_err(…)?` with the unknowns of a part, and the inputs.
    pub(in crate::emit) fn failed(&self, part: usize) -> TokenStream {
        self.failed_at(&self.part_name(part))
    }

    /// `.map_err(…)?` with all unknowns of a part's block, which is singular as a whole.
    pub(in crate::emit) fn failed_together(&self, part: usize) -> TokenStream {
        let mut before = 0;
        let block = self.blocks.iter().find(|block| {
            before += block.parts.len();
            part < before
        });
        block.map_or_else(
            || self.failed(part),
            |block| self.failed_at(&self.names(&block.unknowns)),
        )
    }

    /// `.map_err(…)?` with given names instead of a block.
    pub(in crate::emit) fn failed_at(&self, place: &str) -> TokenStream {
        let inputs = self.input_names();
        let failure = self.own("failure");
        quote!(.map_err(|#failure| self.__failed(#failure, #place, #(#inputs),*))?)
    }
}
