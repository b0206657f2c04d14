//! Writes the solver of a mechanism of the library as C99, with a program that shows it, or in JavaScript or Python.
//!
//! ```sh
//! cargo run --example c_code --features tape -- jansen_leg out
//! cc -O2 -std=c99 -ffp-contract=off out/main.c out/jansen_leg.c -lm -o out/jansen_leg
//! ```
//!
//! With the word `javascript` or `python` behind the folder, the solver is a module of that language. With the word
//! `skeleton` the code finds the joints as well.

use std::error::Error;
use std::fs;
use std::path::Path;

#[allow(clippy::wildcard_imports, reason = "any mechanism of the library may be asked for")]
use kin_core::library::*;
use kin_core::tape::{self, Options, RecordError, Tape};

/// The function that records one mechanism.
type Record = fn(&Options) -> Result<Tape, RecordError>;

/// The tape of a mechanism by its name, if the library has it.
fn tape_of(name: &str, options: &Options) -> Option<Result<Tape, RecordError>> {
    macro_rules! by_name {
        ($($mechanism:ident)+) => {
            [$((stringify!($mechanism), tape::record::<$mechanism>)),+]
        };
    }
    let all: [(&str, Record); 37] = kin_core::each_library_mechanism!(by_name);
    let plain = |name: &str| name.replace('_', "").to_lowercase();
    let (_, record) = all.into_iter().find(|(own, _)| plain(own) == plain(name))?;
    Some(record(options))
}

/// The word that names a language.
enum Language {
    C,
    JavaScript,
    Python,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut words = std::env::args().skip(1);
    let name = words.next().unwrap_or_else(|| "four_bar".to_owned());
    let folder = words.next().unwrap_or_else(|| "out".to_owned());
    let (mut options, mut language) = (Options::new(), Language::C);
    for word in words {
        match word.as_str() {
            "skeleton" => options = options.with_skeleton(),
            "javascript" => language = Language::JavaScript,
            "python" => language = Language::Python,
            _ => return Err(format!("`{word}` is neither `javascript`, `python` nor `skeleton`").into()),
        }
    }
    let Some(tape) = tape_of(&name, &options) else {
        return Err(format!("the library has no mechanism `{name}`; the book lists all of them").into());
    };
    let (tape, folder) = (tape?, Path::new(&folder));
    let c = tape.c();
    let files = match language {
        Language::C => vec![
            (format!("{}.h", c.name), c.header),
            (format!("{}.c", c.name), c.source),
            ("main.c".to_owned(), c.example),
        ],
        Language::JavaScript => vec![(format!("{}.mjs", c.name), tape.java_script())],
        Language::Python => vec![(format!("{}.py", c.name), tape.python())],
    };
    fs::create_dir_all(folder)?;
    for (file, text) in files {
        fs::write(folder.join(&file), &text)?;
        println!("{}: {} bytes", folder.join(&file).display(), text.len());
    }
    if matches!(language, Language::C) {
        let (folder, name) = (folder.display(), c.name);
        println!(
            "build it by: cc -O2 -std=c99 -ffp-contract=off {folder}/main.c {folder}/{name}.c -lm -o {folder}/{name}"
        );
    }
    Ok(())
}
