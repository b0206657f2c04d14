//! Statements to operations.

use std::collections::BTreeMap;

use kin_compiler::lowered::{self, Statement, Symbol, Value};
use kin_core::any::{Name, NameKind};

use super::call::{self, Argument, Call, ClosedForm, Guard};
use super::{Code, KeptFactors, Labels, Operation, Operations, Register};
use crate::elementary::Elementary;
use crate::memory::Lengths;

/// A mechanism that is too large for the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TooLarge;

/// Writes the code of routines that share their registers and run one after the other.
#[derive(Default)]
pub(crate) struct Assembler {
    registers: BTreeMap<Symbol, Register>,
    factors: BTreeMap<Symbol, usize>,
    sizes: Vec<usize>,
    /// Registers whose values are not read any more.
    free: Vec<Register>,
    next: usize,
    /// The number of statements so far, without those inside other statements.
    statement: usize,
    /// The last statement in which each symbol occurs.
    last: BTreeMap<Symbol, usize>,
    /// The symbols whose registers are free after each statement.
    ended: BTreeMap<usize, Vec<Symbol>>,
    routines: Vec<Operations>,
    calls: Vec<Call>,
    constants: Vec<f64>,
    is_too_large: bool,
}

/// The symbol of results that nobody reads.
const NOBODY: Symbol = Symbol::Value(usize::MAX);

/// The register of a value, and whether it is free after its use.
#[derive(Clone, Copy)]
struct Held {
    register: Register,
    is_temporary: bool,
}

impl Assembler {
    /// Writes routines. The registers of results keep their values to the end of the run; those of other symbols serve
    /// again after the last statement in which the symbol occurs. A mechanism then takes a third of the memory, and the
    /// poses of a batch stay in the first cache.
    pub(crate) fn of<'s>(
        routines: impl Iterator<Item = &'s [Statement]> + Clone,
        results: impl IntoIterator<Item = Symbol>,
        labels: &mut Labels<'_>,
    ) -> Self {
        let mut draft = Self::default();
        for statements in routines.clone() {
            draft.routine(statements, labels);
        }
        for result in results.into_iter().chain([NOBODY]) {
            draft.last.remove(&result);
        }
        let mut assembler = Self::default();
        for (symbol, statement) in draft.last {
            assembler.ended.entry(statement).or_default().push(symbol);
        }
        for statements in routines {
            assembler.routine(statements, labels);
        }
        assembler
    }

    /// The register of a symbol.
    pub(crate) fn register(&mut self, symbol: Symbol) -> Register {
        self.last.insert(symbol, self.statement);
        if let Some(&register) = self.registers.get(&symbol) {
            return register;
        }
        let register = match symbol {
            // parameters and inputs are written before the run
            Symbol::Parameter(_) | Symbol::Input(_) | Symbol::InputRate(..) | Symbol::Unknown(_) => self.new_register(),
            _ => self.temporary(),
        };
        self.registers.insert(symbol, register);
        register
    }

    fn new_register(&mut self) -> Register {
        let register = self.next;
        self.next += 1;
        Register::try_from(register).unwrap_or_else(|_| {
            self.is_too_large = true;
            0
        })
    }

    fn temporary(&mut self) -> Register {
        self.free.pop().unwrap_or_else(|| self.new_register())
    }

    fn release(&mut self, held: &[Held]) {
        let temporary = held.iter().filter(|held| held.is_temporary);
        self.free.extend(temporary.map(|held| held.register));
    }

    fn routine(&mut self, statements: &[Statement], labels: &mut Labels<'_>) {
        let mut operations = Vec::new();
        for statement in statements {
            self.statement(statement, labels, &mut operations);
            let ended = self.ended.remove(&self.statement).unwrap_or_default();
            self.free.extend(ended.iter().map(|symbol| self.registers[symbol]));
            self.statement += 1;
        }
        self.routines.push(operations.into());
    }

    /// The code of all routines.
    pub(crate) fn finish(self) -> Result<Code, TooLarge> {
        if self.is_too_large {
            return Err(TooLarge);
        }
        let (mut entry, mut row) = (0, 0);
        let factors = self.sizes.iter().map(|size| {
            let kept = KeptFactors {
                first_entry: entry,
                first_row: row,
            };
            entry += size * size;
            row += size;
            kept
        });
        let factors = factors.collect();
        let mut lengths = Lengths {
            registers: self.next,
            entries: entry,
            ..Lengths::default()
        };
        for call in &self.calls {
            let of_call = call.lengths();
            lengths.row = lengths.row.max(of_call.row);
            lengths.reals = lengths.reals.max(of_call.reals);
            lengths.rows = lengths.rows.max(of_call.rows);
        }
        lengths.rows += row;
        Ok(Code {
            routines: self.routines,
            calls: self.calls,
            constants: self.constants,
            factors,
            lengths,
        })
    }

    /// All symbols with their registers.
    pub(crate) fn registers(&self) -> impl Iterator<Item = (Symbol, Register)> {
        self.registers.iter().map(|(symbol, register)| (*symbol, *register))
    }

    /// A register with a number, which the last routine writes.
    pub(crate) fn number(&mut self, number: f64) -> Register {
        let to = self.new_register();
        let operation = self.constant(number, to);
        let mut operations = self.routines.pop().unwrap_or_default().into_vec();
        operations.push(operation);
        self.routines.push(operations.into());
        to
    }

    /// Writes a value, and returns the register that it chose.
    fn value(&mut self, value: &Value, operations: &mut Vec<Operation>) -> Held {
        if let Value::Symbol(symbol) = value {
            return Held {
                register: self.register(*symbol),
                is_temporary: false,
            };
        }
        let parts = self.parts(value, operations);
        self.release(&parts);
        let to = self.temporary();
        self.write(value, &parts, to, operations);
        Held {
            register: to,
            is_temporary: true,
        }
    }

    /// Writes a value to a given register.
    fn value_to(&mut self, value: &Value, to: Register, operations: &mut Vec<Operation>) {
        let parts = self.parts(value, operations);
        self.release(&parts);
        self.write(value, &parts, to, operations);
    }

    /// The operands of a value, from left to right.
    fn parts(&mut self, value: &Value, operations: &mut Vec<Operation>) -> Vec<Held> {
        let operands: Vec<&Value> = match value {
            Value::Symbol(_) | Value::Constant(_) | Value::Pi => Vec::new(),
            Value::Negate(a) => vec![a],
            Value::Add(a, b) | Value::Subtract(a, b) | Value::Multiply(a, b) | Value::Divide(a, b) => vec![a, b],
            Value::PlusProduct(rest, a, b) | Value::MinusProduct(rest, a, b) => vec![rest, a, b],
            Value::Call(_, arguments) => arguments.iter().collect(),
        };
        operands
            .into_iter()
            .map(|operand| self.value(operand, operations))
            .collect()
    }

    fn write(&mut self, value: &Value, parts: &[Held], to: Register, operations: &mut Vec<Operation>) {
        let registers: Vec<Register> = parts.iter().map(|held| held.register).collect();
        if let Some(operation) = products(value, parts, to, operations.last()) {
            operations.pop();
            operations.push(operation);
            return;
        }
        operations.push(match (value, registers.as_slice()) {
            (Value::Symbol(symbol), _) => Operation::Copy {
                to,
                a: self.register(*symbol),
            },
            (Value::Constant(constant), _) => self.constant(*constant, to),
            (Value::Pi, _) => self.constant(std::f64::consts::PI, to),
            (Value::Negate(_), &[a]) => Operation::Negate { to, a },
            (Value::Add(..), &[a, b]) => Operation::Add { to, a, b },
            (Value::Subtract(..), &[a, b]) => Operation::Subtract { to, a, b },
            (Value::Multiply(..), &[a, b]) => Operation::Multiply { to, a, b },
            (Value::Divide(..), &[a, b]) => Operation::Divide { to, a, b },
            (Value::PlusProduct(..), &[rest, a, b]) => Operation::PlusProduct { to, rest, a, b },
            (Value::MinusProduct(..), &[rest, a, b]) => Operation::MinusProduct { to, rest, a, b },
            (Value::Call("atan2", _), &[y, x]) => Operation::ArcTangent { to, y, x },
            (Value::Call(name, _), &[a]) => Operation::Function {
                function: Elementary::named(name).unwrap_or_else(|| unreachable!("numbers have the method {name}")),
                to,
                a,
            },
            _ => unreachable!("a value has as many operands as its operation takes"),
        });
    }

    fn constant(&mut self, value: f64, to: Register) -> Operation {
        let same = |known: &f64| known.to_bits() == value.to_bits();
        let index = self.constants.iter().position(same).unwrap_or_else(|| {
            self.constants.push(value);
            self.constants.len() - 1
        });
        let value = u16::try_from(index).unwrap_or_else(|_| {
            self.is_too_large = true;
            0
        });
        Operation::Constant { to, value }
    }

    fn call(&mut self, call: Call, operations: &mut Vec<Operation>) {
        self.calls.push(call);
        if let Ok(index) = u16::try_from(self.calls.len() - 1) {
            operations.push(Operation::Call(index));
        } else {
            self.is_too_large = true;
        }
    }

    /// Writes values that are needed together.
    fn values<'v>(
        &mut self,
        values: impl IntoIterator<Item = &'v Value>,
        operations: &mut Vec<Operation>,
    ) -> (Box<[Register]>, Vec<Held>) {
        let held: Vec<Held> = values.into_iter().map(|value| self.value(value, operations)).collect();
        (held.iter().map(|held| held.register).collect(), held)
    }

    /// The register of a decisive number. A number with terms is copied, so that its own register stays as it is.
    fn decisive(&mut self, decisive: &lowered::Decisive, operations: &mut Vec<Operation>) -> Held {
        let held = self.value(&decisive.value, operations);
        if decisive.terms.is_empty() {
            return held;
        }
        let copy = self.copy(held, operations);
        let to = copy.register;
        self.doubt(&decisive.terms, operations, |terms| Call::Decisive { to, terms });
        copy
    }

    fn copy(&mut self, held: Held, operations: &mut Vec<Operation>) -> Held {
        if held.is_temporary {
            return held;
        }
        let to = self.temporary();
        operations.push(Operation::Copy { to, a: held.register });
        Held {
            register: to,
            is_temporary: true,
        }
    }

    /// Writes terms, and the call that takes them. Numbers that always decide skip both.
    fn doubt(&mut self, terms: &[Value], operations: &mut Vec<Operation>, call: impl FnOnce(Box<[Register]>) -> Call) {
        let index = operations.len();
        operations.push(Operation::Doubt { skip: 0 });
        let (registers, held) = self.values(terms, operations);
        self.release(&held);
        self.call(call(registers), operations);
        let skip = u16::try_from(operations.len() - index - 1).unwrap_or_else(|_| {
            self.is_too_large = true;
            0
        });
        operations[index] = Operation::Doubt { skip };
    }

    fn argument(&mut self, argument: &lowered::Argument, operations: &mut Vec<Operation>) -> (Argument, Vec<Held>) {
        match argument {
            lowered::Argument::Scalar(scalar) => {
                let held = self.decisive(scalar, operations);
                (Argument::Scalar(held.register), vec![held])
            }
            lowered::Argument::Plane(vector, terms) => {
                let mut held = vector.each_ref().map(|value| self.value(value, operations));
                if !terms.is_empty() {
                    held = held.map(|held| self.copy(held, operations));
                    let to = held.map(|held| held.register);
                    self.doubt(terms, operations, |terms| Call::DecisiveVector { to, terms });
                }
                (Argument::Plane(held.map(|held| held.register)), held.into())
            }
            lowered::Argument::Pair(pair) => {
                let held = pair.each_ref().map(|value| self.value(value, operations));
                (Argument::Pair(held.map(|held| held.register)), held.into())
            }
            lowered::Argument::Matrix(rows) => {
                let held = rows
                    .each_ref()
                    .map(|row| row.each_ref().map(|value| self.value(value, operations)));
                let registers = held.map(|row| row.map(|held| held.register));
                (Argument::Matrix(registers), held.concat())
            }
            lowered::Argument::Known(number) => (Argument::Known(*number), Vec::new()),
        }
    }

    fn result(&mut self, symbol: Option<Symbol>) -> Register {
        // nobody reads the register of a result without a symbol
        self.register(symbol.unwrap_or(NOBODY))
    }

    fn statement(&mut self, statement: &Statement, labels: &mut Labels<'_>, operations: &mut Vec<Operation>) {
        match statement {
            Statement::Assign { symbol, value } => {
                let to = self.register(*symbol);
                self.value_to(value, to, operations);
            }
            Statement::Finite { symbol, value, label } => {
                let held = self.value(value, operations);
                self.release(&[held]);
                let to = self.register(*symbol);
                let (a, label) = (held.register, labels.name(label));
                self.call(Call::Finite { to, a, label }, operations);
            }
            Statement::Check {
                symbol,
                function,
                argument,
                label,
            } => {
                let held = self.decisive(argument, operations);
                self.release(&[held]);
                let argument = held.register;
                let (to, label) = (self.register(*symbol), labels.name(label));
                let guard = Guard::named(function).unwrap_or_else(|| unreachable!("there is a guard {function}"));
                self.call(
                    Call::Check {
                        to,
                        guard,
                        argument,
                        label,
                    },
                    operations,
                );
            }
            Statement::SineCosine { sine, cosine, angle } => {
                let held = self.value(angle, operations);
                self.release(&[held]);
                let (sine, cosine) = (self.result(*sine), self.result(*cosine));
                operations.push(Operation::SineCosine {
                    sine,
                    cosine,
                    angle: held.register,
                });
            }
            Statement::Solve {
                form,
                arguments,
                selection,
                returns,
                results,
                label,
            } => {
                let (arguments, held): (Vec<_>, Vec<_>) = arguments
                    .iter()
                    .map(|argument| self.argument(argument, operations))
                    .unzip();
                self.release(&held.concat());
                let call = Call::Solve {
                    form: ClosedForm::named(form).unwrap_or_else(|| unreachable!("there is a closed form {form}")),
                    arguments: arguments.into(),
                    selection: *selection,
                    returns: *returns,
                    results: results.iter().map(|symbol| self.result(*symbol)).collect(),
                    label: labels.name(label),
                };
                self.call(call, operations);
            }
            Statement::Angles { symbols, y, x, lengths } => self.angles(symbols, y, x, lengths, operations),
            Statement::InRange { range, label } => {
                let call = Call::InRange {
                    unknown: self.register(Symbol::Unknown(range.unknown)),
                    name: Name::by_index(NameKind::Unknown, range.unknown),
                    is_periodic: range.is_periodic,
                    range: [range.low, range.high],
                    label: labels.name(label),
                };
                self.call(call, operations);
            }
            Statement::Unwrap { unknown } => {
                let (index, unknown) = (*unknown, self.register(Symbol::Unknown(*unknown)));
                self.call(Call::Unwrap { unknown, index }, operations);
            }
            Statement::Candidates {
                body,
                kept,
                ranges,
                label,
            } => {
                let ranges = ranges.iter().filter_map(|range| {
                    let unknown = Symbol::Unknown(range.unknown);
                    Some(call::Range {
                        kept: kept.iter().position(|&symbol| symbol == unknown)?,
                        name: Name::by_index(NameKind::Unknown, range.unknown),
                        is_periodic: range.is_periodic,
                        bounds: [range.low, range.high],
                    })
                });
                let ranges: Box<[call::Range]> = ranges.collect();
                // a closed form has one unknown, or two
                self.is_too_large |= ranges.len() > 2;
                self.call(Call::Candidate, operations);
                let start = operations.len();
                for statement in body {
                    self.statement(statement, labels, operations);
                }
                let mut row = || {
                    let registers: Vec<Register> = kept.iter().map(|_| self.new_register()).collect();
                    registers.first().copied().unwrap_or(0)
                };
                let candidates = [row(), row()];
                let call = Call::Choose {
                    back: operations.len() - start,
                    kept: kept.iter().map(|&symbol| self.register(symbol)).collect(),
                    candidates,
                    ranges,
                    label: labels.name(label),
                };
                self.call(call, operations);
            }
            Statement::Newton { .. } => self.newton(statement, labels, operations),
            Statement::Every {
                block,
                coefficients,
                results,
                label,
                ..
            } => {
                let (coefficients, held) = self.values(coefficients, operations);
                self.release(&held);
                let call = Call::Every {
                    block: *block,
                    coefficients,
                    results: results.iter().map(|&symbol| self.register(symbol)).collect(),
                    label: labels.name(label),
                };
                self.call(call, operations);
            }
            Statement::Factor { symbol, matrix, label } => {
                let (entries, held) = self.values(matrix.iter().flatten(), operations);
                self.release(&held);
                self.sizes.push(matrix.len());
                self.factors.insert(*symbol, self.sizes.len() - 1);
                let call = Call::Factor {
                    factors: self.sizes.len() - 1,
                    size: matrix.len(),
                    matrix: entries,
                    label: labels.name(label),
                };
                self.call(call, operations);
            }
            Statement::Substitute {
                factors,
                right,
                results,
            } => {
                let (right, held) = self.values(right, operations);
                self.release(&held);
                let call = Call::Substitute {
                    factors: self.factors[factors],
                    right,
                    results: results.iter().map(|&symbol| self.register(symbol)).collect(),
                };
                self.call(call, operations);
            }
            Statement::Regular { symbol, value, label } => {
                let held = self.decisive(value, operations);
                self.release(&[held]);
                let value = held.register;
                let (to, label) = (self.result(*symbol), labels.name(label));
                self.call(Call::Regular { to, value, label }, operations);
            }
        }
    }

    fn angles(
        &mut self,
        symbols: &[Symbol],
        y: &[Value],
        x: &[Value],
        lengths: &[Value],
        operations: &mut Vec<Operation>,
    ) {
        let (y, held_y) = self.values(y, operations);
        let (x, held_x) = self.values(x, operations);
        let (lengths, held) = self.values(lengths, operations);
        self.release(&[held_y, held_x, held].concat());
        let to: Vec<Register> = symbols.iter().map(|&symbol| self.register(symbol)).collect();
        let call = match (to.as_slice(), &*y, &*x) {
            (&[to], &[y], &[x]) => Call::Angle {
                to,
                y,
                x,
                length: lengths.first().copied(),
            },
            (&[first, second], &[y, y_2], &[x, x_2]) => Call::TwoAngles {
                to: [first, second],
                y: [y, y_2],
                x: [x, x_2],
                lengths: (*lengths).try_into().ok(),
            },
            _ => unreachable!("one direction, or two"),
        };
        self.call(call, operations);
    }

    fn newton(&mut self, statement: &Statement, labels: &mut Labels<'_>, operations: &mut Vec<Operation>) {
        let Statement::Newton {
            unknowns,
            are_lengths,
            lengths,
            body,
            residuals,
            jacobian,
            label,
        } = statement
        else {
            return;
        };
        let registers = unknowns.iter().map(|&unknown| self.register(Symbol::Unknown(unknown)));
        let registers = registers.collect();
        let lengths = lengths.iter().map(|&symbol| self.register(symbol)).collect();
        let mut inside = Vec::new();
        for statement in body {
            self.statement(statement, labels, &mut inside);
        }
        let (residuals, held_residuals) = self.values(residuals, &mut inside);
        let (jacobian, held) = self.values(jacobian.iter().flatten(), &mut inside);
        self.release(&[held_residuals, held].concat());
        // an iteration cannot fail, so it is arithmetic alone
        debug_assert!(!inside.iter().any(|operation| matches!(operation, Operation::Call(_))));
        let call = Call::Newton {
            unknowns: unknowns.as_slice().into(),
            registers,
            are_lengths: are_lengths.as_slice().into(),
            lengths,
            body: inside.into(),
            residuals,
            jacobian,
            label: labels.name(label),
        };
        self.call(call, operations);
    }
}

/// The operation that adds two products, if the last operation has calculated the first product, or the first two terms
/// of the sum, for this value alone.
fn products(value: &Value, parts: &[Held], to: Register, last: Option<&Operation>) -> Option<Operation> {
    use Operation::{
        DifferenceOfProducts, MinusProduct, MinusProducts, Multiply, PlusMinusProducts, PlusProduct, PlusProducts,
        SumOfProducts,
    };
    let (&last, &[rest, c, d]) = (last?, parts) else {
        return None;
    };
    let (Multiply { to: found, .. } | PlusProduct { to: found, .. } | MinusProduct { to: found, .. }) = last else {
        return None;
    };
    let [c, d] = [c.register, d.register];
    if !rest.is_temporary || rest.register != found || [c, d].contains(&found) {
        return None;
    }
    match (last, value) {
        (Multiply { a, b, .. }, Value::PlusProduct(..)) => Some(SumOfProducts { to, a, b, c, d }),
        (Multiply { a, b, .. }, Value::MinusProduct(..)) => Some(DifferenceOfProducts { to, a, b, c, d }),
        (PlusProduct { rest, a, b, .. }, Value::PlusProduct(..)) => Some(PlusProducts { to, rest, a, b, c, d }),
        (PlusProduct { rest, a, b, .. }, Value::MinusProduct(..)) => Some(PlusMinusProducts { to, rest, a, b, c, d }),
        (MinusProduct { rest, a, b, .. }, Value::MinusProduct(..)) => Some(MinusProducts { to, rest, a, b, c, d }),
        _ => None,
    }
}
