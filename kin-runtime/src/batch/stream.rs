//! Columns that do not fit into the caches: their lines are stored past them.
//!
//! An ordinary store reads its cache line from the memory before it changes it. A non-temporal store of a whole line
//! reads nothing. If every column starts at the same place of its line, chunks of many numbers are stored so at once.
//! Otherwise a chunk starts anywhere within a line, and in each column elsewhere. Then chunks of vectors of 512 bits,
//! which are whole lines, go to stages, from which the lines of the columns are stored. With narrower vectors stages
//! take longer than they save.
#![expect(
    unsafe_code,
    reason = "lines are stored by their addresses, with vectors of a machine that has them"
)]

use core::cell::Cell;

use super::destination::{Destination, Entries, EntriesOf, Ordinary, ViewOf, Way, numbers};
use super::line::{LINE, fence, have_lines, store_lines};
use super::view::View;
use crate::batch::lanes::{Element, Lanes, for_each_lane};
use crate::mechanism::Mechanism;
use crate::number::{Number, Row};

/// The bytes of columns from which on hardly any of them are still in a cache when all have been stored. Tests have
/// fewer poses.
const LONG: usize = if cfg!(test) { 1 << 15 } else { 1 << 25 };

/// The number of chunks after one with a failure that are stored as usual, because poses fail beside each other.
const CALM: usize = 64;

/// Numbers of a pose that hardly wait for the memory. Tests have fewer.
const FEW: usize = if cfg!(test) { 0 } else { 16 };

/// The number of chunks on a stage.
const CHUNKS: usize = 2;

/// Room for the last numbers of a column: two chunks, behind those that share a line with the first number.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(super) struct Stage<E, const W: usize>([[E; W]; CHUNKS + 1]);

/// The columns of all numbers, as chunks are stored in them.
type Chunks<'s, M, const W: usize> = Destination<M, ViewOf<'s, M, W>>;

/// The way of chunks into the columns of a batch, past the caches if that is faster.
pub(super) struct Streams<'s, 'd, M: Mechanism<Scalar: Element>, const W: usize, const BITS: usize> {
    columns: &'s Destination<M, EntriesOf<'d, M>>,
    /// The place for numbers that are not wanted.
    spare: &'s [Cell<M::Scalar>; W],
    /// The numbers before the first whole line of every column, if chunks that are lines go past the caches at once.
    before_lines: Option<usize>,
    staged: Option<Staged<'s, M, W>>,
    /// The pose from which on chunks may go past the caches.
    calm: usize,
}

/// The stages of the columns that are wanted.
struct Staged<'s, M: Mechanism<Scalar: Element>, const W: usize> {
    stages: Destination<M, EntriesOf<'s, M>>,
    /// The paths of the columns that are wanted, from the chunk at the pose `first` on.
    paths: Destination<M, Option<Path<'s, M::Scalar, W>>>,
    first: usize,
    /// Whether no chunk shares a line with the one before.
    are_lines: bool,
    /// The pose with which the next chunk on the stages starts. It is `None` if nothing is on them.
    next: Option<usize>,
    /// The place of that chunk.
    place: usize,
}

/// The numbers on the stage of a column and those in the column, from the start of the same line on.
#[derive(Clone, Copy)]
struct Path<'s, E, const W: usize> {
    stage: View<'s, Cell<E>, W>,
    column: View<'s, Cell<E>, W>,
}

impl<'s, 'd, M: Mechanism<Scalar: Element>, const W: usize, const BITS: usize> Streams<'s, 'd, M, W, BITS> {
    /// Whether chunks may go past the caches at once, for which the kernel is compiled once more. Few numbers hardly
    /// wait for the memory. The numbers of Newton's method depend on those beside them, so that its chunks do not start
    /// where lines do.
    pub(super) const PAST: bool = have_lines(BITS) && M::ASSEMBLY_COUNT > 0 && numbers::<M>() > FEW;

    /// Whether chunks may go to stages.
    const HAVE_STAGES: bool = have_lines(BITS) && BITS == 8 * LINE;

    /// The way into the columns of a batch, which may be a piece of one of so many poses. Chunks from a given pose on
    /// may go past the caches.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(
        columns: &'s Destination<M, EntriesOf<'d, M>>,
        whole: usize,
        calm: usize,
        room: &'s mut Option<Destination<M, Stage<M::Scalar, W>>>,
        spare: &'s [Cell<M::Scalar>; W],
    ) -> Self {
        let (mut before_lines, mut staged) = (None, None);
        if const { Self::PAST || Self::HAVE_STAGES } && columns.are_filled() && columns.bytes(whole) >= LONG {
            if const { Self::PAST } {
                before_lines = columns.before_lines();
            }
            if const { Self::HAVE_STAGES } && before_lines.is_none() {
                let zero = M::Scalar::constant(0.0);
                let room = room.insert(Destination::splat(Stage([[zero; W]; CHUNKS + 1])));
                staged = Some(Staged::new(columns, room));
            }
        }
        Self {
            columns,
            spare,
            before_lines,
            staged,
            calm,
        }
    }

    /// Whether a chunk that starts at a given pose goes past the caches at once.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn passes(&self, start: usize) -> bool {
        let entry = start % const { LINE / size_of::<M::Scalar>() };
        start >= self.calm && self.before_lines == Some(entry)
    }

    /// Stores the motions of a chunk that starts at a given pose, which [passes](Self::passes) the caches or not.
    /// Returns the [sum](Destination::store) of all numbers.
    ///
    /// Chunks that go to stages turn to other columns. These are copied, because a choice between two references makes
    /// a small linkage a twentieth slower.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn store<const PASSES: bool, R: Row<Lanes<W, BITS, M::Scalar>>>(
        &mut self,
        start: usize,
        chunks: &mut Chunks<'s, M, W>,
        unknowns: &[R],
        sines: &[Option<Lanes<W, BITS, M::Scalar>>],
        outputs: &[R],
    ) -> Lanes<W, BITS, M::Scalar> {
        if PASSES {
            return chunks.store(Past, start, unknowns, sines, outputs);
        }
        let first = self.turn(start, chunks);
        chunks.store(Ordinary, first, unknowns, sines, outputs)
    }

    /// Turns to the columns in which a chunk that starts at a given pose is stored, and returns the pose at which it
    /// starts there.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn turn(&mut self, start: usize, chunks: &mut Chunks<'s, M, W>) -> usize {
        if const { Self::HAVE_STAGES }
            && let Some(staged) = &mut self.staged
        {
            if staged.next != Some(start) {
                if staged.unload(self.columns, 0) {
                    *chunks = self.columns.in_chunks(self.spare);
                }
                if start < self.calm {
                    return start;
                }
                *chunks = staged.load(self.columns, start, self.spare);
            }
            return staged.place * W;
        }
        start
    }

    /// Goes on after a chunk without failures.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn advance(&mut self) {
        if const { Self::HAVE_STAGES }
            && let Some(staged) = &mut self.staged
        {
            staged.advance::<BITS>();
        }
    }

    /// Moves the chunk that starts at a given pose into the columns, where poses that have failed are settled.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn interrupt(&mut self, start: usize, chunks: &mut Chunks<'s, M, W>) {
        if const { Self::HAVE_STAGES }
            && let Some(staged) = &mut self.staged
        {
            let chunk = if staged.next == Some(start) { W } else { 0 };
            if staged.unload(self.columns, chunk) {
                *chunks = self.columns.in_chunks(self.spare);
            }
        }
        self.calm = start + CALM * W;
    }

    /// Moves the last numbers into the columns.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn end(&mut self) {
        if const { Self::HAVE_STAGES }
            && let Some(staged) = &mut self.staged
        {
            staged.unload(self.columns, 0);
        }
        if self.before_lines.is_some() || self.staged.is_some() {
            fence();
        }
    }
}

impl<'s, M: Mechanism<Scalar: Element>, const W: usize> Staged<'s, M, W> {
    #[cold]
    #[inline(never)]
    fn new(columns: &Destination<M, EntriesOf<'_, M>>, room: &'s mut Destination<M, Stage<M::Scalar, W>>) -> Self {
        let mut stages = Destination::nowhere();
        for ((stages, room), columns) in stages.rows_mut().zip(room.rows_mut()).zip(columns.rows()) {
            for ((stage, Stage(room)), column) in stages.iter_mut().zip(room).zip(columns) {
                if !column.is_empty() {
                    *stage = Cell::from_mut(room.as_flattened_mut()).as_slice_of_cells();
                }
            }
        }
        Self {
            stages,
            paths: Destination::splat(None),
            first: 0,
            are_lines: false,
            next: None,
            place: 0,
        }
    }

    /// Calls a function with each column that is wanted, and with its stage.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn each(
        &self,
        columns: &Destination<M, EntriesOf<'_, M>>,
        mut function: impl FnMut(EntriesOf<'_, M>, EntriesOf<'_, M>),
    ) {
        for (columns, stages) in columns.rows().zip(self.stages.rows()) {
            for (column, stage) in columns.iter().zip(stages) {
                if !stage.is_empty() {
                    function(column, stage);
                }
            }
        }
    }

    /// Begins with the chunk that starts at a given pose. The numbers before it are in the columns. Returns the places
    /// of chunks on the stages.
    #[cold]
    #[inline(never)]
    fn load(
        &mut self,
        columns: &'s Destination<M, EntriesOf<'_, M>>,
        start: usize,
        spare: &'s [Cell<M::Scalar>; W],
    ) -> Chunks<'s, M, W> {
        (self.first, self.next, self.place, self.are_lines) = (start, Some(start), 0, true);
        let mut places = Destination::nowhere();
        let rows = columns.rows().zip(self.stages.rows());
        for (((columns, stages), paths), places) in rows.zip(self.paths.rows_mut()).zip(places.rows_mut()) {
            let columns = columns.iter().zip(stages).zip(paths).zip(places);
            for (((column, stage), path), place) in columns.filter(|(((_, stage), _), _)| !stage.is_empty()) {
                let before = in_line_before(column, start);
                let (from, to) = (&stage[W - before..], &column[start - before..]);
                copy(&to[..before], from);
                *path = Some(Path {
                    stage: View::each(from, spare),
                    column: View::each(to, spare),
                });
                *place = &stage[W..];
                self.are_lines &= before == 0;
            }
        }
        places.in_chunks(spare)
    }

    /// Copies the numbers that are not in the columns yet into them, with so many of the next chunk. Returns whether
    /// chunks went to the stages.
    #[cold]
    #[inline(never)]
    fn unload(&mut self, columns: &Destination<M, EntriesOf<'_, M>>, more: usize) -> bool {
        let Some(next) = self.next.take() else {
            return false;
        };
        let place = (self.place + 1) * W;
        self.each(columns, |column, stage| {
            let before = in_line_before(column, next);
            copy(&stage[place - before..place + more], &column[next - before..]);
        });
        true
    }

    /// Stores the lines that end in the next chunk.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn advance<const BITS: usize>(&mut self) {
        let Some(next) = self.next else {
            return;
        };
        let (place, pose) = (self.place * W, next - self.first);
        for Path { stage, column } in self.paths.rows().flatten().flatten() {
            // SAFETY: the column starts with a line there, as a chunk consists of lines. Only a machine with AVX-512
            // comes here, by `HAVE_STAGES`.
            unsafe { store_lines::<W, BITS, _>(stage.chunk(place).as_ptr().cast(), column.chunk(pose)) };
        }
        self.next = Some(next + W);
        self.place = (self.place + 1) % CHUNKS;
        if self.place == 0 && !self.are_lines {
            // numbers that share a line with the next ones go to the front
            for stage in self.stages.rows().flatten() {
                if let (Some(front), Some(end)) = (stage.first_chunk::<W>(), stage.last_chunk::<W>()) {
                    let numbers = Lanes::<W, BITS, _>::from_fn(|lane| end[lane].get());
                    for_each_lane!(lane in 0..W {
                        front[lane].set(numbers.0[lane]);
                    });
                }
            }
        }
    }
}

/// The numbers of a column before a pose that share a line with its number.
#[cfg_attr(not(debug_assertions), inline(always))]
fn in_line_before<E>(column: Entries<'_, E>, pose: usize) -> usize {
    (column.as_ptr().addr() / size_of::<E>() + pose) % (LINE / size_of::<E>())
}

fn copy<E: Copy>(from: Entries<'_, E>, to: Entries<'_, E>) {
    for (from, to) in from.iter().zip(to) {
        to.set(from.get());
    }
}

/// The way past the caches. Only [`Streams::store`] sends chunks there.
#[derive(Clone, Copy)]
struct Past;

impl<E: Element, const W: usize, const BITS: usize> Way<View<'_, Cell<E>, W>, Lanes<W, BITS, E>> for Past {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn store(self, numbers: Lanes<W, BITS, E>, column: View<'_, Cell<E>, W>, start: usize) {
        // SAFETY: only chunks that pass the caches go this way, with vectors that have lines: each of them is wanted,
        // and every column starts with a line at this pose.
        unsafe { store_lines::<W, BITS, E>(numbers.0.as_ptr(), column.chunk(start)) }
    }
}
