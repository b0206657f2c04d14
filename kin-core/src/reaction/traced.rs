//! A number that notes what is done with it, and the program of these steps, which runs for many poses at once.

use alloc::collections::BTreeMap;
use alloc::vec;
use alloc::vec::Vec;
use core::cell::RefCell;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::pose_number::PoseNumber;
use crate::batch::Kernel;
use crate::batch::lanes::Lanes;
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

/// Functions of one number and of two.
type Call = fn(f64) -> f64;
type CallOfTwo = fn(f64, f64) -> f64;

/// A step, whose operands are the numbers of other steps; in a program, those of registers.
#[derive(Clone, Copy, Debug)]
enum Step {
    /// A number of a column.
    Given(u32),
    Constant(f64),
    Sum([u32; 2]),
    Difference([u32; 2]),
    Product([u32; 2]),
    Quotient([u32; 2]),
    Opposite(u32),
    SquareRoot(u32),
    Size(u32),
    Larger([u32; 2]),
    Call(Call, u32),
    CallOfTwo(CallOfTwo, [u32; 2]),
    /// Poses are lost where it is decided otherwise whether a number is larger than a part of another one.
    Exceeds([u32; 2], f64, bool),
    /// Poses are lost where a number has another sign.
    Sign(u32, bool),
}

impl Step {
    /// Its operands, and how many there are.
    fn operands(self) -> ([u32; 2], usize) {
        match self {
            Self::Given(_) | Self::Constant(_) => ([0; 2], 0),
            Self::Opposite(one) | Self::SquareRoot(one) | Self::Size(one) | Self::Call(_, one) | Self::Sign(one, _) => {
                ([one; 2], 1)
            }
            Self::Sum(both)
            | Self::Difference(both)
            | Self::Product(both)
            | Self::Quotient(both)
            | Self::Larger(both)
            | Self::CallOfTwo(_, both)
            | Self::Exceeds(both, ..) => (both, 2),
        }
    }

    /// The same with other operands.
    fn with(self, [one, other]: [u32; 2]) -> Self {
        let both = [one, other];
        match self {
            Self::Given(_) | Self::Constant(_) => self,
            Self::Opposite(_) => Self::Opposite(one),
            Self::SquareRoot(_) => Self::SquareRoot(one),
            Self::Size(_) => Self::Size(one),
            Self::Call(call, _) => Self::Call(call, one),
            Self::Sign(_, is_negative) => Self::Sign(one, is_negative),
            Self::Sum(_) => Self::Sum(both),
            Self::Difference(_) => Self::Difference(both),
            Self::Product(_) => Self::Product(both),
            Self::Quotient(_) => Self::Quotient(both),
            Self::Larger(_) => Self::Larger(both),
            Self::CallOfTwo(call, _) => Self::CallOfTwo(call, both),
            Self::Exceeds(_, part, exceeds) => Self::Exceeds(both, part, exceeds),
        }
    }

    /// By what it is known that an equal step is there already; none if it is never looked for.
    fn key(self) -> Option<(u8, u64, u32)> {
        let both = |kind: u8, [one, other]: [u32; 2]| Some((kind, u64::from(one), other));
        match self {
            Self::Given(column) => both(0, [column, 0]),
            Self::Constant(value) => Some((1, value.to_bits(), 0)),
            Self::Sum(operands) => both(2, operands),
            Self::Difference(operands) => both(3, operands),
            Self::Product(operands) => both(4, operands),
            Self::Quotient(operands) => both(5, operands),
            Self::Opposite(one) => both(6, [one, 0]),
            Self::SquareRoot(one) => both(7, [one, 0]),
            Self::Size(one) => both(8, [one, 0]),
            Self::Larger(operands) => both(9, operands),
            _ => None,
        }
    }

    /// Whether it is done for its own sake.
    fn is_guard(self) -> bool {
        matches!(self, Self::Exceeds(..) | Self::Sign(..))
    }
}

/// All steps since the trace began.
#[derive(Default)]
struct Trace {
    steps: Vec<Step>,
    known: BTreeMap<(u8, u64, u32), u32>,
}

impl Trace {
    const EMPTY: Self = Self {
        steps: Vec::new(),
        known: BTreeMap::new(),
    };

    fn add(&mut self, step: Step) -> u32 {
        let Some(key) = step.key() else {
            return self.push(step);
        };
        if let Some(known) = self.known.get(&key) {
            return *known;
        }
        let node = self.push(step);
        self.known.insert(key, node);
        node
    }

    fn push(&mut self, step: Step) -> u32 {
        self.steps.push(step);
        // a program of 2³² steps would fill the memory long before
        u32::try_from(self.steps.len() - 1).unwrap_or(u32::MAX)
    }

    /// The step of a number. A constant has one where it is needed.
    fn node(&mut self, number: Traced) -> u32 {
        number.node.unwrap_or_else(|| self.add(Step::Constant(number.value)))
    }
}

impl Traced {
    /// The number of a column, with its value in the pose that stands for the others.
    pub(super) fn given(column: usize, value: f64) -> Self {
        let column = u32::try_from(column).unwrap_or(u32::MAX);
        Self::noted(value, Step::Given(column))
    }

    fn noted(value: f64, step: Step) -> Self {
        let node = TRACE.with_borrow_mut(|trace| Some(trace.add(step)));
        Self { value, node }
    }

    fn known(self) -> Option<f64> {
        self.node.is_none().then_some(self.value)
    }

    /// The result of an operation, which is a constant if its operands are.
    fn of_two(self, other: Self, value: f64, step: impl FnOnce([u32; 2]) -> Step) -> Self {
        if self.node.is_none() && other.node.is_none() {
            return Self::constant(value);
        }
        let node = TRACE.with_borrow_mut(|trace| {
            let operands = [trace.node(self), trace.node(other)];
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
    fn exceeds(self, part: f64, other: Self) -> bool {
        let exceeds = self.value.exceeds(part, other.value);
        if self.node.is_some() || other.node.is_some() {
            TRACE.with_borrow_mut(|trace| {
                let operands = [trace.node(self), trace.node(other)];
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

/// Where a result stands: in a column, or nowhere because it is the same in all poses.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    Column(usize),
    Same(f64),
}

/// The steps that lead to results in many poses.
#[derive(Clone, Debug)]
pub(super) struct Program {
    /// The steps, each with the register of its result, and the column into which this is written.
    steps: Vec<(Step, u32, Option<u32>)>,
    /// The constants, each with its register.
    constants: Vec<(u32, f64)>,
    registers: usize,
    results: usize,
}

/// The poses for which a step is done at once. They fill two or more vectors.
const AT_ONCE: usize = 32;

impl Program {
    /// The program of what a function does with numbers, with the places of all numbers that it lists.
    pub(super) fn of<R>(trace: impl FnOnce() -> (R, Vec<Traced>)) -> (R, Self, Vec<Place>) {
        // what a trace before has left if it panicked
        drop(TRACE.take());
        let (result, wanted) = trace();
        let trace = TRACE.take();
        let (program, places) = trace.program(&wanted);
        (result, program, places)
    }

    /// The number of columns of results.
    pub(super) fn results(&self) -> usize {
        self.results
    }
}

impl Trace {
    fn program(&self, wanted: &[Traced]) -> (Program, Vec<Place>) {
        const UNUSED: usize = usize::MAX;
        // the last step that needs each number
        let mut last = vec![UNUSED; self.steps.len()];
        let mut columns = vec![None; self.steps.len()];
        let mut results = 0;
        let places = wanted.iter().map(|number| {
            let Some(node) = number.node.map(|node| node as usize) else {
                return Place::Same(number.value);
            };
            last[node] = last[node].min(node);
            let column = *columns[node].get_or_insert_with(|| {
                results += 1;
                results - 1
            });
            Place::Column(column)
        });
        let places: Vec<Place> = places.collect();
        for (node, step) in self.steps.iter().enumerate().rev() {
            if last[node] == UNUSED && !step.is_guard() {
                continue;
            }
            let (operands, count) = step.operands();
            for operand in &operands[..count] {
                let last = &mut last[*operand as usize];
                if *last == UNUSED || *last < node {
                    *last = node;
                }
            }
        }
        let mut program = Program {
            steps: Vec::new(),
            constants: Vec::new(),
            registers: 0,
            results,
        };
        let mut registers = vec![0; self.steps.len()];
        let mut free: Vec<u32> = Vec::new();
        for (node, step) in self.steps.iter().enumerate() {
            if last[node] == UNUSED && !step.is_guard() {
                continue;
            }
            let mut take = || {
                free.pop().unwrap_or_else(|| {
                    program.registers += 1;
                    u32::try_from(program.registers - 1).unwrap_or(u32::MAX)
                })
            };
            if let Step::Constant(value) = step {
                // it stays there for all poses
                program.registers += 1;
                registers[node] = u32::try_from(program.registers - 1).unwrap_or(u32::MAX);
                program.constants.push((registers[node], *value));
                continue;
            }
            let (operands, count) = step.operands();
            let own = operands.map(|operand| registers[operand as usize]);
            // results never take the place of an operand, which could be read afterwards
            if !step.is_guard() {
                registers[node] = take();
            }
            let column = columns[node].map(|column| u32::try_from(column).unwrap_or(u32::MAX));
            program.steps.push((step.with(own), registers[node], column));
            for (index, operand) in operands[..count].iter().enumerate() {
                let operand = *operand as usize;
                let is_again = index == 1 && operands[0] == operands[1];
                let stays = matches!(self.steps[operand], Step::Constant(_));
                if last[operand] == node && !stays && !is_again {
                    free.push(registers[operand]);
                }
            }
            if !step.is_guard() && last[node] == node {
                free.push(registers[node]);
            }
        }
        (program, places)
    }
}

/// A program with the numbers of poses in columns, each of which has room for as many as are found at once.
pub(super) struct ProgramRun<'r> {
    pub(super) program: &'r Program,
    /// So many poses there are.
    pub(super) count: usize,
    /// The length of a column.
    pub(super) stride: usize,
    pub(super) given: &'r [f64],
    pub(super) results: &'r mut [f64],
    /// Finite for the poses that are solved.
    pub(super) kept: &'r mut [f64],
}

impl Kernel for ProgramRun<'_> {
    type Result = ();
    type Element = f64;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const FUSED: bool>(self) {
        let groups = AT_ONCE / W;
        let zero = Lanes::<W, FUSED>::constant(0.0);
        let mut registers = vec![zero; self.program.registers * groups];
        for (register, value) in &self.program.constants {
            registers[*register as usize * groups..][..groups].fill(Lanes([*value; W]));
        }
        let mut start = 0;
        while start < self.count {
            for group in 0..groups {
                self.kept[start + group * W..][..W].fill(0.0);
            }
            for (step, own, column) in &self.program.steps {
                let at = |register: u32, group: usize| register as usize * groups + group;
                // the kind of a step is looked up once for all groups
                macro_rules! each {
                    (|$group:ident| $value:expr) => {
                        for $group in 0..groups {
                            registers[at(*own, $group)] = $value;
                        }
                    };
                }
                match *step {
                    Step::Given(column) => each!(|group| {
                        let mut lanes = [0.0; W];
                        let first = column as usize * self.stride + start + group * W;
                        lanes.copy_from_slice(&self.given[first..][..W]);
                        Lanes(lanes)
                    }),
                    Step::Constant(value) => each!(|group| Lanes([value; W])),
                    Step::Sum([a, b]) => each!(|group| registers[at(a, group)] + registers[at(b, group)]),
                    Step::Difference([a, b]) => each!(|group| registers[at(a, group)] - registers[at(b, group)]),
                    Step::Product([a, b]) => each!(|group| registers[at(a, group)] * registers[at(b, group)]),
                    Step::Quotient([a, b]) => each!(|group| registers[at(a, group)] / registers[at(b, group)]),
                    Step::Opposite(a) => each!(|group| -registers[at(a, group)]),
                    Step::SquareRoot(a) => each!(|group| Number::sqrt(registers[at(a, group)])),
                    Step::Size(a) => each!(|group| {
                        let Lanes(a) = registers[at(a, group)];
                        Lanes::from_fn(|lane| a[lane].abs())
                    }),
                    Step::Larger([a, b]) => each!(|group| {
                        let (Lanes(a), Lanes(b)) = (registers[at(a, group)], registers[at(b, group)]);
                        Lanes::from_fn(|lane| if a[lane] > b[lane] { a[lane] } else { b[lane] })
                    }),
                    Step::Call(call, a) => each!(|group| {
                        let Lanes(a) = registers[at(a, group)];
                        Lanes::from_fn(|lane| call(a[lane]))
                    }),
                    Step::CallOfTwo(call, [a, b]) => each!(|group| {
                        let (Lanes(a), Lanes(b)) = (registers[at(a, group)], registers[at(b, group)]);
                        Lanes::from_fn(|lane| call(a[lane], b[lane]))
                    }),
                    Step::Exceeds([a, b], part, exceeds) => {
                        for group in 0..groups {
                            let (Lanes(a), Lanes(b)) = (registers[at(a, group)], registers[at(b, group)]);
                            let kept = &mut self.kept[start + group * W..][..W];
                            for lane in 0..W {
                                let agrees = (a[lane].abs() > part * b[lane].abs()) == exceeds;
                                kept[lane] = if agrees { kept[lane] } else { f64::NAN };
                            }
                        }
                    }
                    Step::Sign(a, is_negative) => {
                        for group in 0..groups {
                            let Lanes(a) = registers[at(a, group)];
                            let kept = &mut self.kept[start + group * W..][..W];
                            for lane in 0..W {
                                let agrees = (a[lane] < 0.0) == is_negative;
                                kept[lane] = if agrees { kept[lane] } else { f64::NAN };
                            }
                        }
                    }
                }
                let Some(column) = column else { continue };
                for group in 0..groups {
                    let (first, Lanes(value)) = (start + group * W, registers[at(*own, group)]);
                    self.results[*column as usize * self.stride + first..][..W].copy_from_slice(&value);
                    let kept = &mut self.kept[first..][..W];
                    for lane in 0..W {
                        // zero, unless it is not finite
                        kept[lane] += 0.0 * value[lane];
                    }
                }
            }
            start += AT_ONCE;
        }
    }
}

/// The length of columns for so many poses.
pub(super) const fn stride(poses: usize) -> usize {
    poses.next_multiple_of(AT_ONCE)
}
