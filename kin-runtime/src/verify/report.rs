//! The report of a verification.

use core::fmt;
use std::string::String;

use super::Worst;

/// The result of a verification, displayed as a table.
///
/// ```
/// use kin_core::library::SliderCrank;
/// use kin_core::verify;
///
/// let report = verify::mechanism::<SliderCrank>();
/// assert!(report.passed());
/// assert!(report.to_string().starts_with("SliderCrank: passed, "));
/// ```
#[derive(Clone, Debug, PartialEq)]
#[must_use = "a report that is not looked at proves nothing: call `assert` or `passed`"]
pub struct Report {
    /// The name of the mechanism.
    pub name: String,
    /// The worst errors, and the number of poses.
    pub worst: Worst,
    /// The number of combinations of dimensions and inputs drawn.
    pub tried: usize,
    /// The number of them for which the mechanism closed in some assembly.
    pub closed: usize,
    /// The number of poses needed to pass.
    pub needed: usize,
    /// The seed of the random numbers.
    pub seed: u64,
    /// The numbers that carry derivatives through the position solution: `dual numbers` or `truncated Taylor series`.
    pub numbers: &'static str,
}

impl Report {
    /// Whether there were enough poses, and all errors are within the [`allowed`](super::allowed) number of units.
    #[must_use]
    pub fn passed(&self) -> bool {
        self.has_enough_poses() && self.worst.is_allowed()
    }

    /// Asserts that the verification [passed](Self::passed).
    ///
    /// # Panics
    /// Panics if it did not. The message is the table.
    #[track_caller]
    pub fn assert(&self) {
        assert!(self.passed(), "{self}");
    }

    const fn has_enough_poses(&self) -> bool {
        self.worst.poses > 0 && self.worst.poses >= self.needed
    }
}

impl fmt::Display for Report {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let verdict = match (self.worst.is_allowed(), self.has_enough_poses()) {
            (false, _) => "FAILED",
            (true, false) => "NOT VERIFIED, too few poses",
            (true, true) => "passed",
        };
        writeln!(
            formatter,
            "{}: {verdict}, {} poses; closed at {} of {} draws, seed {}",
            self.name, self.worst.poses, self.closed, self.tried, self.seed
        )?;
        if self.worst.poses > 0 {
            writeln!(
                formatter,
                "worst errors in units of the condition and the motion, differentiation by {}:",
                self.numbers
            )?;
            write!(formatter, "{}", self.worst)?;
        }
        if !self.worst.is_allowed()
            && let Some(finding) = &self.worst.finding
        {
            write!(formatter, "\nworst of all: {finding}")?;
        }
        if !self.has_enough_poses() {
            write!(
                formatter,
                "\n{} poses are needed: give dimensions and input ranges at which the mechanism closes, with \
                 `verify::of`",
                self.needed.max(1)
            )?;
        }
        Ok(())
    }
}
