//! The three forms of a formula, letter by letter: text, MathML and LaTeX.

use std::fmt::Write as _;

use super::name::{Base, Name, command};

/// The form in which a formula is printed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Typesetting {
    /// Text for a terminal or an editor.
    Text {
        /// Whether a name looks like the base or the imaginary unit of e^(iθ). Then cis(θ) is written instead.
        is_cis: bool,
    },
    MathMl,
    Latex,
}

impl Typesetting {
    /// A name with its indices, and a time derivative of it.
    pub(super) fn name(self, name: &Name, order: usize) -> String {
        let total = name.dots + order;
        let (dots, superscript) = if total > 2 { (name.dots, order) } else { (total, 0) };
        match self {
            Self::Text { .. } => text(name, dots, superscript),
            Self::MathMl => mathml(name, dots, superscript),
            Self::Latex => latex(name, dots, superscript),
        }
    }

    /// A word or a sign in upright letters.
    pub(super) fn word(self, word: &str) -> String {
        match self {
            Self::Text { .. } => word.to_owned(),
            Self::MathMl => {
                let upright = if word.chars().count() == 1 {
                    " mathvariant=\"normal\""
                } else {
                    ""
                };
                format!("<mi{upright}>{}</mi>", escaped(word))
            }
            Self::Latex => match word {
                "sin" | "cos" | "tan" | "arcsin" | "arccos" | "arctan" | "sinh" | "cosh" | "tanh" | "exp" | "ln"
                | "arg" => format!("\\{word}"),
                "π" => "\\pi".to_owned(),
                _ if word.chars().count() == 1 => format!("\\mathrm{{{word}}}"),
                _ => format!("\\operatorname{{{}}}", escaped_for_latex(word)),
            },
        }
    }

    /// An operator or a relation.
    pub(super) fn operator(self, operator: &str) -> String {
        match self {
            Self::Text { .. } => format!(" {operator} "),
            Self::MathMl => format!("<mo>{}</mo>", escaped(operator)),
            Self::Latex => match operator {
                "−" => " - ".to_owned(),
                "±" => " \\pm ".to_owned(),
                "·" => " \\cdot ".to_owned(),
                "×" => " \\times ".to_owned(),
                "≤" => " \\le ".to_owned(),
                "≥" => " \\ge ".to_owned(),
                other => format!(" {other} "),
            },
        }
    }

    /// A sign in front of a formula.
    pub(super) fn sign(self, sign: &str) -> String {
        match self {
            Self::Text { .. } => sign.to_owned(),
            Self::MathMl => format!("<mo form=\"prefix\">{sign}</mo>"),
            Self::Latex => if sign == "±" { "\\pm " } else { "-" }.to_owned(),
        }
    }

    /// An opening or closing sign, which does not grow with what it encloses.
    pub(super) fn fence(self, fence: char) -> String {
        match self {
            Self::Text { .. } => fence.to_string(),
            Self::MathMl => {
                // a bar in front would be taken for one behind
                let form = if fence == '|' { " form=\"prefix\"" } else { "" };
                format!("<mo stretchy=\"false\"{form}>{fence}</mo>")
            }
            Self::Latex => fence.to_string(),
        }
    }

    /// A digit string.
    pub(super) fn digits(self, digits: &str) -> String {
        match self {
            Self::MathMl => format!("<mn>{digits}</mn>"),
            Self::Text { .. } | Self::Latex => digits.to_owned(),
        }
    }

    /// The space between two factors; `is_wide` if one of them is a word.
    pub(super) const fn between_factors(self, is_wide: bool) -> &'static str {
        match (self, is_wide) {
            (Self::Text { .. }, _) | (Self::Latex, false) => " ",
            (Self::MathMl, true) => "<mspace width=\"0.17em\"></mspace>",
            (Self::MathMl, false) => "",
            (Self::Latex, true) => " \\, ",
        }
    }
}

fn text(name: &Name, dots: usize, superscript: usize) -> String {
    let mut text = match &name.base {
        Base::Letter(letter) => letter.to_string(),
        Base::Word(word) => word.clone(),
    };
    text.push_str(["", "\u{307}", "\u{308}"].get(dots).copied().unwrap_or_default());
    for index in &name.indices {
        if index.chars().all(|digit| digit.is_ascii_digit()) && !text.contains('_') {
            text.extend(index.chars().map(|digit| in_unicode(digit, '₀')));
        } else {
            text.push('_');
            text.push_str(index);
        }
    }
    text.push_str(&"′".repeat(name.primes));
    if superscript > 0 {
        let _ = write!(text, "⁽{}⁾", superscript_text(&superscript.to_string()));
    }
    text
}

fn mathml(name: &Name, dots: usize, superscript: usize) -> String {
    let (style, upright) = if name.is_vector {
        (" style=\"font-weight:bold\"", " mathvariant=\"normal\"")
    } else {
        ("", "")
    };
    let mut base = match &name.base {
        Base::Letter(letter) => format!("<mi{upright}{style}>{}</mi>", escaped(&letter.to_string())),
        Base::Word(word) => format!("<mi{style}>{}</mi>", escaped(word)),
    };
    if let Some(accent) = ["", "˙", "¨"].get(dots).filter(|accent| !accent.is_empty()) {
        // without a font for mathematics, dots touch tall letters
        base = format!("<mover accent=\"true\">{base}<mo style=\"padding-bottom:0.15em\">{accent}</mo></mover>");
    }
    let below = name.indices.join(",");
    let below = match below.chars().next() {
        None => String::new(),
        Some(digit) if digit.is_ascii_digit() && name.indices.len() == 1 => format!("<mn>{below}</mn>"),
        Some(_) => format!("<mi>{}</mi>", escaped(&below)),
    };
    let above = if superscript > 0 {
        format!("<mrow><mo stretchy=\"false\">(</mo><mn>{superscript}</mn><mo stretchy=\"false\">)</mo></mrow>")
    } else if name.primes > 0 {
        format!("<mo>{}</mo>", "′".repeat(name.primes))
    } else {
        String::new()
    };
    match (below.is_empty(), above.is_empty()) {
        (true, true) => base,
        (false, true) => format!("<msub>{base}{below}</msub>"),
        (true, false) => format!("<msup>{base}{above}</msup>"),
        (false, false) => format!("<msubsup>{base}{below}{above}</msubsup>"),
    }
}

fn latex(name: &Name, dots: usize, superscript: usize) -> String {
    let mut latex = match &name.base {
        Base::Letter(letter) => command(*letter).map_or_else(|| letter.to_string(), ToOwned::to_owned),
        Base::Word(word) => format!("\\mathrm{{{}}}", escaped_for_latex(word)),
    };
    if name.is_vector {
        latex = format!("\\boldsymbol{{{latex}}}");
    }
    latex = match dots {
        0 => latex,
        1 => format!("\\dot{{{latex}}}"),
        _ => format!("\\ddot{{{latex}}}"),
    };
    if !name.indices.is_empty() {
        let indices: Vec<String> = name.indices.iter().map(|index| latex_index(index)).collect();
        let _ = write!(latex, "_{{{}}}", indices.join(","));
    }
    let primes = "\\prime".repeat(name.primes);
    match (superscript, primes.is_empty()) {
        (0, true) => {}
        (0, false) => {
            let _ = write!(latex, "^{{{primes}}}");
        }
        (order, _) => {
            let _ = write!(latex, "^{{{primes}({order})}}");
        }
    }
    latex
}

fn latex_index(index: &str) -> String {
    let mut letters = index.chars();
    match (letters.next(), letters.next()) {
        (Some(letter), None) => command(letter).map_or_else(|| index.to_owned(), ToOwned::to_owned),
        _ if index.chars().all(|digit| digit.is_ascii_digit()) => index.to_owned(),
        _ => format!("\\mathrm{{{}}}", escaped_for_latex(index)),
    }
}

/// A whole number above the line, in Unicode.
pub(super) fn superscript_text(number: &str) -> String {
    number
        .chars()
        .map(|sign| match sign {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            digit => in_unicode(digit, '⁰'),
        })
        .collect()
}

/// A digit in the row of Unicode digits that begins with `zero`.
fn in_unicode(digit: char, zero: char) -> char {
    digit
        .to_digit(10)
        .and_then(|value| char::from_u32(u32::from(zero) + value))
        .unwrap_or(digit)
}

/// Text between the tags of a documentation page. The dollar sign is replaced because it may begin a formula there.
pub(super) fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '$' => escaped.push_str("&#36;"),
            _ => escaped.push(letter),
        }
    }
    escaped
}

/// Text between the commands of LaTeX.
pub(super) fn escaped_for_latex(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '\\' => escaped.push_str("\\backslash{}"),
            '_' | '$' | '%' | '&' | '#' | '{' | '}' => {
                escaped.push('\\');
                escaped.push(letter);
            }
            '^' => escaped.push_str("\\hat{}"),
            '~' => escaped.push_str("\\sim{}"),
            _ => escaped.push(letter),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    /// No letter ends a tag or begins another formula.
    #[test]
    fn letters_with_a_meaning_are_escaped() {
        assert_eq!(escaped("a<b>&$"), "a&lt;b&gt;&amp;&#36;");
        assert_eq!(escaped_for_latex("a_b$%&#{}"), "a\\_b\\$\\%\\&\\#\\{\\}");
        assert_eq!(escaped_for_latex("\\^~"), "\\backslash{}\\hat{}\\sim{}");
    }

    #[test]
    fn names_look_as_in_a_book() {
        let name = Name::of_identifier("theta3");
        let text = Typesetting::Text { is_cis: false };
        let all =
            |name: &Name, order| [text, Typesetting::MathMl, Typesetting::Latex].map(|form| form.name(name, order));
        assert_eq!(
            all(&name, 0),
            ["θ₃", "<msub><mi>θ</mi><mn>3</mn></msub>", "\\theta_{3}"]
        );
        assert_eq!(
            all(&name, 1),
            [
                "θ\u{307}₃",
                "<msub><mover accent=\"true\"><mi>θ</mi><mo \
                 style=\"padding-bottom:0.15em\">˙</mo></mover><mn>3</mn></msub>",
                "\\dot{\\theta}_{3}"
            ]
        );
        assert_eq!(
            all(&name, 3),
            [
                "θ₃⁽³⁾",
                "<msubsup><mi>θ</mi><mn>3</mn><mrow><mo stretchy=\"false\">(</mo><mn>3</mn>\
                 <mo stretchy=\"false\">)</mo></mrow></msubsup>",
                "\\theta_{3}^{(3)}"
            ]
        );
        let vector = Name::of_identifier("p").marked_as_vector(true);
        assert_eq!(
            all(&vector, 0),
            [
                "p",
                "<mi mathvariant=\"normal\" style=\"font-weight:bold\">p</mi>",
                "\\boldsymbol{p}"
            ]
        );
        let word = Name::of_identifier("lower_axle1");
        assert_eq!(
            all(&word, 0),
            [
                "lower_axle1",
                "<msub><mi>lower</mi><mi>axle1</mi></msub>",
                "\\mathrm{lower}_{\\mathrm{axle1}}"
            ]
        );
    }
}
