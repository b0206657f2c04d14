//! The recording of a solver.

use core::error::Error;
use core::fmt;
use std::format;
use std::string::{String, ToString as _};
use std::vec::Vec;

use crate::assembly::Assembly;
use crate::failure::SolveError;
use crate::mechanism::{Mechanism, Partials, Pose, Sensitive};
use crate::number::{Number, Row};
use crate::picture::{Outline, PlaneOrSpace, PointArray};
use crate::quantity::{Dimension, Quantity};
use crate::solve::Scalar;
use crate::tape::arrange::arrange;
use crate::tape::recorder::{self, AssemblySource, Recorder, with};
use crate::tape::{Argument, NumberType, Recorded, ResultOf, Role, Tape, TapeNode, TapeResult, Value};

/// A number type for which tapes are recorded: `f64` or `f32`.
pub trait Plain: Scalar + sealed::Sealed {
    /// The number type as a value.
    const PRECISION: NumberType;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f64 {}
    impl Sealed for f32 {}
}

impl Plain for f64 {
    const PRECISION: NumberType = NumberType::Double;
}

impl Plain for f32 {
    const PRECISION: NumberType = NumberType::Single;
}

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

    /// Time derivatives up to this order only: 0 is the position. An order beyond that of the mechanism changes nothing.
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
        block: &'static str,
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
                "the solver took a decision that is not one of its named checks, so its record would hold for some numbers only",
            ),
            Self::NeverSolved { block } => write!(formatter, "the block `{block}` has no solution with these constants"),
            Self::WrongDimensions { given, wanted } => {
                write!(formatter, "{given} dimensions are given, and the mechanism has {wanted}")
            }
        }
    }
}

crate::__debug_by_display!(RecordError);

impl Error for RecordError {}

/// The solver of a mechanism as a tape, in the number type of the mechanism: `FourBar` in double precision, `FourBar<f32>` in
/// single precision.
///
/// One tape serves all assemblies: the choice of each block is an argument. The dimensions are arguments, too, unless the
/// [options](Options::with_dimensions) fold them in.
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
    recorded::<M>(options, &[], |_, _| Vec::new())
}

/// [`record`] at a place: wherever the solver asks for the value of an argument, it is the one given here. The tape is the same at
/// all places. Its checks do not know their blocks.
#[doc(hidden)]
pub fn record_at<M: Mechanism<Scalar: Plain>>(options: &Options, at: &[f64]) -> Result<Tape, RecordError> {
    recorded::<M>(options, at, |_, _| Vec::new())
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
    recorded::<M>(options, &[], partials::<M, M::With<Recorded<M::Scalar>>>)
}

/// The partial derivatives as results.
fn partials<M, R>(mechanism: &R, pose: &R::Pose) -> Vec<TapeResult>
where
    M: Mechanism<Scalar: Plain>,
    R: Sensitive + Mechanism<Scalar = Recorded<M::Scalar>>,
{
    let description = R::DESCRIPTION;
    let partials = mechanism.sensitivities_of(pose);
    let mut results = Vec::new();
    let parameters = description.parameters.iter().zip(partials.as_ref());
    for (parameter, (by, partials)) in parameters.enumerate() {
        let (unknowns, outputs) = (partials.unknown_partials(), partials.output_partials());
        let unknowns = description.unknowns.iter().zip(unknowns.as_ref());
        for (unknown, (quantity, motion)) in unknowns.enumerate() {
            let own = ResultOf::UnknownPartial { unknown, parameter };
            let name = format!("{}.{}", by.name, quantity.name);
            results.extend(orders(own, &name, quantity, motion.as_ref()));
        }
        let outputs = description.outputs.iter().zip(outputs.as_ref());
        for (output, (quantity, motion)) in outputs.enumerate() {
            let own = ResultOf::OutputPartial { output, parameter };
            let name = format!("{}.{}", by.name, quantity.name);
            results.extend(orders(own, &name, quantity, motion.as_ref()));
        }
    }
    results
}

/// All orders of a quantity.
fn orders<F>(own: ResultOf, name: &str, quantity: &Quantity, motion: &[Recorded<F>]) -> Vec<TapeResult> {
    let outcome = |(order, number): (usize, &Recorded<F>)| TapeResult {
        quantity: own,
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
struct Run {
    recorder: Recorder,
    arguments: Vec<Argument>,
    results: Result<Vec<TapeResult>, SolveError>,
}

/// The tape, with the values `at` of the arguments wherever the solver asks for values.
pub(super) fn recorded<M: Mechanism<Scalar: Plain>>(
    options: &Options,
    at: &[f64],
    more: impl Fn(&M::With<Recorded<M::Scalar>>, &<M::With<Recorded<M::Scalar>> as Mechanism>::Pose) -> Vec<TapeResult>,
) -> Result<Tape, RecordError> {
    let description = M::DESCRIPTION;
    if let Some(folded) = &options.folded
        && folded.len() != description.parameters.len()
    {
        return Err(RecordError::WrongDimensions {
            given: folded.len(),
            wanted: description.parameters.len(),
        });
    }
    let choices = if M::ASSEMBLY_COUNT > 0 {
        M::ASSEMBLY_COUNT.trailing_zeros() as usize
    } else {
        0
    };
    let run = |sources: &[AssemblySource], probe: RunOptions| run::<M>(options, at, choices, sources, probe, &more);

    // Which choice of the caller, or which side, each of the assemblies follows that the solver asks for.
    let plain = run(&[], RunOptions::default());
    let mut sources: Vec<AssemblySource> = plain
        .recorder
        .asked
        .iter()
        .map(|own| AssemblySource::Fixed(*own))
        .collect();
    let mut follow = |probe: RunOptions, source: &dyn Fn(bool) -> AssemblySource| {
        let crossed = run(&[], probe).recorder.asked;
        let asked = plain.recorder.asked.iter().zip(crossed);
        for (own, (open, crossed)) in sources.iter_mut().zip(asked) {
            if *open != crossed {
                *own = source(*open == Assembly::Crossed);
            }
        }
    };
    for index in 0..choices {
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
    let is_wanted = |result: &TapeResult| result.order <= order;
    let mut tape = Tape {
        description,
        outline: if options.has_skeleton {
            M::OUTLINE
        } else {
            Outline::NONE
        },
        precision: M::Scalar::PRECISION,
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
            return "";
        }
        let probe = RunOptions {
            fails: Some(check.number),
            ..RunOptions::default()
        };
        run(&sources, probe).results.err().map_or("", |error| error.block)
    });
    Ok(tape)
}

/// Runs the solver once.
fn run<M: Mechanism<Scalar: Plain>>(
    options: &Options,
    at: &[f64],
    choices: usize,
    sources: &[AssemblySource],
    probe: RunOptions,
    more: &impl Fn(&M::With<Recorded<M::Scalar>>, &<M::With<Recorded<M::Scalar>> as Mechanism>::Pose) -> Vec<TapeResult>,
) -> Run {
    type R<M> = <M as Mechanism>::With<Recorded<<M as Mechanism>::Scalar>>;
    type Found<M> = Recorded<<M as Mechanism>::Scalar>;

    let description = M::DESCRIPTION;
    let mut started = Recorder::new(M::Scalar::PRECISION, sources.to_vec(), at);
    started.fails = probe.fails;
    started.crossed_side = probe.crossed_side;
    let before = recorder::begin(started);

    let mut arguments = Vec::new();
    let mut argument = |role: Role, name: &str, dimension: Dimension, text: &'static str| -> Found<M> {
        let index = arguments.len();
        arguments.push(Argument {
            role,
            name: name.to_string(),
            dimension,
            description: text,
        });
        Recorded::at(with(|recorder| recorder.put(TapeNode::Argument(index))))
    };
    let parameters = <<R<M> as Mechanism>::Parameters<Found<M>> as Row<_>>::from_fn(|index| {
        if let Some(folded) = &options.folded {
            return <Found<M> as Number>::constant(folded[index]);
        }
        let own = &description.parameters[index];
        argument(Role::Parameter(index), own.name, own.dimension, own.description)
    });
    let inputs = <<R<M> as Mechanism>::Inputs<<R<M> as Mechanism>::Motion<Found<M>>> as Row<_>>::from_fn(|input| {
        let own = &description.inputs[input];
        <<R<M> as Mechanism>::Motion<Found<M>> as Row<_>>::from_fn(|order| {
            argument(Role::Input { input, order }, own.name, own.dimension, own.description)
        })
    });
    let is_coupled = M::ASSEMBLY_COUNT == 0;
    let near = is_coupled.then(|| {
        <<R<M> as Mechanism>::Unknowns<Found<M>> as Row<_>>::from_fn(|index| {
            let own = &description.unknowns[index];
            argument(Role::Near(index), own.name, own.dimension, own.description)
        })
    });
    let signs: Vec<Value> = choice_names::<M>(choices)
        .iter()
        .enumerate()
        .map(|(index, name)| {
            let text = "1 for the open assembly, -1 for the crossed one.";
            argument(Role::Assembly(index), name, Dimension::Scalar, text).value()
        })
        .collect();
    with(|recorder| recorder.choices = signs);

    let mechanism = R::<M>::from_parameters(parameters);
    let places = Row::from_fn(|input| inputs[input][0]);
    let number = probe.crossed_choice.map_or(0, |choice| 1 << (choices - 1 - choice));
    let results = solved(&mechanism, places, inputs, near, number).map(|pose| {
        let mut results = results_of::<R<M>, _>(&pose);
        results.extend(more(&mechanism, &pose));
        if options.has_skeleton {
            let unknowns = pose.unknown_motions();
            let unknowns = Row::from_fn(|unknown| unknowns[unknown][0]);
            results.extend(joints(&mechanism, places, unknowns));
        }
        results
    });
    let recorder = recorder::begin(before);
    Run {
        recorder,
        arguments,
        results,
    }
}

/// The position first, so that its checks are told from those of its rates, then all orders.
fn solved<F, R>(
    mechanism: &R,
    places: R::Inputs<R::Scalar>,
    inputs: R::Inputs<R::Motion<R::Scalar>>,
    near: Option<R::Unknowns<R::Scalar>>,
    assembly: usize,
) -> Result<R::Pose, SolveError>
where
    R: Mechanism<Scalar = Recorded<F>>,
    Recorded<F>: Scalar,
{
    let phase = |is_of_position: bool| with(|recorder| recorder.is_of_position = is_of_position);
    phase(true);
    match (near, R::assembly(assembly)) {
        (Some(near), _) => {
            mechanism.solve_position_near(places, near)?;
            phase(false);
            mechanism.solve_motion_near(inputs, near)
        }
        (None, Some(assembly)) => {
            mechanism.solve_position(places, assembly)?;
            phase(false);
            mechanism.solve_motion(inputs, assembly)
        }
        (None, None) => Err(crate::failure::Failure::NotFinite { quantity: "assembly" }.at(
            "",
            crate::failure::InputValues::new(&[], &[0.0; crate::failure::InputValues::CAPACITY]),
        )),
    }
}

/// The motions of the unknowns and of the outputs.
fn results_of<R, F>(pose: &R::Pose) -> Vec<TapeResult>
where
    R: Mechanism<Scalar = Recorded<F>>,
    Recorded<F>: Scalar,
{
    let description = R::DESCRIPTION;
    let (unknowns, outputs) = (pose.unknown_motions(), pose.output_motions());
    let mut results = Vec::new();
    for (index, (quantity, motion)) in description.unknowns.iter().zip(unknowns.as_ref()).enumerate() {
        results.extend(orders(
            ResultOf::Unknown(index),
            quantity.name,
            quantity,
            motion.as_ref(),
        ));
    }
    for (index, (quantity, motion)) in description.outputs.iter().zip(outputs.as_ref()).enumerate() {
        results.extend(orders(
            ResultOf::Output(index),
            quantity.name,
            quantity,
            motion.as_ref(),
        ));
    }
    results
}

fn joints<R, F>(mechanism: &R, inputs: R::Inputs<Recorded<F>>, unknowns: R::Unknowns<Recorded<F>>) -> Vec<TapeResult>
where
    R: Mechanism<Scalar = Recorded<F>>,
    Recorded<F>: Scalar,
{
    let places = mechanism.places(inputs, unknowns);
    let places = places.as_slice();
    let count = places.len().saturating_sub(R::OUTLINE.slides.len());
    let mut results = Vec::new();
    for (index, place) in places.iter().enumerate() {
        let point = place.in_space();
        let axes = [("x", point.x), ("y", point.y), ("z", point.z)];
        let is_plane = <<R::Places as PointArray>::Point as PlaneOrSpace>::IS_PLANE;
        for (axis, (letter, number)) in axes.into_iter().enumerate().take(if is_plane { 2 } else { 3 }) {
            let (quantity, name) = if index < count {
                (
                    ResultOf::Joint { joint: index, axis },
                    format!("joints.{index}.{letter}"),
                )
            } else {
                let slide = index - count;
                (ResultOf::Slide { slide, axis }, format!("slides.{slide}.{letter}"))
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
    results
}

/// The names of the choices: the fields of the assembly structure.
fn choice_names<M: Mechanism>(choices: usize) -> Vec<String> {
    if choices < 2 {
        return std::vec!["assembly".to_string(); choices];
    }
    // The structure is read as it shows itself: `Name { first: Open, second: Open }`.
    let shown = M::assembly(0)
        .map(|assembly| format!("{assembly:?}"))
        .unwrap_or_default();
    let fields = shown.split_once('{').map_or("", |(_, fields)| fields);
    let names = fields.split(',').filter_map(|field| field.split_once(':'));
    names.map(|(name, _)| name.trim().to_string()).collect()
}
