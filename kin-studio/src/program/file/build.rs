//! A program of a `.kin` file, built by cargo.

use std::fmt::Write as _;
use std::io::{BufRead as _, BufReader, Read as _};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

use super::super::fault::Fault;
use super::super::progress::watched;
use super::cache::{self, Cache};
use super::place::{Mistake, bytes_of};
use super::read::KinFile;

/// The versions of all crates that kin was built with.
const LOCK: &str = include_str!("../../../../Cargo.lock");

/// How a file is built.
#[derive(Clone, Debug)]
pub(crate) struct Builder {
    /// The folder of kin's source.
    pub(crate) source: PathBuf,
    /// Whether crates may be fetched from the registry.
    pub(crate) fetches: bool,
}

impl Builder {
    /// With the source that this program was built from, unless another one is named.
    pub(crate) fn new(source: Option<&Path>, fetches: bool) -> Result<Self, Fault> {
        let own = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."));
        let source = source.unwrap_or(own);
        if !source.join("kin-studio").join("Cargo.toml").is_file() {
            return Err(Fault::build(format!(
                "kin's source is not in {}: name its folder, as in `--kin-source path/to/kin`",
                source.display()
            )));
        }
        let source = source
            .canonicalize()
            .map_err(|error| Fault::build(format!("{} cannot be read: {error}", source.display())))?;
        Ok(Self { source, fetches })
    }

    /// The program of a file. `path` and `text` are those of the file, for messages.
    pub(crate) fn program(&self, file: &KinFile, path: &str, text: &str) -> Result<PathBuf, Fault> {
        let key = self.key(file)?;
        let kept = cache::kept(&cache::folder()?, &key);
        if kept.is_file() {
            return Ok(kept);
        }
        let cache = Cache::open()?;
        // another one may have built it in the meantime
        if kept.is_file() {
            return Ok(kept);
        }
        let package = cache.package();
        cache.write(&package.join("Cargo.toml"), &self.manifest())?;
        cache.write(&package.join("src").join("main.rs"), &main_of(file))?;
        self.lock(&cache, &package)?;
        let what = format!("building {path} (the first file takes some minutes, later ones seconds)");
        let built = watched(&what, 1, |_| self.build(&cache, &package, path, text))?;
        cache.keep(&key, &built)
    }

    /// What the program depends on: the declaration, kin and the compiler.
    fn key(&self, file: &KinFile) -> Result<String, Fault> {
        let compiler = run(Command::new("rustc").arg("-vV").current_dir(&self.source), "rustc")?;
        let mut hash = hmac_sha256::Hash::new();
        let own = std::env::current_exe().and_then(std::fs::metadata);
        let own = own
            .and_then(|own| Ok(format!("{} {:?}", own.len(), own.modified()?)))
            .unwrap_or_default();
        for part in [
            &main_of(file),
            LOCK,
            &compiler,
            &self.manifest(),
            env!("CARGO_PKG_VERSION"),
            &own,
        ] {
            hash.update(part.len().to_le_bytes());
            hash.update(part);
        }
        Ok(data_encoding::HEXLOWER.encode(&hash.finalize()[..16]))
    }

    fn manifest(&self) -> String {
        let path = |name: &str| Value::from(self.source.join(name).to_string_lossy().into_owned());
        format!(
            "[package]\nname = \"kin-file\"\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = false\n\n\
             [dependencies]\nkin-core = {{ path = {} }}\nkin-studio = {{ path = {}, features = [\"program\"] }}\n\n\
             [workspace]\n\n\
             [profile.dev]\ndebug = false\nincremental = false\ndebug-assertions = false\nopt-level = 1\n\n\
             [profile.dev.package.\"*\"]\nopt-level = 0\n\n[profile.dev.package.kin-core]\nopt-level = 1\n",
            path("kin-core"),
            path("kin-studio"),
        )
    }

    /// A lock file with the versions that kin was built with. Cargo adds the package itself, and takes away what it
    /// does not need.
    fn lock(&self, cache: &Cache, package: &Path) -> Result<(), Fault> {
        let lock = package.join("Cargo.lock");
        // the lock of kin's own source and the manifest tell whether it was made already
        let stamp = package.join("locked");
        let made_from = format!("{}{LOCK}", self.manifest());
        if lock.is_file() && std::fs::read_to_string(&stamp).is_ok_and(|own| own == made_from) {
            return Ok(());
        }
        cache.write(&lock, LOCK)?;
        let mut command = self.cargo(package);
        run(command.args(["update", "--workspace", "--quiet"]), "cargo").map_err(without_crates)?;
        cache.write(&stamp, &made_from)
    }

    fn cargo(&self, package: &Path) -> Command {
        let mut command = Command::new("cargo");
        // the folder of the file may choose another toolchain, or another registry, by its own files
        command
            .current_dir(package)
            .env_remove("CARGO_TARGET_DIR")
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .env_remove("RUSTFLAGS");
        if !self.fetches {
            command.env("CARGO_NET_OFFLINE", "true");
        }
        command
    }

    fn build(&self, cache: &Cache, package: &Path, path: &str, text: &str) -> Result<PathBuf, Fault> {
        let mut command = self.cargo(package);
        command.args(["build", "--locked", "--message-format=json", "--color=never"]);
        if !self.fetches {
            command.arg("--offline");
        }
        command.arg("--target-dir").arg(cache.target());
        command
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let mut child = command.spawn().map_err(|error| missing("cargo", &error))?;
        let stderr = child.stderr.take();
        let told = std::thread::spawn(move || {
            let mut told = String::new();
            if let Some(mut stderr) = stderr {
                // what cannot be read is not shown
                let _ = stderr.read_to_string(&mut told);
            }
            told
        });
        let (mut mistakes, mut others, mut built) = (Vec::new(), Vec::new(), None);
        for line in child
            .stdout
            .take()
            .into_iter()
            .flat_map(|out| BufReader::new(out).lines())
        {
            let Ok(message) = line
                .map_err(drop)
                .and_then(|line| serde_json::from_str::<Value>(&line).map_err(drop))
            else {
                continue;
            };
            match message["reason"].as_str() {
                Some("compiler-artifact") => {
                    let executable = message["executable"].as_str().map(PathBuf::from);
                    built = executable.filter(|_| message["target"]["name"] == "kin-file").or(built);
                }
                Some("compiler-message") if message["message"]["level"] == "error" => {
                    match mistake_of(&message["message"], text) {
                        Some(mistake) => mistakes.push(mistake.shown(path, text)),
                        None => others.push(message["message"]["rendered"].as_str().unwrap_or("").to_owned()),
                    }
                }
                _ => {}
            }
        }
        let status = child.wait().map_err(|error| missing("cargo", &error))?;
        let told = told.join().unwrap_or_default();
        match built {
            Some(built) if status.success() => Ok(built),
            _ if !mistakes.is_empty() => Err(Fault::build(mistakes.join("\n\n"))),
            _ if !others.is_empty() => Err(Fault::build(others.join("\n"))),
            _ => Err(without_crates(Fault::build(told.trim()))),
        }
    }
}

/// The program: one line in front of the declaration, in the place of the first line of the file.
fn main_of(file: &KinFile) -> String {
    let (first, rest) = file.rust.split_once('\n').unwrap_or((&file.rust, ""));
    debug_assert!(first.trim().is_empty(), "the first line names the format only");
    format!(
        "#![allow(warnings)] use kin_core::prelude::*; fn main() -> std::process::ExitCode {{ \
         kin_studio::program::of_file::<{}>() }} mechanism! {{\n{rest}\n}}\n",
        file.name
    )
}

/// The mistake of a message of the compiler, if it has a place in the file.
fn mistake_of(message: &Value, text: &str) -> Option<Mistake> {
    let spans = message["spans"].as_array()?;
    let primary = spans.iter().find(|span| span["is_primary"] == true)?;
    let mut span = primary;
    while !span["file_name"].as_str()?.ends_with("main.rs") {
        span = span["expansion"].get("span")?;
    }
    let number = |name: &str| usize::try_from(span[name].as_u64()?).ok();
    let start = bytes_of(text, number("line_start")?, number("column_start")?);
    let end = bytes_of(text, number("line_end")?, number("column_end")?);
    let mut words = message["message"].as_str()?.to_owned();
    for child in message["children"].as_array().into_iter().flatten() {
        let (level, text) = (child["level"].as_str()?, child["message"].as_str()?);
        let is_ours = !text.contains("this error originates in");
        if is_ours && (level == "help" || level == "note") {
            let _ = write!(words, "\n{level}: {text}");
        }
    }
    Some(Mistake::new(words, start..end.max(start)))
}

/// The output of a command that is to succeed.
fn run(command: &mut Command, name: &str) -> Result<String, Fault> {
    let output = command.output().map_err(|error| missing(name, &error))?;
    if output.status.success() {
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    } else {
        Err(Fault::build(String::from_utf8_lossy(&output.stderr).trim()))
    }
}

fn missing(name: &str, error: &std::io::Error) -> Fault {
    if error.kind() == std::io::ErrorKind::NotFound {
        Fault::build(format!(
            "`{name}` is not found: a .kin file is built by Rust; install it from https://rustup.rs, and \
             open a new terminal"
        ))
    } else {
        Fault::build(format!("`{name}` cannot be run: {error}"))
    }
}

/// Says how to fetch crates that are not there.
fn without_crates(fault: Fault) -> Fault {
    let text = fault.to_string();
    let is_offline =
        text.contains("--offline") || text.contains("offline was specified") || text.contains("offline mode");
    if is_offline {
        Fault::build(format!(
            "crates that kin needs are not on this machine: run the same command with `--fetch` once\n{text}"
        ))
    } else {
        fault
    }
}
