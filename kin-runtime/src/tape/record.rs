//! The recording of a solver.

use core::error::Error;
use core::fmt;
use std::format;
use std::string::{String, ToString as _};
use std::vec::Vec;

use crate::any::{
    Described, MotionOver, Of, Pictured, PositionChoice, PositionOver, SkeletonOver, assembly, motions, row,
};
use crate::assembly::Assembly;
use crate::failure::SolveError;
use crate::mechanism::{Mechanism, Partials, Sensitive};
use crate::number::Number;
use crate::picture::Outline;
use crate::quantity::{Dimension, Name, Quantity};
use crate::solve::Scalar;
use crate::tape::arrange::arrange;
use sealed::Sealed as _;

use crate::tape::recorder::{self, AssemblySource, Recorder, with};
use crate::tape::structure::{self, Argument, NumberType, ResultOf, Role, TapeNode, TapeResult, Value};
use crate::tape::{Recorded, Tape};

/// A number type for which tapes are recorded: `f64` or `f32`.
pub trait Plain: sealed::Sealed {}

mod sealed {
    use super::{Options, RecordError, Solver};
    use crate::solve::Scalar;
    use crate::tape::structure::Tape;

    pub trait Sealed: Scalar {
        /// The tape of a solver. It is compiled once, here.
        fn tape<'d>(solver: Solver<'d, Self>, options: &Options, at: &[f64]) -> Result<Tape<'d>, RecordError>;
    }
}

macro_rules! plain {
    ($($number:ty: $precision:ident,)*) => {
        $(
            impl Plain for $number {}

            impl sealed::Sealed for $number {
                fn tape<'d>(
                    solver: Solver<'d, Self>,
                    options: &Options,
                    at: &[f64],
                ) -> Result<structure::Tape<'d>, RecordError> {
                    recorded(&solver, NumberType::$precision, options, at)
                }
            }
        )*
    };
}

plain! { f64: Double, f32: Single, }

/// What a tape contains.
#[derive(Clone, Debug, Default, PartialEq)]
#[must_use]
pub struct Options {
    order: Option<usize>,
    has_skeleton: bool,
    folded: Option<Vec<f64>>,
}

impl Options {
    /// All orders of all unknowns and outputs; the dimensions are arguments.
    pub fn new() -> Self {
        Self::default()
    }

    /// Time derivatives up to this order only: 0 is the position. An order beyond that of the mechanism changes
    /// nothing.
    pub fn up_to(self, order: usize) -> Self {
        Self {
            order: Some(order),
            ..self
        }
    }

    /// The skeleton as well: its joints and the directions of its slides.
    pub fn with_skeleton(self) -> Self {
        Self {
            has_skeleton: true,
            ..self
        }
    }

    /// These dimensions as constants, in the order of the description. They are no arguments then.
    pub fn with_dimensions(self, dimensions: &[f64]) -> Self {
        Self {
            folded: Some(dimensions.to_vec()),
            ..self
        }
    }
}

/// The reason why a solver cannot be recorded.
#[derive(Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum RecordError {
    /// The solver took a decision that is not a named check.
    DecidedByValue,
    /// The solver fails whatever its numbers are.
    NeverSolved {
        /// The block that fails.
        block: Name,
    },
    /// The number of dimensions that are to be constants is not that of the mechanism.
    WrongDimensions {
        /// The number that was given.
        given: usize,
        /// The number of scalar parameters.
        wanted: usize,
    },
}

impl fmt::Display for RecordError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::DecidedByValue => formatter.write_str(
                "the solver took a decision that is not one of its named checks, so its record would hold for some \
                 numbers only",
            ),
            Self::NeverSolved { block } => write!(
                formatter,
                "the block `{block}` has no solution with these \
                constants"
            ),
            Self::WrongDimensions { given, wanted } => {
                write!(
                    formatter,
                    "{given} dimensions are given, and the mechanism has {wanted}"
                )
            }
        }
    }
}

crate::__debug_by_display!(RecordError);

impl Error for RecordError {}

/// The solver of a mechanism as a tape, in the number type of the mechanism: `FourBar` in double precision,
/// `FourBar<f32>` in single precision.
///
/// One tape serves all assemblies: the choice of each block is an argument. The dimensions are arguments, too, unless
/// the [options](Options::with_dimensions) fold them in.
///
/// # Errors
/// See [`RecordError`].
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::tape::{self, Options};
///
/// let tape = tape::record::<FourBar>(&Options::new())?;
/// // four dimensions, the crank's motion, the assembly
/// assert_eq!(tape.arguments.len(), 4 + 5 + 1);
/// assert_eq!(tape.results.len(), 2 * 5);
/// let found = tape.run(&[90.0, 30.0, 60.0, 45.0, 1.0, -10.0, 2.0, -0.5, 0.3, 1.0]).unwrap();
/// println!("{} rad", found[5]);
/// # Ok::<(), tape::RecordError>(())
/// ```
pub fn record<M: Mechanism<Scalar: Plain>>(options: &Options) -> Result<Tape, RecordError> {
    record_any::<M::Scalar>(Of::<M>::FUNCTIONS, options)
}

/// [`record`] without the type of the mechanism. The tape borrows its names.
///
/// # Errors
/// See [`RecordError`].
///
/// ```
/// use kin_core::any::Of;
/// use kin_core::library::SliderCrank;
/// use kin_core::tape::{self, Options};
///
/// let tape = tape::record_any::<f64>(Of::<SliderCrank>::FUNCTIONS, &Options::new())?;
/// assert_eq!(tape, tape::record::<SliderCrank>(&Options::new())?);
/// # Ok::<(), tape::RecordError>(())
/// ```
pub fn record_any<'d, F: Plain>(
    mechanism: &'d dyn RecordedFunctions<F>,
    options: &Options,
) -> Result<structure::Tape<'d>, RecordError> {
    let solver = Solver {
        mechanism,
        more: |_| Ok(Vec::new()),
    };
    F::tape(solver, options, &[])
}

/// [`record`] at one position: wherever the solver asks for the value of an argument, it is the one given here. The
/// tape is the same at all positions. Its checks do not know their blocks.
#[doc(hidden)]
pub fn record_at<M: Mechanism<Scalar: Plain>>(options: &Options, at: &[f64]) -> Result<Tape, RecordError> {
    let solver = Solver {
        mechanism: Of::<M>::FUNCTIONS,
        more: |_| Ok(Vec::new()),
    };
    M::Scalar::tape(solver, options, at)
}

/// [`record`], with the partial derivatives of every unknown and output with respect to each parameter.
///
/// # Errors
/// See [`RecordError`].
pub fn record_with_sensitivities<M>(options: &Options) -> Result<Tape, RecordError>
where
    M: Mechanism<Scalar: Plain>,
    M::With<Recorded<M::Scalar>>: Sensitive,
{
    let solver = Solver {
        mechanism: Of::<M>::FUNCTIONS,
        more: partials::<M::With<Recorded<M::Scalar>>, _>,
    };
    M::Scalar::tape(solver, options, &[])
}

/// The partial derivatives as results. The pose is solved once more, which records nothing new.
fn partials<R, F>(arguments: &SolverArguments<'_, Recorded<F>>) -> Result<Vec<TapeResult<'static>>, SolveError>
where
    R: Sensitive + Mechanism<Scalar = Recorded<F>>,
{
    let mechanism = R::from_parameters(row(arguments.parameters));
    let inputs = motions(arguments.inputs);
    let pose = match arguments.choice {
        PositionChoice::Assembly(index) => mechanism.solve(inputs, assembly::<R>(index)),
        PositionChoice::Near(near) => mechanism.solve_near(inputs, row(near)),
    }?;
    let description = R::DESCRIPTION;
    let partials = mechanism.sensitivities_of(&pose);
    let mut results = Vec::new();
    let parameters = description.parameters.iter().zip(partials.as_ref());
    for (parameter, (by, partials)) in parameters.enumerate() {
        let (unknowns, outputs) = (partials.unknown_partials(), partials.output_partials());
        let unknowns = description.unknowns.iter().zip(unknowns.as_ref());
        for (unknown, (quantity, motion)) in unknowns.enumerate() {
            let partial = ResultOf::UnknownPartial { unknown, parameter };
            let name = format!("{}.{}", by.name, quantity.name);
            results.extend(orders(partial, &name, quantity, motion.as_ref()));
        }
        let outputs = description.outputs.iter().zip(outputs.as_ref());
        for (output, (quantity, motion)) in outputs.enumerate() {
            let partial = ResultOf::OutputPartial { output, parameter };
            let name = format!("{}.{}", by.name, quantity.name);
            results.extend(orders(partial, &name, quantity, motion.as_ref()));
        }
    }
    Ok(results)
}

/// All orders of a quantity.
fn orders<'d, F>(
    quantity_of_results: ResultOf,
    name: &str,
    quantity: &Quantity<'d>,
    motion: &[Recorded<F>],
) -> Vec<TapeResult<'d>> {
    let outcome = |(order, number): (usize, &Recorded<F>)| TapeResult {
        quantity: quantity_of_results,
        order,
        name: name.to_string(),
        dimension: quantity.dimension,
        description: quantity.description,
        value: number.value(),
    };
    motion.iter().enumerate().map(outcome).collect()
}

/// What a run of the solver is to find out besides.
#[derive(Clone, Copy, Default)]
struct RunOptions {
    /// The choice that is crossed; the others are open.
    crossed_choice: Option<usize>,
    crossed_side: Option<usize>,
    fails: Option<usize>,
}

/// A record with its arguments, its results and its error.
struct Run<'d> {
    recorder: Recorder,
    arguments: Vec<Argument<'d>>,
    results: Result<Vec<TapeResult<'d>>, SolveError>,
}

/// The functions of a mechanism from which a tape is recorded.
pub trait RecordedFunctions<F>:
    Described + Pictured + PositionOver<Recorded<F>> + MotionOver<Recorded<F>> + SkeletonOver<Recorded<F>>
{
}

impl<F, S> RecordedFunctions<F> for S where
    S: Described + Pictured + PositionOver<Recorded<F>> + MotionOver<Recorded<F>> + SkeletonOver<Recorded<F>>
{
}

/// Finds further results.
type More<'d, F> = fn(&SolverArguments<'_, Recorded<F>>) -> Result<Vec<TapeResult<'d>>, SolveError>;

/// What is recorded.
pub struct Solver<'d, F> {
    mechanism: &'d dyn RecordedFunctions<F>,
    /// Finds further results.
    more: More<'d, F>,
}

/// What a solver is given.
pub(super) struct SolverArguments<'s, T> {
    parameters: &'s [T],
    /// The motions of the inputs, one after the other, each with all its orders.
    inputs: &'s [T],
    choice: PositionChoice<'s, T>,
}

/// The tape, with the values `at` of the arguments wherever the solver asks for values.
fn recorded<'d, F: Scalar>(
    solver: &Solver<'d, F>,
    precision: NumberType,
    options: &Options,
    at: &[f64],
) -> Result<structure::Tape<'d>, RecordError> {
    let mechanism = solver.mechanism;
    let description = mechanism.description();
    if let Some(folded) = &options.folded
        && folded.len() != description.parameters.len()
    {
        return Err(RecordError::WrongDimensions {
            given: folded.len(),
            wanted: description.parameters.len(),
        });
    }
    let choices = (mechanism.assembly_count() > 0).then(|| mechanism.choices());
    let run = |sources: &[AssemblySource], probe: RunOptions| {
        let recorder = Recorder::new(precision, sources.to_vec(), at);
        run(solver, options, choices.as_deref(), recorder, probe)
    };

    // Which choice of the caller, or which side, each of the assemblies follows that the solver asks for.
    let plain = run(&[], RunOptions::default());
    let mut sources: Vec<AssemblySource> = plain
        .recorder
        .asked
        .iter()
        .map(|assembly| AssemblySource::Fixed(*assembly))
        .collect();
    let mut follow = |probe: RunOptions, source: &dyn Fn(bool) -> AssemblySource| {
        let crossed = run(&[], probe).recorder.asked;
        let asked = plain.recorder.asked.iter().zip(crossed);
        for (kept, (open, crossed)) in sources.iter_mut().zip(asked) {
            if *open != crossed {
                *kept = source(*open == Assembly::Crossed);
            }
        }
    };
    for index in 0..choices.as_ref().map_or(0, Vec::len) {
        let probe = RunOptions {
            crossed_choice: Some(index),
            ..RunOptions::default()
        };
        follow(probe, &|is_mirrored| AssemblySource::Choice { index, is_mirrored });
    }
    for index in 0..plain.recorder.sides.len() {
        let probe = RunOptions {
            crossed_side: Some(index),
            ..RunOptions::default()
        };
        follow(probe, &|is_mirrored| AssemblySource::Side { index, is_mirrored });
    }

    let Run {
        recorder,
        arguments,
        results,
    } = run(&sources, RunOptions::default());
    let results = results.map_err(|error| RecordError::NeverSolved { block: error.block })?;
    if recorder.is_read && at.is_empty() {
        return Err(RecordError::DecidedByValue);
    }
    let order = description.order.min(options.order.unwrap_or(usize::MAX));
    let is_wanted = |result: &TapeResult<'_>| result.order <= order;
    let mut tape = structure::Tape {
        description: *description,
        outline: if options.has_skeleton {
            mechanism.outline()
        } else {
            Outline::NONE
        },
        precision,
        order,
        folded: options.folded.clone().unwrap_or_default(),
        arguments,
        nodes: Vec::new(),
        steps: Vec::new(),
        results: results.into_iter().filter(is_wanted).collect(),
        checks: Vec::new(),
        searches: Vec::new(),
        systems: Vec::new(),
        solutions: Vec::new(),
    };
    arrange(&recorder, &mut tape, |check| {
        if !at.is_empty() {
            return Name::NONE;
        }
        let probe = RunOptions {
            fails: Some(check.number),
            ..RunOptions::default()
        };
        run(&sources, probe)
            .results
            .err()
            .map_or(Name::NONE, |error| error.block)
    });
    Ok(tape)
}

/// Runs the solver once.
fn run<'d, F: Scalar>(
    solver: &Solver<'d, F>,
    options: &Options,
    choices: Option<&[String]>,
    mut recorder: Recorder,
    probe: RunOptions,
) -> Run<'d> {
    let description = solver.mechanism.description();
    (recorder.fails, recorder.crossed_side) = (probe.fails, probe.crossed_side);
    let before = recorder::begin(recorder);

    let mut arguments = Vec::new();
    let mut argument = |role: Role, name: &str, dimension: Dimension, text: &'d str| -> Recorded<F> {
        let index = arguments.len();
        arguments.push(Argument {
            role,
            name: name.to_string(),
            dimension,
            description: text,
        });
        Recorded::at(with(|recorder| recorder.put(TapeNode::Argument(index))))
    };
    let mut parameters = Vec::new();
    for (index, parameter) in description.parameters.iter().enumerate() {
        parameters.push(match &options.folded {
            Some(folded) => Number::constant(folded[index]),
            None => argument(
                Role::Parameter(index),
                parameter.name,
                parameter.dimension,
                parameter.description,
            ),
        });
    }
    let mut inputs = Vec::new();
    for (input, quantity) in description.inputs.iter().enumerate() {
        for order in 0..=description.order {
            inputs.push(argument(
                Role::Input { input, order },
                quantity.name,
                quantity.dimension,
                quantity.description,
            ));
        }
    }
    let mut near = Vec::new();
    if choices.is_none() {
        for (index, unknown) in description.unknowns.iter().enumerate() {
            near.push(argument(
                Role::Near(index),
                unknown.name,
                unknown.dimension,
                unknown.description,
            ));
        }
    }
    let choices = choices.unwrap_or_default();
    let sign = |(index, name): (usize, &String)| {
        let text = "1 for the open assembly, -1 for the crossed one.";
        argument(Role::Assembly(index), name, Dimension::Scalar, text).value()
    };
    let signs: Vec<Value> = choices.iter().enumerate().map(sign).collect();
    with(|recorder| recorder.choices = signs);

    let number = probe
        .crossed_choice
        .map_or(0, |choice| 1 << (choices.len() - 1 - choice));
    let arguments_of_solver = SolverArguments {
        parameters: &parameters,
        inputs: &inputs,
        choice: if near.is_empty() {
            PositionChoice::Assembly(number)
        } else {
            PositionChoice::Near(&near)
        },
    };
    let results = solved(solver, options, &arguments_of_solver);
    let recorder = recorder::begin(before);
    Run {
        recorder,
        arguments,
        results,
    }
}

/// The position first, so that its checks are distinguished from those of its rates, then all orders.
fn solved<'d, F: Scalar>(
    solver: &Solver<'d, F>,
    options: &Options,
    arguments: &SolverArguments<'_, Recorded<F>>,
) -> Result<Vec<TapeResult<'d>>, SolveError> {
    let mechanism = solver.mechanism;
    let (description, count) = (mechanism.description(), mechanism.description().order + 1);
    let &SolverArguments {
        parameters,
        inputs,
        choice,
    } = arguments;
    // numbers that are written over, so that nothing is recorded for them
    let room = |quantities: usize| std::vec![inputs[0]; quantities];
    let values = |motions: &[Recorded<F>]| motions.iter().copied().step_by(count).collect::<Vec<_>>();
    let phase = |is_of_position: bool| with(|recorder| recorder.is_of_position = is_of_position);
    phase(true);
    let input_values = values(inputs);
    mechanism.position(parameters, &input_values, choice, &mut room(description.unknowns.len()))?;
    phase(false);
    let [mut unknowns, mut outputs] = [description.unknowns, description.outputs].map(|all| room(all.len() * count));
    mechanism.motion(parameters, inputs, choice, &mut unknowns, &mut outputs)?;
    let mut results = Vec::new();
    let motions = description.unknowns.iter().zip(unknowns.chunks_exact(count));
    for (index, (quantity, motion)) in motions.enumerate() {
        results.extend(orders(ResultOf::Unknown(index), quantity.name, quantity, motion));
    }
    let motions = description.outputs.iter().zip(outputs.chunks_exact(count));
    for (index, (quantity, motion)) in motions.enumerate() {
        results.extend(orders(ResultOf::Output(index), quantity.name, quantity, motion));
    }
    results.extend((solver.more)(arguments)?);
    if options.has_skeleton {
        let mut all: Vec<Vec<Recorded<F>>> = Vec::new();
        mechanism.skeleton_points(parameters, &input_values, &values(&unknowns), &mut |point| {
            all.push(point.to_vec());
        });
        let joints = all.len().saturating_sub(mechanism.outline().slides.len());
        for (index, point) in all.iter().enumerate() {
            for (axis, (letter, number)) in ["x", "y", "z"].into_iter().zip(point).enumerate() {
                let (quantity, name) = match index.checked_sub(joints) {
                    None => (
                        ResultOf::Joint { joint: index, axis },
                        format!("joints.{index}.{letter}"),
                    ),
                    Some(slide) => (ResultOf::Slide { slide, axis }, format!("slides.{slide}.{letter}")),
                };
                results.push(TapeResult {
                    quantity,
                    order: 0,
                    name,
                    dimension: Dimension::Length,
                    description: "",
                    value: number.value(),
                });
            }
        }
    }
    Ok(results)
}
