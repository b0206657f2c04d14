//! A `.kin` file, taken apart: the declaration, and the numbers.

use std::ops::Range;

use kin_compiler::Quantity;
use kin_core::Dimension;
use kin_live::{DeclareError, Mechanism};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use super::super::fault::similar;
use super::super::motion::InputMotion;
use super::super::value::{self, Lengths};
use super::place::Mistake;

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
    /// The assembly.
    pub(crate) assembly: Option<String>,
}

/// The sections of a file, apart from each other.
struct Sections {
    /// The entries, and the word before them.
    dimensions: (Vec<Entry>, Range<usize>),
    motion: Vec<Entry>,
    assembly: Option<String>,
    /// What is not the declaration.
    blanks: Vec<Range<usize>>,
}

/// A name with what stands behind its `=`.
#[derive(Clone, Debug)]
struct Entry {
    name: String,
    name_range: Range<usize>,
    value: String,
    value_range: Range<usize>,
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
        // a sign that begins comments elsewhere may be taken for many things
        Self::read_tokens(text).map_err(|mistakes| other_comment(text).map_or(mistakes, |comment| vec![comment]))
    }

    /// The tokens of a file whose statements can be told apart, whatever they say. Each token is where it was typed.
    pub(crate) fn tokens(text: &str) -> Result<TokenStream, Vec<Mistake>> {
        let (_, stream) = Self::lexed(text)?;
        let tokens: Vec<TokenTree> = stream.clone().into_iter().collect();
        let sections = Reader { text, tokens: &tokens }.sections();
        sections.map(|_| stream).map_err(|mistake| vec![mistake])
    }

    fn read_tokens(text: &str) -> Result<Self, Vec<Mistake>> {
        let (blanked, stream) = Self::lexed(text)?;
        let tokens: Vec<TokenTree> = stream.into_iter().collect();
        Reader { text, tokens: &tokens }.read(&blanked)
    }

    /// The text with blanks in the place of its first line, and its tokens.
    fn lexed(text: &str) -> Result<(String, TokenStream), Vec<Mistake>> {
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
        Ok((blanked, stream))
    }
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

struct Reader<'t> {
    text: &'t str,
    tokens: &'t [TokenTree],
}

fn range_of(token: &TokenTree) -> Range<usize> {
    token.span().byte_range()
}

fn is_ident(token: Option<&TokenTree>, name: &str) -> bool {
    matches!(token, Some(TokenTree::Ident(ident)) if ident == name)
}

fn is_punct(token: Option<&TokenTree>, letter: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == letter)
}

fn braces(token: Option<&TokenTree>) -> Option<&Group> {
    match token {
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => Some(group),
        _ => None,
    }
}

impl Reader<'_> {
    fn read(&self, blanked: &str) -> Result<KinFile, Vec<Mistake>> {
        let sections = self.sections().map_err(|mistake| vec![mistake])?;
        // with blanks in the place of all else, so that every token keeps its own
        let declaration = blank(blanked, &sections.blanks);
        let mechanism = Mechanism::declare(&declaration).map_err(|error| match error {
            DeclareError::Mistakes(mistakes) => {
                let mistakes = mistakes.into_iter();
                mistakes
                    .map(|mistake| Mistake::new(mistake.message, mistake.bytes))
                    .collect::<Vec<_>>()
            }
            error => vec![Mistake::new(error.to_string(), 0..0)],
        })?;
        self.file(sections, &declaration, mechanism)
            .map_err(|mistake| vec![mistake])
    }

    /// Divides the file into its sections.
    fn sections(&self) -> Result<Sections, Mistake> {
        let (mut dimensions, mut motion, mut assembly) = (None, None, None);
        let mut declared: Vec<TokenTree> = Vec::new();
        let mut blanks: Vec<Range<usize>> = Vec::new();
        let mut place = 0;
        while let Some(token) = self.tokens.get(place) {
            let next = self.tokens.get(place + 1);
            let section = [("dimensions", &mut dimensions), ("motion", &mut motion)]
                .into_iter()
                .find(|(name, _)| is_ident(Some(token), name));
            check_end(&declared, token)?;
            if let (Some((name, slot)), Some(group)) = (section, braces(next)) {
                let whole = range_of(token).start..group.span().byte_range().end;
                if slot.is_some() {
                    return Err(Mistake::new(
                        format!("there are two sections `{name}`"),
                        range_of(token),
                    ));
                }
                *slot = Some((self.entries(group)?, range_of(token)));
                blanks.push(whole);
                place += 2;
                continue;
            }
            let is_assembly =
                is_ident(Some(token), "assembly") && is_punct(next, '=') && !is_punct(self.tokens.get(place + 2), '=');
            if is_assembly {
                let end = (place..self.tokens.len()).find(|index| is_punct(self.tokens.get(*index), ';'));
                let Some(end) = end else {
                    return Err(Mistake::new(
                        "the assembly ends with `;`, as in `assembly = open;`",
                        range_of(token),
                    ));
                };
                let (from, to) = (range_of(&self.tokens[place + 1]).end, range_of(&self.tokens[end]).start);
                assembly = Some((self.text[from..to].trim().to_owned(), from..to));
                blanks.push(range_of(token).start..range_of(&self.tokens[end]).end);
                place = end + 1;
                continue;
            }
            declared.push(token.clone());
            place += 1;
        }
        check_form(&declared, true)?;
        Ok(Sections {
            dimensions: dimensions.unwrap_or_default(),
            motion: motion.unwrap_or_default().0,
            assembly: assembly.map(|(text, _)| text),
            blanks,
        })
    }

    /// The file with the numbers of its sections.
    fn file(&self, sections: Sections, declaration: &str, mechanism: Mechanism) -> Result<KinFile, Mistake> {
        let compiled = mechanism.declaration();
        let [fields, inputs] = [compiled.parameters(), compiled.inputs()]
            .map(|quantities| quantities.iter().map(Declared::from).collect::<Vec<_>>());
        let (dimensions, dimensions_at) = &sections.dimensions;
        let mut lengths = Lengths::default();
        let mut set = numbers(&fields, dimensions, dimensions_at, self.text, &mut lengths)?;
        let over = motions(&inputs, &sections.motion, &mut lengths, &mut set)?;
        let declaration = declaration.lines().map(str::trim_end).collect::<Vec<_>>().join("\n");
        Ok(KinFile {
            mechanism,
            declaration: declaration.trim().to_owned(),
            set,
            over,
            assembly: sections.assembly,
        })
    }

    /// The entries of a section: `name = value;`.
    fn entries(&self, group: &Group) -> Result<Vec<Entry>, Mistake> {
        let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
        let mut entries = Vec::new();
        for part in tokens.split(|token| is_punct(Some(token), ';')) {
            let (Some(first), Some(last)) = (part.first(), part.last()) else {
                continue;
            };
            let whole = range_of(first).start..range_of(last).end;
            let Some(equals) = part.iter().position(|token| is_punct(Some(token), '=')) else {
                return Err(Mistake::new("a name and a value are written as `r1 = 90;`", whole));
            };
            if part[equals + 1..].iter().any(|token| is_punct(Some(token), '='))
                && !self.text[whole.clone()].contains("..=")
            {
                return Err(Mistake::new("two values without a `;` between them", whole));
            }
            let name_range = whole.start..range_of(&part[equals]).start;
            let value_range = range_of(&part[equals]).end..whole.end;
            let (name, value) = (&self.text[name_range.clone()], &self.text[value_range.clone()]);
            if value.trim().is_empty() {
                return Err(Mistake::new(format!("`{}` has no value", name.trim()), whole));
            }
            let value_start = value_range.start + (value.len() - value.trim_start().len());
            entries.push(Entry {
                name: name.trim().replace(' ', ""),
                name_range: name_range.start..name_range.start + name.trim_end().len(),
                value: value.trim().to_owned(),
                value_range: value_start..value_range.end,
            });
        }
        Ok(entries)
    }
}

/// A text with blanks in some ranges, so that every token keeps its place.
fn blank(text: &str, ranges: &[Range<usize>]) -> String {
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

/// Refuses attributes, which a file does not have, and sections of other names. All else is left to the compiler.
fn check_form(tokens: &[TokenTree], is_outside: bool) -> Result<(), Mistake> {
    let mut braces_seen = 0;
    for (place, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Punct(punct) if punct.as_char() == '#' => {
                let is_inner = is_punct(tokens.get(place + 1), '!');
                let attribute = tokens.get(place + 1 + usize::from(is_inner));
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
                let repeats = is_outside && is_repetition(&tokens[..place]);
                if group.delimiter() == Delimiter::Brace && !repeats {
                    braces_seen += 1;
                    if !is_outside || braces_seen > 1 {
                        return Err(Mistake::new(
                            "these braces have no place here: a file has one structure, `for … in […] { .. }`, \
                             `dimensions { .. }` and `motion { .. }`",
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

/// Whether it is what a doc comment becomes: `[doc = "text"]`.
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

/// The words behind which a statement goes on, and those with which a line may go on.
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
