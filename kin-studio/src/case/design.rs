//! Designs of the library as `.kin` files.

use std::fmt::Write as _;

use kin_core::Dimension;
use kin_core::any::{Described as _, Quantity};

use super::file;
use crate::library::{Design, DesignAssembly};

impl Design {
    /// The design as a `.kin` file: the declaration, its dimensions, the motion of its first input, and its assembly.
    ///
    /// ```
    /// use kin_studio::case::Document;
    /// use kin_studio::library::DESIGNS;
    ///
    /// let text = DESIGNS[0].file();
    /// assert!(text.contains("r2 = 30;"), "{text}");
    /// assert!(Document::read(&text, "four_bar.kin").is_ok());
    /// ```
    #[must_use]
    pub fn file(&self) -> String {
        let Ok(mechanism) = kin_live::Mechanism::declare(self.declaration()) else {
            // the tests of the library declare each of them
            return String::new();
        };
        let description = mechanism.description();
        let mut text = String::from("kin 1\n");
        for line in without_examples(self.declaration()) {
            let line = line.strip_prefix("    ").unwrap_or(line);
            let _ = writeln!(text, "{}", line.replacen("pub struct", "struct", 1).replace("pub ", ""));
        }
        if !self.parameters.is_empty() {
            let _ = writeln!(
                text,
                "\ndimensions {{ {} }}",
                entries(description.parameters, self.parameters)
            );
        }
        let moving = &description.inputs[0];
        let (at, speed) = (self.inputs[0], self.inputs[0].abs().max(1.0));
        let range = if moving.dimension == Dimension::Angle {
            // values of unknowns hold where the motion begins
            let from = match self.assembly {
                DesignAssembly::Named(_) => 0.0,
                DesignAssembly::Near(_) => degrees(at),
            };
            format!("{from}deg..{}deg at 60rpm", from + 360.0)
        } else {
            format!("{}..{} at {speed}", 0.9 * at, 1.1 * at)
        };
        let standing = entries(&description.inputs[1..], &self.inputs[1..]);
        let _ = writeln!(text, "motion {{ {} = {range}; {standing} }}", moving.name);
        let _ = match self.assembly {
            DesignAssembly::Named("") => Ok(()),
            DesignAssembly::Named(name) => writeln!(text, "assembly = {name};"),
            DesignAssembly::Near(near) => {
                let near = entries(description.unknowns, near);
                writeln!(text, "assembly = {};", near.trim_end_matches(';').replace("; ", ", "))
            }
        };
        file::formatted(&text, self.name).unwrap_or(text)
    }
}

/// The lines of a declaration without the examples in Rust, and without the empty line of documentation before each.
fn without_examples(declaration: &str) -> impl Iterator<Item = &str> {
    let mut lines = declaration.lines().peekable();
    let mut is_example = false;
    std::iter::from_fn(move || {
        loop {
            let line = lines.next()?;
            let is_fence = |line: &str| line.trim().starts_with("/// ```");
            let is_before_example = line.trim() == "///" && lines.peek().is_some_and(|next| is_fence(next));
            match (is_fence(line), is_example || is_before_example) {
                (true, _) => is_example = !is_example,
                (false, true) => {}
                (false, false) => return Some(line),
            }
        }
    })
}

/// Quantities with their values: `r1 = 90; r2 = 30;`. The coordinates of a point stand in one pair of brackets.
fn entries(quantities: &[Quantity<'_>], values: &[f64]) -> String {
    let mut entries: Vec<(String, Vec<String>)> = Vec::new();
    for (quantity, value) in quantities.iter().zip(values) {
        let (name, is_part) = match quantity.name.split_once('.') {
            Some((point, _)) => (point, true),
            None => (quantity.name, false),
        };
        let value = match quantity.dimension {
            Dimension::Angle => format!("{}deg", degrees(*value)),
            _ => value.to_string(),
        };
        match entries.last_mut() {
            Some((last, parts)) if is_part && last == name => parts.push(value),
            _ => entries.push((name.to_owned(), vec![value])),
        }
    }
    let entry = |(name, parts): &(String, Vec<String>)| match parts.as_slice() {
        [only] => format!("{name} = {only};"),
        parts => format!("{name} = ({});", parts.join(", ")),
    };
    entries.iter().map(entry).collect::<Vec<_>>().join(" ")
}

/// An angle in degrees, without the rounding of a round number of degrees.
fn degrees(angle: f64) -> f64 {
    let degrees = angle.to_degrees();
    let round = (degrees * 1e9).round() / 1e9;
    if round.to_radians() == angle { round } else { degrees }
}

#[cfg(test)]
mod tests {
    use crate::case::file::of_text;
    use crate::library::DESIGNS;

    #[test]
    fn every_design_is_a_file_with_its_dimensions() {
        for design in DESIGNS {
            let text = design.file();
            let (subject, settings) = of_text(&text, design.name).unwrap_or_else(|mistakes| panic!("{mistakes}"));
            let case = settings
                .typed()
                .case(&subject)
                .unwrap_or_else(|fault| panic!("{fault}"));
            assert_eq!(case.parameters, design.parameters, "{}", design.name);
        }
    }
}
