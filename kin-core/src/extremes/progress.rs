//! How far a question has come.

use core::cell::{Cell, RefCell};

/// The progress of a question, which never goes back: a question that meets a gap is asked again.
pub(super) struct Progress<F> {
    tell: RefCell<F>,
    told: Cell<f64>,
}

impl<F: FnMut(f64)> Progress<F> {
    pub(super) fn new(tell: F) -> Self {
        Self {
            tell: RefCell::new(tell),
            told: Cell::new(0.0),
        }
    }

    /// Tells the part that is done, unless it has been told. The whole is told by [`end`](Self::end).
    pub(super) fn reach(&self, part: f64) {
        if part > self.told.get() && part < 1.0 {
            self.told.set(part);
            (self.tell.borrow_mut())(part);
        }
    }

    /// Tells that all is done.
    pub(super) fn end(self) {
        (self.tell.into_inner())(1.0);
    }
}
