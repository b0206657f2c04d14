//! Two links of nearly one length, folded on each other so that their ends nearly coincide: the hardest place known for
//! derivatives.
//!
//! Such a dyad turns about its ends at nearly any speed. An error that its two angular accelerations have in common
//! hardly changes the jerks, and the condition counts on it. But the solver rounds the accelerations one by one.

use core::f64::consts::PI;

use kin_core::library::FourBar;
use kin_core::prelude::*;
use kin_precise::Number;
use kin_tests::random::Random;
use kin_tests::reference::{Given, solution};
use kin_tests::samples;

/// By how many units an unknown may be off, of ε times the condition with what is carried from order to order.
const ALLOWED: f64 = 1.0;

mod slider_driven {
    use kin_core::prelude::*;

    mechanism! {
        /// A slider-crank that its slider drives, declared by components.
        pub struct SliderDriven { pub a: Length, pub b: Length, pub e: Length }
        input s: Length;
        unknown th: Angle, ph: Angle;

        a * cos(th) + b * cos(ph) == s;
        a * sin(th) - b * sin(ph) == e;
    }
}

use slider_driven::SliderDriven;

/// The worst errors, order by order.
#[derive(Debug, Default)]
struct Worst {
    poses: usize,
    /// In units of ε times the condition.
    plain: [f64; 5],
    /// In units of ε times the condition with what is carried.
    carried: [f64; 5],
}

impl Worst {
    fn hold<M>(&mut self, mechanism: &M, input: [f64; 5], assembly: M::Assembly)
    where
        M: Mechanism<Scalar = f64, Motion<f64> = Motion>,
    {
        let inputs = M::Inputs::from_fn(|_| Motion::new(input));
        let Ok(pose) = mechanism.solve(inputs, assembly) else {
            return;
        };
        self.poses += 1;
        let motions = pose.unknown_motions();
        let position: Vec<f64> = motions.as_ref().iter().map(|motion| motion.derivatives()[0]).collect();
        let given = Given {
            parameters: mechanism.parameters().as_ref().to_vec(),
            inputs: vec![input.to_vec()],
        };
        let reference = solution::<M>(&given, &position).expect("there is a reference");
        for (place, motion) in motions.as_ref().iter().enumerate() {
            for (order, value) in motion.derivatives().into_iter().enumerate() {
                let error = &Number::exactly(value) - &reference.motions[place][order];
                let units = error.nearest().abs() / f64::EPSILON;
                let plain = units / reference.conditions[place][order];
                let carried = units / reference.carried[place][order];
                assert!(
                    carried <= ALLOWED,
                    "{}: order {order} of unknown {place} is off by {carried} units; {given:?}",
                    M::DESCRIPTION.name
                );
                self.plain[order] = self.plain[order].max(plain);
                self.carried[order] = self.carried[order].max(carried);
            }
        }
    }
}

/// A random pose whose links are this much longer than the distance of their ends.
fn folded(random: &mut Random, exponent: f64) -> (SliderDriven, [f64; 5]) {
    let distance = 10_f64.powf(-exponent);
    let a = random.between(0.5, 1.0);
    let b = a - distance * random.between(-0.9, 0.9);
    let (sine, cosine) = random.between(-PI, PI).sin_cos();
    let rates = [0; 4].map(|_| distance * random.between(-500.0, 500.0));
    let linkage = SliderDriven {
        a,
        b,
        e: distance * sine,
    };
    (linkage, [distance * cosine, rates[0], rates[1], rates[2], rates[3]])
}

#[test]
fn a_slider_drives_a_folded_slider_crank() {
    let mut worst = Worst::default();
    let linkage = SliderDriven {
        a: 0.823_984_984_509_306_8,
        b: 0.810_251_137_313_020_1,
        e: -0.014_277_841_906_781_497,
    };
    let slider = [
        0.011_427_078_392_600_196,
        -6.181_594_223_215_868_5,
        -2.641_387_276_328_293_5,
        -4.874_817_434_878_555,
        0.408_258_295_000_155_87,
    ];
    for assembly in Assembly::BOTH {
        worst.hold(&linkage, slider, assembly);
    }
    println!("{worst:.2?}");
    let mut random = Random::new(8);
    for exponent in 0..6 {
        let mut worst = Worst::default();
        for _ in 0..samples::of(40) {
            let (linkage, slider) = folded(&mut random, f64::from(exponent));
            for assembly in Assembly::BOTH {
                worst.hold(&linkage, slider, assembly);
            }
        }
        println!("ends at 1e-{exponent}: {worst:.2?}");
        assert!(worst.poses >= samples::of(40), "{worst:?}");
    }
}

/// A kite when its crank lies on the ground.
#[test]
fn a_four_bar_linkage_folded_to_a_kite() {
    let mut random = Random::new(9);
    for exponent in 0..6 {
        let mut worst = Worst::default();
        let distance = 10_f64.powi(-exponent);
        for _ in 0..samples::of(40) {
            let [ground, coupler] = [0; 2].map(|_| random.between(0.5, 1.0));
            let linkage = FourBar {
                r1: ground,
                r2: ground + distance * random.between(-0.5, 0.5),
                r3: coupler,
                r4: coupler + distance * random.between(-0.5, 0.5),
            };
            let crank = distance * random.between(-1.0, 1.0);
            for assembly in Assembly::BOTH {
                worst.hold(&linkage, [crank, 2.0, -1.0, 3.0, 0.5], assembly);
            }
        }
        println!("ends at 1e-{exponent}: {worst:.2?}");
        assert!(worst.poses >= samples::of(40), "{worst:?}");
    }
}
