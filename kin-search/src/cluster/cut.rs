//! Searches cut into ranges of ids.
//!
//! A search whose rows depend on one id each can be done range by range: each finished range is kept, so a search that
//! was interrupted goes on where it stopped. If a query sorts its rows and keeps the first, each range yields its first
//! rows, and the first rows of the search are among them.

use std::collections::BTreeSet;
use std::sync::Arc;

use datafusion::arrow::array::RecordBatch;
use datafusion::arrow::datatypes::{Field, Schema, SchemaRef};
use datafusion::common::tree_node::{TreeNode, TreeNodeRecursion};
use datafusion::common::{Column, Result};
use datafusion::datasource::{MemTable, provider_as_source};
use datafusion::logical_expr::{Expr, LogicalPlan, LogicalPlanBuilder};

use super::ids::{self, Ids};
use crate::function::{declaration_of, is_solver};

/// A search that can be done range by range.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    /// The query of each range.
    part: LogicalPlan,
    /// The whole query, for the rows of all ranges.
    whole: LogicalPlan,
    /// The ids of the whole search.
    pub(super) ids: Ids,
}

impl Cut {
    /// The cut of an optimized query, if its rows depend on one id each.
    pub(super) fn of(query: &LogicalPlan) -> Option<Self> {
        let mut part = query;
        loop {
            if let Some(ids) = rows(part) {
                return Some(Self {
                    part: first_rows(query, part),
                    whole: query.clone(),
                    ids,
                });
            }
            if part.expressions().iter().any(depends_on_more) {
                return None;
            }
            part = match part {
                LogicalPlan::Projection(node) => &node.input,
                LogicalPlan::SubqueryAlias(node) => &node.input,
                LogicalPlan::Sort(node) => &node.input,
                // Without a sort any rows will do: one query ends as soon as it has them.
                LogicalPlan::Limit(node) if matches!(*node.input, LogicalPlan::Sort(_)) => &node.input,
                _ => return None,
            };
        }
    }

    /// The query of one range.
    pub(super) fn query(&self, range: Ids) -> Result<LogicalPlan> {
        ids::replace(&self.part, range)
    }

    /// Everything but the ids on which the rows of a range depend, as text.
    pub(super) fn text(&self) -> Result<String> {
        let mut text = self.part.display_indent_schema().to_string();
        let mut declarations: BTreeSet<String> = BTreeSet::new();
        self.part.apply_with_subqueries(|node| {
            node.apply_expressions(|expression| {
                expression.apply(|part| {
                    if let Expr::ScalarFunction(call) = part {
                        declarations.extend(declaration_of(&call.func).map(str::to_owned));
                    }
                    Ok(TreeNodeRecursion::Continue)
                })
            })
        })?;
        for declaration in declarations {
            text += "\n";
            text += &declaration;
        }
        Ok(text)
    }

    /// The columns of a range's rows.
    pub(super) fn columns(&self) -> SchemaRef {
        columns(&self.part)
    }

    /// The whole query over the rows of all ranges.
    pub(super) fn join(&self, rows: &[RecordBatch]) -> Result<LogicalPlan> {
        above(&self.whole, &rows_as(&self.part, rows)?)
    }
}

/// The columns of a query's rows. Names are made unique, since tables and files need that.
fn columns(query: &LogicalPlan) -> SchemaRef {
    let fields: Vec<_> = query
        .schema()
        .fields()
        .iter()
        .enumerate()
        .map(|(index, field)| Field::new(format!("{index}_{}", field.name()), field.data_type().clone(), true))
        .collect();
    Arc::new(Schema::new(fields))
}

/// Rows with other names of their columns.
pub(super) fn named(columns: &SchemaRef, rows: &RecordBatch) -> Result<RecordBatch> {
    Ok(RecordBatch::try_new(Arc::clone(columns), rows.columns().to_vec())?)
}

/// The rows that a query has yielded, as a replacement of the query.
pub(super) fn rows_as(query: &LogicalPlan, rows: &[RecordBatch]) -> Result<LogicalPlan> {
    let columns = columns(query);
    let rows = rows
        .iter()
        .map(|rows| named(&columns, rows))
        .collect::<Result<Vec<_>>>()?;
    let table = MemTable::try_new(Arc::clone(&columns), vec![rows])?;
    let names = query
        .schema()
        .iter()
        .zip(columns.fields())
        .map(|((qualifier, field), column)| {
            Expr::Column(Column::new_unqualified(column.name())).alias_qualified(qualifier.cloned(), field.name())
        });
    LogicalPlanBuilder::scan("parts", provider_as_source(Arc::new(table)), None)?
        .project(names)?
        .build()
}

/// The sort with a number of first rows that stands directly above the rows, or the rows.
fn first_rows(query: &LogicalPlan, rows: &LogicalPlan) -> LogicalPlan {
    let mut node = query;
    while !std::ptr::eq(node, rows) {
        match node {
            LogicalPlan::Sort(sort) if sort.fetch.is_some() && std::ptr::eq(sort.input.as_ref(), rows) => break,
            _ => match node.inputs().first() {
                Some(input) => node = input,
                None => break,
            },
        }
    }
    node.clone()
}

/// The part of a query above its rows, moved onto a scan.
fn above(node: &LogicalPlan, scan: &LogicalPlan) -> Result<LogicalPlan> {
    if rows(node).is_some() {
        return Ok(scan.clone());
    }
    let inputs = node
        .inputs()
        .into_iter()
        .map(|input| above(input, scan))
        .collect::<Result<Vec<_>>>()?;
    node.with_new_exprs(node.expressions(), inputs)
}

/// The ids of a query, if each of its rows depends on one of them.
fn rows(plan: &LogicalPlan) -> Option<Ids> {
    if plan.expressions().iter().any(depends_on_more) {
        return None;
    }
    match plan {
        LogicalPlan::TableScan(scan) if scan.fetch.is_none() => ids::scanned(plan),
        LogicalPlan::Projection(node) => rows(&node.input),
        LogicalPlan::Filter(node) => rows(&node.input),
        LogicalPlan::SubqueryAlias(node) => rows(&node.input),
        LogicalPlan::Unnest(node) => rows(&node.input),
        _ => None,
    }
}

/// Whether an expression depends on more than its row.
fn depends_on_more(expression: &Expr) -> bool {
    expression
        .exists(|part| {
            Ok(match part {
                Expr::ScalarSubquery(_) | Expr::Exists(_) | Expr::InSubquery(_) | Expr::SetComparison(_) => true,
                // Searches of a mechanism are marked as volatile, though they depend on their arguments alone.
                Expr::ScalarFunction(call) => part.is_volatile_node() && !is_solver(&call.func),
                _ => part.is_volatile_node(),
            })
        })
        .unwrap_or(true)
}

#[cfg(test)]
mod tests {
    use datafusion::arrow::util::pretty::pretty_format_batches;
    use datafusion::prelude::SessionContext;

    use super::*;

    async fn optimized(session: &SessionContext, sql: &str) -> LogicalPlan {
        let state = session.state();
        let plan = state.create_logical_plan(sql).await.expect("the query is right");
        state
            .optimize(&ids::carry(plan).expect("ids can be carried"))
            .expect("the query can be optimized")
    }

    async fn rows(session: &SessionContext, plan: LogicalPlan) -> Vec<RecordBatch> {
        let frame = session.execute_logical_plan(plan).await.expect("the plan is right");
        frame.collect().await.expect("the plan runs")
    }

    #[tokio::test]
    async fn ranges_together_are_the_whole_search() {
        let session = SessionContext::new();
        let views = "create view numbers as select value as id, value * value % 97 as residue from range(3, 1003)";
        session.sql(views).await.expect("the view is right");
        for sql in [
            "select id, residue from numbers where residue > 90 order by residue desc, id limit 7",
            "select n.id + 1 as next, n.residue from numbers n where n.residue < 3 order by n.id",
            "select residue as r from numbers order by residue, id limit 4 offset 3",
            "select * from (select id, residue from numbers order by residue, id limit 9) where id % 2 = 1",
            "select a.value as value, a.value as again from generate_series(1, 40) a order by value desc limit 3",
        ] {
            let whole = optimized(&session, sql).await;
            let Some(cut) = Cut::of(&whole) else {
                // A filter above a limit needs all rows first.
                assert!(sql.contains("id % 2"), "{sql}");
                continue;
            };
            let mut found = Vec::new();
            for range in cut.ids.pieces(100) {
                found.extend(rows(&session, cut.query(range).expect("ranges can be replaced")).await);
            }
            let joined = rows(&session, cut.join(&found).expect("rows can be joined")).await;
            let text = |rows: &[RecordBatch]| pretty_format_batches(rows).expect("rows can be printed").to_string();
            assert_eq!(text(&rows(&session, whole).await), text(&joined), "{sql}");
        }
    }

    #[tokio::test]
    async fn what_depends_on_more_than_its_row_is_not_cut() {
        let session = SessionContext::new();
        for sql in [
            "select count(*) from range(0, 1000)",
            "select distinct value % 7 from range(0, 1000)",
            "select value, row_number() over (order by value) from range(0, 1000)",
            "select value from range(0, 1000) where value > (select avg(value) from range(0, 10))",
            "select a.value from range(0, 1000) a join range(0, 10) b on a.value = b.value",
            "select value, random() from range(0, 1000)",
            "select value from range(0, 1000) limit 5",
            "select value from range(0, 1000) where value % 7 = 3 limit 5",
            "select 1",
        ] {
            assert!(Cut::of(&optimized(&session, sql).await).is_none(), "{sql}");
        }
    }
}
