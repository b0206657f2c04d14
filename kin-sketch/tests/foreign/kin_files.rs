//! What a drawing writes as a `.kin` file.

use kin_sketch::DriveMotion;
use kin_sketch::foreign::read;

#[test]
fn a_file_states_numbers_motion_and_assembly() {
    let table = "ground crank R 0 0\ncrank rod R 0 3\nrod piston R 4 0\nground piston P 4 0 0\nrod R 1 4\n";
    let declaration = read(table).unwrap().sketch.declaration().unwrap();
    let motion = DriveMotion {
        range: None,
        speed: Some(-std::f64::consts::TAU),
    };
    let file = declaration.kin_file("A pump.\n\nOf PMKS.", "cm", &[motion]);
    let begins =
        "kin 1\n/// A pump.\n///\n/// Of PMKS.\nstruct Imported { crank: Length, rod: Length, rod_e: Vector }\n";
    assert!(file.starts_with(begins), "{file}");
    assert!(
        file.contains("dimensions { crank = 3cm; rod = 5cm; rod_e = ("),
        "{file}"
    );
    assert!(
        file.contains("motion { crank_angle = 90deg..-270deg at 60rpm; }"),
        "{file}"
    );
    assert!(file.contains("assembly = rod_angle=-36.87deg, s=4cm;"), "{file}");
}

#[test]
fn a_slide_moves_as_it_is_told() {
    let table = "boom, ground, P, 12, 3, 90\nground, lever, R, 0, 5\nlever, rod, R, 0, 10\nrod, boom, R, 12, 7\n";
    let declaration = read(table).unwrap().sketch.declaration().unwrap();
    let told = DriveMotion {
        range: Some([0.0, 1.5]),
        speed: Some(2.0),
    };
    assert!(
        declaration
            .kin_file("", "mm", &[told])
            .contains("motion { s = -2mm..-0.5mm at 2mm/s; }")
    );
    // a tenth of the distance to both sides
    assert!(declaration.kin_file("", "", &[]).contains("motion { s = -2.2..-1.8; }"));
}
