//! Readers of the three forms. They know the rules of the notation, and nothing of the printer.

use std::collections::BTreeMap;

/// A formula as tokens: names, numbers and signs. Structure beyond the line becomes parentheses, `/` and `^`.
type Tokens = Vec<String>;

fn push(tokens: &mut Tokens, token: &str) {
    tokens.push(token.to_owned());
}

/// The right side of the only line of a text.
pub(super) fn text(text: &str) -> Tokens {
    let (_, right) = text.split_once(" = ").expect("an equation");
    let mut tokens = Tokens::new();
    let letters: Vec<char> = right.chars().collect();
    let mut position = 0;
    while let Some(&letter) = letters.get(position) {
        let is_exponent = |letter: &char| "⁻⁰¹²³⁴⁵⁶⁷⁸⁹".contains(*letter);
        let end = |test: &dyn Fn(&char) -> bool| {
            letters[position..]
                .iter()
                .position(|letter| !test(letter))
                .map_or(letters.len(), |count| position + count)
        };
        if letter == ' ' {
            position += 1;
        } else if letter.is_ascii_digit() {
            let end = end(&|letter| letter.is_ascii_digit() || *letter == '.');
            tokens.push(letters[position..end].iter().collect());
            position = end;
        } else if is_exponent(&letter) {
            let end = end(&is_exponent);
            push(&mut tokens, "^");
            let digits = letters[position..end].iter().map(|letter| match letter {
                '⁻' => '-',
                '¹' => '1',
                '²' => '2',
                '³' => '3',
                other => char::from_digit(u32::from(*other) - u32::from('⁰'), 10).expect("a digit"),
            });
            tokens.push(digits.collect());
            position = end;
        } else if letter.is_alphabetic() {
            let end = end(&|letter| letter.is_alphabetic());
            tokens.push(letters[position..end].iter().collect());
            // an index belongs to its name
            position = end + usize::from(letters.get(end) == Some(&'₃'));
        } else {
            tokens.push(letter.to_string());
            position += 1;
        }
    }
    tokens
}

/// The element after a position in MathML: its name, its content, and the position behind it.
fn element(source: &str) -> (&str, &str, &str) {
    let (tag, mut rest) = source
        .strip_prefix('<')
        .and_then(|source| source.split_once('>'))
        .unwrap_or_else(|| panic!("an element begins here: {source}"));
    let name = tag.split(' ').next().unwrap_or_default();
    let content = rest;
    let (opening, close) = (format!("<{name}"), format!("</{name}>"));
    let mut depth = 1;
    loop {
        let end = rest.find(&close).expect("every element ends");
        let begin = rest
            .match_indices(&opening)
            .map(|(position, _)| position)
            .find(|&position| {
                // <m> is no beginning of <mo>
                rest[position + opening.len()..].starts_with([' ', '>'])
            });
        if let Some(begin) = begin.filter(|begin| *begin < end) {
            depth += 1;
            rest = &rest[begin + opening.len()..];
        } else {
            depth -= 1;
            let behind = &rest[end + close.len()..];
            if depth == 0 {
                return (name, &content[..content.len() - behind.len() - close.len()], behind);
            }
            rest = behind;
        }
    }
}

/// The right side of the only line of a table.
pub(super) fn mathml(mathml: &str) -> Tokens {
    let cell = mathml.rsplit_once("<mtd").expect("a cell").1;
    let (_, cell) = cell.split_once('>').expect("a tag");
    let (cell, _) = cell.split_once("</mtd>").expect("its end");
    let mut tokens = Tokens::new();
    mathml_row(cell, &mut tokens);
    assert_eq!(tokens.remove(0), "=");
    tokens
}

fn mathml_row(mut source: &str, tokens: &mut Tokens) {
    while !source.is_empty() {
        let (name, content, rest) = element(source);
        source = rest;
        match name {
            "mi" | "mn" | "mo" => push(tokens, content),
            "mspace" => {}
            "mrow" => mathml_row(content, tokens),
            "msub" => mathml_row(content.split_once("<mn>").expect("an index").0, tokens),
            "mfrac" => {
                let (first, second) = two(content);
                push(tokens, "(");
                push(tokens, "(");
                mathml_row(first, tokens);
                push(tokens, ")");
                push(tokens, "/");
                push(tokens, "(");
                mathml_row(second, tokens);
                push(tokens, ")");
                push(tokens, ")");
            }
            "msup" => {
                let (base, above) = two(content);
                mathml_row(base, tokens);
                push(tokens, "^");
                let mut exponent = Tokens::new();
                mathml_row(above, &mut exponent);
                tokens.push(exponent.concat().replace('−', "-"));
            }
            other => panic!("{other} is not read"),
        }
    }
}

/// Two elements, one behind the other.
fn two(source: &str) -> (&str, &str) {
    let (.., second) = element(source);
    (&source[..source.len() - second.len()], second)
}

/// The right side of the only line of LaTeX.
pub(super) fn latex(latex: &str) -> Tokens {
    let line = latex.lines().nth(1).expect("a line");
    let (_, right) = line.split_once("& = ").expect("an equation");
    let mut tokens = Tokens::new();
    latex_row(right, &mut tokens);
    tokens
}

/// The content of the braces at the beginning, and the rest.
fn braces(source: &str) -> (&str, &str) {
    let mut depth = 0;
    for (position, letter) in source.char_indices() {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return (&source[1..position], &source[position + 1..]);
        }
    }
    panic!("braces are closed: {source}");
}

fn latex_row(mut source: &str, tokens: &mut Tokens) {
    while let Some(letter) = source.chars().next() {
        if let Some(rest) = source.strip_prefix("\\frac") {
            let (first, rest) = braces(rest);
            let (second, rest) = braces(rest);
            push(tokens, "(");
            push(tokens, "(");
            latex_row(first, tokens);
            push(tokens, ")");
            push(tokens, "/");
            push(tokens, "(");
            latex_row(second, tokens);
            push(tokens, ")");
            push(tokens, ")");
            source = rest;
        } else if let Some(rest) = source.strip_prefix("\\, ") {
            source = rest;
        } else if let Some(rest) = source.strip_prefix('\\') {
            let end = rest.find(|letter: char| !letter.is_alphabetic()).unwrap_or(rest.len());
            match &rest[..end] {
                "cdot" => push(tokens, "·"),
                "theta" => push(tokens, "θ"),
                command => push(tokens, command),
            }
            source = &rest[end..];
        } else if letter == '{' {
            let (inside, rest) = braces(source);
            latex_row(inside, tokens);
            source = rest;
        } else if letter == '^' {
            let (inside, rest) = braces(&source[1..]);
            push(tokens, "^");
            push(tokens, inside);
            source = rest;
        } else if letter == '_' {
            source = braces(&source[1..]).1;
        } else if letter.is_ascii_digit() {
            let end = source.find(|letter: char| !letter.is_ascii_digit() && letter != '.');
            let end = end.unwrap_or(source.len());
            push(tokens, &source[..end]);
            source = &source[end..];
        } else {
            if letter != ' ' {
                push(
                    tokens,
                    if letter == '-' {
                        "−"
                    } else {
                        &source[..letter.len_utf8()]
                    },
                );
            }
            source = &source[letter.len_utf8()..];
        }
    }
}

/// The value of a formula. Factors stand side by side. `/` binds as tightly as a product and takes one factor. The
/// argument of a function without parentheses is all that follows up to the next function.
pub(super) fn value(tokens: &[String], names: &BTreeMap<&str, f64>) -> f64 {
    let mut reader = Reader { tokens, next: 0, names };
    let value = reader.sum();
    assert_eq!(reader.next, tokens.len(), "all of {tokens:?} is read");
    value
}

struct Reader<'a> {
    tokens: &'a [String],
    next: usize,
    names: &'a BTreeMap<&'a str, f64>,
}

impl Reader<'_> {
    fn peek(&self) -> Option<&str> {
        self.tokens.get(self.next).map(String::as_str)
    }

    fn take(&mut self, token: &str) -> bool {
        let is_next = self.peek() == Some(token);
        self.next += usize::from(is_next);
        is_next
    }

    fn sum(&mut self) -> f64 {
        let mut sum = if self.take("−") {
            -self.product()
        } else {
            self.product()
        };
        loop {
            if self.take("+") {
                sum += self.product();
            } else if self.take("−") {
                sum -= self.product();
            } else {
                return sum;
            }
        }
    }

    fn begins_factor(&self) -> bool {
        !matches!(self.peek(), None | Some("+" | "−" | ")" | "|" | "/" | "·"))
    }

    fn product(&mut self) -> f64 {
        let mut product = self.power();
        loop {
            if self.take("/") {
                product /= self.power();
            } else if self.take("·") || self.begins_factor() || self.peek() == Some("|") && self.opens() {
                product *= self.power();
            } else {
                return product;
            }
        }
    }

    /// Whether a bar opens an absolute value: an even number of bars is open before it at this depth of parentheses.
    fn opens(&self) -> bool {
        let mut inside_bars = vec![false];
        for token in &self.tokens[..self.next] {
            match token.as_str() {
                "(" => inside_bars.push(false),
                ")" => {
                    inside_bars.pop();
                }
                "|" => {
                    let last = inside_bars.last_mut().expect("parentheses are closed");
                    *last = !*last;
                }
                _ => {}
            }
        }
        !inside_bars.last().expect("parentheses are closed")
    }

    fn power(&mut self) -> f64 {
        let base = self.atom();
        if self.take("^") {
            base.powi(self.exponent())
        } else {
            base
        }
    }

    fn exponent(&mut self) -> i32 {
        let exponent = self.tokens[self.next].parse().expect("a whole number");
        self.next += 1;
        exponent
    }

    fn atom(&mut self) -> f64 {
        let token = self.peek().expect("a formula goes on").to_owned();
        self.next += 1;
        match token.as_str() {
            "(" => {
                let value = self.sum();
                assert!(self.take(")"), "a parenthesis is closed");
                value
            }
            "|" => {
                let value = self.sum();
                assert!(self.take("|"), "a bar is closed");
                value.abs()
            }
            "sin" | "cos" | "arctan" => {
                let exponent = if self.take("^") { self.exponent() } else { 1 };
                let argument = self.argument();
                let value = match token.as_str() {
                    "sin" => argument.sin(),
                    "cos" => argument.cos(),
                    _ => argument.atan(),
                };
                value.powi(exponent)
            }
            other => other
                .parse()
                .ok()
                .or_else(|| self.names.get(other).copied())
                .unwrap_or_else(|| panic!("{other} is neither a number nor a name")),
        }
    }

    /// Parentheses, or all factors up to the next function.
    fn argument(&mut self) -> f64 {
        if self.peek() == Some("(") {
            return self.atom();
        }
        let mut argument = self.power();
        while self.begins_factor() && !matches!(self.peek(), Some("sin" | "cos" | "arctan")) {
            argument *= self.power();
        }
        argument
    }
}

/// Every element of a document is closed in the order of opening, and no letter stands for another.
pub(super) fn assert_well_formed(mathml: &str, context: &str) {
    let mut unclosed = Vec::new();
    let mut rest = mathml;
    while let Some(begin) = rest.find(['<', '&', '>']) {
        let end = |end: char| rest[begin..].find(end).unwrap_or_else(|| panic!("{context}: {rest}"));
        match &rest[begin..=begin] {
            "&" => {
                let entity = &rest[begin..=begin + end(';')];
                assert!(
                    ["&lt;", "&gt;", "&amp;", "&#36;"].contains(&entity),
                    "{context}: {entity}"
                );
                rest = &rest[begin + 1..];
            }
            "<" => {
                let tag = &rest[begin + 1..begin + end('>')];
                match tag.strip_prefix('/') {
                    Some(name) => assert_eq!(unclosed.pop(), Some(name), "{context}"),
                    None => unclosed.push(tag.split(' ').next().unwrap_or_default()),
                }
                assert_eq!(tag.matches('"').count() % 2, 0, "{context}: {tag}");
                rest = &rest[begin + end('>') + 1..];
            }
            _ => panic!("{context}: a stray >"),
        }
    }
    assert!(unclosed.is_empty(), "{context}: {unclosed:?} are unclosed");
}
