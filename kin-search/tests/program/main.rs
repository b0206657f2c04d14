//! The program, as a process.

use std::fs;
use std::io::{BufRead, BufReader, Read as _};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

// the measures of a straight line, without SQL
#[cfg(feature = "refine")]
#[allow(dead_code, reason = "only a part is used")]
#[path = "../../../kin-fit/examples/published/mod.rs"]
mod published;
#[cfg(feature = "refine")]
mod straight_line;
mod whole_files;

/// A process that ends with its test, whatever happens.
struct Process(Child);

impl Drop for Process {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl Process {
    /// Waits for a line of the standard output that contains a text.
    fn wait_for(&mut self, text: &str) {
        let mut lines = BufReader::new(self.0.stdout.as_mut().unwrap()).lines();
        assert!(lines.any(|line| line.unwrap().contains(text)), "{text}");
    }

    #[cfg(unix)]
    fn signal(&self, signal: &str) {
        let mut kill = Command::new("kill");
        let sent = kill.arg(format!("-{signal}")).arg(self.0.id().to_string()).status();
        assert!(sent.unwrap().success());
    }
}

fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_kin-search"))
}

/// A file of SQL in the folder of this test's files.
fn file(name: &str, text: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, text).unwrap();
    path
}

#[test]
fn rows_are_printed_or_written_to_a_file() {
    let query = file(
        "best.sql",
        "select 1 as one; select value as id, four_bar_turn(1, candidate(value, 1, 1, 0.2, 0.9), 1.5, 1.5)['closed'] \
         as closed from range(0, 100) order by closed desc, id limit 3",
    );
    let output = program().arg("query").arg(&query).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        output.status.success() && text.contains("| one |") && text.contains("closed"),
        "{text}"
    );
    for ending in ["parquet", "csv", "json"] {
        let best = query.with_extension(ending);
        let status = program()
            .arg("query")
            .arg(&query)
            .arg("--output")
            .arg(&best)
            .output()
            .unwrap()
            .status;
        assert!(status.success());
        let again = match ending {
            "parquet" => {
                let read = file(
                    "read.sql",
                    &format!(
                        "create external table best stored as parquet location '{}'; \
                         select count(*) as rows, sum(closed) as sum from best",
                        best.display()
                    ),
                );
                let output = program().arg("query").arg(read).output().unwrap();
                String::from_utf8(output.stdout).unwrap()
            }
            _ => fs::read_to_string(&best).unwrap(),
        };
        let wanted = if ending == "parquet" { "| 3    |" } else { "id" };
        assert!(again.contains(wanted), "{again}");
    }
}

#[test]
fn mistakes_end_with_a_message() {
    let query = file("wrong.sql", "select five_bars(1)");
    for (arguments, wanted) in [
        (vec![query.display().to_string()], "five_bars"),
        (vec!["nowhere.sql".to_owned()], "nowhere.sql cannot be read"),
        (
            vec![file("empty.sql", "-- nothing").display().to_string()],
            "has no statement",
        ),
        (
            vec![
                query.display().to_string(),
                "--output".to_owned(),
                "best.txt".to_owned(),
            ],
            ".parquet",
        ),
        (
            vec![file("arguments.sql", "select four_bar(1, 2, 3)").display().to_string()],
            "four_bar takes 5 to 10 arguments, and 3 are given",
        ),
    ] {
        let output = program().arg("query").args(arguments).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(1) && message.contains(wanted), "{message}");
    }
}

#[test]
fn files_declare_mechanisms() {
    let example = |name: &str| PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("examples").join(name);
    let (wiper, query) = (example("wiper.kin"), example("wiper.sql"));
    let query = fs::read_to_string(query).unwrap().replace("200000", "2000");
    let query = file("wiper.sql", &query);
    let run = |command: &str, arguments: &[&str], files: &[&PathBuf]| {
        let mut program = program();
        program.arg(command).args(arguments);
        for file in files {
            program.arg("--mechanism").arg(file);
        }
        let output = program.output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (output.status.code(), text(output.stdout), text(output.stderr))
    };
    let query = query.display().to_string();
    let (code, found, message) = run("query", &[&query], &[&wiper]);
    assert!(code == Some(0) && found.contains("| transmission"), "{found}{message}");
    let (code, _, message) = run("query", &[&query], &[]);
    assert!(code == Some(1) && message.contains("wiper_turn"), "{message}");
    let (_, printed, _) = run("functions", &["wiper_turn"], &[&wiper]);
    assert!(
        printed.contains("wiper_turn(crank, rod, lever, frame, arm") && printed.contains("crank: Crank. (length)"),
        "{printed}"
    );

    let mistake = file(
        "mistake.kin",
        "kin 1\nstruct Wiper { crank: Length }\ninput theta: Angle;\nunknown h: Length;\nh == cranc * sin(theta);\n",
    );
    let (code, _, message) = run("query", &[&query], &[&mistake]);
    assert!(
        code == Some(1) && message.contains("mistake.kin:5:6") && message.contains("^^^^^"),
        "{message}"
    );
    let (code, _, message) = run("functions", &[], &[&wiper, &wiper]);
    let wanted = "the mechanism `Wiper` would have the function `wiper`, which another declaration has already";
    assert!(
        code == Some(1) && message.contains(wanted) && message.contains("wiper.kin: "),
        "{message}"
    );
    let (code, _, message) = run("query", &[&query], &[&PathBuf::from("nowhere.kin")]);
    assert!(
        code == Some(1) && message.contains("there is no file nowhere.kin"),
        "{message}"
    );
}

#[cfg(unix)]
#[test]
fn an_interrupt_cancels_the_query() {
    let query = file(
        "long.sql",
        "select 1 as started; select max(four_bar_turn(1, candidate(value, 1, 1, 0.2, 0.9), 1.5, 1.5)['theta4_swing']) \
         from range(0, 1000000000)",
    );
    let child = program()
        .arg("query")
        .arg(query)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut process = Process(child);
    process.wait_for("started");
    process.signal("INT");
    let status = process.0.wait().unwrap();
    let messages: Vec<String> = BufReader::new(process.0.stderr.take().unwrap())
        .lines()
        .map(Result::unwrap)
        .collect();
    assert_eq!(status.code(), Some(130));
    assert!(
        messages.iter().any(|line| line == "the query is cancelled"),
        "{messages:?}"
    );
}

/// `kin-search query … 2>&1 | head -1`
#[test]
fn a_reader_that_goes_away_is_no_mistake() {
    let query = file("rows.sql", "select value from range(0, 30000)");
    for (arguments, code) in [(vec![query], 0), (vec![PathBuf::from("nowhere.sql")], 1)] {
        let mut child = program()
            .arg("query")
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop((child.stdout.take(), child.stderr.take()));
        assert_eq!(Process(child).0.wait().unwrap().code(), Some(code));
    }
}

#[test]
fn letters_of_patterns_in_names_of_files() {
    let name = "a?[1] é%20*.csv";
    let path = file(name, "");
    let query = file("one.sql", "select 1 as one");
    let output = program()
        .arg("query")
        .arg(query)
        .arg("--output")
        .arg(&path)
        .output()
        .unwrap();
    assert!(output.status.success(), "{output:?}");
    assert_eq!(fs::read_to_string(&path).unwrap(), "one\n1\n");
    let copy = file("two.sql", &format!("copy (select 2 as two) to '{}'", path.display()));
    let output = program().arg("query").arg(copy).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    assert_eq!(fs::read_to_string(&path).unwrap(), "two\n2\n");
}

#[test]
fn no_cores_are_refused() {
    let query = file("cores.sql", "select 1 as one");
    let output = program()
        .arg("query")
        .arg(query)
        .args(["--cores", "0"])
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(!output.status.success() && message.contains("--cores"), "{message}");
}

/// The query stood still for ever with two threads that hand rows to each other and write them to the disk.
#[test]
fn a_query_that_needs_too_much_memory_ends_with_an_error() {
    let groups = "select value % 1500000 as k, count(*) as n, max(candidate(value, 1, 1, 0, 1)) as m from \
                  range(0, 3000000) group by 1 order by m, k limit 3";
    // The rows that are printed count as well.
    let rows = "select value, value + 1 as next from range(0, 1000000)";
    for (name, sql, memory) in [("groups.sql", groups, "1500KB"), ("many.sql", rows, "3MB")] {
        let query = file(name, sql);
        let arguments = ["--memory", memory, "--cores", "2"];
        let child = program()
            .arg("query")
            .arg(query)
            .args(arguments)
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut process = Process(child);
        let until = Instant::now() + Duration::from_mins(2);
        let status = loop {
            match process.0.try_wait().unwrap() {
                Some(status) => break status,
                None if Instant::now() > until => panic!("{name} stands still"),
                None => std::thread::sleep(Duration::from_millis(20)),
            }
        };
        let mut message = String::new();
        process.0.stderr.take().unwrap().read_to_string(&mut message).unwrap();
        assert_eq!(status.code(), Some(1), "{name}: {message}");
        assert!(message.contains("Resources exhausted"), "{name}: {message}");
    }
}

/// The candidates of a refinement are the same, whatever the form of their file.
#[cfg(feature = "refine")]
#[test]
fn candidates_of_a_refinement_are_read_from_both_forms() {
    let job = file(
        "job.json",
        r#"{ "mechanism": "hoeken_linkage", "evaluations": 100, "bounds": { "crank": [0.5, 1.5], "coupler": [2, 3] },
             "goal": { "path": { "point": "tracer",
                                 "targets": [[0, 4.0], [1, 4.0], [2, 4.0], [3, 4.0], [4, 4.0]] } } }"#,
    );
    let query = file(
        "hoeken.sql",
        "select value as id, 2e0 as ground, 1.1 + 0.1 / 3 * value as crank, 2.6e0 as coupler, 'open' as assembly \
         from range(0, 3) order by id",
    );
    let refined = |candidates: &PathBuf| {
        let output = program()
            .arg("refine")
            .arg(&job)
            .arg("--candidates")
            .arg(candidates)
            .output()
            .unwrap();
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    let tables = ["csv", "parquet"].map(|ending| {
        let candidates = query.with_extension(ending);
        let written = program()
            .arg("query")
            .arg(&query)
            .arg("--output")
            .arg(&candidates)
            .status();
        assert!(written.unwrap().success());
        refined(&candidates)
    });
    assert_eq!(tables[0].lines().count(), 4, "{}", tables[0]);
    assert_eq!(tables[0], tables[1]);
    // A file of another form says so.
    let wrong = file("wrong.parquet", "id,ground\n");
    let output = program()
        .arg("refine")
        .arg(&job)
        .arg("--candidates")
        .arg(wrong)
        .output()
        .unwrap();
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(
        output.status.code() == Some(1) && message.contains("wrong.parquet cannot be read"),
        "{message}"
    );
}
