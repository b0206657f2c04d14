//! Names as they are printed: `theta2` is θ₂. The rule is that of [`FORMULAS`](kin_core::Mechanism::FORMULAS).

use kin_core::GREEK;

/// A name as it is printed; the coordinates of a point keep their dot: `hand.x`.
pub(crate) fn symbol(name: &str) -> String {
    match name.split_once('.') {
        Some((point, coordinate)) => format!("{}.{coordinate}", of_identifier(point)),
        None => of_identifier(name),
    }
}

fn of_identifier(name: &str) -> String {
    let mut parts = name.split('_').filter(|part| !part.is_empty());
    let Some(first) = parts.next() else {
        return name.to_owned();
    };
    let stem = first.trim_end_matches(|digit: char| digit.is_ascii_digit());
    if stem.is_empty() {
        return name.to_owned();
    }
    let mut text = greek(stem);
    let mut add = |index: &str| {
        if index.chars().all(|digit| digit.is_ascii_digit()) && !text.contains('_') {
            text.extend(index.chars().map(below_the_line));
        } else {
            text.push('_');
            text.push_str(&greek(index));
        }
    };
    let digits = &first[stem.len()..];
    if !digits.is_empty() {
        add(digits);
    }
    parts.for_each(add);
    text
}

/// The letters that replace their names. π is a number, and the letters that are missing look like Latin letters.
const NAMED: &str = "αβγδεζηθικλμνξρστυφχψωΓΔΘΛΞΠΣΦΨΩ";

fn greek(word: &str) -> String {
    let is_capital = word.starts_with(char::is_uppercase);
    let is_name = !word.chars().skip(1).any(char::is_uppercase);
    let name = word.to_lowercase();
    let found = GREEK.iter().find(|(_, greek)| is_name && *greek == name);
    let letter = found.map(|(letter, _)| {
        if is_capital {
            letter.to_uppercase().to_string()
        } else {
            letter.to_string()
        }
    });
    letter
        .filter(|letter| NAMED.contains(letter.as_str()))
        .unwrap_or_else(|| word.to_owned())
}

fn below_the_line(digit: char) -> char {
    digit
        .to_digit(10)
        .and_then(|value| char::from_u32(u32::from('₀') + value))
        .unwrap_or(digit)
}

#[cfg(test)]
mod tests {
    use super::symbol;

    #[test]
    fn names_are_letters_with_indices() {
        for (name, text) in [
            ("theta2", "θ₂"),
            ("r1", "r₁"),
            ("r_12", "r₁₂"),
            ("left_rod", "left_rod"),
            ("left_rod2", "left_rod2"),
            ("beta_phi", "β_φ"),
            ("hand.x", "hand.x"),
            ("p1.y", "p₁.y"),
            ("pi", "pi"),
            ("Omega1", "Ω₁"),
            ("Alpha", "Alpha"),
            ("OMEGA", "OMEGA"),
            ("omicron", "omicron"),
        ] {
            assert_eq!(symbol(name), text);
        }
    }
}
