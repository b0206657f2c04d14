//! Every mechanism of the library: its method of solution, its motion up to snap at one pose, and its verification.
//!
//! ```sh
//! cargo run --release --features num-dual --example library
//! ```
//!
//! The exit code is not zero if a mechanism does not close or is not verified.

use std::f64::consts::{FRAC_PI_2, PI};
use std::process::ExitCode;

#[allow(clippy::wildcard_imports, reason = "it is the example of the whole library")]
use kin_core::library::*;
use kin_core::prelude::*;
use kin_core::verify::{self, Oracle, Report};

/// The numbers of mechanisms shown and failed.
#[derive(Default)]
struct Catalogue {
    shown: usize,
    failed: usize,
}

/// An input that moves at constant speed.
fn steady(value: f64, speed: f64) -> Motion {
    Motion::at_constant_speed(value, speed)
}

impl Catalogue {
    /// Prints a mechanism in one assembly. The verification changes dimensions by up to a tenth, and inputs by up to
    /// `range` to either side.
    fn show<M>(&mut self, mechanism: M, inputs: M::Inputs<Motion>, range: f64, assembly: M::Assembly)
    where
        M: Mechanism<Scalar = f64, Motion<f64> = Motion>,
    {
        let description = M::DESCRIPTION;
        self.shown += 1;
        println!("{} {assembly:?}", description.name);
        for block in description.blocks {
            println!("  {:<32} {}", block.unknowns, block.solution);
        }
        let pose = match mechanism.solve(inputs, assembly) {
            Ok(pose) => pose,
            Err(error) => {
                println!("  {error}\n");
                self.failed += 1;
                return;
            }
        };
        let names = |quantities: &'static [kin_core::Quantity]| quantities.iter().map(|quantity| quantity.name);
        let all = names(description.inputs).zip(inputs.as_ref().iter().copied()).chain(
            names(description.unknowns)
                .zip(pose.unknown_motions().as_ref().iter().copied())
                .chain(names(description.outputs).zip(pose.output_motions().as_ref().iter().copied()))
                .collect::<Vec<_>>(),
        );
        for (name, motion) in all {
            let numbers = motion.derivatives().map(|value| format!("{value:14.6}"));
            println!("  {name:<16}{}", numbers.concat());
        }
        let ranges = M::Inputs::from_fn(|index| {
            let value = inputs[index].value();
            (value - range, value + range)
        });
        let report = verify::of(&mechanism, ranges);
        self.failed += usize::from(!report.passed());
        println!("  {}\n", verdict(&report));
    }
}

/// The verification in one line: the worst error of each oracle, relative to the allowed error.
fn verdict(report: &Report) -> String {
    let worst = |oracle: Oracle| {
        let parts = report.worst.errors(oracle).iter().enumerate();
        parts.fold(0.0, |worst: f64, (order, error)| {
            worst.max(error / verify::allowed(order))
        })
    };
    format!(
        "{} at {} poses: worst of what is allowed {:.1} % against dual numbers, {:.1} % left of the equations",
        if report.passed() { "verified" } else { "NOT VERIFIED" },
        report.worst.poses,
        100.0 * worst(Oracle::Differentiation).max(worst(Oracle::Outputs)),
        100.0 * worst(Oracle::Closure),
    )
}

fn main() -> Result<ExitCode, SolveError> {
    println!(
        "Angles in radians, lengths in the unit of each mechanism's dimensions; each line from position to snap.\n"
    );
    let mut catalogue = Catalogue::default();
    four_bars(&mut catalogue);
    sliders(&mut catalogue);
    straight_lines(&mut catalogue);
    five_bars(&mut catalogue);
    six_bars(&mut catalogue)?;
    machines(&mut catalogue);
    in_space(&mut catalogue);
    println!("{} mechanisms, {} failed", catalogue.shown, catalogue.failed);
    Ok(if catalogue.failed == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

fn four_bars(catalogue: &mut Catalogue) {
    let (r1, r2, r3, r4) = (90.0, 30.0, 60.0, 45.0);
    let crank = [Motion::from((65_f64.to_radians(), -10.0, 2.0, -0.5, 0.3))];
    let triangles = GeometricFourBar { r1, r2, r3, r4 };
    let assembly = triangles.assembly(crank[0].value(), Assembly::Open);
    catalogue.show(FourBar { r1, r2, r3, r4 }, crank, 0.5, Assembly::Open);
    catalogue.show(triangles, crank, 0.5, assembly);
    catalogue.show(
        FreudensteinFourBar { r1, r2, r3, r4 },
        crank,
        0.5,
        FreudensteinFourBar::OPEN,
    );
}

fn sliders(catalogue: &mut Catalogue) {
    let (r, l) = (1.0, 3.5);
    let crank = [steady(0.8, 2.0)];
    catalogue.show(SliderCrank { r, l }, crank, PI, Assembly::Open);
    catalogue.show(OffsetSliderCrank { r, l, h: 0.4 }, crank, PI, Assembly::Open);
    catalogue.show(SliderCrankFirstApproximation { r, l }, crank, PI, ());
    catalogue.show(SliderCrankHigherApproximation { r, l }, crank, PI, ());
    catalogue.show(InvertedSliderCrank { r1: 2.0, r2: 0.8 }, crank, PI, ());
    let press = WhitworthQuickReturn {
        ground: 0.05,
        crank: 0.12,
        arm: 0.15,
        rod: 0.5,
    };
    catalogue.show(press, crank, PI, Assembly::Open);
    let yoke = ScotchYoke {
        crank: 2.0,
        gamma: FRAC_PI_2,
    };
    catalogue.show(yoke, crank, PI, ());
}

fn straight_lines(catalogue: &mut Catalogue) {
    catalogue.show(ChebyshevLinkage::PUBLISHED, [steady(1.2, 1.0)], 0.3, Assembly::Crossed);
    catalogue.show(HoekenLinkage::PUBLISHED, [steady(2.8, 1.0)], PI, Assembly::Open);
    let roberts = RobertsLinkage { base: 1.0, arm: 1.2 };
    catalogue.show(roberts, [steady(1.0, 1.0)], 0.3, Assembly::Open);
    let peaucellier = PeaucellierLinkage {
        ground: 2.0,
        crank: 2.0,
        arm: 6.0,
        side: 4.0,
    };
    let straight = PeaucellierLinkage::STRAIGHT;
    catalogue.show(peaucellier, [steady(0.6, 1.0)], 0.8, straight);
    let pantograph = Pantograph {
        upper: 2.0,
        lower: 1.5,
        factor: 2.5,
    };
    let tracer = [steady(2.0, 1.0), steady(1.0, -0.5)];
    catalogue.show(pantograph, tracer, 0.5, Pantograph::SIMILAR);
}

fn five_bars(catalogue: &mut Catalogue) {
    let robot = FiveBar {
        ground: 2.0,
        left: 1.5,
        left_rod: 2.0,
        right_rod: 2.0,
        right: 1.5,
    };
    catalogue.show(robot, [steady(2.0, 0.4), steady(1.0, 0.3)], 0.5, Assembly::Open);
    let engine = GearedFiveBar {
        r1: 2.0,
        r2: 0.5,
        r3: 2.5,
        r4: 2.5,
        r5: 0.5,
        ratio: -1.0,
        phase: PI,
    };
    catalogue.show(engine, [steady(0.8, 3.0)], PI, Assembly::Open);
}

/// Shows the six-bar linkages, each driven at two different links: with the first drive the dyads close one after the
/// other, with the second nothing closes by itself. The second drive has the motion that results from the first.
fn six_bars(catalogue: &mut Catalogue) -> Result<(), SolveError> {
    let crank = steady(2.5, 2.0);
    let values = |angles: [Motion; 4]| Near(angles.map(|angle| angle.value()));

    let watt1 = WattI::from_parameters([4.0, 1.0, 3.0, 2.5, 1.5, 0.8, 2.0, 1.5, 2.5, 2.0]);
    let first = WattI::ASSEMBLIES[0];
    let pose = watt1.solve(crank, first)?;
    catalogue.show(watt1, [crank], 1.0, first);
    let near = values([crank, pose.theta3, pose.theta4, pose.theta6]);
    let driven = WattIByDyad::from_parameters(watt1.parameters());
    catalogue.show(driven, [pose.theta5], 0.5, near);

    let watt2 = WattII::from_parameters([4.0, 1.0, 3.0, 2.5, 2.0, 1.0, 7.0, 0.5, 3.0, 2.5]);
    let first = WattII::ASSEMBLIES[0];
    let pose = watt2.solve(crank, first)?;
    catalogue.show(watt2, [crank], 1.0, first);
    let near = values([crank, pose.theta3, pose.theta4, pose.theta6]);
    let driven = WattIIByCouplers::from_parameters(watt2.parameters());
    catalogue.show(driven, [pose.theta5 - pose.theta3], 0.5, near);

    let stephenson1 = StephensonI::from_parameters([4.0, 1.0, 3.0, 2.5, 0.5, 1.0, 1.5, 1.0, 2.5, 2.0]);
    let first = StephensonI::ASSEMBLIES[0];
    let pose = stephenson1.solve(crank, first)?;
    catalogue.show(stephenson1, [crank], 1.0, first);
    let near = values([crank, pose.theta3, pose.theta4, pose.theta6]);
    let driven = StephensonIByDyad::from_parameters(stephenson1.parameters());
    catalogue.show(driven, [pose.theta5], 0.5, near);

    let stephenson2 = StephensonIIByElbow::from_parameters([4.0, 2.0, 1.5, 1.2, 3.0, 0.3, 1.0, 0.5, 1.6, 3.0]);
    let first = StephensonIIByElbow::ASSEMBLIES[0];
    let elbow = steady(1.2, 1.0);
    let pose = stephenson2.solve(elbow, first)?;
    catalogue.show(stephenson2, [elbow], 0.5, first);
    let [link3, link4, link5] = [elbow, pose.alpha, pose.beta].map(|relative| pose.theta2 + relative);
    let near = values([link3, link4, link5, pose.theta6]);
    let driven = StephensonII::from_parameters(stephenson2.parameters());
    catalogue.show(driven, [pose.theta2], 0.5, near);

    let stephenson3 = StephensonIII::from_parameters([4.0, 1.0, 3.0, 2.5, 1.5, 1.0, 3.0, 5.0, 3.0, 2.5]);
    let first = StephensonIII::ASSEMBLIES[0];
    let pose = stephenson3.solve(crank, first)?;
    catalogue.show(stephenson3, [crank], 1.0, first);
    let near = values([crank, pose.theta3, pose.theta4, pose.theta5]);
    let driven = StephensonIIIByDyad::from_parameters(stephenson3.parameters());
    catalogue.show(driven, [pose.theta6], 0.5, near);
    Ok(())
}

fn machines(catalogue: &mut Catalogue) {
    let root = 3_f64.sqrt();
    let platform = ClassThreeTriad {
        base_b: Plane::new(2.0 * root, 0.0),
        base_c: Plane::new(root, 3.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    };
    let legs = [steady(2.2, 0.1), steady(2.3, 0.0), steady(2.1, -0.2)];
    catalogue.show(platform, legs, 0.2, Near([0.1, 2.2, -2.0, 1.6]));
    catalogue.show(KlannLeg::PATENT, [steady(0.5, 1.0)], PI, KlannLeg::WALKING);
    catalogue.show(JansenLeg::HOLY_NUMBERS, [steady(0.5, 1.0)], PI, JansenLeg::WALKING);
    catalogue.show(
        AndrewsSqueezer::PUBLISHED,
        [steady(0.1, 1.0)],
        0.5,
        AndrewsSqueezer::PUBLISHED_ASSEMBLY,
    );
}

fn in_space(catalogue: &mut Catalogue) {
    let crank = [steady(0.8, 2.0)];
    let rssr = Rssr::from_parameters([1.0, 3.0, 0.5, 0.8, 0.2, 0.9, 0.3, 0.4, -0.3, 1.9, 3.3]);
    catalogue.show(rssr, crank, PI, Assembly::Open);
    let rssp = Rssp::from_parameters([1.0, 1.5, 0.4, 0.3, 0.3, -0.4, 1.2, 3.0]);
    catalogue.show(rssp, crank, PI, Assembly::Open);
    catalogue.show(UniversalJoint::from_parameters([0.7]), crank, PI, Assembly::Open);
    let spherical = SphericalFourBar::from_parameters([1.4, 0.5, 1.2, 0.9]);
    catalogue.show(spherical, crank, PI, Assembly::Open);
    let pose = [0.1, 0.1, 2.0, 0.2, -0.3, 0.4].map(|value| steady(value, 0.5));
    let leg = StewartGoughLeg::from_parameters([1.0, 0.2, -0.3, 0.6, -0.5, 0.2]);
    catalogue.show(leg, pose, 0.4, ());
    catalogue.show(Bennett::from_parameters([2.0, 0.6, 1.3]), crank, PI, ());
}
