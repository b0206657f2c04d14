//! The sizes and times of every mechanism of the library in each language.

use core::hint::black_box;
use std::fmt::Write as _;
use std::fs;

use kin_core::tape::{self, Options};
use kin_tests::mechanisms::cases::{self, Case, ThroughSnap, Visitor};

use crate::environment::Environment;
use crate::kin::{Written, assert_equal};
use crate::race::Race;
use crate::solved::Wanted;

const POSES: usize = 256;
const TURNS: usize = 20;

/// The chapter with the table, and the lines between which it stands.
const CHAPTER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../docs/languages.md");
const START: &str = "<!-- the table of `kin-peers -- --book` begins -->\n\n";
const END: &str = "\n<!-- and ends -->";

/// The mechanisms in the chapter.
const SHOWN: [&str; 4] = ["ClassThreeTriad", "FourBar", "JansenLeg", "Rssr"];

/// The rows of the table, by mechanism.
struct Table<'a> {
    environment: &'a Environment,
    rows: Vec<String>,
    /// The largest ratios of C and of JavaScript, each with its mechanism.
    largest: [(f64, &'static str); 2],
}

impl Visitor for Table<'_> {
    fn visit<M: ThroughSnap>(&mut self, case: Case) {
        let mechanism: M = case.mechanism();
        let wanted = Wanted::<M>::of(case, POSES);
        let rows: Vec<Vec<f64>> = wanted.iter().map(|own| own.arguments(mechanism)).collect();
        let solved: Vec<f64> = wanted.iter().flat_map(|own| own.results(mechanism)).collect();
        let name = M::DESCRIPTION.name;
        let folder = self.environment.folder.join("library").join(name);
        let tape = tape::record::<M>(&Options::new()).expect("every mechanism of the library is recorded");
        let written = Written::new(&tape, &folder, &rows);
        let mut race = Race::new(POSES, TURNS);
        race.enter_each("solve", wanted, |own| own.solve(black_box(&mechanism)));
        let found = [
            written.enter_c(&mut race, "c", &folder, POSES, &["-O2", "-ffp-contract=off"]),
            written.enter_java_script(&mut race, "javascript", &folder),
            written.enter_python(&mut race, "numpy", &folder, self.environment),
        ];
        for (language, found) in ["C", "JavaScript", "NumPy"].into_iter().zip(found) {
            assert_equal(&format!("{name} in {language}"), &found, &solved);
        }
        let times: Vec<f64> = race.run().into_iter().map(|(_, time)| time).collect();
        let ratios: Vec<f64> = times.iter().map(|time| time / times[0]).collect();
        for (largest, ratio) in self.largest.iter_mut().zip(&ratios[1..]) {
            if *ratio > largest.0 {
                *largest = (*ratio, name);
            }
        }
        for (language, ratio) in ["c", "javascript", "numpy"].into_iter().zip(&ratios[1..]) {
            println!("ratio {name}.{language}/solve {ratio:.3}");
        }
        let [c, java_script, python] = written.bytes.map(|bytes| bytes.div_ceil(1000));
        self.rows.push(format!(
            "| `{name}` | {c} | {java_script} | {python} | {:.0} | {:.2} | {:.1} | {:.1} |\n",
            times[0], ratios[1], ratios[2], ratios[3]
        ));
    }
}

/// Measures all mechanisms, prints the table, and writes it into the book if that is wanted.
pub(crate) fn measure(environment: &Environment, is_for_book: bool) {
    let mut table = Table {
        environment,
        rows: Vec::new(),
        largest: [(0.0, ""); 2],
    };
    cases::library(&mut table);
    cases::coupled_library(&mut table);
    let mut rows = table.rows;
    rows.sort();
    let mut text = String::from(
        "| mechanism | C, KB | JavaScript, KB | Python, KB | `solve`, ns | C | JavaScript | NumPy |\n\
         |---|---|---|---|---|---|---|---|\n",
    );
    text.extend(rows);
    for (language, (ratio, name)) in ["C", "JavaScript"].into_iter().zip(table.largest) {
        writeln!(text, "\nlargest {language}: {ratio:.2}, {name}").expect("a string can be written");
    }
    println!("{text}");
    if is_for_book {
        let is_shown = |line: &&str| {
            line.split('`')
                .nth(1)
                .is_none_or(|name| name == "solve" || SHOWN.contains(&name))
        };
        let lines = text.lines().take_while(|line| !line.is_empty()).filter(is_shown);
        let table: Vec<&str> = lines.collect();
        let table = table.join("\n");
        let chapter = fs::read_to_string(CHAPTER).expect("the chapter is there");
        let (before, rest) = chapter
            .split_once(START)
            .expect("the chapter has a place for the table");
        let (_, after) = rest.split_once(END).expect("the place ends");
        fs::write(CHAPTER, format!("{before}{START}{table}\n{END}{after}")).expect("the chapter can be written");
    }
}
