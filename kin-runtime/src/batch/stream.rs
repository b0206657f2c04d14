//! Columns that do not fit into the caches: their lines are stored past them.
//!
//! An ordinary store reads its cache line from the memory before it changes it. A non-temporal store of a whole line
//! reads nothing. But a chunk starts anywhere within a line, and in each column elsewhere. So chunks go to stages, from
//! which the lines of the columns are stored. Vectors of 512 bits are whole lines; with narrower ones this takes longer
//! than it saves.
#![cfg_attr(
    all(feature = "std", target_arch = "x86_64"),
    expect(
        unsafe_code,
        reason = "an instruction stores a line by its address, and may be used on a machine that has it"
    )
)]

use core::cell::Cell;

use super::destination::{Destination, Entries, EntriesOf, LINE, ViewOf};
use crate::batch::lanes::Element;
use crate::mechanism::Mechanism;
use crate::number::Number;

/// The bytes of columns from which on hardly any of them are still in a cache when all have been stored. Tests have
/// fewer poses.
const LONG: usize = if cfg!(test) { 1 << 15 } else { 1 << 25 };

/// The number of chunks after one with a failure that are stored as usual, because poses fail beside each other.
const CALM: usize = 64;

/// The number of chunks on a stage.
const CHUNKS: usize = 2;

/// Room for the last numbers of a column: two chunks, behind those that share a line with the first number.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(super) struct Stage<E, const W: usize>([[E; W]; CHUNKS + 1]);

/// The columns of all numbers, as chunks are stored in them.
type Chunks<'s, M, const W: usize> = Destination<M, ViewOf<'s, M, W>>;

/// The way of chunks into the columns of a batch, which leads over stages if that is faster.
pub(super) struct Streams<'s, 'd, M: Mechanism<Scalar: Element>, const W: usize, const BITS: usize> {
    columns: &'s Destination<M, EntriesOf<'d, M>>,
    /// The place for numbers that are not wanted.
    spare: &'s [Cell<M::Scalar>; W],
    staged: Option<Staged<'s, M, W>>,
    /// The pose from which on chunks may go to the stages.
    calm: usize,
}

/// The stages of the columns that are wanted.
struct Staged<'s, M: Mechanism<Scalar: Element>, const W: usize> {
    stages: Destination<M, EntriesOf<'s, M>>,
    /// The pose with which the next chunk on the stages starts. It is `None` if nothing is on them.
    next: Option<usize>,
    /// The place of that chunk.
    place: usize,
}

impl<'s, 'd, M: Mechanism<Scalar: Element>, const W: usize, const BITS: usize> Streams<'s, 'd, M, W, BITS> {
    /// Whether vectors of so many bits are lines that can be stored past the caches. It is tested in constants, so that
    /// stages are compiled for these vectors only.
    const HAVE_LINES: bool = cfg!(all(feature = "std", target_arch = "x86_64")) && BITS == 8 * LINE;

    /// The way into the columns of a batch, which may be a piece of one of so many poses. Chunks from a given pose on
    /// may go to the stages.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(
        columns: &'s Destination<M, EntriesOf<'d, M>>,
        whole: usize,
        calm: usize,
        room: &'s mut Option<Destination<M, Stage<M::Scalar, W>>>,
        spare: &'s [Cell<M::Scalar>; W],
    ) -> Self {
        let mut staged = None;
        if const { Self::HAVE_LINES } && columns.are_filled() && columns.bytes(whole) >= LONG {
            let zero = M::Scalar::constant(0.0);
            let room = room.insert(Destination::splat(Stage([[zero; W]; CHUNKS + 1])));
            staged = Some(Staged::new(columns, room));
        }
        Self {
            columns,
            spare,
            staged,
            calm,
        }
    }

    /// Turns to the columns in which a chunk that starts at a given pose is stored, and returns the pose at which it
    /// starts there.
    ///
    /// The columns are copied, because a choice between two references makes a small linkage a twentieth slower.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn turn(&mut self, start: usize, chunks: &mut Chunks<'s, M, W>) -> usize {
        if const { Self::HAVE_LINES }
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
        if const { Self::HAVE_LINES }
            && let Some(staged) = &mut self.staged
        {
            staged.advance(self.columns);
        }
    }

    /// Moves the chunk that starts at a given pose into the columns, where poses that have failed are settled.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn interrupt(&mut self, start: usize, chunks: &mut Chunks<'s, M, W>) {
        if const { Self::HAVE_LINES }
            && let Some(staged) = &mut self.staged
        {
            let chunk = if staged.next == Some(start) { W } else { 0 };
            if staged.unload(self.columns, chunk) {
                *chunks = self.columns.in_chunks(self.spare);
            }
            self.calm = start + CALM * W;
        }
    }

    /// Moves the last numbers into the columns.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn end(&mut self) {
        if const { Self::HAVE_LINES }
            && let Some(staged) = &mut self.staged
        {
            staged.unload(self.columns, 0);
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
        columns: &Destination<M, EntriesOf<'_, M>>,
        start: usize,
        spare: &'s [Cell<M::Scalar>; W],
    ) -> Chunks<'s, M, W> {
        self.each(columns, |column, stage| {
            let before = in_line_before(column, start);
            copy(&column[start - before..start], &stage[W - before..]);
        });
        (self.next, self.place) = (Some(start), 0);
        let mut places = Destination::nowhere();
        for (places, stages) in places.rows_mut().zip(self.stages.rows()) {
            for (place, stage) in places.iter_mut().zip(stages) {
                *place = stage.get(W..).unwrap_or_default();
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
    fn advance(&mut self, columns: &Destination<M, EntriesOf<'_, M>>) {
        if let Some(next) = self.next {
            let place = self.place;
            self.each(columns, |column, stage| store_lines::<_, W>(column, next, stage, place));
            self.next = Some(next + W);
            self.place = (place + 1) % CHUNKS;
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

/// Stores the lines of a column that end in a chunk, which starts at the pose `next` and lies at a place of the stage.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[cfg_attr(not(debug_assertions), inline(always))]
fn store_lines<E: Element, const W: usize>(column: Entries<'_, E>, next: usize, stage: Entries<'_, E>, place: usize) {
    use core::arch::x86_64::__m512i;
    let before = in_line_before(column, next);
    debug_assert!(column.len() >= next + W && stage.len() == (CHUNKS + 1) * W);
    // SAFETY: `before` numbers lie before the chunk, on the stage as well, since they share a line with its first and
    // a chunk has at least a line. From there on `W` numbers are stored, which are whole lines: the first one begins
    // with a line of the column. Both slices consist of cells, which may be changed, and contain the chunk. Only a
    // machine with AVX-512 comes here, by `HAVE_LINES`.
    unsafe {
        let from = stage.as_ptr().add((place + 1) * W - before).cast::<__m512i>();
        let to = column.as_ptr().add(next - before).cast::<__m512i>().cast_mut();
        let mut line = 0;
        while line < const { W * size_of::<E>() / LINE } {
            store_line(from.add(line), to.add(line));
            line += 1;
        }
        if place == CHUNKS - 1 {
            // what is left for the next line goes to the front
            let line = LINE / size_of::<E>();
            let [front, end] = [W, (CHUNKS + 1) * W].map(|end| stage.as_ptr().add(end - line).cast::<[u64; 8]>());
            front.cast_mut().write(end.read());
        }
    }
}

/// Without such vectors nothing is on a stage.
#[cfg(not(all(feature = "std", target_arch = "x86_64")))]
fn store_lines<E: Element, const W: usize>(_: Entries<'_, E>, _: usize, _: Entries<'_, E>, _: usize) {}

/// # Safety
/// The machine must have AVX-512, and the second address must be that of a line.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[inline]
#[target_feature(enable = "avx512f")]
unsafe fn store_line(from: *const core::arch::x86_64::__m512i, to: *mut core::arch::x86_64::__m512i) {
    // SAFETY: the caller's
    unsafe { core::arch::x86_64::_mm512_stream_si512(to, from.read_unaligned()) }
}

/// Orders the lines that have been stored past the caches before all later stores, as others may expect.
fn fence() {
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    // SAFETY: every machine with vectors has this instruction.
    unsafe {
        core::arch::x86_64::_mm_sfence();
    }
}
