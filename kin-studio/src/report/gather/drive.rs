//! The drive as data: power series of the inputs, piece by piece.
//!
//! A law may be any formula. Its pieces are halved until their Taylor series are exact, so that a page needs no
//! formulas of laws, and one way of reading serves lines and laws.

use kin_core::any::Description;
use kin_core::law::Side;
use kin_core::linkage::AnySweep;
use kin_core::sweep::SmoothDrive;

use crate::report::ReportError;
use crate::report::model::{Drive, Joint, Piece, Variable};

/// The highest derivative that a page shows, through which the series are exact.
const SHOWN: usize = 4;
/// The largest error of a derivative, in parts of its size.
const EXACT: f64 = 1e-12;
/// The largest error where halving does not help, for laws whose formulas cancel.
const ROUNDED: f64 = 1e-8;
/// The smallest jump of a derivative, in parts of its size.
const JUMPS: f64 = 1e-9;
/// The smallest distance of two joints, in parts of the range. Nearer joints are one joint, since laws of several
/// inputs round their times.
const ONE_JOINT: f64 = 1e-12;
/// The largest number of halvings of a piece.
const HALVINGS: u32 = 12;
/// The largest number of pieces of a page.
const MOST: usize = 4096;

/// The inputs with their derivatives at a value of the variable.
type Inputs = Vec<Vec<f64>>;

/// A drive over a range.
struct Read<'s, D> {
    sweep: &'s AnySweep<'s, D>,
    description: &'s Description<'s>,
    shown: usize,
}

/// The drive of a sweep over a range.
pub(super) fn of<D: SmoothDrive>(
    sweep: &AnySweep<'_, D>,
    description: &Description<'_>,
    variable: Variable,
    range: [f64; 2],
) -> Result<Drive, ReportError> {
    sweep.check().map_err(ReportError::Motion)?;
    let read = Read {
        sweep,
        description,
        shown: description.order.min(SHOWN),
    };
    let mut drive = Drive {
        variable,
        pieces: Vec::new(),
        joints: Vec::new(),
    };
    let mut before: Option<Vec<Vec<f64>>> = None;
    for [from, to] in read.stretches(range)? {
        let sizes = read.sizes(from, to)?;
        let first = drive.pieces.len();
        read.add(from, to, &sizes, HALVINGS, &mut drive.pieces)?;
        if let (Some(before), Some(left), Some(right)) = (
            &before,
            first.checked_sub(1).map(|last| &drive.pieces[last]),
            drive.pieces.get(first),
        ) && let Some(order) = read.jump(left, right, before, &sizes)
        {
            drive.joints.push(Joint { at: from, order });
        }
        before = Some(sizes);
    }
    Ok(drive)
}

/// The value at which an input stands, if it does.
pub(super) fn standing(drive: &Drive, input: usize) -> Option<f64> {
    let mut series = drive.pieces.iter().map(|piece| piece.inputs[input].as_slice());
    let first = series.next()?;
    match first {
        [value] if series.all(|other| other == first) => Some(*value),
        _ => None,
    }
}

/// Whether all inputs stand somewhere.
pub(super) fn dwells(drive: &Drive) -> bool {
    let mut pieces = drive.pieces.iter();
    pieces.any(|piece| piece.inputs.iter().all(|series| series.len() == 1))
}

impl<D: SmoothDrive> Read<'_, D> {
    /// The parts of the range between joints.
    fn stretches(&self, [low, high]: [f64; 2]) -> Result<Vec<[f64; 2]>, ReportError> {
        let apart = ONE_JOINT * (high - low);
        let mut ends = vec![low];
        let mut after = low;
        while let Some(joint) = self.sweep.next_joint(after).filter(|joint| *joint < high - apart) {
            if joint - ends[ends.len() - 1] > apart {
                ends.push(joint);
            }
            if ends.len() > MOST {
                return Err(ReportError::TooManyPieces { most: MOST });
            }
            after = joint;
        }
        ends.push(high);
        Ok(ends.windows(2).map(|ends| [ends[0], ends[1]]).collect())
    }

    /// The inputs inside of a stretch, where no side is to be chosen.
    fn inputs(&self, at: f64) -> Result<Inputs, ReportError> {
        let inputs = self.sweep.inputs(at, Side::Right);
        let is_finite = |derivatives: &Vec<f64>| derivatives.iter().all(|value| value.is_finite());
        match inputs.iter().position(|derivatives| !is_finite(derivatives)) {
            None => Ok(inputs),
            Some(input) => Err(ReportError::NotFinite {
                quantity: format!("the motion of {} at {at}", self.description.inputs[input].name),
            }),
        }
    }

    /// The size of each derivative of each input within a stretch.
    fn sizes(&self, from: f64, to: f64) -> Result<Vec<Vec<f64>>, ReportError> {
        let mut sizes = vec![vec![0.0_f64; self.shown + 1]; self.description.inputs.len()];
        for part in 1..16 {
            let inputs = self.inputs(from + (to - from) * f64::from(part) / 16.0)?;
            for (sizes, derivatives) in sizes.iter_mut().zip(&inputs) {
                for (size, value) in sizes.iter_mut().zip(derivatives) {
                    *size = size.max(value.abs());
                }
            }
        }
        Ok(sizes)
    }

    /// Adds the pieces of a part of a stretch.
    fn add(
        &self,
        from: f64,
        to: f64,
        sizes: &[Vec<f64>],
        halvings: u32,
        pieces: &mut Vec<Piece>,
    ) -> Result<(), ReportError> {
        let middle = f64::midpoint(from, to);
        let half = 0.5 * (to - from);
        let inputs = self.inputs(middle)?;
        let series = inputs
            .iter()
            .zip(sizes)
            .map(|(derivatives, sizes)| terms(derivatives, half, sizes));
        let piece = Piece {
            from,
            to,
            at: middle,
            inputs: series.collect(),
        };
        // The largest error is at the ends, where rounded times may belong to the piece beyond.
        let mut worst: Option<(usize, f64)> = None;
        for part in [-0.97, 0.97] {
            let at = middle + part * half;
            for (input, (derivatives, sizes)) in self.inputs(at)?.iter().zip(sizes).enumerate() {
                for (order, size) in sizes.iter().enumerate() {
                    let error = (derivative(&piece.inputs[input], order, at - middle) - derivatives[order]).abs();
                    let error = if error == 0.0 { 0.0 } else { error / size };
                    if worst.is_none_or(|(_, worst)| error > worst) {
                        worst = Some((input, error));
                    }
                }
            }
        }
        match worst {
            Some((_, error)) if error > EXACT && halvings > 0 => {
                self.add(from, middle, sizes, halvings - 1, pieces)?;
                self.add(middle, to, sizes, halvings - 1, pieces)
            }
            Some((input, error)) if error > ROUNDED => Err(ReportError::NotSmooth {
                input: self.description.inputs[input].name.to_owned(),
                at: middle,
            }),
            _ if pieces.len() == MOST => Err(ReportError::TooManyPieces { most: MOST }),
            _ => {
                pieces.push(piece);
                Ok(())
            }
        }
    }

    /// The lowest derivative that jumps between two pieces. The value jumps by full revolutions only, which do not
    /// count.
    fn jump(&self, left: &Piece, right: &Piece, before: &[Vec<f64>], behind: &[Vec<f64>]) -> Option<usize> {
        (1..=self.shown).find(|&order| {
            (0..self.description.inputs.len()).any(|input| {
                let ends = [(left, left.to), (right, right.from)];
                let [one, other] = ends.map(|(piece, at)| derivative(&piece.inputs[input], order, at - piece.at));
                (other - one).abs() > JUMPS * before[input][order].max(behind[input][order])
            })
        })
    }
}

/// The coefficients of the Taylor series, without the last coefficients that add nothing within a distance.
fn terms(derivatives: &[f64], distance: f64, sizes: &[f64]) -> Vec<f64> {
    let mut factorial = 1.0;
    let mut terms = Vec::new();
    for (order, value) in derivatives.iter().enumerate() {
        factorial *= number(order.max(1));
        terms.push(value / factorial);
    }
    let adds = |order: usize, term: f64| {
        sizes.iter().enumerate().take(order + 1).any(|(of, size)| {
            let part = (of..order).fold(falling(order, of) * term, |part, _| part * distance);
            part.abs() > 1e-17 * size
        })
    };
    while terms.len() > 1 && !adds(terms.len() - 1, terms[terms.len() - 1]) {
        terms.pop();
    }
    terms
}

/// A derivative of a series at a distance from its centre.
fn derivative(terms: &[f64], order: usize, distance: f64) -> f64 {
    let terms = terms.iter().enumerate().skip(order).rev();
    terms.fold(0.0, |sum, (power, term)| sum * distance + falling(power, order) * term)
}

/// The factor that the derivative of an order takes from a power.
fn falling(power: usize, order: usize) -> f64 {
    (0..order).fold(1.0, |factor, below| factor * number(power - below))
}

/// A small number.
fn number(count: usize) -> f64 {
    f64::from(u32::try_from(count).unwrap_or(u32::MAX))
}
