//! The translated methods: residuals, outputs, and places of the picture.

use kin_compiler::Declaration;
use kin_compiler::tree::Sheet;
use kin_core::any::{ClosureOver, Of, OutputsOver, SkeletonOver};
use kin_core::{Mechanism, Row};
use kin_live::sheet::SheetCode;

use crate::bits::Bits;
use crate::random::Random;
use crate::samples;

/// The numbers of a position: parameters, inputs and unknowns.
type Numbers<T> = [Vec<T>; 3];

/// Compares the translated methods in one kind of numbers. Returns how many results were finite.
pub(crate) fn agreeing<M: Mechanism<Scalar = f64>, T: Bits>(declaration: &Declaration) -> usize {
    let counts = [
        M::Parameters::<f64>::LENGTH,
        M::Inputs::<f64>::LENGTH,
        M::Unknowns::<f64>::LENGTH,
    ];
    let sheets = declaration.sheets();
    let residuals = |[parameters, inputs, unknowns]: &Numbers<T>, found: &mut [T]| {
        Of::<M>::FUNCTIONS.closure(parameters, inputs, unknowns, found);
    };
    let outputs = |[parameters, inputs, unknowns]: &Numbers<T>, found: &mut [T]| {
        Of::<M>::FUNCTIONS.outputs(parameters, inputs, unknowns, found);
    };
    assert_agreeing(&sheets.closure, counts, residuals)
        + assert_agreeing(&sheets.outputs, counts, outputs)
        + assert_agreeing(&sheets.skeleton_points, counts, places::<M, T>)
}

/// The places of the compiled mechanism, part by part.
fn places<M: Mechanism<Scalar = f64>, T: Bits>([parameters, inputs, unknowns]: &Numbers<T>, found: &mut [T]) {
    let mut all = Vec::new();
    Of::<M>::FUNCTIONS.skeleton_points(parameters, inputs, unknowns, &mut |place| all.extend_from_slice(place));
    found.copy_from_slice(&all);
}

/// Compares one method, and returns how many of its results were finite.
fn assert_agreeing<T: Bits>(sheet: &Sheet, counts: [usize; 3], compiled: impl Fn(&Numbers<T>, &mut [T])) -> usize {
    let [parameters, inputs, unknowns] = counts;
    let code = SheetCode::new(sheet, parameters, inputs, unknowns).expect("it uses what is there");
    let mut random = Random::new(7);
    let mut registers = vec![T::constant(f64::NAN); code.registers()];
    let zero = T::constant(0.0);
    let [mut found, mut expected] = [vec![zero; code.results()], vec![zero; code.results()]];
    let mut finite = 0;
    for _ in 0..samples() {
        let numbers = counts.map(|count| (0..count).map(|_| T::drawn(&mut random)).collect::<Vec<T>>());
        let [parameters, inputs, unknowns] = &numbers;
        code.run(parameters, inputs, unknowns, &mut registers, &mut found);
        compiled(&numbers, &mut expected);
        for (index, (found, expected)) in found.iter().zip(&expected).enumerate() {
            assert_eq!(
                found.bits(),
                expected.bits(),
                "result {index} of {sheet:?} at {numbers:?}"
            );
            finite += usize::from(found.is_finite());
        }
    }
    finite
}
