//! Many poses at once.

use std::num::NonZero;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};
use std::thread;

use kin_core::any::{AssemblyChoice, Quantity};
use kin_core::batch::{AnyBatch, Column, ColumnChoice, GivenColumns, Outcome, Slot, Vectors, WantedColumns};
use kin_core::{Dimension, Number, SolveError};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn};
use pyo3::exceptions::{PyAttributeError, PyKeyError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyTuple};

use crate::arguments::{self, Group, Wanted, groups};
use crate::choice::choice;
use crate::fault;
use crate::mechanism::Declared;
use crate::motion::Motion;
use crate::pose::{find, unit};

/// The poses that a thread solves in one go: a multiple of all widths of vectors, so that no pose depends on the number
/// of threads.
const PIECE: usize = 8192;

/// The fewest poses of a piece. Fewer than a vector are solved one by one, and rounded differently.
const FEWEST: usize = 512;

/// No sine: an unknown that is no direction leaves it in the column of its sine.
const NO_SINE: f64 = 2.0;

/// What a batch is asked for beside its numbers.
pub(crate) struct Wishes<'a, 'py> {
    pub(crate) assembly: Option<&'a Bound<'py, PyAny>>,
    pub(crate) near: Option<&'a Bound<'py, PyAny>>,
    /// The highest derivative.
    pub(crate) order: Option<usize>,
    pub(crate) threads: Option<usize>,
}

/// Many poses: unknowns and outputs as attributes, each a `kin.Motion` of arrays. `kin.Mechanism.solve_batch` makes it.
#[pyclass(frozen, module = "kin")]
pub(crate) struct Batch {
    motions: Vec<(String, Py<Motion>)>,
    shape: Vec<usize>,
    solved: Py<PyAny>,
    margin: Py<PyAny>,
    singular: Py<PyAny>,
    count: usize,
    first_failure: Option<(usize, Py<PyAny>)>,
}

/// One number for all poses, or an array with one for each that nobody else has.
enum Values<'py> {
    Same(f64),
    Each(PyReadonlyArrayDyn<'py, f64>),
}

impl Values<'_> {
    fn column(&self) -> PyResult<Column<'_>> {
        Ok(match self {
            Self::Same(value) => Column::Same(*value),
            Self::Each(values) => Column::Each(values.as_slice()?),
        })
    }
}

/// Numbers of Python as an array of NumPy, of any shape.
fn as_array<'py>(numpy: &Bound<'py, PyAny>, value: &Bound<'py, PyAny>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    let array = numpy.call_method1("asarray", (value,)).map_err(|error| {
        let py = value.py();
        PyValueError::new_err(format!("`{name}`: {}", error.value(py)))
    })?;
    let dtype = array.getattr("dtype")?;
    let kind: String = dtype.getattr("kind")?.extract()?;
    if !["f", "i", "u"].contains(&kind.as_str()) {
        return Err(PyTypeError::new_err(format!(
            "`{name}` is an array of {dtype}: give real numbers"
        )));
    }
    Ok(array)
}

/// The values of all arguments, broadcast against each other, and their shape.
fn broadcast<'py>(py: Python<'py>, given: &[(Bound<'py, PyAny>, String)]) -> PyResult<(Vec<Values<'py>>, Vec<usize>)> {
    let numpy = py.import("numpy")?.into_any();
    let arrays = given.iter().map(|(value, name)| as_array(&numpy, value, name));
    let arrays = arrays.collect::<PyResult<Vec<_>>>()?;
    let shapes = arrays
        .iter()
        .map(|array| array.getattr("shape"))
        .collect::<PyResult<Vec<_>>>()?;
    let shape = numpy
        .call_method1("broadcast_shapes", PyTuple::new(py, &shapes)?)
        .map_err(|_| {
            let shapes = given
                .iter()
                .zip(&shapes)
                .filter(|(_, shape)| shape.len().unwrap_or(0) > 0);
            let shapes: Vec<String> = shapes.map(|((_, name), shape)| format!("{name} {shape}")).collect();
            PyValueError::new_err(format!(
                "these shapes do not broadcast against each other: {}",
                shapes.join(", ")
            ))
        })?;
    let float = numpy.getattr("float64")?;
    let mut values = Vec::with_capacity(arrays.len());
    for array in &arrays {
        if array.getattr("ndim")?.extract::<usize>()? == 0 {
            values.push(Values::Same(array.call_method0("item")?.extract()?));
            continue;
        }
        let whole = numpy.call_method1("broadcast_to", (array, &shape))?;
        let keywords = PyDict::new(py);
        keywords.set_item("dtype", &float)?;
        keywords.set_item("order", "C")?;
        // a copy, because other threads of Python may write to the array while this one solves
        let own = numpy.call_method("array", (whole,), Some(&keywords))?;
        let own = own.cast_into::<PyArrayDyn<f64>>().map_err(PyErr::from)?;
        values.push(Values::Each(own.readonly()));
    }
    Ok((values, shape.extract()?))
}

/// The part of a batch that one thread solves.
struct Piece<'w> {
    from: usize,
    wanted: Vec<(Slot, &'w mut [f64])>,
    outcomes: OutcomeColumns<'w>,
}

/// The memory of how poses end.
struct OutcomeColumns<'w> {
    solved: &'w mut [bool],
    singular: &'w mut [bool],
    margin: &'w mut [f64],
}

impl OutcomeColumns<'_> {
    fn split_at(self, length: usize) -> [Self; 2] {
        let (solved, other_solved) = self.solved.split_at_mut(length);
        let (singular, other_singular) = self.singular.split_at_mut(length);
        let (margin, other_margin) = self.margin.split_at_mut(length);
        let rest = Self {
            solved: other_solved,
            singular: other_singular,
            margin: other_margin,
        };
        [
            Self {
                solved,
                singular,
                margin,
            },
            rest,
        ]
    }

    fn write(self, outcomes: &[Outcome]) {
        for (index, outcome) in outcomes.iter().enumerate() {
            self.solved[index] = outcome.is_solved();
            self.singular[index] = matches!(outcome, Outcome::Singular);
            self.margin[index] = outcome.margin().unwrap_or(f64::NAN);
        }
    }
}

/// Solves a batch. Dimensions are these numbers, or stand among the given arguments.
pub(crate) fn solve<'py>(
    py: Python<'py>,
    declared: &Declared,
    dimensions: Option<&[f64]>,
    given: Option<&Bound<'py, PyDict>>,
    wishes: &Wishes<'_, 'py>,
) -> PyResult<Batch> {
    let description = declared.description();
    let wanted = [
        Wanted {
            kind: "dimension",
            quantities: description.parameters,
        },
        Wanted {
            kind: "input",
            quantities: description.inputs,
        },
    ];
    let wanted = &wanted[usize::from(dimensions.is_some())..];
    let mut values = arguments::values(given, wanted)?;
    let inputs = values.pop().unwrap_or_default();
    let parameters = match dimensions {
        Some(numbers) => numbers
            .iter()
            .map(|number| PyFloat::new(py, *number).into_any())
            .collect(),
        None => values.pop().unwrap_or_default(),
    };
    let choice = choice(declared, wishes.assembly, wishes.near)?;
    let orders = match wishes.order {
        Some(order) if order > description.order => {
            return Err(PyValueError::new_err(format!(
                "{} has derivatives up to order {}",
                description.name, description.order
            )));
        }
        order => order.unwrap_or(description.order) + 1,
    };
    let mut given: Vec<(Bound<'py, PyAny>, String)> = Vec::new();
    for (value, quantity) in parameters.into_iter().zip(description.parameters) {
        let value = arguments::without_unit(&value, quantity, 0)?;
        given.push((value, quantity.name.to_owned()));
    }
    let mut counts = Vec::with_capacity(inputs.len());
    for (value, quantity) in inputs.into_iter().zip(description.inputs) {
        let motion = motion(&value, quantity, declared.orders())?;
        counts.push(motion.len());
        given.extend(motion.into_iter().map(|value| (value, quantity.name.to_owned())));
    }
    let (values, shape) = broadcast(py, &given)?;
    let count: usize = shape.iter().product();
    let columns = values.iter().map(Values::column).collect::<PyResult<Vec<_>>>()?;
    let (parameters, motions) = columns.split_at(description.parameters.len());

    let kinds = [description.unknowns, description.outputs];
    let arrays = Arrays::new(py, kinds, orders, count)?;
    let mut guards: Vec<_> = arrays.numbers.iter().map(PyArrayMethods::readwrite).collect();
    let numbers = guards.iter_mut().map(|guard| guard.as_slice_mut());
    let mut found = Columns::new(&arrays, numbers.collect::<Result<_, _>>()?);
    let mut ends = (
        arrays.solved.readwrite(),
        arrays.singular.readwrite(),
        arrays.margin.readwrite(),
    );
    let outcomes = OutcomeColumns {
        solved: ends.0.as_slice_mut()?,
        singular: ends.1.as_slice_mut()?,
        margin: ends.2.as_slice_mut()?,
    };
    let threads = threads(wishes.threads);
    let unknowns = description.unknowns.iter().enumerate();
    let angles = unknowns.filter(|(_, quantity)| quantity.dimension == Dimension::Angle);
    let angles: Vec<usize> = angles.map(|(index, _)| index).collect();
    let first_failure = py.detach(|| {
        let pieces = found.pieces(outcomes);
        let solve = |piece: Piece<'_>| {
            let length = piece.outcomes.solved.len();
            let range = piece.from..piece.from + length;
            let parameters = parts(parameters, &range);
            let motions = parts(motions, &range);
            let mut outcomes = vec![Outcome::Unsolved; length];
            let mut rest = motions.as_slice();
            let inputs = counts.iter().map(|count| {
                let (motion, others) = rest.split_at(*count);
                rest = others;
                motion
            });
            let inputs: Vec<&[Column<'_>]> = inputs.collect();
            let near: Vec<Column<'_>> = match &choice {
                AssemblyChoice::Near(near) => near.iter().copied().map(Column::Same).collect(),
                AssemblyChoice::Index(_) => Vec::new(),
            };
            let given = GivenColumns {
                parameters: &parameters,
                inputs: &inputs,
                choice: match choice {
                    AssemblyChoice::Index(index) => ColumnChoice::Assembly(index),
                    AssemblyChoice::Near(_) => ColumnChoice::Near(&near),
                },
            };
            let mut sines = vec![NO_SINE; angles.len() * length];
            let mut wanted = piece.wanted;
            let columns = wanted.iter_mut().map(|(slot, numbers)| (*slot, &mut **numbers));
            let of_sines = angles.iter().zip(sines.chunks_exact_mut(length));
            let of_sines = of_sines.map(|(unknown, sines)| (Slot::Sine(*unknown), sines));
            let all = &mut WantedColumns::new(columns.chain(of_sines).collect());
            let solved = declared
                .mechanism
                .solve_batch(given, all, &mut outcomes, Vectors::widest());
            piece.outcomes.write(&outcomes);
            for (unknown, sines) in angles.iter().zip(sines.chunks_exact(length)) {
                turn(&mut wanted, *unknown, sines);
            }
            let summary = solved.unwrap_or_else(|_| unreachable!("all columns have the length of the piece"));
            summary.first_failure.map(|(index, error)| (piece.from + index, error))
        };
        on_threads(pieces, threads, solve)
    });
    drop(found);
    drop((guards, ends));
    arrays.batch(py, declared, shape, first_failure)
}

/// The parts of columns for a range of poses.
fn parts<'a>(columns: &[Column<'a>], range: &Range<usize>) -> Vec<Column<'a>> {
    columns.iter().map(|column| column.part(range.clone())).collect()
}

fn threads(wished: Option<usize>) -> usize {
    let all = || thread::available_parallelism().map_or(1, NonZero::get);
    wished.filter(|threads| *threads > 0).unwrap_or_else(all)
}

/// Solves all pieces, and returns the failure with the lowest index.
fn on_threads(
    pieces: Vec<Piece<'_>>,
    threads: usize,
    solve: impl Fn(Piece<'_>) -> Option<(usize, SolveError)> + Sync,
) -> Option<(usize, SolveError)> {
    let threads = threads.min(pieces.len());
    let failures: Vec<(usize, SolveError)> = if threads <= 1 {
        pieces.into_iter().filter_map(solve).collect()
    } else {
        // Threads of this call only: a process that is forked later has no thread that waits for work.
        let pieces = Mutex::new(pieces.into_iter());
        let next = || pieces.lock().unwrap_or_else(PoisonError::into_inner).next();
        thread::scope(|scope| {
            let work = || std::iter::from_fn(next).filter_map(&solve).collect::<Vec<_>>();
            let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
            let found = workers.into_iter().flat_map(|worker| match worker.join() {
                Ok(found) => found,
                Err(panic) => std::panic::resume_unwind(panic),
            });
            found.collect()
        })
    };
    failures.into_iter().min_by_key(|(index, _)| *index)
}

/// The numbers of an input: one for each order, each of which may be an array.
fn motion<'py>(value: &Bound<'py, PyAny>, quantity: &Quantity<'_>, orders: usize) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let name = quantity.name;
    let Ok(tuple) = value.cast::<PyTuple>() else {
        if value.is_instance_of::<pyo3::types::PyList>() {
            return Err(PyTypeError::new_err(format!(
                "`{name}` is a list, which could mean two things: write a tuple for position and derivatives, as in \
                 `{name}=(angles, 10.0)`, and `numpy.array([…])` for many positions"
            )));
        }
        return Ok(vec![arguments::without_unit(value, quantity, 0)?]);
    };
    let count = tuple.len();
    if count == 0 || count > orders {
        return Err(PyValueError::new_err(format!(
            "`{name}` has {count} entries: give its position, and behind it up to {} derivatives with respect to time",
            orders - 1
        )));
    }
    let rates = tuple.iter().enumerate();
    rates
        .map(|(order, value)| arguments::without_unit(&value, quantity, order))
        .collect()
}

/// The arrays of unknowns and outputs, for each group and order one, with the coordinates of a point one after the
/// other. NumPy allocates them, because it asks for large pages, whose first use takes a tenth of the time.
struct Arrays<'d, 'py> {
    kinds: [&'d [Quantity<'d>]; 2],
    groups: Vec<(Group<'d>, bool)>,
    orders: usize,
    count: usize,
    numbers: Vec<Bound<'py, PyArray1<f64>>>,
    solved: Bound<'py, PyArray1<bool>>,
    singular: Bound<'py, PyArray1<bool>>,
    margin: Bound<'py, PyArray1<f64>>,
}

impl<'d, 'py> Arrays<'d, 'py> {
    fn new(py: Python<'py>, kinds: [&'d [Quantity<'d>]; 2], orders: usize, count: usize) -> PyResult<Self> {
        let of = |kind: usize| groups(kinds[kind]).into_iter().map(move |group| (group, kind == 1));
        let groups: Vec<_> = of(0).chain(of(1)).collect();
        let empty = py.import("numpy")?.getattr("empty")?;
        let numbers = groups
            .iter()
            .flat_map(|(group, _)| (0..orders).map(|_| group.coordinates * count))
            .map(|length| Ok(empty.call1((length,))?.cast_into::<PyArray1<f64>>()?));
        let flags = || empty.call1((count, "?"));
        Ok(Self {
            solved: flags()?.cast_into()?,
            singular: flags()?.cast_into()?,
            margin: empty.call1((count,))?.cast_into()?,
            kinds,
            orders,
            count,
            numbers: numbers.collect::<PyResult<_>>()?,
            groups,
        })
    }
}

/// The memory of the arrays.
struct Columns<'d, 'a> {
    groups: &'a [(Group<'d>, bool)],
    orders: usize,
    count: usize,
    numbers: Vec<&'a mut [f64]>,
}

impl<'d, 'a> Columns<'d, 'a> {
    fn new(arrays: &'a Arrays<'d, '_>, numbers: Vec<&'a mut [f64]>) -> Self {
        Self {
            groups: &arrays.groups,
            orders: arrays.orders,
            count: arrays.count,
            numbers,
        }
    }

    /// The pieces that threads solve.
    fn pieces<'w>(&'w mut self, outcomes: OutcomeColumns<'w>) -> Vec<Piece<'w>> {
        let mut rest: Vec<(Slot, &'w mut [f64])> = Vec::new();
        for (index, numbers) in self.numbers.iter_mut().enumerate() {
            let (group, is_output) = &self.groups[index / self.orders];
            let order = index % self.orders;
            let coordinates = numbers.chunks_exact_mut(self.count.max(1)).take(group.coordinates);
            for (coordinate, numbers) in coordinates.enumerate() {
                let scalar = group.first + coordinate;
                let slot = if *is_output {
                    Slot::Output(scalar, order)
                } else {
                    Slot::Unknown(scalar, order)
                };
                rest.push((slot, numbers));
            }
        }

        let (mut outcomes, mut from, mut pieces) = (outcomes, 0, Vec::new());
        while from < self.count {
            let left = self.count - from;
            let length = if left < PIECE + FEWEST { left } else { PIECE };
            let [part, others] = outcomes.split_at(length);
            let split = |(slot, numbers): &mut (Slot, &'w mut [f64])| {
                let (part, others) = std::mem::take(numbers).split_at_mut(length);
                *numbers = others;
                (*slot, part)
            };
            pieces.push(Piece {
                from,
                wanted: rest.iter_mut().map(split).collect(),
                outcomes: part,
            });
            (outcomes, from) = (others, from + length);
        }
        pieces
    }
}

/// Makes angles of an unknown that is a direction, of which a batch stores the cosines and sines.
fn turn(columns: &mut [(Slot, &mut [f64])], unknown: usize, sines: &[f64]) {
    if sines.first().is_none_or(|sine| *sine == NO_SINE) {
        return;
    }
    let is_meant = |slot: &Slot| matches!(slot, Slot::Unknown(index, 0) if *index == unknown);
    for (_, cosines) in columns.iter_mut().filter(|(slot, _)| is_meant(slot)) {
        for (angle, sine) in cosines.iter_mut().zip(sines) {
            *angle = Number::atan2(*sine, *angle);
        }
    }
}

impl<'py> Arrays<'_, 'py> {
    fn batch(
        self,
        py: Python<'py>,
        declared: &Declared,
        shape: Vec<usize>,
        first_failure: Option<(usize, SolveError)>,
    ) -> PyResult<Batch> {
        let mut motions = Vec::with_capacity(self.groups.len());
        let mut numbers = self.numbers.into_iter();
        for (group, _) in &self.groups {
            let mut whole = Vec::new();
            if group.is_point {
                whole.push(group.coordinates);
            }
            whole.extend(&shape);
            let orders = numbers
                .by_ref()
                .take(self.orders)
                .map(|order| Ok(order.reshape(whole.clone())?.into_any().unbind()));
            let orders = orders.collect::<PyResult<Vec<_>>>()?;
            let dimension = find(&self.kinds, group.name).map_or(Dimension::Scalar, |(_, _, dimension)| dimension);
            let motion = Motion::new(group, unit(dimension), orders);
            motions.push((group.name.to_owned(), Py::new(py, motion)?));
        }
        let first_failure = first_failure.map(|(index, error)| {
            let error = fault::of_solver(py, &declared.mechanism, &error);
            (index, error.into_value(py).into_any())
        });
        Ok(Batch {
            motions,
            solved: self.solved.reshape(shape.clone())?.into_any().unbind(),
            singular: self.singular.reshape(shape.clone())?.into_any().unbind(),
            margin: self.margin.reshape(shape.clone())?.into_any().unbind(),
            count: self.count,
            shape,
            first_failure,
        })
    }
}

impl Batch {
    fn find(&self, py: Python<'_>, name: &str) -> PyResult<Option<Py<PyAny>>> {
        for (motion, value) in &self.motions {
            if motion == name {
                return Ok(Some(value.clone_ref(py).into_any()));
            }
        }
        let Some((point, coordinate)) = name.rsplit_once('.') else {
            return Ok(None);
        };
        match self.motions.iter().find(|(motion, _)| motion == point) {
            Some((_, value)) => Ok(Some(value.bind(py).getattr(coordinate)?.unbind())),
            None => Ok(None),
        }
    }

    fn none_called(&self, name: &str) -> String {
        let all: Vec<&str> = self.motions.iter().map(|(name, _)| name.as_str()).collect();
        format!(
            "no unknown and no output is called `{name}`: there are {}",
            all.join(", ")
        )
    }
}

#[pymethods]
impl Batch {
    /// The shape to which dimensions and inputs were broadcast.
    #[getter]
    fn shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.shape)
    }

    /// Where the mechanism closes: an array of bools. Elsewhere all numbers are NaN.
    #[getter]
    fn solved(&self, py: Python<'_>) -> Py<PyAny> {
        self.solved.clone_ref(py)
    }

    /// Where the position is singular, for example a limit position: an array of bools.
    #[getter]
    fn singular(&self, py: Python<'_>) -> Py<PyAny> {
        self.singular.clone_ref(py)
    }

    /// The missing length where the mechanism is out of reach, as a negative number; NaN elsewhere.
    #[getter]
    fn margin(&self, py: Python<'_>) -> Py<PyAny> {
        self.margin.clone_ref(py)
    }

    /// The flat index of the first pose that was not found, with its `kin.SolveError`, or `None`.
    #[getter]
    fn first_failure(&self, py: Python<'_>) -> Option<(usize, Py<PyAny>)> {
        let (index, error) = self.first_failure.as_ref()?;
        Some((*index, error.clone_ref(py)))
    }

    fn __len__(&self) -> usize {
        self.shape.first().copied().unwrap_or(self.count)
    }

    fn __getattr__(&self, py: Python<'_>, name: &str) -> PyResult<Py<PyAny>> {
        self.find(py, name)?
            .ok_or_else(|| PyAttributeError::new_err(self.none_called(name)))
    }

    fn __getitem__(&self, py: Python<'_>, name: &str) -> PyResult<Py<PyAny>> {
        self.find(py, name)?
            .ok_or_else(|| PyKeyError::new_err(self.none_called(name)))
    }

    fn __dir__<'py>(slf: &Bound<'py, Self>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let mut names: Vec<Bound<'py, PyAny>> = slf.get_type().dir()?.iter().collect();
        for (name, _) in &slf.get().motions {
            names.push(name.into_pyobject(slf.py())?.into_any());
        }
        Ok(names)
    }

    fn __repr__(&self) -> String {
        let names: Vec<&str> = self.motions.iter().map(|(name, _)| name.as_str()).collect();
        format!("<kin.Batch of {} poses: {}>", self.count, names.join(", "))
    }
}
