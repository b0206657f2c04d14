//! `--mechanism`: mechanisms of files.

use std::path::{Path, PathBuf};

#[cfg(feature = "refine")]
use kin_live::Mechanism;
use kin_search::Functions;

use super::fault::Fault;

/// The options of commands in which mechanisms have names.
#[derive(Debug, clap::Args)]
pub(crate) struct DeclaredArguments {
    /// A mechanism of a .kin file, which is there beside those of the library. May be given again
    #[arg(long = "mechanism", value_name = "FILE.kin")]
    files: Vec<PathBuf>,
}

impl DeclaredArguments {
    /// These functions, and those of the files.
    pub(crate) fn join(&self, functions: &Functions) -> Result<Functions, Fault> {
        let mut all = functions.clone();
        for path in &self.files {
            let text = declaration(path)?;
            let joined = all.with_declaration(&text);
            all = joined.map_err(|error| Fault::Wrong(format!("{}: {error}", path.display())))?;
        }
        Ok(all)
    }

    /// The mechanisms of the files.
    #[cfg(feature = "refine")]
    pub(crate) fn mechanisms(&self) -> Result<Vec<Mechanism>, Fault> {
        let declare = |path: &PathBuf| {
            let mechanism = Mechanism::declare(&declaration(path)?);
            mechanism.map_err(|error| Fault::Wrong(format!("{}: {error}", path.display())))
        };
        self.files.iter().map(declare).collect()
    }
}

fn declaration(path: &Path) -> Result<String, Fault> {
    kin_studio::file::declaration(path).map_err(Fault::Wrong)
}
