//! Declarations with too large or too small numbers, or that are too deep or too long. Each ends in an expansion or in
//! a reported mistake, never in a panic.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use crate::expand::{expand, solved};
use crate::mistakes::Mistakes;

/// The mistakes of a declaration. One without mistakes is expanded.
fn mistakes(declaration: TokenStream) -> Vec<String> {
    let mut mistakes = Mistakes::new();
    if let (_, Some(_)) = solved(declaration.clone(), &mut mistakes) {
        let _ = expand(declaration);
    }
    mistakes.into_messages()
}

/// Constants that do not fit an `f64`, as typed, after folding, or as a consequence of the solution.
#[test]
fn constants_fit_or_are_reported_once() {
    for (equation, expected) in [
        (quote!(x * 1e-320 == a * t), "this number is too small"),
        (quote!(x == a * t / 1e-320), "this number is too small"),
        (quote!(x == a * t / 1e-400), "this number is too small"),
        (quote!(x == 1e400 * a * t), "this number is too large"),
        (
            quote!(x == 1e308 * a * t * 10 + 1e308 * a),
            "a constant in this formula is too large",
        ),
        (
            quote!(x == 1e308 * a * t + 1e308 * a * t),
            "a constant in this formula is too large",
        ),
        (
            quote!(x == 1e-300 * a * t / 1e10),
            "a constant in this formula is too small",
        ),
        (
            quote!(x == powi(1e-200 * t, 2) * a),
            "a constant in this formula is too small",
        ),
        (
            quote!(x == exp(-1000) * a * t),
            "a constant in this formula is too small",
        ),
        (quote!(x == a * t * tan(PI / 2)), "outside the domain of `tan`"),
        (
            quote!(x * 1e-200 == a * t * 1e200),
            "constants that follow from this one are too large",
        ),
        (
            quote!(powi(x * 1e-200 + a, 2) == a * a * t),
            "constants that follow from this one are too small",
        ),
        (
            quote!(x == a * sin(1e-200 * t)),
            "constants that follow from this one are too small",
        ),
    ] {
        let messages = mistakes(quote! {
            struct M { a: Length }
            input t: Scalar;
            unknown x: Length;
            #equation;
        });
        assert_eq!(messages.len(), 1, "{equation}: {messages:?}");
        assert!(messages[0].contains(expected), "{equation}: {messages:?}");
    }
}

/// Constants as far from 1 as is allowed.
#[test]
fn extreme_constants_that_fit_are_no_mistakes() {
    for equation in [
        quote!(x * 1e-150 == a * t * 1e150),
        quote!(x == a * t * 2.3e-308),
        quote!(x == a * t * 1.7e308),
        quote!(x == a * t * 0.0e-400 + a),
    ] {
        let messages = mistakes(quote! {
            struct M { a: Length }
            input t: Scalar;
            unknown x: Length;
            #equation;
            output y: Length = a * t;
        });
        assert_eq!(messages, Vec::<String>::new(), "{equation}");
    }
}

/// A declaration whose length or depth is a number.
type Family = fn(usize) -> TokenStream;

fn sum(terms: usize) -> TokenStream {
    let names: Vec<_> = (0..terms).map(|index| format_ident!("a{index}")).collect();
    quote! {
        struct M { #(#names: Length),* }
        input t: Scalar;
        unknown x: Length;
        x == 0 #(+ #names * t)*;
    }
}

fn product(factors: usize) -> TokenStream {
    let names: Vec<_> = (0..factors).map(|index| format_ident!("a{index}")).collect();
    quote! {
        struct M { #(#names: Scalar),* }
        input t: Scalar;
        unknown x: Scalar;
        x == t #(* #names)*;
    }
}

fn power(exponent: usize) -> TokenStream {
    let factors = vec![quote!(*t); exponent];
    quote! {
        struct M { a: Scalar }
        input t: Scalar;
        unknown x: Scalar;
        x == a #(#factors)*;
    }
}

/// Abbreviations of abbreviations.
fn abbreviations(count: usize) -> TokenStream {
    let names: Vec<_> = (0..count).map(|index| format_ident!("y{index}")).collect();
    let before = [format_ident!("t")].into_iter().chain(names.clone());
    let last = names.last();
    quote! {
        struct M { a: Scalar }
        input t: Scalar;
        unknown x: Scalar;
        #(let #names = sin(#before);)*
        x == a * #last;
    }
}

/// Blocks that are solved one after another.
fn blocks(count: usize) -> TokenStream {
    let names: Vec<_> = (0..count).map(|index| format_ident!("y{index}")).collect();
    let before = [format_ident!("t")].into_iter().chain(names.clone());
    quote! {
        struct M { a: Scalar }
        input t: Scalar;
        unknown #(#names: Scalar),*;
        #(#names == a + #before;)*
    }
}

fn sines(depth: usize) -> TokenStream {
    let nested = (0..depth).fold(quote!(t), |inner, _| quote!(sin(#inner)));
    quote! {
        struct M { a: Scalar }
        input t: Scalar;
        unknown x: Scalar;
        x == a * #nested;
    }
}

fn methods(count: usize) -> TokenStream {
    let methods = vec![quote!(.sin()); count];
    quote! {
        struct M { a: Scalar }
        input t: Scalar;
        unknown x: Scalar;
        x == a * t #(#methods)*;
    }
}

fn signs(count: usize) -> TokenStream {
    let signs = vec![quote!(-); count];
    quote! {
        struct M { a: Scalar }
        input t: Scalar;
        unknown x: Scalar;
        x == a * #(#signs)* t;
    }
}

fn parentheses(count: usize) -> TokenStream {
    let nested = (0..count).fold(quote!(t), |inner, _| quote!((#inner)));
    quote! {
        struct M { a: Scalar }
        input t: Scalar;
        unknown x: Scalar;
        x == a * #nested;
    }
}

/// Each part of a sum contains the whole previous sum twice.
fn doublings(count: usize) -> TokenStream {
    let names: Vec<_> = (0..count).map(|index| format_ident!("y{index}")).collect();
    let before: Vec<_> = [format_ident!("first")].into_iter().chain(names.clone()).collect();
    let before = &before[..count];
    let last = names.last();
    quote! {
        struct M { a: Length }
        input t: Angle;
        unknown x: Length, y: Length;
        let first = a * cis(t);
        #(let #names = #before + #before;)*
        vec2(x, y) == #last;
    }
}

fn messages_of(family: Family, size: usize, order: usize) -> Vec<String> {
    let (declaration, order) = (family(size), Literal::usize_unsuffixed(order));
    mistakes(quote!(#declaration order = #order;))
}

/// The declarations are expanded on the stack of a test, which is one fourth of the compiler's.
#[test]
fn what_is_long_or_as_deep_as_it_may_be_is_expanded() {
    let families: [(Family, usize); 10] = [
        (sum, 2000),
        (product, 1000),
        (power, 1024),
        (abbreviations, 500),
        (blocks, 1000),
        // within a product
        (sines, 255),
        (methods, 255),
        (signs, 255),
        (parentheses, 255),
        (doublings, 30),
    ];
    for (family, size) in families {
        assert_eq!(messages_of(family, size, 1), Vec::<String>::new());
    }
}

/// Declarations as long as the compiler accepts, and longer: `cargo test -p kin-compiler as_long -- --ignored`.
#[test]
#[ignore = "takes a minute"]
fn what_is_as_long_as_the_compiler_takes_it_is_expanded() {
    let families: [(Family, usize, usize); 6] = [
        (sum, 9000, 1),
        (product, 5000, 1),
        (power, 1024, 4),
        (abbreviations, 2000, 1),
        (abbreviations, 200, 4),
        (blocks, 5000, 4),
    ];
    for (family, size, order) in families {
        assert_eq!(messages_of(family, size, order), Vec::<String>::new());
    }
}

#[test]
fn what_is_too_deep_or_too_long_is_reported_once() {
    let deep = "this is nested more than 256 deep";
    let families: [(Family, usize, &str); 10] = [
        (sines, 256, deep),
        (sines, 5000, deep),
        (methods, 256, deep),
        (methods, 5000, deep),
        (signs, 256, deep),
        (signs, 5000, deep),
        (parentheses, 256, deep),
        (parentheses, 100_000, deep),
        (power, 1100, "1024 is the largest"),
        (abbreviations, 10_001, "a chain of more than 10000 operations"),
    ];
    for (family, size, message) in families {
        let messages = messages_of(family, size, 4);
        assert_eq!(messages.len(), 1, "{message}: {messages:?}");
        assert!(messages[0].contains(message), "{messages:?}");
    }
}

/// The compiler follows a derived comparison by recursion, field by field.
#[test]
fn no_structure_of_many_fields_derives_its_comparison() {
    let [sum, sines] = [(sum as Family, 400), (abbreviations, 400)].map(|(family, size)| {
        let declaration = family(size);
        let items = expand(quote!(#declaration order = 1;));
        syn::parse2::<syn::File>(items).expect("the expansion is Rust").items
    });
    let structures = [sum, sines].into_iter().flatten().filter_map(|item| match item {
        syn::Item::Struct(structure) => Some(structure),
        _ => None,
    });
    let mut large = 0;
    for structure in structures.filter(|structure| structure.fields.len() > 256) {
        large += 1;
        let attributes = structure.attrs.iter().map(|attribute| quote!(#attribute).to_string());
        assert!(
            !attributes.into_iter().any(|text| text.contains("PartialEq")),
            "{}",
            structure.ident
        );
    }
    // the parameters of the one, and the position of the other
    assert_eq!(large, 2);
}

/// An unknown that cancels is reported as such, whatever follows from it: no constants, and no counts of equations.
#[test]
fn unknowns_that_cancel_are_reported_once() {
    let vectors = quote!(struct A { a: Vector3, l: Length } input t: Angle; unknown u: Angle;);
    let numbers = quote!(struct A { a: Scalar } input t: Scalar; unknown u: Scalar;);
    let two = quote!(struct A { a: Length } input t: Scalar; unknown u: Angle, y: Length;);
    let unity = quote!((sin(u) * sin(u) + cos(u) * cos(u)));
    for declaration in [
        // a vector that is rotated about itself
        quote!(#vectors norm(rot(a, u) * a - rot_z(t) * vec3(l, 0, 0)) == l;),
        quote!(#vectors dot(rot(a, u) * a, rot_z(t) * vec3(l, 0, 0)) == l * l;),
        quote!(#numbers a * #unity == a * t;),
        quote!(#numbers sqrt(#unity) == a * t;),
        quote!(#numbers exp(a - u) * exp(u) == t;),
        quote!(#two norm(a * cis(u)) + y == a * t; y == a * t * t;),
        quote!(#two a * #unity + y == a * t; y * y == a * a * t;),
        quote!(#two norm(a * cis(u)) + y * y / a == a * t; y * norm(a * cis(u)) == a * a;),
    ] {
        let messages = mistakes(declaration.clone());
        assert_eq!(
            messages,
            ["unknown `u` cancels out of every equation: nothing determines it"],
            "{declaration}"
        );
    }
    let messages = mistakes(quote!(#numbers a * #unity == a * t; u == t;));
    assert_eq!(
        messages,
        ["every unknown cancels out of this equation, so it determines none: remove it"]
    );
    // small numbers do not cancel
    let small = quote!(#numbers 1e-13 * a * u + 1e-14 * sin(u) == t;);
    assert_eq!(mistakes(small), Vec::<String>::new());
}
