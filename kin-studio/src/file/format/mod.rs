//! `kin fmt`: the text of a `.kin` file in one form. Only blanks and line ends change, so every comment stays.

mod atoms;
mod spaces;

use proc_macro2::TokenStream;

use atoms::{Atom, Kind, atoms};
use spaces::{Break, breaks, space};

/// The length of the longest line, unless a single word is longer.
const WIDTH: usize = 100;
const STEP: usize = 4;

/// The text in one form. The tokens are those of the text with blanks instead of its first line.
pub(crate) fn formatted(text: &str, tokens: &TokenStream) -> String {
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    let skipped = text.len() - rest.len();
    let mut page = Page {
        text: first.trim_end().to_owned(),
    };
    let atoms = atoms(text, tokens);
    page.block(&atoms, 0, Style::Statements, skipped > 0);
    page.text.push('\n');
    page.text
}

/// Whether two texts have the same tokens and comments.
pub(crate) fn is_same(one: (&str, &TokenStream), other: (&str, &TokenStream)) -> bool {
    let words = |(text, tokens)| atoms(text, tokens).into_iter().map(|atom| atom.text);
    words(one).eq(words(other))
}

/// The content of the lines of a block.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Style {
    /// Each statement on its own.
    Statements,
    /// As many elements as were typed on a line.
    Rows,
    /// As many elements as were typed on a line, with the blanks within values as typed.
    Values,
}

struct Page {
    text: String,
}

impl Page {
    fn new_line(&mut self, indent: usize) {
        self.text.push('\n');
        self.text.extend(std::iter::repeat_n(' ', indent));
    }

    fn column(&self) -> usize {
        let start = self.text.rfind('\n').map_or(0, |end| end + 1);
        self.text[start..].chars().count()
    }

    /// The lines of a block, each on a new line.
    fn block(&mut self, atoms: &[Atom<'_>], indent: usize, style: Style, may_begin_blank: bool) {
        let mut rest = atoms;
        let mut is_first = !may_begin_blank;
        while !rest.is_empty() {
            let (line, after) = rest.split_at(length_of_line(rest, style));
            if line[0].lines_before > 1 && !is_first {
                self.text.push('\n');
            }
            self.new_line(indent);
            self.line(line, indent, style);
            is_first = false;
            rest = after;
        }
    }

    /// A statement, or a row of elements, or a comment.
    fn line(&mut self, atoms: &[Atom<'_>], indent: usize, style: Style) {
        let is_value = matches!(atoms, [name, sign, ..] if name.kind == Kind::Word && (sign.is("=") || sign.is("{")));
        let as_typed = style == Style::Values || style == Style::Statements && is_value;
        let hang = if style == Style::Statements { STEP } else { 0 };
        let fits = self.column() + width(atoms, as_typed) <= WIDTH;
        let mut start = 0;
        let mut index = 0;
        while index < atoms.len() {
            let (atom, end) = (&atoms[index], index + length_of_group(&atoms[index..]));
            let is_block = atom.is("{") || atom.is("[");
            let inner = if is_block { &atoms[index + 1..end - 1] } else { &[] };
            let inner_style = match atoms[0].text {
                "for" if atom.is("{") => Style::Statements,
                "for" | "struct" | "pub" => Style::Rows,
                _ => Style::Values,
            };
            let is_divided = inner_style == Style::Statements
                || !fits
                || inner
                    .iter()
                    .chain(&atoms[end - 1..end])
                    .any(|atom| atom.lines_before > 0)
                || inner.iter().any(|atom| atom.kind == Kind::Line);
            if !is_block || !is_divided || inner.is_empty() {
                index += 1;
                continue;
            }
            self.flat(&atoms[start..=index], indent, hang, as_typed);
            self.block(inner, indent + STEP, inner_style, false);
            self.new_line(indent);
            start = end - 1;
            index = end;
        }
        self.flat(&atoms[start..], indent, hang, as_typed);
    }

    /// Atoms beside each other, on as many lines as they take.
    fn flat(&mut self, atoms: &[Atom<'_>], indent: usize, hang: usize, as_typed: bool) {
        let breaks = breaks(atoms, as_typed);
        let mut start = 0;
        while start < atoms.len() {
            let mut column = self.column();
            let mut end = start;
            while end < atoms.len() && (end == start || breaks[end] != Break::Always) {
                let before = if end > start { space(atoms, end, as_typed) } else { "" };
                column += before.len() + atoms[end].text.chars().count();
                let is_comment = atoms[end].kind == Kind::Line;
                if column > WIDTH && end > start && !is_comment {
                    break;
                }
                end += 1;
            }
            let is_full = end < atoms.len() && breaks[end] != Break::Always;
            let best = (start + 1..=end).filter_map(|index| breaks.get(index)?.level()).min();
            let end = match best {
                Some(best) if is_full => (start + 1..=end)
                    .rev()
                    .find(|&index| breaks[index].level() == Some(best)),
                None if is_full => (end..atoms.len()).find(|&index| breaks[index] != Break::Never),
                _ => Some(end),
            };
            let end = end.unwrap_or(atoms.len());
            for index in start..end {
                if index > start {
                    self.text.push_str(space(atoms, index, as_typed));
                }
                self.text.push_str(atoms[index].text);
            }
            if end < atoms.len() {
                let is_between = breaks[end] == Break::BETWEEN_ELEMENTS;
                self.new_line(indent + if is_between { hang } else { STEP });
            }
            start = end;
        }
    }
}

/// The number of atoms up to the end of the group that the first atom begins, or one.
fn length_of_group(atoms: &[Atom<'_>]) -> usize {
    let mut depth = 0_usize;
    for (index, atom) in atoms.iter().enumerate() {
        match atom.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth == 0 {
            return index + 1;
        }
    }
    atoms.len()
}

/// The number of atoms of the first statement, row or comment, with the comment behind it.
fn length_of_line(atoms: &[Atom<'_>], style: Style) -> usize {
    if atoms[0].kind == Kind::Line {
        return 1;
    }
    let mut end = 0;
    while end < atoms.len() {
        let first = &atoms[end];
        end += length_of_group(&atoms[end..]);
        let next = atoms.get(end);
        let is_end = match style {
            Style::Statements => first.is(";") || first.is("{"),
            Style::Rows | Style::Values => first.is(";") || first.is(","),
        };
        if !is_end || next.is_some_and(|next| next.is(";")) {
            continue;
        }
        let is_remark = next.is_some_and(|next| next.kind == Kind::Line && next.lines_before == 0);
        if is_remark && !next.is_some_and(is_documentation) {
            return end + 1;
        }
        if style == Style::Statements || next.is_some_and(|next| next.lines_before > 0 || is_documentation(next)) {
            return end;
        }
    }
    end
}

fn is_documentation(atom: &Atom<'_>) -> bool {
    atom.kind == Kind::Line && (atom.text.starts_with("///") || atom.text.starts_with("//!"))
}

/// The width of atoms beside each other, without a comment behind them.
fn width(atoms: &[Atom<'_>], as_typed: bool) -> usize {
    let atoms = match atoms {
        [before @ .., comment] if comment.kind == Kind::Line => before,
        _ => atoms,
    };
    let widths = (0..atoms.len()).map(|index| space(atoms, index, as_typed).len() + atoms[index].text.chars().count());
    widths.sum()
}

#[cfg(test)]
mod tests;
