//! The motion of a report: its drive over the range, in one assembly.

use kin_core::SolveError;
use kin_core::linkage::{AnyCycle, AnyLinkage, AnyPose, AnySweep};
use kin_core::sweep::{Laws, SmoothDrive, StraightLine};

use super::line::Line;
use super::shown::{ShownAssembly, between_values};
use crate::report::ReportError;

/// The rows of a sweep over the range.
pub(super) const ROWS: usize = 181;

/// A value of the variable, and the pose there.
pub(super) type At = (f64, Result<AnyPose, SolveError>);

/// The sweeps over the range. Closed forms and laws need one sweep. Along a line, coupled blocks are followed from a
/// position to both ends.
pub(super) struct Way<'m, D> {
    /// The sweep downwards comes first, if there are two.
    pub(super) sweeps: Vec<AnySweep<'m, D>>,
    /// The parts of the range in which the assembly closes, by its branches.
    closes: Vec<[f64; 2]>,
}

impl<'m, 'l> Way<'m, Laws<'l>> {
    pub(super) fn under_laws(sweep: AnySweep<'m, Laws<'l>>) -> Self {
        Self {
            sweeps: vec![sweep],
            closes: Vec::new(),
        }
    }
}

impl<'m> Way<'m, StraightLine> {
    pub(super) fn along(
        linkage: &AnyLinkage<'m>,
        line: &Line,
        range: [f64; 2],
        cycle: &AnyCycle<'_>,
        shown: &ShownAssembly,
    ) -> Result<Self, ReportError> {
        let [low, high] = range;
        let branch = shown.branches.first().map(|index| &cycle.branches()[*index]);
        let is_turning = branch.is_some_and(kin_core::cycle::Branch::is_full_revolution);
        let inside = |[from, to]: [f64; 2]| [from.max(low), to.min(high)];
        let closes = match branch {
            Some(_) if is_turning => vec![range],
            Some(branch) if shown.assembly.index().is_none() => vec![inside(branch.ends().map(|end| end.input))],
            _ => Vec::new(),
        };
        if shown.assembly.index().is_some() {
            return Ok(Self {
                sweeps: vec![line.sweep(linkage, &shown.assembly, range)],
                closes,
            });
        }
        let (at, near) = shown.start.clone();
        let start = match (shown.branches.first(), branch) {
            (Some(&index), Some(branch)) => {
                let ends = branch.ends().map(|end| end.input);
                let start = if is_turning {
                    low
                } else {
                    let [from, to] = inside(ends);
                    between_values(from, to)
                };
                let found = cycle.position_on(index, start);
                Some((start, found.map_err(|error| ReportError::ClosesNowhere { error })?))
            }
            _ => None,
        };
        let (start, near) = start.unwrap_or((at, near));
        let assembly = linkage.assembly_at(&line.inputs_at(start), &near);
        let mut sweeps = Vec::new();
        if start > low {
            sweeps.push(line.sweep(linkage, &assembly, [start, low]));
        }
        if start < high {
            sweeps.push(line.sweep(linkage, &assembly, [start, high]));
        }
        Ok(Self { sweeps, closes })
    }
}

impl<D: SmoothDrive> Way<'_, D> {
    /// The value at which two sweeps begin, if there are two.
    pub(super) fn start(&self) -> Option<f64> {
        match self.sweeps.as_slice() {
            [down, _] => Some(down.at(0)),
            _ => None,
        }
    }

    /// The way of the variable on which each sweep closes, if it is known.
    pub(super) fn lengths(&self) -> Option<Vec<f64>> {
        let [from, to] = *self.closes.first()?;
        let start = self.start()?;
        Some(vec![start - from, to - start])
    }

    /// The poses of the range in ascending order.
    #[expect(
        clippy::redundant_closure_for_method_calls,
        reason = "the method by its path has a lifetime of its own"
    )]
    pub(super) fn poses(&self) -> Vec<At> {
        self.ascending(|sweep| sweep.rows())
    }

    /// A property of each row of the sweeps, in the order of [`poses`](Self::poses).
    pub(super) fn ascending<T>(&self, of: impl Fn(&AnySweep<'_, D>) -> Vec<T>) -> Vec<T> {
        let mut all = Vec::new();
        for (number, sweep) in self.sweeps.iter().enumerate() {
            let mut rows = of(sweep);
            if sweep.at(0) > sweep.at(sweep.count() - 1) {
                rows.reverse();
            } else if number > 0 {
                // the row where both sweeps begin is there already
                rows.drain(..1);
            }
            all.append(&mut rows);
        }
        all
    }
}
