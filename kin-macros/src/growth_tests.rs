//! How the expansion grows: with the number of loops, and with the order.

use std::time::Instant;

use proc_macro2::{TokenStream, TokenTree};
use quote::{format_ident, quote};

use crate::expand::expand;
use crate::expr::LOOKUPS;

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

/// Expressions looked up and tokens written for a chain of each length: both follow a straight line.
#[test]
fn a_chain_takes_work_in_proportion_to_its_loops() {
    let work: Vec<[usize; 2]> = (1..=16)
        .map(|loops| {
            let before = LOOKUPS.get();
            let tokens = count_tokens(expand(chain(loops)));
            [LOOKUPS.get() - before, tokens]
        })
        .collect();
    for (loops, [lookups, tokens]) in (1..).zip(&work) {
        println!("{loops:2} loops: {lookups:7} expressions looked up, {tokens:6} tokens");
    }
    // the first loop is driven by an input, the others by an unknown; up to six choices all assemblies are listed
    for (kind, first) in [(0, 2), (1, 7)] {
        let each = work[first][kind] - work[first - 1][kind];
        for loops in first..16 {
            let more = work[loops][kind] - work[loops - 1][kind];
            assert!(
                more.abs_diff(each) * 20 <= each,
                "loop {} takes {more}, one before it {each}",
                loops + 1
            );
        }
    }
}

/// All tokens, those within groups included.
fn count_tokens(tokens: TokenStream) -> usize {
    tokens
        .into_iter()
        .map(|token| match token {
            TokenTree::Group(group) => 1 + count_tokens(group.stream()),
            _ => 1,
        })
        .sum()
}

/// How long expansions take: `cargo test -p kin-macros times -- --ignored --nocapture`. Nothing is asserted of it.
#[test]
#[ignore = "prints times"]
fn times() {
    let mut cases = vec![("six coupled unknowns".to_owned(), coupled())];
    cases.extend([4, 6, 8, 10].map(|order| (format!("four-bar to order {order}"), four_bar(order))));
    cases.extend([1, 2, 4, 8, 16].map(|loops| (format!("chain of {loops}"), chain(loops))));
    for (name, declaration) in cases {
        let start = Instant::now();
        let length = expand(declaration).to_string().len();
        let time = start.elapsed().as_secs_f64() * 1e3;
        println!("{name:22} {time:9.1} ms, {length:7} characters");
    }
}
