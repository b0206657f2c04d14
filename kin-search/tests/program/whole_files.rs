//! A file of rows is there as a whole or not at all.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use super::{Process, program};

/// A folder of one test, with a file that was there before.
struct Folder(PathBuf);

const OLD: &str = "old rows\n";

impl Folder {
    fn new(name: &str) -> Self {
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("whole-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        Self(folder)
    }

    fn old_file(&self, name: &str) -> PathBuf {
        let path = self.0.join(name);
        fs::write(&path, OLD).unwrap();
        path
    }

    /// The names of all files, those in folders as well.
    fn files(&self) -> Vec<String> {
        let mut folders = vec![self.0.clone()];
        let mut names = Vec::new();
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
                if entry.file_type().unwrap().is_dir() {
                    folders.push(entry.path());
                } else {
                    names.push(entry.file_name().into_string().unwrap());
                }
            }
        }
        names
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let mut names: Vec<String> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The ways in which rows get into a file.
#[derive(Clone, Copy, Debug)]
enum Way {
    Output,
    Copy,
}

/// The call of the program that writes the rows of a query to a file, with files of settings and of SQL in another
/// folder.
fn writing(way: Way, select: &str, to: &Path) -> Command {
    // The engine writes little by little.
    let settings = "set datafusion.execution.objectstore_writer_buffer_size = 20000; \
                    set datafusion.execution.parquet.max_row_group_size = 5000;";
    let sql = match way {
        Way::Output => format!("{settings} select 1 as begun; {select}"),
        Way::Copy => format!("{settings} select 1 as begun; copy ({select}) to '{}'", to.display()),
    };
    // The folder has the name of the test, whose queries are no others'.
    let name = format!("{}.sql", to.parent().and_then(Path::file_name).unwrap().display());
    let mut call = program();
    call.arg("query").arg(super::file(&name, &sql));
    if matches!(way, Way::Output) {
        call.arg("--output").arg(to);
    }
    call
}

const FORMS: [&str; 3] = ["rows.csv", "rows.json", "rows.parquet"];

#[test]
fn a_query_that_fails_leaves_the_old_file() {
    // The limits are infinite in a late row.
    let fails = "select value, candidate(value, 1, 1, 0, case when value = 60000 then 1e0 / 0 else 1 end) as r2 \
        from range(0, 100000)";
    for name in FORMS {
        for way in [Way::Output, Way::Copy] {
            let folder = Folder::new(&format!("failed-{name}-{way:?}"));
            let path = folder.old_file(name);
            let output = writing(way, fails, &path).output().unwrap();
            let message = String::from_utf8(output.stderr).unwrap();
            assert_eq!(output.status.code(), Some(1), "{message}");
            assert!(message.contains("must be finite"), "{message}");
            assert_eq!(fs::read_to_string(&path).unwrap(), OLD, "{name} {way:?}");
            assert_eq!(folder.names(), [name]);
            // A query that ends well replaces it.
            let output = writing(way, "select 5 as five", &path).output().unwrap();
            assert!(output.status.success(), "{output:?}");
            assert_ne!(fs::read(&path).unwrap(), OLD.as_bytes(), "{name} {way:?}");
            assert_eq!(folder.names(), [name]);
        }
    }
}

#[test]
fn a_query_that_fails_adds_nothing_to_a_folder_of_files() {
    let folder = Folder::new("folder");
    fs::write(folder.0.join("first.csv"), "value,r2\n1,0.5\n").unwrap();
    let late = "select value, candidate(value, 1, 1, 0, case when value = 60000 then 1e0 / 0 else 1 end) as r2 \
        from range(0, 100000)";
    let table = format!(
        "create external table found (value bigint, r2 double) stored as csv location '{}/' options \
         ('format.has_header' 'true');",
        folder.0.display()
    );
    for (name, sql, code) in [
        ("insert.sql", format!("{table} insert into found {late}"), 1),
        (
            "partition.sql",
            format!(
                "copy (select value % 3 as part, r2 from ({late})) to '{}/' stored as csv partitioned by (part)",
                folder.0.display()
            ),
            1,
        ),
        (
            "added.sql",
            format!("{table} insert into found {}", late.replace("60000", "-1")),
            0,
        ),
    ] {
        let output = program().arg("query").arg(super::file(name, &sql)).output().unwrap();
        assert_eq!(output.status.code(), Some(code), "{name}: {output:?}");
        let files = folder.files();
        assert!(
            files
                .iter()
                .all(|file| Path::new(file).extension().is_some_and(|ending| ending == "csv")),
            "{name}: {files:?}"
        );
        assert_eq!(files.len() == 1, code != 0, "{name}: {files:?}");
    }
}

/// Waits until the drafts in a folder have so many bytes.
#[cfg(unix)]
fn wait_for_draft(folder: &Folder, bytes: u64) {
    let until = Instant::now() + Duration::from_mins(2);
    while Instant::now() < until {
        let sizes = fs::read_dir(&folder.0).unwrap().map(Result::unwrap);
        let drafts = sizes.filter(|entry| entry.file_name().to_string_lossy().ends_with(".draft"));
        let sizes: Vec<u64> = drafts.filter_map(|entry| Some(entry.metadata().ok()?.len())).collect();
        if sizes.iter().any(|size| *size >= bytes) {
            return;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    panic!("no draft of {bytes} bytes");
}

#[cfg(unix)]
#[test]
fn killed_query_leaves_the_old_file() {
    let long = "select value, candidate(value, 1, 1, 0, 1) as r2 from range(0, 1000000000)";
    for (name, way, signal, bytes) in [
        ("rows.csv", Way::Output, "TERM", None),
        ("rows.csv", Way::Output, "INT", Some(0)),
        ("rows.parquet", Way::Output, "TERM", Some(200_000)),
        ("rows.json", Way::Copy, "INT", Some(500_000)),
        ("rows.parquet", Way::Copy, "TERM", Some(1_000_000)),
        ("rows.csv", Way::Copy, "KILL", Some(400_000)),
    ] {
        let folder = Folder::new(&format!("killed-{name}-{way:?}-{signal}"));
        let path = folder.old_file(name);
        let mut call = writing(way, long, &path);
        call.stdout(Stdio::piped()).stderr(Stdio::null());
        let mut process = Process(call.spawn().unwrap());
        process.wait_for("begun");
        if let Some(bytes) = bytes {
            wait_for_draft(&folder, bytes);
        }
        process.signal(signal);
        let status = process.0.wait().unwrap();
        assert_eq!(status.code(), (signal != "KILL").then_some(130), "{name} {signal}");
        assert_eq!(fs::read_to_string(&path).unwrap(), OLD, "{name} {signal}");
        // Drafts that cannot be removed any more are known by their names, whose endings are not those of tables.
        let mut left = folder.names();
        left.retain(|left| signal != "KILL" || left == name);
        assert_eq!(left, [name], "{signal}");
    }
}
