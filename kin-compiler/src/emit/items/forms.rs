//! The forms of the blocks, with the lengths of their links.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::algebra::Symbol;
use crate::emit::compiled::{Compiled, local};
use crate::emit::text::ProgramText;
use crate::program::{Component, FormLengths, Lengths};
use crate::structure::BlockKind;

/// The row of the blocks and the method `block_forms` of the trait.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    let Lengths { forms, program } = &mechanism.solvers.lengths;
    let (text, stage) = (ProgramText::of(mechanism, program), &program.stages[0]);
    let (readings, body) = (text.readings(stage, &[]), text.plain_steps(stage));
    let component = |component: Component| text.component(component);
    let length = |[x, y]: [Component; 2]| match [x, y] {
        [x, Component::Number(0.0)] => component(x),
        [Component::Number(0.0), y] => component(y),
        [x, y] => {
            let (x, y) = (component(x), component(y));
            quote!(#runtime::length(#x, #y))
        }
    };
    let forms: Vec<TokenStream> = forms.iter().map(|form| written(mechanism, form, &length)).collect();
    let count = Literal::usize_unsuffixed(forms.len());
    quote! {
        type Blocks<Element: ::core::marker::Copy> = [Element; #count];

        fn block_forms(&self) -> [#runtime::BlockForm<T>; #count] {
            #readings
            #body
            [#(#forms),*]
        }
    }
}

fn written(
    mechanism: &Compiled<'_>,
    form: &FormLengths,
    length: &dyn Fn([Component; 2]) -> TokenStream,
) -> TokenStream {
    let runtime = mechanism.runtime;
    let Some(driver) = form.driver else {
        let constructor = |name: &str| {
            let name = local(name);
            let lengths = form.lengths.iter().map(|parts| {
                if let Some(parts) = parts {
                    let length = length(*parts);
                    quote!(::core::option::Option::Some(#length))
                } else {
                    quote!(::core::option::Option::None)
                }
            });
            quote!(#runtime::BlockForm::#name(#(#lengths),*))
        };
        return match form.kind {
            BlockKind::TwoLinks => constructor("two_links"),
            BlockKind::LinkAndSlider => constructor("link_and_slider"),
            BlockKind::SliderOnLink => constructor("slider_on_link"),
            kind => {
                let name = local(&format!("{kind:?}"));
                quote!(#runtime::BlockForm::#name)
            }
        };
    };
    let name = local(match form.kind {
        BlockKind::SliderCrank => "slider_crank",
        BlockKind::InvertedSliderCrank => "inverted_slider_crank",
        _ => "four_bar",
    });
    let driver = match driver {
        Symbol::Input(index) => mechanism.model.inputs[index].name.to_string(),
        Symbol::Unknown(index) => mechanism.model.unknowns[index].name.to_string(),
        _ => unreachable!("only inputs and unknowns move"),
    };
    let lengths = form.lengths.iter().flatten().map(|parts| length(*parts));
    quote!(#runtime::BlockForm::#name(#driver, [#(#lengths),*]))
}
