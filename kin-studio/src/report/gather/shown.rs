//! The assembly of a report, and the branches on which it lies.

use kin_core::Dimension;
use kin_core::any::{AssemblyChoice, Description};
use kin_core::cycle::{Branch, EndKind};
use kin_core::linkage::AnyCycle;

use super::line::Line;
use crate::report::ReportError;
use crate::report::draft::Wishes;

/// The part of the range by which the scrubber goes on beyond a limit.
const BEYOND: f64 = 0.1;
/// The number of parts of a range at whose ends an assembly is looked for.
const SAMPLES: u32 = 180;
/// The part of the way between two ends at which no position is special, even of a symmetric mechanism.
const BETWEEN: f64 = 0.487_213;

/// The assembly that a report shows.
pub(super) struct ShownAssembly {
    pub(super) assembly: AssemblyChoice,
    /// The indices of its branches, the branch at the wanted value of the variable first.
    pub(super) branches: Vec<usize>,
    /// A value of the variable, and the unknowns there.
    pub(super) start: (f64, Vec<f64>),
}

impl ShownAssembly {
    pub(super) fn on_line(wishes: &Wishes<'_>, line: &Line, cycle: &AnyCycle<'_>) -> Result<Self, ReportError> {
        let (linkage, at, inputs) = (&wishes.linkage, line.start, line.inputs());
        let of_assembly = |choice: &AssemblyChoice| linkage.position(inputs, choice.position());
        let wanted = wishes.assembly.as_ref().map(|choice| (choice, of_assembly(choice)));
        let found = if let Some((choice, solved)) = &wanted {
            let solved = solved.as_ref().ok();
            solved.map(|unknowns| ((*choice).clone(), unknowns.clone()))
        } else {
            let all = linkage.positions_at(inputs);
            let (all, _) = all.map_err(|error| ReportError::ClosesNowhere { error })?;
            let first = all.into_iter().next();
            first.map(|unknowns| (linkage.assembly_at(inputs, &unknowns), unknowns))
        };
        if let Some((assembly, unknowns)) = found {
            return Ok(Self {
                branches: branches(cycle, at, &assembly, &unknowns, linkage.description()),
                assembly,
                start: (at, unknowns),
            });
        }
        // The mechanism does not close at that value. A branch may be elsewhere.
        let all = cycle.branches().iter().enumerate();
        let mut fitting = all.filter(|(_, branch)| match &wishes.assembly {
            Some(choice) => choice.index().is_some() && branch.assembly() == choice.index(),
            None => true,
        });
        let elsewhere = fitting.find_map(|(index, branch)| {
            let at = between(branch);
            Some((at, cycle.position_on(index, at).ok()?))
        });
        let Some((at, unknowns)) = elsewhere else {
            let mut all = 0..linkage.assembly_count();
            let refused = |index: usize| of_assembly(&AssemblyChoice::Index(index)).err();
            let error = wanted
                .and_then(|(_, solved)| solved.err())
                .or_else(|| all.find_map(refused));
            return Err(match error {
                Some(error) => ReportError::ClosesNowhere { error },
                None => ReportError::NoPosition {
                    inputs: linkage.input_values(inputs),
                },
            });
        };
        let assembly = linkage.assembly_at(&line.inputs_at(at), &unknowns);
        Ok(Self {
            branches: branches(cycle, at, &assembly, &unknowns, linkage.description()),
            assembly,
            start: (at, unknowns),
        })
    }

    /// The assembly under laws: the wanted assembly, or the first that closes. Values nearby hold where the laws begin.
    /// `inputs` gives the inputs at a time.
    pub(super) fn under_laws(
        wishes: &Wishes<'_>,
        range: [f64; 2],
        inputs: &dyn Fn(f64) -> Vec<f64>,
    ) -> Result<Self, ReportError> {
        let (linkage, [begin, _]) = (&wishes.linkage, range);
        let solved = |choice: &AssemblyChoice, at: f64| linkage.position(&inputs(at), choice.position());
        let count = linkage.assembly_count();
        let candidates: Vec<AssemblyChoice> = match &wishes.assembly {
            Some(choice) => vec![choice.clone()],
            None if count > 0 => (0..count).map(AssemblyChoice::Index).collect(),
            None => {
                let found = linkage.positions_at(&inputs(begin));
                let (all, _) = found.map_err(|error| ReportError::ClosesNowhere { error })?;
                all.into_iter().map(AssemblyChoice::Near).collect()
            }
        };
        // a coupled block is followed from the beginning, and a closed form may close only later
        let samples = if count > 0 { samples(range) } else { vec![begin] };
        let closing = samples.iter().find_map(|at| {
            let mut candidates = candidates.iter();
            candidates.find_map(|choice| Some((choice.clone(), *at, solved(choice, *at).ok()?)))
        });
        match (closing, candidates.first()) {
            (Some((assembly, at, unknowns)), _) => Ok(Self {
                assembly,
                branches: Vec::new(),
                start: (at, unknowns),
            }),
            (None, Some(choice)) => Err(match solved(choice, begin) {
                Err(error) => ReportError::ClosesNowhere { error },
                Ok(_) => ReportError::NoPosition {
                    inputs: linkage.input_values(&inputs(begin)),
                },
            }),
            (None, None) => Err(ReportError::NoPosition {
                inputs: linkage.input_values(&inputs(begin)),
            }),
        }
    }

    /// The range of the moving input: as far as the assembly goes, and a bit beyond its limits.
    pub(super) fn range(&self, cycle: &AnyCycle<'_>, at: f64) -> Result<[f64; 2], ReportError> {
        let of = |branch: &usize| &cycle.branches()[*branch];
        let branches = self.branches.iter().map(of);
        if let (true, Some(period)) = (branches.clone().any(Branch::is_full_revolution), cycle.period()) {
            return Ok([0.0, period]);
        }
        let ends = branches.flat_map(Branch::ends);
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
            return Err(ReportError::NoRange { from: at, to: at });
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

/// Samples of a range, from its beginning to its end.
pub(super) fn samples([from, to]: [f64; 2]) -> Vec<f64> {
    let sample = |part: u32| from + (to - from) * f64::from(part) / f64::from(SAMPLES);
    (0..=SAMPLES).map(sample).collect()
}

/// The largest part of a branch within a range, and the whole periods by which it is shifted there.
pub(super) fn part_in(cycle: &AnyCycle<'_>, branch: &Branch, range: [f64; 2]) -> Option<([f64; 2], f64)> {
    let [low, high] = branch.ends().map(|end| end.input);
    let part = |shift: f64| ([range[0].max(low + shift), range[1].min(high + shift)], shift);
    let length = |([from, to], _): &([f64; 2], f64)| to - from;
    let parts: Vec<_> = match cycle.period() {
        Some(_) if branch.is_full_revolution() => vec![(range, 0.0)],
        Some(period) => {
            let first = ((range[0] - high) / period).floor();
            (0..4).map(|shift| part(period * (first + f64::from(shift)))).collect()
        }
        None => vec![part(0.0)],
    };
    let longest = parts
        .into_iter()
        .max_by(|one, other| length(one).total_cmp(&length(other)))?;
    (length(&longest) > 0.0).then_some(longest)
}

/// A value of the variable inside of a branch.
pub(super) fn between(branch: &Branch) -> f64 {
    let [low, high] = branch.ends().map(|end| end.input);
    between_values(low, high)
}

/// A value between two others, at which no position is special.
pub(super) fn between_values(low: f64, high: f64) -> f64 {
    low + BETWEEN * (high - low)
}

/// The branches of an assembly: of closed forms all those of the assembly, otherwise those of the circuit.
fn branches(
    cycle: &AnyCycle<'_>,
    at: f64,
    assembly: &AssemblyChoice,
    unknowns: &[f64],
    description: &Description<'_>,
) -> Vec<usize> {
    let here = cycle.at(at).map(|(index, _)| index);
    let all = || cycle.branches().iter().enumerate();
    let (first, belonging): (Option<usize>, Vec<usize>) = if let Some(assembly) = assembly.index() {
        let belongs = |branch: &Branch| branch.assembly() == Some(assembly);
        let mut fitting = here.filter(|index| belongs(&cycle.branches()[*index]));
        let all_of_assembly = all().filter(|(_, branch)| belongs(branch));
        (fitting.next(), all_of_assembly.map(|(index, _)| index).collect())
    } else {
        let distances = here.filter_map(|index| {
            let position = cycle.position_on(index, shifted(cycle, index, at)).ok()?;
            Some((index, distance(description, &position, unknowns)))
        });
        let nearest = distances.min_by(|one, other| one.1.total_cmp(&other.1));
        let first = nearest.filter(|(_, distance)| *distance < 1e-6).map(|(index, _)| index);
        let circuit = first.map(|first| cycle.branches()[first].circuit());
        let all_of_circuit = all().filter(|(_, branch)| Some(branch.circuit()) == circuit);
        (first, all_of_circuit.map(|(index, _)| index).collect())
    };
    let rest = belonging.into_iter().filter(|index| Some(*index) != first);
    first.into_iter().chain(rest).collect()
}

/// The value on a branch that differs from the given value by a whole number of periods.
fn shifted(cycle: &AnyCycle<'_>, branch: usize, at: f64) -> f64 {
    let [low, high] = cycle.branches()[branch].ends().map(|end| end.input);
    match cycle.period() {
        Some(period) if at < low => at + period * ((low - at) / period).ceil(),
        Some(period) if at > high => at - period * ((at - high) / period).ceil(),
        _ => at,
    }
}

/// The largest difference of two positions: of angles up to full revolutions, of lengths relative to their size.
pub(super) fn distance(description: &Description<'_>, one: &[f64], other: &[f64]) -> f64 {
    let values = one.iter().zip(other);
    let named = description.unknowns.iter().zip(values);
    named.fold(0.0, |largest: f64, (quantity, (one, other))| {
        let difference = one - other;
        largest.max(match quantity.dimension {
            Dimension::Angle => {
                let revolutions = (difference / std::f64::consts::TAU).round();
                (difference - revolutions * std::f64::consts::TAU).abs()
            }
            _ => difference.abs() / one.abs().max(1.0),
        })
    })
}
