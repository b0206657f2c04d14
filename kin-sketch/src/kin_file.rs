//! The `.kin` file of a declared drawing.

use std::fmt::Write;

use crate::declaration::SketchDeclaration;

/// Longer lists get a line for each entry.
const WIDTH: usize = 100;
/// The part of a length by which a slide moves to both sides if nothing else is said.
const SHARE: f64 = 0.1;

/// How a drive moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DriveMotion {
    /// From where to where, counted from the drawn pose: radians, or lengths of the drawing. Without it an angle makes
    /// a turn, and a slide moves a tenth of its distance to both sides.
    pub range: Option<[f64; 2]>,
    /// The speed: radians or lengths for each second. A turn without range goes backwards if it is negative.
    pub speed: Option<f64>,
}

impl DriveMotion {
    /// The value of the input at the start and at the end.
    fn ends(self, drawn: f64, is_angle: bool) -> [f64; 2] {
        let [from, to] = self.range.unwrap_or_else(|| {
            let extent = if is_angle {
                [0.0, std::f64::consts::TAU]
            } else {
                [-SHARE * drawn.abs(), SHARE * drawn.abs()]
            };
            match self.speed {
                Some(speed) if speed < 0.0 => extent.map(|end| -end),
                _ => extent,
            }
        });
        [drawn + from, drawn + to]
    }
}

impl SketchDeclaration {
    /// The text of a `.kin` file: the declaration, its dimensions, the motion of its drives from the drawn pose on,
    /// and the assembly that is drawn. `unit` is the unit of the drawing's lengths, or empty. The documentation of the
    /// mechanism is plain text.
    ///
    /// Dimensions have thirteen digits. Motions follow the order of the drives; a drive without one moves as by
    /// default.
    ///
    /// ```
    /// # use kin_sketch::{Body, Drive, Sketch};
    /// let mut slider_crank = Sketch::new("SliderCrank");
    /// let [o, a, b] = [("o", 0.0, 0.0), ("a", 0.0, 3.0), ("b", 4.0, 0.0)]
    ///     .map(|(name, x, y)| slider_crank.point(name, x, y));
    /// slider_crank.fix(o);
    /// let crank = slider_crank.link("crank", &[o, a]);
    /// slider_crank.link("rod", &[a, b]);
    /// slider_crank.slide(b, Body::Ground, 0.0);
    /// slider_crank.drives.push(Drive::Angle { of: crank, to: Body::Ground });
    ///
    /// let file = slider_crank.declaration().unwrap().kin_file("A pump.", "cm", &[]);
    /// assert!(file.starts_with("kin 1\n/// A pump.\nstruct SliderCrank { crank: Length, rod: Length }\n"));
    /// assert!(file.contains("dimensions { crank = 3cm; rod = 5cm; }\nmotion { crank_angle = 90deg..450deg; }\n"));
    /// ```
    #[must_use]
    pub fn kin_file(&self, documentation: &str, unit: &str, motions: &[DriveMotion]) -> String {
        let mut text = "kin 1\n".to_owned();
        for line in documentation.lines() {
            let _ = writeln!(text, "{}", format!("/// {line}").trim_end());
        }
        text.push_str(&self.text);
        let dimensions = self.dimension_entries(unit);
        if !dimensions.is_empty() {
            section(&mut text, "dimensions", &dimensions);
        }
        let motions = motions.iter().copied().chain(std::iter::repeat(DriveMotion::default()));
        let motions: Vec<String> = self
            .inputs
            .iter()
            .zip(motions)
            .map(|(input, motion)| self.motion(input, motion, unit))
            .collect();
        section(&mut text, "motion", &motions);
        let unknowns = self.unknowns.iter();
        let unknowns: Vec<String> = unknowns
            .map(|(name, value)| format!("{name}={}", self.near(name, *value, unit)))
            .collect();
        if !unknowns.is_empty() {
            let _ = writeln!(text, "assembly = {};", unknowns.join(", "));
        }
        text
    }

    /// The entries of the dimensions, the coordinates of a vector in one.
    fn dimension_entries(&self, unit: &str) -> Vec<String> {
        let mut entries = Vec::new();
        let mut dimensions = self.dimensions.iter();
        while let Some((name, value)) = dimensions.next() {
            if let Some(vector) = name.strip_suffix(".x") {
                let y = dimensions.next().map_or(0.0, |(_, y)| *y);
                entries.push(format!("{vector} = ({}{unit}, {}{unit});", plain(*value), plain(y)));
            } else if self.is_angle(name) {
                entries.push(format!("{name} = {}deg;", plain(value.to_degrees())));
            } else {
                entries.push(format!("{name} = {}{unit};", plain(*value)));
            }
        }
        entries
    }

    fn motion(&self, (name, drawn): &(String, f64), motion: DriveMotion, unit: &str) -> String {
        let is_angle = self.is_angle(name);
        let [from, to] = motion.ends(*drawn, is_angle).map(|end| self.near(name, end, unit));
        let speed = match motion.speed.map(f64::abs) {
            Some(speed) if speed > 0.0 && is_angle => {
                format!(" at {}rpm", rounded(speed * 60.0 / std::f64::consts::TAU, 6))
            }
            Some(speed) if speed > 0.0 => match unit {
                "" => format!(" at {}", rounded(speed, 6)),
                unit => format!(" at {}{unit}/s", rounded(speed, 6)),
            },
            _ => String::new(),
        };
        format!("{name} = {from}..{to}{speed};")
    }

    /// A value near which a position is looked for, in thousandths of a degree, or six digits of the drawing.
    fn near(&self, name: &str, value: f64, unit: &str) -> String {
        if self.is_angle(name) {
            return format!("{}deg", rounded(value.to_degrees(), 3));
        }
        let lengths = self.dimensions.iter().filter(|(name, _)| !self.is_angle(name));
        let size = lengths.fold(value.abs(), |size, (_, length)| size.max(length.abs()));
        let digits = if size > 0.0 { size.log10().floor() } else { 0.0 };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "it is between 0 and 20"
        )]
        let decimals = (5.0 - digits).clamp(0.0, 20.0) as usize;
        format!("{}{unit}", rounded(value, decimals))
    }

    /// Whether the text declares a quantity as an angle.
    fn is_angle(&self, name: &str) -> bool {
        let declared = format!("{name}: Angle");
        self.text.match_indices(&declared).any(|(start, _)| {
            let before = self.text[..start].chars().next_back();
            before.is_none_or(|letter| !letter.is_alphanumeric() && letter != '_')
        })
    }
}

/// A measured number without what its last digits lost.
fn plain(value: f64) -> f64 {
    format!("{value:.12e}").parse().unwrap_or(value) + 0.0
}

/// A number with so many decimals at most.
fn rounded(value: f64, decimals: usize) -> f64 {
    let near = format!("{value:.decimals$}").parse().unwrap_or(value);
    // no -0
    near + 0.0
}

fn section(text: &mut String, word: &str, entries: &[String]) {
    let line = format!("{word} {{ {} }}", entries.join(" "));
    let _ = if line.chars().count() <= WIDTH {
        writeln!(text, "{line}")
    } else {
        writeln!(text, "{word} {{\n    {}\n}}", entries.join("\n    "))
    };
}
