//! Expressions as a person would write them, for documentation and messages.

use std::fmt::Write;

use super::{Graph, Node, Symbol, Term};

/// How tightly the surroundings bind.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Loose,
    Sum,
    Product,
    Power,
}

impl Graph {
    /// An expression in the declaration's own language.
    pub(crate) fn print(&self, node: Node, name: &dyn Fn(Symbol) -> String) -> String {
        self.print_within(node, name, Binding::Loose)
    }

    fn print_within(&self, node: Node, name: &dyn Fn(Symbol) -> String, outside: Binding) -> String {
        match self.term(node) {
            Term::Number(value) => value.get().to_string(),
            Term::Pi => "PI".to_owned(),
            Term::Symbol(symbol) => name(*symbol),
            Term::Sum(constant, terms) => {
                let mut text = String::new();
                for &(part, coefficient) in terms {
                    let value = coefficient.get();
                    let sign = match (text.is_empty(), value < 0.0) {
                        (true, false) => "",
                        (true, true) => "-",
                        (false, false) => " + ",
                        (false, true) => " - ",
                    };
                    text.push_str(sign);
                    if value.abs() == 1.0 {
                        text.push_str(&self.print_within(part, name, Binding::Sum));
                    } else {
                        let _ = write!(
                            text,
                            "{} * {}",
                            value.abs(),
                            self.print_within(part, name, Binding::Product)
                        );
                    }
                }
                let constant = constant.get();
                if constant != 0.0 {
                    let sign = if constant < 0.0 { '-' } else { '+' };
                    let _ = write!(text, " {sign} {}", constant.abs());
                }
                if outside > Binding::Loose {
                    format!("({text})")
                } else {
                    text
                }
            }
            Term::Product(factors) => {
                let side = |wanted: bool| -> Vec<String> {
                    factors
                        .iter()
                        .filter(|&&(_, exponent)| (exponent > 0) == wanted)
                        .map(|&(part, exponent)| match exponent.abs() {
                            1 => self.print_within(part, name, Binding::Product),
                            power => format!("{}.powi({power})", self.print_within(part, name, Binding::Power)),
                        })
                        .collect()
                };
                let (above, below) = (side(true), side(false));
                let mut text = if above.is_empty() {
                    "1".to_owned()
                } else {
                    above.join(" * ")
                };
                match below.as_slice() {
                    [] => {}
                    [one] => {
                        let _ = write!(text, " / {one}");
                    }
                    many => {
                        let _ = write!(text, " / ({})", many.join(" * "));
                    }
                }
                if outside > Binding::Sum {
                    format!("({text})")
                } else {
                    text
                }
            }
            Term::Call(function, arguments) => {
                let arguments: Vec<String> = arguments
                    .iter()
                    .map(|&argument| self.print_within(argument, name, Binding::Loose))
                    .collect();
                format!("{}({})", function.name(), arguments.join(", "))
            }
        }
    }
}
