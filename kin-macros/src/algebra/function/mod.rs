//! The elementary functions of the declaration language, one file each.
//!
//! A file owns all that the rest of the crate needs to know about its function: name, arity, value, domain and
//! partial derivatives. Time derivatives of every order follow from the partial derivatives (`derive/`); sine and
//! cosine are differentiated as a pair there, because they share their angle.

mod acos;
mod asin;
mod atan;
mod atan2;
mod cos;
mod exp;
mod ln;
mod sin;
mod sqrt;
mod tan;

use crate::algebra::{Graph, Node};

/// What a file of this folder says of its function.
struct Elementary {
    name: &'static str,
    arity: usize,
    /// The value, for folding constants and for probing an identity.
    value: fn(&[f64]) -> f64,
    /// Whether the arguments lie where the function is real and finite.
    domain: fn(&[f64]) -> bool,
    /// The partial derivative by each argument, given the arguments and the node of the value itself.
    partials: fn(&mut Graph, &[Node], Node) -> Vec<Node>,
}

/// An elementary function.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(crate) enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sqrt,
    Exp,
    Ln,
}

impl Function {
    /// Every function, in the order in which messages list them.
    pub(crate) const ALL: [Self; 10] = [
        Self::Sin,
        Self::Cos,
        Self::Tan,
        Self::Asin,
        Self::Acos,
        Self::Atan,
        Self::Atan2,
        Self::Sqrt,
        Self::Exp,
        Self::Ln,
    ];

    const fn elementary(self) -> &'static Elementary {
        match self {
            Self::Sin => &sin::SIN,
            Self::Cos => &cos::COS,
            Self::Tan => &tan::TAN,
            Self::Asin => &asin::ASIN,
            Self::Acos => &acos::ACOS,
            Self::Atan => &atan::ATAN,
            Self::Atan2 => &atan2::ATAN2,
            Self::Sqrt => &sqrt::SQRT,
            Self::Exp => &exp::EXP,
            Self::Ln => &ln::LN,
        }
    }

    /// The function that a declaration calls `name`.
    pub(crate) fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|function| function.name() == name)
    }

    /// Its name, in the declaration and in generated code alike.
    pub(crate) const fn name(self) -> &'static str {
        self.elementary().name
    }

    /// How many arguments it takes.
    pub(crate) const fn arity(self) -> usize {
        self.elementary().arity
    }

    /// Its value; NaN outside of the domain.
    pub(crate) fn value(self, arguments: &[f64]) -> f64 {
        if self.contains(arguments) {
            (self.elementary().value)(arguments)
        } else {
            f64::NAN
        }
    }

    /// Whether the arguments lie in its domain.
    pub(crate) fn contains(self, arguments: &[f64]) -> bool {
        (self.elementary().domain)(arguments)
    }

    /// Its partial derivative by each argument.
    pub(crate) fn partials(self, graph: &mut Graph, arguments: &[Node], value: Node) -> Vec<Node> {
        (self.elementary().partials)(graph, arguments, value)
    }
}

/// Every real number will do.
fn everywhere(arguments: &[f64]) -> bool {
    arguments.iter().all(|argument| argument.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::Symbol;

    /// Each partial derivative agrees with a central difference of the value.
    #[test]
    fn partials_agree_with_differences() {
        for function in Function::ALL {
            let mut graph = Graph::new();
            let arguments: Vec<Node> = (0..function.arity())
                .map(|index| graph.symbol(Symbol::Parameter(index)))
                .collect();
            let value = graph.call(function, &arguments);
            let partials = function.partials(&mut graph, &arguments, value);
            let at = [0.37, 0.61];
            for (index, partial) in partials.into_iter().enumerate() {
                let exact = graph.evaluate(partial, &|symbol| match symbol {
                    Symbol::Parameter(index) => at[index],
                    _ => f64::NAN,
                });
                let step = 1e-5;
                let shifted = |by: f64| {
                    let mut point = at;
                    point[index] += by;
                    function.value(&point[..function.arity()])
                };
                let difference = (shifted(step) - shifted(-step)) / (2.0 * step);
                assert!(
                    (exact - difference).abs() < 1e-8,
                    "{} by argument {index}: {exact} against {difference}",
                    function.name()
                );
            }
        }
    }
}
