//! Finished ranges of a search, kept as Parquet.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use datafusion::arrow::array::RecordBatch;
use datafusion::arrow::datatypes::SchemaRef;
use datafusion::parquet::arrow::ArrowWriter;
use datafusion::parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use datafusion::parquet::errors::ParquetError;

use super::fault::Fault;
use super::ids::Ids;
use crate::digest::digest;
use crate::session::draft_of;

/// The folder of the finished ranges of one search.
///
/// Its name is the digest of everything that the rows depend on besides the ids, so another search, or another version
/// of the program, has another folder.
#[derive(Clone, Debug)]
pub(super) struct Parts {
    folder: PathBuf,
}

impl Parts {
    /// The folder in another one, made if it is not there.
    pub(super) fn open(folder: &Path, search: &str) -> Result<Self, Fault> {
        let folder = folder.join(format!("search-{:016x}", digest(search.bytes())));
        let note = folder.join("search.txt");
        fs::create_dir_all(&folder)
            .and_then(|()| fs::write(&note, search))
            .map_err(|error| Fault::File(note, error))?;
        Ok(Self { folder })
    }

    /// The folder itself.
    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    fn file(&self, range: Ids) -> PathBuf {
        self.folder.join(format!("ids-{}-{}.parquet", range.first, range.end))
    }

    /// The rows of a range, if it is finished.
    pub(super) fn read(&self, range: Ids) -> Result<Option<Vec<RecordBatch>>, Fault> {
        let path = self.file(range);
        let file = match File::open(&path) {
            Ok(file) => file,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
            Err(error) => return Err(Fault::File(path, error)),
        };
        let failed = |error: ParquetError| Fault::File(path.clone(), std::io::Error::other(error));
        let reader = ParquetRecordBatchReaderBuilder::try_new(file)
            .and_then(ParquetRecordBatchReaderBuilder::build)
            .map_err(failed)?;
        reader
            .collect::<Result<Vec<_>, _>>()
            .map(Some)
            .map_err(|error| Fault::File(path, std::io::Error::other(error)))
    }

    /// Keeps the rows of a range. The file gets its name when it is whole.
    pub(super) fn write(&self, range: Ids, columns: &SchemaRef, rows: &[RecordBatch]) -> Result<(), Fault> {
        let path = self.file(range);
        let draft = draft_of(&path);
        let failed = |error: std::io::Error| Fault::File(draft.clone(), error);
        let file = File::create(&draft).map_err(failed)?;
        let mut writer =
            ArrowWriter::try_new(file, SchemaRef::clone(columns), None).map_err(|error| failed(error.into()))?;
        for batch in rows {
            writer.write(batch).map_err(|error| failed(error.into()))?;
        }
        writer.close().map_err(|error| failed(error.into()))?;
        fs::rename(&draft, &path).map_err(|error| Fault::File(path, error))
    }
}
