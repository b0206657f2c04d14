//! The picture: which joints belong together, from the vector equations or from statements, and where they are.
//!
//! Like the closure, the joints are translated from the syntax tree.

mod closures;
mod groups;
mod names;
mod outline;
mod statements;
mod terms;
mod turning;

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream, TokenTree};
use quote::{format_ident, quote, quote_spanned};

use super::formula::{Translated, Translation, constant};
use super::names::{behind_abbreviations, bindings, rows, used_names};
use super::vector_type;
use crate::model::{Dimension, Model, ValueShape};
use crate::precedence::Precedence;
use crate::syntax::{Declaration, EquationStatement, OutputStatement, Statement};
use names::SkeletonNames;
use outline::Outline;

/// The generated items of the picture.
pub(crate) struct Picture {
    /// The method `skeleton`, nothing if nothing can be drawn.
    pub(crate) method: TokenStream,
    /// The items that the trait of all mechanisms requires.
    pub(crate) items: TokenStream,
}

/// The picture of a declaration.
///
/// `pose` is the name of the pose of any order that the method takes, `argument` the whole argument.
pub(crate) fn tokens(
    declaration: &Declaration,
    model: &Model,
    runtime: &TokenStream,
    (pose, argument): &(Ident, TokenStream),
) -> Picture {
    let names = SkeletonNames::new(declaration, model, runtime);
    let outline = outline(declaration, model, &names);
    let kind = vector_type(outline.shape);
    let count = Literal::usize_unsuffixed(outline.shown.len() + outline.slides.len());
    let [inputs, unknowns] = [model.inputs.len(), model.unknowns.len()].map(Literal::usize_unsuffixed);
    let (table, body) = (table(&outline, runtime), body(declaration, model, &outline, runtime));
    let places = quote!([#runtime::#kind<T>; #count]);
    let site = Span::mixed_site();
    let items = quote_spanned! {site=>
        type Places = #places;
        const OUTLINE: #runtime::Outline = #table;
        fn places(&self, inputs: [T; #inputs], unknowns: [T; #unknowns]) -> #places {
            #body
        }
    };
    if outline.shown.is_empty() {
        let method = TokenStream::new();
        return Picture { method, items };
    }
    let lines = documentation(&outline);
    let method = quote_spanned! {site=>
        /// The joints of a pose of any order, and the bodies between them.
        ///
        #(#[doc = #lines])*
        #[must_use]
        pub fn skeleton(&self, #argument) -> #runtime::Skeleton<#places> {
            #runtime::Mechanism::skeleton(self, #pose)
        }
    };
    Picture { method, items }
}

fn outline<'a>(declaration: &'a Declaration, model: &Model, names: &SkeletonNames<'a>) -> Outline<'a> {
    let equations = declaration.statements.iter().filter_map(|statement| match statement {
        Statement::Equation(equation) => Some(equation),
        _ => None,
    });
    let (equations, shapes): (Vec<&EquationStatement>, Vec<ValueShape>) = equations
        .zip(&model.equations)
        .map(|(equation, declared)| (equation, declared.residual.shape()))
        .filter(|(_, shape)| matches!(shape, ValueShape::Plane | ValueShape::Space))
        .unzip();
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
    if let Some(outline) = statements::outline(declaration, &points, names) {
        return outline;
    }
    // a plane chain beside one of space lies in the plane of x and y
    let spatial =
        shapes.contains(&ValueShape::Space) || points.iter().any(|output| output.dimension == Dimension::Point3);
    let shape = if spatial { ValueShape::Space } else { ValueShape::Plane };
    closures::outline(&equations, &points, shape, names)
}

/// The constant `OUTLINE`.
fn table(outline: &Outline<'_>, runtime: &TokenStream) -> TokenStream {
    let list = |joints: &[usize]| {
        let joints = joints.iter().map(|&joint| Literal::usize_unsuffixed(joint));
        quote!(&[#(#joints),*])
    };
    let ground = list(&outline.ground);
    let bodies = outline.bodies.iter().map(|body| {
        let (name, joints) = (&body.name, list(&body.joints));
        quote!(#runtime::Body::new(#name, #joints))
    });
    let slides = outline.slides.iter().map(|slide| {
        let joint = Literal::usize_unsuffixed(slide.joint);
        if let Some(body) = slide.guide.map(Literal::usize_unsuffixed) {
            quote!(#runtime::Slide::on_body(#joint, #body))
        } else {
            quote!(#runtime::Slide::on_ground(#joint))
        }
    });
    let points = outline.points.iter().map(|(name, joint)| {
        let joint = Literal::usize_unsuffixed(*joint);
        quote!((#name, #joint))
    });
    quote! {
        #runtime::Outline {
            ground: #ground,
            bodies: &[#(#bodies),*],
            slides: &[#(#slides),*],
            points: &[#(#points),*],
        }
    }
}

/// The joints that are shown, and the directions of the slides behind them.
fn body(declaration: &Declaration, model: &Model, outline: &Outline<'_>, runtime: &TokenStream) -> TokenStream {
    let mut needed: BTreeSet<usize> = BTreeSet::new();
    for &joint in &outline.shown {
        let mut next = Some(joint);
        while let Some(joint) = next {
            needed.insert(joint);
            next = outline.joints[joint].before;
        }
    }
    let terms = needed.iter().filter_map(|&joint| outline.joints[joint].term);
    let mut used = used_names(declaration, terms.map(|term| term.formula));
    for slide in &outline.slides {
        identifiers(slide.direction.clone(), &mut used);
    }
    let used = behind_abbreviations(declaration, used);
    let mut translated = super::names::names(model);
    let mut body = rows(model, &used);
    body.extend(bindings(declaration, runtime, &used, &mut translated));
    let translation = Translation {
        names: &translated,
        runtime,
    };
    let (shape, kind) = (outline.shape, vector_type(outline.shape));
    let site = Span::mixed_site();
    let local = |joint: usize| format_ident!("joint_{joint}", span = site);
    for &joint in &needed {
        let (name, known) = (local(joint), &outline.joints[joint]);
        let value = match (known.before.map(local), known.term) {
            (_, None) => quote!(#runtime::#kind::zero()),
            (before, Some(term)) => {
                let value = in_picture(&translation, translation.formula(term.formula), shape);
                match (before, term.negative) {
                    (Some(before), negative) => {
                        let operator = if negative { quote!(-) } else { quote!(+) };
                        let value = value.within(Precedence::Product);
                        quote!(#before #operator #value)
                    }
                    (None, true) => {
                        let value = value.within(Precedence::Atom);
                        quote!(-#value)
                    }
                    (None, false) => value.tokens,
                }
            }
        };
        body.extend(quote!(let #name: #runtime::#kind<T> = #value;));
    }
    let joints = outline.shown.iter().map(|&joint| local(joint));
    let directions = outline.slides.iter().map(|slide| &slide.direction);
    quote!(#body [#(#joints,)* #(#directions),*])
}

/// A term as a vector of the shape of the whole picture.
fn in_picture(translation: &Translation<'_>, term: Translated, shape: ValueShape) -> Translated {
    if (term.shape, shape) != (ValueShape::Plane, ValueShape::Space) {
        return translation.lifted(term, shape);
    }
    let (runtime, tokens, zero) = (translation.runtime, term.tokens, constant(0.0));
    let plane = Ident::new("plane", Span::mixed_site());
    let lifted = quote!({ let #plane = #tokens; #runtime::Space::new(#plane.x, #plane.y, #zero) });
    Translated::new(shape, lifted)
}

/// The identifiers in tokens.
fn identifiers(tokens: TokenStream, found: &mut BTreeSet<String>) {
    for token in tokens {
        match token {
            TokenTree::Ident(name) => {
                found.insert(name.to_string());
            }
            TokenTree::Group(group) => identifiers(group.stream(), found),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

/// The lists in the method's documentation.
fn documentation(outline: &Outline<'_>) -> Vec<String> {
    let bodies = outline.bodies.iter().map(|body| format!(" - body `{}`", body.name));
    let points = outline.points.iter().map(|(name, _)| format!(" - point `{name}`"));
    bodies.chain(points).collect()
}

#[cfg(test)]
mod tests;
