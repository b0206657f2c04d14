//! The output of every command.

use insta::assert_snapshot;
use kin_core::exact::ExactTable;
use kin_studio::tables::ExactJson as _;
use serde_json::Value;

use crate::typed::{Folder, typed, typed_in};

#[test]
fn help() {
    assert_snapshot!("help", typed("help", "kin --help"));
    assert_snapshot!("help of sweep", typed("help-sweep", "kin sweep --help"));
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
        "import",
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
    let shown = ["slider_crank", "rssr"].map(|name| typed("show", &format!("kin show {name}")));
    assert_snapshot!("show", shown.join("\n"));
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
            "kin sweep slider-crank --over 0..90deg --law modified_sine --time 400ms --rows 5 --columns s,s_jerk \
             --radians"
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
        "sweep at two speeds",
        typed(
            "speeds",
            "kin sweep five_bar --over 'alpha=100..120deg at 60rpm' --over 'beta=50..60deg at 60rpm' --rows 5 \
             --columns hand,alpha_velocity,beta_velocity"
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
    let printed = typed_in(&folder, "kin sweep four_bar --csv turn.csv");
    assert!(
        printed.contains("turn.csv: ") && printed.ends_with("code 0\n"),
        "{printed}"
    );
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
    // a length has no usual range, and a cycle needs none
    let printed = typed("cycle-length", "kin cycle pantograph");
    assert!(
        printed.contains("Pantograph over x: 2 circuits, 4 branches"),
        "{printed}"
    );
    let printed = typed("cycle-standing", "kin cycle pantograph --set x=3");
    assert!(printed.contains("Pantograph over y: "), "{printed}");
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
    let printed = typed("verify", "kin verify four_bar");
    assert!(printed.contains("FourBar: passed, 200 poses"), "{printed}");
    assert!(printed.ends_with("code 0\n"), "{printed}");
}

#[test]
fn code() {
    let folder = Folder::new("code");
    assert_snapshot!(
        "code in C",
        typed_in(&folder, "kin code slider_crank c -o firmware --order 2")
    );
    for (language, file) in [("js", "scotch_yoke.mjs"), ("python", "scotch_yoke.py")] {
        let printed = typed_in(&folder, &format!("kin code scotch_yoke {language}"));
        assert!(
            printed.contains(file) && folder.path().join(file).is_file(),
            "{printed}"
        );
    }
}

/// An example of kin is written again, and nobody else's program is lost.
#[test]
fn the_example_in_c_spares_other_files() {
    let folder = Folder::new("code-spares");
    for mechanism in ["four_bar", "slider_crank"] {
        let printed = typed_in(&folder, &format!("kin code {mechanism} c"));
        assert!(printed.ends_with("code 0\n"), "{printed}");
    }
    let program = "int main(void) { return 0; }\n";
    let path = folder.write("main.c", program);
    let printed = typed_in(&folder, "kin code scotch_yoke c");
    assert!(
        printed.contains("main.c is there already") && printed.contains("`--output FOLDER`"),
        "{printed}"
    );
    assert!(printed.ends_with("code 2\n"), "{printed}");
    assert_eq!(std::fs::read_to_string(path).unwrap(), program);
    assert!(!folder.path().join("scotch_yoke.c").exists());
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
}

/// The columns of the tracer alone: points of a path without the inputs that lead to them.
fn hoeken_path(folder: &Folder, options: &str) {
    typed_in(folder, &format!("kin sweep hoeken_linkage {options} --csv all.csv"));
    let all = std::fs::read_to_string(folder.path().join("all.csv")).unwrap();
    let head: Vec<&str> = all.lines().next().unwrap().split(',').collect();
    let indices: Vec<usize> = head
        .iter()
        .enumerate()
        .filter(|(_, name)| name.ends_with(".x [L]") || name.ends_with(".y [L]"))
        .map(|(index, _)| index)
        .collect();
    assert_eq!(indices.len(), 2, "{head:?}");
    let points = all.lines().map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        format!("{},{}\n", cells[indices[0]], cells[indices[1]])
    });
    folder.write("path.csv", &points.collect::<String>());
}

/// Points beside the seam of a revolution, a search that starts exactly at the seam, and a dimension that starts at its
/// bound: none of them holds the other numbers back.
#[test]
fn fit_of_a_path() {
    let folder = Folder::new("fit-path");
    let small = "--set crank=0.95 --set ground=2.1 --set coupler=2.4";
    for (over, right, options) in [
        ("0..360deg", "--set crank=1.1", ""),
        ("-1..332deg", small, ""),
        ("1..334deg", small, ""),
        ("1..334deg", small, "--within crank=0.9..1"),
        ("1..334deg", "--set crank=1.05", "--within crank=1..1.2"),
        ("20..160deg", small, "--over 20..160deg"),
    ] {
        hoeken_path(&folder, &format!("--rows 10 --over {over} {right}"));
        let printed = typed_in(&folder, &format!("kin fit hoeken_linkage --data path.csv {options}"));
        let deviations = printed.lines().filter_map(|line| line.split_once("deviates by "));
        let deviations: Vec<f64> = deviations
            .filter_map(|(_, behind)| behind.split_whitespace().next()?.parse().ok())
            .collect();
        assert!(
            deviations.len() == 2
                && deviations.iter().all(|deviation| *deviation < 1e-6)
                && printed.ends_with("code 0\n"),
            "{printed}"
        );
    }
}

/// A row that does not close is left out of the deviations, and does not stop the search.
#[test]
fn fit_with_a_row_that_does_not_close() {
    let folder = Folder::new("fit-open");
    folder.write("wanted.csv", "theta2 [deg],theta4 [deg]\n65,110\n170,150\n");
    let printed = typed_in(
        &folder,
        "kin fit four_bar --set r3=60 --set r4=45 --data wanted.csv --vary r4 --within r4=40..50",
    );
    assert!(printed.contains("in the mean of 1 row; at the start by "), "{printed}");
    assert!(
        printed.contains("does not close in 1 of 2 rows") && printed.ends_with("code 1\n"),
        "{printed}"
    );
    let printed = typed_in(&folder, "kin fit four_bar --set r1=900 --data wanted.csv --vary r4");
    assert!(printed.contains("closes in no row"), "{printed}");
}

/// A comma between quotation marks ends no cell.
#[test]
fn fit_with_quoted_cells() {
    let folder = Folder::new("fit-quoted");
    folder.write("plain.csv", "theta2 [deg],theta4 [deg]\n65,110\n170,150\n");
    let quoted =
        "\"outcome\",\"theta2 [deg]\",\"theta4 [deg]\"\n\"typed, then \"\"checked\"\"\",65,110\n\ntyped,170,150\n";
    folder.write("quoted.csv", quoted);
    let [plain, quoted] = ["plain", "quoted"].map(|name| {
        let line = "kin fit four_bar --set r3=60 --set r4=45 --vary r4 --within r4=40..50";
        typed_in(&folder, &format!("{line} --data {name}.csv"))
    });
    assert!(plain.contains("does not close in 1 of 2 rows"), "{plain}");
    assert_eq!(
        plain.split_once('\n').map(|(_, printed)| printed),
        quoted.split_once('\n').map(|(_, printed)| printed)
    );
}

/// Where the data have every input, the range of a length is not asked for.
#[test]
fn fit_without_a_range() {
    let folder = Folder::new("fit-range");
    typed_in(
        &folder,
        "kin sweep pantograph --over x=2.5..3.5 --set y=-1.5 --rows 5 --csv wanted.csv",
    );
    let printed = typed_in(
        &folder,
        "kin fit pantograph --data wanted.csv --vary factor --set factor=1.9",
    );
    assert!(
        printed.contains("--set factor=") && printed.ends_with("code 0\n"),
        "{printed}"
    );
}

/// The values of an assembly are those where the motion begins. Each row is reached from there, and not from the
/// position that is nearest to them at its own input.
#[test]
fn fit_follows_the_assembly() {
    let folder = Folder::new("fit-assembly");
    let options =
        "--over -170..130deg --assembly theta3=-28.8338deg,theta4=80.8715deg,theta5=52.2995deg,theta6=176.485deg";
    typed_in(
        &folder,
        &format!("kin sweep stephenson_ii {options} --rows 7 --csv wanted.csv"),
    );
    let printed = typed_in(
        &folder,
        &format!("kin fit stephenson_ii {options} --data wanted.csv --vary r5"),
    );
    assert!(
        printed
            .contains("theta6: deviates by 0 deg in the mean of 7 rows; at the start by 0 deg in the mean of 7 rows"),
        "{printed}"
    );
}

#[test]
fn table() {
    let folder = Folder::new("table");
    assert_snapshot!("table", typed_in(&folder, "kin table four_bar --tolerance 1e-6"));
    let bytes = std::fs::read(folder.path().join("four_bar.kin-table")).unwrap();
    let table = ExactTable::from_bytes(bytes).unwrap();
    assert_eq!(table.order(), 4);
    typed_in(&folder, "kin table four_bar --tolerance 1e-6 --form json");
    let json = std::fs::read_to_string(folder.path().join("four_bar.json")).unwrap();
    assert_eq!(ExactTable::from_json(&json), Ok(table));
}

/// A mechanism that does not close and a mistake in the arguments have different codes.
#[test]
fn tables_that_cannot_be_made_have_codes() {
    for (options, code) in [
        ("--tolerance 0", 2),
        ("--tolerance=-1e-6", 2),
        ("--tolerance 1e-15", 2),
        ("--order 0", 2),
        ("--order 5", 2),
        ("--set r1=900", 1),
        ("--set r3=60 --set r4=45 --over 0..180deg", 1),
    ] {
        let printed = typed("table-codes", &format!("kin table four_bar {options}"));
        assert!(printed.ends_with(&format!("code {code}\n")), "{printed}");
    }
}

#[test]
fn report() {
    let folder = Folder::new("report");
    let printed = typed_in(&folder, "kin report scotch_yoke --speed 60rpm --title Yoke");
    assert!(printed.contains("scotch_yoke.html: "), "{printed}");
    let page = std::fs::read_to_string(folder.path().join("scotch_yoke.html")).unwrap();
    assert!(page.starts_with("<!doctype html>") && page.contains("Yoke"));
}

/// A page takes the motions that a table takes.
#[test]
fn report_of_motions() {
    let folder = Folder::new("report-motions");
    let page = |options: &str| {
        let printed = typed_in(&folder, &format!("kin report {options} -o page.html"));
        assert!(printed.ends_with("code 0\n"), "{printed}");
        std::fs::read_to_string(folder.path().join("page.html")).unwrap()
    };
    let law = page("slider_crank --over '0..90deg by cycloidal in 0.4s'");
    assert!(law.contains(r#""variable":"time""#) && law.contains(r#""range":[0.0,0.4]"#));
    let robot = "five_bar --set ground=2 --set left=0.5 --set left_rod=2 --set right_rod=2 --set right=1.5";
    let line = page(&format!(
        "{robot} --over alpha=0..2rad --over beta=1..1.6rad --speed 3rad/s"
    ));
    assert!(line.contains(r#""variable":"input""#) && line.contains(r#""range":[0.0,2.0]"#));
    assert!(line.contains(r#""speed":3.0"#) && !line.contains(r#""value":1.0"#));
    let laws = page(&format!(
        "{robot} --over 'alpha=0..2rad by cycloidal in 0.5s' --over 'beta=1..1.6rad at 1rad/s'"
    ));
    assert!(laws.contains(r#""variable":"time""#) && laws.contains(r#""range":[0.0,0.6"#));
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
    for words in [
        &["sweep", "four_bar", "--csv", "--rows", "20000"][..],
        &["completions", "bash"],
    ] {
        let mut child = crate::typed::kin(&folder)
            .args(words)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
        assert!(output.status.success());
    }
}
