//! A `.kin` file, taken apart: the declaration, and what is asked of it.

use kin_core::any::{Described as _, Pictured as _};
use kin_core::load::NamedLoads;
use kin_live::{DeclareError, Mechanism};
use proc_macro2::{TokenStream, TokenTree};

use super::super::columns;
use super::super::loads::{ForceColumns, Loads};
use super::super::value::Lengths;
use super::place::Mistake;
use super::sections::{Section, Sections, blank};
use super::{assemblies, loads, numbers};

/// The first line of every file.
const FIRST_LINE: &str = "kin 1";

/// A file that was read.
#[derive(Debug)]
pub(crate) struct KinFile {
    /// The mechanism.
    pub(crate) mechanism: Mechanism,
    /// The declaration as it was typed.
    pub(crate) declaration: String,
    /// Dimensions and inputs that stand: `r1=90`.
    pub(crate) set: Vec<String>,
    /// Motions of inputs: `theta2=0deg..360deg at 60rpm`.
    pub(crate) over: Vec<String>,
    /// The assembly, or several.
    pub(crate) assembly: Option<String>,
    /// The columns to print.
    pub(crate) columns: Vec<String>,
    /// The loads.
    pub(crate) loads: Loads,
    /// Where the sections stand.
    pub(crate) sections: Vec<Section>,
}

impl KinFile {
    /// Reads the text of a file, and compiles its declaration.
    pub(crate) fn read(text: &str) -> Result<Self, Vec<Mistake>> {
        // a sign that begins comments elsewhere may be taken for many things
        Self::read_tokens(text).map_err(|mistakes| other_comment(text).map_or(mistakes, |comment| vec![comment]))
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
        let mut sections = Sections::read(text, &tokens).map_err(|mistake| vec![mistake])?;
        let mut mistakes = std::mem::take(&mut sections.mistakes);
        // with blanks in the place of all else, so that every token keeps its own
        let declaration = blank(&blanked, sections.places.iter().map(|section| &section.whole));
        match Mechanism::declare(&declaration) {
            Ok(mechanism) => Self::of(sections, text, &declaration, mechanism, mistakes),
            Err(DeclareError::Mistakes(found)) => {
                mistakes.extend(found.into_iter().map(|one| Mistake::new(one.message, one.bytes)));
                Err(in_order(mistakes))
            }
            Err(error) => Err(vec![Mistake::new(error.to_string(), 0..0)]),
        }
    }

    /// The file with what its sections say of the mechanism.
    fn of(
        sections: Sections,
        text: &str,
        declaration: &str,
        mechanism: Mechanism,
        mut mistakes: Vec<Mistake>,
    ) -> Result<Self, Vec<Mistake>> {
        let compiled = mechanism.declaration();
        let mut lengths = Lengths::default();
        let place = sections.place_of("dimensions");
        let found = numbers::dimensions(compiled.parameters(), &sections.dimensions, place, text, &mut lengths);
        let (mut set, wrong) = found;
        mistakes.extend(wrong);
        let (over, wrong) = numbers::motions(compiled.inputs(), &sections.motion, &mut lengths, &mut set);
        mistakes.extend(wrong);
        let description = mechanism.description();
        let mut places = NamedLoads::new(description);
        // the frame of a guessed body is nobody's word
        if mechanism.outline().guess.is_none() {
            places = places.with_bodies(&mechanism.outline());
        }
        let place = sections.place_of("loads");
        let (loads, wrong) = loads::read(&sections.loads, places, description, place, &mut lengths);
        mistakes.extend(wrong);
        let forces = if loads.is_empty() {
            ForceColumns::default()
        } else {
            ForceColumns::of(&mechanism)
        };
        let names = columns::names(description, &forces);
        let mut advised = false;
        for column in &sections.columns {
            if column.text != columns::ALL
                && let Err(message) = columns::named(&column.text, &names)
            {
                let advice = forces.advice(&column.text);
                if advice.is_some() && advised {
                    continue;
                }
                advised |= advice.is_some();
                let message = advice.unwrap_or(message);
                mistakes.push(Mistake::new(message, column.range.clone()));
            }
        }
        if let Some(assembly) = &sections.assembly {
            mistakes.extend(assemblies::mistake(&mechanism, assembly, &mut lengths));
        }
        if !mistakes.is_empty() {
            return Err(in_order(mistakes));
        }
        let declaration = declaration.lines().map(str::trim_end).collect::<Vec<_>>().join("\n");
        Ok(Self {
            mechanism,
            declaration: declaration.trim().to_owned(),
            set,
            over,
            assembly: sections.assembly.map(|assembly| assembly.text),
            columns: sections.columns.into_iter().map(|column| column.text).collect(),
            loads,
            sections: sections.places,
        })
    }
}

/// Mistakes in the order of their places.
fn in_order(mut mistakes: Vec<Mistake>) -> Vec<Mistake> {
    mistakes.sort_by_key(|mistake| mistake.range.start);
    mistakes
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

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "kin 1
/// A pump.
struct Pump { crank: Length, rod: Length, tilt: Angle, pin: Vector }
input s: Length;
unknown theta: Angle, phi: Angle;
pin + crank * cis(theta + tilt) + rod * cis(phi) == vec2(s, 0);
dimensions { crank = 30mm; rod = 80mm; tilt = 5deg; pin = (1, 2cm); }
motion { s = 60mm..100mm at 20mm/s; }
assembly = open;
";

    #[test]
    fn a_file_is_taken_apart() {
        let file = KinFile::read(FILE).unwrap();
        let declared = file.mechanism.declaration();
        assert_eq!((declared.name(), declared.documentation()), ("Pump", "A pump."));
        assert_eq!(
            file.set,
            ["crank=30mm", "rod=80mm", "tilt=5deg", "pin.x=1", "pin.y=2cm"]
        );
        assert_eq!(file.over, ["s=60mm..100mm at 20mm/s"]);
        assert_eq!(file.assembly.as_deref(), Some("open"));
        assert!(!file.declaration.contains("dimensions") && !file.declaration.contains("kin 1"));
        assert!(file.declaration.ends_with("vec2(s, 0);"));
    }

    #[test]
    fn what_is_not_a_declaration_is_refused() {
        for harm in [
            "#[doc = include_str!(\"/etc/passwd\")]",
            "#[derive(Debug)]",
            "#![feature(test)]",
            "#[doc(hidden)]",
            "let x = env!(\"HOME\");",
            "let x = \"text\";",
            "let x = 'c';",
            "let x = std::f64::MAX;",
            "fn main() {}",
            "} fn main() { loop {} }",
            "let x = { 3 };",
            "let x = [1, 2];",
            "let x = &crank;",
            "let x = (std::f64::MAX);",
        ] {
            let text = FILE.replace("input s", &format!("{harm}\ninput s"));
            let mistake = KinFile::read(&text).unwrap_err().remove(0);
            // where it stands, or where the file cannot be read any further
            assert!(mistake.range.start >= 6, "{harm}: {mistake:?}");
            let inside = FILE.replace("rod: Length", &format!("{harm} rod: Length"));
            assert!(KinFile::read(&inside).is_err(), "{harm}");
        }
    }

    /// The width of a format is at most 65 535.
    #[test]
    fn long_lines_are_read_and_told() {
        let blanks = |count| FILE.replacen("kin 1", &format!("kin 1{}", " ".repeat(count)), 1);
        assert!(KinFile::read(&blanks(30_000)).is_ok());
        let long = "a".repeat(70_000);
        for text in [
            blanks(70_000),
            format!("kin 1\n//{long}"),
            format!("kin 1 {long}"),
            FILE.replace("crank", &long).replace("30mm", "30deg"),
            FILE.replacen("crank = 30mm;", &format!("{long} = 30mm;"), 1),
        ] {
            let shown = KinFile::read(&text).unwrap_err()[0].shown("a.kin", &text);
            assert!(shown.contains("a.kin:"));
        }
    }

    /// Whatever a file holds, it is read or there is a mistake in it that can be shown.
    #[test]
    fn spoilt_files_are_mistakes() {
        let mut random = kin_core::verify::Random::new(7);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "it is below the end"
        )]
        let mut below = |end: usize| random.between(0.0, end as f64) as usize;
        let parts = [
            "#", ";", "\n", "'", "{", ")", "input ", "θ", ",5", "-", "..", " at ", "=", "\u{feff}", "0",
        ];
        let mut kinds = [0; 2];
        for _ in 0..3000 {
            let mut text: Vec<char> = FILE.chars().collect();
            for _ in 0..=below(3) {
                let place = below(text.len());
                if below(2) == 0 {
                    text.drain(place..(place + below(9)).min(text.len()));
                } else {
                    let part = parts[below(parts.len())].repeat(1 + below(3) * below(400));
                    text.splice(place..place, part.chars());
                }
            }
            let text: String = text.into_iter().collect();
            let read = KinFile::read(&text).map_err(|mistakes| mistakes[0].shown("a.kin", &text));
            kinds[usize::from(read.is_err())] += 1;
        }
        assert!(kinds[0] > 100 && kinds[1] > 1000, "{kinds:?}");
    }

    #[test]
    fn mistakes_have_places() {
        for (right, wrong, at, word) in [
            ("kin 1", "kin 2", "kin 2", "use a later version"),
            ("kin 1", "struct", "struct", "first line"),
            ("crank = 30mm", "crnk = 30mm", "crnk", "did you mean `crank`?"),
            ("crank = 30mm", "crank = 30deg", "30deg", "unit of length"),
            ("tilt = 5deg", "tilt = 5", "5;", "write `5deg`"),
            ("pin = (1, 2cm)", "pin = 1", "1; }", "(1.5, 1.5)"),
            ("pin = (1, 2cm)", "pin = (1, 2, 3)", "(1, 2, 3)", "2 coordinates"),
            ("rod = 80mm; ", "", "dimensions", "no value for `rod`"),
            ("rod = 80mm", "crank = 80mm", "crank = 80", "two values"),
            ("s = 60mm", "x = 60mm", "x = 60", "there is `s`"),
            ("20mm/s", "20rpm", "60mm..100mm at", "20mm/s"),
            ("assembly = open;", "assembly = open", "assembly", "ends with `;`"),
            ("input s: Length", "input s", "s;", "write `s: Angle`, or another"),
            ("phi: Angle", "phi", "phi;", "write `phi: Angle`, or another"),
            ("crank: Length", "crank", "crank, rod", "write `crank: Length`"),
            (
                "s: Length;",
                "s: Length",
                "Length\nunknown",
                "a statement ends with `;`",
            ),
            (
                "vec2(s, 0);",
                "vec2(s, 0)",
                "(s, 0)\ndimensions",
                "a statement ends with `;`",
            ),
            ("phi: Angle;", "phi: Angle", "Angle\npin", "a statement ends with `;`"),
            (
                "input s",
                "# the pump's input\ninput s",
                "# the",
                "a comment begins with `//`",
            ),
            (
                "rod = 80mm;",
                "rod = 80mm; # long",
                "# long",
                "a comment begins with `//`",
            ),
            ("80mm", "80,5mm", "80,5mm", "write `80.5mm` with a point"),
            (
                "100mm at 20mm/s",
                "100mm 20mm/s",
                "60mm..100mm 20",
                "write `60mm..100mm at 20mm/s`",
            ),
            ("60mm..100mm", "60mm-100mm", "60mm-100mm", "as in `60..100mm`"),
        ] {
            let text = FILE.replacen(right, wrong, 1);
            let mistake = KinFile::read(&text).unwrap_err().remove(0);
            assert!(mistake.message.contains(word), "{wrong}: {}", mistake.message);
            assert!(
                text[mistake.range.start..].starts_with(at),
                "{wrong}: {}",
                &text[mistake.range.start..]
            );
        }
    }
}
