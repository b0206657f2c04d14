//! The elementary functions of the declaration language, one file each.
//!
//! A file states all facts of its function, as [`facts::FunctionFacts`]. A new function needs a new file, an entry in
//! the list below, and the method of the trait `Number` of kin-core that calculates it. Time derivatives of every order
//! follow from the partial derivatives (`derive/`). There, sine and cosine are differentiated as a pair, because they
//! share their angle.

mod acos;
mod acosh;
mod asin;
mod asinh;
mod atan;
mod atan2;
mod atanh;
mod cos;
mod cosh;
mod exp;
mod facts;
mod ln;
mod sin;
mod sinh;
mod sqrt;
mod tan;
mod tanh;

pub(crate) use facts::{Calculation, Checked, Gives, Inverse, InverseFunction, Takes, WorkUnit};

use crate::algebra::{Graph, Node};
use facts::{Domain, FunctionFacts};

/// Lists the functions with their facts, in the order in which messages list them.
macro_rules! functions {
    ($($variant:ident: $facts:path;)+) => {
        /// An elementary function.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum Function {
            $(
                #[doc = stringify!($variant)]
                $variant,
            )+
        }

        impl Function {
            /// Every function, in the order in which messages list them.
            pub(crate) const ALL: &[Self] = &[$(Self::$variant),+];

            const fn facts(self) -> &'static FunctionFacts {
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

    /// The name, in the declaration and in generated code alike.
    pub(crate) const fn name(self) -> &'static str {
        self.facts().name
    }

    /// The spelling of a call, as messages show it.
    pub(crate) const fn form(self) -> &'static str {
        self.facts().form
    }

    /// The usual name, in formulas to be read.
    pub(crate) const fn notation(self) -> &'static str {
        self.facts().notation
    }

    /// The usual name of the function that gives the argument for a value, if it has a name.
    pub(crate) const fn undone_by(self) -> Option<&'static str> {
        self.facts().undone_by
    }

    /// The number of arguments.
    pub(crate) const fn arity(self) -> usize {
        self.facts().arity
    }

    /// The dimension of the arguments.
    pub(crate) const fn takes(self) -> Takes {
        self.facts().takes
    }

    /// The dimension of the value.
    pub(crate) const fn gives(self) -> Gives {
        self.facts().gives
    }

    /// The function of `kin_core::solve` that checks the domain in generated code.
    pub(crate) const fn guard(self) -> Option<&'static Checked> {
        self.facts().guard
    }

    /// The way to solve an equation f(x) = v for x.
    pub(crate) const fn inverse(self) -> Inverse {
        self.facts().inverse
    }

    /// The way in which generated code calculates the function.
    pub(crate) const fn calculation(self) -> Calculation {
        self.facts().calculation
    }

    /// The function that is calculated in the same call: cosine for sine, sine for cosine.
    pub(crate) const fn partner(self) -> Option<Self> {
        match self.calculation() {
            Calculation::Sine => Some(Self::Cos),
            Calculation::Cosine => Some(Self::Sin),
            Calculation::Tangent | Calculation::Method => None,
        }
    }

    /// The cost of a call.
    pub(crate) const fn cost(self) -> &'static [WorkUnit] {
        self.facts().cost
    }

    /// Whether the function has a zero. If not, a zero result comes from underflow.
    pub(crate) const fn has_zeros(self) -> bool {
        self.facts().has_zeros
    }

    /// The value; NaN outside the domain.
    pub(crate) fn value(self, arguments: &[f64]) -> f64 {
        if self.contains(arguments) {
            (self.facts().value)(arguments)
        } else {
            f64::NAN
        }
    }

    /// Whether the arguments lie in the domain and the value is a number.
    pub(crate) fn contains(self, arguments: &[f64]) -> bool {
        match self.facts().domain {
            Domain::Everywhere | Domain::Between { .. } => arguments.iter().all(|argument| argument.is_finite()),
            Domain::Part { contains, .. } => contains(arguments),
        }
    }

    /// The description of the domain in messages, if the arguments are constants outside it.
    pub(crate) fn left_domain(self, graph: &mut Graph, arguments: &[Node]) -> Option<&'static str> {
        let constants: Option<Vec<f64>> = arguments.iter().map(|&node| graph.constant_value(node)).collect();
        let constants = constants?;
        match self.facts().domain {
            Domain::Everywhere => None,
            Domain::Part { contains, text } => (!contains(&constants)).then_some(text),
            Domain::Between { divisor, text } => {
                let divisor = divisor(graph, arguments);
                graph.is_zero(divisor).then_some(text)
            }
        }
    }

    /// The partial derivative by each argument.
    pub(crate) fn partials(self, graph: &mut Graph, arguments: &[Node], value: Node) -> Vec<Node> {
        (self.facts().partials)(graph, arguments, value)
    }
}

#[cfg(test)]
mod tests;
