//! The mechanisms of the library, each with dimensions, inputs and an assembly for which it closes.

use std::f64::consts::PI;

use kin_core::library::{
    AndrewsSqueezer, Bennett, ChebyshevLinkage, ClassThreeTriad, FiveBar, FourBar, FreudensteinFourBar, GearedFiveBar,
    GeometricFourBar, HoekenLinkage, InvertedSliderCrank, JansenLeg, KlannLeg, OffsetSliderCrank, Pantograph,
    PeaucellierLinkage, RobertsLinkage, Rssp, Rssr, ScotchYoke, SliderCrank, SliderCrankFirstApproximation,
    SliderCrankHigherApproximation, SphericalFourBar, StephensonI, StephensonIByDyad, StephensonII,
    StephensonIIByElbow, StephensonIII, StephensonIIIByDyad, StewartGoughLeg, UniversalJoint, WattI, WattIByDyad,
    WattII, WattIIByCouplers, WhitworthQuickReturn,
};
use kin_core::prelude::*;

/// Something that is to be done with every mechanism of the library.
pub trait Visitor {
    /// Does it with one of them. The mechanism closes at the inputs, in the assembly.
    fn visit<M: Mechanism<Scalar = f64> + 'static>(
        &mut self,
        mechanism: &M,
        inputs: M::Inputs<f64>,
        assembly: M::Assembly,
    );
}

/// Leads a visitor through all mechanisms, in the order of the book's table.
///
/// # Errors
/// Where one of them does not close.
pub fn visit(visitor: &mut impl Visitor) -> Result<(), SolveError> {
    let at = f64::to_radians;
    let (open, crossed) = (Assembly::Open, Assembly::Crossed);
    let v = Plane::new;
    let (r1, r2, r3, r4) = (90.0, 30.0, 80.0, 60.0);
    let stephenson = StephensonI {
        r1: 4.0,
        r2: 1.4,
        r3: 3.6,
        r4: 2.6,
        p: v(1.4, 1.5),
        q: v(2.2, -1.6),
        r5: 4.0,
        r6: 2.8,
    };
    let stephenson_iii = StephensonIII {
        r1: 4.0,
        r2: 1.2,
        r3: 3.4,
        r4: 2.6,
        p: v(2.2, 1.5),
        r5: 3.8,
        pivot: v(7.0, 0.5),
        r6: 2.4,
    };
    let watt = WattI {
        r1: 4.0,
        r2: 1.4,
        r3: 3.0,
        r4: 2.5,
        p: v(1.0, 1.2),
        q: v(2.0, 1.5),
        r5: 2.5,
        r6: 2.0,
    };
    let watt_ii = WattII {
        r1: 4.0,
        r2: 1.2,
        r3: 3.0,
        r4: 2.5,
        arm: v(2.0, -1.2),
        pivot: v(8.0, 0.0),
        r5: 3.2,
        r6: 2.2,
    };
    let root = 3.0_f64.sqrt();
    let triad = ClassThreeTriad {
        base_b: v(4.0 * root, 0.0),
        base_c: v(2.0 * root, 6.0),
        platform_b: v(root, 0.0),
        platform_c: v(root / 2.0, 1.5),
    };
    visitor.visit(&FourBar { r1, r2, r3, r4 }, [at(70.0)], open);
    visitor.visit(
        &GeometricFourBar { r1, r2, r3, r4 },
        [at(70.0)],
        GeometricFourBar { r1, r2, r3, r4 }.assembly(at(70.0), open),
    );
    visitor.visit(
        &FreudensteinFourBar { r1, r2, r3, r4 },
        [at(70.0)],
        FreudensteinFourBar::OPEN,
    );
    visitor.visit(&SliderCrank { r: 1.0, l: 3.0 }, [at(60.0)], open);
    visitor.visit(
        &OffsetSliderCrank {
            r: 1.0,
            l: 3.0,
            h: -0.6,
        },
        [at(60.0)],
        open,
    );
    visitor.visit(&InvertedSliderCrank { r1: 2.0, r2: 1.0 }, [at(60.0)], ());
    visitor.visit(&SliderCrankFirstApproximation { r: 1.0, l: 3.0 }, [at(60.0)], ());
    visitor.visit(&SliderCrankHigherApproximation { r: 1.0, l: 3.0 }, [at(60.0)], ());
    visitor.visit(
        &WhitworthQuickReturn {
            ground: 0.05,
            crank: 0.12,
            arm: 0.1,
            rod: 0.28,
        },
        [at(40.0)],
        open,
    );
    visitor.visit(
        &ScotchYoke {
            crank: 1.0,
            gamma: at(90.0),
        },
        [at(50.0)],
        (),
    );
    visitor.visit(&ChebyshevLinkage::PUBLISHED, [at(60.0)], crossed);
    visitor.visit(&HoekenLinkage::PUBLISHED, [at(70.0)], open);
    visitor.visit(&RobertsLinkage { base: 2.0, arm: 2.4 }, [at(60.0)], open);
    visitor.visit(
        &PeaucellierLinkage {
            ground: 1.0,
            crank: 1.0,
            arm: 3.5,
            side: 1.8,
        },
        [at(25.0)],
        PeaucellierLinkage::STRAIGHT,
    );
    visitor.visit(
        &Pantograph {
            upper: 3.0,
            lower: 3.0,
            factor: 2.0,
        },
        [3.0, -1.5],
        Pantograph::SIMILAR,
    );
    visitor.visit(
        &FiveBar {
            ground: 2.0,
            left: 2.0,
            left_rod: 3.0,
            right_rod: 3.0,
            right: 2.0,
        },
        [at(120.0), at(50.0)],
        open,
    );
    visitor.visit(
        &GearedFiveBar {
            r1: 4.0,
            r2: 1.2,
            r3: 3.4,
            r4: 3.4,
            r5: 1.2,
            ratio: -1.0,
            phase: PI,
        },
        [at(110.0)],
        open,
    );
    visitor.visit(&watt, [at(50.0)], WattI::ASSEMBLIES[0]);
    visitor.visit(&watt_ii, [at(60.0)], WattII::ASSEMBLIES[0]);
    visitor.visit(&stephenson, [at(70.0)], StephensonI::ASSEMBLIES[0]);
    by_elbow(visitor)?;
    visitor.visit(&stephenson_iii, [at(70.0)], StephensonIII::ASSEMBLIES[0]);
    visitor.visit(&KlannLeg::PATENT, [at(190.0)], KlannLeg::WALKING);
    visitor.visit(&JansenLeg::HOLY_NUMBERS, [at(60.0)], JansenLeg::WALKING);
    visitor.visit(&AndrewsSqueezer::PUBLISHED, [0.7], AndrewsSqueezer::PUBLISHED_ASSEMBLY);
    driven_at_dyads(visitor, &watt, &watt_ii, &stephenson, &stephenson_iii)?;
    visitor.visit(&triad, [3.4, 3.4, 3.6], Near([0.5, 2.6, -1.5, 0.2]));
    visitor.visit(
        &Rssr {
            crank: 1.0,
            pivot: Space::new(0.0, 3.0, 0.0),
            axis: Space::new(1.0, 0.0, 0.0),
            arm: Space::new(0.0, 0.0, 2.5),
            rod: 3.0,
        },
        [at(50.0)],
        open,
    );
    visitor.visit(
        &Rssp {
            crank: 1.0,
            start: Space::new(0.0, 3.0, 1.0),
            rail: Space::new(0.0, 1.0, 0.0),
            rod: 3.5,
        },
        [at(50.0)],
        open,
    );
    visitor.visit(&UniversalJoint { beta: at(35.0) }, [at(30.0)], open);
    visitor.visit(
        &SphericalFourBar {
            ground: at(70.0),
            crank: at(30.0),
            coupler: at(60.0),
            rocker: at(55.0),
        },
        [at(60.0)],
        open,
    );
    visitor.visit(
        &StewartGoughLeg {
            base: Space::new(2.0, 0.0, 0.0),
            joint: Space::new(1.0, 0.5, 0.0),
        },
        [0.3, 0.2, 3.0, 0.2, 0.1, 0.3],
        (),
    );
    visitor.visit(
        &Bennett {
            a: 2.0,
            alpha: at(30.0),
            beta: at(70.0),
        },
        [1.2],
        (),
    );
    Ok(())
}

/// Stephenson's six-bar linkage of the second kind.
const STEPHENSON_II: StephensonII = StephensonII {
    r1: 4.0,
    r2: 1.2,
    r3: 1.8,
    r4: 2.2,
    p: Plane::new(1.0, 0.8),
    q: Plane::new(1.4, -1.0),
    r5: 2.6,
    r6: 2.4,
};

/// The same linkage driven at its elbow, in a position of the crank.
fn by_elbow(visitor: &mut impl Visitor) -> Result<(), SolveError> {
    let crank = 50_f64.to_radians();
    let [theta3, theta4, theta5, theta6] = STEPHENSON_II.position_near(crank, NEAR)?.unknowns();
    let linkage: StephensonIIByElbow = StephensonIIByElbow::from_parameters(STEPHENSON_II.parameters());
    // in the frame of the crank
    let near = [theta4 - crank, theta5 - crank, crank, theta6];
    let elbow = theta3 - crank;
    visitor.visit(&linkage, [elbow], linkage.assembly_at(elbow, near));
    Ok(())
}

/// A position of Stephenson's second kind.
const NEAR: [f64; 4] = [0.2, 0.6, 0.3, 1.6];

/// The six-bar linkages that are driven where no dyad closes: in positions of the same linkages, driven at the crank.
fn driven_at_dyads(
    visitor: &mut impl Visitor,
    watt: &WattI,
    watt_ii: &WattII,
    stephenson: &StephensonI,
    third: &StephensonIII,
) -> Result<(), SolveError> {
    let crank = 50_f64.to_radians();
    let [theta3, theta4, theta5, theta6] = watt.position(crank, WattI::ASSEMBLIES[0])?.unknowns();
    let linkage: WattIByDyad = WattIByDyad::from_parameters(watt.parameters());
    visitor.visit(&linkage, [theta5], Near([crank, theta3, theta4, theta6]));

    let [theta3, theta4, theta5, theta6] = watt_ii.position(crank, WattII::ASSEMBLIES[0])?.unknowns();
    let linkage: WattIIByCouplers = WattIIByCouplers::from_parameters(watt_ii.parameters());
    visitor.visit(&linkage, [theta5 - theta3], Near([crank, theta3, theta4, theta6]));

    let [theta3, theta4, theta5, theta6] = stephenson.position(crank, StephensonI::ASSEMBLIES[0])?.unknowns();
    let linkage: StephensonIByDyad = StephensonIByDyad::from_parameters(stephenson.parameters());
    visitor.visit(&linkage, [theta5], Near([crank, theta3, theta4, theta6]));

    visitor.visit(&STEPHENSON_II, [crank], Near(NEAR));

    let [theta3, theta4, theta5, theta6] = third.position(crank, StephensonIII::ASSEMBLIES[0])?.unknowns();
    let linkage: StephensonIIIByDyad = StephensonIIIByDyad::from_parameters(third.parameters());
    visitor.visit(&linkage, [theta6], Near([crank, theta3, theta4, theta5]));
    Ok(())
}
