//! The folder in which contenders are built, with a Python of its own.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The programs that take turns, and those that write the solvers of others.
const PROGRAMS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/programs");

/// The packages with their versions.
const REQUIREMENTS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/requirements.txt");

/// The folder, and the Python in it.
pub(crate) struct Environment {
    pub(crate) folder: PathBuf,
    python: PathBuf,
    /// This program, built for all instructions of this machine, as the C of others is.
    pub(crate) native: Option<PathBuf>,
}

impl Environment {
    /// The folder below cargo's, with the packages of others if they are wanted. A package that cannot be installed is
    /// told, and left out.
    pub(crate) fn new(has_peers: bool) -> Self {
        let folder = target().join("peers");
        fs::create_dir_all(&folder).expect("cargo's folder can be written");
        let home = folder.join("python");
        let python = home.join("bin/python");
        if !python.exists() {
            run(Command::new("python3").args(["-m", "venv"]).arg(&home));
        }
        let native = if has_peers { native(&folder) } else { None };
        let own = Self { folder, python, native };
        let requirements = fs::read_to_string(REQUIREMENTS).expect("the list of packages is there");
        for package in requirements.lines() {
            let name = package.split("==").next().unwrap_or(package);
            if has_peers || name == "numpy" {
                own.install(package);
            }
        }
        own
    }

    fn install(&self, package: &str) {
        let output = self
            .python()
            .args(["-m", "pip", "install", "--quiet", package])
            .output();
        let output = output.expect("the environment has a Python");
        if !output.status.success() {
            println!(
                "{package} cannot be installed: {}",
                String::from_utf8_lossy(&output.stderr).trim()
            );
        }
    }

    /// Whether a module can be imported.
    pub(crate) fn has(&self, module: &str) -> bool {
        let output = self.python().args(["-c", &format!("import {module}")]).output();
        output.is_ok_and(|output| output.status.success())
    }

    pub(crate) fn python(&self) -> Command {
        let mut command = Command::new(&self.python);
        command.env("PYTHONDONTWRITEBYTECODE", "1").env("PYTHONPATH", ".");
        // NumPy asks for huge pages, and nobody asks for those of kin's columns
        command.env("NUMPY_MADVISE_HUGEPAGE", "0");
        command
    }

    /// A program of this crate.
    pub(crate) fn program(name: &str) -> PathBuf {
        Path::new(PROGRAMS).join(name)
    }

    /// Prints what the contenders are made by.
    pub(crate) fn print_versions(&self) {
        for mut command in [
            Command::new("rustc"),
            Command::new("gcc"),
            Command::new("node"),
            self.python(),
        ] {
            if let Ok(output) = command.arg("--version").output() {
                let text = String::from_utf8_lossy(&output.stdout).into_owned();
                let name = command.get_program().to_string_lossy().into_owned();
                println!("version {name}: {}", text.lines().next().unwrap_or_default());
            }
        }
        let list = self
            .python()
            .args(["-m", "pip", "freeze"])
            .output()
            .expect("pip is there");
        for line in String::from_utf8_lossy(&list.stdout).lines() {
            println!("version of a package: {line}");
        }
    }
}

/// This program, built for all instructions of this machine, as the C of others is.
fn native(folder: &Path) -> Option<PathBuf> {
    let target = folder.join("native");
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo
        .args(["build", "--release", "--quiet", "--manifest-path"])
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml"))
        .arg("--target-dir")
        .arg(&target)
        .env("RUSTFLAGS", "-C target-cpu=native");
    let is_built = cargo.status().is_ok_and(|status| status.success());
    if !is_built {
        println!("kin.solve.native cannot be built");
    }
    is_built.then(|| target.join("release").join(env!("CARGO_BIN_NAME")))
}

/// Cargo's folder for what is built.
fn target() -> PathBuf {
    let program = std::env::current_exe().expect("this program has a path");
    let profile = program.parent().expect("it is in a folder");
    profile.parent().expect("which is in cargo's folder").to_owned()
}

/// Runs a command that must succeed.
pub(crate) fn run(command: &mut Command) {
    let output = command
        .output()
        .unwrap_or_else(|error| panic!("{command:?} cannot be run: {error}"));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {errors}");
}

/// Builds a program of C that takes turns, from files of a folder.
pub(crate) fn build(folder: &Path, files: &[&str], flags: &[&str], shape: [usize; 3], program: &str) {
    let [rows, arguments, results] = shape;
    let sizes = [("ROWS", rows), ("ARGUMENTS", arguments), ("RESULTS", results)];
    run(Command::new("gcc")
        .current_dir(folder)
        .arg("-std=c99")
        .args(flags)
        .args(sizes.map(|(name, size)| format!("-D{name}={size}")))
        .arg(Environment::program("turns.c"))
        .args(files)
        .args(["-lm", "-o", program]));
}
