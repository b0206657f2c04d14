//! Small tables of the client that go with a query.

use std::io::Cursor;
use std::sync::Arc;

use datafusion::arrow::array::RecordBatch;
use datafusion::arrow::ipc::reader::StreamReader;
use datafusion::arrow::ipc::writer::StreamWriter;
use datafusion::catalog::TableProvider;
use datafusion::common::{Result, exec_datafusion_err};
use datafusion::datasource::MemTable;

/// The most bytes of a table that goes with a query. It is written into the plan, which every task takes along.
const MOST: usize = 1 << 20;

/// The rows of a table of this process; `None` if it is of another kind.
fn rows(table: &dyn TableProvider) -> Option<Vec<RecordBatch>> {
    let table: &dyn std::any::Any = table;
    let mut rows = Vec::new();
    for part in &table.downcast_ref::<MemTable>()?.batches {
        // A table to which rows are being added is no table that can be sent.
        rows.extend(part.try_read().ok()?.iter().cloned());
    }
    Some(rows)
}

/// Whether a table goes with a query: it is in the memory of this process, and small.
pub(super) fn is_small(table: &dyn TableProvider) -> bool {
    let bytes = |rows: Vec<RecordBatch>| rows.iter().map(RecordBatch::get_array_memory_size).sum::<usize>();
    rows(table).is_some_and(|rows| bytes(rows) <= MOST)
}

/// The table as a stream of Arrow.
pub(super) fn encode(table: &dyn TableProvider, to: &mut Vec<u8>) -> Result<()> {
    let rows = rows(table).ok_or_else(|| exec_datafusion_err!("a table is not in memory, and cannot be sent"))?;
    let mut writer = StreamWriter::try_new(to, &table.schema())?;
    for rows in &rows {
        writer.write(rows)?;
    }
    Ok(writer.finish()?)
}

/// The table of a stream.
pub(super) fn decode(bytes: &[u8]) -> Result<Arc<dyn TableProvider>> {
    let reader = StreamReader::try_new(Cursor::new(bytes), None)?;
    let schema = reader.schema();
    let rows = reader.collect::<std::result::Result<Vec<_>, _>>()?;
    Ok(Arc::new(MemTable::try_new(schema, vec![rows])?))
}

#[cfg(test)]
mod tests {
    use datafusion::arrow::array::{Float64Array, StringArray};
    use datafusion::arrow::datatypes::{DataType, Field, Schema};

    use super::*;

    fn table(count: usize) -> MemTable {
        let fields = vec![
            Field::new("name", DataType::Utf8, true),
            Field::new("length", DataType::Float64, true),
        ];
        let schema = Arc::new(Schema::new(fields));
        let names: StringArray = (0..count).map(|row| (row % 2 == 0).then_some("rocker")).collect();
        let lengths: Float64Array = (0..count).map(|row| (row % 3 == 0).then_some(0.1)).collect();
        let rows = RecordBatch::try_new(Arc::clone(&schema), vec![Arc::new(names), Arc::new(lengths)]);
        MemTable::try_new(schema, vec![vec![rows.expect("two columns")]]).expect("a table")
    }

    #[test]
    fn tables_arrive_as_they_were() {
        for count in [0, 1, 100] {
            let sent = table(count);
            let mut bytes = Vec::new();
            encode(&sent, &mut bytes).expect("it is in memory");
            let received = decode(&bytes).expect("it was written by this program");
            assert_eq!(received.schema(), sent.schema());
            assert_eq!(rows(received.as_ref()), rows(&sent));
        }
        assert!(decode(&[1, 2, 3]).is_err());
    }

    #[test]
    fn large_tables_stay() {
        assert!(is_small(&table(1000)));
        assert!(!is_small(&table(1 << 20)));
    }
}
