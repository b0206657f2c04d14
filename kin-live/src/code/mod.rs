//! Flat code over registers.
//!
//! A number stands in a register. An [`Operation`] takes one step of arithmetic; a [`Call`] is a step with a decision
//! in it, as a function of `kin_core::solve` takes it.

mod assembler;
mod call;
mod labels;

pub(crate) use assembler::{Assembler, TooLarge};
pub(crate) use call::{Argument, Call, ClosedForm, Range};
pub(crate) use labels::Labels;

use crate::elementary::Elementary;
use crate::memory::Lengths;

/// The index of a register.
pub(crate) type Register = u16;

/// A step of arithmetic, or the index of a call.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Operation {
    /// A constant, by its index.
    Constant {
        to: Register,
        value: u16,
    },
    Copy {
        to: Register,
        a: Register,
    },
    Add {
        to: Register,
        a: Register,
        b: Register,
    },
    Subtract {
        to: Register,
        a: Register,
        b: Register,
    },
    Multiply {
        to: Register,
        a: Register,
        b: Register,
    },
    Divide {
        to: Register,
        a: Register,
        b: Register,
    },
    Negate {
        to: Register,
        a: Register,
    },
    PlusProduct {
        to: Register,
        rest: Register,
        a: Register,
        b: Register,
    },
    MinusProduct {
        to: Register,
        rest: Register,
        a: Register,
        b: Register,
    },
    /// a b + c d: two operations at once, between which the number need not be written and read.
    SumOfProducts {
        to: Register,
        a: Register,
        b: Register,
        c: Register,
        d: Register,
    },
    /// a b - c d.
    DifferenceOfProducts {
        to: Register,
        a: Register,
        b: Register,
        c: Register,
        d: Register,
    },
    /// rest + a b + c d.
    PlusProducts {
        to: Register,
        rest: Register,
        a: Register,
        b: Register,
        c: Register,
        d: Register,
    },
    /// rest + a b - c d.
    PlusMinusProducts {
        to: Register,
        rest: Register,
        a: Register,
        b: Register,
        c: Register,
        d: Register,
    },
    /// rest - a b - c d.
    MinusProducts {
        to: Register,
        rest: Register,
        a: Register,
        b: Register,
        c: Register,
        d: Register,
    },
    SineCosine {
        sine: Register,
        cosine: Register,
        angle: Register,
    },
    Function {
        function: Elementary,
        to: Register,
        a: Register,
    },
    ArcTangent {
        to: Register,
        y: Register,
        x: Register,
    },
    /// Skips the next operations, which find the terms of a decisive number, for numbers that always decide.
    Doubt {
        skip: u16,
    },
    Call(u16),
}

/// Operations, one after the other.
pub(crate) type Operations = Box<[Operation]>;

/// The code of some routines that share their registers.
#[derive(Debug)]
pub(crate) struct Code {
    /// The operations of each routine.
    pub(crate) routines: Vec<Operations>,
    pub(crate) calls: Vec<Call>,
    pub(crate) constants: Vec<f64>,
    pub(crate) factors: Vec<KeptFactors>,
    /// The memory that a run takes.
    pub(crate) lengths: Lengths,
}

/// The memory of the factors of a matrix.
#[derive(Clone, Copy, Debug)]
pub(crate) struct KeptFactors {
    /// The first entry.
    pub(crate) first_entry: usize,
    /// The first row.
    pub(crate) first_row: usize,
}
