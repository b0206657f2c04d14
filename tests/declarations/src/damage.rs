//! Near misses: sound declarations with a few tokens changed.

use crate::names;
use crate::numbers;
use crate::random::Random;

/// Words and signs of the language, and of Rust.
const VOCABULARY: &str = "struct enum input unknown let output order with where in test sensitivities \
    transmission_angles Length Angle Scalar Point Vector Point3 Vector3 Direction PI sin cos tan asin acos atan \
    atan2 sqrt exp ln powi cis polar vec2 \
    vec3 rot_x rot dot cross norm x y z ; , : = == != + - * / % ** < <= > >= .. ..= ... . :: -> => & && | || ! ? @ # \
    $ ~ ^ += << _ () [] {} (0)";

/// A declaration, changed in one to four places.
pub(crate) fn damaged(random: &mut Random, sound: &str) -> String {
    let mut tokens = tokens(sound);
    for _ in 0..random.size(4) {
        if tokens.is_empty() {
            break;
        }
        change(random, &mut tokens);
    }
    tokens.join(" ")
}

fn change(random: &mut Random, tokens: &mut Vec<String>) {
    let place = random.below(tokens.len());
    match random.below(11) {
        0 | 1 => remove(tokens, place),
        2 => {
            let token = tokens[place].clone();
            if !is_delimiter(&token) {
                tokens.insert(place, token);
            }
        }
        3 => {
            let other = random.below(tokens.len());
            if !is_delimiter(&tokens[place]) && !is_delimiter(&tokens[other]) {
                tokens.swap(place, other);
            }
        }
        4 | 5 => {
            let token = any(random);
            if !is_delimiter(&tokens[place]) {
                tokens[place] = token;
            }
        }
        6 => tokens.insert(place, any(random)),
        // one name for another, wherever it stands
        7 | 8 => {
            let names: Vec<String> = tokens.iter().filter(|token| is_word(token)).cloned().collect();
            if names.is_empty() {
                return;
            }
            let old = random.pick(&names).clone();
            let new = match random.below(4) {
                0 => names::forbidden(random),
                1 => names::unusual(random),
                _ => random.pick(&names).clone(),
            };
            for token in tokens.iter_mut().filter(|token| **token == old) {
                token.clone_from(&new);
            }
        }
        9 => repeat_statement(random, tokens),
        _ => cut(random, tokens, place),
    }
}

fn any(random: &mut Random) -> String {
    match random.below(8) {
        0 => numbers::extreme(random),
        1 => numbers::odd(random),
        2 => names::forbidden(random),
        3 => names::unusual(random),
        _ => random.word(VOCABULARY).to_owned(),
    }
}

/// Removes a token; a delimiter with its partner.
fn remove(tokens: &mut Vec<String>, place: usize) {
    if let Some(partner) = partner(tokens, place) {
        tokens.remove(place.max(partner));
        tokens.remove(place.min(partner));
    } else {
        tokens.remove(place);
    }
}

/// Removes a stretch of tokens without delimiters.
fn cut(random: &mut Random, tokens: &mut Vec<String>, start: usize) {
    let length = random.size(8);
    let end = (start..tokens.len().min(start + length))
        .find(|&place| is_delimiter(&tokens[place]))
        .unwrap_or(tokens.len().min(start + length));
    tokens.drain(start..end);
}

/// Writes a statement once more, somewhere else.
fn repeat_statement(random: &mut Random, tokens: &mut Vec<String>) {
    let Some(body) = tokens.iter().position(|token| token == "}") else {
        return;
    };
    let mut statements: Vec<&[String]> = tokens[body + 1..].split_inclusive(|token| token == ";").collect();
    if statements.is_empty() {
        return;
    }
    let repeated = *random.pick(&statements);
    let place = random.below(statements.len() + 1);
    statements.insert(place, repeated);
    let rest: Vec<String> = statements.concat();
    tokens.truncate(body + 1);
    tokens.extend(rest);
}

fn is_word(token: &str) -> bool {
    token.starts_with(|letter: char| letter.is_alphabetic() || letter == '_')
}

fn is_delimiter(token: &str) -> bool {
    matches!(token, "(" | ")" | "[" | "]" | "{" | "}")
}

/// Where the other delimiter of a pair is.
fn partner(tokens: &[String], place: usize) -> Option<usize> {
    let opens = |token: &str| matches!(token, "(" | "[" | "{");
    let depth = |token: &str| i32::from(is_delimiter(token)) * if opens(token) { 1 } else { -1 };
    if !is_delimiter(&tokens[place]) {
        return None;
    }
    let mut open = 0;
    let mut closes = |other: usize| {
        open += depth(&tokens[other]);
        open == 0
    };
    if opens(&tokens[place]) {
        (place..tokens.len()).find(|&other| closes(other))
    } else {
        (0..=place).rev().find(|&other| closes(other))
    }
}

/// Words, numbers and signs apart from each other; comments are left out.
fn tokens(text: &str) -> Vec<String> {
    let mut tokens: Vec<String> = Vec::new();
    for line in text.lines() {
        let line = line.split("//").next().unwrap_or_default();
        let mut letters = line.chars().peekable();
        while let Some(letter) = letters.next() {
            if letter.is_whitespace() {
                continue;
            }
            let mut token = String::from(letter);
            if letter == '"' {
                // sound declarations have no quotes in their strings
                token.extend(letters.by_ref().take_while(|&letter| letter != '"'));
                token.push('"');
            } else if is_part_of_word(letter) {
                while let Some(letter) = letters.next_if(|&letter| is_part_of_word(letter)) {
                    token.push(letter);
                }
                // the point of a number, and not that of a range or a method
                let mut ahead = letters.clone();
                let is_number = token.starts_with(|first: char| first.is_ascii_digit());
                if is_number && ahead.next() == Some('.') && ahead.next().is_some_and(|next| next.is_ascii_digit()) {
                    token.extend(letters.by_ref().next());
                    while let Some(letter) = letters.next_if(|&letter| is_part_of_word(letter)) {
                        token.push(letter);
                    }
                }
            } else if matches!(letter, '=' | '.' | '<' | '>') {
                while let Some(letter) = letters.next_if(|letter| matches!(letter, '=' | '.')) {
                    token.push(letter);
                }
            }
            tokens.push(token);
        }
    }
    tokens
}

fn is_part_of_word(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_' || letter == '\u{301}'
}

#[cfg(test)]
mod tests {
    use super::{damaged, partner, tokens};
    use crate::random::Random;

    #[test]
    fn tokens_are_told_apart() {
        let text = "struct M { a: Length } // not this\nunknown u: Angle in 0.5..=2e1; a.x*cis(t) == 1.0.sin()";
        assert_eq!(
            tokens(text).join(" "),
            "struct M { a : Length } unknown u : Angle in 0.5 ..= 2e1 ; a . x * cis ( t ) == 1.0 . sin ( )"
        );
    }

    #[test]
    fn delimiters_have_partners() {
        let tokens = tokens("a(b[c]{d(e)})");
        assert_eq!(partner(&tokens, 1), Some(tokens.len() - 1));
        assert_eq!(partner(&tokens, tokens.len() - 1), Some(1));
        assert_eq!(partner(&tokens, 3), Some(5));
        assert_eq!(partner(&tokens, 0), None);
    }

    #[test]
    fn damage_is_done_and_leaves_delimiters_in_pairs() {
        let sound = "struct M { a: Length } input t: Angle; unknown u: Length; u == a * cos(t);";
        for seed in 0..500 {
            let damaged = damaged(&mut Random::new(seed), sound);
            let count = |letter| damaged.matches(letter).count();
            assert_eq!(count('('), count(')'), "{damaged}");
            assert_eq!(count('{'), count('}'), "{damaged}");
        }
    }
}
