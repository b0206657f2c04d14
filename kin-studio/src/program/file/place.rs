//! Mistakes with their places in a file.

use std::fmt::Write as _;
use std::ops::Range;

/// A mistake in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Mistake {
    /// What is wrong and what to do.
    pub(crate) message: String,
    /// The bytes of the file that are at fault.
    pub(crate) range: Range<usize>,
}

impl Mistake {
    pub(crate) fn new(message: impl Into<String>, range: Range<usize>) -> Self {
        Self {
            message: message.into(),
            range,
        }
    }

    /// The message, the place, and the line at fault with a mark below it.
    pub(crate) fn shown(&self, file: &str, text: &str) -> String {
        let start = self.range.start.min(text.len());
        let before = &text[..start];
        let line_number = before.matches('\n').count() + 1;
        let line_start = before.rfind('\n').map_or(0, |end| end + 1);
        let line = text[line_start..].lines().next().unwrap_or("");
        let column = text[line_start..start].chars().count();
        let end = self
            .range
            .end
            .clamp(start, line_start + line.len().max(start - line_start));
        let marks = text.get(start..end).map_or(1, |part| part.chars().count()).max(1);
        let margin = line_number.to_string().len();
        let mut out = format!("{}\n", self.message);
        let _ = writeln!(out, "{:margin$}--> {file}:{line_number}:{}", "", column + 1);
        let _ = writeln!(out, "{:margin$} |", "");
        let _ = writeln!(out, "{line_number} | {line}");
        let _ = write!(out, "{:margin$} | {:column$}{}", "", "", "^".repeat(marks));
        out
    }
}

/// The bytes of a place that is given by its line and its column, both from one, the column in characters.
pub(crate) fn bytes_of(text: &str, line: usize, column: usize) -> usize {
    let line_start = text
        .split_inclusive('\n')
        .take(line.saturating_sub(1))
        .map(str::len)
        .sum::<usize>();
    let own = text.get(line_start..).unwrap_or("");
    let inside: usize = own.chars().take(column.saturating_sub(1)).map(char::len_utf8).sum();
    line_start + inside
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mark_stands_below_the_fault() {
        let text = "kin 1\nθ = 30;\nend";
        let start = text.find("30").unwrap();
        let shown = Mistake::new("an angle has a unit", start..start + 2).shown("a.kin", text);
        assert_eq!(
            shown,
            "an angle has a unit\n --> a.kin:2:5\n  |\n2 | θ = 30;\n  |     ^^"
        );
        assert_eq!(bytes_of(text, 2, 5), start);
        // behind the end
        let end = Mistake::new("more", text.len()..text.len() + 9).shown("a.kin", text);
        assert!(end.ends_with("3 | end\n  |    ^"), "{end}");
    }
}
