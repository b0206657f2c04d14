//! The picture: joints and links from the vector equations.
//!
//! Each side of such an equation is a chain of links that begins at the origin. The partial sums of its terms are the
//! joints. Like the closure, the terms are translated from the syntax tree.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote, quote_spanned};

use super::formula::{Translated, Translation, constant};
use super::names::{bindings, names, pattern, used_names};
use super::vector_type;
use crate::model::{Dimension, Model, Shape};
use crate::precedence::Precedence;
use crate::syntax::{Declaration, Formula, FormulaKind, Operand, Operator, OutputStatement, Statement};

/// The largest number of abbreviations that are written out on one side of an equation.
const WRITTEN_OUT: usize = 256;

/// One side of a vector equation.
struct Chain<'a> {
    equation: usize,
    shape: Shape,
    side: &'a Formula,
    links: Vec<Link<'a>>,
}

/// A term of the sum.
struct Link<'a> {
    negative: bool,
    term: &'a Formula,
}

/// The method `skeleton`; nothing if there is nothing to draw.
///
/// `pose` is the name of the method's pose of any order, `argument` the whole argument.
pub(crate) fn tokens(
    declaration: &Declaration,
    model: &Model,
    runtime: &TokenStream,
    (pose, argument): &(Ident, TokenStream),
) -> TokenStream {
    let chains = chains(declaration, model, runtime);
    let points: Vec<&OutputStatement> = declaration
        .statements
        .iter()
        .filter_map(|statement| match statement {
            Statement::Output(output) if matches!(output.dimension, Dimension::Point | Dimension::Point3) => {
                Some(output)
            }
            _ => None,
        })
        .collect();
    if chains.is_empty() && points.is_empty() {
        return TokenStream::new();
    }

    // a plane chain beside a chain in space lies in the plane of x and y
    let shape = if chains.iter().any(|chain| chain.shape == Shape::Space)
        || points.iter().any(|output| output.dimension == Dimension::Point3)
    {
        Shape::Space
    } else {
        Shape::Plane
    };
    let kind = vector_type(shape);
    let terms = chains.iter().flat_map(|chain| &chain.links).map(|link| link.term);
    let used = used_names(declaration, terms.chain(points.iter().map(|output| &output.value)));
    let mut names = names(model);
    let mut body = values_of_pose(model, pose, &used);
    body.extend(bindings(declaration, runtime, &used, &mut names));
    let translation = Translation { names: &names, runtime };

    let mut joints: Vec<Ident> = Vec::new();
    for chain in &chains {
        let mut last: Option<Ident> = None;
        let mut add = |joints: &mut Vec<Ident>, last: &mut Option<Ident>, value: &TokenStream| {
            let joint = format_ident!("joint_{}", joints.len(), span = Span::mixed_site());
            body.extend(quote!(let #joint: #runtime::#kind<T> = #value;));
            joints.push(joint.clone());
            *last = Some(joint);
        };
        add(&mut joints, &mut last, &quote!(#runtime::#kind::zero()));
        for (place, link) in chain.links.iter().enumerate() {
            let term = on(&translation, translation.formula(link.term), shape);
            let value = match (&last, place, link.negative) {
                (Some(last), 1.., negative) => {
                    let operator = if negative { quote!(-) } else { quote!(+) };
                    let term = term.within(Precedence::Product);
                    quote!(#last #operator #term)
                }
                (_, _, true) => {
                    let term = term.within(Precedence::Atom);
                    quote!(-#term)
                }
                (_, _, false) => term.tokens,
            };
            add(&mut joints, &mut last, &value);
        }
    }
    let places = points
        .iter()
        .map(|output| on(&translation, translation.formula(&output.value), shape).tokens);
    let labels = points.iter().map(|output| output.name.to_string());
    let [joint_count, point_count] = [joints.len(), points.len()].map(Literal::usize_unsuffixed);
    let tables = chains.iter().map(|chain| {
        let (side, equation) = (chain.side.to_string(), Literal::usize_unsuffixed(chain.equation));
        let links = chain.links.iter().map(Link::text);
        quote!(#runtime::Chain { name: #side, equation: #equation, links: &[#(#links),*] })
    });
    let lines = documentation(&chains, &points);
    let ignored = used.is_empty().then(|| quote!(let _ = #pose;));
    // `self` must have the hygiene of the translation
    quote_spanned! {Span::mixed_site()=>
            /// The joints and links of a pose of any order, as polylines from the origin, and its points.
            ///
            #(#[doc = #lines])*
            #[must_use]
            pub fn skeleton(
                &self,
                #argument,
            ) -> #runtime::Skeleton<#runtime::#kind<T>, #joint_count, #point_count> {
                #ignored
                #body
                #runtime::Skeleton::new(&[#(#tables),*], [#(#joints),*], &[#(#labels),*], [#(#places),*])
            }
    }
}

/// A term as a vector of the picture's shape.
fn on(translation: &Translation<'_>, term: Translated, shape: Shape) -> Translated {
    if (term.shape, shape) != (Shape::Plane, Shape::Space) {
        return translation.lifted(term, shape);
    }
    let (runtime, tokens, zero) = (translation.runtime, term.tokens, constant(0.0));
    let plane = Ident::new("plane", Span::mixed_site());
    let lifted = quote!({ let #plane = #tokens; #runtime::Space::new(#plane.x, #plane.y, #zero) });
    Translated::new(shape, lifted)
}

/// `let` for the used inputs and unknowns.
fn values_of_pose(model: &Model, pose: &Ident, used: &BTreeSet<String>) -> TokenStream {
    let inputs: Vec<&Ident> = model.inputs.iter().map(|input| &input.name).collect();
    let unknowns: Vec<&Ident> = model.unknowns.iter().map(|unknown| &unknown.name).collect();
    let mut body = TokenStream::new();
    for (names, method) in [(inputs, "input_values"), (unknowns, "unknowns")] {
        if names.iter().any(|name| used.contains(&name.to_string())) {
            let (pattern, method) = (pattern(names.into_iter(), used), Ident::new(method, Span::mixed_site()));
            body.extend(quote!(let #pattern = #pose.#method();));
        }
    }
    body
}

/// The lines of the method's documentation.
fn documentation(chains: &[Chain<'_>], points: &[&OutputStatement]) -> Vec<String> {
    let chains = chains.iter().map(|chain| format!(" - `{}`", chain.side));
    let points = points.iter().map(|output| format!(" - point `{}`", output.name));
    chains.chain(points).collect()
}

/// The sides of all vector equations, except those that are zero.
fn chains<'a>(declaration: &'a Declaration, model: &Model, runtime: &TokenStream) -> Vec<Chain<'a>> {
    let sums = sums(declaration, model, runtime);
    let equations = declaration.statements.iter().filter_map(|statement| match statement {
        Statement::Equation(equation) => Some(equation),
        _ => None,
    });
    let mut chains = Vec::new();
    for (number, (equation, declared)) in equations.zip(&model.equations).enumerate() {
        let shape = declared.residual.shape();
        if !matches!(shape, Shape::Plane | Shape::Space) {
            continue;
        }
        for side in [&equation.left, &equation.right] {
            let mut terms = Terms {
                sums: &sums,
                left: WRITTEN_OUT,
                links: Vec::new(),
            };
            terms.add(side, false);
            if !terms.links.is_empty() {
                chains.push(Chain {
                    equation: number,
                    shape,
                    side,
                    links: terms.links,
                });
            }
        }
    }
    chains
}

/// The abbreviations of vectors that are sums, by name.
fn sums<'a>(declaration: &'a Declaration, model: &Model, runtime: &TokenStream) -> BTreeMap<String, &'a Formula> {
    let all = declaration
        .statements
        .iter()
        .filter_map(|statement| match statement {
            Statement::Let(statement) => Some(statement.name.to_string()),
            _ => None,
        })
        .collect();
    let mut names = names(model);
    bindings(declaration, runtime, &all, &mut names);
    let mut sums = BTreeMap::new();
    for statement in &declaration.statements {
        if let Statement::Let(statement) = statement {
            let word = statement.name.to_string();
            if names.get(&word).is_some_and(|value| value.shape != Shape::Scalar) && is_sum(&statement.value, &sums) {
                sums.insert(word, &statement.value);
            }
        }
    }
    sums
}

fn is_sum(formula: &Formula, sums: &BTreeMap<String, &Formula>) -> bool {
    match &formula.kind {
        FormulaKind::Parenthesis(inner) | FormulaKind::Negate(inner) => is_sum(inner, sums),
        FormulaKind::Sum { .. } => true,
        FormulaKind::Name(name) => sums.contains_key(&name.to_string()),
        _ => false,
    }
}

/// Collects the terms of a sum, through parentheses, signs and abbreviations.
struct Terms<'a, 'b> {
    /// The abbreviations that are sums themselves.
    sums: &'b BTreeMap<String, &'a Formula>,
    /// The number of abbreviations that may still be written out: the number of terms can double with each of them.
    left: usize,
    links: Vec<Link<'a>>,
}

impl<'a> Terms<'a, '_> {
    fn add(&mut self, formula: &'a Formula, negative: bool) {
        match &formula.kind {
            FormulaKind::Parenthesis(inner) => self.add(inner, negative),
            FormulaKind::Negate(inner) => self.add(inner, !negative),
            FormulaKind::Sum { first, rest } => {
                self.add(first, negative);
                for Operand {
                    operator,
                    formula: operand,
                    ..
                } in rest
                {
                    self.add(operand, negative != (*operator == Operator::Subtract));
                }
            }
            FormulaKind::Number { value: 0.0, .. } => {}
            FormulaKind::Name(name) => match self.sums.get(&name.to_string()) {
                Some(sum) if self.left > 0 => {
                    self.left -= 1;
                    self.add(sum, negative);
                }
                _ => self.link(formula, negative),
            },
            _ => self.link(formula, negative),
        }
    }

    fn link(&mut self, term: &'a Formula, negative: bool) {
        self.links.push(Link { negative, term });
    }
}

impl Link<'_> {
    /// The term with its sign.
    fn text(&self) -> String {
        let term = self.term.to_string();
        match (self.negative, term.starts_with('-')) {
            (false, _) => term,
            (true, false) => format!("-{term}"),
            (true, true) => format!("-({term})"),
        }
    }
}

#[cfg(test)]
#[allow(clippy::needless_pass_by_value, reason = "formulas are quoted where they are passed")]
mod tests {
    use quote::ToTokens;

    use super::*;
    use crate::expand::expand;

    /// The links of all chains, with the names in the expansion.
    fn links(statements: TokenStream) -> Vec<Vec<String>> {
        let expansion = expand(quote! {
            struct M { a: Length, b: Length, p: Point }
            input t: Angle;
            #statements
            output used: Vector = p + a + b;
        })
        .to_string();
        let Ok(expansion) = syn::parse_str::<TokenStream>(&expansion) else {
            return Vec::new();
        };
        let expansion = expansion.to_token_stream().to_string();
        expansion
            .split("links : & [")
            .skip(1)
            .map(|rest| {
                let list = rest.split_once(']').map_or("", |(list, _)| list);
                list.split(" , ")
                    .map(|text| text.trim().trim_matches('"').to_owned())
                    .collect()
            })
            .collect()
    }

    #[test]
    fn every_term_is_a_link() {
        assert_eq!(
            links(quote! {
                unknown u: Angle, v: Angle;
                a * cis(t) + b * cis(u) == p - a * cis(v);
            }),
            [vec!["a * cis(t)", "b * cis(u)"], vec!["p", "-a * cis(v)"]]
        );
    }

    #[test]
    fn terms_are_found_behind_signs_parentheses_and_abbreviations() {
        assert_eq!(
            links(quote! {
                unknown u: Angle, v: Angle;
                let pin = p - (a * cis(t) - b);
                let rod = b * cis(u);
                let reach = a + b;
                -(-pin - rod) + -(-a * cis(v)) - reach == 0;
            }),
            [vec!["p", "-a * cis(t)", "b", "rod", "-(-a * cis(v))", "-reach"]]
        );
    }

    #[test]
    fn scalar_equations_are_no_picture() {
        assert!(
            links(quote! {
                unknown u: Length;
                u == a * t;
            })
            .is_empty()
        );
    }
}
