//! Expressions as a person would write them, for documentation and messages.

use std::fmt::Write;

use super::{Graph, Node, NodeKind, Symbol};
use crate::precedence::Precedence;

/// The length at which a text is cut off. Nobody reads longer ones, and the length of an expression with repeated parts
/// can grow as a power of two.
const LONGEST: usize = 1000;

impl Graph {
    /// An expression in the declaration language, cut off at a readable length.
    pub(crate) fn print(&self, node: Node, name: &dyn Fn(Symbol) -> String) -> String {
        let mut printer = Printer {
            graph: self,
            name,
            text: String::new(),
        };
        printer.print(node, Precedence::Sum);
        let mut text = printer.text;
        if text.len() > LONGEST {
            let end = (0..=LONGEST).rev().find(|&end| text.is_char_boundary(end));
            text.truncate(end.unwrap_or(0));
            text.push('…');
        }
        text
    }
}

struct Printer<'a> {
    graph: &'a Graph,
    name: &'a dyn Fn(Symbol) -> String,
    text: String,
}

impl Printer<'_> {
    fn print(&mut self, node: Node, outside: Precedence) {
        if self.text.len() > LONGEST {
            return;
        }
        match self.graph.kind(node) {
            NodeKind::Number(value) => self.text.push_str(&value.get().to_string()),
            NodeKind::Pi => self.text.push_str("PI"),
            NodeKind::Symbol(symbol) => self.text.push_str(&(self.name)(*symbol)),
            NodeKind::Sum(constant, terms) => {
                self.within(Precedence::Sum.needs_parentheses(outside), |printer| {
                    for (index, &(part, coefficient)) in terms.iter().enumerate() {
                        let value = coefficient.get();
                        printer.text.push_str(match (index, value < 0.0) {
                            (0, false) => "",
                            (0, true) => "-",
                            (_, false) => " + ",
                            (_, true) => " - ",
                        });
                        if value.abs() == 1.0 {
                            printer.print(part, Precedence::Product);
                        } else {
                            let _ = write!(printer.text, "{} * ", value.abs());
                            printer.print(part, Precedence::Atom);
                        }
                    }
                    let constant = constant.get();
                    if constant != 0.0 {
                        let sign = if constant < 0.0 { '-' } else { '+' };
                        let _ = write!(printer.text, " {sign} {}", constant.abs());
                    }
                });
            }
            NodeKind::Product(factors) => {
                let (above, below): (Vec<_>, Vec<_>) = factors.iter().partition(|&&(_, exponent)| exponent > 0);
                self.within(Precedence::Product.needs_parentheses(outside), |printer| {
                    if above.is_empty() {
                        printer.text.push('1');
                    }
                    printer.factors(&above);
                    if !below.is_empty() {
                        printer.text.push_str(" / ");
                        printer.within(below.len() > 1, |printer| printer.factors(&below));
                    }
                });
            }
            NodeKind::Call(function, arguments) => {
                self.text.push_str(function.name());
                self.within(true, |printer| {
                    for (index, &argument) in arguments.iter().enumerate() {
                        printer.text.push_str(if index == 0 { "" } else { ", " });
                        printer.print(argument, Precedence::Sum);
                    }
                });
            }
        }
    }

    /// Writes factors with their powers, whatever the sign of the powers.
    fn factors(&mut self, factors: &[(Node, i32)]) {
        for (index, &(part, exponent)) in factors.iter().enumerate() {
            self.text.push_str(if index == 0 { "" } else { " * " });
            match exponent.unsigned_abs() {
                1 => self.print(part, Precedence::Atom),
                power => {
                    self.print(part, Precedence::Atom);
                    let _ = write!(self.text, ".powi({power})");
                }
            }
        }
    }

    /// Writes `inside` in parentheses, or without.
    fn within(&mut self, parentheses: bool, inside: impl FnOnce(&mut Self)) {
        self.text.push_str(if parentheses { "(" } else { "" });
        inside(self);
        self.text.push_str(if parentheses { ")" } else { "" });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A text of exactly the greatest length stays whole; a longer one is cut there.
    #[test]
    fn only_what_is_longer_is_cut_off() {
        let mut graph = Graph::new();
        let symbol = graph.symbol(Symbol::Parameter(0));
        let text = |length: usize| graph.print(symbol, &|_| "x".repeat(length));
        assert_eq!(text(LONGEST), "x".repeat(LONGEST));
        assert_eq!(text(LONGEST + 1), format!("{}…", "x".repeat(LONGEST)));
    }
}
