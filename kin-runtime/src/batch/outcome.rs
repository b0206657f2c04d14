//! The outcomes of a batch.

use core::error::Error;
use core::fmt;

use crate::failure::{Failure, SolveError};
use crate::quantity::Name;

/// The outcome of one pose.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub enum Outcome {
    /// The pose has not been solved yet.
    #[default]
    Unsolved,
    /// The pose is found, and all its numbers are finite.
    Solved,
    /// The mechanism does not close. The numbers of the pose are NaN.
    OutOfReach {
        /// The missing length as a negative number, as in [`Failure::OutOfReach`].
        margin: f64,
    },
    /// The position is singular, for example a limit position. The numbers of the pose are NaN.
    Singular,
    /// There is no pose for another reason, which `solve` reports. The numbers of the pose are NaN.
    Failed,
}

impl Outcome {
    /// Whether the pose is found.
    #[inline]
    #[must_use]
    pub const fn is_solved(&self) -> bool {
        matches!(self, Self::Solved)
    }

    /// The missing length as a negative number, if the mechanism does not close.
    #[inline]
    #[must_use]
    pub const fn margin(&self) -> Option<f64> {
        match self {
            Self::OutOfReach { margin } => Some(*margin),
            _ => None,
        }
    }
}

impl From<&SolveError> for Outcome {
    fn from(error: &SolveError) -> Self {
        match error.failure {
            Failure::OutOfReach { margin } => Self::OutOfReach { margin },
            Failure::Singular { .. } => Self::Singular,
            _ => Self::Failed,
        }
    }
}

/// The outcome of a whole batch.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Summary {
    /// The number of poses found.
    pub solved: usize,
    /// The number of found poses that had to be solved alone instead of together with others. The solver for one pose
    /// goes further than the solver for several at once: it handles huge angles, damped iterations and decisions close
    /// to rounding. If this number is large, a batch saves little.
    pub alone: usize,
    /// The number of poses not found.
    pub failed: usize,
    /// The failed pose with the lowest index, and the error of `solve` for it.
    pub first_failure: Option<(usize, SolveError)>,
}

impl Summary {
    /// The part of the poses that are found, 0 ..= 1, or `None` if there are no poses.
    #[must_use]
    pub fn share_solved(&self) -> Option<f64> {
        let count = self.solved + self.failed;
        #[expect(clippy::cast_precision_loss, reason = "nobody solves 2⁵³ poses")]
        let share = self.solved as f64 / count as f64;
        (count > 0).then_some(share)
    }

    /// The summary of two parts of a batch.
    pub(super) fn and(self, other: Self) -> Self {
        let first_failure = match (self.first_failure, other.first_failure) {
            (Some(one), Some(other)) if other.0 < one.0 => Some(other),
            (one, other) => one.or(other),
        };
        Self {
            solved: self.solved + other.solved,
            alone: self.alone + other.alone,
            failed: self.failed + other.failed,
            first_failure,
        }
    }

    /// Counts poses as failed that were counted as solved before.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn fail(&mut self, count: usize) {
        self.solved -= count;
        self.failed += count;
    }

    /// Records the outcome of a pose that was solved alone, and that was counted as solved before.
    pub(super) fn note(&mut self, index: usize, result: Result<(), SolveError>) -> Outcome {
        let Err(error) = result else {
            self.alone += 1;
            return Outcome::Solved;
        };
        self.solved -= 1;
        self.failed += 1;
        let outcome = Outcome::from(&error);
        if self.first_failure.is_none_or(|(first, _)| index < first) {
            self.first_failure = Some((index, error));
        }
        outcome
    }
}

/// The error for a column whose length differs from the number of poses.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct LengthMismatch {
    /// The quantity of the column.
    pub quantity: Name,
    /// The number of poses, which is the number of outcomes given.
    pub poses: usize,
    /// The length of the column.
    pub length: usize,
}

impl fmt::Display for LengthMismatch {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            quantity,
            poses,
            length,
        } = self;
        write!(
            formatter,
            "a column of `{quantity}` has {length} entries, but there are {poses} outcomes: give one entry and one \
             outcome for each pose"
        )
    }
}

crate::__debug_by_display!(LengthMismatch);

impl Error for LengthMismatch {}

#[cfg(test)]
mod tests {
    use super::{Outcome, Summary};
    use crate::failure::{Failure, InputValues, SolveError};

    fn error(failure: Failure) -> SolveError {
        failure.at("theta3, theta4", InputValues::new(&[], &[]))
    }

    const OUT_OF_REACH: Failure = Failure::OutOfReach { margin: -0.25 };
    const SINGULAR: Failure = Failure::Singular { determinant: 0.0 };

    /// An error of `solve` becomes the outcome with the same cause. Only a loop that does not close has a margin.
    #[test]
    fn an_outcome_tells_the_cause_of_its_error() {
        let outcome = |failure| Outcome::from(&error(failure));
        assert_eq!(outcome(OUT_OF_REACH), Outcome::OutOfReach { margin: -0.25 });
        assert_eq!(outcome(OUT_OF_REACH).margin(), Some(-0.25));
        assert_eq!(outcome(SINGULAR), Outcome::Singular);
        assert_eq!(outcome(Failure::not_finite("r1")), Outcome::Failed);
        for other in [Outcome::Unsolved, Outcome::Solved, Outcome::Singular, Outcome::Failed] {
            assert_eq!(other.margin(), None);
            assert_eq!(other.is_solved(), other == Outcome::Solved);
        }
    }

    /// A pose counts either as solved or as failed. The failure with the lowest index is kept, in any order of arrival.
    #[test]
    fn notes_keep_the_failure_of_the_lowest_index() {
        let mut summary = Summary {
            solved: 10,
            ..Summary::default()
        };
        assert_eq!(summary.note(7, Ok(())), Outcome::Solved);
        assert_eq!((summary.solved, summary.alone, summary.failed), (10, 1, 0));
        assert_eq!(summary.first_failure, None);
        assert_eq!(summary.note(5, Err(error(SINGULAR))), Outcome::Singular);
        assert_eq!(
            summary.note(3, Err(error(OUT_OF_REACH))),
            Outcome::OutOfReach { margin: -0.25 }
        );
        assert_eq!(summary.note(8, Err(error(SINGULAR))), Outcome::Singular);
        assert_eq!((summary.solved, summary.alone, summary.failed), (7, 1, 3));
        assert_eq!(summary.first_failure, Some((3, error(OUT_OF_REACH))));
    }

    /// The summaries of two parts add up. The first failure is the one with the lower index, in whichever part it lies.
    #[cfg(feature = "rayon")]
    #[test]
    fn summaries_of_parts_add_up() {
        let part = |first_failure| Summary {
            solved: 5,
            alone: 3,
            failed: 2,
            first_failure,
        };
        let (early, late) = (Some((4, error(SINGULAR))), Some((9, error(OUT_OF_REACH))));
        let first_of = |one, other| part(one).and(part(other)).first_failure;
        assert_eq!(first_of(early, late), early);
        assert_eq!(first_of(late, early), early);
        assert_eq!(first_of(None, late), late);
        assert_eq!(first_of(late, None), late);
        assert_eq!(first_of(None, None), None);
        let both = part(None).and(Summary {
            solved: 7,
            alone: 1,
            failed: 4,
            first_failure: None,
        });
        assert_eq!((both.solved, both.alone, both.failed), (12, 4, 6));
    }
}
