//! A rule of the optimizer: a revolution is summarised in those fields only that the query uses.

use std::any::Any;
use std::collections::{BTreeSet, HashMap, HashSet};

use datafusion::common::tree_node::{Transformed, TreeNode, TreeNodeRecursion};
use datafusion::common::{Result, ScalarValue};
use datafusion::functions::core::getfield::GetFieldFunc;
use datafusion::logical_expr::expr::ScalarFunction;
use datafusion::logical_expr::expr_rewriter::NamePreserver;
use datafusion::logical_expr::{Expr, LogicalPlan};
use datafusion::optimizer::{OptimizerConfig, OptimizerRule};

use crate::function::{TurnFunction, used};

/// Adds to each call of a function such as `four_bar_turn` the names of the fields that are used.
///
/// A column is known by its name alone, without its table. Two columns of one name share their uses, so that a field
/// too many is calculated, and none too few.
#[derive(Debug)]
pub(super) struct OnlyUsedFields;

impl OptimizerRule for OnlyUsedFields {
    fn name(&self) -> &'static str {
        "only_used_fields"
    }

    fn rewrite(&self, plan: LogicalPlan, _: &dyn OptimizerConfig) -> Result<Transformed<LogicalPlan>> {
        if !has_revolutions(&plan)? {
            return Ok(Transformed::no(plan));
        }
        let uses = Uses::of(&plan)?;
        plan.transform_down_with_subqueries(|node| {
            // Other expressions, such as keys of joins, are sent to executors in other ways.
            if !matches!(node, LogicalPlan::Projection(_)) {
                return Ok(Transformed::no(node));
            }
            let names = NamePreserver::new(&node);
            node.map_expressions(|expression| {
                let name = names.save(&expression);
                Ok(uses
                    .with_used_fields(expression)?
                    .update_data(|expression| name.restore(expression)))
            })
        })
    }
}

/// The fields that a query uses of each column, by the name of the column. A column that is used as a whole is not
/// here.
struct Uses(HashMap<String, BTreeSet<String>>);

impl Uses {
    fn of(plan: &LogicalPlan) -> Result<Self> {
        let mut fields: HashMap<String, BTreeSet<String>> = HashMap::new();
        let mut whole: HashSet<String> = columns(plan).collect();
        plan.apply_with_subqueries(|node| {
            if !names_what_it_uses(node) {
                whole.extend(node.inputs().into_iter().flat_map(columns));
            }
            node.apply_expressions(|expression| match expression {
                // The column keeps its name, by which those above use it.
                Expr::Column(_) if matches!(node, LogicalPlan::Projection(_)) => Ok(TreeNodeRecursion::Continue),
                used => used.apply(|part| {
                    if let Some((Expr::Column(column), field)) = field_of(part) {
                        fields.entry(column.name.clone()).or_default().insert(field.to_owned());
                        return Ok(TreeNodeRecursion::Jump);
                    }
                    if let Expr::Column(column) | Expr::OuterReferenceColumn(_, column) = part {
                        whole.insert(column.name.clone());
                    }
                    Ok(TreeNodeRecursion::Continue)
                }),
            })
        })?;
        fields.retain(|column, _| !whole.contains(column));
        Ok(Self(fields))
    }

    /// An expression of a projection, with the used fields at its calls.
    fn with_used_fields(&self, expression: Expr) -> Result<Transformed<Expr>> {
        if let Expr::Alias(alias) = &expression
            && is_revolution(&alias.expr)
        {
            let Some(fields) = self.0.get(&alias.name) else {
                return Ok(Transformed::no(expression));
            };
            let fields = fields.iter().map(String::as_str);
            return expression.map_children(|call| Ok(Transformed::yes(with_fields(call, fields.clone()))));
        }
        expression.transform_down(|part| {
            if !field_of(&part).is_some_and(|(whole, _)| is_revolution(whole)) {
                return Ok(Transformed::no(part));
            }
            let Expr::ScalarFunction(mut of_field) = part else {
                return Ok(Transformed::no(part));
            };
            if let [call, Expr::Literal(name, _), ..] = of_field.args.as_mut_slice()
                && let Some(Some(name)) = name.try_as_str()
            {
                *call = with_fields(std::mem::take(call), [name]);
            }
            Ok(Transformed::yes(Expr::ScalarFunction(of_field)))
        })
    }
}

/// The names of the columns of a plan.
fn columns(plan: &LogicalPlan) -> impl Iterator<Item = String> {
    plan.schema().fields().iter().map(|field| field.name().clone())
}

/// Whether a node uses nothing but what its expressions name. It may hand other columns on, under their names.
fn names_what_it_uses(node: &LogicalPlan) -> bool {
    matches!(
        node,
        LogicalPlan::Projection(_)
            | LogicalPlan::Filter(_)
            | LogicalPlan::Sort(_)
            | LogicalPlan::Limit(_)
            | LogicalPlan::Aggregate(_)
            | LogicalPlan::Window(_)
            | LogicalPlan::Join(_)
            | LogicalPlan::Repartition(_)
            | LogicalPlan::SubqueryAlias(_)
            | LogicalPlan::TableScan(_)
            | LogicalPlan::EmptyRelation(_)
            | LogicalPlan::Values(_)
    )
}

/// The structure of which an expression is one field, and the name of the field.
fn field_of(expression: &Expr) -> Option<(&Expr, &str)> {
    let Expr::ScalarFunction(ScalarFunction { func, args }) = expression else {
        return None;
    };
    let function: &dyn Any = func.inner().as_ref();
    match args.as_slice() {
        [whole, Expr::Literal(name, _), ..] if function.is::<GetFieldFunc>() => {
            Some((whole, ScalarValue::try_as_str(name)??))
        }
        _ => None,
    }
}

/// Whether an expression is a call of a function of revolutions that does not name its fields yet.
fn is_revolution(expression: &Expr) -> bool {
    let Expr::ScalarFunction(ScalarFunction { func, args }) = expression else {
        return false;
    };
    let function: &dyn Any = func.inner().as_ref();
    function.is::<TurnFunction>() && !matches!(args.last(), Some(Expr::Literal(ScalarValue::List(_), _)))
}

fn has_revolutions(plan: &LogicalPlan) -> Result<bool> {
    let mut found = false;
    plan.apply_with_subqueries(|node| {
        node.apply_expressions(|expression| {
            found |= expression.exists(|part| Ok(is_revolution(part)))?;
            Ok(if found {
                TreeNodeRecursion::Stop
            } else {
                TreeNodeRecursion::Continue
            })
        })
    })?;
    Ok(found)
}

fn with_fields<'f>(call: Expr, fields: impl IntoIterator<Item = &'f str>) -> Expr {
    match call {
        Expr::ScalarFunction(mut call) => {
            call.args.push(used::argument(fields));
            Expr::ScalarFunction(call)
        }
        other => other,
    }
}
