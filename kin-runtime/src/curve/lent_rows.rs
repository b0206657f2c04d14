//! Memory that the caller lends to a track, which allocates none itself.

/// Memory for rows of numbers. What is taken in a [scope](Self::scope) is free again behind it.
pub(crate) struct LentRows<'s>(&'s mut [f64]);

impl<'s> LentRows<'s> {
    pub(crate) const fn new(memory: &'s mut [f64]) -> Self {
        Self(memory)
    }

    /// A row of so many numbers, whatever they are.
    pub(crate) fn lend(&mut self, count: usize) -> &'s mut [f64] {
        let (row, rest) = core::mem::take(&mut self.0).split_at_mut(count);
        self.0 = rest;
        row
    }

    /// The row of the numbers `function(index)`.
    pub(crate) fn row(&mut self, count: usize, function: impl FnMut(usize) -> f64) -> &'s [f64] {
        self.filled(count, function)
    }

    /// [`row`](Self::row) whose numbers change.
    pub(crate) fn filled(&mut self, count: usize, mut function: impl FnMut(usize) -> f64) -> &'s mut [f64] {
        let row = self.lend(count);
        for (index, value) in row.iter_mut().enumerate() {
            *value = function(index);
        }
        row
    }

    /// The same memory, for a while.
    pub(crate) const fn scope(&mut self) -> LentRows<'_> {
        LentRows(self.0)
    }
}
