//! A mechanism of any type, as the program sees it. What is generic over the mechanism is here and as thin as possible, because it is
//! compiled for each mechanism.

use kin_core::batch::LengthMismatch;
use kin_core::cycle::{BlockClass, EndKind, FullCycle};
use kin_core::exact::{ExactTable, ExactTableError, Precision};
use kin_core::extremes::{Extreme, ExtremeKind, ExtremesError, Mean, Over};
use kin_core::law::Piecewise;
use kin_core::prelude::*;
use kin_core::sweep::{Course, Laws, Local, StraightLine, Sweep, SweepError, Table};
use kin_core::tape::{self, RecordError, Tape};
use kin_core::verify;
use kin_core::{Description, Number, Row, TrackError, track};

use super::case::Case;
use super::fault::Fault;
use super::motion::InputMotion;
use super::text;
use crate::report::ReportError;

/// The assembly that is wanted.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Wanted {
    /// The one with this index.
    Named(usize),
    /// The one to which these values of the unknowns belong, where the motion begins.
    Near(Vec<f64>),
    /// The one to which these values of the unknowns belong at these inputs.
    At {
        /// The inputs.
        inputs: Vec<f64>,
        /// The unknowns.
        near: Vec<f64>,
    },
    /// None was given, and none has a name.
    Unknown,
}

/// Dimensions and a position for which a mechanism closes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Example {
    /// The scalar parameters.
    pub(crate) parameters: Vec<f64>,
    /// The inputs.
    pub(crate) inputs: Vec<f64>,
    /// The assembly.
    pub(crate) assembly: Wanted,
}

/// A derivative over a motion.
#[derive(Clone, Debug)]
pub(crate) struct Extent {
    /// The lowest value and where.
    pub(crate) lowest: Reached,
    /// The highest value and where.
    pub(crate) highest: Reached,
    /// The root of the mean square.
    pub(crate) rms: Result<Mean, ExtremesError>,
}

/// An extreme value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reached {
    /// The value, or `None` if it grows beyond all bounds.
    pub(crate) value: Option<f64>,
    /// The place.
    pub(crate) at: f64,
    /// Whether the mechanism closes no further there.
    pub(crate) is_limit: bool,
}

/// All circuits and branches.
#[derive(Clone, Debug)]
pub(crate) struct CycleOf {
    /// The reasons why there may be other branches, each a clause.
    pub(crate) incomplete: Vec<String>,
    /// The circuits.
    pub(crate) circuits: Vec<CircuitOf>,
    /// What Grashof, Barker and others call the blocks.
    pub(crate) classes: Vec<(&'static str, BlockClass)>,
}

/// A circuit.
#[derive(Clone, Debug)]
pub(crate) struct CircuitOf {
    /// Its branches.
    pub(crate) branches: Vec<BranchOf>,
    /// The ranges of unknowns and outputs along it: name index, lowest and highest with the inputs there.
    pub(crate) strokes: Vec<Option<[(f64, f64); 2]>>,
    /// The worst transmission angle, with its dyad and the input there.
    pub(crate) transmission: Option<(&'static str, f64, f64)>,
}

/// A branch.
#[derive(Clone, Debug)]
pub(crate) struct BranchOf {
    /// The name of its assembly, if it has one.
    pub(crate) assembly: String,
    /// The inputs at its ends.
    pub(crate) range: [f64; 2],
    /// The reasons for its ends.
    pub(crate) ends: [EndKind; 2],
}

/// One pose: the value of each unknown, then of each scalar output, with the derivatives by the dimensions and by the inputs.
#[derive(Clone, Debug)]
pub(crate) struct Partial {
    /// The values.
    pub(crate) values: Vec<f64>,
    /// For each value its derivatives by the parameters and then by the inputs.
    pub(crate) by: Vec<Vec<f64>>,
}

/// What is wanted of a page.
#[derive(Clone, Debug, Default)]
pub(crate) struct PageWishes {
    /// The title.
    pub(crate) title: Option<String>,
    /// The quantities that are plotted at first.
    pub(crate) plots: Vec<String>,
    /// What the mechanism is.
    pub(crate) documentation: String,
    /// The declaration as it was typed.
    pub(crate) declaration: Option<String>,
    /// Whether the range of the input was given.
    pub(crate) has_range: bool,
}

/// What the program asks of a mechanism.
pub(crate) trait Subject {
    /// Its quantities.
    fn description(&self) -> Description;
    /// Dimensions for which it closes, if they are known.
    fn example(&self) -> Option<Example>;
    /// The names of its assemblies; none if they depend on the dimensions, an empty name if there is only one.
    fn assemblies(&self) -> Vec<String>;
    /// Whether it closes all along the motion, between the rows of tables too.
    fn closes(&self, case: &Case) -> Result<(), Fault>;
    /// The table of a sweep.
    fn table(&self, case: &Case, rows: usize) -> Result<Table, Fault>;
    /// The extremes of one derivative over a sweep.
    fn extent(&self, case: &Case, name: &str) -> Result<Extent, Fault>;
    /// The full cycle over the leading input.
    fn cycle(&self, case: &Case) -> Result<CycleOf, Fault>;
    /// Both oracles.
    fn verify(&self, case: &Case) -> Result<verify::Report, Fault>;
    /// The solver as data.
    fn tape(&self, options: &tape::Options) -> Result<Tape, RecordError>;
    /// The page.
    fn page(&self, case: &Case, wishes: &PageWishes) -> Result<String, Fault>;
    /// The table that is exact between its rows.
    fn exact_table(&self, case: &Case, precision: Precision) -> Result<ExactTable, Fault>;
    /// One pose and its derivatives.
    fn partial(&self, parameters: &[f64], inputs: &[f64], assembly: &Wanted) -> Result<Partial, Fault>;
}

/// A mechanism of the type `M`, with an example if there is one.
pub(crate) struct Sample<M: Mechanism<Scalar = f64>> {
    example: Option<(M, M::Inputs<f64>, M::Assembly)>,
}

/// A mechanism of a program that has many.
pub struct Entry(pub(super) Box<dyn Subject>);

impl Entry {
    /// A mechanism with dimensions, inputs and an assembly for which it closes.
    #[must_use]
    pub fn new<M: Mechanism<Scalar = f64> + 'static>(
        mechanism: &M,
        inputs: M::Inputs<f64>,
        assembly: M::Assembly,
    ) -> Self {
        Self(Box::new(Sample {
            example: Some((*mechanism, inputs, assembly)),
        }))
    }
}

/// A mechanism of which nothing is known but its declaration.
pub(crate) fn bare<M: Mechanism<Scalar = f64>>() -> impl Subject {
    Sample::<M> { example: None }
}

type RowOfLaws<'l, M> = <M as Mechanism>::Inputs<&'l dyn Piecewise<f64>>;

impl<M: Mechanism<Scalar = f64>> Sample<M> {
    fn mechanism(parameters: &[f64]) -> M {
        M::from_parameters(Row::from_fn(|index| parameters[index]))
    }

    fn row(values: &[f64]) -> M::Inputs<f64> {
        Row::from_fn(|index| values[index])
    }

    /// The assembly at the first inputs of a case.
    fn assembly(case: &Case, mechanism: &M) -> Result<M::Assembly, Fault> {
        let start: Vec<f64> = case.motions.iter().map(InputMotion::start).collect();
        Self::assembly_at(&case.assembly, mechanism, &start)
    }

    fn assembly_at(wanted: &Wanted, mechanism: &M, start: &[f64]) -> Result<M::Assembly, Fault> {
        let start = Self::row(start);
        match wanted {
            Wanted::Named(index) => {
                M::assembly(*index).ok_or_else(|| Fault::wrong("there is no assembly of this number"))
            }
            Wanted::Near(values) => Ok(mechanism.assembly_near(start, Row::from_fn(|index| values[index]))),
            Wanted::At { inputs, near } => {
                let (inputs, near) = (Self::row(inputs), Row::from_fn(|index| near[index]));
                let unknowns = mechanism.solve_position_near(inputs, near).map_err(Fault::open)?;
                let there = track(mechanism, inputs, unknowns, start).map_err(Fault::open)?;
                Ok(mechanism.assembly_near(start, there))
            }
            Wanted::Unknown => Err(unnamed(
                &M::DESCRIPTION,
                &Self::positions_of(mechanism, start)?,
                start.as_ref(),
            )),
        }
    }

    fn positions_of(mechanism: &M, inputs: M::Inputs<f64>) -> Result<Vec<Vec<f64>>, Fault> {
        let mut all = Vec::new();
        mechanism
            .positions_at(inputs, |_, unknowns| all.push(unknowns.as_ref().to_vec()))
            .map_err(Fault::open)?;
        Ok(all)
    }

    fn line(case: &Case, rows: usize) -> Result<Course<M, StraightLine>, Fault> {
        let mechanism = Self::mechanism(&case.parameters);
        let assembly = Self::assembly(case, &mechanism)?;
        let [from, to] =
            [InputMotion::start, InputMotion::end].map(|end| Row::from_fn(|index| end(&case.motions[index])));
        Ok(mechanism.sweep(assembly).between(from, to, rows).speed(case.speed()))
    }

    /// Calls `then` with the sweep under laws.
    fn under_laws<R>(
        case: &Case,
        duration: f64,
        rows: usize,
        then: impl FnOnce(Course<M, Laws<'_>>) -> R,
    ) -> Result<R, Fault> {
        let laws: Result<Vec<_>, _> = case.motions.iter().map(|motion| motion.law(duration)).collect();
        let laws = laws.map_err(Fault::wrong)?;
        let mechanism = Self::mechanism(&case.parameters);
        let assembly = Self::assembly(case, &mechanism)?;
        let row: RowOfLaws<'_, M> = Row::from_fn(|index| &*laws[index]);
        Ok(then(mechanism.sweep(assembly).under_laws(row, 0.0..=duration, rows)))
    }
}

/// The mechanism has several positions, and none was chosen.
fn unnamed(description: &Description, positions: &[Vec<f64>], inputs: &[f64]) -> Fault {
    use std::fmt::Write as _;
    let mut message = "the positions of this mechanism have no names, and none was chosen".to_owned();
    let value = |dimension, value: f64| match dimension {
        kin_core::Dimension::Angle => format!("{:.4}deg", value.to_degrees()),
        _ => format!("{value:.6}"),
    };
    let named = |quantities: &[kin_core::Quantity], values: &[f64]| {
        let all = quantities.iter().zip(values);
        let all: Vec<String> = all
            .map(|(quantity, own)| format!("{}={}", quantity.name, value(quantity.dimension, *own)))
            .collect();
        all.join(",")
    };
    let start = named(description.inputs, inputs);
    if positions.is_empty() {
        let _ = write!(message, "; at {start} it does not close at all");
        return Fault::open(message);
    }
    let _ = write!(message, "; at {start} it closes like this, so add one of these:");
    for position in positions {
        let _ = write!(message, "\n  --assembly {}", named(description.unknowns, position));
    }
    Fault::wrong(message)
}

fn of_sweep(error: &SweepError) -> Fault {
    Fault::wrong(error)
}

fn of_extremes(error: ExtremesError) -> Fault {
    match error {
        ExtremesError::NothingCloses(error) => Fault::open(error),
        error => Fault::wrong(error),
    }
}

fn of_exact_table(error: ExactTableError) -> Fault {
    match error {
        ExactTableError::NotClosed { .. } | ExactTableError::ChangePoint { .. } | ExactTableError::Lost { .. } => {
            Fault::open(error)
        }
        error => Fault::wrong(error),
    }
}

/// The lowest and the highest value, and the root of the mean square.
fn extent_of<M, D>(course: &Course<M, D>, name: &str) -> Result<Extent, Fault>
where
    M: Mechanism<Scalar = f64>,
    D: kin_core::sweep::SmoothDrive,
{
    let quantity = course.of(name);
    let all = quantity.extremes().map_err(of_extremes)?;
    let reached = || {
        let bounded = all.iter().filter(|one| one.value.is_some());
        bounded.map(|one| Reached {
            value: one.value,
            at: one.at,
            is_limit: one.kind == ExtremeKind::Limit,
        })
    };
    let size = |one: &Reached| one.value.unwrap_or(f64::NAN);
    let order = |one: &Reached, other: &Reached| size(one).total_cmp(&size(other));
    let lowest = unbounded(&all, false).or_else(|| reached().min_by(order));
    let highest = unbounded(&all, true).or_else(|| reached().max_by(order));
    let flat = |peak: kin_core::extremes::Peak| Reached {
        value: Some(peak.value),
        at: peak.at,
        is_limit: false,
    };
    Ok(Extent {
        lowest: match lowest {
            Some(lowest) => lowest,
            None => flat(quantity.lowest().map_err(of_extremes)?),
        },
        highest: match highest {
            Some(highest) => highest,
            None => flat(quantity.highest().map_err(of_extremes)?),
        },
        rms: quantity.rms(Over::Time),
    })
}

/// The place where a quantity grows beyond all bounds on one side.
fn unbounded(all: &[Extreme], is_maximum: bool) -> Option<Reached> {
    let place = all
        .iter()
        .find(|one| one.value.is_none() && one.is_maximum == is_maximum)?;
    Some(Reached {
        value: None,
        at: place.at,
        is_limit: true,
    })
}

impl<M: Mechanism<Scalar = f64>> Subject for Sample<M> {
    fn description(&self) -> Description {
        M::DESCRIPTION
    }

    fn example(&self) -> Option<Example> {
        let (mechanism, inputs, assembly) = &self.example?;
        let index = M::assemblies().position(|own| own == *assembly);
        let assembly = match index {
            Some(index) => Wanted::Named(index),
            None => Wanted::At {
                inputs: inputs.as_ref().to_vec(),
                near: mechanism.solve_position(*inputs, *assembly).ok()?.as_ref().to_vec(),
            },
        };
        Some(Example {
            parameters: mechanism.parameters().as_ref().to_vec(),
            inputs: inputs.as_ref().to_vec(),
            assembly,
        })
    }

    fn assemblies(&self) -> Vec<String> {
        M::assemblies().map(M::assembly_name).collect()
    }

    fn closes(&self, case: &Case) -> Result<(), Fault> {
        // several laws lead along a curve, and one along a line
        const ROWS: usize = 721;
        let moving = case.motions.iter().filter(|motion| motion.moves()).count();
        if case.time_of_laws().is_some() && moving > 1 {
            let table = self.table(case, ROWS)?;
            let open = table.rows().find(|row| !row.outcome().is_solved());
            return open.map_or(Ok(()), |row| {
                let at = table.variable().values[row.index()];
                Err(Fault::open(format!(
                    "the mechanism does not close at {} s",
                    text::digits(at)
                )))
            });
        }
        let mechanism = Self::mechanism(&case.parameters);
        let [from, to] =
            [InputMotion::start, InputMotion::end].map(|end| Row::from_fn(|index| end(&case.motions[index])));
        let start = mechanism
            .solve_position(from, Self::assembly(case, &mechanism)?)
            .map_err(Fault::open)?;
        match track(&mechanism, from, start, to) {
            Err(error @ (TrackError::Limit(_) | TrackError::Unbounded(_) | TrackError::Failed(_))) => Err(Fault::open(
                format!("the mechanism does not close all along the motion: {error}"),
            )),
            // branches cross, or nothing certain is known
            _ => Ok(()),
        }
    }

    fn table(&self, case: &Case, rows: usize) -> Result<Table, Fault> {
        match case.time_of_laws() {
            None => Self::line(case, rows)?.table(),
            Some(duration) => Self::under_laws(case, duration, rows, |course| course.table())?,
        }
        .map_err(|error| of_sweep(&error))
    }

    fn extent(&self, case: &Case, name: &str) -> Result<Extent, Fault> {
        const ROWS: usize = 181;
        match case.time_of_laws() {
            None => extent_of(&Self::line(case, ROWS)?, name),
            Some(duration) => Self::under_laws(case, duration, ROWS, |course| extent_of(&course, name))?,
        }
    }

    fn cycle(&self, case: &Case) -> Result<CycleOf, Fault> {
        let mechanism = Self::mechanism(&case.parameters);
        let lead = case.lead;
        let from = Row::from_fn(|index| {
            if index == lead {
                0.0
            } else {
                case.motions[index].start()
            }
        });
        let direction = Row::from_fn(|index| f64::from(u8::from(index == lead)));
        let cycle = mechanism.cycle_along(from, direction).map_err(Fault::open)?;
        let names = M::DESCRIPTION.unknowns.iter().chain(M::DESCRIPTION.outputs);
        let circuits = cycle.circuits().iter().enumerate().map(|(index, circuit)| CircuitOf {
            branches: circuit
                .branches()
                .iter()
                .map(|branch| {
                    let assembly = cycle.assembly_of(*branch).map(M::assembly_name);
                    let branch = &cycle.branches()[*branch];
                    BranchOf {
                        assembly: assembly.filter(|_| M::ASSEMBLY_COUNT > 0).unwrap_or_default(),
                        range: branch.ends().map(|end| end.input),
                        ends: branch.ends().map(|end| end.kind),
                    }
                })
                .collect(),
            strokes: names
                .clone()
                .map(|quantity| {
                    let stroke = cycle.stroke(index, quantity.name).ok()?;
                    Some([stroke.low, stroke.high].map(|end| (end.value, end.input)))
                })
                .collect(),
            transmission: cycle
                .worst_transmission(index)
                .ok()
                .map(|worst| (worst.block, worst.angle, worst.input)),
        });
        let forms = mechanism.block_forms();
        let classes = M::DESCRIPTION.blocks.iter().zip(forms.as_ref());
        Ok(CycleOf {
            incomplete: cycle.incomplete().iter().map(ToString::to_string).collect(),
            circuits: circuits.collect(),
            classes: classes
                .filter_map(|(block, form)| Some((block.unknowns, BlockClass::of(form)?)))
                .collect(),
        })
    }

    fn verify(&self, case: &Case) -> Result<verify::Report, Fault> {
        let ranges = Row::from_fn(|index| {
            let motion = &case.motions[index];
            let (from, to) = (motion.start(), motion.end());
            (from.min(to), from.max(to))
        });
        Ok(verify::of(&Self::mechanism(&case.parameters), ranges))
    }

    fn tape(&self, options: &tape::Options) -> Result<Tape, RecordError> {
        tape::record::<M>(options)
    }

    fn page(&self, case: &Case, wishes: &PageWishes) -> Result<String, Fault> {
        let mechanism = Self::mechanism(&case.parameters);
        let lead = case.lead;
        let motion = &case.motions[lead];
        let (from, to) = (motion.start().min(motion.end()), motion.start().max(motion.end()));
        let inputs = Row::from_fn(|index| case.motions[index].start());
        let mut draft = crate::report(&mechanism)
            .at(inputs)
            .moving(M::DESCRIPTION.inputs[lead].name)
            .speed((motion.end() - motion.start()).signum() * case.speed())
            .units(case.length, "s")
            .assembly(Self::assembly(case, &mechanism)?)
            .plots(wishes.plots.iter().cloned())
            .documentation(wishes.documentation.clone());
        if wishes.has_range {
            draft = draft.range(from..=to);
        }
        if !case.in_degrees {
            draft = draft.in_radians();
        }
        if let Some(title) = &wishes.title {
            draft = draft.title(title.clone());
        }
        if let Some(declaration) = &wishes.declaration {
            draft = draft.declaration(declaration.clone());
        }
        draft.html().map_err(|error| match error {
            ReportError::ClosesNowhere { .. } | ReportError::NoPosition { .. } => Fault::open(error),
            error => Fault::wrong(error),
        })
    }

    fn exact_table(&self, case: &Case, precision: Precision) -> Result<ExactTable, Fault> {
        const ROWS: usize = 13;
        match case.time_of_laws() {
            None => Self::line(case, ROWS)?.exact_table(precision),
            Some(duration) => Self::under_laws(case, duration, ROWS, |course| course.exact_table(precision))?,
        }
        .map_err(of_exact_table)
    }

    fn partial(&self, parameters: &[f64], inputs: &[f64], assembly: &Wanted) -> Result<Partial, Fault> {
        let assembly = Self::assembly_at(assembly, &Self::mechanism(parameters), inputs)?;
        let mut values = Vec::new();
        let mut by: Vec<Vec<f64>> = Vec::new();
        for place in 0..parameters.len() + inputs.len() {
            let moved = |index: usize, value: f64| {
                let rate = f64::from(u8::from(index == place));
                Local::from_derivatives([value, rate, 0.0, 0.0, 0.0])
            };
            let mechanism = M::With::<Local>::from_parameters(Row::from_fn(|index| moved(index, parameters[index])));
            let motions = Row::from_fn(|index| {
                let value = moved(parameters.len() + index, inputs[index]);
                Row::from_fn(|order| if order == 0 { value } else { Local::constant(0.0) })
            });
            let pose = mechanism.solve_motion(motions, assembly).map_err(Fault::open)?;
            let (unknowns, outputs) = (pose.unknown_motions(), pose.output_motions());
            let all = unknowns.as_ref().iter().chain(outputs.as_ref());
            let all: Vec<[f64; 5]> = all.map(|motion| motion[0].derivatives()).collect();
            if place == 0 {
                values = all.iter().map(|series| series[0]).collect();
                by = vec![Vec::new(); all.len()];
            }
            for (own, series) in by.iter_mut().zip(&all) {
                own.push(series[1]);
            }
        }
        Ok(Partial { values, by })
    }
}

impl From<LengthMismatch> for Fault {
    fn from(mismatch: LengthMismatch) -> Self {
        Self::wrong(mismatch)
    }
}
