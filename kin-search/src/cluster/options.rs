//! Settings of a query that travel with it.

use std::any::Any;

use datafusion::common::config::{ConfigEntry, ConfigExtension, ExtensionOptions};
use datafusion::common::{Result, plan_err};

/// The identity of a client and the settings of its query, which go with the query to all processes.
///
/// The structure is written by hand: settings of the engine's macro are sent without their prefix, and are lost.
#[derive(Clone, Debug, Default)]
pub(super) struct Caller {
    /// The tag of the client's identity. The scheduler refuses every other tag than its own.
    pub(super) identity: String,
    /// The kind of vectors of kin's functions.
    pub(super) vectors: String,
}

impl ConfigExtension for Caller {
    const PREFIX: &'static str = "kin_client";
}

impl ExtensionOptions for Caller {
    fn as_any(&self) -> &dyn Any {
        self
    }

    fn as_any_mut(&mut self) -> &mut dyn Any {
        self
    }

    fn cloned(&self) -> Box<dyn ExtensionOptions> {
        Box::new(self.clone())
    }

    fn set(&mut self, key: &str, value: &str) -> Result<()> {
        let field = match key {
            "identity" => &mut self.identity,
            "vectors" => &mut self.vectors,
            other => return plan_err!("kin_client has no setting {other}"),
        };
        value.clone_into(field);
        Ok(())
    }

    fn entries(&self) -> Vec<ConfigEntry> {
        let entry = |key: &str, value: &str, description| ConfigEntry {
            key: key.to_owned(),
            value: (!value.is_empty()).then(|| value.to_owned()),
            description,
        };
        vec![
            entry(
                "kin_client.identity",
                &self.identity,
                "the version and the functions of the client",
            ),
            entry("kin_client.vectors", &self.vectors, "the kind of vectors of the query"),
            // The same for the functions, which read it there.
            entry("kin.vectors", &self.vectors, "the kind of vectors of the query"),
        ]
    }
}
