//! The rooms of both crates, and the order in which they import each other.
//!
//! A room is a part of a crate with one task. It imports only from the rooms below it, which stand before it in the lists here.

mod drawing;
mod errors;
mod imports;
mod rooms;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use errors::errors;
use imports::{Source, Target, sources, targets};
use rooms::{CORE, House, MACROS, OF_BOTH_CRATES, SEVERAL_TIMES};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The room of a file, by its place in the list; the faults of the list are added to `faults`.
fn room_of(house: &House, file: &str, faults: &mut Vec<String>) -> Option<usize> {
    let owners: Vec<usize> = (0..house.rooms.len())
        .filter(|&room| house.rooms[room].owns(file))
        .collect();
    let is_face = house.faces.contains(&file);
    match owners.as_slice() {
        [] if is_face => None,
        [own] if !is_face => Some(*own),
        [] => {
            faults.push(format!("{file} belongs to no room"));
            None
        }
        _ => {
            faults.push(format!("{file} belongs to several rooms"));
            None
        }
    }
}

/// Which rooms import which, with the places at which they do.
type Arrows = BTreeMap<(usize, usize), BTreeSet<String>>;

fn arrows(house: &House, sources: &[Source], faults: &mut Vec<String>) -> Arrows {
    let rooms: BTreeMap<&str, Option<usize>> = sources
        .iter()
        .map(|source| (source.file.as_str(), room_of(house, &source.file, faults)))
        .collect();
    let mut arrows = Arrows::new();
    for (file, targets) in targets(sources) {
        let Some(from) = rooms[file] else { continue };
        for (target, path) in targets {
            let place = format!("{file} names crate::{path}");
            match target {
                Target::Root if house.root_items.contains(&path.as_str()) => {}
                Target::Root => faults.push(format!("{place} through the root, and not by its room")),
                Target::File(other) => match rooms[other] {
                    Some(to) if to == from => {}
                    Some(to) => {
                        arrows.entry((from, to)).or_default().insert(place);
                    }
                    None if house.faces.contains(&other) => {
                        faults.push(format!("{place}, which is a face of the crate and no room"));
                    }
                    None => {}
                },
            }
        }
    }
    arrows
}

/// The lists of a house hold: every file is in one room, no arrow runs up, and no room is too large.
fn assert_in_order(house: &House) -> Arrows {
    let sources = sources(&root().join(house.source));
    let mut faults = Vec::new();
    let mut arrows = arrows(house, &sources, &mut faults);

    let index = |name: &str| {
        let found = house.rooms.iter().position(|room| room.name == name);
        found.unwrap_or_else(|| panic!("there is no room {name}"))
    };
    for (from, to) in house.known {
        if arrows.remove(&(index(from), index(to))).is_none() {
            faults.push(format!(
                "{from} imports {to} no more: take it off the list of known faults"
            ));
        }
    }
    for ((from, to), places) in &arrows {
        if to > from {
            let places: Vec<&str> = places.iter().map(String::as_str).collect();
            faults.push(format!(
                "{} imports {}, which stands above it:\n    {}",
                house.rooms[*from].name,
                house.rooms[*to].name,
                places.join("\n    ")
            ));
        }
    }

    let mut lines = vec![0; house.rooms.len()];
    for source in &sources {
        if let Some(own) = room_of(house, &source.file, &mut Vec::new()) {
            lines[own] += source.lines;
        }
    }
    let all: usize = lines.iter().sum();
    let mut table = String::new();
    for (room, lines) in house.rooms.iter().zip(&lines) {
        let _ = writeln!(table, "{:>6} {:4.1} % {}", lines, 100.0 * share(*lines, all), room.name);
        if 5 * lines > all && !house.large.contains(&room.name) {
            faults.push(format!("{} has {lines} of {all} lines, more than a fifth", room.name));
        }
        // Longer words would leave the box.
        if room.holds.len() > 22 {
            faults.push(format!("\"{}\" is too long for the picture", room.holds));
        }
        if *lines == 0 {
            faults.push(format!("{} is empty", room.name));
        }
    }
    println!("{}: {all} lines\n{table}", house.name);
    assert!(faults.is_empty(), "{}:\n{}", house.name, faults.join("\n"));
    arrows
}

fn share(part: usize, all: usize) -> f64 {
    f64::from(u32::try_from(part).unwrap_or(u32::MAX)) / f64::from(u32::try_from(all).unwrap_or(u32::MAX))
}

/// The picture in the book is that of the code. With `KIN_DRAW` in the environment it is drawn anew.
fn assert_drawn(house: &House, arrows: &Arrows) {
    let drawn = drawing::draw(house.rooms, &arrows.keys().copied().collect::<Vec<_>>());
    let path = root().join("docs/figures").join(format!("rooms-{}.svg", house.name));
    if std::env::var_os("KIN_DRAW").is_some() {
        fs::write(&path, &drawn).expect("the picture can be written");
    }
    let there = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        drawn == there,
        "{} is not that of the code: draw it by `KIN_DRAW=1 cargo test -p kin-tests --test house`",
        path.display()
    );
}

#[test]
fn kin_core_is_layered() {
    let arrows = assert_in_order(&CORE);
    assert_drawn(&CORE, &arrows);
}

#[test]
fn kin_macros_is_layered() {
    let arrows = assert_in_order(&MACROS);
    assert_drawn(&MACROS, &arrows);
}

/// The lines between a heading of the chapter on the architecture and the next one.
fn section(heading: &str) -> String {
    let text = fs::read_to_string(root().join("docs/architecture.md")).expect("the chapter is there");
    let (_, after) = text
        .split_once(&format!("\n## {heading}\n"))
        .unwrap_or_else(|| panic!("there is no heading {heading}"));
    after.split("\n## ").next().unwrap_or_default().to_owned()
}

/// The cells of a table's rows that hold a path, without its marks.
fn paths_of_column(section: &str, column: usize) -> Vec<String> {
    section
        .lines()
        .filter(|line| line.starts_with("| "))
        .filter_map(|line| line.split('|').nth(column + 1))
        .flat_map(|cell| cell.split(','))
        .filter_map(|name| name.trim().strip_prefix('`')?.strip_suffix('`'))
        .map(str::to_owned)
        .collect()
}

/// The book has a line for each room, and for no other: a list that is kept twice would soon be two lists.
#[test]
fn the_book_describes_every_room() {
    for house in [&CORE, &MACROS] {
        let mut described = paths_of_column(&section(house.name), 0);
        let mut expected: Vec<String> = house
            .rooms
            .iter()
            .flat_map(|room| room.files)
            .map(|file| (*file).to_owned())
            .collect();
        described.sort_unstable();
        expected.sort_unstable();
        assert_eq!(described, expected, "{}", house.name);
    }
}

/// Each file that the book sends a newcomer to is there.
#[test]
fn the_book_knows_where_to_look() {
    let files = paths_of_column(&section("Where to look"), 1);
    assert!(files.len() > 10, "{files:?}");
    for file in files {
        assert!(root().join(&file).is_file(), "{file}");
    }
}

/// One name means one thing, across both crates: a type that several files may name has its name for itself. Types that
/// only their file can name may be called alike, as `Reach` is in each closed form.
#[test]
fn one_name_means_one_thing() {
    let mut places: BTreeMap<String, Vec<(&str, String, bool)>> = BTreeMap::new();
    for house in [&CORE, &MACROS] {
        for source in sources(&root().join(house.source)) {
            for own in source.types {
                let place = (house.name, format!("{}/{}", house.source, source.file), own.is_shared);
                places.entry(own.name).or_default().push(place);
            }
        }
    }
    let mut faults = Vec::new();
    let mut is_needed: BTreeSet<&str> = BTreeSet::new();
    for (name, places) in &places {
        let of_crate = |name| places.iter().filter(|(house, ..)| *house == name).count();
        let own = [CORE.name, MACROS.name].map(of_crate);
        if places.len() == 1 || places.iter().all(|(_, _, is_shared)| !is_shared) {
            continue;
        }
        let is_of_both = OF_BOTH_CRATES.contains(&name.as_str()) && own == [1, 1];
        let is_several = SEVERAL_TIMES.contains(&name.as_str());
        if is_of_both || is_several {
            is_needed.insert(name);
        } else {
            let files: Vec<&str> = places.iter().map(|(_, file, _)| file.as_str()).collect();
            faults.push(format!("{name} is declared in {}", files.join(", ")));
        }
    }
    for name in OF_BOTH_CRATES.iter().chain(SEVERAL_TIMES) {
        if !is_needed.contains(name) {
            faults.push(format!("{name} has one declaration: take it off the list"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// What `main` and `unwrap` print of an error is a sentence: its `Debug` is its `Display`.
#[test]
fn every_error_prints_its_sentence() {
    let inner = ["Found"];
    for (source, least) in [(CORE.source, 18), ("kin-studio/src", 2)] {
        let errors = errors(&root().join(source));
        assert!(errors.len() >= least, "{source}: {:?}", errors.keys());
        for (name, (is_printed, file)) in errors {
            assert!(
                is_printed || inner.contains(&name.as_str()),
                "{source}/{file}: {name} prints its structure: call `__debug_by_display!({name})` instead of deriving `Debug`"
            );
        }
    }
}
