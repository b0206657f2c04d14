//! `.kin` files.

use std::f64::consts::FRAC_PI_2;
use std::io::Write as _;
use std::process::Stdio;
use std::time::{Duration, Instant};

use insta::assert_snapshot;
use kin_core::any::AssemblyChoice;
use kin_core::library::Rssr;
use kin_core::linkage::AnyLinkage;
use kin_core::prelude::*;
use kin_core::reaction::ReactionPart;
use kin_studio::report::{Forces, Report};

use crate::serving::Server;
use crate::typed::{Folder, kin, typed_in};

const WIPER: &str = include_str!("wiper.kin");
const ROBOT: &str = include_str!("robot.kin");
const PLATFORM: &str = include_str!("platform.kin");
const PRESS: &str = include_str!("press.kin");
const PUMP: &str = include_str!("pump.kin");
const CRANK_PRESS: &str = include_str!("../../examples/crank_press.kin");
const RACK_PRESS: &str = include_str!("../../examples/rack_press.kin");
const RSSR: &str = include_str!("rssr.kin");

/// Waits until the page of a server says something.
fn wait(server: &Server, is_there: impl Fn(&str) -> bool) -> String {
    let start = Instant::now();
    loop {
        let page = server.get("/page");
        if is_there(&page) {
            return page;
        }
        assert!(start.elapsed() < Duration::from_secs(60), "the file is not looked at");
        std::thread::sleep(Duration::from_millis(20));
    }
}

fn says(printed: &str, text: &str) {
    assert!(printed.contains(text), "{printed}");
}

/// Commands take a file, which is changed and spoilt, where nothing but the program is installed.
#[test]
fn a_file_takes_every_command() {
    let folder = Folder::new("wiper");
    folder.write("wiper.kin", WIPER);
    let done = |arguments: &[&str]| {
        let output = kin(&folder).args(arguments).env("PATH", "").output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    says(
        &done(&["sweep", "wiper.kin", "--rows", "5"]),
        "180.000   8.9079  150.637  -192.187  220.656         270.000       45.0000        45.000\n",
    );
    folder.write("wiper.kin", &WIPER.replace("crank = 40mm", "crank = 4.5cm"));
    says(
        &done(&["peaks", "wiper.kin", "--of", "psi"]),
        "theta moves at 270 deg/s\n",
    );
    says(&done(&["show", "wiper.kin"]), "  crank e^(i θ) + rod e^(i φ) = ");
    says(&done(&["verify", "wiper.kin"]), "Wiper: passed, ");
    says(&done(&["code", "wiper.kin", "c"]), "wiper.c: ");

    // a block is called by its unknowns wherever one is named
    for (line, text) in [
        ("cycle --set rod=120mm", "of phi, psi"),
        ("sweep --set rod=120mm", "limit position of phi, psi"),
        ("sweep --set rod=120mm --json -", "\"phi, psi\""),
        ("report --set rod=12mm", "phi, psi"),
    ] {
        let printed = typed_in(&folder, &format!("kin {line} wiper.kin"));
        assert!(printed.contains(text) && !printed.contains('‹'), "{printed}");
    }

    // a value beside a motion would not be read
    let printed = typed_in(&folder, "kin sweep wiper.kin --set theta=10deg");
    says(
        &printed,
        "`theta` has a motion, so `--set theta=10deg` would not be read: `--over theta=10deg` lets it",
    );
    says(&printed, "-- code 2\n");

    // mistakes that the compiler finds have their positions in the file
    for (old, new, message, position) in [
        (
            "rocker * cis(psi);",
            "rocker * cis(chi);",
            "is called `chi`; did you mean `phi`?",
            "wiper.kin:6:62\n",
        ),
        (
            "rod * cis(phi) ==",
            "rod + cis(phi) ==",
            "cannot add a plane vector of lengths and a plane vector of plain numbers",
            "wiper.kin:6:26\n",
        ),
    ] {
        folder.write("wiper.kin", &WIPER.replacen(old, new, 1));
        let printed = typed_in(&folder, "kin report wiper.kin");
        says(&printed, message);
        says(&printed, position);
        says(&printed, "-- code 2\n");
    }
}

/// A file has its columns, a sequence of laws, loads and two assemblies.
#[test]
fn a_file_with_all_statements_is_run() {
    let folder = Folder::new("all");
    folder.write("robot.kin", ROBOT);
    let all = [
        "check robot.kin",
        "sweep robot.kin --rows 9",
        "sweep robot.kin --rows 3 --csv",
        "sweep robot.kin --rows 2 --columns alpha_effort_rate --json",
        "sweep robot.kin --rows 2 --assembly crossed --columns all --csv",
        "peaks robot.kin",
        "peaks robot.kin --assembly open --of alpha_effort,beta_effort_rate,hand",
        "table robot.kin",
        "table robot.kin --assembly open --order 2",
        "table robot.kin --assembly open --order 2 --over 'beta=60..75deg by cycloidal in 0.5s'",
        "report robot.kin",
        "cycle robot.kin",
    ]
    .map(|words| typed_in(&folder, &format!("kin {words}")));
    assert_snapshot!("a file with all statements", all.join("\n"));
}

/// Efforts do not depend on the unit of lengths.
#[test]
fn efforts_are_in_si() {
    let folder = Folder::new("si");
    folder.write("robot.kin", ROBOT);
    folder.write("metres.kin", &ROBOT.replacen("ground = 200mm", "ground = 0.2m", 1));
    let efforts = ["robot", "metres"].map(|name| {
        let words = format!("kin sweep {name}.kin --rows 5 --assembly open --columns alpha_effort,beta_effort");
        let printed = typed_in(&folder, &words);
        printed.lines().skip(1).map(str::to_owned).collect::<Vec<_>>()
    });
    assert!(efforts[0].len() > 6, "{efforts:?}");
    assert_eq!(efforts[0], efforts[1]);
}

/// A weight that hangs on a crank needs the torque of its weight, and that of its acceleration.
#[test]
fn an_effort_by_hand() {
    let folder = Folder::new("hand");
    folder.write(
        "crank.kin",
        "kin 1
struct Crank { arm: Length }
input theta: Angle;
unknown phi: Angle;
phi == theta;
output tip: Point = arm * cis(theta);
dimensions { arm = 500mm; }
motion { theta = 0..90deg by 3-4-5 in 1s; }
loads { gravity = (0, -10m/s2); mass tip = 2kg; inertia phi = 1.5kgm2; torque phi = -3Nm; }
columns theta, theta_effort, theta_acceleration;
",
    );
    let printed = typed_in(&folder, "kin sweep crank.kin --rows 5 --radians --csv");
    let mut count = 0;
    for line in printed.lines().filter(|line| line.ends_with(",closes,")) {
        let numbers: Vec<f64> = line.split(',').take(4).map(|number| number.parse().unwrap()).collect();
        let [_, theta, effort, acceleration] = numbers.try_into().unwrap();
        let expected = 2.0 * 10.0 * 0.5 * theta.cos() + (2.0 * 0.25 + 1.5) * acceleration + 3.0;
        assert!((effort - expected).abs() < 1e-12 * 20.0, "{effort} {expected}");
        count += 1;
    }
    assert_eq!(count, 5, "{printed}");
}

/// Bodies have masses, and joints have forces.
#[test]
fn forces_in_joints() {
    let folder = Folder::new("forces");
    folder.write("press.kin", PRESS);
    let bodies = [
        "ground 0, pivot;",
        "body crank: 0, pin;",
        "body coupler: pin, knee;",
        "body rocker: pivot, knee;",
    ];
    let guessed = without(PRESS, &bodies);
    folder.write("guessed.kin", &guessed);
    let loads = guessed.replace("mass of coupler", "//").replace("mass of rocker", "//");
    folder.write("light.kin", &loads);
    folder.write("lacking.kin", &PRESS.replacen("body rocker: pivot, knee;", "", 1));
    let all = [
        "sweep press.kin --rows 5",
        "sweep press.kin --rows 3 --columns ground_crank_force_second_rate,pivot_x --csv",
        "sweep press.kin --rows 3 --columns knee_moment",
        "peaks press.kin",
        "peaks press.kin --of pin_force,theta_effort",
        "sweep guessed.kin",
        "sweep light.kin",
        "sweep lacking.kin",
    ]
    .map(|words| typed_in(&folder, &format!("kin {words}")));
    assert_snapshot!("forces in joints", all.join("\n"));
}

/// A file in which statements are missing.
fn without(file: &str, statements: &[&str]) -> String {
    let statements = statements.iter();
    statements.fold(file.to_owned(), |text, statement| text.replacen(statement, "", 1))
}

/// Joints have friction, which efforts and forces contain, whatever the unit of lengths is.
#[test]
fn friction_in_joints() {
    let folder = Folder::new("rubbed");
    folder.write("pump.kin", PUMP);
    folder.write("metres.kin", &PUMP.replacen("crank = 50mm", "crank = 0.05m", 1));
    let rest = PUMP.replacen("360deg at 900rpm", "90deg at 900rpm, rest 0.1s", 1);
    folder.write("rest.kin", &rest);
    let begins = "loads { sense of theta = forwards; drive of theta = arm;";
    folder.write("begins.kin", &rest.replacen("loads {", begins, 1));
    let all = [
        "peaks pump.kin",
        "sweep pump.kin --rows 5",
        "sweep rest.kin --rows 3 --columns friction_heat",
        "sweep begins.kin --rows 3 --columns theta_effort",
        "forces pump.kin",
        "forces pump.kin --json",
        "forces pump.kin --csv",
    ]
    .map(|words| typed_in(&folder, &format!("kin {words}")));
    assert_snapshot!("friction in joints", all.join("\n"));
    let [one, other] = ["pump", "metres"].map(|name| typed_in(&folder, &format!("kin sweep {name}.kin --rows 5")));
    assert_eq!(
        one.lines().skip(1).collect::<Vec<_>>(),
        other.lines().skip(1).collect::<Vec<_>>()
    );
}

/// Forces are those of the file in metres, and the body that hangs on a crank pulls at it with its weight.
#[test]
fn forces_are_in_si() {
    let folder = Folder::new("newtons");
    folder.write("press.kin", PRESS);
    folder.write("metres.kin", &PRESS.replacen("ground = 200mm", "ground = 0.2m", 1));
    let forces = ["press", "metres"].map(|name| {
        let words = format!("kin sweep {name}.kin --rows 5 --columns theta_effort,knee_x,knee_force_rate,pivot_y");
        let printed = typed_in(&folder, &words);
        printed.lines().skip(1).map(str::to_owned).collect::<Vec<_>>()
    });
    assert!(forces[0].len() > 6, "{forces:?}");
    assert_eq!(forces[0], forces[1]);
}

/// What a catalogue of bearings asks for: of pins, of a guide with a moment, and of drives.
#[test]
fn forces_of_a_press() {
    let folder = Folder::new("catalogue");
    folder.write("crank_press.kin", CRANK_PRESS);
    let declaration = CRANK_PRESS.split_once("loads {").unwrap().0;
    let free = [
        "ground 0;",
        "body shaft: 0, pin;",
        "body conrod: pin, wrist;",
        "body ram: wrist;",
        "slide wrist along vec2(0, -1);",
    ];
    folder.write("bare.kin", &(without(declaration, &free) + "assembly = crossed;"));
    let law = CRANK_PRESS.replacen("0..360deg at 500rpm", "0..180deg by 4-5-6-7 in 60ms", 1);
    folder.write("law.kin", &law);
    // three guides hold a ram in more than one way, and the forces in the pins do not depend on it
    let guides = "body ram: wrist, middle, foot;\nslide middle along vec2(0, -1);\nslide foot along vec2(0, -1);\n";
    let points = "output middle: Point = vec2(0, -s - rod / 2);\noutput foot: Point = vec2(0, -s - rod);\n";
    let guided = CRANK_PRESS.replacen("body ram: wrist;", &format!("{points}{guides}"), 1);
    folder.write("wrong.kin", &guided);
    folder.write("guided.kin", &guided.replacen("force wrist", "force middle", 1));
    let all = [
        "forces crank_press.kin",
        "forces law.kin",
        "forces guided.kin --speed 250rpm --assembly all --csv",
        "forces wrong.kin",
        "forces bare.kin",
        "forces four_bar",
    ]
    .map(|words| typed_in(&folder, &format!("kin {words}")));
    assert_snapshot!("forces of a press", all.join("\n"));
    // the book shows the file and its forces
    let book = include_str!("../../../docs/forces.md");
    let (line, rest) = all[0].split_once('\n').unwrap();
    let shown = rest.strip_suffix("-- code 0\n").unwrap();
    assert!(book.contains(CRANK_PRESS), "docs/forces.md should show\n{CRANK_PRESS}");
    assert!(
        book.contains(&format!("{line}\n{shown}```")),
        "docs/forces.md should show\n{line}\n{shown}"
    );
}

/// The forces on the page of a file.
fn forces_on_page(folder: &Folder, file: &str) -> Forces {
    typed_in(folder, &format!("kin report {file} --output page.html"));
    let page = std::fs::read_to_string(folder.path().join("page.html")).unwrap();
    let (_, data) = page.split_once("<script type=\"application/json\"").unwrap();
    let data = data.split_once('>').unwrap().1.split_once("</script>").unwrap().0;
    Report::from_json(data).unwrap().forces.unwrap()
}

/// Bodies that roll on each other, in a press whose rack a toothed sector moves.
#[test]
fn gears_and_racks() {
    let folder = Folder::new("rolling");
    folder.write("rack_press.kin", RACK_PRESS);
    let (declaration, _) = RACK_PRESS.split_once("    rack teeth").unwrap();
    folder.write("bare.kin", &format!("{declaration}}}\nassembly = open;\n"));
    folder.write("slips.kin", &RACK_PRESS.replacen("radius sector", "radius 61mm", 1));
    let all = [
        "forces rack_press.kin",
        "sweep rack_press.kin --rows 3 --columns teeth_x,teeth_y,teeth_force_rate --set sector=65mm",
        "forces bare.kin",
        "forces slips.kin",
        "check slips.kin",
        "check rack_press.kin",
        "fmt --check rack_press.kin",
    ]
    .map(|words| typed_in(&folder, &format!("kin {words}")));
    assert_snapshot!("gears and racks", all.join("\n"));
    let object = typed_in(&folder, "kin check --json slips.kin");
    assert!(
        object.contains(r#""severity":"error""#) && object.contains("-- code 2"),
        "{object}"
    );
    // the book shows the file and its forces
    let book = include_str!("../../../docs/forces.md");
    let (shown, _) = all[0].split_once("-- code 0").unwrap();
    assert!(book.contains(RACK_PRESS), "docs/forces.md should show\n{RACK_PRESS}");
    assert!(book.contains(shown), "docs/forces.md should show\n{shown}");
    // the page draws the force of the teeth where they touch, and tells the efficiency
    let forces = forces_on_page(&folder, "rack_press.kin");
    let teeth = forces.joints.last().unwrap();
    assert_eq!((teeth.name.as_str(), teeth.joint), ("teeth", None));
    for sample in &forces.samples {
        let [[x, y]] = sample.contacts[..] else {
            panic!("one contact")
        };
        assert!((x - 260.0).abs() < 1e-3 && y.abs() < 1e-9, "{x} {y}");
    }
    // and the pitch curves, from the dimension that is the radius
    let [contact] = &forces.contacts[..] else {
        panic!("one contact")
    };
    let [circle] = &contact.circles[..] else {
        panic!("one gear")
    };
    assert_eq!((circle.body, circle.radius), (Some(2), 60.0));
    assert_eq!(circle.dimension.as_deref(), Some("sector"));
    assert!(matches!(circle.centre, kin_studio::report::Place::Joint(_)));
    let rack = contact.rack.unwrap();
    assert_eq!((rack.body, rack.along), (Some(3), [0.0, 1.0]));
    let powers = forces.powers.unwrap();
    let efficiency = powers.efficiency.unwrap();
    assert!((efficiency - (1.0 - powers.heat / powers.input)).abs() < 1e-12 && (0.9..0.95).contains(&efficiency));
    says(&all[0], &format!("efficiency {efficiency:.6}"));
    // teeth without friction give the ram what it takes, and push it aside by their angle
    let smooth = without(
        RACK_PRESS,
        &["friction of foot = 0.12;", "friction of pivot = 0.1, radius 15mm;"],
    );
    folder.write("smooth.kin", &smooth);
    folder.write("straight.kin", &smooth.replacen(", pressure angle 20deg", "", 1));
    let [own, straight] = ["smooth", "straight"].map(|name| {
        let words = format!("kin sweep {name}.kin --rows 3 --columns theta,teeth_force --csv");
        let printed = typed_in(&folder, &words);
        let row = printed.lines().nth(3).unwrap();
        row.split(',').nth(1).unwrap().parse::<f64>().unwrap()
    });
    assert!(
        (own * 20_f64.to_radians().cos() - straight).abs() < 1e-9 * own,
        "{own} {straight}"
    );
}

/// The linkages of space of the library have hinges by their axes, and the forces that Rust finds.
#[test]
fn hinges_in_space() {
    let folder = Folder::new("hinges");
    folder.write("rssr.kin", RSSR);
    let printed =
        ["forces rssr.kin", "sweep rssr.kin --rows 3"].map(|words| typed_in(&folder, &format!("kin {words}")));
    assert_snapshot!("hinges in space", printed.join("\n"));
    let page = forces_on_page(&folder, "rssr.kin");
    assert!(page.joints.is_empty() && page.unknown.is_none());
    let rssr = Rssr {
        crank: 0.04,
        pivot: Space::new(0.12, 0.02, 0.03),
        axis: Space::new(0.008, 0.09, 0.012),
        arm: Space::new(0.016, -0.012, 0.076),
        rod: 0.13,
    };
    let linkage = AnyLinkage::of(&rssr);
    let loads = linkage.loads().torque(-2.0, "phi").unwrap();
    let reactions = linkage
        .reactions(&loads)
        .unwrap()
        .hinge("ground_crank", Space::new(0.0, 0.0, 1.0))
        .unwrap();
    let reactions = reactions.hinge("ground_arm", "axis").unwrap();
    let sweep = linkage
        .sweep(AssemblyChoice::Index(0))
        .between(&[0.0], &[FRAC_PI_2], 91)
        .speed(rpm(500.0));
    let csv = typed_in(&folder, "kin forces rssr.kin --csv");
    for (name, part, column) in [
        ("ground_crank", ReactionPart::Moment, "ground_crank_moment"),
        ("ground_arm", ReactionPart::Moment, "ground_arm_moment"),
        ("ball", ReactionPart::Force, "ball_force"),
    ] {
        let expected = sweep.of_reaction(&reactions, name, part, 0).peak().unwrap().value;
        let row = csv.lines().find(|line| line.starts_with(column)).unwrap();
        let peak: f64 = row.split(',').nth(4).unwrap().parse().unwrap();
        assert!((peak - expected).abs() < 1e-9 * expected, "{row} {expected}");
        let curve = page.curves.iter().find(|own| own.name == column).unwrap();
        let on_page = curve.peak.unwrap().value.unwrap();
        assert!((on_page - expected).abs() < 1e-9 * expected, "{on_page} {expected}");
    }
}

/// Limits are proved over all inputs and tolerances, or refuted at a place; mistakes in them are told.
#[test]
fn limits_of_forces() {
    let folder = Folder::new("limits");
    folder.write("crank_press.kin", CRANK_PRESS);
    let metres = CRANK_PRESS.replacen("crank = 20mm", "crank = 0.02m", 1);
    folder.write("metres.kin", &metres);
    folder.write("short.kin", &CRANK_PRESS.replacen("rod = 160mm", "rod = 19mm", 1));
    let rubbed = "loads {\n    friction of pin = 0.1, radius 10mm;";
    folder.write("rubbed.kin", &CRANK_PRESS.replacen("loads {", rubbed, 1));
    let proof = "--prove 'pin_force <= 6kN' --prove 'theta_effort <= 55Nm' --tolerance crank=0.1mm";
    let all = [
        format!("crank_press.kin {proof}"),
        format!("metres.kin {proof}"),
        "crank_press.kin --assembly all --prove 'wrist_slide_moment <= 50Nm' --tolerance rod=0.2mm".to_owned(),
        "short.kin --over 90..0deg --prove 'pin_force <= 1e90kN'".to_owned(),
        "crank_press.kin --prove 'pin <= 6kN'".to_owned(),
        "crank_press.kin --prove 'pin_force <= 6'".to_owned(),
        "crank_press.kin --prove pin_force".to_owned(),
        "crank_press.kin --prove 'pin_force <= 6kN' --tolerance crnk=1mm".to_owned(),
        "crank_press.kin --prove 'pin_force <= 6kN' --tolerance crank".to_owned(),
        "crank_press.kin --prove 'pin_force <= 6kN' --over '0..90deg by cycloidal in 1s'".to_owned(),
        "rubbed.kin --prove 'pin_force <= 6kN'".to_owned(),
    ]
    .map(|words| typed_in(&folder, &format!("kin forces {words}")));
    assert_snapshot!("limits of forces", all.join("\n"));
    let (line, rest) = all[0].split_once('\n').unwrap();
    let (shown, _) = rest.split_once("-- ").unwrap();
    let book = include_str!("../../../docs/forces.md");
    assert!(
        book.contains(&format!("{line}\n{shown}```")),
        "docs/forces.md should show\n{line}\n{shown}"
    );
}

/// The power of a drive is its effort times its speed, and inertia forces grow with the square of the speed.
#[test]
fn forces_follow_the_speed() {
    let folder = Folder::new("speeds");
    let light = CRANK_PRESS.replacen("gravity = (0, -9.81m/s2);", "", 1);
    folder.write("light.kin", &light.replacen("force wrist = (0, 800N);", "", 1));
    let peaks = ["200rpm", "600rpm"].map(|speed| {
        let printed = typed_in(&folder, &format!("kin forces light.kin --speed {speed} --csv"));
        let cells = |name: &str| -> f64 {
            let line = printed.lines().find(|line| line.starts_with(name)).unwrap();
            line.split(',').nth(4).unwrap().parse().unwrap()
        };
        ["pin_force", "wrist_slide_moment", "theta_effort", "theta_power"].map(cells)
    });
    let speed = std::f64::consts::TAU * 200.0 / 60.0;
    assert!(
        (peaks[0][3] / peaks[0][2].abs() / speed).abs() - 1.0 < 1e-9,
        "{peaks:?}"
    );
    for (part, factor) in [9.0, 9.0, 9.0, 27.0].into_iter().enumerate() {
        let ratio = (peaks[1][part] / peaks[0][part]).abs();
        assert!((ratio / factor - 1.0).abs() < 1e-9, "{peaks:?}");
    }
}

/// An editor checks what it has not saved, and makes an outline of it.
#[test]
fn an_outline_of_the_input() {
    let folder = Folder::new("outline");
    let mut child = kin(&folder)
        .args(["check", "-", "--json"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let text = WIPER.replacen("crank = 40mm", "crank = -40mm", 1);
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert!(output.status.success());
    assert_snapshot!("an outline for an editor", String::from_utf8(output.stdout).unwrap());
}

/// Six legs that are declared as one, on a body that is a frame.
#[test]
fn a_platform_is_run() {
    let folder = Folder::new("platform");
    folder.write("platform.kin", PLATFORM);
    let printed = typed_in(&folder, "kin sweep platform.kin --rows 2 --columns x,y,pitch");
    says(&printed, "170.000  -9.75846  6.71925  -0.99571");
    says(&typed_in(&folder, "kin verify platform.kin"), "Platform: passed, ");
    // one leg is wrong, and the list says which
    folder.write("platform.kin", &PLATFORM.replace("a5, b5, l5", "a5, l5, b5"));
    let printed = typed_in(&folder, "kin check platform.kin");
    says(
        &printed,
        "but this is a scalar: write `vec3(x, y, z)`\n  --> platform.kin:15:36\n",
    );
    assert_eq!(printed.matches("-->").count(), 1, "{printed}");
}

#[test]
fn a_file_is_formatted() {
    let folder = Folder::new("formatted");
    let path = folder.write("wiper.kin", &WIPER.replace(' ', "  ").replacen("kin  1", "kin 1", 1));
    let read = || std::fs::read_to_string(&path).unwrap();
    let printed = typed_in(&folder, "kin fmt --check wiper.kin");
    says(&printed, "wiper.kin is in another form");
    says(&printed, "-- code 1\n");
    assert_ne!(read(), WIPER);
    assert_eq!(
        typed_in(&folder, "kin fmt wiper.kin"),
        "$ kin fmt wiper.kin\n-- code 0\n"
    );
    // but for the words of comments
    assert_eq!(read().replace("  ", " "), WIPER);
    says(&typed_in(&folder, "kin fmt --check wiper.kin"), "-- code 0\n");

    // what has mistakes in its form is left alone
    let spoilt = WIPER.replacen("psi: Angle;", "psi:  Angle", 1);
    folder.write("wiper.kin", &spoilt);
    let printed = typed_in(&folder, "kin fmt wiper.kin");
    says(&printed, "a statement ends with `;`\n --> wiper.kin:5:");
    says(&printed, "-- code 2\n");
    assert_eq!(read(), spoilt);
}

/// The page comes back when the file is mended.
#[test]
fn a_file_is_watched() {
    let folder = Folder::new("watched");
    folder.write("wiper.kin", &WIPER.replacen("cis(psi);", "cis(chi);", 1));
    let server = Server::start(&folder, &["serve", "wiper.kin"]);
    says(&server.get("/"), "<iframe");
    says(&server.get("/page"), "A mistake");
    let version = server.get("/version");
    folder.write("wiper.kin", WIPER);
    let page = wait(&server, |page| !page.contains("A mistake"));
    says(&page, "Wiper");
    assert_ne!(server.get("/version"), version);
}

/// The first look at the file lasts until the pipe is closed, and by then another file has its name.
#[cfg(unix)]
#[test]
fn a_change_during_the_first_look_is_seen() {
    let folder = Folder::new("changed");
    let path = folder.path().join("wiper.kin");
    let made = std::process::Command::new("mkfifo").arg(&path).status().unwrap();
    assert!(made.success());
    let other = folder.write("other.kin", &WIPER.replacen("kin 1", "kin 2", 1));
    let writer = std::thread::spawn(move || {
        let mut pipe = std::fs::OpenOptions::new().write(true).open(&path).unwrap();
        std::fs::rename(other, &path).unwrap();
        std::io::Write::write_all(&mut pipe, WIPER.replacen("motion {", "movement {", 1).as_bytes()).unwrap();
    });
    let server = Server::start(&folder, &["serve", "wiper.kin"]);
    writer.join().unwrap();
    wait(&server, |page| page.contains("kin 2"));
}

/// Joints of space have forces and moments, and bodies of space tensors of inertia.
#[test]
fn forces_in_space() {
    const SHAFTS: &str = "kin 1
/// Two skew shafts, and a rod between two ball joints.
struct Shafts { crank: Length, pivot: Point3, axis: Vector3, arm: Vector3, rod: Length }
input theta: Angle;
unknown phi: Angle;
let rocker = pivot + rot(axis, phi) * arm;
let knob = rot_z(theta) * vec3(crank, 0, 0);
dot(rocker - knob, rocker - knob) == rod.powi(2);
output pin: Point3 = knob;
output ball: Point3 = rocker;
let up = vec3(0, 0, crank);
let along = pivot + axis;
ground 0, up, pivot, along;
body crank: 0, pin, up;
body rod: pin, ball;
body rocker: pivot, ball, along;
dimensions {
    crank = 40mm; pivot = (120mm, 20mm, 30mm); axis = (8mm, 90mm, 12mm); arm = (16mm, -12mm, 76mm); rod = 130mm;
}
motion { theta = 0..90deg at 500rpm; }
loads {
    gravity = (0, 0, -9.81m/s2);
    mass of rod = 0.2kg at (65mm, 0), inertia 300kgmm2;
    mass of rocker = 0.4kg at (38mm, 0, 10mm), inertia (400kgmm2, 500kgmm2, 300kgmm2);
    torque phi = -2Nm;
}
assembly = open;
";
    let folder = Folder::new("space");
    folder.write("shafts.kin", SHAFTS);
    folder.write(
        "ball.kin",
        &SHAFTS.replace("body crank: 0, pin, up;", "body crank: 0, pin;"),
    );
    folder.write("tensor.kin", &SHAFTS.replace(", 300kgmm2);", ");"));
    let all = [
        "forces shafts.kin",
        "sweep shafts.kin --rows 3 --columns ball_z,ground_crank_moment,ground_crank_moment_x",
        "forces ball.kin",
        "forces tensor.kin",
    ]
    .map(|words| typed_in(&folder, &format!("kin {words}")));
    assert_snapshot!("forces in space", all.join("\n"));
}
