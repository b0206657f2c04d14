//! Cases of the plane, without friction and with it.

use kin_tests::reference::{Body, Connection, Cut, Shape};

use super::record::{Case, Given};

const FOUR_BAR: &str = "\
struct FourBar { ground: Length, crank: Length, coupler: Length, rocker: Length }
input theta: Angle;
unknown phi: Angle, psi: Angle;
crank * cis(theta) + coupler * cis(phi) == ground + rocker * cis(psi);
output pin: Point = crank * cis(theta);
output knee: Point = ground + rocker * cis(psi);
output pivot: Point = vec2(ground, 0);
ground 0, pivot;
body crank: 0, pin;
body coupler: pin, knee;
body rocker: pivot, knee;
";

const SLIDER_CRANK: &str = "\
struct SliderCrank { crank: Length, rod: Length }
input theta: Angle;
unknown phi: Angle, s: Length;
crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
output pin: Point = crank * cis(theta);
output slider: Point = vec2(s, 0);
ground 0;
body crank: 0, pin;
body rod: pin, slider;
body piston: slider;
slide slider along vec2(1, 0);
";

const fn body(name: &'static str, joints: (usize, Option<usize>), mass: f64, centre: [f64; 2], inertia: f64) -> Body {
    Body {
        name,
        joints,
        mass,
        centre,
        inertia,
    }
}

const BARS: [Body; 3] = [
    body("crank", (0, Some(1)), 0.8, [0.05, 0.01], 0.004),
    body("coupler", (1, Some(2)), 1.4, [0.3, 0.08], 0.09),
    body("rocker", (3, Some(2)), 1.1, [0.25, -0.03], 0.05),
];

const ENGINE: [Body; 3] = [
    body("crank", (0, Some(1)), 2.5, [0.005, 0.0], 0.003),
    body("rod", (1, Some(2)), 0.7, [0.05, 0.002], 0.0025),
    body("piston", (2, None), 0.6, [0.004, 0.001], 0.0004),
];

const fn connection(
    name: &'static str,
    joint: usize,
    pair: (usize, Option<usize>),
    coefficient: f64,
    radius: Option<f64>,
) -> Connection {
    let (on, by) = pair;
    Connection {
        name,
        joint,
        on,
        by,
        coefficient,
        radius,
    }
}

const fn of_bars(coefficient: f64) -> [Connection; 4] {
    let radius = Some(0.012);
    [
        connection("ground_crank", 0, (0, None), coefficient, radius),
        connection("pin", 1, (1, Some(0)), coefficient, radius),
        connection("knee", 2, (2, Some(1)), coefficient, radius),
        connection("pivot", 3, (2, None), coefficient, radius),
    ]
}

const fn of_engine(coefficient: f64) -> [Connection; 4] {
    let radius = Some(0.015);
    [
        connection("ground_crank", 0, (0, None), coefficient, radius),
        connection("pin", 1, (1, Some(0)), coefficient, radius),
        connection("slider", 2, (1, Some(2)), coefficient, radius),
        connection("slider_slide", 2, (2, None), coefficient, None),
    ]
}

const DRY_BARS: [Connection; 4] = of_bars(0.15);
const EASY_BARS: [Connection; 4] = of_bars(0.0);
const DRY_ENGINE: [Connection; 4] = of_engine(0.1);
const EASY_ENGINE: [Connection; 4] = of_engine(0.0);

const fn case(name: &'static str, declaration: &'static str, cut: Cut, starts: [f64; 3]) -> Case {
    Case {
        name,
        declaration,
        given: Given::Plane(cut),
        starts,
    }
}

pub(super) const CASES: [Case; 4] = [
    case("four-bar linkage", FOUR_BAR, bars(&EASY_BARS), BARS_AT),
    case("four-bar linkage with friction", FOUR_BAR, bars(&DRY_BARS), BARS_AT),
    case("slider-crank", SLIDER_CRANK, engine(&EASY_ENGINE), ENGINE_AT),
    case(
        "slider-crank with friction",
        SLIDER_CRANK,
        engine(&DRY_ENGINE),
        ENGINE_AT,
    ),
];

const BARS_AT: [f64; 3] = [0.5, 2.25, 4.75];
const ENGINE_AT: [f64; 3] = [0.25, 1.75, 5.5];

const fn bars(connections: &'static [Connection]) -> Cut {
    Cut {
        shape: Shape::FourBar,
        dimensions: &[0.9, 0.3, 0.8, 0.6],
        bodies: &BARS,
        connections,
        gravity: [0.0, -9.81],
        force: None,
        motion: [0.0, 12.0, -30.0, 200.0, 1500.0],
    }
}

const fn engine(connections: &'static [Connection]) -> Cut {
    Cut {
        shape: Shape::SliderCrank,
        dimensions: &[0.05, 0.16],
        bodies: &ENGINE,
        connections,
        gravity: [0.0, -9.81],
        force: Some((2, [-900.0, 0.0])),
        motion: [0.0, 90.0, -20.0, 500.0, -4000.0],
    }
}
