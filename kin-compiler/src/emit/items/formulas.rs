//! The formulas to be read: as a constant, and in the documentation of the solvers.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::compiled::Compiled;
use crate::formulas::Formula;

/// The value of the trait's constant.
pub(in crate::emit) fn constant(mechanism: &Compiled<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    let formulas = mechanism.formulas;
    let one = |Formula { text, mathml, latex }: &Formula| quote!(#runtime::Formula::new(#text, #mathml, #latex));
    let [closure, rates, outputs] = [&formulas.closure, &formulas.rates, &formulas.outputs].map(one);
    let [position, velocity] = [&formulas.position, &formulas.velocity].map(|blocks| {
        let blocks = blocks.iter().map(one);
        quote!(&[#(#blocks),*])
    });
    quote!(#runtime::Formulas::new(#closure, #position, #velocity, #rates, #outputs))
}

/// The constant of the structure.
pub(in crate::emit) fn inherent(mechanism: &Compiled<'_>) -> TokenStream {
    let runtime = mechanism.runtime;
    quote! {
        /// The equations and their solution in the notation of textbooks, as text, MathML and LaTeX.
        pub const FORMULAS: #runtime::Formulas = <Self as #runtime::Mechanism>::FORMULAS;
    }
}

impl Compiled<'_> {
    /// The equations, the outputs, and the solution of each block, as documentation.
    pub(super) fn position_formulas(&self) -> TokenStream {
        let formulas = self.formulas;
        let mut shown = vec![(
            "In the notation of textbooks, the equations are".to_owned(),
            &formulas.closure,
        )];
        if !self.model.outputs.is_empty() {
            shown.push(("and the outputs are".to_owned(), &formulas.outputs));
        }
        shown.extend(self.blocks.iter().zip(&formulas.position).map(|(block, formula)| {
            let line = format!("`{}`, {}:", self.names(&block.unknowns), self.solution(block));
            (line, formula)
        }));
        documentation(&shown)
    }

    /// The linear equations of an order, as documentation.
    pub(super) fn rate_formulas(&self, order: usize) -> TokenStream {
        let formulas = self.formulas;
        if let Some(higher) = order.checked_sub(2) {
            let line = "Where **A** ẋ = **b** are the linear equations of a block's velocities:".to_owned();
            return documentation(&[(line, &formulas.higher[higher])]);
        }
        let blocks = self.blocks.iter().zip(&formulas.velocity);
        let shown: Vec<(String, &Formula)> = blocks
            .map(|(block, formula)| {
                (
                    format!("The linear equations of `{}`:", self.names(&block.unknowns)),
                    formula,
                )
            })
            .collect();
        documentation(&shown)
    }
}

/// Formulas, each below a line. A page of documentation shows MathML. An editor, which cannot, shows text.
fn documentation(shown: &[(String, &Formula)]) -> TokenStream {
    let (mut pages, mut editors) = (String::new(), String::new());
    for (line, Formula { text, mathml, .. }) in shown {
        pages.push_str(
            &[
                "\n ",
                line,
                "\n\n <div style=\"overflow-x:auto;margin:0.7em 0\">",
                mathml,
                "</div>\n",
            ]
            .concat(),
        );
        let text = text.replace('\n', "\n ");
        editors.push_str(&["\n ", line, "\n\n ```text\n ", &text, "\n ```\n"].concat());
    }
    quote! {
        #[cfg_attr(doc, doc = #pages)]
        #[cfg_attr(not(doc), doc = #editors)]
    }
}
