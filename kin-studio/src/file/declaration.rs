//! The declaration of a file.

use kin_live::{DeclareError, Mechanism};
use proc_macro2::{TokenStream, TokenTree};

use super::mistake::Mistake;
use super::sections::{Sections, blank};

/// The first line of every file.
const FIRST_LINE: &str = "kin 1";

/// The declaration of a file, and the sections beside it.
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
        // blanks replace everything else, so that every token keeps its position
        let besides = sections
            .spans
            .iter()
            .map(|section| &section.whole)
            .chain(&sections.strays);
        let declaration = blank(&blanked, besides);
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

/// The tokens of a file whose statements can be separated, with or without other mistakes. Each token has the position
/// at which it was typed.
pub(crate) fn tokens(text: &str) -> Result<TokenStream, Vec<Mistake>> {
    let (_, stream) = lexed(text)?;
    let tokens: Vec<TokenTree> = stream.clone().into_iter().collect();
    let sections = Sections::read(text, &tokens);
    sections.map(|_| stream).map_err(|mistake| vec![mistake])
}

/// The text with blanks instead of its first line, and its tokens.
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

/// Mistakes of a text in the order of their positions. A comment in the form of another language is reported alone,
/// since the sign with which it begins causes many other mistakes.
pub(crate) fn in_order(mut mistakes: Vec<Mistake>, text: &str) -> Vec<Mistake> {
    mistakes.sort_by_key(|mistake| mistake.range.start);
    other_comment(text).map_or(mistakes, |comment| vec![comment])
}

/// The mistake of a comment in the form of another language.
fn other_comment(text: &str) -> Option<Mistake> {
    let mut start = 0;
    for line in text.split_inclusive('\n') {
        let code = line.split("//").next().unwrap_or(line);
        let mut signs = code.match_indices('#');
        let is_attribute = |index: usize| code[index + 1..].starts_with(['[', '!']);
        if let Some((index, _)) = signs.find(|(index, _)| !is_attribute(*index)) {
            let index = start + index;
            return Some(Mistake::new("a comment begins with `//`", index..index + 1));
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
