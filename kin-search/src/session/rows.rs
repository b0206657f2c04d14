//! The rows of a query, within the memory of its session.

use datafusion::arrow::array::{Array as _, RecordBatch};
use datafusion::common::Result;
use datafusion::dataframe::DataFrame;
use datafusion::execution::memory_pool::MemoryConsumer;
use futures::TryStreamExt as _;

/// All rows of a query. The rows count as memory of the session, unlike those of the engine's `collect`.
///
/// # Errors
/// Returns the errors of the engine, one of which says that the rows need more memory than the session may take.
pub async fn rows(frame: DataFrame) -> Result<Vec<RecordBatch>> {
    let reservation = MemoryConsumer::new("Rows").register(frame.task_ctx().memory_pool());
    let mut stream = frame.execute_stream().await?;
    let mut rows = Vec::new();
    while let Some(batch) = stream.try_next().await? {
        reservation.try_grow(bytes(&batch)?)?;
        rows.push(batch);
    }
    Ok(rows)
}

/// The memory of some rows. Rows that are a part of a larger buffer count alone.
fn bytes(batch: &RecordBatch) -> Result<usize> {
    let mut bytes = 0;
    for column in batch.columns() {
        bytes += column.to_data().get_slice_memory_size()?;
    }
    Ok(bytes)
}
