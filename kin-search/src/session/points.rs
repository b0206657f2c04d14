//! Tables of wanted points, written into a query.

use std::collections::{HashMap, VecDeque};

use datafusion::arrow::array::AsArray;
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{DataType, Float64Type};
use datafusion::common::tree_node::{Transformed, TreeNode, TreeNodeRecursion};
use datafusion::common::{Result, ScalarValue, plan_err};
use datafusion::logical_expr::{Expr, LogicalPlan};
use datafusion::prelude::SessionContext;
use datafusion::sql::parser::{DFParser, Statement};

use crate::function::{ENDING, Points, text_of};

/// The statements of a text, in their order.
///
/// # Errors
/// Returns an error if the text is not SQL.
pub fn statements(sql: &str) -> Result<VecDeque<Statement>> {
    DFParser::parse_sql(sql)
}

/// The plan of a statement, with the tables of wanted points that it names written into it.
///
/// The functions of path errors name a table of points. This function reads the table once, and replaces its name by
/// its points. So the points go with the query, as any constant does: to all threads, and to the executors of a
/// cluster, which have no tables.
///
/// # Errors
/// Returns the errors of the engine, and an error if a table of points is not there, or does not have the columns x and
/// y, or input, x and y.
pub async fn plan(session: &SessionContext, statement: Statement) -> Result<LogicalPlan> {
    let plan = session.state().statement_to_plan(statement).await?;
    let mut texts: HashMap<String, String> = HashMap::new();
    for name in named(&plan)? {
        let text = read(session, &name).await?;
        texts.insert(name, text);
    }
    if texts.is_empty() {
        return Ok(plan);
    }
    let written = plan.transform_up_with_subqueries(|plan| {
        plan.map_expressions(|expression| {
            expression.transform_up(|expression| {
                Ok(match expression {
                    Expr::ScalarFunction(mut call) if is_of_points(call.name()) => {
                        let text = call
                            .args
                            .first()
                            .and_then(text_in)
                            .and_then(|name| texts.get(name))
                            .cloned();
                        if let (Some(text), Some(first)) = (text, call.args.first_mut()) {
                            *first = Expr::Literal(ScalarValue::Utf8(Some(text)), None);
                        }
                        Transformed::yes(Expr::ScalarFunction(call))
                    }
                    other => Transformed::no(other),
                })
            })
        })
    })?;
    Ok(written.data)
}

/// Whether the first argument of a function is a text of points.
fn is_of_points(function: &str) -> bool {
    function.strip_suffix(ENDING).is_some_and(|name| name.ends_with('_'))
}

/// The constant text of an argument.
fn text_in(argument: &Expr) -> Option<&str> {
    match argument {
        Expr::Literal(
            ScalarValue::Utf8(Some(text)) | ScalarValue::Utf8View(Some(text)) | ScalarValue::LargeUtf8(Some(text)),
            _,
        ) => Some(text),
        Expr::Cast(cast) => text_in(&cast.expr),
        Expr::Alias(alias) => text_in(&alias.expr),
        _ => None,
    }
}

/// The names of tables of points in a plan.
fn named(plan: &LogicalPlan) -> Result<Vec<String>> {
    let mut names: Vec<String> = Vec::new();
    plan.apply_with_subqueries(|plan| {
        plan.apply_expressions(|expression| {
            expression.apply(|expression| {
                if let Expr::ScalarFunction(call) = expression
                    && is_of_points(call.name())
                    && let Some(text) = call.args.first().and_then(text_in)
                    && !names.iter().any(|name| name == text)
                    && Points::parse(text).is_err()
                {
                    names.push(text.to_owned());
                }
                Ok(TreeNodeRecursion::Continue)
            })
        })
    })?;
    Ok(names)
}

/// The points of a table as text.
async fn read(session: &SessionContext, name: &str) -> Result<String> {
    if !session.table_exist(name)? {
        if name.contains([' ', ';']) {
            // the message about the point that is none
            Points::parse(name)?;
        }
        return plan_err!(
            "there is no table `{name}`, and it is no list of points: write the name of a table with the columns x and \
             y, or points as in '0 1; 0.5 1.2'"
        );
    }
    let table = session.table(name).await?;
    let has = |column: &str| table.schema().has_column_with_unqualified_name(column);
    let columns: &[&str] = match (has("input"), has("x") && has("y")) {
        (true, true) => &["input", "x", "y"],
        (false, true) => &["x", "y"],
        (_, false) => return plan_err!("the table {name} has no columns x and y, and so no points"),
    };
    let mut rows: Vec<Vec<f64>> = Vec::new();
    for batch in table.select_columns(columns)?.collect().await? {
        let numbers: Vec<_> = batch
            .columns()
            .iter()
            .map(|column| Ok(cast(column, &DataType::Float64)?))
            .collect::<Result<_>>()?;
        for row in 0..batch.num_rows() {
            if numbers.iter().any(|column| column.is_null(row)) {
                return plan_err!("a point of the table {name} is null");
            }
            rows.push(
                numbers
                    .iter()
                    .map(|column| column.as_primitive::<Float64Type>().value(row))
                    .collect(),
            );
        }
    }
    Ok(text_of(&rows))
}
