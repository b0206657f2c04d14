//! A session of queries in this process: its functions, its limits, and the files that it writes.

mod drafts;
mod fields;
mod memory;
mod points;
mod rows;
mod signals;

use std::sync::Arc;

use datafusion::common::Result;
use datafusion::execution::runtime_env::RuntimeEnvBuilder;
use datafusion::execution::session_state::{SessionState, SessionStateBuilder};
use datafusion::prelude::{SessionConfig, SessionContext};

pub use drafts::Drafts;
#[cfg(feature = "cluster")]
pub(crate) use drafts::draft_of;
pub use points::{plan, statements};
pub use rows::rows;
pub use signals::Signals;

use crate::function::{Functions, Settings};

/// The limits of a session.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The memory that a query may take for what its sorts, groups and joins hold, in bytes, and for the rows of
    /// [`rows`]. A query that needs more ends with an error, or writes to the disk where its operators can. Tables that
    /// are made in memory do not count.
    pub memory: Option<usize>,
    /// The number of parts of a query that run at the same time, one for each core if it is not given.
    pub partitions: Option<usize>,
}

/// The configuration of a session: [`Settings`], and tables that describe the functions.
#[must_use]
pub fn config(options: &Options) -> SessionConfig {
    let mut config = SessionConfig::new()
        .with_information_schema(true)
        .with_option_extension(Settings::default());
    // The engine would copy a call to each use of its fields, and solve the revolution once for each use.
    config.options_mut().optimizer.enable_leaf_expression_pushdown = false;
    match options.partitions {
        Some(partitions) => config.with_target_partitions(partitions.max(1)),
        None => config,
    }
}

/// The state of a session: these functions beside those of SQL.
///
/// A cluster's scheduler makes its sessions by this function too, with the settings of the client.
///
/// # Errors
/// Returns an error of the engine if it cannot be set up.
pub fn state(functions: &Functions, config: SessionConfig, options: &Options) -> Result<SessionState> {
    let mut runtime = RuntimeEnvBuilder::new();
    if let Some(memory) = options.memory {
        runtime = runtime.with_memory_pool(memory::pool(memory));
    }
    let mut state = SessionStateBuilder::new()
        .with_config(config)
        .with_runtime_env(Arc::new(runtime.build()?))
        .with_default_features()
        .with_optimizer_rule(Arc::new(fields::OnlyUsedFields))
        .build();
    functions.register(&mut state)?;
    Ok(state)
}

/// A session of queries in this process.
///
/// # Errors
/// Returns an error of the engine if it cannot be set up.
///
/// ```
/// use kin_search::{Functions, Options, session};
///
/// # #[tokio::main(flavor = "current_thread")]
/// # async fn main() -> datafusion::error::Result<()> {
/// let session = session(&Functions::library(), &Options::default())?;
/// let query = "select four_bar(90, 30, 60, 45, 1.134, -10)['theta4_velocity'] as v";
/// let rows = session.sql(query).await?.collect().await?;
/// assert_eq!(rows[0].num_rows(), 1);
/// # Ok(())
/// # }
/// ```
pub fn session(functions: &Functions, options: &Options) -> Result<SessionContext> {
    Ok(SessionContext::new_with_state(state(
        functions,
        config(options),
        options,
    )?))
}

#[cfg(test)]
mod tests {
    use datafusion::arrow::util::pretty::pretty_format_batches;

    use datafusion::optimizer::OptimizerRule as _;

    use super::{Options, SessionStateBuilder, config, fields, session, state};
    use crate::Functions;

    /// The optimized plan of a query, as text.
    async fn optimized(sql: &str) -> String {
        let session = session(&Functions::library(), &Options::default()).expect("a session");
        let plan = session.sql(sql).await.expect("the query is right");
        let plan = plan.into_optimized_plan().expect("it can be optimized");
        plan.display_indent().to_string()
    }

    const CALL: &str = "four_bar_turn(1, candidate(value, 1, 1, 0.1, 1.0), 1.5, 1.5)";

    #[tokio::test]
    async fn one_solution_for_all_fields() {
        let text = optimized(&format!(
            "select min(turn['theta4_peak_snap']) as snap from (select {CALL} as turn from range(0, 100))
            where turn['rotates'] and turn['theta4_swing'] > 1"
        ))
        .await;
        assert_eq!(text.matches("four_bar_turn(").count(), 1, "{text}");
        assert!(
            text.contains("List([rotates, theta4_peak_snap, theta4_swing])"),
            "{text}"
        );
    }

    #[tokio::test]
    async fn handed_on_with_all_fields() {
        let range = "range(0, 100)";
        for whole in [
            format!("select {CALL} as turn from {range}"),
            format!("select turn, turn['closed'] as closed from (select {CALL} as turn from {range})"),
            format!(
                "select turn['closed'] as closed, turn is null as missing from (select {CALL} as turn from {range})"
            ),
            format!("select distinct turn from (select {CALL} as turn from {range})"),
            format!(
                "select turn['closed'] as closed from (select {CALL} as turn from {range} union all select {CALL} from \
                 {range})"
            ),
            format!("select first_value(turn order by turn['closed']) from (select {CALL} as turn from {range})"),
        ] {
            let text = optimized(&whole).await;
            assert!(
                text.contains("four_bar_turn(") && !text.contains("List(["),
                "{whole}\n{text}"
            );
        }
    }

    #[tokio::test]
    async fn rows_are_the_same_with_all_fields() {
        let few_fields = session(&Functions::library(), &Options::default()).expect("a session");
        let all = state(&Functions::library(), config(&Options::default()), &Options::default()).expect("a state");
        let mut rules = all.optimizers().to_vec();
        rules.retain(|rule| rule.name() != fields::OnlyUsedFields.name());
        let all = SessionStateBuilder::new_from_existing(all)
            .with_optimizer_rules(rules)
            .build();
        let all = datafusion::prelude::SessionContext::new_with_state(all);
        for query in [
            "select id, turn['where_min_transmission'] as input, turn['theta4_least'] as least, \
             turn['theta3_where_peak_jerk'] as jerk
            from (select value as id, four_bar_turn(1, 0.2 + 0.01 * value, 1.5, 1.5, 'crossed', 100) as turn
                  from range(0, 100))
            where turn['closed'] > 0.5 order by id",
            "select four_bar_turn(1, 0.2, 1.5, 0.5 + 0.01 * value)['theta4_peak_snap'] from range(0, 100)",
            "select value, \
             four_bar_turn(1, 0.2, 1.5, 1.5, case when value < 5 then null else 2.0 + value end)['theta4_swing'] \
             as swing
            from range(0, 10)",
            "with a as (select value as id, four_bar_turn(1, 0.2, 1.5, 1.5, 360, 1.0 + value) as turn from range(0, 9)),
            b as (select *, turn['theta4_peak_velocity'] as v from a)
            select b.id, b.v, b.turn['theta4_peak_snap'] as s
            from b join a on a.id = b.id and a.turn['closed'] = 1 order by 1",
            "select count(*) from range(0, 9) as r where 1.0 > (select max(turn['theta4_swing']) from
            (select four_bar_turn(1, 0.2, 1.5, 1.5) as turn from range(0, 2)))",
        ] {
            let (few, many) = (few_fields.sql(query).await, all.sql(query).await);
            let few = few.expect("the query is right").collect().await.expect("rows");
            let many = many.expect("the query is right").collect().await.expect("rows");
            assert_eq!(
                pretty_format_batches(&few).expect("a table").to_string(),
                pretty_format_batches(&many).expect("a table").to_string(),
            );
        }
    }
}
