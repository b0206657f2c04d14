//! The growth of rounding errors through relations that replace unknowns.

use std::collections::BTreeSet;

use crate::algebra::{Graph, Node, Symbol};

/// The growth up to which relations are taken out of equations that Newton's method solves. Four bits of the residuals
/// are lost at most.
pub(super) const COUPLED: f64 = 16.0;
/// The growth up to which relations are taken out of equations that closed forms solve: that of one coefficient whose
/// value is not known, beside numbers that Newton's method would accept. Without them the equations would need a guess.
pub(super) const CLOSED: f64 = COUPLED * UNKNOWN_COEFFICIENT;
/// The growth that a coefficient counts for whose value is not known: more than Newton's method accepts.
const UNKNOWN_COEFFICIENT: f64 = 32.0;

/// The quantities whose magnitudes say something about coefficients.
pub(crate) struct CoefficientMagnitudes {
    /// The unknowns that are lengths.
    pub(crate) lengths: BTreeSet<usize>,
    /// The parameters, inputs and unknowns that are plain numbers. These may have any magnitude.
    pub(crate) numbers: BTreeSet<Symbol>,
}

/// The factor by which rounding errors of the remaining unknowns may grow on their way through relations.
#[derive(Clone, Copy)]
pub(super) struct Growth(f64);

impl Growth {
    /// Nothing is replaced.
    pub(super) const NONE: Self = Self(1.0);

    pub(super) const fn get(self) -> f64 {
        self.0
    }

    /// The growth if an equation gives an unknown from others: the sum of the magnitudes of their coefficients, if that
    /// is more than one.
    ///
    /// The coefficient of an angle in a length is itself a length, and not larger than a link. Any other coefficient
    /// that is no number may have any value.
    pub(super) fn through(
        self,
        graph: &mut Graph,
        magnitudes: &CoefficientMagnitudes,
        equation: Node,
        (unknown, coefficient): (usize, Node),
        others: impl Iterator<Item = usize>,
    ) -> Self {
        let is_length = magnitudes.lengths.contains(&unknown);
        let (mut sum, mut longest) = (0.0, 0.0_f64);
        for other in others {
            let partial = graph.partial(equation, Symbol::Unknown(other));
            let ratio = graph.divide(partial, coefficient);
            if let Some(number) = graph.as_number(ratio) {
                sum += number.abs();
            } else if is_length && !magnitudes.lengths.contains(&other) && magnitudes.is_length(graph, ratio) {
                longest = 1.0;
            } else {
                longest = UNKNOWN_COEFFICIENT;
            }
        }
        Self(self.0 * (sum + longest).max(1.0))
    }
}

impl CoefficientMagnitudes {
    /// Whether an expression for a length is made up of lengths and functions of angles, without plain numbers that
    /// would enlarge it.
    fn is_length(&self, graph: &Graph, node: Node) -> bool {
        graph.reachable(&[node]).into_iter().all(|part| {
            let is_number = graph
                .as_symbol(part)
                .is_some_and(|symbol| self.numbers.contains(&symbol));
            !is_number && graph.extremity(part) <= COUPLED.ln()
        })
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;
    use quote::quote;

    use crate::passes::Passes;
    use crate::testing::sound;

    /// The parts of the first block, by the unknowns that they find.
    fn parts(declaration: TokenStream) -> Vec<(Vec<usize>, bool)> {
        let declared = sound(declaration);
        let parts = &declared.task(Passes::ALL).blocks[0].parts;
        let is_newton = |part: &crate::structure::Part| matches!(part.method, crate::structure::Method::Newton { .. });
        parts
            .iter()
            .map(|part| (part.unknowns.clone(), is_newton(part)))
            .collect()
    }

    /// A slide along an axis and a gear of a small ratio are taken out of a coupled block, because they magnify
    /// nothing.
    #[test]
    fn slides_and_small_gears_are_taken_out() {
        let slide = quote! {
            struct M { a: Length, b: Length, c: Length, d: Length }
            input t: Angle;
            unknown x: Angle, y: Angle, s: Length;
            s == a * cos(t) + b * cos(x) + c * cos(y);
            0 == a * sin(t) + b * sin(x) + c * sin(y);
            s * s == d * d + a * b * sin(x + y);
        };
        assert_eq!(parts(slide), [(vec![0, 1], true), (vec![2], false)]);
        let gear = quote! {
            struct M { a: Angle, k: Scalar }
            input t: Angle;
            unknown x: Angle, y: Angle;
            y == 3 * x + a;
            x + k * sin(y) == t;
        };
        assert_eq!(parts(gear), [(vec![0], true), (vec![1], false)]);
    }

    /// Large ratios, and ratios that are not known, stay with Newton's method.
    #[test]
    fn what_may_magnify_stays() {
        let gear = |ratio: TokenStream| {
            quote! {
                struct M { a: Angle, k: Scalar }
                input t: Angle;
                unknown x: Angle, y: Angle;
                y == #ratio * x + a;
                x + k * sin(y) == t;
            }
        };
        assert_eq!(parts(gear(quote!(k))), [(vec![0, 1], true)]);
        // the slow gear follows from the fast one
        assert_eq!(parts(gear(quote!(30))), [(vec![1], true), (vec![0], false)]);
        let chain = quote! {
            struct M { k: Scalar }
            input t: Scalar;
            unknown x: Scalar, y: Scalar, z: Scalar;
            20 * x - y + sin(x) == t;
            20 * y - x - z + sin(y) == k;
            20 * z - y + sin(z) == k;
        };
        assert_eq!(parts(chain), [(vec![0, 1, 2], true)]);
    }

    /// Linear equations with large coefficients are one system, and those with small ones are solved one by one.
    #[test]
    fn linear_equations_are_one_system_if_they_may_magnify() {
        let chain = |a: TokenStream| {
            quote! {
                struct M { k: Scalar }
                input t: Scalar;
                unknown x: Scalar, y: Scalar, z: Scalar;
                #a * x - y == t;
                #a * y - x - z == k;
                #a * z - y == k;
            }
        };
        assert_eq!(parts(chain(quote!(20))), [(vec![0, 1, 2], false)]);
        assert_eq!(parts(chain(quote!(2))), [(vec![0, 2], false), (vec![1], false)]);
    }

    /// Closed forms need no guess, so one coefficient of any value is taken out for them.
    #[test]
    fn closed_forms_take_one_unknown_ratio() {
        let tackle = quote! {
            struct M { k: Scalar, a: Length, b: Length }
            input t: Length;
            unknown x: Length, y: Length;
            y == k * x + t;
            x * x + y * y == a * b;
        };
        assert_eq!(parts(tackle), [(vec![0], false), (vec![1], false)]);
    }
}
