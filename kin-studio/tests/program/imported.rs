//! `kin import`.

use crate::typed::{Folder, typed_in};

const LEG: &str = include_str!("../../../kin-sketch/tests/foreign/pylinkage/jansen.json");
const PRESS: &str = include_str!("../../../kin-sketch/tests/foreign/pmks_plus/punch_press.txt");
const RADIAL: &str = include_str!("../../../kin-sketch/tests/foreign/pmks_plus/radial_engine.txt");
const ACTUATOR: &str = include_str!("../../../kin-sketch/tests/foreign/linkage/actuator.linkage2");
const PUMP: &str = "ground crank R 0 0\ncrank rod R 0 3\nrod piston R 4 0\nground piston P 4 0 0\n";

/// What is typed ends with code 0.
fn done(folder: &Folder, line: &str) -> String {
    let printed = typed_in(folder, line);
    assert!(printed.ends_with("-- code 0\n"), "{printed}");
    printed
}

#[test]
fn files_of_others_run_and_are_in_form() {
    let folder = Folder::new("import");
    for (name, text, says) in [
        ("leg.json", LEG, "pylinkage has no seconds"),
        ("press.txt", PRESS, "the forces were left out"),
        ("radial.txt", RADIAL, "masses and colours"),
        ("lift.linkage2", ACTUATOR, "the actuator moves out once"),
        ("pump.txt", PUMP, "the first joint is driven"),
    ] {
        folder.write(name, text);
        let printed = done(&folder, &format!("kin import {name} -o it.kin"));
        assert!(printed.contains(says), "{printed}");
        done(&folder, "kin fmt --check it.kin");
        done(&folder, "kin check it.kin");
        done(&folder, "kin sweep it.kin");
    }
}

#[test]
fn the_file_is_that_of_the_book() {
    let folder = Folder::new("import-pump");
    folder.write("pump.txt", PUMP);
    insta::assert_snapshot!("import of a pump", typed_in(&folder, "kin import pump.txt"));
}

#[test]
fn an_address_is_typed() {
    let folder = Folder::new("import-address");
    let address = format!("https://app.pmksplus.com/?{}", PRESS.trim());
    let printed = done(&folder, &format!("kin import '{address}'"));
    assert!(printed.contains("at 20rpm") && printed.contains("2cm"), "{printed}");
}

#[test]
fn mistakes_are_told_with_advice() {
    let folder = Folder::new("import-mistakes");
    for (text, says) in [
        (
            PUMP.replace("ground piston P 4 0 0\n", ""),
            "pump.txt: the drawing moves in 3 ways and has one drive",
        ),
        (
            PUMP.replace("R 0 3", "R 0 x"),
            "pump.txt: line 2 has `x`, which is no finite number",
        ),
        ("kin 1".to_owned(), "pump.txt: the format is not known: kin reads"),
    ] {
        folder.write("pump.txt", &text);
        let printed = typed_in(&folder, "kin import pump.txt");
        assert!(printed.contains(says) && printed.ends_with("-- code 2\n"), "{printed}");
    }
    let printed = typed_in(&folder, "kin import lost.json");
    assert!(
        printed.contains("lost.json") && printed.ends_with("-- code 2\n"),
        "{printed}"
    );
}
