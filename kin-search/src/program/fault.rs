//! The reasons why the program ends early.

use std::fmt;
use std::process::ExitCode;

use datafusion::error::DataFusionError;

/// The exit code by which shells know an interrupt.
pub(crate) const INTERRUPTED: u8 = 130;

/// The reason why the program ends without an answer.
#[derive(Debug)]
pub(crate) enum Fault {
    /// The request or a file has a mistake.
    Wrong(String),
    /// Somebody has pressed Ctrl-C.
    Interrupted,
    /// Somebody has pressed Ctrl-C, and the work of a cluster has been called off.
    #[cfg(feature = "cluster")]
    CalledOff(String),
}

impl Fault {
    /// The exit code: 1, or the one by which shells know an interrupt.
    pub(crate) fn code(&self) -> ExitCode {
        match self {
            Self::Wrong(_) => ExitCode::FAILURE,
            Self::Interrupted => ExitCode::from(INTERRUPTED),
            #[cfg(feature = "cluster")]
            Self::CalledOff(_) => ExitCode::from(INTERRUPTED),
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Wrong(message) => write!(formatter, "error: {message}"),
            Self::Interrupted => formatter.write_str("the query is cancelled"),
            #[cfg(feature = "cluster")]
            Self::CalledOff(message) => formatter.write_str(message),
        }
    }
}

impl From<DataFusionError> for Fault {
    fn from(error: DataFusionError) -> Self {
        Self::Wrong(error.strip_backtrace())
    }
}

#[cfg(feature = "cluster")]
impl From<kin_search::cluster::Fault> for Fault {
    fn from(fault: kin_search::cluster::Fault) -> Self {
        match fault {
            kin_search::cluster::Fault::Engine(error) => (*error).into(),
            kin_search::cluster::Fault::Interrupted { .. } => Self::CalledOff(fault.to_string()),
            fault => Self::Wrong(fault.to_string()),
        }
    }
}
