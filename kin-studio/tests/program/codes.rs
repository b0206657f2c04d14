//! The codes with which the commands end: each means one thing in all of them.

use std::process::Command;

use crate::typed::{Folder, kin, typed_in};

/// A crank that swings by 112° to both sides.
const SWINGS: &str = "--set r3=60 --set r4=45";

/// For each command, a case that closes and a case that does not.
#[test]
fn codes_of_mechanisms_that_do_not_close() {
    let folder = Folder::new("codes");
    typed_in(&folder, "kin sweep four_bar --set r3=82 --rows 7 --csv wanted.csv");
    for (command, code) in [
        ("show four_bar", 0),
        ("list", 0),
        ("code four_bar c", 0),
        ("sweep four_bar", 0),
        ("sweep four_bar --csv a.csv", 0),
        ("sweep four_bar SWINGS --over -100..100deg", 0),
        ("sweep four_bar SWINGS", 1),
        ("sweep four_bar SWINGS --csv b.csv", 1),
        ("sweep four_bar SWINGS --json b.json", 1),
        // all rows close, and there is a gap between them
        ("sweep four_bar SWINGS --over -10..370deg --rows 2", 1),
        (
            "sweep four_bar SWINGS --over -10..370deg --rows 2 --law cycloidal --time 1s",
            1,
        ),
        ("sweep four_bar --set r1=900", 1),
        // branches cross there, and the rows beside close
        (
            "sweep four_bar --set r2=90 --set r3=90 --set r4=90 --over 10..350deg --rows 2",
            0,
        ),
        ("sweep universal_joint --set beta=90deg --rows 5", 1),
        ("cycle four_bar SWINGS", 0),
        ("cycle four_bar --set r1=900", 1),
        ("peaks four_bar --of theta4", 0),
        ("peaks four_bar SWINGS --of theta4", 1),
        ("peaks four_bar --set r1=900 --of theta4", 1),
        ("verify four_bar", 0),
        ("verify four_bar SWINGS --over -150..150deg", 1),
        ("fit four_bar --data wanted.csv --vary r3", 0),
        ("fit four_bar SWINGS --data wanted.csv --vary r1 --within r1=85..95", 1),
        ("table four_bar --tolerance 1e-3", 0),
        ("table four_bar SWINGS --tolerance 1e-3", 1),
        // without a range, the page goes as far as the mechanism does
        ("report four_bar SWINGS", 0),
        ("report four_bar SWINGS --over 0..360deg -o c.html", 1),
        ("report four_bar --set r1=900 -o d.html", 1),
    ] {
        let line = format!("kin {}", command.replace("SWINGS", SWINGS));
        let printed = typed_in(&folder, &line);
        assert!(printed.ends_with(&format!("-- code {code}\n")), "{printed}");
        assert!(code == 0 || printed.contains("close"), "{printed}");
    }
    // the files that were written are good, and their messages say so
    for file in ["b.csv", "b.json", "c.html"] {
        assert!(
            std::fs::metadata(folder.path().join(file)).unwrap().len() > 1000,
            "{file}"
        );
    }
    assert!(!folder.path().join("d.html").exists());
    let printed = typed_in(&folder, &format!("kin sweep four_bar {SWINGS} --csv b.csv"));
    assert!(
        printed.contains("b.csv: ") && printed.contains("of 361 rows"),
        "{printed}"
    );
}

/// The joint has no motion there, and no number stands for one.
#[test]
fn a_singular_joint_has_no_rates() {
    let folder = Folder::new("singular");
    let printed = typed_in(&folder, "kin sweep universal_joint --set beta=90deg --rows 5");
    assert_eq!(printed.matches("singular\n").count(), 3, "{printed}");
    assert!(
        !printed.contains("e1") && printed.contains("in 3 of 5 rows"),
        "{printed}"
    );
}

/// The program that reads poses reports lines that it cannot read.
#[test]
#[cfg(unix)]
fn example_in_c_with_wrong_poses() {
    use std::io::Write as _;
    use std::process::Stdio;
    let Ok(_) = Command::new("cc").arg("--version").output() else {
        return;
    };
    let folder = Folder::new("example");
    assert!(kin(&folder).args(["code", "four_bar", "c"]).status().unwrap().success());
    let built = Command::new("cc")
        .current_dir(folder.path())
        .args(["-std=c99", "main.c", "four_bar.c", "-lm", "-o", "four_bar"])
        .status()
        .unwrap();
    assert!(built.success());
    for (input, code, out, message) in [
        ("90 30 80 70 1 1 0 0 0 1\n", 0, "theta3 ", ""),
        (
            "90 30 80 70 1\n",
            1,
            "",
            "a pose takes 10 numbers, and the last one has 5",
        ),
        ("90 30 80 70 1 1 0 0 0 open\n", 1, "", "the last one has 9"),
        ("90 30 80 70 1 1 0 0 0 1\n45", 1, "theta3 ", "the last one has 1"),
        (
            "90 30 80 70 1 1 0 0 0 0\n",
            0,
            "-1: an assembly is neither 1 nor -1",
            "",
        ),
        ("", 0, "", ""),
    ] {
        let mut child = Command::new(folder.path().join("four_bar"))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
        let output = child.wait_with_output().unwrap();
        let [output_text, messages] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
        assert_eq!(output.status.code(), Some(code), "{input}: {output_text}{messages}");
        assert!(
            output_text.starts_with(out) && output_text.is_empty() == out.is_empty(),
            "{input}: {output_text}"
        );
        assert!(
            messages.contains(message) && messages.is_empty() == message.is_empty(),
            "{input}: {messages}"
        );
    }
}
