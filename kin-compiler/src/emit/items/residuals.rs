//! The residuals of the equations, for verification.

use proc_macro2::{Literal, Span, TokenStream};
use quote::quote_spanned;

use crate::emit::sheet::{SheetText, pattern, used};
use crate::model::{Model, ValueShape};
use crate::translate::tree::Sheet;

/// The method `closure`.
pub(in crate::emit) fn tokens(text: &SheetText<'_>, sheet: &Sheet) -> TokenStream {
    let model = text.model;
    let site = Span::mixed_site();
    let [used_inputs, used_unknowns] = used(sheet);
    let unknowns = pattern(model.unknowns.iter().map(|unknown| &unknown.name), &used_unknowns);
    let unused = model.inputs.iter().enumerate();
    let unused = unused.filter(|(index, _)| !used_inputs.contains(index));
    let unused = unused.map(|(_, input)| &input.name);
    let (bindings, residuals) = (text.bindings(sheet), text.results(sheet));
    let inputs = model.inputs.iter().map(|input| &input.name);
    let unknown_count = Literal::usize_unsuffixed(model.unknowns.len());
    let residual_count = Literal::usize_unsuffixed(sheet.results.len());
    let documentation = documentation(model);
    quote_spanned! {site=>
        #(#[doc = #documentation])*
        #[must_use]
        pub fn closure(&self, #(#inputs: T,)* #unknowns: [T; #unknown_count]) -> [T; #residual_count] {
            #(let _ = #unused;)*
            #bindings
            [#(#residuals),*]
        }
    }
}

/// The summary, and a line for each equation, as a paragraph.
fn documentation(model: &Model) -> Vec<String> {
    let order: Vec<String> = model.unknowns.iter().map(|unknown| unknown.name.to_string()).collect();
    let summary = format!(
        " The residuals of the equations, left side minus right side, for the unknowns `[{}]`. \
         All are zero at a position of the mechanism.",
        order.join(", ")
    );
    let mut lines = vec![summary, " ".to_owned()];
    let mut index = 0;
    for equation in &model.equations {
        let text = &equation.text;
        lines.push(match equation.residual.shape() {
            ValueShape::Plane => format!(" - `[{index}]` and `[{}]`: x and y of `{text}`", index + 1),
            ValueShape::Space => format!(
                " - `[{index}]`, `[{}]` and `[{}]`: x, y and z of `{text}`",
                index + 1,
                index + 2
            ),
            _ => format!(" - `[{index}]`: `{text}`"),
        });
        index += equation.residual.nodes().len();
    }
    lines
}

#[cfg(test)]
#[allow(clippy::needless_pass_by_value, reason = "formulas are quoted where they are passed")]
mod tests {
    use quote::quote;

    use super::*;
    use crate::mistakes::Mistakes;
    use crate::model;
    use crate::syntax;
    use crate::translate::sheets;

    /// The method after its arguments.
    fn body(statements: TokenStream) -> String {
        let method = method(statements);
        method[method.find("-> [").unwrap_or_default()..].to_owned()
    }

    fn method(statements: TokenStream) -> String {
        let mut mistakes = Mistakes::new();
        let tokens = quote! {
            struct M { a: Length, b: Length, k: Scalar, p: Point }
            #statements
            output all: Vector = k * (p + a + b);
        };
        let declaration = syntax::parse(tokens, &mut mistakes);
        let model = declaration
            .as_ref()
            .and_then(|declaration| model::build(declaration, &mut mistakes));
        let (Some(declaration), Some(model)) = (declaration, model) else {
            panic!("{:?}", mistakes.into_messages());
        };
        let sheet = sheets(&declaration, &model).closure;
        super::tokens(&SheetText::new(&declaration, &model, &quote!(rt)), &sheet).to_string()
    }

    #[test]
    fn powers_are_those_of_the_number_type() {
        let powers = |n: TokenStream| body(quote!(input t: Angle; unknown e: Scalar; powi(e - 1, #n) == t;));
        assert_eq!(
            powers(quote!(5)),
            "-> [T ; 1] { [(e - T :: constant (1.0)) . powi (5) - t] }"
        );
        assert_eq!(
            powers(quote!(-6)),
            "-> [T ; 1] { [(e - T :: constant (1.0)) . powi (- 6) - t] }"
        );
    }

    #[test]
    fn parentheses_stand_where_they_are_needed() {
        assert_eq!(
            body(quote!(input t: Angle; unknown e: Length; ((a)) - (b - e) * -(t) == -(-(a)) / (k * k);)),
            "-> [T ; 1] { [self . a - (self . b - e) * - t - - (- self . a) / (self . k * self . k)] }"
        );
    }

    #[test]
    fn scalars_beside_vectors_lie_along_x() {
        assert_eq!(
            body(quote! {
                input t: Angle; unknown e: Angle; unknown l: Length;
                let wheel = b * cis(e) / 2;
                let idle = p.x * t;
                p * cis(t) - a == wheel + l;
                output q: Length = idle;
            }),
            "-> [T ; 2] { let wheel = rt :: Plane :: scale (rt :: Plane :: polar (self . b , e) , \
             T :: constant (1.0) / T :: constant (2.0)) ; \
             let equation_0 = rt :: Plane :: times (self . p , rt :: Plane :: cis (t)) \
             - rt :: Plane :: new (self . a , T :: constant (0.0)) \
             - (wheel + rt :: Plane :: new (l , T :: constant (0.0))) ; [equation_0 . x , equation_0 . y] }"
        );
    }

    #[test]
    fn vectors_of_space_have_three_parts() {
        assert_eq!(
            body(quote! {
                input t: Angle; unknown e: Length; unknown l: Length; unknown m: Length;
                let axis = vec3(a, b, e) / 2;
                rot(axis, t) * (rot_x(t) * rot_y(t) * axis) == -vec3(l, m, norm(p)) + cross(axis, axis) / e;
            }),
            "-> [T ; 3] { let axis = rt :: Space :: scale (rt :: Space :: new (self . a , self . b , e) , \
             T :: constant (1.0) / T :: constant (2.0)) ; \
             let equation_0 = rt :: Rotation :: rotate (rt :: Rotation :: about (axis , t) , \
             rt :: Rotation :: rotate (rt :: Rotation :: times (rt :: Rotation :: about_x (t) , \
             rt :: Rotation :: about_y (t)) , axis)) - (- rt :: Space :: new (l , m , rt :: Plane :: norm (self . p)) \
             + rt :: Space :: scale (rt :: Space :: cross (axis , axis) , T :: constant (1.0) / e)) ; \
             [equation_0 . x , equation_0 . y , equation_0 . z] }"
        );
    }

    #[test]
    fn names_of_outputs_alone_leave_no_warning() {
        let method = method(quote! {
            input t: Angle, u: Length; unknown e: Angle, l: Length; e == t; l * l == a * a; output v: Length = 2 * u;
        });
        assert!(method.contains("[e , l] : [T ; 2]"), "{method}");
        assert!(method.contains("{ let _ = u ; [e - t ,"), "{method}");
    }
}
