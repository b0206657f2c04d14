//! A `.kin` file, taken apart.

use std::ops::Range;

use kin_live::{DeclareError, Mechanism};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use super::mistake::Mistake;

/// The first line of every file.
const FIRST_LINE: &str = "kin 1";

/// The declaration of a file, and what stands beside it.
#[cfg_attr(not(feature = "program"), expect(dead_code, reason = "the program reads them"))]
#[derive(Debug)]
pub(crate) struct KinDeclaration {
    /// The mechanism.
    pub(crate) mechanism: Mechanism,
    /// The declaration as it was typed.
    pub(crate) text: String,
    /// The sections, which are not read yet.
    pub(crate) sections: Sections,
}

/// The sections of a file, apart from each other.
#[cfg_attr(not(feature = "program"), expect(dead_code, reason = "the program reads them"))]
#[derive(Debug)]
pub(crate) struct Sections {
    /// The dimensions, and the place of the word before them.
    pub(crate) dimensions: (Vec<Entry>, Range<usize>),
    /// The motions of inputs.
    pub(crate) motion: Vec<Entry>,
    /// The assembly.
    pub(crate) assembly: Option<String>,
    /// What is not the declaration.
    blanks: Vec<Range<usize>>,
}

/// A name with what stands behind its `=`, each with its place.
#[cfg_attr(not(feature = "program"), expect(dead_code, reason = "the program reads them"))]
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) name: String,
    pub(crate) name_range: Range<usize>,
    pub(crate) value: String,
    pub(crate) value_range: Range<usize>,
}

impl KinDeclaration {
    /// Divides the text of a file, and compiles the declaration.
    pub(crate) fn read(text: &str) -> Result<Self, Vec<Mistake>> {
        Self::read_tokens(text).map_err(|mistakes| or_comment(mistakes, text))
    }

    fn read_tokens(text: &str) -> Result<Self, Vec<Mistake>> {
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
        let tokens: Vec<TokenTree> = stream.into_iter().collect();
        Reader { text, tokens: &tokens }.read(&blanked)
    }
}

/// Mistakes of a text, or else its comment as other languages have them: the sign that begins it may be taken for many
/// things.
pub(crate) fn or_comment(mistakes: Vec<Mistake>, text: &str) -> Vec<Mistake> {
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

struct Reader<'t> {
    text: &'t str,
    tokens: &'t [TokenTree],
}

fn range_of(token: &TokenTree) -> Range<usize> {
    token.span().byte_range()
}

fn is_ident(token: Option<&TokenTree>, name: &str) -> bool {
    matches!(token, Some(TokenTree::Ident(ident)) if ident == name)
}

fn is_punct(token: Option<&TokenTree>, letter: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == letter)
}

fn braces(token: Option<&TokenTree>) -> Option<&Group> {
    match token {
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => Some(group),
        _ => None,
    }
}

impl Reader<'_> {
    fn read(&self, blanked: &str) -> Result<KinDeclaration, Vec<Mistake>> {
        let sections = self.sections().map_err(|mistake| vec![mistake])?;
        // with blanks in the place of all else, so that every token keeps its own
        let declaration = blank(blanked, &sections.blanks);
        let mechanism = Mechanism::declare(&declaration).map_err(|error| match error {
            DeclareError::Mistakes(mistakes) => {
                let mistakes = mistakes.into_iter();
                mistakes
                    .map(|mistake| Mistake::new(mistake.message, mistake.bytes))
                    .collect::<Vec<_>>()
            }
            error => vec![Mistake::new(error.to_string(), 0..0)],
        })?;
        let declaration = declaration.lines().map(str::trim_end).collect::<Vec<_>>().join("\n");
        Ok(KinDeclaration {
            mechanism,
            text: declaration.trim().to_owned(),
            sections,
        })
    }

    /// Divides the file into its sections.
    fn sections(&self) -> Result<Sections, Mistake> {
        let (mut dimensions, mut motion, mut assembly) = (None, None, None);
        let mut declared: Vec<TokenTree> = Vec::new();
        let mut blanks: Vec<Range<usize>> = Vec::new();
        let mut place = 0;
        while let Some(token) = self.tokens.get(place) {
            let next = self.tokens.get(place + 1);
            let section = [("dimensions", &mut dimensions), ("motion", &mut motion)]
                .into_iter()
                .find(|(name, _)| is_ident(Some(token), name));
            check_end(&declared, token)?;
            if let (Some((name, slot)), Some(group)) = (section, braces(next)) {
                let whole = range_of(token).start..group.span().byte_range().end;
                if slot.is_some() {
                    return Err(Mistake::new(
                        format!("there are two sections `{name}`"),
                        range_of(token),
                    ));
                }
                *slot = Some((self.entries(group)?, range_of(token)));
                blanks.push(whole);
                place += 2;
                continue;
            }
            let is_assembly =
                is_ident(Some(token), "assembly") && is_punct(next, '=') && !is_punct(self.tokens.get(place + 2), '=');
            if is_assembly {
                let end = (place..self.tokens.len()).find(|index| is_punct(self.tokens.get(*index), ';'));
                let Some(end) = end else {
                    return Err(Mistake::new(
                        "the assembly ends with `;`, as in `assembly = open;`",
                        range_of(token),
                    ));
                };
                let (from, to) = (range_of(&self.tokens[place + 1]).end, range_of(&self.tokens[end]).start);
                assembly = Some((self.text[from..to].trim().to_owned(), from..to));
                blanks.push(range_of(token).start..range_of(&self.tokens[end]).end);
                place = end + 1;
                continue;
            }
            declared.push(token.clone());
            place += 1;
        }
        check_form(&declared, true)?;
        Ok(Sections {
            dimensions: dimensions.unwrap_or_default(),
            motion: motion.unwrap_or_default().0,
            assembly: assembly.map(|(text, _)| text),
            blanks,
        })
    }

    /// The entries of a section: `name = value;`.
    fn entries(&self, group: &Group) -> Result<Vec<Entry>, Mistake> {
        let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
        let mut entries = Vec::new();
        for part in tokens.split(|token| is_punct(Some(token), ';')) {
            let (Some(first), Some(last)) = (part.first(), part.last()) else {
                continue;
            };
            let whole = range_of(first).start..range_of(last).end;
            let Some(equals) = part.iter().position(|token| is_punct(Some(token), '=')) else {
                return Err(Mistake::new("a name and a value are written as `r1 = 90;`", whole));
            };
            if part[equals + 1..].iter().any(|token| is_punct(Some(token), '='))
                && !self.text[whole.clone()].contains("..=")
            {
                return Err(Mistake::new("two values without a `;` between them", whole));
            }
            let name_range = whole.start..range_of(&part[equals]).start;
            let value_range = range_of(&part[equals]).end..whole.end;
            let (name, value) = (&self.text[name_range.clone()], &self.text[value_range.clone()]);
            if value.trim().is_empty() {
                return Err(Mistake::new(format!("`{}` has no value", name.trim()), whole));
            }
            let value_start = value_range.start + (value.len() - value.trim_start().len());
            entries.push(Entry {
                name: name.trim().replace(' ', ""),
                name_range: name_range.start..name_range.start + name.trim_end().len(),
                value: value.trim().to_owned(),
                value_range: value_start..value_range.end,
            });
        }
        Ok(entries)
    }
}

/// A text with blanks in some ranges, so that every token keeps its place.
fn blank(text: &str, ranges: &[Range<usize>]) -> String {
    let mut blanked = text.to_owned();
    for range in ranges {
        let letters = text[range.clone()].chars();
        let blanks: String = letters
            .map(|letter| match letter {
                '\n' => "\n".to_owned(),
                _ => " ".repeat(letter.len_utf8()),
            })
            .collect();
        blanked.replace_range(range.clone(), &blanks);
    }
    blanked
}

/// Refuses attributes, which a file does not have, and sections of other names. All else is left to the compiler.
fn check_form(tokens: &[TokenTree], is_outside: bool) -> Result<(), Mistake> {
    let mut braces_seen = 0;
    for (place, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Punct(punct) if punct.as_char() == '#' => {
                let is_inner = is_punct(tokens.get(place + 1), '!');
                let attribute = tokens.get(place + 1 + usize::from(is_inner));
                if !is_documentation(attribute) {
                    let range = range_of(token);
                    let end = attribute.map_or(range.end, |attribute| range_of(attribute).end);
                    return Err(Mistake::new(
                        "of attributes only doc comments are allowed in a .kin file: write `/// text`",
                        range.start..end,
                    ));
                }
            }
            TokenTree::Group(group) => {
                if group.delimiter() == Delimiter::Brace {
                    braces_seen += 1;
                    if !is_outside || braces_seen > 1 {
                        return Err(Mistake::new(
                            "these braces have no place here: a file has one structure, `dimensions { .. }` and \
                             `motion { .. }`",
                            group.span_open().byte_range(),
                        ));
                    }
                }
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                check_form(&inner, false)?;
            }
            _ => {}
        }
    }
    Ok(())
}

/// Whether it is what a doc comment becomes: `[doc = "text"]`.
fn is_documentation(attribute: Option<&TokenTree>) -> bool {
    let Some(TokenTree::Group(group)) = attribute else {
        return false;
    };
    let inner: Vec<TokenTree> = group.stream().into_iter().collect();
    let [doc, equals, TokenTree::Literal(text)] = inner.as_slice() else {
        return false;
    };
    is_ident(Some(doc), "doc") && is_punct(Some(equals), '=') && text.to_string().starts_with(['"', 'r'])
}

/// The words behind which a statement goes on, and those with which a line may go on.
const HEADS: [&str; 11] = [
    "struct", "pub", "input", "unknown", "output", "let", "ground", "body", "slide", "on", "with",
];
const INFIXES: [&str; 3] = ["in", "where", "on"];

/// Refuses a line that begins a statement while the one before has no end.
fn check_end(before: &[TokenTree], token: &TokenTree) -> Result<(), Mistake> {
    let Some(last) = before.last() else { return Ok(()) };
    let is_operand = match last {
        TokenTree::Ident(word) => !HEADS.iter().any(|head| word == head),
        TokenTree::Literal(_) => true,
        TokenTree::Group(group) => group.delimiter() == Delimiter::Parenthesis,
        TokenTree::Punct(_) => false,
    };
    let begins = match token {
        TokenTree::Ident(word) => !INFIXES.iter().any(|infix| word == infix),
        TokenTree::Literal(_) => true,
        TokenTree::Group(_) | TokenTree::Punct(_) => false,
    };
    let is_next_line = last.span().end().line < token.span().start().line;
    if is_operand && begins && is_next_line {
        return Err(Mistake::new("a statement ends with `;`", range_of(last)));
    }
    Ok(())
}
