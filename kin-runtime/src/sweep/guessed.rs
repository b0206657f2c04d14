//! Questions to a sweep that does not say yet how its inputs move. Each leads the compiler to a message that names what
//! is missing.
//!
//! No program can ask them: they ask for a condition that never holds.

/// A sweep that says how its inputs move. [`Assembled`](super::Assembled) does not.
#[diagnostic::on_unimplemented(
    message = "the sweep does not say how its inputs move",
    label = "say it before: `.over(0.0..=TAU, 361)` for a single input, `.between([..], [..], rows)` for several, \
             `.under_laws([&law], 0.0..=1.0, rows)` over time",
    note = "`over_time` and `by_formula` take a function of the time, and `along` takes columns"
)]
pub trait Moves {
    /// The answer.
    fn answer<A>(&self) -> A;
}

/// Methods of [`Assembled`] that nobody can call.
macro_rules! questions {
    ($($question:ident($($argument:ident)*) -> $answer:ty;)+) => {
        impl<M: $crate::mechanism::Mechanism<Scalar = f64>> $crate::sweep::Assembled<M> {
            $(
                #[doc(hidden)]
                pub fn $question<$($argument),*>(&self, $(_: $argument),*) -> $answer
                where
                    Self: $crate::sweep::guessed::Moves,
                {
                    $crate::sweep::guessed::Moves::answer(self)
                }
            )+
        }
    };
}

questions! {
    speed(S) -> &Self;
    rows() -> core::iter::Empty<Result<M::Pose, crate::failure::SolveError>>;
}

#[cfg(feature = "alloc")]
questions! {
    table() -> Result<super::Table, super::SweepError>;
    adaptive_table(T O R) -> Result<super::Table, super::SweepError>;
}
