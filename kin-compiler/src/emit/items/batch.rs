//! The solution of many poses in one call.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::emit::compiled::{Compiled, attributes, local};
use crate::emit::equality::Equality;
use crate::program::order_name;

/// The structure of columns: `FourBarBatch`.
fn type_name(mechanism: &Compiled<'_>) -> Ident {
    format_ident!("{}Batch", mechanism.model.name, span = mechanism.model.name.span())
}

/// The motions of many poses, with a column for each number.
pub(in crate::emit) fn structure(mechanism: &Compiled<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let (structure, attributes, visibility) = (type_name(mechanism), attributes(), &model.visibility);
    let length = Literal::usize_unsuffixed(mechanism.order() + 1);
    let summary = format!(
        " The motions of many poses of [`{}`], with a column instead of each number.",
        model.name
    );
    let inputs = model
        .inputs
        .iter()
        .map(|input| (&input.name, quote!(#runtime::Motion<Column, #length>)));
    let unknowns = model.unknowns.iter().enumerate().map(|(index, unknown)| {
        (
            &unknown.name,
            mechanism.unknown_type(index, mechanism.order(), &quote!(Column)),
        )
    });
    let outputs = model.outputs.iter().map(|output| {
        let kind = mechanism.output_type(output.value.shape(), &quote!(Column));
        (&output.name, quote!(#runtime::Motion<#kind, #length>))
    });
    let fields: Vec<(&Ident, TokenStream)> = inputs.chain(unknowns).chain(outputs).collect();
    let names: Vec<&Ident> = fields.iter().map(|&(name, _)| name).collect();
    let Equality { derived, implemented } = Equality::of(&structure, &format_ident!("Column"), &names);
    let derived = derived.into_iter();
    let fields = fields.iter().map(|(name, kind)| {
        let line = format!(" As in [`{}`].", mechanism.pose(mechanism.order()));
        quote! {
            #[doc = #line]
            pub #name: #kind
        }
    });
    quote! {
        #[doc = #summary]
        #[derive(::core::clone::Clone, ::core::fmt::Debug #(, #derived)*)]
        #attributes
        #visibility struct #structure<Column> {
            #(#fields,)*
        }

        #implemented
    }
}

/// `batch`, for constant parameters and for columns of parameters, and the function that fills the structure.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let methods = methods(mechanism);
    let columns = columns(mechanism);
    quote!(#methods #columns)
}

fn methods(mechanism: &Compiled<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let name = &model.name;
    let inputs = mechanism.input_names();
    let length = Literal::usize_unsuffixed(mechanism.order() + 1);
    let near = mechanism.fresh("near");
    let value = mechanism.type_parameter("Value");
    let same = quote!(#name<#value::Element>);
    let columns = quote!(#runtime::batch::Column<'a, #value::Element>);
    let in_assembly = |kind: TokenStream| quote!(#runtime::batch::InAssembly<#kind>);
    let (choice, chosen, new, guide) = if mechanism.is_coupled() {
        let count = Literal::usize_unsuffixed(model.unknowns.len());
        let near_columns = quote!([#columns; #count]);
        let guide = quote!(#runtime::batch::Nearest<#near_columns>);
        (quote!(#near: #near_columns,), quote!(#near), local("near"), guide)
    } else if mechanism.choices().is_empty() {
        (TokenStream::new(), quote!(()), local("new"), in_assembly(quote!(())))
    } else {
        let (argument, value) = (mechanism.assembly_argument(), mechanism.assembly_value());
        let kind = mechanism.assembly_type();
        (quote!(#argument,), value, local("new"), in_assembly(quote!(#kind)))
    };
    let summary = format!(
        " Position and all time derivatives to {} of many poses.",
        order_name(mechanism.order())
    );
    let scalars: Vec<TokenStream> = mechanism
        .scalar_parameters()
        .into_iter()
        .map(|(_, value, ..)| value)
        .collect();
    quote! {
        impl<#value: #runtime::batch::Parameter> #name<#value> {
            #[doc = #summary]
            ///
            /// Each parameter and input is one number for all poses, or a column with one number for each pose. `solve`
            /// of the batch stores the motions, `fold` summarises them.
            #[inline]
            pub fn batch<'a>(
                &'a self,
                #(#inputs: #runtime::Motion<#columns, #length>,)*
                #choice
            ) -> #runtime::batch::Batch<'a, #same, #guide> {
                #runtime::batch::Batch::#new([#(#scalars.column()),*], [#(#inputs),*], #chosen)
            }
        }
    }
}

fn columns(mechanism: &Compiled<'_>) -> TokenStream {
    let (runtime, model) = (mechanism.runtime, mechanism.model);
    let structure = type_name(mechanism);
    let [fill, visitor] = ["fill", "visitor"].map(|name| mechanism.fresh(name));
    let inputs = model.inputs.iter().map(|input| &input.name);
    let unknowns = model.unknowns.iter().map(|unknown| &unknown.name);
    let outputs = model.outputs.iter().map(|output| &output.name);
    let fields: Vec<_> = inputs.chain(unknowns).chain(outputs).collect();
    let firsts = (0..model.inputs.len())
        .chain(0..model.unknowns.len())
        .chain(mechanism.output_parts().into_iter().map(|parts| parts[0]))
        .map(Literal::usize_unsuffixed);
    let kinds = [
        ("Input", model.inputs.len()),
        ("Unknown", model.unknowns.len()),
        ("Output", model.outputs.len()),
    ];
    let kinds = kinds
        .into_iter()
        .flat_map(|(kind, count)| std::iter::repeat_n(local(kind), count));
    quote! {
        impl<Column> #structure<Column> {
            /// Columns made by a function: vectors that a batch fills, or nothing for numbers that are not needed.
            pub fn filled(mut #fill: impl ::core::ops::FnMut() -> Column) -> Self {
                Self {
                    #(#fields: #runtime::batch::MotionColumns::filled(&mut #fill)),*
                }
            }
        }
        impl<Column> #runtime::batch::Columns<Column> for #structure<Column> {
            #[inline(always)]
            fn each<'a>(&'a mut self, #visitor: &mut impl #runtime::batch::Visitor<'a, Column>)
            where
                Column: 'a,
            {
                #(
                    self.#fields.each(#firsts, #runtime::batch::Slot::#kinds, #visitor);
                )*
            }
        }
    }
}
