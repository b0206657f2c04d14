use proc_macro2::TokenStream;
use quote::quote;

use super::Task;
use super::forms::{Derived, forms};
use super::guards::unguarded_divisors;
use crate::algebra::{Graph, Node, Symbol};
use crate::derive::{Influences, TooLarge};
use crate::passes::{Pass, Passes};
use crate::program::{Stage, Step};
use crate::testing::{declarations, sound};

fn four_bar(order: usize) -> TokenStream {
    let order = proc_macro2::Literal::usize_unsuffixed(order);
    let declaration = declarations::four_bar();
    quote! {
        #declaration
        order = #order;
    }
}

/// The table in the chapter on the macro: the savings of link vectors for the four-bar linkage, order by order.
#[test]
fn the_table_of_link_vectors_is_up_to_date() {
    let book = include_str!("../../../docs/macro.md");
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
        assert!(book.lines().any(|line| line == row), "docs/macro.md should say\n{row}");
    }
}

/// Both forms of the equations are tried if they differ, and an excluded form is not tried.
#[test]
fn forms_are_tried_if_they_differ_and_are_included() {
    let same = sound(declarations::four_bar());
    assert_eq!(forms(&same.task(Passes::ALL)).len(), 1);
    let different = sound(quote! {
        struct Squares { a: Length }
        input t: Length;
        unknown x: Scalar;
        (t + a) * (t - a) == x * a * a;
    });
    let tried = |passes: Passes| -> Vec<Vec<_>> {
        let forms = forms(&different.task(passes));
        forms.into_iter().map(|form| form.formulas.residuals).collect()
    };
    let both = tried(Passes::ALL);
    assert_eq!(both.len(), 2);
    assert_eq!(tried(Passes::without(Pass::ProductsLeft)), both[..1]);
    assert_eq!(tried(Passes::without(Pass::MultipliedOut)), both[1..]);
}

/// Exactly as many expressions are derived as are allowed.
#[test]
fn the_limit_of_expressions_is_exact() {
    let declaration = four_bar(3);
    let solvable = sound(quote!(#declaration with sensitivities;));
    let derived = |most_expressions: usize| {
        let task = Task {
            most_expressions,
            ..solvable.task(Passes::ALL)
        };
        let form = forms(&task).swap_remove(0);
        let mut derived = Derived::new(&task, form, Influences::Separate)?;
        let rates = derived.graph.len();
        let form_task = derived.form.task(&task, derived.influences);
        let parameters = task.parameters;
        derived
            .derivatives
            .sensitivities(&mut derived.graph, form_task, parameters)?;
        Ok((rates, derived.graph.len()))
    };
    let (rates, all) = derived(usize::MAX).expect("there is no limit");
    assert!(rates < all);
    assert_eq!(derived(all), Ok((rates, all)));
    assert_eq!(derived(all - 1), Err(TooLarge { order: 3 }));
    // the rates fit, but the partial derivatives of the position do not
    assert_eq!(derived(rates), Err(TooLarge { order: 0 }));
    assert_eq!(derived(rates - 1), Err(TooLarge { order: 3 }));
}

/// An unused result of a closed form has no name, so that the compiler does not warn about it.
#[test]
fn results_that_nothing_needs_have_no_name() {
    let declared = sound(four_bar(1));
    for (passes, names) in [(Passes::ALL, 4), (Passes::without(Pass::InvertedRoots), 2)] {
        let solvers = declared.solvers(passes);
        let results = solvers.motion.stages[0].steps.iter().find_map(|step| match step {
            Step::Solve { results, .. } => Some(results.clone()),
            _ => None,
        });
        // both components of a vector; and four times the area with its square, which give the inverse of the
        // determinant
        let named = results.expect("it has a closed form").iter().flatten().count();
        assert_eq!(named, names, "{passes:?}");
    }
}

/// A length that may be negative costs a change of its sign, and of both components of the vector that it reverses.
#[test]
fn a_negative_length_turns_its_vector_round() {
    let position = |declaration: TokenStream| sound(declaration).solvers(Passes::ALL).motion.stages[0].cost;
    let positive = position(declarations::inverted_slider_crank());
    let either = position(quote! {
        struct Lever { r1: Length, r2: Length }
        input theta2: Angle;
        unknown r4: Length, theta4: Angle;
        r1 + r2 * cis(theta2) == r4 * cis(theta4);
    });
    assert_eq!(either.negations, positive.negations + 3);
}

/// A form that was given up for size is recorded.
#[test]
fn forms_that_are_given_up_are_reported() {
    let is_reported = |declaration: TokenStream| sound(declaration).solvers(Passes::ALL).is_form_given_up;
    assert!(!is_reported(four_bar(1)));
    assert!(is_reported(quote! {
        struct Power { a: Length }
        order = 1;
        input t: Length, s: Length, r: Length, q: Length, p: Length, o: Length;
        unknown x: Scalar;
        x == powi((t + s + r + q + p + o) / a, 8);
    }));
}

/// The position tests the divisors of later stages, unless they are known to be nonzero.
#[test]
fn divisors_of_later_stages_are_guarded_in_the_position() {
    let mut graph = Graph::new();
    let steps: Vec<(Symbol, Node)> = (0..9)
        .map(|value| (Symbol::Value(value), graph.symbol(Symbol::Value(value))))
        .collect();
    let [a, b, c, d] = [0, 1, 2, 3].map(|index| steps[index].1);
    let length = graph.symbol(Symbol::Unknown(0));
    let one = graph.one();
    let mut divided = |symbol: usize, divisors: &[Node]| {
        let factors: Vec<(Node, i32)> = divisors.iter().map(|&divisor| (divisor, -1)).collect();
        let quotient = graph.product(&factors);
        Step::Define {
            symbol: steps[symbol].0,
            value: graph.add(quotient, one),
        }
    };
    let stages = [
        Stage::new(vec![divided(5, &[a])]),
        Stage::new(vec![divided(6, &[a, b, length])]),
        Stage::new(vec![divided(7, &[c, d])]),
    ];
    let product = graph.product(&[(b, 1), (c, 2)]);
    let (scaled, sum) = (graph.scale(-3.0, product), graph.add(b, c));
    let scaled_symbol = graph.scale(2.0, d);
    for (guaranteed, unguarded) in [
        (vec![], vec![b, c, d]),
        (vec![c], vec![b, d]),
        (vec![product], vec![d]),
        (vec![scaled], vec![d]),
        (vec![scaled, scaled_symbol], vec![]),
        // a nonzero sum says nothing about its terms
        (vec![sum], vec![b, c, d]),
    ] {
        assert_eq!(
            unguarded_divisors(&graph, &stages, &guaranteed),
            unguarded,
            "{guaranteed:?}"
        );
    }
}
