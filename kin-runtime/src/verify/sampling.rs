//! Random mechanisms and motions.

use core::f64::consts::PI;
use std::vec;
use std::vec::Vec;

use super::carrier::numbers_through;
use super::functions::VerifiedFunctions;
use super::{Random, Report, Worst};
use crate::any::{AssemblyChoice, Described, Of};
use crate::mechanism::{Description, Mechanism};
use crate::quantity::{Dimension, Quantity};

/// The number and the choice of poses to verify.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::verify::Sampling;
///
/// let sampling = Sampling { poses: 50, seed: 7, ..Sampling::default() };
/// sampling.mechanism::<FourBar>().assert();
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sampling {
    /// The number of poses wanted. They come from at least a quarter as many draws. With fewer than a quarter of these
    /// poses, a verification does not pass.
    pub poses: usize,
    /// The largest number of draws of dimensions and inputs.
    pub draws: usize,
    /// The seed of the draws. Each seed gives another sequence, the same in every run.
    pub seed: u64,
}

impl Default for Sampling {
    fn default() -> Self {
        Self {
            poses: 200,
            draws: 50_000,
            seed: 1,
        }
    }
}

impl Sampling {
    /// Verifies a mechanism over random dimensions and motions, in every assembly.
    ///
    /// Lengths and plain numbers are log-uniform over the decade around 1. Plain numbers, the coordinates of points and
    /// inputs that are lengths have random signs. Angles are uniform. The derivatives of the inputs have mixed sizes
    /// and signs. If the assemblies depend on the dimensions, the mechanism is solved near random values of the
    /// unknowns.
    pub fn mechanism<M: Mechanism<Scalar = f64>>(self) -> Report {
        let functions = Of::<M>::FUNCTIONS;
        let description = functions.description();
        self.run(functions, |random| {
            let parameters = description.parameters.iter().map(|quantity| {
                // The coordinate of a point has a dot in its name.
                if quantity.dimension == Dimension::Length && !quantity.name.contains('.') {
                    random.size()
                } else {
                    any(random, quantity, 1.0)
                }
            });
            let parameters = parameters.collect();
            let mut inputs = Vec::new();
            for input in description.inputs {
                let value = any(random, input, 1.0);
                motion(random, value, 1.0, description.order, &mut inputs);
            }
            (parameters, inputs)
        })
    }

    /// Verifies a mechanism around given dimensions, which are changed by up to a tenth, over given ranges of its
    /// inputs from low to high. The mechanism need not close everywhere.
    pub fn of<M: Mechanism<Scalar = f64>>(self, mechanism: &M, ranges: M::Inputs<(f64, f64)>) -> Report {
        let parameters = mechanism.parameters();
        self.of_any(Of::<M>::FUNCTIONS, parameters.as_ref(), ranges.as_ref())
    }

    /// [`of`](Self::of) a mechanism without its type.
    pub fn of_any(self, functions: &dyn VerifiedFunctions, given: &[f64], ranges: &[(f64, f64)]) -> Report {
        let description = functions.description();
        self.run(functions, |random| {
            let parameters = given.iter().map(|value| value * random.between(0.9, 1.1));
            let parameters: Vec<f64> = parameters.collect();
            let mut inputs = Vec::new();
            for (input, (low, high)) in description.inputs.iter().zip(ranges) {
                let value = random.between(*low, *high);
                let size = if input.dimension == Dimension::Length {
                    largest_length(description, &parameters).max(value.abs())
                } else {
                    1.0
                };
                motion(random, value, size, description.order, &mut inputs);
            }
            (parameters, inputs)
        })
    }

    /// Verifies at parameters and motions of the inputs that are drawn.
    fn run(
        self,
        functions: &dyn VerifiedFunctions,
        mut draw: impl FnMut(&mut Random) -> (Vec<f64>, Vec<f64>),
    ) -> Report {
        let mut random = Random::new(self.seed);
        let mut worst = Worst::default();
        let (mut tried, mut closed) = (0, 0);
        let needed = self.poses / 4;
        while tried < self.draws && (worst.poses < self.poses || closed < needed) {
            tried += 1;
            let (parameters, inputs) = draw(&mut random);
            let mut closes = false;
            for assembly in assemblies(functions, &parameters, &inputs, &mut random) {
                closes |= worst.check_any(functions, &parameters, &inputs, assembly.position());
            }
            closed += usize::from(closes);
        }
        let description = functions.description();
        Report {
            name: description.name.into(),
            worst,
            tried,
            closed,
            needed,
            seed: self.seed,
            numbers: numbers_through(description.order),
        }
    }
}

/// All named assemblies, or one reached from a random guess if the assemblies depend on the dimensions.
fn assemblies(
    functions: &dyn VerifiedFunctions,
    parameters: &[f64],
    inputs: &[f64],
    random: &mut Random,
) -> Vec<AssemblyChoice> {
    let count = functions.assembly_count();
    if count > 0 {
        return (0..count).map(AssemblyChoice::Index).collect();
    }
    let description = functions.description();
    let values: Vec<f64> = inputs.iter().copied().step_by(description.order + 1).collect();
    let length = largest_length(description, parameters);
    let guess = description.unknowns.iter().map(|unknown| any(random, unknown, length));
    let (guess, mut unknowns) = (guess.collect::<Vec<f64>>(), vec![0.0; description.unknowns.len()]);
    let found = functions.position_near(parameters, &values, &guess, &mut unknowns);
    found.map(|()| AssemblyChoice::Near(unknowns)).into_iter().collect()
}

/// A random value for a quantity of any kind.
fn any(random: &mut Random, quantity: &Quantity<'_>, length: f64) -> f64 {
    match quantity.dimension {
        Dimension::Length => length * random.signed_size(),
        Dimension::Angle => random.between(-PI, PI),
        Dimension::Scalar => random.signed_size(),
    }
}

/// Adds a random motion around a value, with derivatives of the size that belongs to a random rate.
fn motion(random: &mut Random, value: f64, size: f64, order: usize, motions: &mut Vec<f64>) {
    let rate = random.size();
    let mut power = size;
    motions.push(value);
    motions.extend((0..order).map(|_| {
        power *= rate;
        power * random.between(-1.0, 1.0)
    }));
}

/// The largest length of a mechanism, or 1 if it has none.
fn largest_length(description: &Description<'_>, parameters: &[f64]) -> f64 {
    let parameters = description.parameters.iter().zip(parameters);
    let largest = parameters
        .filter(|(quantity, _)| quantity.dimension == Dimension::Length)
        .fold(0.0_f64, |largest, (_, value)| largest.max(value.abs()));
    if largest > 0.0 { largest } else { 1.0 }
}
