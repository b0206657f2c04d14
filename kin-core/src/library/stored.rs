//! The mechanisms of the library can be stored.

#[allow(clippy::wildcard_imports, reason = "all mechanisms are meant")]
use super::*;

macro_rules! storable {
    ($($mechanism:ident)+) => {
        crate::storable! { $($mechanism),+ }
    };
}

crate::each_library_mechanism!(storable);
