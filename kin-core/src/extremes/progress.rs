//! How far a question has come.

use alloc::boxed::Box;
use core::cell::{Cell, RefCell};

/// The progress of a question, which never goes back: a question that meets a gap is asked again.
pub(super) struct Progress<'p> {
    tell: RefCell<Box<dyn FnMut(f64) + 'p>>,
    told: Cell<f64>,
}

impl<'p> Progress<'p> {
    pub(super) fn new(tell: Box<dyn FnMut(f64) + 'p>) -> Self {
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

    /// Tells that all is done. The next question begins again.
    pub(super) fn end(&self) {
        self.told.set(0.0);
        (self.tell.borrow_mut())(1.0);
    }
}
