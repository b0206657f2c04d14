//! The division of the ranges into pieces, the worst first.

use alloc::collections::BinaryHeap;
use alloc::vec::Vec;
use core::cmp::Ordering;

use super::forces::{Piece, Reach, Sample, Wanted, middle};
use super::{ForcePlace, ForceProof, ForceVerdict, PeakBounds, ProofError, UndecidedForce, UndecidedReason};

/// The longest piece of an input at first, as a part of its range.
const LONGEST: f64 = 1.0 / 16.0;
/// The shortest, in which no pose is proved.
const SHORTEST: f64 = 1.0 / 16_777_216.0;
/// The shortest piece of a variable, as a part of its largest value: in shorter ones rounding decides.
const NARROWEST: f64 = 1e-12;

/// By so much the derivative by another variable must be less certain than that by the input.
const MORE: f64 = 32.0;

/// A piece with what is known of the force over it.
struct Known {
    piece: Piece,
    upper: f64,
    slopes: Option<Vec<[f64; 2]>>,
}

impl PartialEq for Known {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Known {}

impl PartialOrd for Known {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Known {
    fn cmp(&self, other: &Self) -> Ordering {
        self.upper.total_cmp(&other.upper)
    }
}

struct Search<'p> {
    proof: &'p ForceProof<'p>,
    lead: usize,
    sample: Sample<'p>,
    whole: Vec<[f64; 2]>,
    waiting: BinaryHeap<Known>,
    best: Option<ForcePlace>,
    pieces: usize,
    /// Where the poses end that are proved.
    gap: Option<[f64; 2]>,
}

/// Whether a search may end with the force that is known and the bound of the rest, and how.
enum Step<T> {
    Done(T),
    Divide,
}

pub(super) fn below(proof: &ForceProof<'_>, wanted: Wanted, limit: f64) -> Result<ForceVerdict, ProofError> {
    let mut search = Search::new(proof, wanted)?;
    let found = search.run(|search, upper| match &search.best {
        Some(best) if best.force > limit => Step::Done(ForceVerdict::Fails(best.clone())),
        _ if upper <= limit => Step::Done(ForceVerdict::Holds {
            upper,
            pieces: search.pieces,
        }),
        _ => Step::Divide,
    });
    Ok(match (found, search.gap) {
        (Ok(ForceVerdict::Holds { upper, .. }), Some(range)) => {
            ForceVerdict::Undecided(search.undecided(range, upper, UndecidedReason::Pose))
        }
        (Ok(verdict), _) => verdict,
        (Err(undecided), _) => ForceVerdict::Undecided(undecided),
    })
}

pub(super) fn peak(proof: &ForceProof<'_>, wanted: Wanted, part: f64) -> Result<PeakBounds, ProofError> {
    let mut search = Search::new(proof, wanted)?;
    if let Some(range) = search.gap {
        let undecided = search.undecided(range, f64::INFINITY, UndecidedReason::Pose);
        return Err(ProofError::Undecided(undecided));
    }
    let found = search.run(|search, upper| match &search.best {
        Some(best) if upper <= best.force * (1.0 + part) => Step::Done(PeakBounds {
            lower: best.clone(),
            upper,
            pieces: search.pieces,
        }),
        _ => Step::Divide,
    });
    found.map_err(ProofError::Undecided)
}

impl<'p> Search<'p> {
    /// The poses over the whole range, from its beginning on.
    fn new(proof: &'p ForceProof<'p>, wanted: Wanted) -> Result<Self, ProofError> {
        let lead = proof.lead().ok_or(ProofError::NoMotion)?;
        let whole = proof.ranges(lead);
        let [from, to] = whole[0];
        let mut place = middle(&whole);
        place[0] = from;
        let mut near = proof.start(lead, &place)?;
        let mut pieces: Vec<Piece> = Vec::new();
        let mut gap = None;
        let (mut begin, mut step) = (from, (to - from) * LONGEST);
        while begin != to {
            let end = begin + step;
            let is_last = (end - to) * (to - from) >= 0.0;
            let end = if is_last { to } else { end };
            let mut ranges = whole.clone();
            ranges[0] = [begin.min(end), begin.max(end)];
            place[0] = begin;
            let piece = proof.piece(lead, ranges, &near).filter(|piece| {
                let before: Vec<&Piece> = pieces.last().into_iter().chain([piece]).collect();
                proof.belongs(lead, &place, &near, &before)
            });
            if let Some(piece) = piece {
                near.clone_from(&piece.enclosed.centre);
                pieces.push(piece);
                begin = end;
                step = (to - from).signum() * (2.0 * step).abs().min((to - from).abs() * LONGEST);
            } else {
                step *= 0.5;
                if step.abs() < SHORTEST * (to - from).abs() {
                    gap = Some([begin.min(end), begin.max(end)]);
                    break;
                }
            }
        }
        let Some(first) = pieces.get(pieces.len() / 2) else {
            let [low, high] = gap.unwrap_or([from.min(to), from.max(to)]);
            return Err(ProofError::Undecided(UndecidedForce {
                range: [low, high],
                force: [0.0, f64::INFINITY],
                reason: UndecidedReason::Pose,
                pieces: 0,
            }));
        };
        let sample = Sample::new(proof, lead, wanted, first)?;
        let mut search = Self {
            proof,
            lead,
            sample,
            whole,
            waiting: BinaryHeap::new(),
            best: None,
            pieces: 0,
            gap,
        };
        for piece in pieces {
            search.add(piece);
        }
        Ok(search)
    }

    fn add(&mut self, piece: Piece) {
        self.pieces += 1;
        let reach = self.sample.reach(self.lead, &piece);
        let (upper, slopes) = match reach {
            Some(Reach { upper, slopes }) => (upper, Some(slopes)),
            None => (f64::INFINITY, None),
        };
        self.waiting.push(Known { piece, upper, slopes });
    }

    fn undecided(&self, range: [f64; 2], upper: f64, reason: UndecidedReason) -> UndecidedForce {
        UndecidedForce {
            range,
            force: [self.best.as_ref().map_or(0.0, |best| best.force), upper],
            reason,
            pieces: self.pieces,
        }
    }

    /// Divides the worst piece until the question is answered.
    fn run<T>(&mut self, answer: impl Fn(&Self, f64) -> Step<T>) -> Result<T, UndecidedForce> {
        while let Some(worst) = self.waiting.pop() {
            self.look_at(&worst);
            if let Step::Done(found) = answer(self, worst.upper) {
                return Ok(found);
            }
            let undecided = |search: &Self, reason| search.undecided(worst.piece.ranges[0], worst.upper, reason);
            if self.pieces >= self.proof.budget {
                return Err(undecided(self, UndecidedReason::Budget));
            }
            let Some(variable) = self.dividing(&worst) else {
                return Err(undecided(self, UndecidedReason::Rounding));
            };
            let [low, high] = worst.piece.ranges[variable];
            let border = 0.5 * (low + high);
            for part in [[low, border], [border, high]] {
                let mut ranges = worst.piece.ranges.clone();
                ranges[variable] = part;
                let place = middle(&ranges);
                let near = &worst.piece.enclosed.centre;
                let piece = self.proof.piece(self.lead, ranges, near);
                let piece = piece.filter(|piece| self.proof.belongs(self.lead, &place, near, &[piece, &worst.piece]));
                let Some(piece) = piece else {
                    return Err(undecided(self, UndecidedReason::Pose));
                };
                self.add(piece);
            }
        }
        // there is a piece at least, and two take the place of each
        Err(self.undecided(self.whole[0], f64::INFINITY, UndecidedReason::Pose))
    }

    /// Looks at the place of a piece where the force is likely to be largest.
    fn look_at(&mut self, known: &Known) {
        let Some(slopes) = &known.slopes else { return };
        let ranges = known.piece.ranges.iter().zip(slopes).enumerate();
        let place: Vec<f64> = ranges
            .map(|(variable, ([low, high], [least, greatest]))| {
                // along the input, the largest force may be inside; tolerances have theirs at the ends
                if variable == 0 && *least < 0.0 && *greatest > 0.0 {
                    0.5 * (low + high)
                } else if least + greatest > 0.0 {
                    *high
                } else {
                    *low
                }
            })
            .collect();
        let Some(force) = self.sample.least(self.lead, &known.piece, &place) else {
            return;
        };
        if self.best.as_ref().is_none_or(|best| force > best.force) {
            self.best = Some(ForcePlace {
                force,
                at: place[0],
                velocity: place[1],
                acceleration: place[2],
                dimensions: self.proof.parameters_at(&place),
            });
        }
    }

    /// The variable along which a piece is divided. The input makes all derivatives uncertain, so that another one
    /// comes only where its own is much more so.
    fn dividing(&self, known: &Known) -> Option<usize> {
        let is_wide = |variable: &usize| {
            let [low, high] = known.piece.ranges[*variable];
            high - low > NARROWEST * low.abs().max(high.abs())
        };
        let spread = |variable: usize| {
            let slopes = known.slopes.as_ref().map(|slopes| slopes[variable]);
            let spread = slopes.map_or(0.0, |[least, greatest]| greatest - least);
            if variable == 0 { MORE * spread } else { spread }
        };
        // of several that are equal, the last one
        let wide = (0..self.whole.len()).rev().filter(is_wide);
        wide.max_by(|one, other| spread(*one).total_cmp(&spread(*other)))
    }
}
