//! The arrays into which a batch is solved: new ones, or those that the caller keeps.

use kin_core::SolveError;
use kin_core::any::{Description, Quantity};
use kin_core::{Dimension, RATES};
use numpy::{BorrowError, Element, PyArrayDyn, PyArrayMethods, PyReadwriteArrayDyn};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

use super::poses::Batch;
use crate::arguments::{Group, groups};
use crate::declared::Declared;
use crate::fault;
use crate::motion::Motion;
use crate::pose::{find, unit};

/// For each group of unknowns and outputs and each order an array of the shape of the batch, with the coordinates of a
/// point as its first axis. NumPy allocates new ones, because it asks for large pages, whose first use takes a tenth of
/// the time.
pub(super) struct Memory<'d, 'py> {
    kinds: [&'d [Quantity<'d>]; 2],
    /// Whether the group is one of outputs.
    pub(super) groups: Vec<(Group<'d>, bool)>,
    pub(super) orders: usize,
    shape: Vec<usize>,
    pub(super) numbers: Vec<Bound<'py, PyArrayDyn<f64>>>,
    pub(super) solved: Bound<'py, PyArrayDyn<bool>>,
    pub(super) singular: Bound<'py, PyArrayDyn<bool>>,
    pub(super) margin: Bound<'py, PyArrayDyn<f64>>,
}

impl<'d, 'py> Memory<'d, 'py> {
    /// Memory for a batch of a shape. What `out` has no arrays for is allocated.
    pub(super) fn new(
        py: Python<'py>,
        description: &'d Description<'d>,
        orders: usize,
        shape: Vec<usize>,
        out: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Self> {
        let kinds = [description.unknowns, description.outputs];
        let of = |kind: usize| groups(kinds[kind]).into_iter().map(move |group| (group, kind == 1));
        let groups: Vec<_> = of(0).chain(of(1)).collect();
        let mut kept = out.map(Kept::of).transpose()?.unwrap_or_default();
        let mut numbers = Vec::with_capacity(groups.len() * orders);
        for (group, _) in &groups {
            let name = group.name;
            let point = group.is_point.then_some(group.coordinates);
            let whole: Vec<usize> = point.into_iter().chain(shape.iter().copied()).collect();
            let Some(arrays) = kept.take(name) else {
                for _ in 0..orders {
                    numbers.push(empty(py, &whole)?);
                }
                continue;
            };
            if arrays.len() != orders {
                let rates = match orders - 1 {
                    0 => String::new(),
                    1 => " and its velocity".to_owned(),
                    rates => format!(" and {rates} derivatives"),
                };
                return Err(PyValueError::new_err(format!(
                    "`out`: the number of arrays of `{name}` is {}, and {orders} are needed: its position{rates}",
                    arrays.len()
                )));
            }
            for (order, array) in arrays.iter().enumerate() {
                let rate = order
                    .checked_sub(1)
                    .map_or("position", |rate| RATES.get(rate).unwrap_or(&"derivative"));
                numbers.push(checked(array, &format!("the {rate} of `{name}`"), &whole)?);
            }
        }
        let solved = kept.flags("solved", py, &shape)?;
        let singular = kept.flags("singular", py, &shape)?;
        let margin = kept.flags("margin", py, &shape)?;
        kept.is_used_up(&groups)?;
        Ok(Self {
            kinds,
            groups,
            orders,
            shape,
            numbers,
            solved,
            singular,
            margin,
        })
    }

    /// The result, whose arrays these are.
    pub(super) fn batch(
        self,
        py: Python<'py>,
        declared: &Declared,
        first_failure: Option<(usize, SolveError)>,
    ) -> PyResult<Batch> {
        let mut motions = Vec::with_capacity(self.groups.len());
        let mut numbers = self.numbers.into_iter();
        for (group, _) in &self.groups {
            let orders = numbers.by_ref().take(self.orders);
            let orders = orders.map(|order| order.into_any().unbind()).collect();
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
            solved: self.solved.into_any().unbind(),
            singular: self.singular.into_any().unbind(),
            margin: self.margin.into_any().unbind(),
            shape: self.shape,
            first_failure,
        })
    }
}

fn empty<'py, T: Element>(py: Python<'py>, shape: &[usize]) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    let empty = py.import("numpy")?.getattr("empty")?;
    let made = empty.call1((PyTuple::new(py, shape)?, T::get_dtype(py)))?;
    Ok(made.cast_into()?)
}

/// The arrays that the caller keeps, by their names, until they are taken.
#[derive(Default)]
struct Kept<'py> {
    arrays: Vec<(String, Vec<Bound<'py, PyAny>>)>,
}

impl<'py> Kept<'py> {
    fn of(out: &Bound<'py, PyAny>) -> PyResult<Self> {
        let py = out.py();
        if let Ok(batch) = out.cast::<Batch>() {
            let batch = batch.get();
            let motions = batch.motions.iter();
            let mut arrays: Vec<_> = motions
                .map(|(name, motion)| (name.clone(), motion.get().derivatives(py)))
                .collect();
            let flags = [
                ("solved", &batch.solved),
                ("singular", &batch.singular),
                ("margin", &batch.margin),
            ];
            arrays.extend(flags.map(|(name, array)| (name.to_owned(), vec![array.bind(py).clone()])));
            return Ok(Self { arrays });
        }
        let named = out.cast::<PyDict>().map_err(|_| {
            PyTypeError::new_err("`out` is a kin.Batch, or a dictionary of arrays by the names of unknowns and outputs")
        })?;
        let arrays = named.iter().map(|(name, value)| {
            let is_sequence = value.is_instance_of::<PyTuple>() || value.is_instance_of::<PyList>();
            let orders = if is_sequence {
                value.try_iter()?.collect::<PyResult<_>>()?
            } else {
                vec![value]
            };
            Ok((name.extract()?, orders))
        });
        Ok(Self {
            arrays: arrays.collect::<PyResult<_>>()?,
        })
    }

    fn take(&mut self, name: &str) -> Option<Vec<Bound<'py, PyAny>>> {
        let index = self.arrays.iter().position(|(own, _)| own == name)?;
        Some(self.arrays.remove(index).1)
    }

    /// An array that tells how the poses end.
    fn flags<T: Element>(
        &mut self,
        name: &str,
        py: Python<'py>,
        shape: &[usize],
    ) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
        match self.take(name).as_deref() {
            None => empty(py, shape),
            Some([array]) => checked(array, &format!("`{name}`"), shape),
            Some(_) => Err(PyTypeError::new_err(format!("`out`: give one array for `{name}`"))),
        }
    }

    /// Refuses names that nothing has.
    fn is_used_up(&self, groups: &[(Group<'_>, bool)]) -> PyResult<()> {
        let Some((name, _)) = self.arrays.first() else {
            return Ok(());
        };
        let names: Vec<&str> = groups.iter().map(|(group, _)| group.name).collect();
        Err(PyValueError::new_err(format!(
            "`out`: no unknown and no output is called `{name}`: there are {}, and solved, singular and margin",
            names.join(", ")
        )))
    }
}

/// An array of the caller, if a batch can be solved into it.
fn checked<'py, T: Element>(
    array: &Bound<'py, PyAny>,
    what: &str,
    shape: &[usize],
) -> PyResult<Bound<'py, PyArrayDyn<T>>> {
    let py = array.py();
    let wanted = T::get_dtype(py);
    let Ok(dtype) = array.getattr("dtype") else {
        let kind = array.get_type().name()?;
        return Err(PyTypeError::new_err(format!(
            "`out`: {what} is of the type {kind}: give an array of NumPy"
        )));
    };
    let found = array.cast::<PyArrayDyn<T>>().map_err(|_| {
        PyTypeError::new_err(format!(
            "`out`: {what} is an array of {dtype}: give one of {wanted}, in the byte order of this machine"
        ))
    })?;
    let own: Vec<usize> = array.getattr("shape")?.extract()?;
    if own != shape {
        return Err(PyValueError::new_err(format!(
            "`out`: {what} has the shape {}, and {} is needed",
            PyTuple::new(py, own)?,
            PyTuple::new(py, shape)?
        )));
    }
    let flags = array.getattr("flags")?;
    let is = |name| flags.getattr(name)?.is_truthy();
    if !is("c_contiguous")? || !is("aligned")? {
        return Err(PyValueError::new_err(format!(
            "`out`: the numbers of {what} do not lie one after the other: give an array as `numpy.empty` makes it"
        )));
    }
    if !is("writeable")? {
        return Err(PyValueError::new_err(format!("`out`: {what} is read-only")));
    }
    Ok(found.clone())
}

/// An array to write to, which nothing else writes to meanwhile.
pub(super) fn own<'py, T: Element>(array: &Bound<'py, PyArrayDyn<T>>) -> PyResult<PyReadwriteArrayDyn<'py, T>> {
    array.try_readwrite().map_err(|error| match error {
        BorrowError::AlreadyBorrowed => {
            PyValueError::new_err("`out`: two arrays share memory, or another batch is being solved into it")
        }
        error => PyValueError::new_err(format!("`out`: {error}")),
    })
}
