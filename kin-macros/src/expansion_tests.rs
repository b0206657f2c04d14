//! What declarations expand to, held in snapshots: whoever changes the generated code sees what changes for its readers.

use proc_macro2::TokenStream;
use quote::quote;

use crate::expand::expand;

/// The expansion as `cargo expand` would show it.
fn pretty(declaration: &TokenStream) -> String {
    let tokens = expand(quote!((::kin_core) #declaration));
    let file = syn::parse2(tokens).expect("an expansion is a list of items");
    prettyplease::unparse(&file)
}

fn four_bar() -> TokenStream {
    quote! {
        /// Planar four-bar linkage.
        pub struct FourBar {
            /// Ground.
            pub r1: Length,
            pub r2: Length,
            pub r3: Length,
            pub r4: Length,
        }
        input theta2: Angle;
        unknown theta3: Angle, theta4: Angle;
        r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    }
}

#[test]
fn four_bar_expansion() {
    insta::assert_snapshot!(pretty(&four_bar()));
}

/// The same declaration gives the same bytes.
#[test]
fn expansion_is_deterministic() {
    assert_eq!(pretty(&four_bar()), pretty(&four_bar()));
}
