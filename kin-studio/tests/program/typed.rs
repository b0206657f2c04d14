//! Lines that are typed, and the output of the program.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A temporary folder of a test, which is removed at the end.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("kin-program-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    pub(crate) fn write(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, text).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // what is left does no harm
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// The program in a folder.
pub(crate) fn kin(folder: &Folder) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kin"));
    command
        .current_dir(folder.path())
        .env("COLUMNS", "100")
        .env("NO_COLOR", "1");
    command
}

/// The output, the messages and the code of a line that is typed. Single quotes hold words together.
pub(crate) fn typed_in(folder: &Folder, line: &str) -> String {
    let mut words: Vec<String> = Vec::new();
    for (index, part) in line.split('\'').enumerate() {
        if index % 2 == 1 {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    let output = kin(folder).args(words.iter().skip(1)).output().unwrap();
    let mut text = format!("$ {line}\n{}", String::from_utf8(output.stdout).unwrap());
    let messages = String::from_utf8(output.stderr).unwrap();
    if !messages.is_empty() {
        let _ = write!(text, "-- messages\n{messages}");
    }
    let _ = writeln!(text, "-- code {}", output.status.code().unwrap());
    without_sizes_of_pages(&text.replace(&*folder.path().to_string_lossy(), "FOLDER"))
}

/// The size of a page changes with each word of its script, which other tests hold.
fn without_sizes_of_pages(text: &str) -> String {
    let without_size = |line: &str| match line.split_once(".html: ") {
        Some((name, size)) if size.ends_with(" bytes\n") => format!("{name}.html: … bytes\n"),
        _ => line.to_owned(),
    };
    text.split_inclusive('\n').map(without_size).collect()
}

/// The same in a new folder.
pub(crate) fn typed(name: &str, line: &str) -> String {
    typed_in(&Folder::new(name), line)
}
