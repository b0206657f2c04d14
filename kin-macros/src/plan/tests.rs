use proc_macro2::TokenStream;
use quote::quote;

use crate::passes::{Pass, Passes};
use crate::testing::{declarations, sound};

fn four_bar(order: usize) -> TokenStream {
    let order = proc_macro2::Literal::usize_unsuffixed(order);
    let declaration = declarations::four_bar();
    quote! {
        #declaration
        order = #order;
    }
}

/// The architecture shows what link vectors save for the four-bar linkage, from the position through each order.
#[test]
fn the_table_of_link_vectors_is_up_to_date() {
    let book = include_str!("../../../docs/architecture.md");
    for (name, passes) in [
        ("link vectors", Passes::ALL),
        ("Leibniz's rule", Passes::without(Pass::LinkVectors)),
    ] {
        let cells: Vec<String> = (1..=4)
            .map(|order| {
                sound(four_bar(order))
                    .solvers(passes)
                    .motion
                    .cost()
                    .arithmetic()
                    .to_string()
            })
            .collect();
        let row = format!("| {name} | {} |", cells.join(" | "));
        assert!(
            book.lines().any(|line| line == row),
            "docs/architecture.md should say\n{row}"
        );
    }
}
