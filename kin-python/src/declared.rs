//! What a declaration declares.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError, Weak};

use kin_core::any::{Described, Description, Quantity};
use kin_core::{Dimension, RATES};
use kin_live::DeclareError;

/// A mechanism and the text that declares it.
#[derive(Debug)]
pub(crate) struct Declared {
    pub(crate) mechanism: kin_live::Mechanism,
    pub(crate) text: String,
    fitted: OnceLock<&'static kin_live::Mechanism>,
}

/// The mechanisms that are in use, by their texts: a text is compiled once, also where a thousand linkages of it are
/// unpickled.
static IN_USE: Mutex<BTreeMap<String, Weak<Declared>>> = Mutex::new(BTreeMap::new());

impl Declared {
    /// The mechanism that a text declares.
    pub(crate) fn of(text: String) -> Result<Arc<Self>, (DeclareError, String)> {
        let in_use = || IN_USE.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = in_use().get(&text).and_then(Weak::upgrade) {
            return Ok(known);
        }
        let mechanism = match kin_live::Mechanism::declare(&text) {
            Ok(mechanism) => mechanism,
            Err(error) => return Err((error, text)),
        };
        let declared = Arc::new(Self {
            mechanism,
            text: text.clone(),
            fitted: OnceLock::new(),
        });
        let mut in_use = in_use();
        in_use.retain(|_, known| known.strong_count() > 0);
        in_use.insert(text, Arc::downgrade(&declared));
        Ok(declared)
    }

    pub(crate) fn description(&self) -> &Description<'_> {
        self.mechanism.description()
    }

    /// The mechanism for fits, which ask for one that stays. Once asked for, it stays in memory, once for each text.
    pub(crate) fn for_fits(self: &Arc<Self>) -> &'static kin_live::Mechanism {
        self.fitted.get_or_init(|| {
            let kept: &'static Arc<Self> = Box::leak(Box::new(Arc::clone(self)));
            &kept.mechanism
        })
    }

    /// The quantity of a column of tables, and the order of its derivative.
    pub(crate) fn column(&self, name: &str) -> Option<(&Quantity<'_>, usize)> {
        let description = self.description();
        let kinds = [description.inputs, description.unknowns, description.outputs];
        kinds.into_iter().flatten().find_map(|quantity| {
            let order = match name.strip_prefix(quantity.name)? {
                "" => 0,
                rest => 1 + RATES.iter().position(|rate| rest.strip_prefix('_') == Some(*rate))?,
            };
            Some((quantity, order))
        })
    }

    /// The number of derivatives, and one for the position.
    pub(crate) fn orders(&self) -> usize {
        self.description().order + 1
    }
}

/// The word for what a quantity measures.
pub(crate) fn measure(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Angle => "angle",
        Dimension::Length => "length",
        Dimension::Scalar => "number",
    }
}
