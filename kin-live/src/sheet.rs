//! Translated methods of a mechanism as flat code over numbers.

mod compile;
mod instruction;
mod registers;

use kin_compiler::tree::Sheet;
use kin_core::Scalar;

use instruction::Instruction;

/// A method: instructions over registers of one number each. A vector takes two or three registers in a row, a rotation
/// nine.
///
/// ```
/// use kin_live::sheet::SheetCode;
///
/// let text = "struct Crank { r: Length } input t: Angle; unknown x: Length; x == r * cos(t);";
/// let declaration = kin_compiler::Declaration::parse(text).expect("there is no mistake");
/// let closure = SheetCode::new(&declaration.sheets().closure, 1, 1, 1).expect("there is one of each");
/// let (mut registers, mut residuals) = (vec![0.0; closure.registers()], [1.0]);
/// closure.run(&[3.0], &[0.5], &[3.0 * 0.5_f64.cos()], &mut registers, &mut residuals);
/// assert_eq!(residuals, [0.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SheetCode {
    /// The numbers of parameters, inputs and unknowns, which stand in the first registers.
    given: [usize; 3],
    instructions: Vec<Instruction>,
    registers: usize,
    /// The registers of the results.
    results: Vec<usize>,
}

impl SheetCode {
    /// The code of a method, for as many scalar parameters, inputs and unknowns as the mechanism has. `None` if the
    /// method uses one that is not there; no method of a compiled declaration does.
    #[must_use]
    pub fn new(sheet: &Sheet, parameters: usize, inputs: usize, unknowns: usize) -> Option<Self> {
        compile::compiled(sheet, [parameters, inputs, unknowns])
    }

    /// The number of registers that a run needs.
    #[must_use]
    pub fn registers(&self) -> usize {
        self.registers
    }

    /// The number of results: all vectors part by part.
    #[must_use]
    pub fn results(&self) -> usize {
        self.results.len()
    }

    /// Calculates the results. What the registers hold before does not matter.
    ///
    /// # Panics
    /// If a slice does not have the length that was given to [`new`](Self::new), or that this code names.
    pub fn run<T: Scalar>(
        &self,
        parameters: &[T],
        inputs: &[T],
        unknowns: &[T],
        registers: &mut [T],
        results: &mut [T],
    ) {
        let mut next = 0;
        for (given, count) in [parameters, inputs, unknowns].into_iter().zip(self.given) {
            registers[next..next + count].copy_from_slice(given);
            next += count;
        }
        for instruction in &self.instructions {
            instruction.run(registers);
        }
        assert_eq!(results.len(), self.results.len(), "one number for each result");
        for (result, &register) in results.iter_mut().zip(&self.results) {
            *result = registers[register];
        }
    }
}
