//! Mistakes in arguments and files, with the messages of the program.

use insta::assert_snapshot;

use crate::typed::{Folder, typed, typed_in};

#[test]
fn messages_say_what_to_do() {
    let lines = [
        "kin",
        "kin swep four_bar",
        "kin sweep",
        "kin sweep for_bar",
        "kin sweep thing",
        "kin sweep four_bar --set r7=3",
        "kin sweep four_bar --set r2",
        "kin sweep four_bar --set r2=30deg",
        "kin sweep four_bar --set r2=30,r3=80",
        "kin sweep watt_i --set 'p=(1, 2),r2=4'",
        "kin sweep four_bar --set r2=45,5",
        "kin sweep four_bar r2=45",
        "kin sweep four_bar --set r2=-30 --rows 1 --columns theta4",
        "kin sweep four_bar --set r2=0 --rows 1 --columns theta4",
        "kin sweep four_bar --over theta2",
        "kin sweep five_bar --over beta",
        "kin sweep four_bar --over 0-360",
        "kin sweep four_bar --over 0:360:10",
        "kin sweep four_bar --over '0..360deg 45rpm'",
        "kin sweep four_bar --columns theta4_acc",
        "kin sweep four_bar --step 10",
        "kin sweep four_bar --set theta2=30",
        "kin sweep watt_i --set p=3",
        "kin sweep watt_i --set 'p=(1, 2, 3, 4)'",
        "kin sweep four_bar --over 0..90",
        "kin sweep four_bar --over 90deg..90deg",
        "kin sweep four_bar --over theta3=0..90deg",
        "kin sweep four_bar --speed 10",
        "kin sweep four_bar --law cyclodial --time 1s",
        "kin sweep four_bar --law cycloidal",
        "kin sweep four_bar --over '0..90deg by cycloidal in 0.4s' --speed 60rpm",
        "kin sweep four_bar --over '0..90deg by cycloidal in 0.4s' --time 1s",
        "kin sweep five_bar --over 'alpha=100..120deg at 60rpm, rest 1' --over 'beta=50..60deg, rest 1s'",
        "kin sweep four_bar --assembly open,crossed",
        "kin table four_bar --assembly all",
        "kin sweep four_bar --assembly opn",
        "kin sweep watt_i --assembly opn",
        "kin sweep scotch_yoke --assembly open",
        "kin sweep stephenson_ii --assembly open",
        "kin sweep stephenson_ii --assembly theta3=10deg",
        "kin sweep four_bar --columns theta4_jek",
        "kin sweep four_bar --rows 0",
        "kin sweep four_bar --units parsec",
        "kin sweep five_bar --over 0..90deg",
        "kin sweep stewart_gough_leg",
        "kin cycle four_bar --set r1=900",
        "kin peaks four_bar --of theta5",
        "kin peaks four_bar --set r1=900",
        "kin report four_bar --set r1=900",
        "kin report four_bar -o no/such/folder/page.html",
        "kin report four_bar -o page.pdf",
        "kin code four_bar fortran",
        "kin code c four_bar",
        "kin wiper.kin",
        "kin report wiper.kin",
        "kin fit four_bar --data none.csv",
        "kin completions tcsh",
        "kin report none.kin",
    ];
    let all: Vec<String> = lines.iter().map(|line| short(&typed("mistakes", line))).collect();
    assert_snapshot!("mistakes", all.join("\n"));
}

/// Help that is printed instead of a message is not repeated here.
fn short(text: &str) -> String {
    match text.split_once("\nUsage:") {
        Some((before, rest)) if rest.contains("Commands:") => {
            format!("{before}\n[help]\n{}", text.lines().last().unwrap_or(""))
        }
        _ => text.to_owned(),
    }
}

#[test]
fn files_of_numbers_are_checked() {
    let folder = Folder::new("numbers");
    folder.write("no_unit.csv", "theta2,theta4\n0,1\n");
    folder.write("name.csv", "theta2 [deg],theta5 [deg]\n0,1\n");
    folder.write("word.csv", "theta2 [deg],theta4 [deg]\n0,much\n");
    folder.write("empty.csv", "theta2 [deg],theta4 [deg]\n");
    folder.write("inputs.csv", "theta2 [deg]\n1\n");
    let all = ["no_unit", "name", "word", "empty", "inputs"]
        .map(|name| typed_in(&folder, &format!("kin fit four_bar --data {name}.csv")));
    assert_snapshot!("mistakes in files of numbers", all.join("\n"));
}

#[test]
fn mistakes_in_kin_files() {
    let folder = Folder::new("kin-files");
    let right = include_str!("wiper.kin");
    let all = [
        ("kin 1", "kin 2"),
        ("crank = 40mm", "crnk = 40mm"),
        ("crank = 40mm", "crank = 40deg"),
        ("blade = 450mm;", ""),
        ("0deg..360deg at 45rpm", "0..360 at 45rpm"),
        (
            "/// A windscreen",
            "#[doc = include_str!(\"/etc/passwd\")]\n/// A windscreen",
        ),
        ("rod * cis(phi)", "rod * cis(phi"),
        ("motion {", "movement {"),
        ("input theta: Angle;", "input theta;"),
        ("at 45rpm", "45rpm"),
        ("/// A windscreen", "# it's a comment\n/// A windscreen"),
        ("crank = 40mm", "crank = 40,5mm"),
        ("motion {", "blade = 450mm; rod = 10mm;\nmotion {"),
    ]
    .map(|(old, new)| {
        folder.write("wiper.kin", &right.replacen(old, new, 1));
        typed_in(&folder, "kin report wiper.kin")
    });
    assert_snapshot!("mistakes in kin files", all.join("\n"));
    // a declaration is compiled without being built
    folder.write("wiper.kin", right);
    let sound = typed_in(&folder, "kin check wiper.kin");
    assert!(
        sound.contains("\nwiper.kin: Wiper has no mistakes\n-- code 0"),
        "{sound}"
    );
    let (wrong, other) = (
        ("rod * cis(phi)", "rood * cis(fi)"),
        ("input theta: Angle", "input theta: Angel"),
    );
    folder.write(
        "wiper.kin",
        &right.replacen(wrong.0, wrong.1, 1).replacen(other.0, other.1, 1),
    );
    let printed = ["check wiper.kin", "report wiper.kin"].map(|words| typed_in(&folder, &format!("kin {words}")));
    assert_snapshot!("mistakes in the declaration of a kin file", printed.join("\n"));
    // without any of these mistakes, the first is reported
    folder.write("wiper.kin", &right.replace(';', ""));
    let printed = typed_in(&folder, "kin report wiper.kin");
    assert!(
        printed.contains("a statement ends with `;`") && printed.contains("wiper.kin:4:14\n"),
        "{printed}"
    );
    // a line that is longer than formats are wide
    folder.write("wiper.kin", &format!("kin 1\n//{}", "a".repeat(70_000)));
    let printed = typed_in(&folder, "kin report wiper.kin");
    assert!(
        printed.contains("more than 32768 bytes") && printed.ends_with("code 2\n"),
        "{printed}"
    );
}

/// The masses of bodies have a form of their own.
#[test]
fn mistakes_in_masses_of_bodies() {
    let folder = Folder::new("bodies");
    let right = include_str!("press.kin");
    let all = [
        ("mass of coupler", "mass of couple"),
        ("mass of coupler", "mass of"),
        ("mass of coupler", "mass coupler"),
        ("mass of coupler", "mass of the coupler"),
        ("1.4kg at (90mm, 0)", "1.4kg"),
        ("1.4kg at (90mm, 0)", "1.4kg at knie"),
        ("1.4kg at (90mm, 0)", "1.4kg at (90kg, 0)"),
        ("1.4kg at (90mm, 0)", "-1.4kg at (90mm, 0)"),
        ("1.4kg at (90mm, 0)", "at (90mm, 0)"),
        (", inertia 0.016kg*m2", ", 0.016kg*m2"),
        (", inertia 0.016kg*m2", ", inertia 0.016kg"),
        (", inertia 0.016kg*m2", ", inertia 0.016kg*m2, 3"),
        ("knee_force,", "knee_forc,"),
    ]
    .map(|(old, new)| {
        assert!(right.contains(old), "{old}");
        folder.write("press.kin", &right.replacen(old, new, 1));
        typed_in(&folder, "kin check press.kin")
    });
    assert_snapshot!("mistakes in masses of bodies", all.join("\n"));
}

/// Friction is that of a joint, and a joint is a pin or a slide.
#[test]
fn mistakes_in_friction() {
    let folder = Folder::new("friction");
    let right = include_str!("pump.kin");
    let pin = "friction of pin = 0.1, radius 20mm";
    let all = [
        (pin, "friction of pn = 0.1, radius 20mm"),
        (pin, "drive of thta = arm"),
        (pin, "drive theta = arm"),
        (pin, "drive of theta = am"),
        (pin, "sense of theta = upwards"),
        (pin, "friction of = 0.1, radius 20mm"),
        (pin, "friction pin = 0.1, radius 20mm"),
        (pin, "friction of ground_arm = 0.1, radius 20mm"),
        (pin, "friction of piston = 0.1"),
        (pin, "friction of pin = 0.1, length 20mm"),
        (pin, "friction of pin = -0.1, radius 20mm"),
        (pin, "friction of pin = 0.1N, radius 20mm"),
        (pin, "friction of pin = 0.1, radius 0"),
        (pin, "friction of pin = 0.1, radius 20deg"),
        (pin, "friction of pin = 0.1, radius 20mm, 3"),
        (", length 60mm", ", radius 60mm"),
        (", length 60mm", ", length -60mm"),
        ("body arm: 0, pin;\nbody conrod: pin, piston;\nbody block: piston;", ""),
        ("friction_heat;", "friction_haet;"),
    ]
    .map(|(old, new)| {
        assert!(right.contains(old), "{old}");
        folder.write("pump.kin", &right.replacen(old, new, 1));
        typed_in(&folder, "kin check pump.kin")
    });
    assert_snapshot!("mistakes in friction", all.join("\n"));
}

/// Gears and racks are two bodies with their pitch curves.
#[test]
fn mistakes_in_gears_and_racks() {
    let folder = Folder::new("meshing");
    let right = include_str!("../../examples/rack_press.kin");
    let (_, bodies) = right.split_once("ground 0, pivot;").unwrap();
    let (bodies, _) = bodies.split_once("dimensions").unwrap();
    let bodies = &format!("ground 0, pivot;{bodies}");
    let rack = "rack teeth = lever at pivot radius sector, ram along (0, 1), pressure angle 20deg";
    let all = [
        ("rack teeth =", "rack ="),
        ("rack teeth =", "rack of teeth ="),
        ("rack teeth =", "rak teeth ="),
        ("rack teeth =", "gears teeth ="),
        ("rack teeth =", "rack pin ="),
        ("lever at", "levr at"),
        ("at pivot", "at pvot"),
        ("at pivot", "at (1deg, 0)"),
        (" at pivot", ""),
        ("radius sector", "radius sektor"),
        ("radius sector", "radius -60mm"),
        ("radius sector", "radius 60deg"),
        (" radius sector", ""),
        ("ram along", "lever along"),
        ("along (0, 1)", "along (0, 0)"),
        ("along (0, 1)", "along (0, 1, 0)"),
        ("along (0, 1)", "along (0, 1mm)"),
        ("along (0, 1)", "along up"),
        (", pressure angle 20deg", ", 20deg"),
        ("angle 20deg", "angle 20"),
        ("angle 20deg", "angle 95deg"),
        ("friction of foot", "friction of teeth"),
        (
            rack,
            "gears teeth = lever at pivot radius sector, ground at (0, 0) radius 0",
        ),
        (rack, "hinge of pin = (0, 0, 1)"),
        (bodies, ""),
    ]
    .map(|(old, new)| {
        assert!(right.contains(old), "{old}");
        folder.write("rack_press.kin", &right.replacen(old, new, 1));
        typed_in(&folder, "kin check rack_press.kin")
    });
    assert_snapshot!("mistakes in gears and racks", all.join("\n"));
}

/// A hinge of space is a ball joint with an axis.
#[test]
fn mistakes_in_hinges() {
    let folder = Folder::new("axes");
    let right = include_str!("rssr.kin");
    let all = [
        ("hinge of ground_crank", "hinge ground_crank"),
        ("hinge of ground_crank", "hinge of ground_krank"),
        ("hinge of ground_crank", "hinge of ground_arm"),
        ("(0, 0, 1)", "(0, 1)"),
        ("(0, 0, 1)", "(0, 0, 0)"),
        ("(0, 0, 1)", "(0, 0, 1mm)"),
        ("= axis", "= axs"),
        (
            "hinge of ground_arm = axis;",
            "rack teeth = arm at ball radius 1mm, rod along (0, 1, 0);",
        ),
    ]
    .map(|(old, new)| {
        assert!(right.contains(old), "{old}");
        folder.write("rssr.kin", &right.replacen(old, new, 1));
        typed_in(&folder, "kin check rssr.kin")
    });
    assert_snapshot!("mistakes in hinges", all.join("\n"));
}

/// Every statement beside the declaration has its mistakes, all of which are reported at once.
#[test]
fn mistakes_in_loads_motions_and_columns() {
    let folder = Folder::new("loads");
    let right = include_str!("robot.kin");
    let all = [
        ("rest 0.1s, 80deg", "rest 0.1s, 85deg"),
        ("rest 0.1s", "rest 0.1mm"),
        ("80deg..120deg by", "80deg..120deg"),
        ("beta = 60deg", "alpha = 60deg"),
        ("-9.81m/s2", "-9.81"),
        ("(0, -9.81m/s2)", "9.81m/s2"),
        ("gravity =", "gravty ="),
        ("mass hand = 2kg", "hand = 2kg"),
        ("mass hand", "mass hnd"),
        ("mass hand", "mass phi"),
        ("mass hand", "mass"),
        ("2kg", "2N"),
        ("2kg", "-2kg"),
        ("2kg", "2"),
        ("0.004kg*m2", "0.004kg"),
        ("inertia phi", "inertia hand"),
        ("(-10N, 0)", "10N"),
        ("force hand", "force phi"),
        ("0.2Nm", "0.2N"),
        ("to (100mm, 0) = 0.5N/mm", "to psi = 0.5N/mm"),
        ("to (100mm, 0) = 0.5N/mm", "to (100mm) = 0.5N/mm"),
        ("to (100mm, 0) = 0.5N/mm", "to (100deg, 0) = 0.5N/mm"),
        (", rest 300mm", ", 300mm"),
        (", rest 300mm", ", rest 300deg"),
        ("1.5Nm/rad", "1.5N/m"),
        ("20Ns/m", "20N/m"),
        ("0.1Nms/rad", "0.1"),
        ("open or crossed", "open, crossed"),
        ("open or crossed", "open or crosed"),
        ("columns hand", "columns hnad"),
        ("beta_effort;", "gamma_effort;"),
        ("beta_effort;", "beta_effort,;"),
        ("beta_effort;", "beta_effort"),
        ("columns hand", "columns hand; columns alpha"),
    ]
    .map(|(old, new)| {
        assert!(right.contains(old), "{old}");
        folder.write("robot.kin", &right.replacen(old, new, 1));
        typed_in(&folder, "kin check robot.kin")
    });
    assert_snapshot!("mistakes in loads, motions and columns", all.join("\n"));
    let bare = right.replace("mm", "").replace("N/,", "N/mm,");
    folder.write("robot.kin", &bare.replace("hnd", "hand"));
    let printed = typed_in(&folder, "kin check robot.kin");
    assert!(printed.contains("loads need the unit of the lengths"), "{printed}");
    let several = [
        ("mass hand", "mass hnd"),
        ("columns hand", "columns hnad"),
        ("150mm;", "150deg;"),
    ];
    let spoilt = several
        .iter()
        .fold(right.to_owned(), |text, (old, new)| text.replacen(old, new, 1));
    folder.write("robot.kin", &spoilt);
    let all = ["robot.kin", "robot.kin --json"].map(|words| typed_in(&folder, &format!("kin check {words}")));
    assert_snapshot!("mistakes for an editor", all.join("\n"));
}
