//! How far a question has come.

use alloc::boxed::Box;
use core::cell::{Cell, RefCell};

/// The progress of a question, which never goes back: a question that meets a gap is asked again.
pub(super) struct Progress<'p> {
    report: RefCell<Box<dyn FnMut(f64) + 'p>>,
    reported: Cell<f64>,
}

impl<'p> Progress<'p> {
    pub(super) fn new(report: Box<dyn FnMut(f64) + 'p>) -> Self {
        Self {
            report: RefCell::new(report),
            reported: Cell::new(0.0),
        }
    }

    /// Reports the part that is done, unless it has been reported. The whole is reported by [`end`](Self::end).
    pub(super) fn reach(&self, part: f64) {
        if part > self.reported.get() && part < 1.0 {
            self.reported.set(part);
            (self.report.borrow_mut())(part);
        }
    }

    /// Reports that all is done. The next question begins again.
    pub(super) fn end(&self) {
        self.reported.set(0.0);
        (self.report.borrow_mut())(1.0);
    }
}
