//! A session of queries in this process: its functions and its limits.

mod points;

use std::sync::Arc;

use datafusion::common::Result;
use datafusion::execution::runtime_env::RuntimeEnvBuilder;
use datafusion::execution::session_state::{SessionState, SessionStateBuilder};
use datafusion::prelude::{SessionConfig, SessionContext};

pub use points::{plan, statements};

use crate::function::{Functions, Settings};

/// The limits of a session.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// The memory that a query may take, in bytes. A query that needs more ends with an error, or writes to the disk
    /// where its operators can.
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
    // The engine would copy a call of a turn to each use of its fields, and solve the turn once for each of them.
    config.options_mut().optimizer.enable_leaf_expression_pushdown = false;
    match options.partitions {
        Some(partitions) => config.with_target_partitions(partitions.max(1)),
        None => config,
    }
}

/// The state of a session: these functions beside those of SQL.
///
/// A cluster's scheduler makes its sessions by it too, with the settings of the client.
///
/// # Errors
/// Returns an error of the engine if it cannot be set up.
pub fn state(functions: &Functions, config: SessionConfig, options: &Options) -> Result<SessionState> {
    let mut runtime = RuntimeEnvBuilder::new();
    if let Some(memory) = options.memory {
        runtime = runtime.with_memory_limit(memory, 1.0);
    }
    let mut state = SessionStateBuilder::new()
        .with_config(config)
        .with_runtime_env(Arc::new(runtime.build()?))
        .with_default_features()
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
/// let rows = session.sql("select four_bar(90, 30, 60, 45, 1.134, -10)['theta4_velocity'] as v").await?.collect().await?;
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
    use super::{Options, session};
    use crate::Functions;

    #[tokio::test]
    async fn a_turn_is_solved_once_for_all_its_fields() {
        let session = session(&Functions::library(), &Options::default()).expect("a session");
        let sql = "select min(turn['theta4_peak_snap']) as snap from (
                select four_bar_turn(1, candidate(value, 1, 1, 0.1, 1.0), 1.5, 1.5) as turn from range(0, 100)
            ) where turn['rotates'] and turn['theta4_swing'] > 1";
        let plan = session.sql(sql).await.expect("the query is right");
        let plan = plan.into_optimized_plan().expect("it can be optimized");
        let text = plan.display_indent().to_string();
        assert_eq!(text.matches("four_bar_turn(").count(), 1, "{text}");
    }
}
