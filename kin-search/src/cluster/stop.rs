//! The reasons for which a query on the cluster is called off.

use std::future::pending;

use tokio::sync::watch;

/// Reports to a query that it is called off: because the process is interrupted, or because another range of its search
/// has failed.
#[derive(Clone, Debug)]
pub(super) struct Stop {
    pub(super) interrupted: watch::Receiver<bool>,
    /// The search of which the query is a range.
    pub(super) search: Option<watch::Receiver<bool>>,
}

impl Stop {
    /// Whether the query is called off.
    pub(super) fn has_come(&self) -> bool {
        *self.interrupted.borrow() || self.search.as_ref().is_some_and(|search| *search.borrow())
    }

    /// Waits until the query is called off.
    pub(super) async fn come(&mut self) {
        let search = async {
            match &mut self.search {
                Some(search) => reached(search).await,
                None => pending().await,
            }
        };
        tokio::select! {
            () = reached(&mut self.interrupted) => {}
            () = search => {}
        }
    }
}

/// Waits until a flag is set.
pub(super) async fn reached(flag: &mut watch::Receiver<bool>) {
    if flag.wait_for(|set| *set).await.is_err() {
        // Nobody is left who could set it.
        pending::<()>().await;
    }
}
