//! The topologies of the campaign, each with its closure written by hand.

use kin_core::Mechanism;
use kin_core::any::Of;
use kin_core::library::{
    FourBar, GearedFiveBar, GeometricFourBar, OffsetSliderCrank, Rssr, SphericalFourBar, StephensonIII, WattI,
};

use super::taylor::Taylor;
use super::topology::{Topology, poses};
use super::vectors::{Flat, Spatial, polar};
use crate::drawn::{self, Drawn0, Drawn1, Drawn2};
use crate::trees::{TreeOfAllKinds, TreeOfDyads};
use kin_tests::counting::Counting;
use kin_tests::mechanisms::chains::Chain4;
use kin_tests::mechanisms::coupled::{GearedPair, Kepler, StephensonThree, Triad};
use kin_tests::mechanisms::directions::DirectedRack;
use kin_tests::mechanisms::inverted_slider_crank_typings::{InvertedDrivenByCylinder, InvertedOffset};
use kin_tests::mechanisms::scalar_forms::{ExplicitFunctions, QuadraticForm};
use kin_tests::mechanisms::slider_crank_typings::SliderCrankDrivenAtSlider;

/// The rows of vector loops, one after the other.
fn loops<const N: usize>(loops: [Flat; N]) -> Vec<Taylor> {
    loops.into_iter().flat_map(|left| left.0).collect()
}

fn number(value: f64) -> Taylor {
    Taylor::constant(value)
}

fn pi() -> Taylor {
    Taylor::rounded(std::f64::consts::PI)
}

/// All topologies, each by its mechanism and its closure over parameters, inputs and unknowns.
macro_rules! topologies {
    ($($mechanism:ident: |$p:ident, $q:ident, $u:ident| $closure:expr;)+) => {
        pub(crate) const ALL: &[Topology] = &[$(Topology {
            solvers: Of::<$mechanism>::FUNCTIONS,
            counted: Of::<Counting<$mechanism>>::FUNCTIONS,
            closure: |$p, $q, $u| $closure,
            in_parallel: |problems, assemblies, vectors| {
                let assembly = assemblies[0].index().and_then(<$mechanism as Mechanism>::assembly);
                poses::<$mechanism>(problems, assemblies).solve_in_parallel(assembly, vectors)
            },
        }),+];
    };
}

/// r2 ∠θ2 + r3 ∠θ3 - r1 - r4 ∠θ4.
fn four_bar(r: &[Taylor], angles: [Taylor; 3]) -> Flat {
    let [theta2, theta3, theta4] = angles;
    let end = Flat::along(r[0]).plus(polar(r[3], theta4));
    polar(r[1], theta2).plus(polar(r[2], theta3)).minus(end)
}

topologies! {
    FourBar: |p, q, u| loops([four_bar(p, [q[0], u[0], u[1]])]);
    GeometricFourBar: |p, q, u| {
        let [r1, r2, r3, r4] = [p[0], p[1], p[2], p[3]];
        let [e, alpha, gamma, beta, theta4, theta3] = [u[0], u[1], u[2], u[3], u[4], u[5]];
        let (sine, cosine) = q[0].sin_cos();
        vec![
            e * e - r1 * r1 - r2 * r2 + number(2.0) * r1 * r2 * cosine,
            alpha.sin() - r2 * sine / e,
            gamma.cos() - (r3 * r3 + r4 * r4 - e * e) / (number(2.0) * r3 * r4),
            beta.sin() - r3 * gamma.sin() / e,
            alpha + beta + theta4 - pi(),
            theta3 - theta4 + gamma,
        ]
    };
    OffsetSliderCrank: |p, q, u| {
        loops([polar(p[0], q[0]).plus(polar(p[1], -u[0])).minus(Flat([u[1], p[2]]))])
    };
    SliderCrankDrivenAtSlider: |p, q, u| {
        loops([polar(p[0], u[0]).plus(polar(p[1], u[1])).minus(Flat([q[0], p[2]]))])
    };
    InvertedOffset: |p, q, u| {
        let pin = Flat::along(p[0]).plus(polar(p[1], q[0]));
        loops([pin.minus(Flat([u[0], p[2]]).turned(u[1]))])
    };
    InvertedDrivenByCylinder: |p, q, u| {
        loops([Flat::along(p[0]).plus(polar(p[1], u[0])).minus(polar(q[0], u[1]))])
    };
    GearedFiveBar: |p, q, u| {
        let left = polar(p[1], q[0]).plus(polar(p[2], u[0]));
        let right = Flat::along(p[0]).plus(polar(p[4], u[2])).plus(polar(p[3], u[1]));
        let mut rows = vec![u[2] - p[5] * q[0] - p[6]];
        rows.extend(left.minus(right).0);
        rows
    };
    WattI: |p, q, u| {
        let other = polar(p[1], q[0]).plus(Flat::new(&p[6..]).turned(u[0])).plus(polar(p[9], u[3]));
        let tool = Flat::new(&p[4..]).turned(q[0]).plus(polar(p[8], u[2]));
        loops([four_bar(p, [q[0], u[0], u[1]]), tool.minus(other)])
    };
    StephensonIII: |p, q, u| {
        let tip = polar(p[1], q[0]).plus(Flat::new(&p[4..]).turned(u[0]));
        let end = Flat::new(&p[7..]).plus(polar(p[9], u[3]));
        loops([four_bar(p, [q[0], u[0], u[1]]), tip.plus(polar(p[6], u[2])).minus(end)])
    };
    Chain4: |p, q, u| {
        let mut crank = polar(p[0], q[0]);
        let mut rows = Vec::new();
        for (sizes, angles) in p[1..].chunks(3).zip(u.chunks(2)) {
            let rocker = polar(sizes[2], angles[1]);
            let end = Flat::along(sizes[0]).plus(rocker);
            rows.extend(crank.plus(polar(sizes[1], angles[0])).minus(end).0);
            crank = rocker;
        }
        rows
    };
    TreeOfDyads: |p, q, u| {
        let pin = polar(p[0], q[0]);
        let pivot = Flat::new(&p[3..]);
        let carried = pin.plus(Flat::new(&p[5..]).turned(u[0]));
        let held = pivot.plus(Flat::new(&p[7..]).turned(u[1]));
        let last = carried.plus(Flat::new(&p[11..]).turned(u[2]));
        loops([
            pin.plus(polar(p[1], u[0])).minus(pivot.plus(polar(p[2], u[1]))),
            carried.plus(polar(p[9], u[2])).minus(held.plus(polar(p[10], u[3]))),
            last.plus(polar(p[13], u[4])).minus(Flat::new(&p[15..]).plus(polar(p[14], u[5]))),
        ])
    };
    TreeOfAllKinds: |p, q, u| {
        let pin = polar(p[0], q[0]);
        let other = Flat::new(&p[3..]).plus(polar(p[5], u[0]));
        let slide = Flat::new(&p[11..]).plus(polar(u[4], p[13]));
        let carried = pin.plus(Flat::new(&p[8..]).turned(u[1]));
        let held = other.plus(Flat::new(&p[14..]).turned(u[2]));
        let mut rows = vec![u[0] - p[1] * q[0] - p[2]];
        rows.extend(loops([
            pin.plus(polar(p[6], u[1])).minus(other.plus(polar(p[7], u[2]))),
            carried.plus(polar(p[10], u[3])).minus(slide),
            Flat::new(&p[16..]).plus(polar(u[5], u[6])).minus(held),
        ]));
        let ball = polar(p[18], u[6]);
        let rocker = Spatial::new(&p[19..]).plus(Spatial::new(&p[25..]).turned(Spatial::new(&p[22..]), u[7]));
        let coupler = rocker.minus(Spatial::flat(ball));
        rows.push(coupler.dot(coupler) - p[28] * p[28]);
        rows
    };
    DirectedRack: |p, q, u| {
        let mut rows = loops([four_bar(p, [q[0], u[0], u[1]])]);
        rows.push(u[2] - p[4] * u[1]);
        rows.push(u[3] - p[4] * u[1] * u[1]);
        rows
    };
    Rssr: |p, q, u| {
        let ball = polar(p[0], q[0]);
        let rocker = Spatial::new(&p[1..]).plus(Spatial::new(&p[7..]).turned(Spatial::new(&p[4..]), u[0]));
        let coupler = rocker.minus(Spatial::flat(ball));
        vec![coupler.dot(coupler) - p[10] * p[10]]
    };
    SphericalFourBar: |p, q, u| {
        // by the law of cosines on the sphere, in coordinates
        let [(ground, along), (crank, lean), (rocker, rise)] = [p[0], p[1], p[3]].map(Taylor::sin_cos);
        let hinge = polar(crank, q[0]);
        let swung = polar(rocker, u[0]);
        let end = Spatial([along * swung.0[0] + ground * rise, swung.0[1], along * rise - ground * swung.0[0]]);
        vec![end.dot(Spatial([hinge.0[0], hinge.0[1], lean])) - p[2].cos()]
    };
    QuadraticForm: |p, q, u| vec![(p[0] * u[0] + q[0]) * (u[0] - p[1]) + p[2] * q[0]];
    ExplicitFunctions: |p, q, u| {
        let (sine, cosine) = q[0].sin_cos();
        let (across, along) = (p[1] * sine, p[0] - p[1] * cosine);
        vec![
            u[0] - (p[0].squared() + p[1].squared() - number(2.0) * p[0] * p[1] * cosine).sqrt(),
            u[1] - across.atan2(along),
            u[2] - sine.exp() / (number(2.0) + u[0] / p[0]).ln() - (q[0] / number(3.0)).tan(),
            u[3] - (across / (number(2.0) * u[0])).asin() + (cosine / number(2.0)).acos() - u[2].atan(),
        ]
    };
    Triad: |p, q, u| {
        let joint = polar(p[0], q[0]).plus(polar(p[1], u[0]));
        let second = Flat::new(&p[7..]).plus(polar(p[2], u[1]));
        let third = Flat::new(&p[9..]).plus(polar(p[3], u[2]));
        loops([
            joint.plus(polar(p[4], u[3])).minus(second),
            joint.plus(polar(p[5], u[3] + p[6])).minus(third),
        ])
    };
    StephensonThree: |p, q, u| {
        let tip = polar(p[1], u[0]).plus(Flat::new(&p[4..]).turned(u[1]));
        let end = Flat::new(&p[6..]).plus(polar(p[9], q[0]));
        loops([four_bar(p, [u[0], u[1], u[2]]), tip.plus(polar(p[8], u[3])).minus(end)])
    };
    GearedPair: |p, q, u| {
        let end = Flat::along(p[0] + u[2]).plus(polar(p[3], u[1]));
        let mut rows = loops([polar(p[1], u[0]).plus(polar(p[2], q[0])).minus(end)]);
        rows.push(u[1] - p[4] * u[0] - p[5]);
        rows
    };
    Kepler: |p, q, u| vec![u[0] - p[0] * u[0].sin() - q[0]];
    Drawn0: |p, q, u| drawn::closure0(p, q, u);
    Drawn1: |p, q, u| drawn::closure1(p, q, u);
    Drawn2: |p, q, u| drawn::closure2(p, q, u);
}
