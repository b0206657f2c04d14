//! The decisions about a schedule.

use crate::passes::Passes;

/// The decisions about a schedule that may differ.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    /// Whether shared factors are taken out of sums. Factors that depend on the position alone are multiplied first and
    /// kept together.
    pub(crate) takes_out_factors: bool,
    /// Whether functions that are not defined everywhere are checked, in the first stage.
    pub(crate) check_domains: bool,
    pub(crate) passes: Passes,
}

impl Style {
    /// A style in which nothing is taken out and nothing is checked.
    pub(crate) const fn plain(passes: Passes) -> Self {
        Self {
            takes_out_factors: false,
            check_domains: false,
            passes,
        }
    }

    /// A style in which the domains of functions are checked.
    pub(crate) const fn checked(passes: Passes) -> Self {
        Self {
            check_domains: true,
            ..Self::plain(passes)
        }
    }
}
