//! How the expansion grows: with the number of loops, and with the order.

use std::time::Instant;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::expand::expand;

/// Four-bar linkages in series: the rocker of each is the crank of the next.
fn chain(loops: usize) -> TokenStream {
    let name = format_ident!("Chain{loops}");
    let (mut fields, mut unknowns, mut equations) = (TokenStream::new(), TokenStream::new(), TokenStream::new());
    let (mut crank, mut angle) = (format_ident!("crank"), format_ident!("theta"));
    for index in 1..=loops {
        let [ground, coupler, rocker, phi, psi] =
            ["ground", "coupler", "rocker", "phi", "psi"].map(|name| format_ident!("{name}_{index}"));
        fields.extend(quote!(#ground: Length, #coupler: Length, #rocker: Length,));
        unknowns.extend(quote!(unknown #phi: Angle, #psi: Angle;));
        equations.extend(quote!(
            #crank * cis(#angle) + #coupler * cis(#phi) == #ground + #rocker * cis(#psi);
        ));
        (crank, angle) = (rocker, psi);
    }
    quote! {
        struct #name { crank: Length, #fields }
        input theta: Angle;
        #unknowns
        #equations
    }
}

/// A four-bar linkage to a given order.
fn four_bar(order: usize) -> TokenStream {
    let order = proc_macro2::Literal::usize_unsuffixed(order);
    quote! {
        struct FourBar { r1: Length, r2: Length, r3: Length, r4: Length }
        input theta2: Angle;
        unknown theta3: Angle, theta4: Angle;
        r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
        order = #order;
    }
}

/// Six unknown angles in one block.
fn coupled() -> TokenStream {
    quote! {
        struct SixCoupled { side: Length, leg: Length, tie: Length, radius: Length }
        input theta: Angle;
        unknown a: Angle, b: Angle, c: Angle, d: Angle, e: Angle, f: Angle;
        let first = polar(radius, 0) + leg * cis(a);
        let second = polar(radius, 2 * PI / 3) + leg * cis(b);
        let third = polar(radius, 4 * PI / 3) + leg * cis(c);
        first + side * cis(d) + tie * cis(e) == second;
        second + side * cis(e) + tie * cis(f) == third;
        third + side * cis(f) + tie * cis(d + theta) == first;
    }
}

/// How long expansions take: `cargo test -p kin-macros times -- --ignored --nocapture`. Nothing is asserted of it.
#[test]
#[ignore = "prints times"]
fn times() {
    let mut cases = vec![("six coupled unknowns".to_owned(), coupled())];
    cases.extend([4, 6, 8, 10].map(|order| (format!("four-bar to order {order}"), four_bar(order))));
    cases.extend([1, 2, 4, 8, 16].map(|loops| (format!("chain of {loops}"), chain(loops))));
    let only = std::env::var("ONLY").unwrap_or_default();
    for (name, declaration) in cases.into_iter().filter(|(name, _)| only.is_empty() || *name == only) {
        let start = Instant::now();
        let length = expand(declaration).to_string().len();
        let time = start.elapsed().as_secs_f64() * 1e3;
        println!("{name:22} {time:9.1} ms, {length:7} characters");
    }
}
