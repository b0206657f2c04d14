//! A `.kin` file, taken apart: the declaration, and what is asked of it.

use kin_core::any::{Described as _, Pictured as _};
use kin_core::load::NamedLoads;
use kin_live::Mechanism;

use super::super::columns;
use super::super::loads::{ForceColumns, Loads, unit_linkage};
use super::super::value::Lengths;
use super::joints::{is_friction, is_of_joint};
use super::numbers::Number;
use super::{assemblies, loads, numbers};
use crate::file::{Entry, KinDeclaration, Mistake, Sections, in_order};

/// A file that was read.
#[derive(Debug)]
pub(crate) struct KinFile {
    /// The mechanism.
    pub(crate) mechanism: Mechanism,
    /// The declaration as it was typed.
    pub(crate) declaration: String,
    /// Dimensions and inputs that stand.
    pub(crate) set: Vec<Number>,
    /// The unit of its lengths.
    pub(crate) lengths: Lengths,
    /// Motions of inputs: `theta2=0deg..360deg at 60rpm`.
    pub(crate) over: Vec<String>,
    /// The loads.
    pub(crate) loads: Loads,
    /// The sections, as they were typed.
    pub(crate) sections: Sections,
}

impl KinFile {
    /// Reads the text of a file, and compiles its declaration.
    pub(crate) fn read(text: &str) -> Result<Self, Vec<Mistake>> {
        KinDeclaration::read(text)
            .and_then(|file| Self::of(file, text))
            .map_err(|mistakes| in_order(mistakes, text))
    }

    /// The file with what its sections say of the mechanism.
    fn of(file: KinDeclaration, text: &str) -> Result<Self, Vec<Mistake>> {
        let KinDeclaration {
            mechanism,
            text: declaration,
            mut sections,
        } = file;
        let mut mistakes = std::mem::take(&mut sections.mistakes);
        let compiled = mechanism.declaration();
        let mut lengths = Lengths::default();
        let word = sections.word_of("dimensions");
        let found = numbers::dimensions(compiled.parameters(), &sections.dimensions, word, text, &mut lengths);
        let (mut set, wrong) = found;
        mistakes.extend(wrong);
        let (over, wrong) = numbers::motions(compiled.inputs(), &sections.motion, &mut lengths, &mut set);
        mistakes.extend(wrong);
        let description = mechanism.description();
        let mut named = NamedLoads::new(description);
        // the frame of a guessed body is nobody's word
        if mechanism.outline().guess.is_none() {
            named = named.with_bodies(&mechanism.outline());
        }
        let word = sections.word_of("loads");
        let bodies = mechanism.outline().bodies.iter().map(|body| body.name.to_owned());
        let lacks_a_body = loads::lack_a_body(&sections.loads, &bodies.collect::<Vec<_>>());
        let linkage = unit_linkage(&mechanism);
        let joints = linkage.reactions(&linkage.loads());
        let joints = (&linkage, joints, mechanism.is_space());
        let (loads, wrong) = loads::read(&sections.loads, named, joints, description, word, &mut lengths);
        mistakes.extend(wrong);
        // a mistake in the loads is no reason to miss their columns
        let forces = if sections.loads.is_empty() {
            ForceColumns::default()
        } else {
            let has_friction = sections.loads.iter().any(is_friction);
            ForceColumns::of(&mechanism, &loads.stated(1.0), has_friction)
        };
        let states_joints = |entry: &&Entry| is_of_joint(entry) && !is_friction(entry);
        let lacks_a_joint =
            sections.loads.iter().filter(states_joints).count() > loads.hinges.len() + loads.contacts.len();
        let names = columns::names(description, &forces);
        let mut advised = false;
        for column in &sections.columns {
            if column.text != columns::ALL
                && let Err(message) = columns::named(&column.text, &names)
            {
                let advice = forces.advice(&column.text);
                // the body that is missing is settings, or how all bodies are declared
                let is_known = if advice.is_some() {
                    advised
                } else {
                    (lacks_a_body || lacks_a_joint) && ForceColumns::could_be_of_a_joint(&column.text)
                };
                if is_known {
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
            return Err(mistakes);
        }
        Ok(Self {
            mechanism,
            declaration,
            set,
            lengths,
            over,
            loads,
            sections,
        })
    }
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
        let set: Vec<String> = file.set.iter().map(Number::setting).collect();
        assert_eq!(set, ["crank=30mm", "rod=80mm", "tilt=5deg", "pin.x=1", "pin.y=2cm"]);
        assert_eq!(file.over, ["s=60mm..100mm at 20mm/s"]);
        assert_eq!(
            file.sections.assembly.map(|assembly| assembly.text).as_deref(),
            Some("open")
        );
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
        let count = if std::env::var_os("KIN_EVERY_CASE").is_some() {
            3000
        } else {
            600
        };
        for _ in 0..count {
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
        assert!(kinds[0] > count / 30 && kinds[1] > count / 3, "{kinds:?}");
    }

    #[test]
    fn mistakes_have_ranges() {
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
