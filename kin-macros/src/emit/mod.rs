//! Model and program to Rust. Nothing here can fail.

mod bindings;
pub(crate) mod declaration;
mod items;
mod mechanism;
mod source;
mod text;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::model::{Model, Request};
use crate::program::Solvers;
use crate::structure::Block;
use crate::syntax::Declaration;
use items::{
    assembly, batch, description, every, interface, poses, position, rates, sensitivities, solve, test, track,
    transmission, values,
};
use mechanism::{Mechanism, local};
use source::skeleton;

/// Everything that a declaration expands to.
pub(crate) fn tokens(
    declaration: &Declaration,
    model: &Model,
    blocks: &[Block],
    solvers: &Solvers,
    runtime: &TokenStream,
) -> TokenStream {
    let alias = alias(&model.name.to_string());
    let outside = &Mechanism {
        declaration,
        model,
        blocks,
        solvers,
        runtime,
    };
    let inside = &Mechanism {
        runtime: &quote!(#alias),
        ..*outside
    };
    let structures = [
        declaration::tokens(model, runtime),
        assembly::structure(outside),
        poses::structures(outside),
        batch::structure(outside),
        sensitivities::structures(outside),
    ];
    let implementations = [
        assembly::tokens(inside),
        description::tokens(inside),
        solve::tokens(inside),
        position::tokens(inside),
        every::tokens(inside),
        track::tokens(inside),
        poses::tokens(inside),
        rates::tokens(inside),
        sensitivities::tokens(inside),
        interface::tokens(inside),
        batch::tokens(inside),
        values::tokens(inside),
        skeleton::tokens(inside),
        transmission::tokens(inside),
    ];
    // test functions inside of other items do not run
    let test = if outside.is_requested(Request::Test) {
        test::tokens(outside)
    } else {
        TokenStream::new()
    };
    let bindings = bindings::imports(&implementations, runtime);
    // a scope of its own, so that short names meet no others
    quote! {
        #(#structures)*
        #[allow(deprecated)]
        const _: () = {
            use #runtime as #alias;
            #bindings
            #(#implementations)*
        };
        #test
    }
}

/// What the runtime is called within the expansion: anything but what the mechanism is called.
fn alias(mechanism: &str) -> Ident {
    local(if mechanism == "kin" { "runtime" } else { "kin" })
}
