//! The folder in which `.kin` files are built, and what was built is kept.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use super::super::fault::Fault;

/// The variable that names another folder.
const VARIABLE: &str = "KIN_CACHE";

/// The cache. Its lock is held until it is dropped.
pub(crate) struct Cache {
    folder: PathBuf,
    _lock: File,
}

/// The folder of the cache.
pub(crate) fn folder() -> Result<PathBuf, Fault> {
    let named = |name: &str| {
        std::env::var_os(name)
            .filter(|value| !value.is_empty())
            .map(PathBuf::from)
    };
    named(VARIABLE)
        .or_else(|| Some(named("XDG_CACHE_HOME")?.join("kin")))
        .or_else(|| Some(named("LOCALAPPDATA")?.join("kin")))
        .or_else(|| Some(named("HOME")?.join(".cache").join("kin")))
        .ok_or_else(|| {
            Fault::build(format!(
                "there is no home folder for the cache: name one, as in `{VARIABLE}=folder`"
            ))
        })
}

fn refused(folder: &Path, error: &io::Error) -> Fault {
    Fault::build(format!(
        "the cache {} cannot be written: {error}; name another folder, as in `{VARIABLE}=folder`",
        folder.display()
    ))
}

impl Cache {
    /// Opens the cache, and waits while another `kin` builds in it.
    pub(crate) fn open() -> Result<Self, Fault> {
        let folder = folder()?;
        let lock = fs::create_dir_all(&folder)
            .and_then(|()| {
                File::options()
                    .create(true)
                    .write(true)
                    .truncate(false)
                    .open(folder.join("lock"))
            })
            .map_err(|error| refused(&folder, &error))?;
        match lock.try_lock() {
            Ok(()) => {}
            Err(TryLockError::WouldBlock) => {
                eprintln!("another `kin` builds in {}: waiting for it", folder.display());
                lock.lock().map_err(|error| refused(&folder, &error))?;
            }
            Err(TryLockError::Error(error)) => return Err(refused(&folder, &error)),
        }
        Ok(Self { folder, _lock: lock })
    }

    /// The folder in which cargo builds, shared by all files.
    pub(crate) fn target(&self) -> PathBuf {
        self.folder.join("target")
    }

    /// The package of one file, and another one for each version of kin.
    pub(crate) fn package(&self) -> PathBuf {
        self.folder.join("package")
    }

    /// Writes a file of the cache, unless it is there with the same text.
    pub(crate) fn write(&self, path: &Path, text: &str) -> Result<(), Fault> {
        if fs::read_to_string(path).is_ok_and(|own| own == text) {
            return Ok(());
        }
        let parent = path.parent().unwrap_or(path);
        fs::create_dir_all(parent)
            .and_then(|()| fs::write(path, text))
            .map_err(|error| refused(&self.folder, &error))
    }

    /// Keeps what was built under its key.
    pub(crate) fn keep(&self, key: &str, built: &Path) -> Result<PathBuf, Fault> {
        let kept = kept(&self.folder, key);
        let parent = kept.parent().unwrap_or(&self.folder);
        // a program that runs can be replaced, not overwritten
        let fresh = kept.with_extension("new");
        fs::create_dir_all(parent)
            .and_then(|()| fs::copy(built, &fresh))
            .and_then(|_| fs::rename(&fresh, &kept))
            .map_err(|error| refused(&self.folder, &error))?;
        Ok(kept)
    }
}

/// The program of a key, whether it is there or not.
pub(crate) fn kept(folder: &Path, key: &str) -> PathBuf {
    folder
        .join("built")
        .join(key)
        .with_extension(std::env::consts::EXE_EXTENSION)
}

/// Takes away all that was built. Other files in the folder stay, in case that a folder of one's own was named.
pub(crate) fn clear() -> Result<PathBuf, Fault> {
    let folder = folder()?;
    if !folder.exists() {
        return Ok(folder);
    }
    let cache = Cache::open()?;
    for part in [cache.target(), cache.package(), cache.folder.join("built")] {
        if part.exists() {
            fs::remove_dir_all(&part).map_err(|error| refused(&cache.folder, &error))?;
        }
    }
    Ok(folder)
}
