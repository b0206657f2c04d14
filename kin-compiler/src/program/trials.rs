//! The decisions behind a program: the ways to derive it that were tried, and their costs.

use std::fmt::{self, Display, Formatter};

use super::Cost;

/// A way to derive a program.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Approach {
    /// Whether the equations were multiplied out before they were differentiated.
    pub(crate) is_multiplied_out: bool,
    /// Whether the mutual influences of the rates are collected in coefficients.
    pub(crate) has_influences: bool,
    /// Whether shared factors are taken out of sums.
    pub(crate) takes_out_factors: bool,
}

impl Display for Approach {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        formatter.write_str(if self.is_multiplied_out {
            "the equations multiplied out"
        } else {
            "the equations with their products left"
        })?;
        if self.has_influences {
            formatter.write_str(", with influence coefficients")?;
        }
        if self.takes_out_factors {
            formatter.write_str(", shared factors taken out")?;
        }
        Ok(())
    }
}

/// A way that was tried.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trial {
    pub(crate) way: Approach,
    pub(crate) cost: Cost,
}

/// All trials, and the way that was kept.
#[derive(Clone, Debug)]
pub(crate) struct Trials {
    pub(crate) all: Vec<Trial>,
    pub(crate) kept: Approach,
}

impl Display for Trials {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> fmt::Result {
        for Trial { way, cost } in &self.all {
            let mark = if *way == self.kept { '>' } else { ' ' };
            writeln!(
                formatter,
                "{mark} {:5} operations, weighted {:5}: {way}",
                cost.arithmetic(),
                cost.total()
            )?;
        }
        Ok(())
    }
}
