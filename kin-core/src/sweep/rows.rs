//! A sweep as an iterator of poses.

use super::walk::Walk;
use super::{Course, Drive};
use crate::failure::SolveError;
use crate::mechanism::Mechanism;

/// The poses of a sweep, one after the other, as [`Course::rows`] returns them.
#[derive(Clone)]
pub struct Rows<'s, M: Mechanism<Scalar = f64>, D> {
    course: &'s Course<M, D>,
    walk: Walk<M>,
    next: usize,
}

impl<'s, M: Mechanism<Scalar = f64>, D: Drive<M>> Rows<'s, M, D> {
    pub(super) fn new(course: &'s Course<M, D>) -> Self {
        Self {
            course,
            walk: Walk::BEGINNING,
            next: 0,
        }
    }
}

impl<M: Mechanism<Scalar = f64>, D: Drive<M>> Iterator for Rows<'_, M, D> {
    type Item = Result<M::Pose, SolveError>;

    fn next(&mut self) -> Option<Self::Item> {
        let course = self.course;
        if self.next >= course.count {
            return None;
        }
        let at = course.at(self.next);
        self.next += 1;
        let reached = self.walk.step(course, at, course.drive.motions(at));
        Some(reached.map(|reached| reached.pose))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let rest = self.course.count - self.next;
        (rest, Some(rest))
    }
}

impl<M: Mechanism<Scalar = f64>, D: Drive<M>> ExactSizeIterator for Rows<'_, M, D> {}
