//! Ranges of ids that cross to executors.
//!
//! The engine's own `range` is a table of the session that made it, in one part, and does not cross. The table here
//! does, as two numbers. On the scheduler it becomes operators that every executor knows: rows with the first id and
//! the end of a list, distributed over the parts, and the function `range` of lists, unnested.

use std::sync::Arc;

use datafusion::arrow::array::{Int64Array, RecordBatch};
use datafusion::arrow::datatypes::{DataType, Field, Schema, SchemaRef};
use datafusion::catalog::{Session, TableProvider};
use datafusion::common::tree_node::Transformed;
use datafusion::common::{Result, UnnestOptions, exec_err, plan_err};
use datafusion::datasource::memory::MemorySourceConfig;
use datafusion::datasource::{provider_as_source, source_as_provider};
use datafusion::functions_nested::range::range_udf;
use datafusion::functions_table::generate_series::{GenerateSeriesTable, GenericSeriesState};
use datafusion::logical_expr::{Expr, LogicalPlan, TableType};
use datafusion::physical_expr::expressions::Column;
use datafusion::physical_expr::{PhysicalExpr, ScalarFunctionExpr};
use datafusion::physical_plan::ExecutionPlan;
use datafusion::physical_plan::projection::ProjectionExec;
use datafusion::physical_plan::unnest::{ListUnnest, UnnestExec};

/// The number of ids that are listed at a time: a batch of the engine, or 8 MB of a very large range. A query can be
/// called off after every 128 lists, when the engine lets other work go on.
const LIST: std::ops::RangeInclusive<i64> = 1 << 13..=1 << 20;

/// The largest number of lists, which all stand in the plan of a query.
const LISTS: i64 = 1 << 16;

/// The most ids of a range that executors list.
const MOST: i64 = LISTS * *LIST.end();

/// The ids from the first to before the end, as a table with the column `value`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Ids {
    pub(super) first: i64,
    pub(super) end: i64,
}

impl Ids {
    /// The number of ids.
    pub(super) fn count(self) -> i64 {
        self.end - self.first
    }

    /// Refuses more ids than executors can list.
    pub(super) fn check(self) -> Result<()> {
        if self.count() <= MOST {
            return Ok(());
        }
        plan_err!(
            "a range of a query on a cluster has {MOST} ids at most, and this one has {}",
            self.count()
        )
    }

    /// The number of [`pieces`](Self::pieces).
    pub(super) fn count_of_pieces(self, length: i64) -> i64 {
        quotient(self.count(), length.max(1))
    }

    /// The same ids in pieces of a length, counted from the first.
    pub(super) fn pieces(self, length: i64) -> impl Iterator<Item = Self> {
        let length = length.max(1);
        (0..self.count_of_pieces(length)).map(move |piece| {
            let first = self.first + piece * length;
            Self {
                first,
                end: self.end.min(first.saturating_add(length)),
            }
        })
    }

    /// The ids of the engine's own `range` and `generate_series`, if they are whole numbers one by one.
    fn of_series(series: &GenerateSeriesTable) -> Result<Option<Self>> {
        let generator = series.as_generator(1)?;
        let generator = generator.read();
        let Some(series) = generator.as_any().downcast_ref::<GenericSeriesState<i64>>() else {
            return Ok(None);
        };
        let (first, end) = (*series.start(), *series.end());
        // An end or a count that has no number is left to the engine.
        let end = end.checked_add(i64::from(series.include_end()));
        let end = end.filter(|end| *series.step() == 1 && end.checked_sub(first).is_some());
        Ok(end.map(|end| Self {
            first,
            end: end.max(first),
        }))
    }

    fn column() -> SchemaRef {
        Arc::new(Schema::new(vec![Field::new("value", DataType::Int64, false)]))
    }

    pub(super) fn encode(self) -> [u8; 16] {
        let mut bytes = [0; 16];
        bytes[..8].copy_from_slice(&self.first.to_le_bytes());
        bytes[8..].copy_from_slice(&self.end.to_le_bytes());
        bytes
    }

    pub(super) fn decode(bytes: &[u8]) -> Result<Self> {
        let number = |at: usize| {
            bytes
                .get(at..at + 8)
                .and_then(|bytes| bytes.try_into().ok())
                .map(i64::from_le_bytes)
        };
        match (number(0), number(8), bytes.len()) {
            (Some(first), Some(end), 16) if end.checked_sub(first).is_some_and(|count| count >= 0) => {
                Ok(Self { first, end })
            }
            _ => exec_err!(
                "a range of ids is two numbers of 8 bytes, and these are {} bytes",
                bytes.len()
            ),
        }
    }
}

/// The quotient, rounded up.
fn quotient(count: i64, length: i64) -> i64 {
    count / length + i64::from(count % length != 0)
}

#[async_trait::async_trait]
impl TableProvider for Ids {
    fn schema(&self) -> SchemaRef {
        Self::column()
    }

    fn table_type(&self) -> TableType {
        TableType::Base
    }

    async fn scan(
        &self,
        state: &dyn Session,
        projection: Option<&Vec<usize>>,
        _: &[Expr],
        _: Option<usize>,
    ) -> Result<Arc<dyn ExecutionPlan>> {
        self.check()?;
        let options = state.config_options();
        let parts = i64::try_from(options.execution.target_partitions).unwrap_or(1).max(1);
        // Parts of nearly the same length, and never more than there are ids.
        let length = quotient(self.count(), parts);
        let list = (self.count() / LISTS).clamp(*LIST.start(), *LIST.end());
        let bounds = Arc::new(Schema::new(vec![
            Field::new("first", DataType::Int64, false),
            Field::new("end", DataType::Int64, false),
        ]));
        let rows = self
            .pieces(length)
            .map(|part| {
                part.pieces(list)
                    .map(|list| {
                        let column = |id| Arc::new(Int64Array::from(vec![id])) as _;
                        let columns = vec![column(list.first), column(list.end)];
                        // One row in each batch, since all lists of a batch are made at once.
                        Ok(RecordBatch::try_new(Arc::clone(&bounds), columns)?)
                    })
                    .collect::<Result<Vec<_>>>()
            })
            .collect::<Result<Vec<_>>>()?;
        let rows = if rows.is_empty() { vec![vec![]] } else { rows };
        let source = MemorySourceConfig::try_new_exec(&rows, Arc::clone(&bounds), None)?;
        let columns: Vec<Arc<dyn PhysicalExpr>> =
            vec![Arc::new(Column::new("first", 0)), Arc::new(Column::new("end", 1))];
        let list = ScalarFunctionExpr::try_new(range_udf(), columns, &bounds, Arc::new(options.clone()))?;
        let list: Arc<dyn PhysicalExpr> = Arc::new(list);
        let lists = Arc::new(ProjectionExec::try_new(vec![(list, "value".to_owned())], source)?);
        let unnested = ListUnnest {
            index_in_input_schema: 0,
            depth: 1,
        };
        let ids = Arc::new(UnnestExec::new(
            lists,
            vec![unnested],
            vec![],
            Self::column(),
            UnnestOptions::default(),
        )?);
        // Nobody asks for no column at all unless only the rows are counted.
        match projection {
            Some(columns) if columns.is_empty() => Ok(Arc::new(ProjectionExec::try_new(
                Vec::<(Arc<dyn PhysicalExpr>, String)>::new(),
                ids,
            )?)),
            _ => Ok(ids),
        }
    }
}

/// The ids that a scan reads, if it reads ids.
pub(super) fn scanned(plan: &LogicalPlan) -> Option<Ids> {
    let LogicalPlan::TableScan(scan) = plan else {
        return None;
    };
    let provider = source_as_provider(&scan.source).ok()?;
    let provider: &dyn std::any::Any = provider.as_ref();
    provider.downcast_ref::<Ids>().copied()
}

/// The plan with `range` and `generate_series` as tables that cross to executors.
pub(super) fn carry(plan: LogicalPlan) -> Result<LogicalPlan> {
    plan.transform_down_with_subqueries(|node| {
        let LogicalPlan::TableScan(mut scan) = node else {
            return Ok(Transformed::no(node));
        };
        let ids = match source_as_provider(&scan.source) {
            Ok(provider) => {
                let provider: &dyn std::any::Any = provider.as_ref();
                match provider.downcast_ref::<GenerateSeriesTable>() {
                    Some(series) => Ids::of_series(series)?,
                    None => None,
                }
            }
            Err(_) => None,
        };
        Ok(match ids {
            Some(ids) => {
                scan.source = provider_as_source(Arc::new(ids));
                Transformed::yes(LogicalPlan::TableScan(scan))
            }
            None => Transformed::no(LogicalPlan::TableScan(scan)),
        })
    })
    .map(|transformed| transformed.data)
}

/// The plan with all its ids replaced by others.
pub(super) fn replace(plan: &LogicalPlan, ids: Ids) -> Result<LogicalPlan> {
    plan.clone()
        .transform_down_with_subqueries(|node| match node {
            LogicalPlan::TableScan(mut scan) if scanned(&LogicalPlan::TableScan(scan.clone())).is_some() => {
                scan.source = provider_as_source(Arc::new(ids));
                Ok(Transformed::yes(LogicalPlan::TableScan(scan)))
            }
            node => Ok(Transformed::no(node)),
        })
        .map(|transformed| transformed.data)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_hold_each_id_once() {
        for (first, end, length) in [(0, 10, 3), (-5, 7, 4), (2, 2, 5), (0, 9, 9), (0, 1, 1000)] {
            let pieces: Vec<_> = Ids { first, end }.pieces(length).collect();
            let ids: Vec<_> = pieces.iter().flat_map(|piece| piece.first..piece.end).collect();
            assert_eq!(ids, (first..end).collect::<Vec<_>>());
            assert!(pieces.iter().all(|piece| (1..=length).contains(&piece.count())));
        }
    }

    #[test]
    fn bytes_of_another_kind_are_refused() {
        let ids = Ids { first: -3, end: 8 };
        assert_eq!(Ids::decode(&ids.encode()).expect("they are ids"), ids);
        assert!(Ids::decode(&ids.encode()[..15]).is_err());
        assert!(Ids::decode(&Ids { first: 8, end: -3 }.encode()).is_err());
    }
}
