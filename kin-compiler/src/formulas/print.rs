//! Terms as text, MathML and LaTeX, by one printer.

use super::Formula;
use super::form::{Typesetting, superscript_text};
use super::name::Name;
use super::term::{DisplayLine, Notation};
use crate::precedence::Precedence;

/// The cell before a relation. Chromium knows no `columnalign`, and others no `-webkit-right`.
const RIGHT: &str = "<mtd style=\"text-align:-webkit-right;padding-right:0\">";

/// The cell that begins with a relation.
const LEFT: &str = "<mtd style=\"text-align:-webkit-left;padding-left:0\">";

/// Lines below each other, with their relations below each other, in all three forms.
pub(super) fn formula(lines: &[DisplayLine], is_cis: bool) -> Formula {
    let both = |line: &DisplayLine, form: Typesetting| {
        let right = Printer::of(&line.right, form, &form.operator(line.relation));
        (Printer::of(&line.left, form, ""), right)
    };
    let text: Vec<String> = lines
        .iter()
        .map(|line| {
            let (left, right) = both(line, Typesetting::Text { is_cis });
            format!("{left}{right}")
        })
        .collect();
    let mathml: String = lines
        .iter()
        .map(|line| {
            let (left, right) = both(line, Typesetting::MathMl);
            ["<mtr>", RIGHT, &left, "</mtd>", LEFT, &right, "</mtd></mtr>"].concat()
        })
        .collect();
    let latex: Vec<String> = lines
        .iter()
        .map(|line| {
            let (left, right) = both(line, Typesetting::Latex);
            format!("{left} &{right}")
        })
        .collect();
    if lines.is_empty() {
        return Formula {
            text: String::new(),
            mathml: String::new(),
            latex: String::new(),
        };
    }
    Formula {
        text: text.join("\n"),
        mathml: format!(
            "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\"><mtable displaystyle=\"true\" \
             columnalign=\"right left\">{mathml}</mtable></math>"
        ),
        latex: format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", latex.join(" \\\\\n")),
    }
}

/// Prints terms one after the other.
struct Printer {
    form: Typesetting,
    text: String,
    /// Whether the nearest fence outside is a bar, which cannot be distinguished from a second one.
    is_between_bars: bool,
}

/// The surroundings of a formula.
#[derive(Clone, Copy)]
struct Surroundings {
    precedence: Precedence,
    /// Whether nothing follows in the same product that could be taken for a part of an argument.
    is_last: bool,
}

impl Surroundings {
    const fn new(precedence: Precedence, is_last: bool) -> Self {
        Self { precedence, is_last }
    }

    /// A position between fences or lines.
    const ALONE: Self = Self::new(Precedence::Sum, true);
}

impl Printer {
    /// A term behind a beginning.
    fn of(term: &Notation, form: Typesetting, beginning: &str) -> String {
        let mut printer = Self {
            form,
            text: beginning.to_owned(),
            is_between_bars: false,
        };
        printer.term(term, Surroundings::ALONE);
        printer.text
    }

    fn push(&mut self, text: &str) {
        self.text.push_str(text);
    }

    const fn is_text(&self) -> bool {
        matches!(self.form, Typesetting::Text { .. })
    }

    /// How tightly the outermost operator binds. A fraction with a bar needs parentheses only as the base of a power.
    fn precedence(&self, term: &Notation) -> Precedence {
        match term {
            Notation::Sum(_) | Notation::Negative(_) | Notation::Either(_) => Precedence::Sum,
            Notation::Product(_) | Notation::Dot(..) | Notation::Cross(..) => Precedence::Product,
            Notation::Number(value) if is_scientific(*value) => Precedence::Product,
            Notation::Quotient(..) if self.is_text() => Precedence::Product,
            Notation::Quotient(..) | Notation::Power(..) | Notation::Direction(_) | Notation::Call(..) => {
                Precedence::Sign
            }
            Notation::Number(_)
            | Notation::Degrees(_)
            | Notation::Pi
            | Notation::Imaginary
            | Notation::Dots
            | Notation::Words(_)
            | Notation::Name(_)
            | Notation::Rate(..)
            | Notation::Change(..)
            | Notation::Root(_)
            | Notation::Norm(_)
            | Notation::Function(..)
            | Notation::Tuple(_) => Precedence::Atom,
        }
    }

    fn term(&mut self, term: &Notation, around: Surroundings) {
        let precedence = self.precedence(term);
        // a time derivative above the line would be taken for a power, and the other way round
        let is_crowded = around.precedence == Precedence::Atom && matches!(term, Notation::Rate(_, 3..));
        let is_in_bars = self.is_between_bars && matches!(term, Notation::Norm(_));
        if precedence.needs_parentheses(around.precedence) || is_crowded || is_in_bars {
            self.fenced('(', ')', |printer| printer.bare(term, Surroundings::ALONE));
        } else {
            self.bare(term, around);
        }
    }

    /// A term without parentheses around it.
    fn bare(&mut self, term: &Notation, around: Surroundings) {
        match term {
            Notation::Number(value) => self.number(*value),
            Notation::Degrees(value) => {
                self.number(*value);
                let sign = if self.form == Typesetting::Latex {
                    "^{\\circ}"
                } else {
                    "°"
                };
                if self.form == Typesetting::MathMl {
                    self.push("<mi mathvariant=\"normal\">°</mi>");
                } else {
                    self.push(sign);
                }
            }
            Notation::Pi => self.word("π"),
            Notation::Imaginary => self.word("i"),
            Notation::Dots => self.push(match self.form {
                Typesetting::Text { .. } => "…",
                Typesetting::MathMl => "<mi>…</mi>",
                Typesetting::Latex => "\\dots",
            }),
            Notation::Name(name) => self.name(name, 0),
            Notation::Rate(name, order) => self.name(name, *order),
            Notation::Change(letter, name) => {
                match (self.form, letter) {
                    (Typesetting::Latex, '∂') => self.push("\\partial "),
                    (Typesetting::Latex, _) => self.push("\\Delta "),
                    (Typesetting::MathMl, _) => self.push(&format!("<mi mathvariant=\"normal\">{letter}</mi>")),
                    (Typesetting::Text { .. }, _) => self.text.push(*letter),
                }
                self.name(name, 0);
            }
            Notation::Words(words) => self.push(&match self.form {
                Typesetting::Text { .. } => (*words).to_owned(),
                Typesetting::MathMl => format!("<mtext>{words}</mtext>"),
                Typesetting::Latex => format!("\\text{{{words}}}"),
            }),
            Notation::Negative(of) => {
                self.push(&self.form.sign("−"));
                self.term(of, Surroundings::new(Precedence::Product, around.is_last));
            }
            Notation::Either(of) => {
                self.push(&self.form.sign("±"));
                self.term(of, Surroundings::new(Precedence::Product, around.is_last));
            }
            Notation::Sum(terms) => self.sum(terms),
            Notation::Product(factors) => self.product(factors, around.is_last),
            Notation::Dot(left, right) => self.two(left, "·", right),
            Notation::Cross(left, right) => self.two(left, "×", right),
            Notation::Quotient(dividend, divisor) => self.quotient(dividend, divisor),
            Notation::Power(base, exponent) => self.power(base, *exponent, around.is_last),
            Notation::Direction(angle) => self.direction(angle),
            Notation::Root(of) => match self.form {
                Typesetting::Text { .. } => {
                    self.push("√");
                    self.fenced('(', ')', |printer| printer.term(of, Surroundings::ALONE));
                }
                Typesetting::MathMl => self.element("msqrt", |printer| printer.term(of, Surroundings::ALONE)),
                Typesetting::Latex => self.element("\\sqrt", |printer| printer.term(of, Surroundings::ALONE)),
            },
            Notation::Norm(of) => self.fenced('|', '|', |printer| printer.term(of, Surroundings::ALONE)),
            Notation::Call(function, arguments) => {
                self.word(function);
                self.arguments(arguments, around.is_last);
            }
            Notation::Function(name, arguments) => {
                self.name(name, 0);
                self.list(arguments);
            }
            Notation::Tuple(terms) => self.list(terms),
        }
    }

    fn word(&mut self, word: &str) {
        let word = self.form.word(word);
        // a command would run into a letter behind it
        let gap = if word.starts_with('\\') && !word.ends_with('}') {
            " "
        } else {
            ""
        };
        self.push(&word);
        self.push(gap);
    }

    fn name(&mut self, name: &Name, order: usize) {
        let name = self.form.name(name, order);
        let gap = if name.starts_with('\\') && name.ends_with(char::is_alphabetic) {
            " "
        } else {
            ""
        };
        self.push(&name);
        self.push(gap);
    }

    fn number(&mut self, value: f64) {
        if !is_scientific(value) {
            let digits = self.form.digits(&value.to_string());
            return self.push(&digits);
        }
        let text = format!("{value:e}");
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let digits = self.form.digits(mantissa);
        self.push(&digits);
        self.push(&self.form.operator("·"));
        match self.form {
            Typesetting::Text { .. } => self.push(&format!("10{}", superscript_text(exponent))),
            Typesetting::MathMl => {
                let minus = if exponent.starts_with('-') { "<mo>−</mo>" } else { "" };
                let digits = exponent.trim_start_matches('-');
                self.push(&format!(
                    "<msup><mn>10</mn><mrow>{minus}<mn>{digits}</mn></mrow></msup>"
                ));
            }
            Typesetting::Latex => self.push(&format!("10^{{{exponent}}}")),
        }
    }

    fn sum(&mut self, terms: &[Notation]) {
        for (index, term) in terms.iter().enumerate() {
            let (sign, of) = match term {
                Notation::Negative(of) => ("−", &**of),
                Notation::Either(of) => ("±", &**of),
                _ => ("+", term),
            };
            if index == 0 {
                self.term(term, Surroundings::ALONE);
            } else {
                self.push(&self.form.operator(sign));
                self.term(of, Surroundings::new(Precedence::Product, true));
            }
        }
    }

    fn product(&mut self, factors: &[Notation], is_last: bool) {
        for (index, factor) in factors.iter().enumerate() {
            let rest = &factors[index + 1..];
            // only a function can follow the argument of another without parentheses
            let is_last = is_last && rest.iter().all(is_call);
            if index > 0 {
                let is_wide = is_wide(factor) || is_wide(&factors[index - 1]);
                if begins_with_digit(factor) {
                    self.push(&self.form.operator("·"));
                } else {
                    self.push(self.form.between_factors(is_wide));
                }
            }
            // a power of ten in front is read as a part of the product
            let precedence = match factor {
                Notation::Number(_) if index == 0 => Precedence::Product,
                _ => Precedence::Sign,
            };
            self.term(factor, Surroundings::new(precedence, is_last));
        }
    }

    /// Two vectors with the sign of their product between them.
    fn two(&mut self, left: &Notation, operator: &str, right: &Notation) {
        self.term(left, Surroundings::new(Precedence::Sign, false));
        self.push(&self.form.operator(operator));
        self.term(right, Surroundings::new(Precedence::Sign, false));
    }

    fn quotient(&mut self, dividend: &Notation, divisor: &Notation) {
        match self.form {
            Typesetting::Text { .. } => {
                self.term(dividend, Surroundings::new(Precedence::Product, false));
                self.push("/");
                self.term(divisor, Surroundings::new(Precedence::Sign, false));
            }
            Typesetting::MathMl => self.element("mfrac", |printer| {
                printer.element("mrow", |printer| printer.term(dividend, Surroundings::ALONE));
                printer.element("mrow", |printer| printer.term(divisor, Surroundings::ALONE));
            }),
            Typesetting::Latex => {
                self.element("\\frac", |printer| printer.term(dividend, Surroundings::ALONE));
                self.element("", |printer| printer.term(divisor, Surroundings::ALONE));
            }
        }
    }

    fn power(&mut self, base: &Notation, exponent: i32, is_last: bool) {
        if let Notation::Call(function @ ("sin" | "cos" | "tan"), arguments) = base
            && exponent > 0
        {
            // sin² θ
            self.raised(exponent, |printer| printer.word(function));
            self.arguments(arguments, is_last);
        } else {
            self.raised(exponent, |printer| {
                printer.term(base, Surroundings::new(Precedence::Atom, false));
            });
        }
    }

    fn raised(&mut self, exponent: i32, base: impl FnOnce(&mut Self)) {
        match self.form {
            Typesetting::Text { .. } => {
                base(self);
                self.push(&superscript_text(&exponent.to_string()));
            }
            Typesetting::MathMl => self.element("msup", |printer| {
                printer.element("mrow", base);
                let (minus, digits) = (if exponent < 0 { "<mo>−</mo>" } else { "" }, exponent.unsigned_abs());
                printer.push(&format!("<mrow>{minus}<mn>{digits}</mn></mrow>"));
            }),
            Typesetting::Latex => {
                // the braces keep two powers apart
                self.element("", base);
                self.push(&format!("^{{{exponent}}}"));
            }
        }
    }

    /// e with the angle above the line.
    fn direction(&mut self, angle: &Notation) {
        let exponent = exponent(angle);
        match self.form {
            Typesetting::Text { is_cis: true } => {
                self.push("cis");
                self.fenced('(', ')', |printer| printer.term(angle, Surroundings::ALONE));
            }
            Typesetting::Text { is_cis: false } => {
                self.push("e^");
                self.fenced('(', ')', |printer| printer.term(&exponent, Surroundings::ALONE));
            }
            Typesetting::MathMl => self.element("msup", |printer| {
                printer.push("<mi mathvariant=\"normal\">e</mi>");
                printer.element("mrow", |printer| printer.term(&exponent, Surroundings::ALONE));
            }),
            Typesetting::Latex => self.element("\\mathrm{e}^", |printer| printer.term(&exponent, Surroundings::ALONE)),
        }
    }

    /// The arguments of a function. A single short one stands without parentheses where nothing can be mistaken for a
    /// part of it.
    fn arguments(&mut self, arguments: &[Notation], is_last: bool) {
        match arguments {
            [only] if is_last && is_short(only) && !self.is_text() => {
                // a command of LaTeX ends with a space
                if self.form == Typesetting::MathMl {
                    self.push("<mspace width=\"0.17em\"></mspace>");
                }
                self.term(only, Surroundings::new(Precedence::Product, true));
            }
            _ => self.list(arguments),
        }
    }

    fn list(&mut self, terms: &[Notation]) {
        self.fenced('(', ')', |printer| {
            for (index, term) in terms.iter().enumerate() {
                if index > 0 {
                    printer.push(match printer.form {
                        Typesetting::MathMl => "<mo>,</mo>",
                        Typesetting::Text { .. } | Typesetting::Latex => ", ",
                    });
                }
                printer.term(term, Surroundings::ALONE);
            }
        });
    }

    fn fenced(&mut self, opening: char, close: char, inside: impl FnOnce(&mut Self)) {
        self.push(&self.form.fence(opening));
        let outside = std::mem::replace(&mut self.is_between_bars, opening == '|');
        inside(self);
        self.is_between_bars = outside;
        let close = self.form.fence(close).replace("prefix", "postfix");
        self.push(&close);
    }

    /// Content within the tags of MathML or the braces of LaTeX.
    fn element(&mut self, name: &str, inside: impl FnOnce(&mut Self)) {
        if self.form == Typesetting::MathMl {
            self.push(&format!("<{name}>"));
            inside(self);
            self.push(&format!("</{name}>"));
        } else {
            self.push(&format!("{name}{{"));
            inside(self);
            self.push("}");
        }
    }
}

/// Whether a number is written with a power of ten.
fn is_scientific(value: f64) -> bool {
    value != 0.0 && !(1e-4..1e7).contains(&value)
}

/// i times an angle, with signs and numbers in front.
fn exponent(angle: &Notation) -> Notation {
    match angle {
        Notation::Negative(of) => exponent(of).negative(),
        Notation::Product(factors) => {
            let numbers = factors
                .iter()
                .take_while(|factor| matches!(factor, Notation::Number(_)))
                .count();
            let mut factors = factors.clone();
            factors.insert(numbers, Notation::Imaginary);
            Notation::Product(factors)
        }
        Notation::Number(_) => Notation::Product(vec![angle.clone(), Notation::Imaginary]),
        other => Notation::Product(vec![Notation::Imaginary, other.clone()]),
    }
}

fn is_call(term: &Notation) -> bool {
    match term {
        Notation::Call(..) => true,
        Notation::Power(base, _) => matches!(**base, Notation::Call("sin" | "cos" | "tan", _)),
        _ => false,
    }
}

/// Whether an argument needs no parentheses: a name, a number, or a number of times a name.
fn is_short(term: &Notation) -> bool {
    match term {
        Notation::Name(_) | Notation::Pi | Notation::Degrees(_) => true,
        Notation::Number(value) => !is_scientific(*value),
        Notation::Product(factors) => match factors.as_slice() {
            [number @ Notation::Number(_), Notation::Name(_) | Notation::Pi] => is_short(number),
            _ => false,
        },
        _ => false,
    }
}

/// Whether a space keeps the factor apart from its neighbours.
fn is_wide(factor: &Notation) -> bool {
    match factor {
        Notation::Name(name) | Notation::Rate(name, _) => name.is_word(),
        Notation::Power(base, _) => is_wide(base),
        Notation::Words(_)
        | Notation::Call(..)
        | Notation::Quotient(..)
        | Notation::Root(_)
        | Notation::Function(..)
        | Notation::Change(..) => true,
        _ => false,
    }
}

/// Whether a factor would be read as the continuation of a number in front of it.
fn begins_with_digit(factor: &Notation) -> bool {
    match factor {
        Notation::Number(value) => !is_scientific(*value),
        Notation::Degrees(_) => true,
        Notation::Power(base, _) => begins_with_digit(base),
        _ => false,
    }
}
