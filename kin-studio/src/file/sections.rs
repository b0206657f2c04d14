//! The sections of a file: the statements beside the declaration.

use std::ops::Range;

use proc_macro2::{Delimiter, Group, TokenTree};

use super::mistake::Mistake;

/// The sections of a file, apart from each other.
#[derive(Debug, Default)]
pub(crate) struct Sections {
    pub(crate) dimensions: Vec<Entry>,
    pub(crate) motion: Vec<Entry>,
    pub(crate) loads: Vec<Entry>,
    pub(crate) assembly: Option<Part>,
    pub(crate) columns: Vec<Part>,
    /// The ranges of all sections in the text.
    pub(crate) spans: Vec<Section>,
    /// The ranges of values that stand in no section, which the compiler does not see.
    pub(crate) strays: Vec<Range<usize>>,
    /// The mistakes in the sections.
    pub(crate) mistakes: Vec<Mistake>,
}

/// A section, which is no part of the declaration.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Section {
    /// Its first word.
    pub(crate) name: &'static str,
    /// The bytes of this word.
    pub(crate) word: Range<usize>,
    /// All its bytes.
    pub(crate) whole: Range<usize>,
}

/// A part of the text of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Part {
    pub(crate) text: String,
    pub(crate) range: Range<usize>,
}

/// The text before an `=`, and the text behind it.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    pub(crate) head: Part,
    /// The tokens of the head. They are text, as the positions of tokens end where a declaration is compiled without a
    /// thread of its own.
    pub(crate) words: Vec<Part>,
    pub(crate) value: Part,
}

impl Entry {
    /// Whether its first word is this.
    pub(crate) fn begins_with(&self, word: &str) -> bool {
        self.words.first().is_some_and(|first| first.text == word)
    }
}

impl Part {
    /// A part without the blanks around it.
    pub(crate) fn new(text: &str, range: Range<usize>) -> Self {
        let part = &text[range.clone()];
        let start = range.start + (part.len() - part.trim_start().len());
        Self {
            text: part.trim().to_owned(),
            range: start..start + part.trim().len(),
        }
    }

    /// The parts between commas.
    pub(crate) fn parts(&self) -> Vec<Self> {
        let part = |range: Range<usize>| Self {
            text: self.text[range.clone()].to_owned(),
            range: self.range.start + range.start..self.range.start + range.end,
        };
        parts(&self.text).into_iter().map(part).collect()
    }

    /// The text behind a word at the beginning.
    pub(crate) fn behind(&self, word: &str) -> Option<Self> {
        let text = self.text.strip_prefix(word)?;
        let range = self.range.end - text.len()..self.range.end;
        let text = text.to_owned();
        Some(Self { text, range })
    }

    /// The text before a word, and the text behind it.
    pub(crate) fn around(&self, word: &str) -> Option<(Self, Self)> {
        let index = self.text.find(word)?;
        let part = |range: Range<usize>| {
            let Self { text, range } = Self::new(&self.text, range);
            let range = self.range.start + range.start..self.range.start + range.end;
            Self { text, range }
        };
        Some((part(0..index), part(index + word.len()..self.text.len())))
    }

    /// The parts of `(x, y)`.
    pub(crate) fn coordinates(&self) -> Option<Vec<Self>> {
        let inner = self.text.strip_prefix('(')?.strip_suffix(')')?;
        let start = self.range.start + 1;
        let inner = Self {
            text: inner.to_owned(),
            range: start..start + inner.len(),
        };
        Some(inner.parts())
    }

    /// Whether it may be a name.
    pub(crate) fn is_word(&self) -> bool {
        self.text
            .starts_with(|letter: char| letter.is_alphabetic() || letter == '_')
    }

    pub(crate) fn mistake(&self, message: impl Into<String>) -> Mistake {
        Mistake::new(message, self.range.clone())
    }
}

/// The parts of a text between commas that stand in no parentheses, without the blanks around them.
pub(crate) fn parts(text: &str) -> Vec<Range<usize>> {
    let (mut found, mut start, mut depth) = (Vec::new(), 0, 0_usize);
    for (index, letter) in text.char_indices().chain([(text.len(), ',')]) {
        match letter {
            '(' => depth += 1,
            ')' => depth = depth.saturating_sub(1),
            ',' if depth == 0 || index == text.len() => {
                let part = &text[start..index];
                let from = start + (part.len() - part.trim_start().len());
                found.push(from..from + part.trim().len());
                start = index + 1;
            }
            _ => {}
        }
    }
    found
}

pub(crate) fn range_of(token: &TokenTree) -> Range<usize> {
    token.span().byte_range()
}

pub(crate) fn is_ident(token: Option<&TokenTree>, name: &str) -> bool {
    matches!(token, Some(TokenTree::Ident(ident)) if ident == name)
}

pub(crate) fn is_punct(token: Option<&TokenTree>, letter: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == letter)
}

fn braces(token: Option<&TokenTree>) -> Option<&Group> {
    match token {
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => Some(group),
        _ => None,
    }
}

impl Sections {
    /// Divides the file into its sections.
    pub(crate) fn read(text: &str, tokens: &[TokenTree]) -> Result<Self, Mistake> {
        let mut sections = Self::default();
        let mut declared: Vec<TokenTree> = Vec::new();
        let mut position = 0;
        while let Some(token) = tokens.get(position) {
            check_end(&declared, token)?;
            if let Some(length) = stray_value(&declared, &tokens[position..]) {
                let end = position + length;
                let whole = range_of(token).start..range_of(&tokens[end]).end;
                let message = format!(
                    "the value of a dimension stands in a section: `dimensions {{ {} }}`; that of an input in \
                     `motion {{ .. }}`",
                    &text[whole.clone()]
                );
                sections.mistakes.push(Mistake::new(message, range_of(token)));
                sections.strays.push(whole);
                position = end + 1;
                continue;
            }
            let Some(name) = section_at(&declared, &tokens[position..]) else {
                declared.push(token.clone());
                position += 1;
                continue;
            };
            if sections.spans.iter().any(|section| section.name == name) {
                let message = format!("there are two sections `{name}`");
                sections.mistakes.push(Mistake::new(message, range_of(token)));
            }
            let end = if let Some(group) = braces(tokens.get(position + 1)) {
                sections.entries_of(name, group, text);
                position + 1
            } else {
                sections.statement(name, position, tokens, text)?
            };
            sections.spans.push(Section {
                name,
                word: range_of(token),
                whole: range_of(token).start..range_of(&tokens[end]).end,
            });
            position = end + 1;
        }
        check_form(&declared, true)?;
        Ok(sections)
    }

    /// The bytes of the first word of a section, if the file has the section.
    pub(crate) fn word_of(&self, name: &str) -> Option<Range<usize>> {
        self.section(name).map(|section| section.word.clone())
    }

    fn section(&self, name: &str) -> Option<&Section> {
        self.spans.iter().find(|section| section.name == name)
    }

    /// The entries of a section.
    fn entries(&self, name: &str) -> &[Entry] {
        match name {
            "dimensions" => &self.dimensions,
            "motion" => &self.motion,
            "loads" => &self.loads,
            _ => &[],
        }
    }

    /// The bytes of a name to which a section gives a value, or else those of the section, or none.
    pub(crate) fn named(&self, section: &str, name: &str) -> Range<usize> {
        let names = self.entries(section).iter().filter_map(|entry| entry.words.last());
        let named = names.filter(|word| word.text == name).map(|word| &word.range).next();
        let whole = || self.section(section).map(|section| &section.whole);
        named.or_else(whole).cloned().unwrap_or_default()
    }

    /// Reads a section of one statement, and returns the index of its `;`.
    fn statement(
        &mut self,
        name: &'static str,
        position: usize,
        tokens: &[TokenTree],
        text: &str,
    ) -> Result<usize, Mistake> {
        let end = (position..tokens.len()).find(|index| is_punct(tokens.get(*index), ';'));
        let Some(end) = end else {
            let message = match name {
                "columns" => "the columns end with `;`, as in `columns psi, psi_velocity;`",
                _ => "the assembly ends with `;`, as in `assembly = open;`",
            };
            return Err(Mistake::new(message, range_of(&tokens[position])));
        };
        let begin = if name == "columns" { position } else { position + 1 };
        let whole = Part::new(text, range_of(&tokens[begin]).end..range_of(&tokens[end]).start);
        if name == "columns" {
            let is_empty = |part: &Part| part.text.is_empty();
            let (empty, columns) = whole.parts().into_iter().partition(is_empty);
            self.columns = columns;
            let empty: Vec<Part> = empty;
            self.mistakes
                .extend(empty.iter().map(|_| whole.mistake("a name is missing beside a comma")));
        } else {
            self.assembly = Some(whole);
        }
        Ok(end)
    }

    /// The entries of a section in braces: `name = value;`.
    fn entries_of(&mut self, name: &str, group: &Group, text: &str) {
        let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
        for part in tokens.split(|token| is_punct(Some(token), ';')) {
            let (Some(first), Some(last)) = (part.first(), part.last()) else {
                continue;
            };
            match entry(name, part, range_of(first).start..range_of(last).end, text) {
                Ok(entry) => match name {
                    "dimensions" => self.dimensions.push(entry),
                    "motion" => self.motion.push(entry),
                    _ => self.loads.push(entry),
                },
                Err(mistake) => self.mistakes.push(mistake),
            }
        }
    }
}

/// The section that begins with these tokens, if one does. The tokens of the declaration before them decide.
fn section_at(declared: &[TokenTree], tokens: &[TokenTree]) -> Option<&'static str> {
    let (first, next) = (tokens.first(), tokens.get(1));
    let in_braces = ["dimensions", "motion", "loads"];
    if let Some(name) = in_braces.into_iter().find(|name| is_ident(first, name)) {
        return braces(next).map(|_| name);
    }
    if is_ident(first, "assembly") {
        return (is_punct(next, '=') && !is_punct(tokens.get(2), '=')).then_some("assembly");
    }
    (begins_statement(declared) && is_ident(first, "columns") && matches!(next, Some(TokenTree::Ident(_))))
        .then_some("columns")
}

/// Whether a statement begins behind these tokens of the declaration.
fn begins_statement(declared: &[TokenTree]) -> bool {
    declared
        .last()
        .is_none_or(|last| is_punct(Some(last), ';') || braces(Some(last)).is_some())
}

/// The index of the `;` behind `r1 = 90mm`, which stands in no section, if these tokens begin so.
fn stray_value(declared: &[TokenTree], tokens: &[TokenTree]) -> Option<usize> {
    let [TokenTree::Ident(name), equals, value, ..] = tokens else {
        return None;
    };
    let is_value = is_punct(Some(equals), '=') && !is_punct(Some(value), '=');
    let is_stray = begins_statement(declared) && name != "assembly" && is_value;
    is_stray.then(|| tokens.iter().position(|token| is_punct(Some(token), ';')))?
}

fn entry(section: &str, part: &[TokenTree], whole: Range<usize>, text: &str) -> Result<Entry, Mistake> {
    let Some(equals) = part.iter().position(|token| is_punct(Some(token), '=')) else {
        let message = match section {
            "loads" => "a load and its value are written as `mass tip = 2kg;`",
            _ => "a name and a value are written as `r1 = 90;`",
        };
        return Err(Mistake::new(message, whole));
    };
    if part[equals + 1..].iter().any(|token| is_punct(Some(token), '=')) && !text[whole.clone()].contains("..=") {
        return Err(Mistake::new("two values without a `;` between them", whole));
    }
    let head = Part::new(text, whole.start..range_of(&part[equals]).start);
    let value = Part::new(text, range_of(&part[equals]).end..whole.end);
    if value.text.is_empty() {
        return Err(Mistake::new(format!("`{}` has no value", head.text), whole));
    }
    let words = part[..equals]
        .iter()
        .map(|token| Part::new(text, range_of(token)))
        .collect();
    Ok(Entry { head, words, value })
}

/// A text with blanks in some ranges, so that every token keeps its position.
pub(crate) fn blank<'r>(text: &str, ranges: impl Iterator<Item = &'r Range<usize>>) -> String {
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

/// Refuses attributes, which a file does not have, and sections of unknown names. The compiler finds all other
/// mistakes.
fn check_form(tokens: &[TokenTree], is_outside: bool) -> Result<(), Mistake> {
    let mut braces_seen = 0;
    for (index, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Punct(punct) if punct.as_char() == '#' => {
                let is_inner = is_punct(tokens.get(index + 1), '!');
                let attribute = tokens.get(index + 1 + usize::from(is_inner));
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
                let repeats = is_outside && is_repetition(&tokens[..index]);
                if group.delimiter() == Delimiter::Brace && !repeats {
                    braces_seen += 1;
                    if !is_outside || braces_seen > 1 {
                        return Err(Mistake::new(
                            "these braces have no place here: a file has one structure, `for … in […] { .. }`, \
                             `dimensions { .. }`, `motion { .. }` and `loads { .. }`",
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

/// Whether the statement at the end of some tokens is a `for`.
fn is_repetition(tokens: &[TokenTree]) -> bool {
    let is_end = |token: &TokenTree| is_punct(Some(token), ';') || braces(Some(token)).is_some();
    let statement = tokens.rsplit(is_end).next();
    is_ident(statement.and_then(<[TokenTree]>::first), "for")
}

/// Whether an attribute is a doc comment: `[doc = "text"]`.
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

/// The words behind which a statement goes on, and the words with which a line may go on.
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
