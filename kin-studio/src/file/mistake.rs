//! Mistakes with their positions in a file.

use std::fmt::Write as _;
use std::ops::Range;

/// A mistake in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Mistake {
    /// The message, with advice.
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

    /// The message, the line number and the column, and the line at fault with a mark below it.
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
        let (excerpt, before) = excerpt(line, column);
        let marks = marks.min(excerpt.chars().count().saturating_sub(before)).max(1);
        let mut out = format!("{}\n", self.message);
        let _ = writeln!(out, "{:margin$}--> {file}:{line_number}:{}", "", column + 1);
        let _ = writeln!(out, "{:margin$} |", "");
        let _ = writeln!(out, "{line_number} | {excerpt}");
        let _ = write!(out, "{:margin$} | {}{}", "", " ".repeat(before), "^".repeat(marks));
        out
    }
}

/// The longest line that is shown whole, in characters.
const LONGEST: usize = 200;

/// A line, or the part of a long line around a column, with the position of the column in the part.
fn excerpt(line: &str, column: usize) -> (String, usize) {
    let count = line.chars().count();
    if count <= LONGEST {
        return (line.to_owned(), column);
    }
    let from = column.saturating_sub(LONGEST / 2).min(count - LONGEST);
    let part: String = line.chars().skip(from).take(LONGEST).collect();
    let [before, behind] = [from > 0, from + LONGEST < count].map(|is_cut| if is_cut { "…" } else { "" });
    (
        format!("{before}{part}{behind}"),
        column - from + before.chars().count(),
    )
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
        // behind the end
        let end = Mistake::new("more", text.len()..text.len() + 9).shown("a.kin", text);
        assert!(end.ends_with("3 | end\n  |    ^"), "{end}");
    }

    #[test]
    fn long_lines_are_cut_around_the_fault() {
        for (before, behind) in [(0, 100_000), (70_000, 0), (70_000, 70_000), (150, 150)] {
            let text = format!("kin 1\n{}FAULT{}\nend", "ä".repeat(before), "ö".repeat(behind));
            let start = text.find("FAULT").unwrap();
            let shown = Mistake::new("this", start..start + 5).shown("a.kin", &text);
            let lines: Vec<&str> = shown.lines().collect();
            let [.., line, marks] = lines.as_slice() else {
                panic!("{shown}")
            };
            assert!(line.chars().count() < 220, "{line}");
            let position = marks.find('^').unwrap();
            let marked: String = line.chars().skip(position).take(5).collect();
            assert_eq!((marked.as_str(), marks.matches('^').count()), ("FAULT", 5), "{shown}");
            assert!(shown.contains(&format!("a.kin:2:{}", before + 1)), "{shown}");
        }
    }
}
