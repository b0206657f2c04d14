//! Poses of a mechanism, in reach and out of reach, as numbers for a tape.

use kin_core::Row;
use kin_core::prelude::*;
use kin_tests::mechanisms::cases::{Case, ThroughSnap};
use kin_tests::random::Random;

/// The inputs of each mechanism in other languages, each tried in every assembly. About half of the poses are out of
/// reach.
pub(crate) const INPUTS: u32 = if cfg!(feature = "every-case") { 1000 } else { 100 };

/// A pose that is to be found.
pub(crate) struct Wanted<M: Mechanism> {
    pub(crate) mechanism: M,
    pub(crate) inputs: M::Inputs<M::Motion<f64>>,
    /// Values near the unknowns, if a block is coupled.
    pub(crate) near: Option<M::Unknowns<f64>>,
    /// The number of the assembly.
    pub(crate) number: usize,
}

impl<M: ThroughSnap> Wanted<M> {
    /// The arguments of the tape.
    pub(crate) fn arguments(&self) -> Vec<f64> {
        let mut own: Vec<f64> = self.mechanism.parameters().as_ref().to_vec();
        for motion in self.inputs.as_ref() {
            own.extend(motion.as_ref());
        }
        if let Some(near) = self.near {
            own.extend(near.as_ref());
        } else {
            let choices = M::ASSEMBLY_COUNT.trailing_zeros();
            let is_crossed = |choice: u32| self.number >> (choices - 1 - choice) & 1 == 1;
            own.extend((0..choices).map(|choice| if is_crossed(choice) { -1.0 } else { 1.0 }));
        }
        own
    }

    /// A length that no link exceeds.
    pub(crate) fn size(&self) -> f64 {
        let parameters = self.mechanism.parameters();
        parameters.as_ref().iter().fold(1.0, |sum, own| sum + own.abs())
    }
}

/// `count` inputs with dimensions, each in every assembly. Half of the dimensions are close to those of the case, the
/// others may not close at all.
pub(crate) fn poses<M: ThroughSnap>(case: Case, count: u32) -> Vec<Wanted<M>> {
    let mut random = Random::new(16);
    let mut all = Vec::new();
    for pose in 0..count {
        let mechanism: M = if pose % 2 == 0 {
            case.varied(&mut random)
        } else {
            M::from_parameters(M::Parameters::from_fn(|index| {
                case.parameters[index] * random.between(0.3, 2.0)
            }))
        };
        let own = case.inputs::<M>((f64::from(pose) + 0.5) / f64::from(count), &mut random);
        let inputs = <M::Inputs<M::Motion<f64>> as Row<_>>::from_fn(|index| own[index]);
        let near = (M::ASSEMBLY_COUNT == 0).then(|| M::Unknowns::from_fn(|_| random.between(-4.0, 4.0)));
        for number in 0..M::ASSEMBLY_COUNT.max(1) {
            all.push(Wanted {
                mechanism,
                inputs,
                near,
                number,
            });
        }
    }
    all
}
