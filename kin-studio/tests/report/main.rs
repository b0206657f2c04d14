//! Reports hold the answers of kin-core, and pages are single files whose texts stay texts.

mod forces;
mod motions;

use std::f64::consts::TAU;

use kin_core::cycle::{EndKind, FullCycle as _};
use kin_core::extremes::Over;
use kin_core::library::{ClassThreeTriad, FiveBar, FourBar, Rssr};
use kin_core::prelude::*;
use kin_core::{LimitKind, mechanism, track};
use kin_studio::report::{Argument, Cause, FORMAT, Report, ReportError, Side};

const CRANK_ROCKER: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 70.0,
    r4: 60.0,
};
const DOUBLE_ROCKER: FourBar = FourBar {
    r1: 90.0,
    r2: 30.0,
    r3: 60.0,
    r4: 45.0,
};

/// A triad whose rods move a platform of a quarter of the size of its base.
fn triad() -> ClassThreeTriad {
    let root = 3_f64.sqrt();
    ClassThreeTriad {
        base_b: Plane::new(4.0 * root, 0.0),
        base_c: Plane::new(2.0 * root, 6.0),
        platform_b: Plane::new(root, 0.0),
        platform_c: Plane::new(root / 2.0, 1.5),
    }
}

fn crank_rocker() -> Report {
    let draft = kin_studio::report(&CRANK_ROCKER).speed(10.0).units("mm", "s");
    draft.report().expect("the crank turns")
}

#[test]
fn the_same_report_gives_the_same_bytes() {
    let (one, other) = (crank_rocker(), crank_rocker());
    assert_eq!(one, other);
    let page = one.html();
    assert_eq!(page, other.html());
    assert!(page.len() <= 200_000, "a four-bar's page has {} bytes", page.len());
}

#[test]
fn reports_come_back_from_json() {
    let report = crank_rocker();
    let read = Report::from_json(&report.to_json()).expect("it has just been written");
    assert_eq!(report, read);
    assert_eq!(report.html(), read.html());
}

#[test]
fn later_formats_are_refused_with_both_numbers() {
    // a later format need not be one of this version
    let text = format!(r#"{{"format":{},"something":"else"}}"#, FORMAT + 1);
    let error = Report::from_json(&text).expect_err("it is a later format");
    assert!(matches!(error, ReportError::NewerFormat { found, known } if (found, known) == (FORMAT + 1, FORMAT)));
    let message = error.to_string();
    assert!(
        message.contains(&(FORMAT + 1).to_string()) && message.contains(&FORMAT.to_string()),
        "{message}"
    );
    assert!(matches!(Report::from_json("{}"), Err(ReportError::Json(_))));
}

/// Peaks, means and sensitivities are those of a sweep over the same range.
#[test]
fn numbers_are_those_of_sweeps() {
    let report = crank_rocker();
    assert_eq!(report.range, [0.0, TAU]);
    assert!(report.unanswered.is_empty());
    let sweep = CRANK_ROCKER.sweep(Assembly::Open).over(0.0..=TAU, 91).speed(10.0);
    for (order, rate) in ["", "_velocity", "_acceleration", "_jerk", "_snap"].iter().enumerate() {
        for quantity in ["theta3", "theta4"] {
            let name = format!("{quantity}{rate}");
            // the sweeps have different rows, so that their roots are refined from different starts
            let agrees = |one: f64, other: f64, size: f64| (one - other).abs() <= 1e-11 * size;
            for (kind, expected) in [
                (Side::Highest, sweep.of(&name).highest()),
                (Side::Lowest, sweep.of(&name).lowest()),
            ] {
                let expected = expected.expect("it is bounded");
                let of = |extreme: &&kin_studio::report::Extreme| {
                    (extreme.quantity.as_str(), extreme.order, extreme.kind) == (quantity, order, kind)
                };
                let reported = report.extremes.iter().find(of).expect("it is in the list");
                let value = reported.value.expect("it is bounded");
                assert!(
                    agrees(value, expected.value, expected.value.abs()),
                    "{name}: {value} {}",
                    expected.value
                );
            }
            let mean = sweep.of(&name).rms(Over::Time).expect("it is bounded").value;
            let reported = report
                .rms
                .iter()
                .find(|rms| (rms.quantity.as_str(), rms.order) == (quantity, order));
            let value = reported.and_then(|reported| reported.value).expect("it is in the list");
            assert!(agrees(value, mean, mean), "{name}: {value} {mean}");
            let expected = sweep.of(&name).peak_sensitivities().expect("the peak is inside");
            let reported = report
                .sensitivities
                .iter()
                .find(|one| (one.quantity.as_str(), one.order) == (quantity, order));
            let reported = reported.expect("it is in the list");
            let size = expected.by.iter().map(|by| by.value.abs()).fold(0.0, f64::max);
            for (value, by) in reported.values.iter().zip(expected.by) {
                assert!((value - by.value).abs() <= 1e-8 * size, "{name}: {value} {}", by.value);
            }
        }
    }
}

/// An assembly that closes only beyond the range would show the numbers of another assembly.
#[test]
#[cfg_attr(not(feature = "gallery"), ignore = "half a minute, for the feature gallery")]
fn assemblies_of_coupled_blocks_lie_in_the_range() {
    let triad = triad();
    let [b, c] = [3.4, 3.6];
    let start = [3.4, b, c];
    let cycle = triad.cycle_along([0.0, b, c], [1.0, 0.0, 0.0]).unwrap();
    let of = |range: [f64; 2]| {
        let report = kin_studio::report(&triad)
            .at(start)
            .moving("a")
            .range(range[0]..=range[1]);
        report.report().unwrap()
    };
    let range = [3.0, 6.5];
    let report = of(range);
    let reaches = |branch: &&kin_core::cycle::Branch| {
        let [low, high] = branch.ends().map(|end| end.input);
        low < range[1] && range[0] < high
    };
    let inside = cycle.branches().iter().filter(reaches).count();
    assert!(
        report.assemblies.len() >= inside && report.assemblies.len() <= inside + 1,
        "{range:?}"
    );
    let mut found: Vec<[f64; 4]> = Vec::new();
    for (index, assembly) in report.assemblies.iter().enumerate() {
        let at = assembly.at.unwrap();
        if index == report.assembly && !(range[0]..=range[1]).contains(&at) {
            continue;
        }
        assert!((range[0]..=range[1]).contains(&at), "{range:?}: {at}");
        let Argument::Several(near) = &assembly.argument else {
            panic!("a coupled block has values nearby");
        };
        let near = ["alpha", "beta", "gamma", "phi"].map(|name| near[name]);
        let position = triad.position_near(at, b, c, near).unwrap().unknowns();
        assert!(
            position
                .iter()
                .zip(near)
                .all(|(value, near)| (value - near).abs() < 1e-6)
        );
        // brought to the same value of the variable, no two assemblies are the same
        let there = track(&triad, [at, b, c], position, [0.5 * (range[0] + range[1]), b, c]);
        if let Ok(there) = there {
            let is_new = |other: &[f64; 4]| {
                other
                    .iter()
                    .zip(there)
                    .any(|(one, known)| (one - known).sin().abs() > 1e-6)
            };
            assert!(found.iter().all(is_new), "{range:?}: {index}");
            found.push(there);
        }
    }
    // a branch beyond the range belongs to no assembly
    let reported = report.cycle.unwrap();
    let named = reported
        .branches
        .iter()
        .filter(|branch| branch.assembly.is_some())
        .count();
    assert_eq!(named, report.assemblies.len());
}

/// The limits are those of the cycle, and the scrubber goes a bit beyond them.
#[test]
fn limits_are_those_of_the_cycle() {
    let report = kin_studio::report(&DOUBLE_ROCKER).report().expect("it closes at zero");
    let cycle = DOUBLE_ROCKER.cycle().expect("the numbers are finite");
    let reported = report.cycle.as_ref().expect("there is one");
    assert!(reported.incomplete.is_empty());
    assert_eq!(reported.circuits, cycle.circuits());
    assert_eq!(reported.branches.len(), cycle.branches().len());
    for (index, (reported, branch)) in reported.branches.iter().zip(cycle.branches()).enumerate() {
        assert_eq!(
            reported.ends.each_ref().map(|end| end.input),
            branch.ends().map(|end| end.input)
        );
        assert_eq!(reported.circuit, branch.circuit());
        let Argument::One(sign) = report.assemblies[reported.assembly.unwrap()].argument else {
            panic!("a four-bar has one choice");
        };
        assert_eq!(cycle.assembly_of(index), Some(Assembly::from_sign(sign)));
        let limit = EndKind::Limit(LimitKind::TurningPoint);
        assert!(reported.ends.iter().all(|end| end.kind == limit));
    }
    let [low, high] = cycle.branches()[0].ends().map(|end| end.input);
    assert!(report.range[0] < low && report.range[1] > high);
    // there the rocker is fastest beyond all bounds, and the links do not reach further on
    let speed = report
        .extremes
        .iter()
        .find(|extreme| (extreme.quantity.as_str(), extreme.order) == ("theta4", 1));
    assert!(speed.is_some_and(|speed| speed.cause == Cause::Unbounded && speed.value.is_none()));
    let missing = report.not_closed.expect("the range goes beyond the limits");
    assert!(missing.margin.is_some_and(|margin| margin < 0.0) && !(low..=high).contains(&missing.at));
    assert_eq!(report.period, None);
}

/// Coupled blocks are followed from a position to both ends of their branch.
#[test]
#[cfg_attr(not(feature = "gallery"), ignore = "half a minute, for the feature gallery")]
fn coupled_blocks_have_nearby_values() {
    let triad = triad();
    let draft = kin_studio::report(&triad)
        .at([3.4, 3.4, 3.6])
        .assembly(Near([0.5, 2.6, -1.5, 0.2]));
    let report = draft.report().expect("it closes there");
    assert!(report.coupled);
    let shown = &report.assemblies[report.assembly];
    let (Argument::Several(near), Some(at)) = (&shown.argument, shown.at) else {
        panic!("coupled blocks have nearby values");
    };
    let near = Near(["alpha", "beta", "gamma", "phi"].map(|name| near[name]));
    let pose = triad
        .position(at, 3.4, 3.6, near)
        .expect("the values are those of a position");
    assert!((pose.phi.position() - near.0[3]).abs() <= 1e-12);
    // the leg that moves has its extremes over the whole branch
    let extreme = report
        .extremes
        .iter()
        .find(|extreme| (extreme.quantity.as_str(), extreme.order) == ("phi", 0));
    assert!(extreme.is_some());
}

#[test]
fn several_inputs_and_space() {
    let robot = FiveBar {
        ground: 2.0,
        left: 0.5,
        left_rod: 2.0,
        right_rod: 2.0,
        right: 1.5,
    };
    let report = kin_studio::report(&robot).at([0.0, 1.0]).report().expect("it closes");
    assert_eq!((report.moving, report.inputs[1].value), (0, Some(1.0)));
    assert_eq!(report.outputs[0].key, "hand_x");
    let error = kin_studio::report(&robot)
        .moving("gamma")
        .report()
        .expect_err("there is no such input");
    assert_eq!(
        error.to_string(),
        "no input is called `gamma`: there is `alpha` and `beta`"
    );
    let error = kin_studio::report(&robot).at([0.0, 1.0]).plots(["hand"]).report();
    assert!(matches!(error, Err(ReportError::NoSuchQuantity { .. })));

    let shaft = Rssr {
        crank: 1.0,
        pivot: Space::new(0.0, 3.0, 0.0),
        axis: Space::new(1.0, 0.0, 0.0),
        arm: Space::new(0.0, 0.0, 2.5),
        rod: 3.0,
    };
    assert!(kin_studio::report(&shaft).report().expect("it closes").space);
}

/// A speed of zero, at which nothing moves, and a speed that is no number are different mistakes.
#[test]
fn speeds_are_not_zero() {
    let at = |speed: f64| {
        kin_studio::report(&CRANK_ROCKER)
            .speed(speed)
            .report()
            .map(|_| ())
            .expect_err("it is refused")
    };
    for zero in [0.0, -0.0] {
        assert!(matches!(at(zero), ReportError::NoSpeed));
        assert!(format!("{:?}", at(zero)).starts_with("the speed of the moving input is zero"));
    }
    assert_eq!(at(f64::NAN).to_string(), "the speed is not finite: give a number");
}

#[test]
fn what_closes_nowhere_has_no_report() {
    let apart = FourBar {
        r1: 900.0,
        ..CRANK_ROCKER
    };
    let error = kin_studio::report(&apart).report().expect_err("the links do not reach");
    assert!(matches!(error, ReportError::ClosesNowhere { .. }), "{error}");
    assert!(error.to_string().contains("out of reach by 740"), "{error}");
    // coupled equations have no margin; the rods are too short, wherever the first one ends
    let triad = ClassThreeTriad {
        base_b: Plane::new(400.0, 0.0),
        base_c: Plane::new(200.0, 600.0),
        platform_b: Plane::new(1.0, 0.0),
        platform_c: Plane::new(0.5, 1.5),
    };
    let draft = kin_studio::report(&triad).at([3.4, 3.4, 3.6]).moving("a");
    let error = draft.report().expect_err("the rods do not reach");
    assert!(matches!(error, ReportError::NoPosition { .. }), "{error}");
    let endless = FourBar {
        r2: f64::NAN,
        ..CRANK_ROCKER
    };
    let error = kin_studio::report(&endless)
        .report()
        .expect_err("a crank is not a number");
    assert_eq!(error.to_string(), "r2 is not finite: give a number");
}

mechanism! {
    struct Hostile {
        /// </script><b>bold</b> <!-- & "quoted" 'text'
        r: Length,
    }
    input
        /// <!-- <script>
        theta: Angle;
    unknown
        /// </style></title>
        x: Length;
    x == r * cos(theta);
}

/// The text between the tags of an element, of which there is one.
fn element<'p>(page: &'p str, tag: &str) -> &'p str {
    let (_, rest) = page.split_once(tag).unwrap_or_else(|| panic!("there is no {tag}"));
    let rest = rest.split_once('>').expect("the tag ends").1;
    let name = tag.trim_start_matches('<').split(' ').next().expect("a tag has a name");
    rest.split_once(&format!("</{name}>")).expect("the element ends").0
}

/// All texts of a person stay texts: they begin and end no element.
#[test]
fn texts_stay_texts() {
    let text = "</script><b>\u{2028}\u{2029}<!-- </title> \" ' & \\ ${x}`";
    let draft = kin_studio::report(&Hostile { r: 2.0 })
        .title(text)
        .documentation(text)
        .declaration(text);
    let report = draft.units(text, text).report().expect("it closes");
    let page = report.html();
    assert_eq!(page.matches("<script").count(), 2);
    assert_eq!(page.matches("</script").count(), 2);
    assert_eq!(page.matches("</title").count(), 1);
    assert_eq!(page.matches("<!--").count(), 0);
    // comments of the solver have such texts, where no tag is read
    let (before, _) = page.split_once("<script type=\"module\"").expect("there is a script");
    assert!(!before.contains("<b>"));
    assert!(!element(&page, "<script type=\"application/json\"").contains(['\u{2028}', '\u{2029}', '<']));
    // what the page's script reads are the texts themselves
    let data = Report::from_json(element(&page, "<script type=\"application/json\"")).expect("the data are a report");
    assert_eq!((data.title.as_str(), data.units.time.as_str()), (text, text));
    assert_eq!(data.declaration.as_deref(), Some(text));
    assert!(
        data.parameters[0]
            .documentation
            .starts_with("</script><b>bold</b> <!--")
    );
    assert_eq!(data.solver, None);
}

/// The policy admits the page's script and style, by the hashes of their texts.
#[test]
fn the_policy_names_the_hashes_of_the_content() {
    let page = crank_rocker().html();
    let policy = page
        .split_once("Content-Security-Policy\" content=\"")
        .expect("there is a policy")
        .1;
    let policy = policy.split_once('"').expect("it ends").0;
    assert!(policy.starts_with("default-src 'none';"), "{policy}");
    for (tag, source) in [("<script type=\"module\"", "script-src"), ("<style", "style-src")] {
        let hash = hmac_sha256::Hash::hash(element(&page, tag).as_bytes());
        let wanted = format!("{source} 'sha256-{}'", data_encoding::BASE64.encode(&hash));
        assert!(policy.contains(&wanted), "{policy} lacks {wanted}");
    }
    for outside in ["http://", "https://", "src=", "href="] {
        let markup = page.replace("http://www.w3.org/", "");
        let head = markup
            .split("<script type=\"application/json\"")
            .next()
            .expect("there is a head");
        assert!(!head.contains(outside), "the page asks for {outside}");
    }
}
