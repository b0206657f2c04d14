//! The decisions about a schedule.

use crate::passes::Passes;

/// What may be decided about a schedule.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    /// Whether factors that terms of a sum share are taken out. Those of the position alone are multiplied by each other first, and
    /// not torn apart.
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

    /// The same style, in which shared factors are taken out.
    pub(crate) const fn with_factors_taken_out(self) -> Self {
        Self {
            takes_out_factors: true,
            ..self
        }
    }
}
