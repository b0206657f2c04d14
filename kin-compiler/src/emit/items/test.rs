//! The test that `with test;` requests: it verifies the mechanism with random dimensions and motions.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::compiled::Compiled;

/// The test, as an item outside the scope of the mechanism: test functions inside other items do not run.
pub(in crate::emit) fn tokens(mechanism: &Compiled<'_>) -> TokenStream {
    function(&mechanism.model.name, mechanism.runtime)
}

/// A call of a macro of the runtime, which reports a missing feature.
fn function(mechanism: &Ident, runtime: &TokenStream) -> TokenStream {
    let name = format_ident!(
        "{}_verifies",
        snake_case(&mechanism.to_string()),
        span = mechanism.span()
    );
    quote! {
        #[cfg(test)]
        #[allow(deprecated, clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
        #[test]
        fn #name() {
            #runtime::assert_verified!(#mechanism<::core::primitive::f64>);
        }
    }
}

/// `FourBar` as `four_bar`, `RSSRLinkage` as `rssr_linkage`.
fn snake_case(name: &str) -> String {
    let letters: Vec<char> = name.trim_start_matches("r#").chars().collect();
    let mut snake = String::new();
    for (index, &letter) in letters.iter().enumerate() {
        if letter == '_' {
            continue;
        }
        let before = index.checked_sub(1).map(|index| letters[index]);
        let starts_word = match before {
            None => false,
            Some('_') => true,
            Some(before) if letter.is_uppercase() => {
                let ends_capitals = letters.get(index + 1).is_some_and(|after| after.is_lowercase());
                !before.is_uppercase() || ends_capitals
            }
            Some(_) => false,
        };
        // an underscore is never doubled, and comes first only if it does in the name
        if starts_word && !snake.ends_with('_') {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}

#[cfg(test)]
mod tests {
    use super::{function, snake_case};
    use quote::{format_ident, quote};

    #[test]
    fn names() {
        for (name, expected) in [
            ("FourBar", "four_bar"),
            ("Whitworth", "whitworth"),
            ("RSSR", "rssr"),
            ("RSSRLinkage", "rssr_linkage"),
            ("LinkageRSSR", "linkage_rssr"),
            ("FourBar2", "four_bar2"),
            ("FourBar2D", "four_bar2_d"),
            ("Four_Bar", "four_bar"),
            ("four__bar", "four_bar"),
            ("_FourBar", "_four_bar"),
            ("Trailing_", "trailing"),
            ("r#FourBar", "four_bar"),
            ("Übertrieb", "übertrieb"),
            ("_0", "_0"),
        ] {
            assert_eq!(snake_case(name), expected);
        }
    }

    /// rustc's lint on names allows no capital and no double underscore.
    #[test]
    fn no_name_meets_the_lint() {
        for name in ["FourBar", "A__B", "__A", "ABCd_E", "_", "__", "A_1__b2C"] {
            let test = format!("{}_verifies", snake_case(name));
            assert!(!test.chars().any(char::is_uppercase), "{test}");
            assert!(!test.contains("__"), "{test}");
        }
    }

    #[test]
    fn the_test_is_an_item_that_calls_the_runtime() {
        let tokens = function(&format_ident!("FourBar"), &quote!($crate::__private));
        let file = quote! {
            #[cfg(test)]
            #[allow(deprecated, clippy::all, clippy::pedantic, clippy::nursery, clippy::restriction)]
            #[test]
            fn four_bar_verifies() {
                $crate::__private::assert_verified!(FourBar<::core::primitive::f64>);
            }
        };
        assert_eq!(tokens.to_string(), file.to_string());
        let tokens = function(&format_ident!("FourBar"), &quote!(::kin_core::__private));
        let item: syn::ItemFn = syn::parse2(tokens).expect("it is a function");
        assert_eq!(item.sig.ident, "four_bar_verifies");
    }
}
