//! The elementary functions of the declaration language, one file each.
//!
//! A file owns all that is known of its function: the facts of [`elementary::Elementary`]. A new function is a new file and an entry of
//! the list below, besides the method that calculates it in the trait `Number` of kin-core. Time derivatives of every order follow
//! from the partial derivatives (`derive/`); sine and cosine are differentiated as a pair there, because they share their angle.

mod acos;
mod acosh;
mod asin;
mod asinh;
mod atan;
mod atan2;
mod atanh;
mod cos;
mod cosh;
mod elementary;
mod exp;
mod ln;
mod sin;
mod sinh;
mod sqrt;
mod tan;
mod tanh;

pub(crate) use elementary::{Calculation, Checked, Gives, Inverse, InverseFunction, Takes, Work};

use crate::algebra::{Graph, Node};
use elementary::{Domain, Elementary};

/// The list of the functions with their facts, in the order in which messages list them.
macro_rules! functions {
    ($($variant:ident: $facts:path;)+) => {
        /// An elementary function.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub(crate) enum Function {
            $($variant,)+
        }

        impl Function {
            /// Every function, in the order in which messages list them.
            pub(crate) const ALL: &[Self] = &[$(Self::$variant),+];

            const fn elementary(self) -> &'static Elementary {
                match self {
                    $(Self::$variant => &$facts,)+
                }
            }
        }
    };
}

functions! {
    Sin: sin::SIN;
    Cos: cos::COS;
    Tan: tan::TAN;
    Asin: asin::ASIN;
    Acos: acos::ACOS;
    Atan: atan::ATAN;
    Atan2: atan2::ATAN2;
    Sinh: sinh::SINH;
    Cosh: cosh::COSH;
    Tanh: tanh::TANH;
    Asinh: asinh::ASINH;
    Acosh: acosh::ACOSH;
    Atanh: atanh::ATANH;
    Sqrt: sqrt::SQRT;
    Exp: exp::EXP;
    Ln: ln::LN;
}

impl Function {
    /// The function that a declaration calls `name`.
    pub(crate) fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|function| function.name() == name)
    }

    /// Its name, in the declaration and in generated code alike.
    pub(crate) const fn name(self) -> &'static str {
        self.elementary().name
    }

    /// How it is written, as messages show it.
    pub(crate) const fn form(self) -> &'static str {
        self.elementary().form
    }

    /// How many arguments it takes.
    pub(crate) const fn arity(self) -> usize {
        self.elementary().arity
    }

    /// The dimension of its arguments.
    pub(crate) const fn takes(self) -> Takes {
        self.elementary().takes
    }

    /// The dimension of its value.
    pub(crate) const fn gives(self) -> Gives {
        self.elementary().gives
    }

    /// The function of `kin_core::solve` that checks its domain in generated code.
    pub(crate) const fn guard(self) -> Option<&'static Checked> {
        self.elementary().guard
    }

    /// How an equation f(x) = v is solved for x.
    pub(crate) const fn inverse(self) -> Inverse {
        self.elementary().inverse
    }

    /// How generated code calculates it.
    pub(crate) const fn calculation(self) -> Calculation {
        self.elementary().calculation
    }

    /// The function that is calculated along with it: the cosine to the sine, the sine to the cosine.
    pub(crate) const fn partner(self) -> Option<Self> {
        match self.calculation() {
            Calculation::Sine => Some(Self::Cos),
            Calculation::Cosine => Some(Self::Sin),
            Calculation::Tangent | Calculation::Method => None,
        }
    }

    /// What it costs.
    pub(crate) const fn cost(self) -> &'static [Work] {
        self.elementary().cost
    }

    /// Whether its value is zero anywhere. If not, a zero has come by underflow.
    pub(crate) const fn has_zeros(self) -> bool {
        self.elementary().has_zeros
    }

    /// Its value; NaN outside of the domain.
    pub(crate) fn value(self, arguments: &[f64]) -> f64 {
        if self.contains(arguments) {
            (self.elementary().value)(arguments)
        } else {
            f64::NAN
        }
    }

    /// Whether the arguments lie in its domain, and it has a value there.
    pub(crate) fn contains(self, arguments: &[f64]) -> bool {
        match self.elementary().domain {
            Domain::Everywhere | Domain::Between { .. } => arguments.iter().all(|argument| argument.is_finite()),
            Domain::Part { contains, .. } => contains(arguments),
        }
    }

    /// What messages say of its domain, if the arguments are constants outside of it.
    pub(crate) fn left_domain(self, graph: &mut Graph, arguments: &[Node]) -> Option<&'static str> {
        let constants: Option<Vec<f64>> = arguments.iter().map(|&node| graph.constant_value(node)).collect();
        let constants = constants?;
        match self.elementary().domain {
            Domain::Everywhere => None,
            Domain::Part { contains, text } => (!contains(&constants)).then_some(text),
            Domain::Between { divisor, text } => {
                let divisor = divisor(graph, arguments);
                graph.is_zero(divisor).then_some(text)
            }
        }
    }

    /// Its partial derivative by each argument.
    pub(crate) fn partials(self, graph: &mut Graph, arguments: &[Node], value: Node) -> Vec<Node> {
        (self.elementary().partials)(graph, arguments, value)
    }
}

#[cfg(test)]
mod tests;
