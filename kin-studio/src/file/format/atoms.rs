//! The tokens of a file and the comments between them, in one row.

use proc_macro2::{TokenStream, TokenTree};

/// A token or a comment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Atom<'t> {
    pub(super) text: &'t str,
    pub(super) kind: Kind,
    /// The number of line ends before it.
    pub(super) lines_before: usize,
    /// Whether a blank stands before it.
    pub(super) is_apart: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Word,
    Sign,
    Open,
    Close,
    /// A comment that the rest of its line belongs to.
    Line,
    /// A comment with two ends.
    Comment,
}

impl Atom<'_> {
    pub(super) fn is(&self, text: &str) -> bool {
        self.text == text && self.kind != Kind::Line
    }
}

/// Signs of several characters.
pub(super) const LONG_SIGNS: [&str; 6] = ["==", "..=", "..", "<=", ">=", "::"];

/// The atoms of a text.
pub(super) fn atoms<'t>(text: &'t str, tokens: &TokenStream) -> Vec<Atom<'t>> {
    let mut row = Row {
        text,
        end: 0,
        atoms: Vec::new(),
    };
    row.tokens(tokens);
    row.gap(text.len());
    row.atoms
}

struct Row<'t> {
    text: &'t str,
    /// The byte behind the last atom.
    end: usize,
    atoms: Vec<Atom<'t>>,
}

impl Row<'_> {
    fn tokens(&mut self, tokens: &TokenStream) {
        for token in tokens.clone() {
            let range = token.span().byte_range();
            // a doc comment is a row of tokens, each of which has the range of the whole comment
            if range.start < self.end {
                continue;
            }
            match token {
                TokenTree::Group(group) => {
                    let [open, close] = [group.span_open(), group.span_close()].map(|span| span.byte_range());
                    self.atom(open.start, open.end, Kind::Open);
                    self.tokens(&group.stream());
                    self.atom(close.start, close.end, Kind::Close);
                }
                TokenTree::Punct(sign) => {
                    let rest = &self.text[range.start..];
                    let long = LONG_SIGNS.iter().find(|long| rest.starts_with(**long));
                    let is_comment = sign.as_char() != rest.chars().next().unwrap_or(' ');
                    if is_comment {
                        self.gap(range.end);
                    } else {
                        self.atom(range.start, range.start + long.map_or(1, |long| long.len()), Kind::Sign);
                    }
                }
                TokenTree::Ident(_) | TokenTree::Literal(_) => self.atom(range.start, range.end, Kind::Word),
            }
        }
    }

    fn atom(&mut self, start: usize, end: usize, kind: Kind) {
        self.gap(start);
        self.push(start, end, kind);
    }

    fn push(&mut self, start: usize, end: usize, kind: Kind) {
        let blank = &self.text[self.end..start];
        self.atoms.push(Atom {
            text: self.text[start..end].trim_end(),
            kind,
            lines_before: blank.matches('\n').count(),
            is_apart: !blank.is_empty(),
        });
        self.end = end;
    }

    /// The comments up to a byte.
    fn gap(&mut self, end: usize) {
        while let Some(start) = self.text[self.end..end].find('/').map(|offset| self.end + offset) {
            let rest = &self.text[start..end];
            if rest.starts_with("//") {
                let length = rest.find('\n').unwrap_or(rest.len());
                self.push(start, start + length, Kind::Line);
            } else {
                self.push(start, start + length_of_comment(rest), Kind::Comment);
            }
        }
    }
}

/// The length of a comment with two ends, which may hold others.
fn length_of_comment(text: &str) -> usize {
    let (mut depth, mut end) = (0_usize, 0);
    while end < text.len() {
        let rest = &text.as_bytes()[end..];
        let is_mark = rest.starts_with(b"/*") || rest.starts_with(b"*/");
        if is_mark && rest[0] == b'/' {
            depth += 1;
        } else if is_mark {
            depth -= 1;
        }
        end += if is_mark { 2 } else { 1 };
        if depth == 0 {
            break;
        }
    }
    end
}
