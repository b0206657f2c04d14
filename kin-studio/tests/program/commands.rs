//! Every command, with what it prints.

use insta::assert_snapshot;
use serde_json::Value;

use crate::typed::{Folder, typed, typed_in};

#[test]
fn help() {
    assert_snapshot!("help", typed("help", "kin --help"));
    assert_snapshot!("help of sweep", typed("help-sweep", "kin sweep --help"));
    assert_snapshot!("help of run", typed("help-run", "kin run --help"));
    // every command has examples
    for command in [
        "list",
        "show",
        "sweep",
        "cycle",
        "peaks",
        "verify",
        "code",
        "fit",
        "table",
        "report",
        "serve",
        "run",
        "cache",
        "completions",
    ] {
        let help = typed("help-all", &format!("kin {command} --help"));
        assert!(help.contains(&format!("  kin {command}")), "{help}");
        assert!(help.contains("Example"), "{help}");
    }
}

#[test]
fn list_and_show() {
    assert_snapshot!("list", typed("list", "kin list"));
    assert_snapshot!("show", typed("show", "kin show slider_crank"));
}

#[test]
fn sweep() {
    assert_snapshot!("sweep", typed("sweep", "kin sweep four_bar --speed 60rpm"));
    assert_snapshot!(
        "sweep with a limit",
        typed(
            "limit",
            "kin sweep FourBar --set r1=90mm --set r2=30 --set r3=6cm --set r4=45 --rows 5 --over 0..180deg"
        )
    );
    assert_snapshot!(
        "sweep under a law",
        typed(
            "law",
            "kin sweep slider-crank --over 0..90deg --law modified_sine --time 400ms --rows 5 --columns s,s_jerk --radians"
        )
    );
    assert_snapshot!(
        "sweep of two inputs",
        typed(
            "two",
            "kin sweep five_bar --over 'alpha=100..120deg' --set beta=50deg --rows 3 --columns hand.x,hand.y"
        )
    );
    assert_snapshot!(
        "sweep of a coupled mechanism",
        typed("coupled", "kin sweep stephenson_ii --over 50..80deg --rows 4")
    );
}

/// CSV and JSON hold all columns, and the file is what the output would be.
#[test]
fn sweeps_go_to_files() {
    let folder = Folder::new("files-of-sweeps");
    let csv = typed_in(&folder, "kin sweep four_bar --rows 3 --csv");
    assert_snapshot!("sweep as csv", csv);
    let told = typed_in(&folder, "kin sweep four_bar --csv turn.csv");
    assert!(told.contains("turn.csv: ") && told.ends_with("code 0\n"), "{told}");
    let lines = std::fs::read_to_string(folder.path().join("turn.csv"))
        .unwrap()
        .lines()
        .count();
    assert_eq!(lines, 1 + 361);
    typed_in(&folder, "kin sweep four_bar --rows 7 --json turn.json");
    let json: Value = serde_json::from_slice(&std::fs::read(folder.path().join("turn.json")).unwrap()).unwrap();
    assert_eq!(json["outcome"].as_array().unwrap().len(), 7);
}

#[test]
fn cycle() {
    assert_snapshot!("cycle", typed("cycle", "kin cycle four_bar"));
    assert_snapshot!(
        "cycle with limits",
        typed("cycle-limits", "kin cycle four_bar --set r3=60 --set r4=45")
    );
}

#[test]
fn peaks() {
    assert_snapshot!(
        "peaks",
        typed("peaks", "kin peaks four_bar --speed 1500rpm --of theta4,theta3_jerk")
    );
    assert_snapshot!(
        "peaks with limits",
        typed(
            "peaks-limits",
            "kin peaks four_bar --set r3=60 --set r4=45 --over -150..150deg --of theta4_velocity,theta4"
        )
    );
}

#[test]
fn verify() {
    let told = typed("verify", "kin verify four_bar");
    assert!(told.contains("FourBar: passed, 200 poses"), "{told}");
    assert!(told.ends_with("code 0\n"), "{told}");
}

#[test]
fn code() {
    let folder = Folder::new("code");
    assert_snapshot!(
        "code in C",
        typed_in(&folder, "kin code slider_crank c -o firmware --order 2")
    );
    for (language, file) in [("js", "scotch_yoke.mjs"), ("python", "scotch_yoke.py")] {
        let told = typed_in(&folder, &format!("kin code scotch_yoke {language}"));
        assert!(told.contains(file) && folder.path().join(file).is_file(), "{told}");
    }
}

/// The dimensions with which the numbers were made are found again.
#[test]
fn fit() {
    let folder = Folder::new("fit");
    typed_in(
        &folder,
        "kin sweep four_bar --set r3=82 --set r4=57 --rows 13 --csv wanted.csv",
    );
    let found = typed_in(
        &folder,
        "kin fit four_bar --data wanted.csv --vary r3,r4 --within r3=40..100",
    );
    // the last digits depend on the steps of the search
    for line in [
        "r3             40     80     82      100",
        "r4             15     60     57      240",
    ] {
        assert!(found.contains(line), "{found}");
    }
    // points of a path without the inputs that lead to them
    typed_in(
        &folder,
        "kin sweep hoeken_linkage --rows 13 --set crank=1.1 --csv all.csv",
    );
    let all = std::fs::read_to_string(folder.path().join("all.csv")).unwrap();
    let head: Vec<&str> = all.lines().next().unwrap().split(',').collect();
    let places: Vec<usize> = head
        .iter()
        .enumerate()
        .filter(|(_, name)| name.ends_with(".x [L]") || name.ends_with(".y [L]"))
        .map(|(place, _)| place)
        .collect();
    assert_eq!(places.len(), 2, "{head:?}");
    let points = all.lines().map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        format!("{},{}\n", cells[places[0]], cells[places[1]])
    });
    folder.write("path.csv", &points.collect::<String>());
    let found = typed_in(&folder, "kin fit hoeken_linkage --data path.csv");
    // the first and the last point lie at the bounds of the input, towards which the search makes short steps: a part of 4000 is left
    let number = |before: &str| -> f64 {
        let behind = found
            .split(before)
            .nth(1)
            .and_then(|rest| rest.split_whitespace().next());
        behind
            .and_then(|text| text.parse().ok())
            .unwrap_or_else(|| panic!("{found}"))
    };
    let (start, end) = (number("at the start by "), number("deviates by "));
    assert!(end < start / 1000.0, "{found}");
}

#[test]
fn table() {
    let folder = Folder::new("table");
    assert_snapshot!("table", typed_in(&folder, "kin table four_bar --tolerance 1e-6"));
    let bytes = std::fs::read(folder.path().join("four_bar.kin-table")).unwrap();
    let table = kin_core::exact::ExactTable::from_bytes(bytes).unwrap();
    assert_eq!(table.order(), 4);
    typed_in(&folder, "kin table four_bar --tolerance 1e-6 --form json");
    let json: Value = serde_json::from_slice(&std::fs::read(folder.path().join("four_bar.json")).unwrap()).unwrap();
    assert_eq!(json["rows"].as_array().unwrap().len(), table.rows());
}

#[test]
fn report() {
    let folder = Folder::new("report");
    let told = typed_in(&folder, "kin report scotch_yoke --speed 60rpm --title Yoke");
    assert!(told.contains("scotch_yoke.html: "), "{told}");
    let page = std::fs::read_to_string(folder.path().join("scotch_yoke.html")).unwrap();
    assert!(page.starts_with("<!doctype html>") && page.contains("Yoke"));
}

#[test]
fn completions() {
    let bash = typed("completions", "kin completions bash");
    assert!(
        bash.contains("_kin()") && bash.contains("--over"),
        "no completions for bash"
    );
    for shell in ["zsh", "fish", "elvish", "powershell"] {
        let script = typed("completions-all", &format!("kin completions {shell}"));
        assert!(
            script.contains("sweep") && script.ends_with("code 0\n"),
            "no completions for {shell}"
        );
    }
}

/// As with `kin sweep four_bar --csv | head`.
#[test]
fn a_closed_pipe_is_no_mistake() {
    use std::process::Stdio;
    let folder = Folder::new("pipe");
    let mut child = crate::typed::kin(&folder)
        .args(["sweep", "four_bar", "--csv", "--rows", "20000"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
    assert!(output.status.success());
}
