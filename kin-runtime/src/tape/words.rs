//! Names and comments of other languages.

use std::collections::BTreeSet;
use std::format;
use std::string::{String, ToString as _};
use std::vec::Vec;

use crate::quantity::{GREEK, RATES, in_small_letters};

/// Distinct names, none of which is a word of the language.
pub(crate) struct DistinctNames {
    keywords: &'static [&'static str],
    taken: BTreeSet<String>,
}

impl DistinctNames {
    pub(crate) fn new(keywords: &'static [&'static str]) -> Self {
        Self {
            keywords,
            taken: BTreeSet::new(),
        }
    }

    /// An identifier for a name as declared, different from all before.
    pub(crate) fn name(&mut self, declared: &str) -> String {
        let plain = identifier(declared);
        // Printers name their variables so.
        let is_value = |name: &str| {
            let is_number = |rest: &str| rest.parse::<u32>().is_ok();
            let is_array = |(head, rest): (&str, &str)| ARRAYS.contains(&head) && is_number(rest);
            name.strip_prefix('v').is_some_and(is_number) || name.rsplit_once('_').is_some_and(is_array)
        };
        let mut name = plain.clone();
        if self.keywords.contains(&plain.as_str()) || is_value(&plain) {
            name.push('_');
        }
        let mut number = 2;
        while !self.taken.insert(name.clone()) {
            name = format!("{plain}_{number}");
            number += 1;
        }
        name
    }
}

/// The beginnings of the names of the variables of a printer.
const ARRAYS: [&str; 10] = [
    "guess", "sizes", "given", "block", "roots", "found", "factors", "regular", "right", "solution",
];

/// A name in letters, digits and underscores that begins with a letter.
pub(crate) fn identifier(declared: &str) -> String {
    let declared = declared.strip_prefix("r#").unwrap_or(declared);
    let mut name = String::new();
    for letter in declared.chars() {
        let greek = |wanted: char| {
            GREEK
                .iter()
                .find(|(letter_of_name, _)| *letter_of_name == wanted)
                .map(|(_, word)| *word)
        };
        let lower = letter.to_lowercase().next().unwrap_or(letter);
        if letter.is_ascii_alphanumeric() || letter == '_' {
            name.push(letter);
        } else if letter == '.' {
            name.push('_');
        } else if let Some(word) = greek(letter) {
            name.push_str(word);
        } else if let Some(word) = greek(lower) {
            name.push_str(&word[..1].to_uppercase());
            name.push_str(&word[1..]);
        } else {
            let code = format!("u{:x}", u32::from(letter));
            name.push_str(&code);
        }
    }
    // Names that begin with an underscore belong to the language.
    let name = name.trim_start_matches('_').to_string();
    match name.chars().next() {
        Some(first) if first.is_ascii_alphabetic() => name,
        _ => format!("n{name}"),
    }
}

/// A type's name as an identifier in small letters, with underscores: `FourBar` becomes `four_bar`.
pub(crate) fn snake(name: &str) -> String {
    in_small_letters(&identifier(name), '_')
}

/// The words of a text in lines of at most `width` letters. Control letters become blanks, so that a text has no line
/// separators and no marks of direction.
pub(super) fn lines(text: &str, width: usize) -> Vec<String> {
    let is_mark = |letter: char| {
        letter.is_control()
            || matches!(
                letter,
                '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}'
            )
    };
    let text: String = text
        .chars()
        .map(|letter| if is_mark(letter) { ' ' } else { letter })
        .collect();
    let mut lines = Vec::new();
    let mut line = String::new();
    for word in text.split_whitespace() {
        if !line.is_empty() && line.chars().count() + 1 + word.chars().count() > width {
            lines.push(core::mem::take(&mut line));
        }
        if !line.is_empty() {
            line.push(' ');
        }
        line.push_str(word);
    }
    if !line.is_empty() {
        lines.push(line);
    }
    lines
}

/// The name of a time derivative: `theta3`, `theta3_velocity` and so on.
pub(super) fn of_order(name: &str, order: usize) -> String {
    match order.checked_sub(1) {
        None => name.to_string(),
        Some(rate) => RATES
            .get(rate)
            .map_or_else(|| format!("{name}_derivative_{order}"), |rate| format!("{name}_{rate}")),
    }
}

/// A string literal of JavaScript or Python.
pub(crate) fn quoted(text: &str) -> String {
    let text = lines(text, usize::MAX).concat();
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use super::{DistinctNames, lines, snake};

    #[test]
    fn names_are_distinct_and_are_no_keywords() {
        let mut names = DistinctNames::new(&["int", "double"]);
        let declared = [
            "p.x", "p_x", "int", "int_", "θ", "theta", "Θ2", "v12", "_a", "__b", "2x", "été", "r#double",
        ];
        let distinct = declared.map(|name| names.name(name));
        let expected = [
            "p_x", "p_x_2", "int_", "int__2", "theta", "theta_2", "Theta2", "v12_", "a", "b", "n2x", "ue9tue9",
            "double_",
        ];
        assert_eq!(distinct, expected);
    }

    #[test]
    fn types_become_small_letters() {
        let snakes = ["FourBar", "WattIIByCouplers", "Rssr", "StephensonIII"].map(snake);
        assert_eq!(snakes, ["four_bar", "watt_ii_by_couplers", "rssr", "stephenson_iii"]);
    }

    #[test]
    fn lines_hold_no_separators() {
        assert_eq!(
            lines("one\ntwo\u{2028}three  four\\", 9),
            ["one two", "three", "four\\"]
        );
        assert!(lines(" \n", 10).is_empty());
    }
}
