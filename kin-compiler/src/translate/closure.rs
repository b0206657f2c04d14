//! The residuals of the equations, for verification.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote_spanned};

use super::formula::Translation;
use super::names::{bindings, names, pattern, used_names};
use crate::model::{Model, ValueShape};
use crate::syntax::{ArithmeticOperator, Declaration, EquationStatement, Statement};

/// The method `closure`.
pub(crate) fn tokens(declaration: &Declaration, model: &Model, runtime: &TokenStream) -> TokenStream {
    let equations: Vec<&EquationStatement> = declaration
        .statements
        .iter()
        .filter_map(|statement| match statement {
            Statement::Equation(equation) => Some(equation),
            _ => None,
        })
        .collect();
    let formulas = equations.iter().flat_map(|equation| [&equation.left, &equation.right]);
    let used = used_names(declaration, formulas);
    let mut names = names(model);

    let site = Span::mixed_site();
    let unknowns = pattern(model.unknowns.iter().map(|unknown| &unknown.name), &used);
    let mut body = TokenStream::new();
    for input in &model.inputs {
        let name = &input.name;
        if !used.contains(&name.to_string()) {
            body.extend(quote_spanned!(site=> let _ = #name;));
        }
    }
    body.extend(bindings(declaration, runtime, &used, &mut names));
    let translation = Translation { names: &names, runtime };
    let mut residuals: Vec<TokenStream> = Vec::new();
    let mut lines: Vec<String> = Vec::new();
    for (number, equation) in equations.iter().enumerate() {
        let left = translation.formula(&equation.left);
        let right = translation.formula(&equation.right);
        let residual = translation.sum(ArithmeticOperator::Subtract, left, right);
        let index = residuals.len();
        let tokens = residual.tokens;
        let axes = residual.shape.axes();
        if axes.is_empty() {
            residuals.push(tokens);
            lines.push(format!("- `[{index}]`: `{equation}`"));
            continue;
        }
        let local = format_ident!("equation_{number}", span = site);
        body.extend(quote_spanned!(site=> let #local = #tokens;));
        for axis in axes {
            let part = Ident::new(&axis.to_string(), site);
            residuals.push(quote_spanned!(site=> #local.#part));
        }
        lines.push(match residual.shape {
            ValueShape::Space => format!(
                "- `[{index}]`, `[{}]` and `[{}]`: x, y and z of `{equation}`",
                index + 1,
                index + 2
            ),
            _ => format!("- `[{index}]` and `[{}]`: x and y of `{equation}`", index + 1),
        });
    }

    let inputs = model.inputs.iter().map(|input| &input.name);
    let unknown_count = Literal::usize_unsuffixed(model.unknowns.len());
    let residual_count = Literal::usize_unsuffixed(residuals.len());
    let order: Vec<String> = model.unknowns.iter().map(|unknown| unknown.name.to_string()).collect();
    let summary = format!(
        "The residuals of the equations, left side minus right side, for the unknowns `[{}]`. All are zero at a position of the mechanism.",
        order.join(", ")
    );
    // the lines follow the summary, each as a paragraph, as in a doc comment
    let documentation = [summary, String::new()]
        .into_iter()
        .chain(lines)
        .map(|line| format!(" {line}"));
    quote_spanned! {site=>
        #(#[doc = #documentation])*
        #[must_use]
        pub fn closure(&self, #(#inputs: T,)* #unknowns: [T; #unknown_count]) -> [T; #residual_count] {
            #body
            [#(#residuals),*]
        }
    }
}

#[cfg(test)]
#[allow(clippy::needless_pass_by_value, reason = "formulas are quoted where they are passed")]
mod tests {
    use quote::quote;

    use super::*;
    use crate::mistakes::Mistakes;
    use crate::model;
    use crate::syntax;

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
        super::tokens(&declaration, &model, &quote!(rt)).to_string()
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
             let equation_0 = rt :: Rotation :: turn (rt :: Rotation :: about (axis , t) , \
             rt :: Rotation :: turn (rt :: Rotation :: times (rt :: Rotation :: about_x (t) , rt :: Rotation :: about_y (t)) , axis)) \
             - (- rt :: Space :: new (l , m , rt :: Plane :: norm (self . p)) \
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
