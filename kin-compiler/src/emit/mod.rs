//! Model and program to Rust. This pass cannot fail.

mod bindings;
mod compiled;
pub(crate) mod declaration;
mod equality;
mod items;
mod sheet;
mod text;

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::formulas::Formulas;
use crate::model::{Model, Request, ValueShape};
use crate::program::Solvers;
use crate::structure::Block;
use crate::syntax::Declaration;
use crate::translate::sheets;
pub(crate) use compiled::pose_name;
use compiled::{Compiled, local};
use items::{
    assembly, batch, description, every, formulas, interface, internal, outputs, page, picture, poses, position,
    prepared::PreparedValues, readable, residuals, sensitivities, solve, stored, test, track, transmission, values,
};
use sheet::SheetText;

/// The whole expansion of a declaration.
pub(crate) fn tokens(
    declaration: &Declaration,
    model: &Model,
    blocks: &[Block],
    solvers: &Solvers,
    formulas: &Formulas,
    runtime: &TokenStream,
) -> TokenStream {
    let alias = alias(&model.name.to_string());
    let outside = &Compiled {
        model,
        blocks,
        solvers,
        formulas,
        runtime,
    };
    let inside = &Compiled {
        runtime: &quote!(#alias),
        ..*outside
    };
    let structures = [
        declaration::tokens(model, &page::lines(outside), runtime),
        assembly::structure(outside),
        poses::structures(outside),
        batch::structure(outside),
        sensitivities::structures(outside),
    ];
    let (sheets, text) = (
        sheets(declaration, model),
        SheetText::new(declaration, model, inside.runtime),
    );
    let picture = picture::tokens(&text, &sheets, &values::argument(inside));
    let prepared = PreparedValues::of(inside);
    let prepared = prepared.as_ref();
    let constants = [
        assembly::list(inside),
        description::tokens(inside),
        sensitivities::cost(inside),
        formulas::inherent(inside),
        every::tokens(inside),
    ];
    let methods = [
        solve::tokens(inside),
        residuals::tokens(&text, &sheets.closure),
        position::tokens(inside, prepared),
        assembly::tokens(inside),
        track::tokens(inside),
        sensitivities::method(inside),
        transmission::tokens(inside),
        picture.method,
    ];
    let mut internals = vec![position::internal(inside, prepared)];
    internals.extend(prepared.map(PreparedValues::internal));
    internals.extend(solve::internal(inside));
    internals.extend(assembly::internal(inside));
    let of_f64: Vec<_> = every::internal(inside).into_iter().collect();
    let internals = internal::tokens(inside, &internals, &of_f64);
    let further = [
        poses::tokens(inside),
        values::tokens(inside),
        interface::tokens(
            inside,
            prepared,
            &picture.items,
            &outputs::tokens(&text, &sheets.outputs),
        ),
        sensitivities::tokens(inside),
        batch::tokens(inside),
        stored::tokens(inside),
        readable::tokens(inside),
        assembly::methods(inside),
        every::absence(inside),
    ];
    let name = &model.name;
    let prepared = prepared.map(PreparedValues::structure);
    let implementations = quote! {
        #prepared

        impl #name<::core::primitive::f64> {
            #(#constants)*
        }

        impl<T: #alias::Scalar> #name<T> {
            #(#methods)*
        }

        #internals

        #(#further)*
    };
    // test functions inside other items do not run
    let test = if outside.is_requested(Request::Test) {
        test::tokens(outside)
    } else {
        TokenStream::new()
    };
    let bindings = bindings::imports(implementations.clone(), runtime);
    // a separate scope, so that short names meet no others
    quote! {
        #(#structures)*
        #[allow(dead_code, deprecated, non_snake_case, unused_imports)]
        #[allow(clippy::all, clippy::pedantic, clippy::nursery)]
        const _: () = {
            use #runtime as #alias;
            use #alias::methods::*;
            #bindings
            #implementations
        };
        #test
    }
}

/// The vector type of a shape; `None` for a scalar or a rotation.
pub(crate) fn vector_type(shape: ValueShape) -> Option<Ident> {
    let name = match shape {
        ValueShape::Plane => "Plane",
        ValueShape::Space => "Space",
        ValueShape::Scalar | ValueShape::Rotation => return None,
    };
    Some(Ident::new(name, Span::mixed_site()))
}

/// The name of the runtime within the expansion, different from the name of the mechanism.
fn alias(mechanism: &str) -> Ident {
    local(if mechanism == "kin" { "runtime" } else { "kin" })
}
