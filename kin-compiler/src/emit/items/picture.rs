//! The picture of a mechanism: its parts as a constant, and its joints.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{quote, quote_spanned};

use crate::emit::sheet::SheetText;
use crate::emit::vector_type;
use crate::translate::tree::{Outline, Sheets};

/// The generated items of the picture.
pub(in crate::emit) struct Picture {
    /// The method `skeleton`, nothing if nothing can be drawn.
    pub(in crate::emit) method: TokenStream,
    /// The items that the trait of all mechanisms requires.
    pub(in crate::emit) items: TokenStream,
}

/// The picture of a declaration.
///
/// `pose` is the name of the pose of any order that the method takes, `argument` the whole argument.
pub(in crate::emit) fn tokens(
    text: &SheetText<'_>,
    sheets: &Sheets,
    (pose, argument): &(Ident, TokenStream),
) -> Picture {
    let Sheets {
        outline,
        skeleton_points,
        ..
    } = sheets;
    let runtime = text.runtime;
    let kind = vector_type(outline.shape);
    let counts = [
        text.model.inputs.len(),
        text.model.unknowns.len(),
        skeleton_points.results.len(),
    ];
    let [inputs, unknowns, count] = counts.map(Literal::usize_unsuffixed);
    let (rows, bindings, results) = (
        text.rows(skeleton_points),
        text.bindings(skeleton_points),
        text.results(skeleton_points),
    );
    let (joints, directions) = results.split_at(outline.joints);
    let table = table(outline, runtime);
    let points = quote!([#runtime::#kind<T>; #count]);
    let site = Span::mixed_site();
    let items = quote_spanned! {site=>
        type SkeletonPoints = #points;
        const OUTLINE: #runtime::Outline = #table;
        fn skeleton_points(&self, inputs: [T; #inputs], unknowns: [T; #unknowns]) -> #points {
            #rows
            #bindings
            [#(#joints,)* #(#directions),*]
        }
    };
    if outline.joints == 0 {
        let method = TokenStream::new();
        return Picture { method, items };
    }
    let lines = documentation(outline);
    let method = quote_spanned! {site=>
        /// The joints of a pose of any order, and the bodies between them.
        ///
        #(#[doc = #lines])*
        #[must_use]
        pub fn skeleton(&self, #argument) -> #runtime::Skeleton<#points> {
            #runtime::Mechanism::skeleton(self, #pose)
        }
    };
    Picture { method, items }
}

/// The constant `OUTLINE`.
fn table(outline: &Outline, runtime: &TokenStream) -> TokenStream {
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
    let scalar_equations = &outline.scalar_equations;
    let guess = if let Some(statements) = &outline.guess {
        quote!(::core::option::Option::Some(#statements))
    } else {
        quote!(::core::option::Option::None)
    };
    quote! {
        #runtime::Outline {
            ground: #ground,
            bodies: &[#(#bodies),*],
            slides: &[#(#slides),*],
            points: &[#(#points),*],
            scalar_equations: &[#(#scalar_equations),*],
            guess: #guess,
        }
    }
}

/// The lists in the method's documentation.
fn documentation(outline: &Outline) -> Vec<String> {
    let bodies = outline.bodies.iter().map(|body| format!(" - body `{}`", body.name));
    let points = outline.points.iter().map(|(name, _)| format!(" - point `{name}`"));
    bodies.chain(points).collect()
}
