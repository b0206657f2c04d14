//! Mistakes in files, and files that are spoilt.

use kin_core::verify::Random;
use kin_sketch::foreign::{ForeignError, read};

use super::{File, all_files};

fn text(name: &str) -> String {
    let mut files = all_files().into_iter();
    files.find(|file: &File| file.name == name).expect("it is a file").text
}

fn fault(text: &str) -> ForeignError {
    match read(text) {
        Ok(foreign) => panic!("{text}\nis read: {foreign:?}"),
        Err(error) => error,
    }
}

#[test]
fn mistakes_in_json_are_told() {
    let four_bar = text("four_bar_crossed");
    let replaced = |from: &str, to: &str| {
        assert!(four_bar.contains(from), "{from}");
        fault(&four_bar.replace(from, to))
    };
    assert!(matches!(
        fault(&four_bar[..200]),
        ForeignError::Syntax { line: 10..=20, .. }
    ));
    assert!(matches!(
        replaced("\"revolute\"", "\"Revolute\""),
        ForeignError::Version(_)
    ));
    assert!(matches!(
        replaced("\"revolute\"", "\"gear\""),
        ForeignError::Unsupported { .. }
    ));
    assert!(matches!(
        replaced("\"joints\"", "\"points\""),
        ForeignError::Entry { .. }
    ));
    assert!(matches!(
        replaced("\"position\"", "\"place\""),
        ForeignError::Entry { .. }
    ));
    assert!(matches!(
        replaced("\"motor_joint\": \"", "\"motor_joint\": \"x"),
        ForeignError::Missing { .. }
    ));
    assert!(matches!(
        replaced("\"position\": [", "\"position\": [\"NaN\", 1.0], \"old\": ["),
        ForeignError::Number { .. }
    ));
    assert!(matches!(
        replaced("\"id\": \"", "\"id\": \"\", \"was\": \""),
        ForeignError::Entry { .. }
    ));
    // Python writes it, and JSON has no such number
    assert!(matches!(replaced("6.0", "NaN"), ForeignError::Syntax { .. }));
    assert!(matches!(replaced("6.0", "1e999"), ForeignError::Syntax { .. }));
    assert!(matches!(
        fault("{\"nodes\": [], \"edges\": []}"),
        ForeignError::Version(_)
    ));
    assert!(matches!(fault("[1, 2]"), ForeignError::Entry { .. }));
    assert!(matches!(fault(&"[".repeat(100_000)), ForeignError::Syntax { .. }));
    assert!(matches!(fault(&" {".repeat(1_000_000)), ForeignError::TooLarge(_)));
    let joints: Vec<String> = (0..500)
        .map(|id| format!("{{\"id\": \"{id}\", \"position\": [{id}, 0]}}"))
        .collect();
    let many = format!("{{\"joints\": [{}], \"links\": []}}", joints.join(","));
    assert!(matches!(fault(&many), ForeignError::TooLarge(_)));
    let message = replaced("\"revolute\"", "\"gear\"").to_string();
    assert!(
        message.contains("of the type `gear`") && message.contains("use ground, revolute"),
        "{message}"
    );
}

#[test]
fn mistakes_in_addresses_are_told() {
    let address = text("four_bar");
    let whitworth = text("whitworth");
    let whitworth = whitworth.trim();
    // the count follows the length, so a mistake of the same length passes it
    let replaced = |from: &str, to: &str| fault(&whitworth.replacen(from, to, 1));
    assert!(matches!(
        fault("https://app.pmksplus.com/"),
        ForeignError::Syntax { .. }
    ));
    assert!(matches!(
        fault(&whitworth[..whitworth.len() - 9]),
        ForeignError::Syntax { .. }
    ));
    assert!(matches!(
        fault("https://pmksplus.com/?j=A,0,0&l=AB"),
        ForeignError::Version(_)
    ));
    assert!(matches!(
        replaced(",CD,C,D..", ",CX,C,D.."),
        ForeignError::Missing { .. }
    ));
    assert!(matches!(replaced("A,B,,.", "A,X,,."), ForeignError::Missing { .. }));
    assert!(matches!(replaced("095", "0!5"), ForeignError::Number { .. }));
    assert!(matches!(replaced("GB,B", "GA,B"), ForeignError::Twice(_)));
    assert!(read(&address).is_ok());
}

#[test]
fn mistakes_in_tables_are_told() {
    let quick_return = text("quick_return");
    let replaced = |from: &str, to: &str| fault(&quick_return.replacen(from, to, 1));
    assert!(matches!(replaced("R,0,0", "G,0,0"), ForeignError::Unsupported { .. }));
    assert!(matches!(replaced("R,0,0", "R,0,NaN"), ForeignError::Number { .. }));
    assert!(matches!(replaced("R,0,0", "R,0"), ForeignError::Entry { .. }));
    assert!(matches!(replaced("R,0,0", "weld"), ForeignError::Entry { .. }));
    assert!(matches!(
        replaced("ground,block,P", "block,block,P"),
        ForeignError::Twice(_)
    ));
    assert!(matches!(
        replaced("ground,block,P", "ground,P"),
        ForeignError::Entry { .. }
    ));
    let message = replaced("R,0,0", "G,0,0").to_string();
    assert!(
        message.starts_with("the gear of line 1 has no counterpart"),
        "{message}"
    );
    assert_eq!(fault("struct FourBar { r1: Length }"), ForeignError::Unknown);
    assert_eq!(fault(""), ForeignError::Unknown);
}

#[test]
fn mistakes_in_xml_are_told() {
    let slotted = text("slotted_lever");
    let replaced = |from: &str, to: &str| {
        assert!(slotted.contains(from), "{from}");
        fault(&slotted.replace(from, to))
    };
    assert!(matches!(fault(&slotted[..300]), ForeignError::Syntax { .. }));
    assert!(matches!(replaced("linkage2", "linkage"), ForeignError::Version(_)));
    assert!(matches!(
        replaced("<slidelimit id=\"2\"/>", "<slidelimit id=\"7\"/>"),
        ForeignError::Missing { .. }
    ));
    assert!(matches!(
        replaced("x=\"45.000000\"", "x=\"nan\""),
        ForeignError::Number { .. }
    ));
    assert!(matches!(
        replaced(" id=\"3\" selected", " selected"),
        ForeignError::Entry { .. }
    ));
    assert!(matches!(
        replaced("id=\"3\" selected", "id=\"2\" selected"),
        ForeignError::Twice(_)
    ));
    let curved = replaced("slider=\"true\"", "slider=\"true\" slideradius=\"40\"");
    assert!(curved.to_string().contains("slides along an arc"), "{curved}");
    let ratios = "<ratios><ratio type=\"gears\"/></ratios></linkage2>";
    assert!(matches!(
        replaced("</linkage2>", ratios),
        ForeignError::Unsupported { .. }
    ));
    // entities that grow, and more nodes than a mechanism has
    let bomb = "<!DOCTYPE x [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;\">]><linkage2>&b;</linkage2>";
    assert!(matches!(fault(bomb), ForeignError::Syntax { .. }));
    let many = format!("<linkage2>{}</linkage2>", "<a/>".repeat(30_000));
    assert!(matches!(fault(&many), ForeignError::Syntax { .. }));
}

/// Whatever a file holds, it is read, or there is an error, and what is read can be asked for its declaration.
#[test]
fn spoilt_files_are_errors() {
    let mut random = Random::new(11);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "it is below the end"
    )]
    let mut below = |end: usize| random.between(0.0, end as f64) as usize;
    let parts = [
        "\"", "<", "{", "}", ",", ".", "0", "-", "1e308", "NaN", "true", "null", "θ", "%", "%2", "%ff", "\u{feff}",
        "\n", "ground", "P", " ", "?", "[[",
    ];
    let files = all_files();
    let mut kinds = [0; 3];
    for round in 0..4000 {
        let mut text: Vec<char> = files[round % files.len()].text.chars().collect();
        for _ in 0..=below(3) {
            let place = below(text.len());
            match below(3) {
                0 => drop(text.drain(place..(place + below(9)).min(text.len()))),
                1 => text.truncate(place.max(1)),
                _ => drop(text.splice(place..place, parts[below(parts.len())].chars())),
            }
            if text.is_empty() {
                break;
            }
        }
        let text: String = text.into_iter().collect();
        let kind = match read(&text) {
            Err(error) => {
                assert!(!error.to_string().is_empty());
                0
            }
            Ok(foreign) => match foreign.sketch.declaration() {
                Err(faults) => {
                    assert!(!faults.is_empty());
                    1
                }
                Ok(declaration) => {
                    assert!(declaration.kin_file("", "mm", &foreign.motions).starts_with("kin 1\n"));
                    2
                }
            },
        };
        kinds[kind] += 1;
    }
    assert!(kinds.iter().all(|count| *count > 50), "{kinds:?}");
}
