//! A mechanism of the program.

use std::fmt;
use std::sync::Arc;

use kin_core::TrackError;
use kin_core::any::{AssemblyChoice, Described as _, Description, Named, Of, Outline, PositionChoice, Quantity};
use kin_core::batch::LengthMismatch;
use kin_core::cycle::BlockClass;
use kin_core::exact::{ExactTable, ExactTableError, Precision};
use kin_core::extremes::{
    AskedQuantity, Extreme, ExtremeKind, ExtremesError, Mean, Over, QuantityAlong, QuantitySource,
};
use kin_core::law::{Piecewise, Side};
use kin_core::linkage::{AnyCycle, AnyLinkage, AnySweep};
use kin_core::load::NamedLoads;
use kin_core::prelude::*;
use kin_core::reaction::{Efficiency, ForceProof, NamedReactions, ReactionError};
use kin_core::sweep::{Laws, SmoothDrive, StraightLine, SweepError, Table};
use kin_core::tape::structure::Tape;
use kin_core::tape::{self, RecordError};

use super::fault::Fault;
use super::functions::CaseFunctions;
use super::loads::{ForceColumn, ForceColumns};
use super::page::PageWishes;
use super::text;
use super::typed::Case;
use crate::forces::{Causes, Force, ForceQuestion, OfPeak, OfRows, Reached, Stated};
use crate::library::{Design, DesignAssembly};
use crate::report::{Report, ReportError, WayWished, WishedLoads, Wishes};

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

/// A mechanism of the program, with an example if there is one.
#[derive(Clone, Debug)]
pub(crate) struct Subject {
    pub(super) functions: Arc<dyn CaseFunctions>,
    example: Option<Example>,
}

/// The mechanism has several positions, and none was chosen.
fn unnamed(description: &Description<'_>, positions: &[Vec<f64>], inputs: &[f64]) -> Fault {
    use std::fmt::Write as _;
    let mut message = "the positions of this mechanism have no names, and none was chosen".to_owned();
    let value = |dimension, value: f64| match dimension {
        kin_core::Dimension::Angle => format!("{:.4}deg", value.to_degrees()),
        _ => format!("{value:.6}"),
    };
    let named = |quantities: &[Quantity<'_>], values: &[f64]| {
        let all = quantities.iter().zip(values);
        let all: Vec<String> = all
            .map(|(quantity, own)| format!("{}={}", quantity.name, value(quantity.dimension, *own)))
            .collect();
        all.join(",")
    };
    let start = named(description.inputs, inputs);
    if positions.is_empty() {
        let _ = write!(message, "; at {start} it does not close at all");
        return Fault::failed(message);
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
        ExtremesError::NothingCloses(error) => Fault::failed(error),
        error => Fault::wrong(error),
    }
}

fn of_exact_table(error: ExactTableError) -> Fault {
    match error {
        ExactTableError::NotClosed { .. } | ExactTableError::ChangePoint { .. } | ExactTableError::Lost { .. } => {
            Fault::failed(error)
        }
        error => Fault::wrong(error),
    }
}

/// The rows of a sweep whose extremes are sought.
const ROWS_OF_PEAKS: usize = 181;

/// The lowest and the highest value, and the root of the mean square.
fn extent_of<S: QuantitySource, Q: AskedQuantity<S>>(quantity: &QuantityAlong<'_, S, Q>) -> Result<Extent, Fault> {
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
    let lowest = reached().min_by(order);
    let highest = reached().max_by(order);
    let flat = |peak: kin_core::extremes::Peak| Reached {
        value: Some(peak.value),
        at: peak.at,
        is_limit: false,
    };
    // an extreme over a while, as in a dwell, is at no place
    let further = |known: Option<Reached>, peak: Result<kin_core::extremes::Peak, ExtremesError>, sign: f64| {
        let peak = flat(peak.map_err(of_extremes)?);
        Ok::<_, Fault>(match known {
            Some(known) if sign * (size(&peak) - size(&known)) <= 1e-12 * size(&peak).abs() => known,
            _ => peak,
        })
    };
    Ok(Extent {
        lowest: match unbounded(&all, false) {
            Some(lowest) => lowest,
            None => further(lowest, quantity.lowest(), -1.0)?,
        },
        highest: match unbounded(&all, true) {
            Some(highest) => highest,
            None => further(highest, quantity.highest(), 1.0)?,
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

impl Subject {
    /// A mechanism of which nothing is known but its declaration.
    pub(crate) fn of<M: Mechanism<Scalar = f64>>() -> Self {
        Self::new(*Of::<M>::FUNCTIONS)
    }

    /// A mechanism of the library.
    pub(crate) fn of_library(design: &Design) -> Result<Self, Fault> {
        let mechanism = kin_live::Mechanism::declare(design.declaration()).map_err(Fault::wrong)?;
        let inputs = design.inputs.to_vec();
        let assembly = match design.assembly {
            DesignAssembly::Named(name) => {
                let index = mechanism.assembly_names().iter().position(|own| own == name);
                index.map_or(Wanted::Unknown, Wanted::Named)
            }
            DesignAssembly::Near(near) => Wanted::At {
                inputs: inputs.clone(),
                near: near.to_vec(),
            },
        };
        Ok(Self {
            example: Some(Example {
                parameters: design.parameters.to_vec(),
                inputs,
                assembly,
            }),
            ..Self::new(mechanism)
        })
    }

    /// A mechanism by its functions.
    pub(crate) fn new(functions: impl CaseFunctions + 'static) -> Self {
        Self {
            functions: Arc::new(functions),
            example: None,
        }
    }

    /// Its quantities.
    pub(crate) fn description(&self) -> &Description<'_> {
        self.functions.description()
    }

    /// Its equations and their solution, as in a textbook.
    #[cfg(feature = "program")]
    pub(crate) fn formulas(&self) -> kin_core::any::Formulas<'_> {
        self.functions.formulas()
    }

    /// A text of kin-core with the names of the mechanism in the place of their indices.
    pub(crate) fn named(&self, text: impl fmt::Display) -> String {
        Named::new(text, self.description()).to_string()
    }

    /// Dimensions for which it closes, if they are known.
    pub(crate) fn example(&self) -> Option<&Example> {
        self.example.as_ref()
    }

    /// The names of its assemblies; none if they depend on the dimensions, an empty name if there is only one.
    pub(crate) fn assemblies(&self) -> Vec<String> {
        self.functions.assembly_names()
    }

    pub(super) fn linkage(&self, parameters: &[f64]) -> AnyLinkage<'_> {
        AnyLinkage::new(&*self.functions, parameters)
    }

    /// The assembly at the first inputs of a case.
    fn assembly(&self, case: &Case) -> Result<AssemblyChoice, Fault> {
        let linkage = self.linkage(&case.parameters);
        assembly_at(&case.assembly, &linkage, &case.ends()[0])
    }

    fn line(&self, case: &Case, rows: usize) -> Result<AnySweep<'_, StraightLine>, Fault> {
        let [from, to] = case.ends();
        let sweep = self.linkage(&case.parameters).sweep(self.assembly(case)?);
        Ok(sweep.between(&from, &to, rows).speed(case.speed()))
    }

    /// Calls `then` with the sweep under laws.
    fn under_laws<R>(
        &self,
        case: &Case,
        duration: f64,
        rows: usize,
        then: impl FnOnce(AnySweep<'_, Laws<'_>>) -> R,
    ) -> Result<R, Fault> {
        let laws = laws_of(case, duration)?;
        let laws: Vec<&dyn Piecewise<f64>> = laws.iter().map(|law| &**law).collect();
        let sweep = self.linkage(&case.parameters).sweep(self.assembly(case)?);
        Ok(then(sweep.under_laws(&laws, 0.0..=duration, rows)))
    }

    /// Whether it closes all along the motion, between the rows of tables too.
    pub(crate) fn closes(&self, case: &Case) -> Result<(), Fault> {
        // several laws lead along a curve, and one along a line
        const ROWS: usize = 721;
        let moving = case.motions.iter().filter(|motion| motion.moves()).count();
        if case.time_of_laws().is_some() && moving > 1 {
            let table = self.table(case, ROWS)?;
            let open = table.rows().find(|row| !row.outcome().is_solved());
            return open.map_or(Ok(()), |row| {
                let at = table.variable().values[row.index()];
                Err(Fault::failed(format!(
                    "the mechanism does not close at {} s",
                    text::digits(at)
                )))
            });
        }
        let (linkage, [from, end]) = (self.linkage(&case.parameters), case.ends());
        let assembly = self.assembly(case)?;
        let mut unknowns = linkage.position(&from, assembly.position()).map_err(Fault::failed)?;
        // several inputs go together to their ends, and one alone passes its stations
        let stations = case.motions[case.lead].stations();
        let mut inputs = from;
        for station in stations.into_iter().skip(1) {
            let mut next = end.clone();
            next[case.lead] = station;
            match linkage.track(&inputs, &unknowns, &next) {
                Ok(reached) => unknowns = reached,
                Err(error @ (TrackError::TurningPoint(_) | TrackError::Pole(_) | TrackError::Failed(_))) => {
                    return Err(Fault::failed(format!(
                        "the mechanism does not close all along the motion: {error}"
                    )));
                }
                // branches cross, or nothing certain is known
                Err(_) => return Ok(()),
            }
            inputs = next;
        }
        Ok(())
    }

    /// The table of a sweep.
    pub(crate) fn table(&self, case: &Case, rows: usize) -> Result<Table, Fault> {
        let functions = &*self.functions;
        match case.time_of_laws() {
            None => self.line(case, rows)?.table(functions),
            Some(duration) => self.under_laws(case, duration, rows, |sweep| sweep.table(functions))?,
        }
        .map_err(|error| of_sweep(&error))
    }

    /// The extremes of one derivative over a sweep.
    pub(crate) fn extent(&self, case: &Case, name: &str) -> Result<Extent, Fault> {
        match case.time_of_laws() {
            None => extent_of(&self.line(case, ROWS_OF_PEAKS)?.of(name)),
            Some(duration) => self.under_laws(case, duration, ROWS_OF_PEAKS, |sweep| extent_of(&sweep.of(name)))?,
        }
    }

    /// The bodies and joints.
    pub(crate) fn outline(&self) -> Outline<'_> {
        self.functions.outline()
    }

    /// The columns of forces that loads cause.
    pub(crate) fn forces(&self, stated: &Stated) -> ForceColumns {
        ForceColumns::of(&*self.functions, stated, stated.has_friction())
    }

    /// The forces of a case, if it has loads. Questions about several of them are answered faster by one of these.
    pub(crate) fn forces_of<'c>(&'c self, case: &'c Case) -> Option<CaseForces<'c>> {
        let loads = case.loads.as_ref()?;
        let reactions = self.reactions(case, loads);
        Some(CaseForces {
            subject: self,
            case,
            loads,
            reactions,
        })
    }

    fn reactions(&self, case: &Case, loads: &NamedLoads) -> Result<NamedReactions<'_>, Fault> {
        let reactions = case.stated.reactions(&self.linkage(&case.parameters), loads);
        reactions.map_err(Fault::wrong)
    }

    /// The contact whose bodies slip on each other where the motion begins, by its name, and why.
    pub(crate) fn slip(&self, case: &Case) -> Option<(String, ReactionError)> {
        let linkage = self.linkage(&case.parameters);
        let loads = case.loads.clone().unwrap_or_else(|| linkage.loads());
        let reactions = case.stated.joined(&linkage, &loads).ok()?;
        let assembly = self.assembly(case).ok()?;
        let error = reactions.check_contacts(&case.ends()[0], assembly.position()).err()?;
        match &error {
            ReactionError::Rolling { reaction, .. } => Some((reaction.clone(), error)),
            _ => None,
        }
    }

    /// The times inside of the motion at which the speed of an input jumps, where a mass has no bounded effort.
    pub(crate) fn speed_jumps(&self, case: &Case) -> Result<Vec<f64>, Fault> {
        let Some(duration) = case.time_of_laws() else {
            return Ok(Vec::new());
        };
        self.under_laws(case, duration, 2, |sweep| {
            let next = |after: f64| sweep.next_joint(after).filter(|joint| *joint < duration);
            let joints = std::iter::successors(next(0.0), |joint| next(*joint));
            let jumps = |joint: &f64| {
                let [left, right] = [Side::Left, Side::Right].map(|side| sweep.inputs(*joint, side));
                let mut speeds = left.iter().zip(&right).map(|(left, right)| (left[1], right[1]));
                speeds.any(|(left, right)| (right - left).abs() > 1e-9 * left.abs().max(right.abs()))
            };
            joints.filter(jumps).collect()
        })
    }

    /// The full cycle over the leading input.
    pub(crate) fn cycle(&self, case: &Case) -> Result<AnyCycle<'_>, Fault> {
        let [mut from, _] = case.ends();
        let mut direction = vec![0.0; from.len()];
        (from[case.lead], direction[case.lead]) = (0.0, 1.0);
        let linkage = self.linkage(&case.parameters);
        linkage.cycle_along(&from, &direction).map_err(Fault::failed)
    }

    /// What Grashof, Barker and others call the blocks.
    pub(crate) fn classes(&self, case: &Case) -> Vec<(&str, BlockClass)> {
        let forms = self.linkage(&case.parameters).block_forms();
        let blocks = self.description().blocks.iter().zip(&forms);
        let classes = blocks.filter_map(|(block, form)| Some((block.unknowns, BlockClass::of(form)?)));
        classes.collect()
    }

    /// The solver as data.
    pub(crate) fn tape(&self, options: &tape::Options) -> Result<Tape<'_>, RecordError> {
        tape::record_any::<f64>(&*self.functions, options)
    }

    /// The report, which is the content of a page.
    pub(crate) fn report(&self, case: &Case, wishes: &PageWishes) -> Result<Report, Fault> {
        let motion = &case.motions[case.lead];
        let ends = case.ends();
        let wished = Wishes {
            assembly: Some(self.assembly(case)?),
            plots: wishes.plots.clone(),
            title: wishes.title.clone(),
            documentation: wishes.documentation.clone(),
            declaration: wishes.declaration.clone(),
            length: case.length.to_owned(),
            degrees: case.in_degrees,
            has_peaks: wishes.has_peaks,
            loads: case.loads.clone().map(|loads| WishedLoads {
                loads,
                stated: case.stated.clone(),
                metres: case.metres(),
            }),
            ..Wishes::new(&*self.functions, &case.parameters)
        };
        let several = case.motions.iter().filter(|motion| motion.moves()).count() > 1;
        let report = if let Some(duration) = case.time_of_laws() {
            let laws = laws_of(case, duration)?;
            let laws = laws.iter().map(|law| &**law).collect();
            let way = WayWished::UnderLaws(laws, [0.0, duration]);
            Wishes { way, ..wished }.report()
        } else if several {
            let speed = Some(case.speed());
            let way = WayWished::Between(ends);
            Wishes { way, speed, ..wished }.report()
        } else {
            let (from, to) = (motion.start().min(motion.end()), motion.start().max(motion.end()));
            let [inputs, _] = ends;
            Wishes {
                at: Some(inputs),
                moving: Some(self.description().inputs[case.lead].name.to_owned()),
                range: wishes.has_range.then_some([from, to]),
                speed: Some((motion.end() - motion.start()).signum() * case.speed()),
                ..wished
            }
            .report()
        };
        report.map_err(|error| match error {
            ReportError::ClosesNowhere { .. } | ReportError::NoPosition { .. } => Fault::failed(error),
            error => Fault::wrong(error),
        })
    }

    /// The table that is exact between its rows.
    pub(crate) fn exact_table(&self, case: &Case, precision: Precision) -> Result<ExactTable, Fault> {
        const ROWS: usize = 13;
        match case.time_of_laws() {
            None => self.line(case, ROWS)?.exact_table(precision),
            Some(duration) => self.under_laws(case, duration, ROWS, |sweep| sweep.exact_table(precision))?,
        }
        .map_err(of_exact_table)
    }
}

/// The forces that the loads of a case cause.
pub(crate) struct CaseForces<'c> {
    subject: &'c Subject,
    case: &'c Case,
    loads: &'c NamedLoads,
    reactions: Result<NamedReactions<'c>, Fault>,
}

/// What are the extremes and the mean?
struct OfExtent;

impl ForceQuestion for OfExtent {
    type Answer = Result<Extent, Fault>;

    fn ask<S: QuantitySource, Q: AskedQuantity<S>>(&self, quantity: &QuantityAlong<'_, S, Q>) -> Self::Answer {
        extent_of(quantity)
    }
}

impl CaseForces<'_> {
    /// The extremes of a force and its mean, in units of the mechanism.
    pub(crate) fn extent(&self, force: &ForceColumn) -> Result<Extent, Fault> {
        self.ask(force, &OfExtent)?
    }

    /// The value of a force that is largest in size, in units of the mechanism.
    pub(crate) fn peak(&self, force: &ForceColumn) -> Result<Reached, Fault> {
        self.ask(force, &OfPeak)?.map_err(of_extremes)
    }

    /// The mean power of all drives, and what friction takes of it; none without friction.
    pub(crate) fn efficiency(&self) -> Option<Result<Efficiency, Fault>> {
        let Self { subject, case, .. } = self;
        let reactions = self
            .reactions
            .as_ref()
            .ok()
            .filter(|reactions| reactions.has_friction())?;
        let found = || {
            let found = match case.time_of_laws() {
                None => subject.line(case, ROWS_OF_PEAKS)?.efficiency(reactions),
                Some(duration) => {
                    subject.under_laws(case, duration, ROWS_OF_PEAKS, |sweep| sweep.efficiency(reactions))?
                }
            };
            found.map_err(of_extremes)
        };
        Some(found())
    }

    /// What a proof about its forces tells. It takes a motion at constant speed.
    pub(crate) fn proof<R>(&self, tell: impl FnOnce(ForceProof<'_>) -> R) -> Result<R, Fault> {
        let Self { subject, case, .. } = self;
        if case.time_of_laws().is_some() {
            return Err(Fault::wrong(
                "a proof takes a motion at constant speed, as in `--over '0..360deg at 500rpm'`, and no law",
            ));
        }
        let reactions = self.reactions.as_ref().map_err(Fault::clone)?;
        Ok(tell(subject.line(case, 2)?.proof(reactions)))
    }

    fn ask<A: ForceQuestion>(&self, force: &ForceColumn, question: &A) -> Result<A::Answer, Fault> {
        let Self { subject, case, .. } = self;
        match case.time_of_laws() {
            None => self.along(force, question, &subject.line(case, ROWS_OF_PEAKS)?),
            Some(duration) => subject.under_laws(case, duration, ROWS_OF_PEAKS, |sweep| {
                self.along(force, question, &sweep)
            })?,
        }
    }

    fn along<A: ForceQuestion, D: SmoothDrive>(
        &self,
        ForceColumn { force, order }: &ForceColumn,
        question: &A,
        sweep: &AnySweep<'_, D>,
    ) -> Result<A::Answer, Fault> {
        let causes = Causes {
            loads: self.loads,
            reactions: self.reactions.as_ref().ok(),
            has_friction: self.case.stated.has_friction(),
        };
        match (causes.ask(force, *order, sweep, question), &self.reactions) {
            (Some(answer), _) => Ok(answer),
            (None, Err(fault)) => Err(fault.clone()),
            (None, Ok(_)) => Err(Fault::wrong("the forces in joints are not known")),
        }
    }

    /// Forces in the rows of a sweep, in their units.
    pub(crate) fn columns(&self, rows: usize, forces: &[ForceColumn]) -> Result<Vec<Vec<f64>>, Fault> {
        let Self { subject, case, .. } = self;
        match case.time_of_laws() {
            None => self.columns_along(forces, &subject.line(case, rows)?),
            Some(duration) => subject.under_laws(case, duration, rows, |sweep| self.columns_along(forces, &sweep))?,
        }
    }

    fn columns_along<D: SmoothDrive>(
        &self,
        forces: &[ForceColumn],
        sweep: &AnySweep<'_, D>,
    ) -> Result<Vec<Vec<f64>>, Fault> {
        let columns = forces.iter().map(|column| {
            let values = self.along(column, &OfRows, sweep)?.map_err(of_extremes)?;
            let size = column.size(self.subject.description(), self.case.metres());
            Ok(values.into_iter().map(|value| value * size).collect())
        });
        columns.collect()
    }

    /// The bodies of a force in a joint: the one on which it acts, and the one that exerts it. A drive has none.
    pub(crate) fn bodies_of(&self, force: &Force) -> [String; 2] {
        match (force, &self.reactions) {
            (Force::Reaction(name, _), Ok(reactions)) => reactions.bodies_of(name).unwrap_or_default(),
            _ => Default::default(),
        }
    }
}

/// The motions as laws over a time.
fn laws_of(case: &Case, duration: f64) -> Result<Vec<Box<dyn Piecewise<f64>>>, Fault> {
    let laws: Result<_, _> = case.motions.iter().map(|motion| motion.law(duration)).collect();
    laws.map_err(Fault::wrong)
}

pub(super) fn assembly_at(wanted: &Wanted, linkage: &AnyLinkage<'_>, start: &[f64]) -> Result<AssemblyChoice, Fault> {
    match wanted {
        Wanted::Named(index) if *index < linkage.assembly_count() => Ok(AssemblyChoice::Index(*index)),
        Wanted::Named(_) => Err(Fault::wrong("there is no assembly of this number")),
        Wanted::Near(values) => Ok(linkage.assembly_at(start, values)),
        Wanted::At { inputs, near } => {
            let unknowns = linkage
                .position(inputs, PositionChoice::Near(near))
                .map_err(Fault::failed)?;
            let there = linkage.track(inputs, &unknowns, start).map_err(Fault::failed)?;
            Ok(linkage.assembly_at(start, &there))
        }
        Wanted::Unknown => {
            let (positions, _) = linkage.positions_at(start).map_err(Fault::failed)?;
            Err(unnamed(linkage.description(), &positions, start))
        }
    }
}

impl From<LengthMismatch> for Fault {
    fn from(mismatch: LengthMismatch) -> Self {
        Self::wrong(mismatch)
    }
}
