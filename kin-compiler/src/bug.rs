//! The handling of panics: a panic during an expansion becomes an error that asks for a bug report.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use proc_macro2::{Span, TokenStream};

use crate::expand::expand;
use crate::mistakes::Mistakes;
use crate::{fallback, syntax};

/// The expansion of a declaration of `mechanism!`, after the path of `kin_core` in parentheses. A panic is reported as
/// a bug, at the declaration.
#[must_use]
pub fn expand_or_tell(tokens: TokenStream) -> TokenStream {
    or_tell(tokens, expand)
}

/// The message about a panic.
pub(crate) fn bug(panic: &(dyn Any + Send)) -> String {
    let words = panic.downcast_ref::<&str>().copied();
    let words = words.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    format!(
        "this is a bug in kin: please report it with this declaration{}",
        words.map(|words| format!(" ({words})")).unwrap_or_default()
    )
}

/// Calls `expand`, and reports its panic.
fn or_tell(tokens: TokenStream, expand: impl FnOnce(TokenStream) -> TokenStream) -> TokenStream {
    let copy = tokens.clone();
    // no state survives that a panic may have left inconsistent
    catch_unwind(AssertUnwindSafe(|| expand(copy))).unwrap_or_else(|panic| {
        let bug = bug(&*panic);
        let read = catch_unwind(AssertUnwindSafe(|| {
            let (runtime, tokens) = syntax::runtime(tokens);
            let mut mistakes = Mistakes::new();
            let declaration = syntax::parse(tokens, &mut mistakes);
            match &declaration {
                Some(declaration) => mistakes.error(&declaration.name, &bug),
                None => mistakes.error_at(Span::call_site(), &bug),
            }
            fallback::tokens(declaration.as_ref(), mistakes, &runtime)
        }));
        read.unwrap_or_else(|_| syn::Error::new(Span::call_site(), bug).to_compile_error())
    })
}

#[cfg(test)]
mod tests {
    use quote::quote;

    use super::*;
    use crate::room::with_room;

    /// A panic is reported as a bug of the macro, and the structure stays.
    #[test]
    fn a_panic_is_reported_and_leaves_the_structure() {
        let declaration = quote! {
            ($crate)
            pub struct Lever { pub arm: Length }
            input theta: Angle;
            unknown height: Length;
            height == arm * sin(theta);
        };
        let at_once: fn(TokenStream) -> TokenStream = |_| panic!("at {} steps", 3);
        let elsewhere: fn(TokenStream) -> TokenStream = |tokens| {
            with_room::<()>(|| panic!("at {} steps", 3));
            tokens
        };
        for panic in [at_once, elsewhere] {
            let expansion = or_tell(declaration.clone(), panic).to_string();
            assert!(
                expansion.contains("this is a bug in kin: please report it with this declaration (at 3 steps)"),
                "{expansion}"
            );
            assert!(expansion.contains("pub struct Lever"), "{expansion}");
        }
        // mistakes in the declaration are reported too, even if it has no readable structure
        let expansion = or_tell(
            quote!(
                struct Lever {
                    arm: Lenght,
                }
            ),
            |_| panic!("here"),
        )
        .to_string();
        // the first one is repeated in a type
        assert_eq!(expansion.matches("compile_error").count(), 3, "{expansion}");
        let expansion = or_tell(quote!(height == arm;), |_| std::panic::panic_any(3)).to_string();
        assert!(expansion.contains("with this declaration\""), "{expansion}");
    }

    #[test]
    fn without_a_panic_nothing_is_reported() {
        let declaration = quote!(height == arm;);
        let mut expected = TokenStream::new();
        expected.extend(declaration.clone());
        assert_eq!(or_tell(declaration, |tokens| tokens).to_string(), expected.to_string());
    }
}
