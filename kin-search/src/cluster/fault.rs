//! The errors of a cluster.

use std::path::PathBuf;
use std::{error, fmt, io};

use ballista_core::error::BallistaError;
use datafusion::error::DataFusionError;

use super::address::{Endpoint, Listen};
use super::identity::Identity;

/// Why a process of a cluster ended, or a search did not finish.
#[derive(Debug)]
#[non_exhaustive]
pub enum Fault {
    /// The address cannot be listened on.
    Address(Listen, io::Error),
    /// The scheduler listens on all addresses of the machine, and executors need one of them.
    Nameless(Listen),
    /// The system grants no handlers of signals.
    Signals(io::Error),
    /// The scheduler refuses this process: it has another version, other functions or other vectors.
    Refused {
        /// The identity of this process.
        here: String,
        /// The identity of the scheduler, as the scheduler reports it.
        there: String,
    },
    /// The scheduler cannot be reached, or was lost while it worked.
    Lost {
        /// Its address.
        scheduler: Endpoint,
        /// The report of the connection.
        report: String,
        /// The rest of the search, and advice on how it goes on.
        advice: String,
    },
    /// The scheduler was started again while it worked, and does not know the query.
    Restarted {
        /// Its address.
        scheduler: Endpoint,
        /// The rest of the search, and advice on how it goes on.
        advice: String,
    },
    /// The process at the address of the scheduler is no scheduler: it may be an executor.
    Another(Endpoint),
    /// A query lost more executors than one machine that failed explains.
    Executors {
        /// The part of the search that was queried.
        name: String,
        /// The number of executors that were lost.
        count: usize,
        /// The rest of the search, and advice on how it goes on.
        advice: String,
    },
    /// A query needs more memory than an executor has.
    Memory {
        /// The memory that was asked for, and the memory that was free.
        report: String,
    },
    /// The search was interrupted, and its work on executors has been called off.
    Interrupted {
        /// The rest of the search, and advice on how it goes on.
        advice: String,
    },
    /// A folder or file cannot be read or written.
    File(PathBuf, io::Error),
    /// The engine reports an error.
    Engine(Box<DataFusionError>),
    /// Ballista reports an error.
    Cluster(Box<BallistaError>),
}

impl Fault {
    /// The refusal of a scheduler, if the text of an error holds one.
    pub(super) fn refusal(here: &Identity, text: &str) -> Option<Self> {
        // The errors around the refusal quote it.
        let there = text[text.find("refused: ")?..].split(['"', '\\', '\n']).next()?;
        Some(Self::Refused {
            here: here.to_string(),
            there: there.to_owned(),
        })
    }

    /// A lack of memory on an executor, if the text of an error holds one.
    pub(super) fn memory(text: &str) -> Option<Self> {
        let (_, report) = text.split_once("ResourcesExhausted(")?;
        Some(Self::Memory {
            report: report
                .trim_start_matches(['"', '\\'])
                .split(['"', '\\'])
                .next()?
                .to_owned(),
        })
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Address(address, error) => write!(f, "cannot listen on {}: {error}", address.0),
            Self::Nameless(address) => write!(
                f,
                "{} is no address that executors can call back; give one with --host",
                address.0.ip()
            ),
            Self::Signals(error) => write!(f, "cannot listen for signals: {error}"),
            Self::Refused { here, there } => write!(
                f,
                "the scheduler refuses this process.\n  here:  {here}\n  there: {there}"
            ),
            Self::Lost {
                scheduler,
                report,
                advice,
            } => write!(f, "the scheduler at {scheduler} does not answer ({report}). {advice}"),
            Self::Restarted { scheduler, advice } => write!(
                f,
                "the scheduler at {scheduler} was started again, and does not know the query. {advice}"
            ),
            Self::Another(endpoint) => write!(
                f,
                "what listens at {endpoint} is no scheduler; give the address that `kin-search scheduler` has printed"
            ),
            Self::Executors { name, count, advice } => write!(
                f,
                "{name}: {count} executors were lost, one after the other. If it needs more memory than they have, \
                 give executors a limit with --memory, or make the ranges smaller with --range. {advice}"
            ),
            Self::Memory { report } => write!(
                f,
                "an executor has too little memory for the query: {report}. Give it more with --memory, or make the \
                 ranges smaller with --range."
            ),
            Self::Interrupted { advice } => write!(
                f,
                "interrupted. The query is cancelled; an executor may finish the list of ids on which it works. \
                 {advice}"
            ),
            Self::File(path, error) => write!(f, "{}: {error}", path.display()),
            Self::Engine(error) => error.fmt(f),
            Self::Cluster(error) => error.fmt(f),
        }
    }
}

impl error::Error for Fault {}

impl From<DataFusionError> for Fault {
    fn from(error: DataFusionError) -> Self {
        Self::Engine(Box::new(error))
    }
}

impl From<BallistaError> for Fault {
    fn from(error: BallistaError) -> Self {
        Self::Cluster(Box::new(error))
    }
}
