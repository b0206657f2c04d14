//! A number that notes what is done with it.
//!
//! Its operations are calls: where they are used, they would take several times as much code as all solvers.

use core::cell::RefCell;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::pose_number::PoseNumber;
use super::steps::{Call, CallOfTwo, Step, Trace};
use crate::number::Number;

std::thread_local! {
    static TRACE: RefCell<Trace> = const { RefCell::new(Trace::EMPTY) };
}

/// A number of a pose that stands for others, with the step that found it; none for a constant.
#[derive(Clone, Copy, Debug)]
pub(super) struct Traced {
    value: f64,
    node: Option<u32>,
}

/// What a function returns, and the steps that it takes with such numbers.
pub(super) fn trace_of<R>(function: impl FnOnce() -> R) -> (R, Trace) {
    // what a trace before has left if it panicked
    drop(TRACE.take());
    let result = function();
    (result, TRACE.take())
}

impl Traced {
    /// The step that found it; none for a constant.
    pub(super) fn node(self) -> Option<u32> {
        self.node
    }

    /// Its step. A constant has one where it is needed.
    fn node_in(self, trace: &mut Trace) -> u32 {
        self.node.unwrap_or_else(|| trace.add(Step::Constant(self.value)))
    }

    /// The number of a column, with its value in the pose that stands for the others.
    pub(super) fn given(column: usize, value: f64) -> Self {
        let column = u32::try_from(column).unwrap_or(u32::MAX);
        Self::noted(value, Step::Given(column))
    }

    #[inline(never)]
    fn noted(value: f64, step: Step) -> Self {
        let node = TRACE.with_borrow_mut(|trace| Some(trace.add(step)));
        Self { value, node }
    }

    fn known(self) -> Option<f64> {
        self.node.is_none().then_some(self.value)
    }

    /// The result of an operation, which is a constant if its operands are.
    #[inline(never)]
    fn of_two(self, other: Self, value: f64, step: impl FnOnce([u32; 2]) -> Step) -> Self {
        if self.node.is_none() && other.node.is_none() {
            return Self::constant(value);
        }
        let node = TRACE.with_borrow_mut(|trace| {
            let operands = [self.node_in(trace), other.node_in(trace)];
            Some(trace.add(step(operands)))
        });
        Self { value, node }
    }

    fn of_one(self, value: f64, step: impl FnOnce(u32) -> Step) -> Self {
        match self.node {
            Some(node) => Self::noted(value, step(node)),
            None => Self::constant(value),
        }
    }

    fn called(self, call: Call) -> Self {
        self.of_one(call(self.value), |one| Step::Call(call, one))
    }
}

impl Add for Traced {
    type Output = Self;

    #[inline(never)]
    fn add(self, other: Self) -> Self {
        if other.known() == Some(0.0) {
            return self;
        }
        if self.known() == Some(0.0) {
            return other;
        }
        self.of_two(other, self.value + other.value, Step::Sum)
    }
}

impl Sub for Traced {
    type Output = Self;

    #[inline(never)]
    fn sub(self, other: Self) -> Self {
        if other.known() == Some(0.0) {
            return self;
        }
        if self.known() == Some(0.0) {
            return -other;
        }
        self.of_two(other, self.value - other.value, Step::Difference)
    }
}

impl Mul for Traced {
    type Output = Self;

    #[inline(never)]
    fn mul(self, other: Self) -> Self {
        let knowns = [self.known(), other.known()];
        if knowns.contains(&Some(0.0)) {
            return Self::constant(0.0);
        }
        match knowns {
            [Some(1.0), _] => other,
            [_, Some(1.0)] => self,
            [Some(-1.0), _] => -other,
            [_, Some(-1.0)] => -self,
            _ => self.of_two(other, self.value * other.value, Step::Product),
        }
    }
}

impl Div for Traced {
    type Output = Self;

    #[inline(never)]
    fn div(self, other: Self) -> Self {
        if self.known() == Some(0.0) && other.known() != Some(0.0) {
            return self;
        }
        match other.known() {
            Some(1.0) => self,
            Some(-1.0) => -self,
            _ => self.of_two(other, self.value / other.value, Step::Quotient),
        }
    }
}

impl Neg for Traced {
    type Output = Self;

    #[inline(never)]
    fn neg(self) -> Self {
        let value = -self.value;
        let step = self
            .node
            .map(|node| TRACE.with_borrow(|trace| trace.steps[node as usize]));
        match step {
            Some(Step::Opposite(node)) => Self {
                value,
                node: Some(node),
            },
            _ => self.of_one(value, Step::Opposite),
        }
    }
}

macro_rules! called {
    ($($function:ident)+) => {
        $(
            fn $function(self) -> Self {
                self.called(<f64 as Number>::$function)
            }
        )+
    };
}

impl Number for Traced {
    const EPSILON: f64 = f64::EPSILON;

    fn constant(value: f64) -> Self {
        Self { value, node: None }
    }

    fn real(self) -> f64 {
        self.value
    }

    /// Whether it is so in the pose that stands for the others. The results of these are looked at themselves.
    fn is_finite(self) -> bool {
        self.value.is_finite()
    }

    fn sqrt(self) -> Self {
        self.of_one(Number::sqrt(self.value), Step::SquareRoot)
    }

    fn sin_cos(self) -> (Self, Self) {
        (self.called(<f64 as Number>::sin), self.called(<f64 as Number>::cos))
    }

    fn atan2(self, x: Self) -> Self {
        let call: CallOfTwo = <f64 as Number>::atan2;
        self.of_two(x, call(self.value, x.value), |both| Step::CallOfTwo(call, both))
    }

    called! { asin acos atan sinh cosh tanh asinh acosh atanh exp ln }
}

impl PoseNumber for Traced {
    #[inline(never)]
    fn exceeds(self, part: f64, other: Self) -> bool {
        let exceeds = self.value.exceeds(part, other.value);
        if self.node.is_some() || other.node.is_some() {
            TRACE.with_borrow_mut(|trace| {
                let operands = [self.node_in(trace), other.node_in(trace)];
                trace.add(Step::Exceeds(operands, part, exceeds))
            });
        }
        exceeds
    }

    fn is_negative(self) -> bool {
        let is_negative = self.value < 0.0;
        if let Some(node) = self.node {
            TRACE.with_borrow_mut(|trace| trace.add(Step::Sign(node, is_negative)));
        }
        is_negative
    }

    fn size(self) -> Self {
        self.of_one(self.value.abs(), Step::Size)
    }

    fn or_larger(self, other: Self) -> Self {
        self.of_two(other, self.value.max(other.value), Step::Larger)
    }
}
