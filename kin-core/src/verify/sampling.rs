//! Random mechanisms and motions.

use core::f64::consts::PI;
use std::vec::Vec;

use super::carrier::numbers_through;
use super::{Inputs, Random, Report, Worst};
use crate::mechanism::Mechanism;
use crate::number::Row;
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
    /// The seed of the draws. Each seed gives its own sequence, the same in every run.
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
        self.run(|random| {
            let mechanism = M::from_parameters(M::Parameters::from_fn(|index| {
                let quantity = &M::DESCRIPTION.parameters[index];
                // The coordinate of a point has a dot in its name.
                if quantity.dimension == Dimension::Length && !quantity.name.contains('.') {
                    random.size()
                } else {
                    any(random, quantity, 1.0)
                }
            }));
            let inputs = M::Inputs::from_fn(|index| {
                let value = any(random, &M::DESCRIPTION.inputs[index], 1.0);
                motion::<M>(random, value, 1.0)
            });
            (mechanism, inputs)
        })
    }

    /// Verifies a mechanism around given dimensions, which are changed by up to a tenth, over given ranges of its
    /// inputs from low to high. The mechanism need not close everywhere.
    pub fn of<M: Mechanism<Scalar = f64>>(self, mechanism: &M, ranges: M::Inputs<(f64, f64)>) -> Report {
        let given = mechanism.parameters();
        self.run(|random| {
            let mechanism = M::from_parameters(M::Parameters::from_fn(|index| given[index] * random.between(0.9, 1.1)));
            let inputs = M::Inputs::from_fn(|index| {
                let (low, high) = ranges[index];
                let value = random.between(low, high);
                let size = if M::DESCRIPTION.inputs[index].dimension == Dimension::Length {
                    largest_length(&mechanism).max(value.abs())
                } else {
                    1.0
                };
                motion::<M>(random, value, size)
            });
            (mechanism, inputs)
        })
    }

    fn run<M: Mechanism<Scalar = f64>>(self, mut draw: impl FnMut(&mut Random) -> (M, Inputs<M>)) -> Report {
        let mut random = Random::new(self.seed);
        let mut worst = Worst::default();
        let (mut tried, mut closed) = (0, 0);
        let needed = self.poses / 4;
        while tried < self.draws && (worst.poses < self.poses || closed < needed) {
            tried += 1;
            let (mechanism, inputs) = draw(&mut random);
            let mut closes = false;
            for assembly in assemblies(&mechanism, &inputs, &mut random) {
                closes |= worst.check(&mechanism, inputs, assembly);
            }
            closed += usize::from(closes);
        }
        Report {
            name: M::DESCRIPTION.name,
            worst,
            tried,
            closed,
            needed,
            seed: self.seed,
            numbers: numbers_through(M::DESCRIPTION.order),
        }
    }
}

/// All named assemblies, or one reached from a random guess if the assemblies depend on the dimensions.
fn assemblies<M: Mechanism<Scalar = f64>>(mechanism: &M, inputs: &Inputs<M>, random: &mut Random) -> Vec<M::Assembly> {
    if M::ASSEMBLY_COUNT > 0 {
        return M::assemblies().collect();
    }
    let values = M::Inputs::from_fn(|index| {
        let motion: &M::Motion<f64> = &inputs[index];
        motion[0]
    });
    let length = largest_length(mechanism);
    let guess = M::Unknowns::from_fn(|index| any(random, &M::DESCRIPTION.unknowns[index], length));
    mechanism
        .position_near(values, guess)
        .map(|unknowns| mechanism.assembly_at(values, unknowns))
        .into_iter()
        .collect()
}

/// A random value for a quantity of any kind.
fn any(random: &mut Random, quantity: &Quantity<'_>, length: f64) -> f64 {
    match quantity.dimension {
        Dimension::Length => length * random.signed_size(),
        Dimension::Angle => random.between(-PI, PI),
        Dimension::Scalar => random.signed_size(),
    }
}

/// A random motion around a value, with derivatives of the size that belongs to a random rate.
fn motion<M: Mechanism<Scalar = f64>>(random: &mut Random, value: f64, size: f64) -> M::Motion<f64> {
    let rate = random.size();
    let mut power = size;
    M::Motion::from_fn(|order| {
        if order == 0 {
            return value;
        }
        power *= rate;
        power * random.between(-1.0, 1.0)
    })
}

/// The largest length of a mechanism, or 1 if it has none.
fn largest_length<M: Mechanism<Scalar = f64>>(mechanism: &M) -> f64 {
    let parameters = mechanism.parameters();
    let largest = M::DESCRIPTION
        .parameters
        .iter()
        .zip(parameters.as_ref())
        .filter(|(quantity, _)| quantity.dimension == Dimension::Length)
        .fold(0.0_f64, |largest, (_, value)| largest.max(value.abs()));
    if largest > 0.0 { largest } else { 1.0 }
}
