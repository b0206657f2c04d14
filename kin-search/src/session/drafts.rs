//! Files that get their names when they are whole.

use std::ffi::OsString;
use std::fs::{self, File};
use std::future::ready;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::{fmt, mem};

use datafusion::execution::object_store::ObjectStoreUrl;
use datafusion::object_store::local::LocalFileSystem;
use datafusion::object_store::path::Path as Location;
use datafusion::object_store::{
    CopyOptions, Error, GetOptions, GetResult, ListResult, MultipartUpload, ObjectMeta, ObjectStore, PutMode,
    PutMultipartOptions, PutOptions, PutPayload, PutResult, Result, UploadPart,
};
use datafusion::prelude::SessionContext;
use futures::stream::BoxStream;

/// The draft of a file, beside it. Its name holds the number of the process that writes it, and has no ending by which
/// tables are read.
pub(crate) fn draft_of(path: &Path) -> PathBuf {
    let mut draft = OsString::from(path);
    draft.push(format!(".{}.draft", std::process::id()));
    PathBuf::from(draft)
}

/// The local files of a session. What a statement writes gets its name when the statement has ended well.
///
/// The engine itself keeps the rows that it has written when a query fails, under the name of the file that was wanted.
/// So each file is written as a draft beside it, until [`publish`](Self::publish) or [`discard`](Self::discard) is
/// called.
#[derive(Debug)]
pub struct Drafts {
    files: LocalFileSystem,
    begun: Mutex<Begun>,
}

/// The files that have been begun.
#[derive(Debug)]
enum Begun {
    Files(Vec<PathBuf>),
    /// No file is begun any more.
    Discarded,
}

impl Drafts {
    /// Lets a session write its local files as drafts.
    #[must_use]
    pub fn of(session: &SessionContext) -> Arc<Self> {
        let drafts = Arc::new(Self {
            files: LocalFileSystem::new(),
            begun: Mutex::new(Begun::Files(Vec::new())),
        });
        session.register_object_store(
            ObjectStoreUrl::local_filesystem().as_ref(),
            Arc::clone(&drafts) as Arc<dyn ObjectStore>,
        );
        drafts
    }

    /// Gives all files their names. Each replaces the file that had its name.
    ///
    /// # Errors
    /// Returns the error of the system if a file cannot be renamed, with the path of the file.
    pub fn publish(&self) -> Result<(), (PathBuf, io::Error)> {
        let mut begun = self.begun();
        let Begun::Files(files) = &mut *begun else {
            return Ok(());
        };
        for path in mem::take(files) {
            if let Err(error) = fs::rename(draft_of(&path), &path) {
                files.push(path.clone());
                return Err((path, error));
            }
        }
        Ok(())
    }

    /// Removes all drafts. None is begun after this, whatever the engine still does.
    pub fn discard(&self) {
        if let Begun::Files(files) = mem::replace(&mut *self.begun(), Begun::Discarded) {
            for path in files {
                // A draft that cannot be removed is known by its name.
                let _ = fs::remove_file(draft_of(&path));
            }
        }
    }

    fn begun(&self) -> MutexGuard<'_, Begun> {
        self.begun.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Begins the draft of a file.
    fn begin(&self, location: &Location) -> Result<File> {
        let path = self.files.path_to_filesystem(location)?;
        let mut begun = self.begun();
        let Begun::Files(files) = &mut *begun else {
            return Err(failed(io::Error::other("the statement is cancelled")));
        };
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder).map_err(failed)?;
        }
        let draft = File::create(draft_of(&path)).map_err(failed)?;
        files.push(path);
        Ok(draft)
    }
}

fn failed(error: io::Error) -> Error {
    Error::Generic {
        store: "file",
        source: Box::new(error),
    }
}

fn written() -> PutResult {
    PutResult {
        e_tag: None,
        version: None,
    }
}

/// A draft that is written in several parts, in the order in which they come.
#[derive(Debug)]
struct Draft(File);

impl Draft {
    fn append(&mut self, data: &PutPayload) -> Result<()> {
        data.iter()
            .try_for_each(|bytes| self.0.write_all(bytes))
            .map_err(failed)
    }
}

#[async_trait::async_trait]
impl MultipartUpload for Draft {
    fn put_part(&mut self, data: PutPayload) -> UploadPart {
        Box::pin(ready(self.append(&data)))
    }

    async fn complete(&mut self) -> Result<PutResult> {
        Ok(written())
    }

    async fn abort(&mut self) -> Result<()> {
        Ok(())
    }
}

impl fmt::Display for Drafts {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "drafts in {}", self.files)
    }
}

#[async_trait::async_trait]
impl ObjectStore for Drafts {
    async fn put_opts(&self, location: &Location, payload: PutPayload, options: PutOptions) -> Result<PutResult> {
        if !matches!(options.mode, PutMode::Overwrite) {
            return Err(Error::NotImplemented {
                operation: "a file that may not be there yet".to_owned(),
                implementer: self.to_string(),
            });
        }
        Draft(self.begin(location)?).append(&payload)?;
        Ok(written())
    }

    async fn put_multipart_opts(
        &self,
        location: &Location,
        _: PutMultipartOptions,
    ) -> Result<Box<dyn MultipartUpload>> {
        Ok(Box::new(Draft(self.begin(location)?)))
    }

    async fn get_opts(&self, location: &Location, options: GetOptions) -> Result<GetResult> {
        self.files.get_opts(location, options).await
    }

    fn delete_stream(&self, locations: BoxStream<'static, Result<Location>>) -> BoxStream<'static, Result<Location>> {
        self.files.delete_stream(locations)
    }

    fn list(&self, prefix: Option<&Location>) -> BoxStream<'static, Result<ObjectMeta>> {
        self.files.list(prefix)
    }

    async fn list_with_delimiter(&self, prefix: Option<&Location>) -> Result<ListResult> {
        self.files.list_with_delimiter(prefix).await
    }

    async fn copy_opts(&self, from: &Location, to: &Location, options: CopyOptions) -> Result<()> {
        self.files.copy_opts(from, to, options).await
    }
}
