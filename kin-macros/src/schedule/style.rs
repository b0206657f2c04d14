//! The decisions about a schedule.

use crate::passes::Passes;

/// What becomes of factors that terms of a sum share.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Factors {
    /// They stay where they are.
    Left,
    /// They are taken out. Those of the position alone are multiplied by each other first, and not torn apart.
    TakenOut,
    /// The same, and what the position has computed in steps of its own is of the position.
    TakenOutOfRates,
}

/// What may be decided about a schedule.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    pub(crate) factors: Factors,
    /// Whether functions that are not defined everywhere are checked, in the first stage.
    pub(crate) check_domains: bool,
    pub(crate) passes: Passes,
}

impl Style {
    /// A style in which nothing is taken out and nothing is checked.
    pub(crate) const fn plain(passes: Passes) -> Self {
        Self {
            factors: Factors::Left,
            check_domains: false,
            passes,
        }
    }

    /// A style in which the domains of functions are checked.
    pub(crate) const fn checked(factors: Factors, passes: Passes) -> Self {
        Self {
            factors,
            check_domains: true,
            passes,
        }
    }
}
