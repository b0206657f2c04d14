//! `--mechanism`: mechanisms of files.

use std::path::PathBuf;

use kin_search::Functions;

use super::fault::Fault;

/// What commands take that call functions by their names.
#[derive(Debug, clap::Args)]
pub(crate) struct DeclaredArguments {
    /// A mechanism of a .kin file, whose functions are there beside those of the library. May be given again
    #[arg(long = "mechanism", value_name = "FILE.kin")]
    files: Vec<PathBuf>,
}

impl DeclaredArguments {
    /// These functions, and those of the files.
    pub(crate) fn join(&self, functions: &Functions) -> Result<Functions, Fault> {
        let mut all = functions.clone();
        for path in &self.files {
            let text = kin_studio::file::declaration(path).map_err(Fault::Wrong)?;
            let joined = all.with_declaration(&text);
            all = joined.map_err(|error| Fault::Wrong(format!("{}: {error}", path.display())))?;
        }
        Ok(all)
    }
}
