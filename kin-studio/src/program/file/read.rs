//! The numbers of a `.kin` file.

use std::ops::Range;

use kin_compiler::Quantity;
use kin_core::Dimension;
use kin_live::Mechanism;

use super::super::fault::similar;
use super::super::motion::InputMotion;
use super::super::value::{self, Lengths};
use crate::file::{Entry, KinDeclaration, Mistake, or_comment};

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
    /// The assembly.
    pub(crate) assembly: Option<String>,
}

/// A quantity of the declaration.
#[derive(Clone, Debug)]
struct Declared {
    name: String,
    dimension: Dimension,
    /// One, or the number of coordinates of a point.
    parts: usize,
}

impl From<&Quantity> for Declared {
    fn from(quantity: &Quantity) -> Self {
        use kin_compiler::Dimension as Of;
        let (dimension, parts) = match quantity.dimension {
            Of::Length => (Dimension::Length, 1),
            Of::Angle | Of::Direction => (Dimension::Angle, 1),
            Of::Scalar => (Dimension::Scalar, 1),
            Of::Point | Of::Vector => (Dimension::Length, 2),
            Of::Point3 | Of::Vector3 => (Dimension::Length, 3),
        };
        Self {
            name: quantity.name.clone(),
            dimension,
            parts,
        }
    }
}

impl KinFile {
    /// Reads the text of a file, and compiles its declaration.
    pub(crate) fn read(text: &str) -> Result<Self, Vec<Mistake>> {
        let file = KinDeclaration::read(text)?;
        Self::of(file, text).map_err(|mistake| or_comment(vec![mistake], text))
    }

    /// The file with the numbers of its sections.
    fn of(file: KinDeclaration, text: &str) -> Result<Self, Mistake> {
        let KinDeclaration {
            mechanism,
            text: declaration,
            sections,
        } = file;
        let compiled = mechanism.declaration();
        let [fields, inputs] = [compiled.parameters(), compiled.inputs()]
            .map(|quantities| quantities.iter().map(Declared::from).collect::<Vec<_>>());
        let (dimensions, dimensions_at) = &sections.dimensions;
        let mut lengths = Lengths::default();
        let mut set = numbers(&fields, dimensions, dimensions_at, text, &mut lengths)?;
        let over = motions(&inputs, &sections.motion, &mut lengths, &mut set)?;
        Ok(Self {
            mechanism,
            declaration,
            set,
            over,
            assembly: sections.assembly,
        })
    }
}

const COORDINATES: [&str; 3] = ["x", "y", "z"];

/// The dimensions as they are typed behind `--set`.
fn numbers(
    fields: &[Declared],
    entries: &[Entry],
    section: &Range<usize>,
    text: &str,
    lengths: &mut Lengths,
) -> Result<Vec<String>, Mistake> {
    let mut set = Vec::new();
    let mut given: Vec<String> = Vec::new();
    for entry in entries {
        let base = entry.name.split('.').next().unwrap_or("");
        let Some(field) = fields.iter().find(|field| field.name == base) else {
            let names = fields.iter().map(|field| field.name.as_str());
            let message = format!(
                "the structure has no dimension `{}`; {}",
                entry.name,
                similar(&entry.name, names)
            );
            return Err(Mistake::new(message, entry.name_range.clone()));
        };
        let pieces: Vec<(String, &str)> = match entry.value.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) {
            Some(inner) => {
                let parts: Vec<&str> = inner.split(',').map(str::trim).collect();
                if field.parts == 1 || parts.len() != field.parts {
                    let wanted = if field.parts == 1 {
                        "one number".to_owned()
                    } else {
                        format!("{} coordinates", field.parts)
                    };
                    return Err(Mistake::new(
                        format!("`{base}` takes {wanted}"),
                        entry.value_range.clone(),
                    ));
                }
                let names = COORDINATES.iter().map(|part| format!("{base}.{part}"));
                names.zip(parts).collect()
            }
            None if field.parts > 1 && !entry.name.contains('.') => {
                let example = vec!["1.5"; field.parts].join(", ");
                return Err(Mistake::new(
                    format!("`{base}` is a point: write `{base} = ({example});`"),
                    entry.value_range.clone(),
                ));
            }
            None => vec![(entry.name.clone(), entry.value.as_str())],
        };
        for (name, value) in pieces {
            if given.contains(&name) {
                return Err(Mistake::new(
                    format!("`{name}` has two values"),
                    entry.name_range.clone(),
                ));
            }
            value::quantity(field.dimension, value, lengths)
                .map_err(|message| Mistake::new(message, entry.value_range.clone()))?;
            set.push(format!("{name}={value}"));
            given.push(name);
        }
    }
    let whole = |field: &Declared| -> Vec<String> {
        if field.parts == 1 {
            vec![field.name.clone()]
        } else {
            COORDINATES[..field.parts]
                .iter()
                .map(|part| format!("{}.{part}", field.name))
                .collect()
        }
    };
    let missing: Vec<String> = fields
        .iter()
        .flat_map(whole)
        .filter(|name| !given.contains(name))
        .collect();
    if let Some(first) = missing.first() {
        let names: Vec<String> = missing.iter().map(|name| format!("`{name}`")).collect();
        let message = format!(
            "no value for {}: write `dimensions {{ {first} = 45mm; }}`",
            names.join(", ")
        );
        let range = if section.is_empty() {
            let end = text.trim_end().len();
            end..end
        } else {
            section.clone()
        };
        return Err(Mistake::new(message, range));
    }
    Ok(set)
}

/// The motions as they are typed behind `--over`; inputs that stand go to `set`.
fn motions(
    inputs: &[Declared],
    entries: &[Entry],
    lengths: &mut Lengths,
    set: &mut Vec<String>,
) -> Result<Vec<String>, Mistake> {
    let mut over = Vec::new();
    for entry in entries {
        let Some(input) = inputs.iter().find(|input| input.name == entry.name) else {
            let names = inputs.iter().map(|input| input.name.as_str());
            let message = format!("there is no input `{}`; {}", entry.name, similar(&entry.name, names));
            return Err(Mistake::new(message, entry.name_range.clone()));
        };
        let motion = InputMotion::read(input.dimension, &entry.value, lengths)
            .map_err(|message| Mistake::new(message, entry.value_range.clone()))?;
        let text = format!("{}={}", entry.name, entry.value);
        if motion.moves() {
            over.push(text);
        } else {
            set.push(text);
        }
    }
    Ok(over)
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
        let blanks = FILE.replacen("kin 1", &format!("kin 1{}", " ".repeat(70_000)), 1);
        assert!(KinFile::read(&blanks).is_ok());
        let long = "a".repeat(70_000);
        for text in [
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
