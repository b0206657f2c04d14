//! Andrews' squeezer, against published values.

use kin_core::library::*;
use kin_core::prelude::*;
use kin_tests::compare::turned_back;
use kin_tests::oracles::{ALLOWED, Gauge};

/// Hairer and Wanner's initial position, to its printed digits.
#[test]
fn andrews_position() {
    let squeezer = AndrewsSqueezer::PUBLISHED;
    let position = squeezer
        .position(0.0, AndrewsSqueezer::PUBLISHED_ASSEMBLY)
        .expect("it is published");
    let motion = squeezer
        .solve(Motion::constant(0.0), AndrewsSqueezer::PUBLISHED_ASSEMBLY)
        .expect("it closes");
    let gauge = Gauge::new(&squeezer, &[Motion::constant(0.0)], &motion.unknown_motions());
    let published = [
        -0.061_713_890_014_276_45,
        0.455_279_819_163_070_4,
        0.222_668_390_165_885_9,
        0.487_364_979_543_842_55,
        -0.222_668_390_165_885_9,
        1.230_547_444_549_821_2,
    ];
    let own = [
        position.beta,
        position.gamma,
        position.phi,
        position.delta,
        position.omega,
        position.epsilon,
    ]
    .map(|angle| angle.value());
    for (index, (own, published)) in own.into_iter().zip(published).enumerate() {
        let difference = (own - published).abs();
        assert!(difference <= ALLOWED[0] * gauge.unknown(index, 0), "{own} {published}");
        // and in plain digits
        assert!(difference < 5e-16, "{own} {published}");
    }
}

/// At rest only what the crank's rod moves is accelerated: Hairer and Wanner's initial accelerations.
#[test]
fn andrews_start() {
    let start = Motion::from((0.0, 0.0, -10_666.832_939_965_585, 0.0, 0.0));
    let squeezer = AndrewsSqueezer::PUBLISHED;
    let pose = squeezer
        .solve(start, AndrewsSqueezer::PUBLISHED_ASSEMBLY)
        .expect("it closes");
    let gauge = Gauge::new(&squeezer, &[start], &pose.unknown_motions());
    let published = [14_222.443_919_954_114, 0.0, 0.0, 0.0, 0.0, 0.0];
    for (index, (own, published)) in pose.unknown_motions().into_iter().zip(published).enumerate() {
        assert_eq!(own.velocity(), 0.0);
        assert!(
            (own.acceleration() - published).abs() <= ALLOWED[2] * gauge.unknown(index, 2),
            "{}, {published}",
            own.acceleration()
        );
    }
}

/// The state after 0.03 s of F. Mazzia and C. Magherini's Test Set for Initial Value Problem Solvers, Bari 2008: given
/// the motion of theta to the acceleration, those of the other angles follow.
#[test]
fn andrews_after_integration() {
    let theta = Motion::from((
        -15.756_371_059_842_98,
        -1_424.379_294_994_111,
        51_850.377_016_103_29,
        0.0,
        0.0,
    ));
    // beta, gamma, phi, delta, omega, epsilon: value, velocity, acceleration
    let published: [[f64; 3]; 6] = [
        [15.810_771_196_299_04, 1_139.920_302_151_208, -24_631.763_166_951_96],
        [0.040_822_240_130_731_01, 11.032_912_219_371_34, 324_102.564_137_812_6],
        [-0.534_730_116_322_694_8, 19.293_374_644_213_85, 566_749.364_517_621_3],
        [0.524_409_965_880_530_4, 0.573_569_928_479_080_8, 16_743.629_294_793_61],
        [0.534_730_116_322_694_8, -19.293_374_644_213_85, -566_749.364_517_622_2],
        [1.048_080_741_042_263, 0.323_179_165_802_695_5, 9_826.520_791_458_422],
    ];
    let pose = AndrewsSqueezer::PUBLISHED
        .solve(theta, AndrewsSqueezer::PUBLISHED_ASSEMBLY)
        .expect("it closes");
    // the constraints hold for the published positions; velocities and accelerations are as good as the integration,
    // which did not impose the constraints on them
    let largest = |order: usize| published.iter().map(|state| state[order].abs()).fold(0.0, f64::max);
    let allowed = [0.0, 1e-10 * largest(1), 1e-6 * largest(2)];
    for (own, published) in pose.unknown_motions().into_iter().zip(published) {
        assert!(turned_back(own.value() - published[0]).abs() <= 8.0 * f64::EPSILON * published[0].abs());
        for order in [1, 2] {
            let difference = own.derivatives()[order] - published[order];
            assert!(difference.abs() <= allowed[order], "order {order}: {difference}");
        }
    }
}
