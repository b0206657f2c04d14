//! The settings of a query that go with it to every process.

use datafusion::common::config::{ConfigExtension, ConfigOptions};
use datafusion::common::{Result, extensions_options, plan_err};
use kin_core::batch::Vectors;

extensions_options! {
    /// The settings of kin's functions: `set kin.vectors = 'avx2'` in SQL.
    ///
    /// Fused products round differently from separate ones. A query that must give the same digits on machines of
    /// several kinds fixes the kind of vectors: `compiled` or `avx2`. `avx512` rounds Newton's method differently where
    /// a processor works on 512 bits in halves. It is `widest` otherwise, those of the machine.
    pub struct Settings {
        /// The kind of vectors.
        pub vectors: String, default = "widest".to_owned()
    }
}

impl ConfigExtension for Settings {
    const PREFIX: &'static str = "kin";
}

/// The kind of vectors that a query wants.
pub(crate) fn vectors(options: &ConfigOptions) -> Result<Vectors> {
    let Some(settings) = options.extensions.get::<Settings>() else {
        return Ok(Vectors::widest());
    };
    let vectors = match settings.vectors.as_str() {
        "widest" => Vectors::widest(),
        "compiled" => Vectors::Compiled,
        "avx2" => Vectors::Avx2,
        "avx512" => Vectors::Avx512,
        other => return plan_err!("kin.vectors is `{other}`; write 'widest', 'compiled', 'avx2' or 'avx512'"),
    };
    if vectors.are_there() {
        Ok(vectors)
    } else {
        plan_err!("this machine has no {vectors:?} vectors, which the query asks for by kin.vectors")
    }
}
