//! A tape that is run by itself.

use core::error::Error;
use core::fmt;
use std::vec;
use std::vec::Vec;

use num_traits::Float;

use crate::failure::Failure;
use crate::number::Number;
use crate::quantity::Name;
use crate::solve::{self, FactorRow, NewtonMemory};
use crate::tape::structure::Tape;
use crate::tape::{Condition, Function, Operator, Plain, TapeNode, TapeStep, Value};

/// The check that failed in a run of a tape.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Stop {
    /// The index of the check.
    pub check: usize,
    /// The subject of the check, in a few words.
    pub name: &'static str,
    /// The unknowns of the block in which it was made, separated by commas.
    pub block: Name,
    /// The distance from passing; see [`TapeCheck::margin`](crate::tape::TapeCheck::margin).
    pub margin: f64,
}

impl fmt::Display for Stop {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            name, block, margin, ..
        } = self;
        write!(
            formatter,
            "the check `{name}` failed for `{block}`, with the margin {margin}"
        )
    }
}

crate::__debug_by_display!(Stop);

impl Error for Stop {}

impl Tape<'_> {
    /// Runs the tape on the [arguments](Self::arguments), in their order, in the number type for which it was recorded.
    /// The numbers found are in the order of the [results](Self::results).
    ///
    /// The numbers are those of `solve` to the last bit, in double precision. Where the build of this crate fuses
    /// products, so does the run.
    ///
    /// # Errors
    /// The first check that fails. If a number is missing among the arguments, it counts as NaN.
    ///
    /// ```
    /// use kin_core::library::FourBar;
    /// use kin_core::tape::{self, Options};
    ///
    /// let tape = tape::record::<FourBar>(&Options::new().up_to(0))?;
    /// let stop = tape.run(&[90.0, 30.0, 20.0, 25.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]).unwrap_err();
    /// assert_eq!(stop.name, "reach of two circles");
    /// assert_eq!(stop.block, "theta3, theta4");
    /// assert!(stop.margin < -30.0);
    /// # Ok::<(), tape::RecordError>(())
    /// ```
    pub fn run(&self, arguments: &[f64]) -> Result<Vec<f64>, Stop> {
        match self.precision {
            crate::tape::NumberType::Single => self.run_in::<f32>(arguments),
            crate::tape::NumberType::Double => self.run_in::<f64>(arguments),
        }
    }

    fn run_in<F: Plain + Float>(&self, arguments: &[f64]) -> Result<Vec<f64>, Stop> {
        let mut run = Run::<F>::new(self, arguments);
        for step in &self.steps {
            match *step {
                TapeStep::Compute(value) => run.compute(value),
                TapeStep::Check(check) => run.check(check)?,
                TapeStep::Search(search) => run.search(search),
                TapeStep::Factor(system) => run.factor(system),
                TapeStep::Solve(solution) => run.solve(solution),
            }
        }
        let results = self.results.iter();
        Ok(results.map(|result| run.number(result.value).real()).collect())
    }
}

/// The entries and the rows that [`solve::factor_in`] gives.
type TriangularFactors<F> = (Vec<F>, Vec<FactorRow>);

/// What a run has found so far.
struct Run<'a, F> {
    tape: &'a Tape<'a>,
    numbers: Vec<F>,
    truths: Vec<bool>,
    /// The roots of each search, or the residual where it stopped.
    roots: Vec<Result<Vec<F>, f64>>,
    /// The triangular factors of each system, or its determinant where it is singular.
    factors: Vec<Result<TriangularFactors<F>, f64>>,
    solutions: Vec<Vec<F>>,
}

impl<'a, F: Plain + Float> Run<'a, F> {
    fn new(tape: &'a Tape<'a>, arguments: &[f64]) -> Self {
        let mut run = Self {
            tape,
            numbers: vec![F::nan(); tape.nodes.len()],
            truths: vec![false; tape.nodes.len()],
            roots: vec![Err(f64::NAN); tape.searches.len()],
            factors: vec![Err(f64::NAN); tape.systems.len()],
            solutions: vec![Vec::new(); tape.solutions.len()],
        };
        for (index, node) in tape.nodes.iter().enumerate() {
            match *node {
                TapeNode::Argument(argument) => {
                    run.numbers[index] = arguments.get(argument).map_or_else(F::nan, |given| F::constant(*given));
                }
                TapeNode::Constant(constant) => run.numbers[index] = F::constant(constant.value()),
                TapeNode::Certain(truth) => run.truths[index] = truth,
                _ => {}
            }
        }
        run
    }

    fn number(&self, value: Value) -> F {
        match self.tape.nodes[value.index()] {
            TapeNode::Root { search, index } => match &self.roots[search] {
                Ok(roots) => roots[index],
                Err(_) => F::nan(),
            },
            TapeNode::Solution { solution, index } => self.solutions[solution][index],
            _ => self.numbers[value.index()],
        }
    }

    fn all(&self, values: &[Value]) -> Vec<F> {
        values.iter().map(|value| self.number(*value)).collect()
    }

    fn truth(&self, value: Value) -> bool {
        self.truths[value.index()]
    }

    fn compute(&mut self, value: Value) {
        let node = self.tape.nodes[value.index()];
        if node.is_truth() {
            self.truths[value.index()] = self.decided(node);
        } else {
            self.numbers[value.index()] = self.computed(node);
        }
    }

    fn decided(&self, node: TapeNode) -> bool {
        match node {
            TapeNode::Compare(comparison, one, other) => {
                comparison.holds(self.number(one).real(), self.number(other).real())
            }
            TapeNode::IsFinite(one) => Number::is_finite(self.number(one)),
            TapeNode::Both(one, other) => self.truth(one) && self.truth(other),
            TapeNode::Either(one, other) => self.truth(one) || self.truth(other),
            TapeNode::Not(one) => !self.truth(one),
            _ => false,
        }
    }

    fn computed(&self, node: TapeNode) -> F {
        let operand = |value: Value| self.number(value);
        match node {
            TapeNode::Call(function, one) => called(function, operand(one)),
            TapeNode::Binary(operator, one, other) => combined(operator, operand(one), operand(other)),
            TapeNode::PlusProduct(sum, one, other) => operand(sum).plus_product(operand(one), operand(other)),
            TapeNode::MinusProduct(sum, one, other) => operand(sum).minus_product(operand(one), operand(other)),
            TapeNode::Select(truth, one, other) => operand(if self.truth(truth) { one } else { other }),
            _ => F::nan(),
        }
    }

    fn check(&mut self, index: usize) -> Result<(), Stop> {
        let check = &self.tape.checks[index];
        let measure = match check.condition {
            Condition::Holds(truth) => (!self.truth(truth)).then_some(f64::NAN),
            Condition::Found(search) => self.roots[search].as_ref().err().copied(),
            Condition::Regular(system) => self.factors[system].as_ref().err().copied(),
        };
        let Some(measure) = measure else { return Ok(()) };
        for value in &check.cold {
            self.compute(*value);
        }
        Err(Stop {
            check: index,
            name: check.name,
            block: check.block,
            margin: check.margin.map_or(measure, |margin| self.number(margin).real()),
        })
    }

    fn search(&mut self, index: usize) {
        let tape = self.tape;
        let search = &tape.searches[index];
        let (mut solution, sizes) = (self.all(&search.guess), self.all(&search.sizes));
        let unknowns: Vec<(usize, usize)> = (tape.nodes.iter().enumerate())
            .filter_map(|(index_of_node, node)| match *node {
                TapeNode::Unknown { search, index: unknown } if search == index => Some((index_of_node, unknown)),
                _ => None,
            })
            .collect();
        let [numbers, reals, rows] = NewtonMemory::<F>::lengths(solution.len());
        let (mut numbers, mut reals) = (vec![F::nan(); numbers], vec![0.0; reals]);
        let mut rows = vec![FactorRow::default(); rows];
        let Some(memory) = NewtonMemory::new(solution.len(), &mut numbers, &mut reals, &mut rows) else {
            unreachable!("the memory has the lengths that it needs");
        };
        let root = solve::newton_in(
            &mut solution,
            &sizes,
            memory,
            |at: &[F], residuals: &mut [F], jacobian: &mut [F]| {
                for (index_of_node, unknown) in &unknowns {
                    self.numbers[*index_of_node] = at[*unknown];
                }
                for value in &search.body {
                    self.compute(*value);
                }
                for (place, value) in residuals.iter_mut().zip(&search.residuals) {
                    *place = self.number(*value);
                }
                for (place, value) in jacobian.iter_mut().zip(search.jacobian.iter().flatten()) {
                    *place = self.number(*value);
                }
            },
        );
        self.roots[index] = match root {
            Ok(()) => Ok(solution),
            Err(Failure::NotConverged { residual, .. }) => Err(residual),
            Err(Failure::Singular { determinant }) => Err(determinant),
            Err(_) => Err(f64::NAN),
        };
    }

    fn factor(&mut self, index: usize) {
        let matrix = &self.tape.systems[index].rows;
        let mut entries: Vec<F> = matrix.iter().flatten().map(|value| self.number(*value)).collect();
        let mut rows = vec![FactorRow::default(); matrix.len()];
        self.factors[index] = match solve::factor_in(&mut entries, &mut rows) {
            Ok(_) => Ok((entries, rows)),
            Err(Failure::Singular { determinant }) => Err(determinant),
            Err(_) => Err(f64::NAN),
        };
    }

    fn solve(&mut self, index: usize) {
        let solution = &self.tape.solutions[index];
        let right = self.all(&solution.right);
        self.solutions[index] = match &self.factors[solution.system] {
            Ok((entries, rows)) => {
                let mut found = right.clone();
                solve::substitute_in(entries, rows, &right, &mut found);
                found
            }
            Err(_) => vec![F::nan(); right.len()],
        };
    }
}

/// A function of two numbers.
pub(super) fn combined<F: Plain>(operator: Operator, one: F, other: F) -> F {
    match operator {
        Operator::Add => one + other,
        Operator::Subtract => one - other,
        Operator::Multiply => one * other,
        Operator::Divide => one / other,
        Operator::ArcTangent => one.atan2(other),
    }
}

/// A function of one number.
pub(super) fn called<F: Plain + Float>(function: Function, one: F) -> F {
    match function {
        Function::Negate => -one,
        Function::Magnitude => Float::abs(one),
        Function::SquareRoot => Number::sqrt(one),
        Function::Sine => Number::sin_cos(one).0,
        Function::Cosine => Number::sin_cos(one).1,
        Function::ArcSine => Number::asin(one),
        Function::ArcCosine => Number::acos(one),
        Function::ArcTangent => Number::atan(one),
        Function::HyperbolicSine => Number::sinh(one),
        Function::HyperbolicCosine => Number::cosh(one),
        Function::HyperbolicTangent => Number::tanh(one),
        Function::AreaHyperbolicSine => Number::asinh(one),
        Function::AreaHyperbolicCosine => Number::acosh(one),
        Function::AreaHyperbolicTangent => Number::atanh(one),
        Function::Exponential => Number::exp(one),
        Function::Logarithm => Number::ln(one),
        Function::Round => Float::round(one),
        Function::Raise => Float::ceil(one),
    }
}
