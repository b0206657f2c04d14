//! The number that records.

use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Sub};
use std::vec::Vec;

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::number::Number;
use crate::solve::{Check, Choose, Elimination, Equations, FactorRow, Measure, NewtonMemory, Real, RowMeasure, Scalar};
use crate::tape::recorder::Sought;
use crate::tape::recording::{self, node};
use crate::tape::{Comparison, Function, Operator, TapeNode, Value};

/// A number that writes down what is done with it, for a tape in the number type `F`.
///
/// It stands for a node and has no value. It is used inside of [`tape::record`](crate::tape::record()) only.
#[derive(Debug)]
pub struct Recorded<F> {
    value: Value,
    number: PhantomData<F>,
}

impl<F> Clone for Recorded<F> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<F> Copy for Recorded<F> {}

impl<F> Recorded<F> {
    pub(super) const fn at(value: Value) -> Self {
        Self {
            value,
            number: PhantomData,
        }
    }

    pub(super) const fn value(self) -> Value {
        self.value
    }

    fn call(self, function: Function) -> Self {
        Self::at(recording::call(function, self.value))
    }

    fn with(self, operator: Operator, other: Self) -> Self {
        Self::at(recording::binary(operator, self.value, other.value))
    }
}

fn put<F>(node: TapeNode) -> Recorded<F> {
    Recorded::at(recording::node(node))
}

macro_rules! operators {
    ($($trait:ident $method:ident $operator:ident,)+) => {
        $(
            impl<F> $trait for Recorded<F> {
                type Output = Self;

                fn $method(self, other: Self) -> Self {
                    self.with(Operator::$operator, other)
                }
            }
        )+
    };
}

operators! { Add add Add, Sub sub Subtract, Mul mul Multiply, Div div Divide, }

impl<F> Neg for Recorded<F> {
    type Output = Self;

    fn neg(self) -> Self {
        self.call(Function::Negate)
    }
}

macro_rules! functions {
    ($($method:ident $function:ident,)+) => {
        $(
            fn $method(self) -> Self {
                self.call(Function::$function)
            }
        )+
    };
}

impl<F: Number> Number for Recorded<F> {
    const EPSILON: f64 = F::EPSILON;
    const SMALLEST_DIVISOR: f64 = F::SMALLEST_DIVISOR;

    fn constant(value: f64) -> Self {
        Self::at(recording::constant(value))
    }

    fn real(self) -> f64 {
        recording::read(self.value)
    }

    fn is_finite(self) -> bool {
        Self::are_finite(&[self])
    }

    fn are_finite(numbers: &[Self]) -> bool {
        recording::are_finite(&values(numbers))
    }

    functions! {
        sqrt SquareRoot, asin ArcSine, acos ArcCosine, atan ArcTangent, sinh HyperbolicSine, cosh HyperbolicCosine,
        tanh HyperbolicTangent, asinh AreaHyperbolicSine, acosh AreaHyperbolicCosine, atanh AreaHyperbolicTangent,
        exp Exponential, ln Logarithm,
    }

    fn sin_cos(self) -> (Self, Self) {
        (self.call(Function::Sine), self.call(Function::Cosine))
    }

    fn atan2(self, x: Self) -> Self {
        self.with(Operator::ArcTangent, x)
    }

    fn plus_product(self, a: Self, b: Self) -> Self {
        put(TapeNode::PlusProduct(self.value, a.value, b.value))
    }

    fn minus_product(self, a: Self, b: Self) -> Self {
        put(TapeNode::MinusProduct(self.value, a.value, b.value))
    }
}

impl<F: Number> Real for Recorded<F> {
    type Truth = Value;

    fn of(value: f64) -> Self {
        Self::constant(value)
    }

    fn magnitude(self) -> Self {
        self.call(Function::Magnitude)
    }

    fn rounded(self) -> Self {
        self.call(Function::Round)
    }

    fn raised(self) -> Self {
        self.call(Function::Raise)
    }

    fn is_at_least(self, other: Self) -> Value {
        node(TapeNode::Compare(Comparison::AtLeast, self.value, other.value))
    }

    fn exceeds(self, other: Self) -> Value {
        node(TapeNode::Compare(Comparison::Exceeds, self.value, other.value))
    }

    fn equals(self, other: Self) -> Value {
        node(TapeNode::Compare(Comparison::Equals, self.value, other.value))
    }

    fn is_finite(self) -> Value {
        node(TapeNode::IsFinite(self.value))
    }

    fn certainly(answer: bool) -> Value {
        node(TapeNode::Certain(answer))
    }

    fn both(one: Value, other: impl FnOnce() -> Value) -> Value {
        let other = other();
        node(TapeNode::Both(one, other))
    }

    fn either(one: Value, other: impl FnOnce() -> Value) -> Value {
        let other = other();
        node(TapeNode::Either(one, other))
    }

    fn not(truth: Value) -> Value {
        node(TapeNode::Not(truth))
    }

    fn choose(truth: Value, one: impl FnOnce() -> Self, other: impl FnOnce() -> Self) -> Self {
        let (one, other) = (one(), other());
        put(TapeNode::Select(truth, one.value, other.value))
    }
}

/// The node of all conditions together.
fn all<const K: usize>(conditions: [Value; K]) -> Value {
    conditions
        .into_iter()
        .reduce(|one, other| node(TapeNode::Both(one, other)))
        .unwrap_or_else(|| node(TapeNode::Certain(true)))
}

impl<F: Number> Scalar for Recorded<F> {
    fn provided<const N: usize, const K: usize>(self, check: impl Check<Self, N, K>) -> Option<Self> {
        let condition = all(check.holds(check.operands()));
        let before = recording::count();
        let margin = check.margin();
        recording::holds(check.name(), condition, margin.value, before).then_some(self)
    }

    fn either<const N: usize>(
        check: impl Check<Self, N, 1>,
        one: impl FnOnce() -> Self,
        other: impl FnOnce() -> Self,
    ) -> Self {
        let [holds] = check.holds(check.operands());
        Self::choose(holds, one, other)
    }

    fn assembled(assembly: Assembly, open: impl FnOnce() -> Self, crossed: impl FnOnce() -> Self) -> Self {
        match recording::is_open(assembly) {
            Ok((truth, is_mirrored)) => {
                let (open, crossed) = (open(), crossed());
                let [one, other] = if is_mirrored { [crossed, open] } else { [open, crossed] };
                put(TapeNode::Select(truth, one.value, other.value))
            }
            Err(known) => {
                let (open, crossed) = (open(), crossed());
                match known {
                    Assembly::Open => open,
                    Assembly::Crossed => crossed,
                }
            }
        }
    }

    fn all_assembled<const N: usize>(assembly: Assembly, open: [Self; N], crossed: [Self; N]) -> [Self; N] {
        core::array::from_fn(|index| Self::assembled(assembly, || open[index], || crossed[index]))
    }

    fn side(self) -> Assembly {
        let is_open = self.is_at_least(Self::constant(0.0));
        recording::side(is_open)
    }

    fn agree(_: &mut [Self], _: &[Self]) {}

    fn measured<const N: usize>(measure: impl Measure<Self, N>) -> Self {
        measure.measure(measure.operands())
    }

    fn measured_over<M: RowMeasure>(_: M, count: usize, operand: impl Fn(usize) -> Self) -> Self {
        M::end((0..count).fold(M::start(), |constant, index| M::with(constant, operand(index))))
    }

    fn chosen<const N: usize>(choice: impl Choose<Self, N>) -> Result<Assembly, Failure> {
        Self::first_chosen(&[choice])
    }

    fn first_chosen<const N: usize>(choices: &[impl Choose<Self, N>]) -> Result<Assembly, Failure> {
        // Whether all criteria before found both solutions valid, and what the last of them that was asked chose.
        let mut is_asked = Self::certainly(true);
        let mut is_first = Self::certainly(true);
        for (number, choice) in choices.iter().enumerate() {
            let (operands, zero) = (choice.operands(), Self::constant(0.0));
            let validity = choice.validity(operands);
            // The margin of numbers that are not finite is not finite.
            let finite = operands
                .into_iter()
                .fold(Self::constant(f64::INFINITY), |sum, operand| sum + operand * zero);
            let checks = [
                ("finite solutions", validity.are_finite, finite),
                ("a solution in the range", validity.has_one, validity.margin_of_one),
                (
                    "only one solution in the range",
                    Self::not(validity.has_two),
                    validity.margin_of_two,
                ),
            ];
            // Only the last criterion fails if both solutions are valid.
            let count = if number + 1 == choices.len() { 3 } else { 2 };
            for (name, condition, margin) in checks.into_iter().take(count) {
                let condition = <Self as Real>::either(Self::not(is_asked), || condition);
                let holds = recording::holds(name, condition, margin.value, recording::count());
                if !holds {
                    return Err(Failure::not_finite(choice.name()));
                }
            }
            let is_first_of_one = Self::both(is_asked, || validity.is_first);
            is_first = <Self as Real>::either(is_first_of_one, || Self::both(Self::not(is_asked), || is_first));
            is_asked = Self::both(is_asked, || validity.has_two);
        }
        Ok(recording::side(is_first))
    }

    fn root(
        solution: &mut [Self],
        sizes: &[Self],
        _: NewtonMemory<'_, Self>,
        mut equations: impl Equations<Self>,
    ) -> Result<(), Failure> {
        let count = solution.len();
        let mut sought_with = |search: usize| {
            let unknowns: Vec<Self> = (0..count)
                .map(|index| put(TapeNode::Unknown { search, index }))
                .collect();
            let (mut residuals, mut jacobian) = (unknowns.clone(), unknowns.repeat(count));
            equations.evaluate(&unknowns, &mut residuals, &mut jacobian);
            Sought {
                guess: values(solution),
                sizes: values(sizes),
                residuals: values(&residuals),
                jacobian: jacobian.chunks(count.max(1)).map(values).collect(),
            }
        };
        let search = recording::searched(&mut sought_with);
        if !recording::is_found(search) {
            return Err(Failure::not_finite("root"));
        }
        for (index, entry) in solution.iter_mut().enumerate() {
            *entry = put(TapeNode::Root { search, index });
        }
        Ok(())
    }

    fn factored(entries: &mut [Self], rows: &mut [FactorRow]) -> Result<Elimination, Failure> {
        let (system, holds) = recording::factored(entries.chunks(rows.len().max(1)).map(values).collect());
        if holds {
            // Each entry stands for the whole system.
            let system = u32::try_from(system).unwrap_or(u32::MAX);
            entries.fill(Self::at(Value(system)));
            Ok(Elimination::default())
        } else {
            Err(Failure::not_finite("matrix"))
        }
    }

    fn substituted(entries: &[Self], _: &[FactorRow], right: &[Self], solution: &mut [Self]) {
        let solved = recording::solved(entries[0].value.index(), values(right));
        for (index, entry) in solution.iter_mut().enumerate() {
            let solution = solved;
            *entry = put(TapeNode::Solution { solution, index });
        }
    }
}

fn values<F>(numbers: &[Recorded<F>]) -> Vec<Value> {
    numbers.iter().map(|number| number.value).collect()
}
