//! The assembly of a report, and the branches on which it lies.

use kin_core::cycle::{Branch, Cycle, EndKind};
use kin_core::{Dimension, InputValues, Mechanism, Row as _};

use crate::report::{Draft, ReportError};

/// The part of the range by which the scrubber goes on beyond a limit.
const BEYOND: f64 = 0.1;
/// A place between two ends at which nothing special is, however symmetric the mechanism.
const BETWEEN: f64 = 0.487_213;

/// The assembly that a report shows.
pub(super) struct Own<M: Mechanism<Scalar = f64>> {
    pub(super) assembly: M::Assembly,
    /// The indices of its branches, the branch of the wanted place first.
    pub(super) branches: Vec<usize>,
    /// A value of the moving input, and the unknowns there.
    pub(super) start: (f64, M::Unknowns<f64>),
}

impl<M: Mechanism<Scalar = f64>> Own<M> {
    pub(super) fn find(draft: &Draft<M>, moving: usize, cycle: &Cycle<M>) -> Result<Self, ReportError> {
        let mechanism = &draft.mechanism;
        let place = draft.inputs[moving];
        let wanted = draft
            .assembly
            .map(|assembly| mechanism.solve_position(draft.inputs, assembly));
        let mut found = None;
        let search = match (&wanted, draft.assembly) {
            (None, _) | (_, None) => mechanism.positions_at(draft.inputs, |assembly, unknowns| {
                if found.is_none() {
                    found = Some((assembly, unknowns));
                }
            }),
            (Some(Ok(unknowns)), Some(assembly)) => {
                found = Some((assembly, *unknowns));
                Ok(kin_core::PositionSearch::default())
            }
            (Some(Err(_)), Some(_)) => Ok(kin_core::PositionSearch::default()),
        };
        search.map_err(|error| ReportError::ClosesNowhere { error })?;
        if let Some((assembly, unknowns)) = found {
            return Ok(Self {
                assembly,
                branches: branches(cycle, place, assembly, &unknowns),
                start: (place, unknowns),
            });
        }
        // It does not close at that place. A branch may be elsewhere.
        let all = cycle.branches().iter().enumerate();
        let mut fitting = all.filter(|(index, _)| match draft.assembly {
            Some(assembly) => cycle.assembly_of(*index) == Some(assembly),
            None => true,
        });
        let elsewhere = fitting.find_map(|(index, branch)| {
            let place = between(branch);
            Some((place, cycle.position_on(index, place).ok()?))
        });
        let Some((place, unknowns)) = elsewhere else {
            let refused = |assembly| mechanism.solve_position(draft.inputs, assembly).err();
            let error = wanted
                .and_then(Result::err)
                .or_else(|| M::assemblies().find_map(refused));
            return Err(match error {
                Some(error) => ReportError::ClosesNowhere { error },
                None => ReportError::NoPosition {
                    inputs: InputValues::new(M::DESCRIPTION.inputs, draft.inputs.as_ref()),
                },
            });
        };
        let inputs = M::Inputs::from_fn(|input| if input == moving { place } else { draft.inputs[input] });
        let assembly = mechanism.assembly_near(inputs, unknowns);
        Ok(Self {
            assembly,
            branches: branches(cycle, place, assembly, &unknowns),
            start: (place, unknowns),
        })
    }

    /// The range of the moving input: as far as the assembly goes, and a bit beyond its limits.
    pub(super) fn range(&self, cycle: &Cycle<M>, place: f64) -> Result<[f64; 2], ReportError> {
        let of = |branch: &usize| &cycle.branches()[*branch];
        let own = self.branches.iter().map(of);
        if let (true, Some(period)) = (own.clone().any(Branch::is_full_turn), cycle.period()) {
            return Ok([0.0, period]);
        }
        let ends = own.flat_map(Branch::ends);
        let reach = ends.fold(None, |reach: Option<[(f64, bool); 2]>, end| {
            let here = (end.input, end.kind != EndKind::Range);
            Some(match reach {
                None => [here; 2],
                Some([low, high]) => [
                    if here.0 < low.0 { here } else { low },
                    if here.0 > high.0 { here } else { high },
                ],
            })
        });
        let Some([low, high]) = reach else {
            return Err(ReportError::NoRange { from: place, to: place });
        };
        let beyond = BEYOND * (high.0 - low.0);
        let padded = |(end, is_limit): (f64, bool), side: f64| if is_limit { end + side * beyond } else { end };
        let range = [padded(low, -1.0), padded(high, 1.0)];
        match cycle.period() {
            Some(period) if range[1] - range[0] > period => {
                let middle = f64::midpoint(low.0, high.0);
                Ok([middle - 0.5 * period, middle + 0.5 * period])
            }
            _ if range[1] > range[0] => Ok(range),
            _ => Err(ReportError::NoRange {
                from: range[0],
                to: range[1],
            }),
        }
    }
}

/// The largest part of a branch within a range, and the whole periods by which it is shifted there.
pub(super) fn part_in<M: Mechanism<Scalar = f64>>(
    cycle: &Cycle<M>,
    branch: &Branch,
    range: [f64; 2],
) -> Option<([f64; 2], f64)> {
    let [low, high] = branch.ends().map(|end| end.input);
    let part = |shift: f64| ([range[0].max(low + shift), range[1].min(high + shift)], shift);
    let length = |([from, to], _): &([f64; 2], f64)| to - from;
    let parts: Vec<_> = match cycle.period() {
        Some(_) if branch.is_full_turn() => vec![(range, 0.0)],
        Some(period) => {
            let first = ((range[0] - high) / period).floor();
            (0..4).map(|turn| part(period * (first + f64::from(turn)))).collect()
        }
        None => vec![part(0.0)],
    };
    let longest = parts
        .into_iter()
        .max_by(|one, other| length(one).total_cmp(&length(other)))?;
    (length(&longest) > 0.0).then_some(longest)
}

/// A place inside of a branch.
pub(super) fn between(branch: &Branch) -> f64 {
    let [low, high] = branch.ends().map(|end| end.input);
    between_places(low, high)
}

/// A place between two others, at which nothing special is.
pub(super) fn between_places(low: f64, high: f64) -> f64 {
    low + BETWEEN * (high - low)
}

/// The branches of an assembly: of closed forms all those of the assembly, otherwise those of the circuit.
fn branches<M: Mechanism<Scalar = f64>>(
    cycle: &Cycle<M>,
    place: f64,
    assembly: M::Assembly,
    unknowns: &M::Unknowns<f64>,
) -> Vec<usize> {
    let here = cycle.at(place).map(|(index, _)| index);
    let first = if M::ASSEMBLY_COUNT > 0 {
        let mut fitting = here.filter(|index| cycle.assembly_of(*index) == Some(assembly));
        fitting.next()
    } else {
        let distances = here.filter_map(|index| {
            let own = cycle.position_on(index, shifted(cycle, index, place)).ok()?;
            Some((index, distance::<M>(&own, unknowns)))
        });
        let nearest = distances.min_by(|one, other| one.1.total_cmp(&other.1));
        nearest.filter(|(_, distance)| *distance < 1e-6).map(|(index, _)| index)
    };
    let all = 0..cycle.branches().len();
    let belongs = |index: &usize| match first {
        _ if M::ASSEMBLY_COUNT > 0 => cycle.assembly_of(*index) == Some(assembly),
        Some(first) => cycle.branches()[*index].circuit() == cycle.branches()[first].circuit(),
        None => false,
    };
    let rest = all.filter(|index| belongs(index) && Some(*index) != first);
    first.into_iter().chain(rest).collect()
}

/// The place on a branch that is a whole number of periods from the given one.
fn shifted<M: Mechanism<Scalar = f64>>(cycle: &Cycle<M>, branch: usize, place: f64) -> f64 {
    let [low, high] = cycle.branches()[branch].ends().map(|end| end.input);
    match cycle.period() {
        Some(period) if place < low => place + period * ((low - place) / period).ceil(),
        Some(period) if place > high => place - period * ((place - high) / period).ceil(),
        _ => place,
    }
}

/// The largest difference of two positions: of angles without whole turns, of lengths relative to their size.
fn distance<M: Mechanism>(one: &M::Unknowns<f64>, other: &M::Unknowns<f64>) -> f64 {
    let values = one.as_ref().iter().zip(other.as_ref());
    let named = M::DESCRIPTION.unknowns.iter().zip(values);
    named.fold(0.0, |largest: f64, (quantity, (one, other))| {
        let difference = one - other;
        largest.max(match quantity.dimension {
            Dimension::Angle => {
                let turns = (difference / std::f64::consts::TAU).round();
                (difference - turns * std::f64::consts::TAU).abs()
            }
            _ => difference.abs() / one.abs().max(1.0),
        })
    })
}
