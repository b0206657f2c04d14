//! The declaration of a file.

use kin_live::{DeclareError, Mechanism};
use proc_macro2::{TokenStream, TokenTree};

use super::mistake::Mistake;
use super::sections::{Sections, blank};

/// The first line of every file.
const FIRST_LINE: &str = "kin 1";

/// The declaration of a file, and what stands beside it.
#[derive(Debug)]
pub(crate) struct KinDeclaration {
    /// The mechanism.
    pub(crate) mechanism: Mechanism,
    /// The declaration as it was typed.
    pub(crate) text: String,
    /// The sections, whose numbers are not read yet.
    pub(crate) sections: Sections,
}

impl KinDeclaration {
    /// Divides the text of a file, and compiles the declaration. The mistakes in the form of sections stand beside
    /// them.
    pub(crate) fn read(text: &str) -> Result<Self, Vec<Mistake>> {
        let (blanked, stream) = lexed(text)?;
        let tokens: Vec<TokenTree> = stream.into_iter().collect();
        let mut sections = Sections::read(text, &tokens).map_err(|mistake| vec![mistake])?;
        // with blanks in the place of all else, so that every token keeps its own
        let declaration = blank(&blanked, sections.places.iter().map(|section| &section.whole));
        match Mechanism::declare(&declaration) {
            Ok(mechanism) => {
                let lines: Vec<&str> = declaration.lines().map(str::trim_end).collect();
                Ok(Self {
                    mechanism,
                    text: lines.join("\n").trim().to_owned(),
                    sections,
                })
            }
            Err(DeclareError::Mistakes(found)) => {
                let found = found.into_iter().map(|one| Mistake::new(one.message, one.bytes));
                sections.mistakes.extend(found);
                Err(sections.mistakes)
            }
            Err(error) => Err(vec![Mistake::new(error.to_string(), 0..0)]),
        }
    }
}

/// The tokens of a file whose statements can be told apart, whatever they say. Each token is where it was typed.
pub(crate) fn tokens(text: &str) -> Result<TokenStream, Vec<Mistake>> {
    let (_, stream) = lexed(text)?;
    let tokens: Vec<TokenTree> = stream.clone().into_iter().collect();
    let sections = Sections::read(text, &tokens);
    sections.map(|_| stream).map_err(|mistake| vec![mistake])
}

/// The text with blanks in the place of its first line, and its tokens.
fn lexed(text: &str) -> Result<(String, TokenStream), Vec<Mistake>> {
    let first = text.lines().next().unwrap_or("");
    if first.trim_end() != FIRST_LINE {
        return Err(vec![wrong_first_line(first)]);
    }
    let blanked = format!("{}{}", " ".repeat(first.len()), &text[first.len()..]);
    let stream: TokenStream = blanked.parse().map_err(|error: proc_macro2::LexError| {
        let range = error.span().byte_range();
        vec![Mistake::new(
            "this cannot be read: a bracket or a quotation mark has no partner, or a sign is none of the language",
            range,
        )]
    })?;
    Ok((blanked, stream))
}

/// Mistakes of a text in the order of their places, or else its comment as other languages have them: the sign that
/// begins it may be taken for many things.
pub(crate) fn in_order(mut mistakes: Vec<Mistake>, text: &str) -> Vec<Mistake> {
    mistakes.sort_by_key(|mistake| mistake.range.start);
    other_comment(text).map_or(mistakes, |comment| vec![comment])
}

/// A comment as other languages have them.
fn other_comment(text: &str) -> Option<Mistake> {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let code = line.split("//").next().unwrap_or(line);
        let mut signs = code.match_indices('#');
        let is_attribute = |place: usize| code[place + 1..].starts_with(['[', '!']);
        if let Some((place, _)) = signs.find(|(place, _)| !is_attribute(*place)) {
            let place = start + place;
            return Some(Mistake::new("a comment begins with `//`", place..place + 1));
        }
        start += line.len();
    }
    None
}

fn wrong_first_line(first: &str) -> Mistake {
    let message = match first.trim().strip_prefix("kin ") {
        Some(version) if version.trim().parse::<u32>().is_ok() => format!(
            "the file has the format {}, and this version of kin reads the format 1: use a later version",
            version.trim()
        ),
        _ => format!("the first line of a .kin file is `{FIRST_LINE}`"),
    };
    Mistake::new(message, 0..first.len().max(1))
}
