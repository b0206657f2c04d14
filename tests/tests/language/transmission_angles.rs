//! Transmission angles against the law of cosines, and where they vanish.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use kin_core::TransmissionAngle;
use kin_core::prelude::*;

mechanism! {
    struct FourBar { r1: Length, r2: Length, r3: Length, r4: Length }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    with transmission_angles;
}

mechanism! {
    /// The same with everything mirrored, turned and scaled: what is measured must not change.
    struct Disguised { r1: Length, r2: Length, r3: Length, r4: Length, turn: Angle }
    input theta2: Angle;
    unknown theta3: Angle, theta4: Angle;
    -3 * r3 * cis(turn - theta3) == 3 * (r2 * cis(turn - theta2) - r1 * cis(turn)) - 3 * r4 * cis(turn - theta4);
    with transmission_angles;
}

mechanism! {
    /// A slider-crank whose slide is inclined and misses the crank's pivot, then a dyad on the slider's pin.
    struct Press { crank: Length, rod: Length, slope: Angle, offset: Length, pivot: Point, link: Length, beam: Length }
    input theta: Angle;
    unknown rod_angle: Angle, travel: Length, link_angle: Angle, beam_angle: Angle;
    let slider = (travel + vec2(0, 1) * offset) * cis(slope);
    crank * cis(theta) + rod * cis(rod_angle) == slider;
    slider + link * cis(link_angle) == pivot + beam * cis(beam_angle);
    with transmission_angles;
}

const LINKAGE: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 80.0,
    r4: 60.0,
};

/// The angle between `r3` and `r4` opposite to the diagonal from the crank's pin to the rocker's pivot.
fn law_of_cosines(linkage: &FourBar, theta2: f64) -> f64 {
    let FourBar { r1, r2, r3, r4 } = *linkage;
    let square = r1 * r1 + r2 * r2 - 2.0 * r1 * r2 * theta2.cos();
    ((r3 * r3 + r4 * r4 - square) / (2.0 * r3 * r4)).acos()
}

#[test]
fn a_four_bar_follows_the_law_of_cosines() {
    for step in 0..36 {
        let theta2 = TAU * f64::from(step) / 36.0;
        let expected = law_of_cosines(&LINKAGE, theta2);
        for assembly in Assembly::BOTH {
            let pose = LINKAGE.position(theta2, assembly).unwrap();
            let [angle] = LINKAGE.transmission_angles(&pose);
            assert_eq!(angle.block, "theta3, theta4");
            let allowed = 32.0 * f64::EPSILON / expected.sin();
            assert!(
                (angle.angle - expected).abs() <= allowed,
                "{theta2} {assembly}: {angle:?}"
            );
            assert!((angle.folded() - expected.min(PI - expected)).abs() <= allowed);
            assert!((angle.deviation() - (FRAC_PI_2 - expected).abs()).abs() <= allowed);
        }
    }
}

#[test]
fn extremes_are_where_the_crank_lies_along_the_ground() {
    // Grashof crank-rocker: least at theta2 = 0 and largest at π
    let angle = |theta2| {
        let pose = LINKAGE.position(theta2, Assembly::Open).unwrap();
        LINKAGE.transmission_angles(&pose)[0].angle
    };
    let (least, most) = (angle(0.0), angle(PI));
    for step in 1..60 {
        let between = angle(PI * f64::from(step) / 60.0);
        assert!(least < between && between < most);
    }
}

#[test]
fn the_way_it_is_written_does_not_matter() {
    let FourBar { r1, r2, r3, r4 } = LINKAGE;
    let disguised = Disguised {
        r1,
        r2,
        r3,
        r4,
        turn: 0.7,
    };
    for theta2 in [0.3, 2.0, 4.1] {
        let expected = law_of_cosines(&LINKAGE, theta2);
        for assembly in Assembly::BOTH {
            let pose = disguised.position(theta2, assembly).unwrap();
            let [angle] = disguised.transmission_angles(&pose);
            assert!(
                (angle.angle - expected).abs() <= 64.0 * f64::EPSILON / expected.sin(),
                "{theta2} {assembly}: {angle:?} {expected}"
            );
        }
    }
}

#[test]
fn a_slider_is_a_link_without_end() {
    let press = Press {
        crank: 0.3,
        rod: 1.0,
        slope: 0.4,
        offset: 0.1,
        pivot: Plane::new(0.2, -1.5),
        link: 1.6,
        beam: 1.8,
    };
    for step in 0..12 {
        let theta = TAU * f64::from(step) / 12.0;
        for assembly in Press::<f64>::ASSEMBLIES {
            let pose = press.position(theta, assembly).unwrap();
            let [slider, dyad] = press.transmission_angles(&pose.velocity(1.0));
            // measured from the slide, the rod's angle has the sine (offset - crank sin) / rod
            let sine = (press.offset - press.crank * (theta - press.slope).sin()) / press.rod;
            assert!((slider.deviation() - sine.asin().abs()).abs() <= 16.0 * f64::EPSILON);
            let [rod_angle, travel] = [pose.rod_angle.value(), pose.travel.value()];
            assert_eq!(slider.block, "rod_angle, travel");
            // from the slider to the crank's pin, and from the normal to the left of the slide
            let turn = (rod_angle + PI - (press.slope + FRAC_PI_2)).cos().acos();
            assert!((slider.angle - turn).abs() <= 32.0 * f64::EPSILON);

            let pin = Plane::new(travel, press.offset).times(Plane::new(press.slope.cos(), press.slope.sin()));
            let square = (press.pivot - pin).norm_squared();
            let cosine = (press.link.powi(2) + press.beam.powi(2) - square) / (2.0 * press.link * press.beam);
            assert_eq!(dyad.block, "link_angle, beam_angle");
            let allowed = 64.0 * f64::EPSILON / cosine.acos().sin();
            assert!((dyad.angle - cosine.acos()).abs() <= allowed, "{theta} {dyad:?}");
        }
    }
}

mechanism! {
    /// A slider on the x axis, and one on a line parallel to the y axis, each solved in two blocks.
    struct TwoSliders { crank: Length, rod: Length, height: Length, side: Length, beam: Length }
    input theta: Angle;
    unknown phi: Angle in -PI/2..=PI/2, x: Length, psi: Angle in 0..=PI, y: Length;
    crank * cis(theta) + rod * cis(-phi) == vec2(x, height);
    vec2(side, -y) == crank * cis(theta) + beam * cis(psi);
    with transmission_angles;
}

#[test]
fn sliders_on_the_axes_are_dyads_as_well() {
    let press = TwoSliders {
        crank: 0.3,
        rod: 1.0,
        height: -0.2,
        side: 0.1,
        beam: 0.8,
    };
    for step in 0..12 {
        let theta = TAU * f64::from(step) / 12.0;
        let pose = press.position(theta).unwrap();
        let [first, second] = press.transmission_angles(&pose);
        assert_eq!((first.block, second.block), ("phi, x".into(), "psi, y".into()));
        // from each slider to the pin, and from the normal to the left of its movement as x grows, as y grows
        let expected = [
            (PI - pose.phi.value() - FRAC_PI_2).cos().acos(),
            (PI + pose.psi.value()).cos().acos(),
        ];
        for (found, expected) in [first, second].iter().zip(expected) {
            let allowed = 16.0 * f64::EPSILON / expected.sin();
            assert!(
                (found.angle - expected).abs() <= allowed,
                "{theta}: {found:?} {expected}"
            );
        }
    }
}

#[test]
fn derivatives_pass_through() {
    use kin_core::series::Series;

    // dμ/dθ₂ = r1 r2 sin θ₂ / (r3 r4 sin μ), the law of cosines differentiated
    let series = |value: f64| Series::from_coefficients([value, 0.0]);
    let linkage = LINKAGE.convert(series);
    let theta2 = 1.3;
    let pose = linkage
        .position(Series::from_coefficients([theta2, 1.0]), Assembly::Open)
        .unwrap();
    let [TransmissionAngle { angle, .. }] = linkage.transmission_angles(&pose);
    let FourBar { r1, r2, r3, r4 } = LINKAGE;
    let expected = r1 * r2 * theta2.sin() / (r3 * r4 * law_of_cosines(&LINKAGE, theta2).sin());
    assert!((angle.coefficients()[1] - expected).abs() <= 64.0 * f64::EPSILON * expected);
}
