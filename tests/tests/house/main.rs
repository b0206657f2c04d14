//! The rooms of all packages, and the order in which they import each other.
//!
//! A room is a part of a package with one task. It imports only from the rooms before it in its package's list.

mod errors;
mod manifests;
mod source;
mod width;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, TokenTree};

use errors::errors;
use source::{Source, add_paths, is_mark, sources};

struct Package {
    name: &'static str,
    /// The modules that may name any room, and that no room names: the crate's names for others, and programs.
    faces: &'static [&'static str],
    /// Items at the root of the crate that any room may name.
    root_items: &'static [&'static str],
    /// From the lowest to the highest. A room consists of one module, or of several joined by `+`, without those of
    /// their modules that are rooms themselves.
    rooms: &'static str,
}

const RUNTIME: Package = Package {
    name: "kin-runtime",
    faces: &["lib", "declared", "private"],
    root_items: &["__debug_by_display"],
    rooms: "number geometry quantity failure assembly solve bounds motion hermite law picture mechanism any assemblies \
            curve track load batch reaction sweep extremes cycle tape exact linkage stored interop verify editor",
};

const CORE: Package = Package {
    name: "kin-core",
    faces: &["lib", "declaration", "prelude"],
    root_items: &[
        "Assembly",
        "Motion",
        "Number",
        "Plane",
        "Scalar",
        "each_library_mechanism",
        "mechanism",
        "storable",
    ],
    rooms: "library",
};

const COMPILER: Package = Package {
    name: "kin-compiler",
    faces: &["lib"],
    root_items: &[],
    rooms: "work+room mistakes precedence algebra syntax model structure formulas passes program describe refuse \
            derive assemble schedule plan lower translate emit editor fallback expand bug budget+text",
};

const LIVE: Package = Package {
    name: "kin-live",
    faces: &["lib"],
    root_items: &[],
    rooms: "memory budget names elementary sheet::registers sheet::instruction sheet code code::assembler run \
            routine forms motion every formulas mechanism functions batch",
};

const FIT: Package = Package {
    name: "kin-fit",
    faces: &["lib"],
    root_items: &[],
    rooms: "threads minimise error adjustable quantity functions margins term objective rows order design refine \
            measured job+table traced_four_bar",
};

const SKETCH: Package = Package {
    name: "kin-sketch",
    faces: &["lib"],
    root_items: &[],
    rooms: "sketch+json names local fault parts ways placement freedom quantities+vectors statements+declaration \
            kin_file foreign::error foreign::found foreign::draft foreign::pylinkage foreign::pmks foreign::pmks_plus \
            foreign::linkage foreign",
};

const STUDIO: Package = Package {
    name: "kin-studio",
    faces: &["lib", "bin"],
    root_items: &[],
    rooms: "names drawing tables file forces report::error+report::model report library figures \
            case::fault+case::text+case::units+case::value case::motion case::loads \
            case::typed+case::subject+case::assembly+case::columns+case::functions+case::oracles+case::page+case::file \
            case::language case::design+case::document case program::text program::progress+program::server \
            program::command+program::advice program::tasks program",
};

const WEB: Package = Package {
    name: "kin-web",
    faces: &["lib"],
    root_items: &[],
    rooms: "examples question border",
};

const SEARCH: Package = Package {
    name: "kin-search",
    faces: &["lib", "program"],
    root_items: &[],
    rooms: "say digest \
            function::arguments+function::assembly+function::names+function::settings+function::solver \
            function::pose candidates function session \
            cluster::address+cluster::identity+cluster::fault+cluster::options+cluster::progress+cluster::stop+\
            cluster::job+cluster::cores+cluster::assigned \
            cluster::ids+cluster::tables+cluster::codec+cluster::cut+cluster::parts cluster pages",
};

const PYTHON: Package = Package {
    name: "kin-python",
    faces: &["lib"],
    root_items: &[],
    rooms: "answers arguments arrays arrow made fault declared mechanism linkage motion pose choice batch code law \
            loads sweep table exact quantity proof cycle fit report library methods",
};

/// So many lines are not too much for a room of any package.
const SMALL: usize = 300;

/// Names of kin-core's root that have other declarations. kin-compiler calls so what it knows of the thing; the words
/// for editors are called like what they explain.
const OF_SEVERAL_TYPES: &str = "Block BlockForm Body ClosureTerm Description Dimension Formula Formulas Mechanism Name \
                                Outline Quantity Slide";

impl Package {
    fn sources(&self) -> Vec<Source> {
        sources(&root().join(self.name).join("src"))
    }

    fn rooms(&self) -> impl Iterator<Item = &'static str> {
        self.rooms.split(' ').filter(|room| !room.is_empty())
    }

    /// The room of a module: the one with the longest path to it.
    fn room_of(&self, module: &[String]) -> Option<usize> {
        let module = format!("{}::", module.join("::"));
        let paths = self
            .rooms()
            .enumerate()
            .flat_map(|(room, paths)| paths.split('+').map(move |path| (path, room)));
        let longest = paths
            .filter(|(path, _)| module.starts_with(&format!("{path}::")))
            .max_by_key(|(path, _)| path.len());
        longest.map(|(_, room)| room)
    }

    /// What does not agree with the list.
    fn faults(&self) -> Vec<String> {
        let mut faults = Vec::new();
        let mut lines = vec![0; self.rooms().count()];
        let mut all = 0;
        for source in self.sources() {
            all += source.lines;
            if source
                .module
                .first()
                .is_some_and(|first| self.faces.contains(&first.as_str()))
            {
                continue;
            }
            let Some(from) = self.room_of(&source.module) else {
                faults.push(format!("{} belongs to no room", source.file));
                continue;
            };
            lines[from] += source.lines;
            let mut paths = BTreeSet::new();
            add_paths(source.tokens, &source.module, &mut paths);
            for path in paths {
                let place = format!("{} names crate::{}", source.file, path.join("::"));
                match self.room_of(&path) {
                    Some(to) if to > from => faults.push(format!("{place}, which stands above it")),
                    Some(_) => {}
                    None if path.len() == 1 && self.root_items.contains(&path[0].as_str()) => {}
                    None => faults.push(format!("{place}, which is in no room")),
                }
            }
        }
        let is_divided = lines.len() > 1;
        for (room, lines) in self.rooms().zip(lines) {
            if lines == 0 || is_divided && lines > SMALL && 5 * lines > all {
                faults.push(format!("{}: {room} has {lines} of {all} lines", self.name));
            }
        }
        faults
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

#[test]
fn every_package_is_layered() {
    let faults: Vec<String> = [RUNTIME, CORE, COMPILER, LIVE, FIT, SKETCH, STUDIO, WEB, SEARCH, PYTHON]
        .iter()
        .flat_map(Package::faults)
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn paths_are_found_wherever_they_stand() {
    let found = |module: &str, code: &str| {
        let module: Vec<String> = module.split("::").map(str::to_owned).collect();
        let mut paths = BTreeSet::new();
        add_paths(code.parse().expect("the code is Rust"), &module, &mut paths);
        paths.iter().map(|path| path.join("::")).collect::<Vec<_>>()
    };
    let trees = "use crate::{a::{self, B, c::*}, d}; pub(crate) use super::{e, super::f};";
    assert_eq!(found("x::y::z", trees), ["a", "a::B", "a::c", "d", "x::f", "x::y::e"]);
    let code = "fn f(x: crate::a::B<crate::c::D>) -> u8 { g!(1, [super::h, super::super::i]); crate::j::k::<u8>() }";
    assert_eq!(found("x::y", code), ["a::B", "c::D", "i", "j::k", "x::h"]);
    assert_eq!(found("x", "macro_rules! m { () => { $crate::a::B }; }"), ["a::B"]);
    assert_eq!(
        found("x::y", "mod own { use super::a; use super::super::b; }"),
        ["x::b", "x::y::a"]
    );
}

/// The chapter on the architecture.
fn chapter() -> String {
    fs::read_to_string(root().join("docs/architecture.md")).expect("the chapter is there")
}

/// The book lists every room of the packages on which the others stand. Elsewhere the first line of a file is enough.
#[test]
fn the_book_lists_the_rooms_below() {
    let chapter = chapter();
    for module in [RUNTIME.rooms(), COMPILER.rooms()]
        .into_iter()
        .flatten()
        .flat_map(|room| room.split('+'))
        .filter_map(|module| module.split("::").next())
    {
        let is_described = [format!("`{module}/`"), format!("`{module}.rs`")]
            .iter()
            .any(|name| chapter.contains(name));
        assert!(is_described, "{module}");
    }
}

/// Each file that the book sends a newcomer to is there.
#[test]
fn the_book_knows_where_to_look() {
    let chapter = chapter();
    let paths = chapter
        .split('`')
        .filter(|word| word.starts_with("kin-") && Path::new(word).extension() == Some("rs".as_ref()));
    let files: Vec<&str> = paths.collect();
    assert!(files.len() > 10, "{files:?}");
    for file in files {
        assert!(root().join(file).is_file(), "{file}");
    }
}

/// A type that kin-core's root exports has its name for itself. Other types are told apart by their modules.
#[test]
fn one_name_means_one_thing() {
    let mut exported = BTreeSet::new();
    let mut declared: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for source in [RUNTIME, CORE, COMPILER].iter().flat_map(Package::sources) {
        let tokens: Vec<TokenTree> = source.tokens.into_iter().collect();
        let is_face = source.file.ends_with("kin-runtime/src/lib.rs");
        for statement in tokens.split(|token| is_mark(token, ';')).filter(|_| is_face) {
            let words = statement.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
            if let Some((_, names)) = words.split_once("pub use ") {
                let names = names.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
                exported.extend(
                    names
                        .filter(|name| name.starts_with(char::is_uppercase))
                        .map(str::to_owned),
                );
            }
        }
        let types = shared_types(&tokens);
        // They give exported names to types of the rooms, which are called alike.
        if source.file.ends_with("kin-runtime/src/declared.rs") {
            exported.extend(types);
            continue;
        }
        for name in types {
            declared.entry(name).or_default().push(source.file.clone());
        }
    }
    assert!(exported.len() > 50, "{exported:?}");
    let exported = declared.iter().filter(|(name, _)| exported.contains(*name));
    let twice: Vec<_> = exported.filter(|(_, files)| files.len() > 1).collect();
    let names: Vec<&str> = twice.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names.join(" "), OF_SEVERAL_TYPES, "{twice:?}");
}

/// The types and traits that other files may name.
fn shared_types(tokens: &[TokenTree]) -> Vec<String> {
    let word = |token: &TokenTree| match token {
        TokenTree::Ident(word) => word.to_string(),
        // what follows `pub` in `pub(crate)`
        TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis => "pub".to_owned(),
        _ => String::new(),
    };
    let words: Vec<String> = tokens.iter().map(word).collect();
    let types = words
        .windows(3)
        .filter(|words| words[0] == "pub" && KINDS.contains(&words[1].as_str()));
    types.map(|words| words[2].clone()).collect()
}

const KINDS: [&str; 4] = ["enum", "struct", "trait", "type"];

/// What `main` and `unwrap` print of an error is a sentence: its `Debug` is its `Display`.
#[test]
fn every_error_prints_its_sentence() {
    let inner = ["Found"];
    for (package, least) in [(RUNTIME, 18), (CORE, 0), (FIT, 4), (STUDIO, 2)] {
        let errors = errors(package.sources());
        assert!(errors.len() >= least, "{}: {:?}", package.name, errors.keys());
        for (name, (is_printed, file)) in errors {
            assert!(
                is_printed || inner.contains(&name.as_str()),
                "{file}: {name} prints its structure: call `__debug_by_display!({name})` instead of deriving `Debug`"
            );
        }
    }
}
