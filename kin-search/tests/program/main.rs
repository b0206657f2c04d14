//! The program, as a process.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};

#[cfg(all(feature = "problem", feature = "refine"))]
mod straight_line;

/// A process that ends with its test, whatever happens.
struct Process(Child);

impl Drop for Process {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _ = self.0.kill();
        let _ = self.0.wait();
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
        "select 1 as one; select value as id, four_bar_turn(1, candidate(value, 1, 1, 0.2, 0.9), 1.5, 1.5)['closed'] as closed \
         from range(0, 100) order by closed desc, id limit 3",
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
    for (arguments, told) in [
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
    ] {
        let output = program().arg("query").args(arguments).output().unwrap();
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.code() == Some(1) && message.contains(told), "{message}");
    }
}

#[cfg(unix)]
#[test]
fn an_interrupt_cancels_the_query() {
    let query = file(
        "long.sql",
        "select 1 as started; select max(four_bar_turn(1, candidate(value, 1, 1, 0.2, 0.9), 1.5, 1.5)['theta4_swing']) from range(0, 1000000000)",
    );
    let child = program()
        .arg("query")
        .arg(query)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut process = Process(child);
    let mut lines = BufReader::new(process.0.stdout.take().unwrap()).lines();
    assert!(lines.any(|line| line.unwrap().contains("started")));
    let sent = Command::new("kill")
        .arg("-INT")
        .arg(process.0.id().to_string())
        .status()
        .unwrap();
    assert!(sent.success());
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
