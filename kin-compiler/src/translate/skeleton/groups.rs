//! Sets that are united step by step.

/// Numbers from zero on, each in one set.
#[derive(Default)]
pub(super) struct Groups {
    parents: Vec<usize>,
}

impl Groups {
    /// A new number, in a separate set.
    pub(super) fn add(&mut self) -> usize {
        self.parents.push(self.parents.len());
        self.parents.len() - 1
    }

    /// The number that stands for the set: the smallest in it.
    pub(super) fn of(&self, mut number: usize) -> usize {
        while self.parents[number] != number {
            number = self.parents[number];
        }
        number
    }

    /// Makes one set of two. False if they were one.
    pub(super) fn unite(&mut self, one: usize, other: usize) -> bool {
        let (one, other) = (self.of(one), self.of(other));
        self.parents[one.max(other)] = one.min(other);
        one != other
    }
}
