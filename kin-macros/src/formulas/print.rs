//! Terms as text, MathML and LaTeX, by one printer.

use super::Formula;
use super::form::{Form, superscript_text};
use super::name::Name;
use super::term::{Line, Term};
use crate::precedence::Precedence;

/// The cell before a relation. Chromium knows no `columnalign`, and others no `-webkit-right`.
const RIGHT: &str = "<mtd style=\"text-align:-webkit-right;padding-right:0\">";

/// The cell that begins with a relation.
const LEFT: &str = "<mtd style=\"text-align:-webkit-left;padding-left:0\">";

/// Lines below each other, with their relations below each other, in all three forms.
pub(super) fn formula(lines: &[Line], is_cis: bool) -> Formula {
    let both = |line: &Line, form: Form| {
        let right = Printer::of(&line.right, form, &form.operator(line.relation));
        (Printer::of(&line.left, form, ""), right)
    };
    let text: Vec<String> = lines
        .iter()
        .map(|line| {
            let (left, right) = both(line, Form::Text { is_cis });
            format!("{left}{right}")
        })
        .collect();
    let mathml: String = lines
        .iter()
        .map(|line| {
            let (left, right) = both(line, Form::MathMl);
            ["<mtr>", RIGHT, &left, "</mtd>", LEFT, &right, "</mtd></mtr>"].concat()
        })
        .collect();
    let latex: Vec<String> = lines
        .iter()
        .map(|line| {
            let (left, right) = both(line, Form::Latex);
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
            "<math xmlns=\"http://www.w3.org/1998/Math/MathML\" display=\"block\"><mtable displaystyle=\"true\" columnalign=\"right left\">{mathml}</mtable></math>"
        ),
        latex: format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", latex.join(" \\\\\n")),
    }
}

/// Prints terms one after the other.
struct Printer {
    form: Form,
    text: String,
    /// Whether the nearest fence outside is a bar, which cannot be told from a second one.
    is_between_bars: bool,
}

/// The surroundings of a formula.
#[derive(Clone, Copy)]
struct Place {
    precedence: Precedence,
    /// Whether nothing follows in the same product that could be taken for a part of an argument.
    is_last: bool,
}

impl Place {
    const fn new(precedence: Precedence, is_last: bool) -> Self {
        Self { precedence, is_last }
    }

    /// A place between fences or lines.
    const ALONE: Self = Self::new(Precedence::Sum, true);
}

impl Printer {
    /// A term behind a beginning.
    fn of(term: &Term, form: Form, beginning: &str) -> String {
        let mut printer = Self {
            form,
            text: beginning.to_owned(),
            is_between_bars: false,
        };
        printer.term(term, Place::ALONE);
        printer.text
    }

    fn push(&mut self, text: &str) {
        self.text.push_str(text);
    }

    const fn is_text(&self) -> bool {
        matches!(self.form, Form::Text { .. })
    }

    /// How tightly the outermost operator binds. A fraction with a bar needs parentheses only as the base of a power.
    fn precedence(&self, term: &Term) -> Precedence {
        match term {
            Term::Sum(_) | Term::Negative(_) | Term::Either(_) => Precedence::Sum,
            Term::Product(_) | Term::Dot(..) | Term::Cross(..) => Precedence::Product,
            Term::Number(value) if is_scientific(*value) => Precedence::Product,
            Term::Quotient(..) if self.is_text() => Precedence::Product,
            Term::Quotient(..) | Term::Power(..) | Term::Direction(_) | Term::Call(..) => Precedence::Sign,
            Term::Number(_)
            | Term::Degrees(_)
            | Term::Pi
            | Term::Imaginary
            | Term::Dots
            | Term::Words(_)
            | Term::Name(_)
            | Term::Rate(..)
            | Term::Change(..)
            | Term::Root(_)
            | Term::Norm(_)
            | Term::Function(..)
            | Term::Tuple(_) => Precedence::Atom,
        }
    }

    fn term(&mut self, term: &Term, place: Place) {
        let own = self.precedence(term);
        // a time derivative above the line would be taken for a power, and the other way round
        let is_crowded = place.precedence == Precedence::Atom && matches!(term, Term::Rate(_, 3..));
        let is_in_bars = self.is_between_bars && matches!(term, Term::Norm(_));
        if own.needs_parentheses(place.precedence) || is_crowded || is_in_bars {
            self.fenced('(', ')', |printer| printer.bare(term, Place::ALONE));
        } else {
            self.bare(term, place);
        }
    }

    /// A term without parentheses around it.
    fn bare(&mut self, term: &Term, place: Place) {
        match term {
            Term::Number(value) => self.number(*value),
            Term::Degrees(value) => {
                self.number(*value);
                let sign = if self.form == Form::Latex { "^{\\circ}" } else { "°" };
                if self.form == Form::MathMl {
                    self.push("<mi mathvariant=\"normal\">°</mi>");
                } else {
                    self.push(sign);
                }
            }
            Term::Pi => self.word("π"),
            Term::Imaginary => self.word("i"),
            Term::Dots => self.push(match self.form {
                Form::Text { .. } => "…",
                Form::MathMl => "<mi>…</mi>",
                Form::Latex => "\\dots",
            }),
            Term::Name(name) => self.name(name, 0),
            Term::Rate(name, order) => self.name(name, *order),
            Term::Change(letter, name) => {
                match (self.form, letter) {
                    (Form::Latex, '∂') => self.push("\\partial "),
                    (Form::Latex, _) => self.push("\\Delta "),
                    (Form::MathMl, _) => self.push(&format!("<mi mathvariant=\"normal\">{letter}</mi>")),
                    (Form::Text { .. }, _) => self.text.push(*letter),
                }
                self.name(name, 0);
            }
            Term::Words(words) => self.push(&match self.form {
                Form::Text { .. } => (*words).to_owned(),
                Form::MathMl => format!("<mtext>{words}</mtext>"),
                Form::Latex => format!("\\text{{{words}}}"),
            }),
            Term::Negative(of) => {
                self.push(&self.form.sign("−"));
                self.term(of, Place::new(Precedence::Product, place.is_last));
            }
            Term::Either(of) => {
                self.push(&self.form.sign("±"));
                self.term(of, Place::new(Precedence::Product, place.is_last));
            }
            Term::Sum(terms) => self.sum(terms),
            Term::Product(factors) => self.product(factors, place.is_last),
            Term::Dot(left, right) => self.two(left, "·", right),
            Term::Cross(left, right) => self.two(left, "×", right),
            Term::Quotient(dividend, divisor) => self.quotient(dividend, divisor),
            Term::Power(base, exponent) => self.power(base, *exponent, place.is_last),
            Term::Direction(angle) => self.direction(angle),
            Term::Root(of) => match self.form {
                Form::Text { .. } => {
                    self.push("√");
                    self.fenced('(', ')', |printer| printer.term(of, Place::ALONE));
                }
                Form::MathMl => self.element("msqrt", |printer| printer.term(of, Place::ALONE)),
                Form::Latex => self.element("\\sqrt", |printer| printer.term(of, Place::ALONE)),
            },
            Term::Norm(of) => self.fenced('|', '|', |printer| printer.term(of, Place::ALONE)),
            Term::Call(function, arguments) => {
                self.word(function);
                self.arguments(arguments, place.is_last);
            }
            Term::Function(name, arguments) => {
                self.name(name, 0);
                self.list(arguments);
            }
            Term::Tuple(terms) => self.list(terms),
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
            Form::Text { .. } => self.push(&format!("10{}", superscript_text(exponent))),
            Form::MathMl => {
                let minus = if exponent.starts_with('-') { "<mo>−</mo>" } else { "" };
                let digits = exponent.trim_start_matches('-');
                self.push(&format!(
                    "<msup><mn>10</mn><mrow>{minus}<mn>{digits}</mn></mrow></msup>"
                ));
            }
            Form::Latex => self.push(&format!("10^{{{exponent}}}")),
        }
    }

    fn sum(&mut self, terms: &[Term]) {
        for (index, term) in terms.iter().enumerate() {
            let (sign, of) = match term {
                Term::Negative(of) => ("−", &**of),
                Term::Either(of) => ("±", &**of),
                _ => ("+", term),
            };
            if index == 0 {
                self.term(term, Place::ALONE);
            } else {
                self.push(&self.form.operator(sign));
                self.term(of, Place::new(Precedence::Product, true));
            }
        }
    }

    fn product(&mut self, factors: &[Term], is_last: bool) {
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
            let place = match factor {
                Term::Number(_) if index == 0 => Precedence::Product,
                _ => Precedence::Sign,
            };
            self.term(factor, Place::new(place, is_last));
        }
    }

    /// Two vectors with the sign of their product between them.
    fn two(&mut self, left: &Term, operator: &str, right: &Term) {
        self.term(left, Place::new(Precedence::Sign, false));
        self.push(&self.form.operator(operator));
        self.term(right, Place::new(Precedence::Sign, false));
    }

    fn quotient(&mut self, dividend: &Term, divisor: &Term) {
        match self.form {
            Form::Text { .. } => {
                self.term(dividend, Place::new(Precedence::Product, false));
                self.push("/");
                self.term(divisor, Place::new(Precedence::Sign, false));
            }
            Form::MathMl => self.element("mfrac", |printer| {
                printer.element("mrow", |printer| printer.term(dividend, Place::ALONE));
                printer.element("mrow", |printer| printer.term(divisor, Place::ALONE));
            }),
            Form::Latex => {
                self.element("\\frac", |printer| printer.term(dividend, Place::ALONE));
                self.element("", |printer| printer.term(divisor, Place::ALONE));
            }
        }
    }

    fn power(&mut self, base: &Term, exponent: i32, is_last: bool) {
        if let Term::Call(function @ ("sin" | "cos" | "tan"), arguments) = base
            && exponent > 0
        {
            // sin² θ
            self.raised(exponent, |printer| printer.word(function));
            self.arguments(arguments, is_last);
        } else {
            self.raised(exponent, |printer| {
                printer.term(base, Place::new(Precedence::Atom, false));
            });
        }
    }

    fn raised(&mut self, exponent: i32, base: impl FnOnce(&mut Self)) {
        match self.form {
            Form::Text { .. } => {
                base(self);
                self.push(&superscript_text(&exponent.to_string()));
            }
            Form::MathMl => self.element("msup", |printer| {
                printer.element("mrow", base);
                let (minus, digits) = (if exponent < 0 { "<mo>−</mo>" } else { "" }, exponent.unsigned_abs());
                printer.push(&format!("<mrow>{minus}<mn>{digits}</mn></mrow>"));
            }),
            Form::Latex => {
                // the braces keep two powers apart
                self.element("", base);
                self.push(&format!("^{{{exponent}}}"));
            }
        }
    }

    /// e with the angle above the line.
    fn direction(&mut self, angle: &Term) {
        let exponent = exponent(angle);
        match self.form {
            Form::Text { is_cis: true } => {
                self.push("cis");
                self.fenced('(', ')', |printer| printer.term(angle, Place::ALONE));
            }
            Form::Text { is_cis: false } => {
                self.push("e^");
                self.fenced('(', ')', |printer| printer.term(&exponent, Place::ALONE));
            }
            Form::MathMl => self.element("msup", |printer| {
                printer.push("<mi mathvariant=\"normal\">e</mi>");
                printer.element("mrow", |printer| printer.term(&exponent, Place::ALONE));
            }),
            Form::Latex => self.element("\\mathrm{e}^", |printer| printer.term(&exponent, Place::ALONE)),
        }
    }

    /// The arguments of a function. A single short one stands without parentheses where nothing can be mistaken for a
    /// part of it.
    fn arguments(&mut self, arguments: &[Term], is_last: bool) {
        match arguments {
            [only] if is_last && is_short(only) && !self.is_text() => {
                // a command of LaTeX ends with a space of its own
                if self.form == Form::MathMl {
                    self.push("<mspace width=\"0.17em\"></mspace>");
                }
                self.term(only, Place::new(Precedence::Product, true));
            }
            _ => self.list(arguments),
        }
    }

    fn list(&mut self, terms: &[Term]) {
        self.fenced('(', ')', |printer| {
            for (index, term) in terms.iter().enumerate() {
                if index > 0 {
                    printer.push(match printer.form {
                        Form::MathMl => "<mo>,</mo>",
                        Form::Text { .. } | Form::Latex => ", ",
                    });
                }
                printer.term(term, Place::ALONE);
            }
        });
    }

    fn fenced(&mut self, open: char, close: char, inside: impl FnOnce(&mut Self)) {
        self.push(&self.form.fence(open));
        let outside = std::mem::replace(&mut self.is_between_bars, open == '|');
        inside(self);
        self.is_between_bars = outside;
        let close = self.form.fence(close).replace("prefix", "postfix");
        self.push(&close);
    }

    /// Content within the tags of MathML or the braces of LaTeX.
    fn element(&mut self, name: &str, inside: impl FnOnce(&mut Self)) {
        if self.form == Form::MathMl {
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
fn exponent(angle: &Term) -> Term {
    match angle {
        Term::Negative(of) => exponent(of).negative(),
        Term::Product(factors) => {
            let numbers = factors
                .iter()
                .take_while(|factor| matches!(factor, Term::Number(_)))
                .count();
            let mut factors = factors.clone();
            factors.insert(numbers, Term::Imaginary);
            Term::Product(factors)
        }
        Term::Number(_) => Term::Product(vec![angle.clone(), Term::Imaginary]),
        other => Term::Product(vec![Term::Imaginary, other.clone()]),
    }
}

fn is_call(term: &Term) -> bool {
    match term {
        Term::Call(..) => true,
        Term::Power(base, _) => matches!(**base, Term::Call("sin" | "cos" | "tan", _)),
        _ => false,
    }
}

/// Whether an argument needs no parentheses: a name, a number, or a number of times a name.
fn is_short(term: &Term) -> bool {
    match term {
        Term::Name(_) | Term::Pi | Term::Degrees(_) => true,
        Term::Number(value) => !is_scientific(*value),
        Term::Product(factors) => match factors.as_slice() {
            [number @ Term::Number(_), Term::Name(_) | Term::Pi] => is_short(number),
            _ => false,
        },
        _ => false,
    }
}

/// Whether a space keeps the factor apart from its neighbours.
fn is_wide(factor: &Term) -> bool {
    match factor {
        Term::Name(name) | Term::Rate(name, _) => name.is_word(),
        Term::Power(base, _) => is_wide(base),
        Term::Words(_)
        | Term::Call(..)
        | Term::Quotient(..)
        | Term::Root(_)
        | Term::Function(..)
        | Term::Change(..) => true,
        _ => false,
    }
}

/// Whether a factor would be read as the continuation of a number in front of it.
fn begins_with_digit(factor: &Term) -> bool {
    match factor {
        Term::Number(value) => !is_scientific(*value),
        Term::Degrees(_) => true,
        Term::Power(base, _) => begins_with_digit(base),
        _ => false,
    }
}
