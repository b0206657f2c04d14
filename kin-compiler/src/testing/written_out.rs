//! What `for` and frames stand for: the same code as the statements that a person would write.

use syn::Item;

use crate::text::Declaration;

/// The code without the dead function for editors, which shows what was typed.
fn code(text: &str) -> String {
    let declaration = Declaration::parse(text).unwrap_or_else(|mistakes| panic!("{text}\n{}", mistakes[0]));
    let mut file: syn::File = syn::parse_str(&declaration.rust()).expect("an expansion is a list of items");
    let all = file.items.len();
    file.items
        .retain(|item| !matches!(item, Item::Const(item) if item.ident == "_" && item.attrs.len() == 1));
    assert_eq!(file.items.len() + 1, all);
    prettyplease::unparse(&file)
}

fn assert_same(short: &str, long: &str) {
    let (short, long) = (code(short), code(long));
    for (short, long) in short.lines().zip(long.lines()) {
        assert_eq!(short, long);
    }
    assert_eq!(short.lines().count(), long.lines().count());
}

const PLATFORM: &str = "
    struct Platform {
        a1: Point3, a2: Point3, a3: Point3, a4: Point3, a5: Point3, a6: Point3,
        b1: Vector3, b2: Vector3, b3: Vector3, b4: Vector3, b5: Vector3, b6: Vector3,
    }
    input l1: Length, l2: Length, l3: Length, l4: Length, l5: Length, l6: Length;
    unknown x: Length, y: Length, z: Length, roll: Angle, pitch: Angle, yaw: Angle;
";

/// Six legs as one, and the body as a frame.
#[test]
fn a_platform() {
    let long = "
        let position = vec3(x, y, z);
        let platform_rotation = rot_z(yaw) * rot_y(pitch) * rot_x(roll);
        norm(position + platform_rotation * b1 - a1) == l1;
        norm(position + platform_rotation * b2 - a2) == l2;
        norm(position + platform_rotation * b3 - a3) == l3;
        norm(position + platform_rotation * b4 - a4) == l4;
        norm(position + platform_rotation * b5 - a5) == l5;
        norm(position + platform_rotation * b6 - a6) == l6;
    ";
    let short = "
        let position = vec3(x, y, z);
        let platform = frame(position, rot_z(yaw) * rot_y(pitch) * rot_x(roll));
        for (base, joint, length) in [
            (a1, b1, l1), (a2, b2, l2), (a3, b3, l3), (a4, b4, l4), (a5, b5, l5), (a6, b6, l6),
        ] {
            norm(platform * joint - base) == length;
        }
    ";
    assert_same(&format!("{PLATFORM}{short}"), &format!("{PLATFORM}{long}"));
}

/// The leg of the library, with its picture.
#[test]
fn a_leg() {
    let leg = |statements: &str| {
        format!(
            "struct Leg {{ base: Point3, joint: Vector3 }}
            input x: Length, y: Length, z: Length, roll: Angle, pitch: Angle, yaw: Angle;
            unknown leg: Length where leg > 0;
            {statements}
            dot(top - base, top - base) == leg.powi(2);
            output head: Point3 = top;
            ground base;
            body platform: vec3(x, y, z), head;
            body leg: base;
            slide head along top - base on leg;"
        )
    };
    assert_same(
        &leg("let table = frame(vec3(x, y, z), rot_z(yaw) * rot_y(pitch) * rot_x(roll)); let top = table * joint;"),
        &leg(
            "let table_origin = vec3(x, y, z); let table_rotation = rot_z(yaw) * rot_y(pitch) * rot_x(roll);
            let top = table_origin + table_rotation * joint;",
        ),
    );
}

/// Frames of the plane on each other; abbreviations, outputs and bodies in copies.
#[test]
fn a_four_bar() {
    let bar = |statements: &str| {
        format!(
            "struct Bar {{ ground: Length, crank: Length, rod: Length, rocker: Length, p: Vector, q: Vector }}
            input theta: Angle;
            unknown phi: Angle, psi: Angle;
            {statements}"
        )
    };
    let short = "
        let lever = frame(0, theta);
        let coupler = lever * frame_of_rod;
        lever * crank + rod * cis(theta + phi) == ground + rocker * cis(psi);
        for (trace, tip, arm, place) in [(p, tip1, upper, 2 * p), (q, tip2, lower, p - q)] {
            let carried = coupler * trace;
            /// A point of the coupler.
            output tip: Point = carried;
            output place: Point = -(coupler * trace) / 2 + coupler * (trace + place) * 3 - coupler * 0;
            body arm: coupler * 0, tip;
        }
    ";
    let short = short
        .replace("output place", "output out")
        .replace("(trace, tip, arm, place)", "(trace, tip, arm, place, out)")
        .replace("2 * p)", "2 * p, out1)")
        .replace("p - q)", "p - q, out2)")
        .replace("let coupler", "let frame_of_rod = frame(crank, phi); let coupler");
    let long = "
        let coupler_origin = crank * cis(theta);
        let coupler_angle = theta + phi;
        crank * cis(theta) + rod * cis(theta + phi) == ground + rocker * cis(psi);
        let carried_1 = coupler_origin + p * cis(coupler_angle);
        /// A point of the coupler.
        output tip1: Point = carried_1;
        output out1: Point = -(coupler_origin + p * cis(coupler_angle)) / 2
            + (coupler_origin + (p + (2 * p)) * cis(coupler_angle)) * 3 - coupler_origin;
        body upper: coupler_origin, tip1;
        let carried_2 = coupler_origin + q * cis(coupler_angle);
        /// A point of the coupler.
        output tip2: Point = carried_2;
        output out2: Point = -(coupler_origin + q * cis(coupler_angle)) / 2
            + (coupler_origin + (q + (p - q)) * cis(coupler_angle)) * 3 - coupler_origin;
        body lower: coupler_origin, tip2;
    ";
    assert_same(&bar(&short), &bar(long));
}

/// Frames of space on each other, in a row and in one formula; names that are taken.
#[test]
fn an_arm() {
    let arm = |statements: &str| {
        format!(
            "struct Arm {{ l: Length, m: Length, tool: Vector3, leg_1: Length, arm_rotation: Angle }}
            input q: Angle, r: Angle, s: Angle;
            unknown u: Angle, w: Length, v: Length;
            sin(u) == sin(q) * leg_1 / l;
            {statements}"
        )
    };
    let short = "
        let base = frame(vec3(0, 0, l), rot_z(q));
        let arm = base * wrist;
        for (height, offset) in [(w, 0), (v, 30deg)] {
            let leg = rot_x(r + offset) * tool;
            height == leg.z + (base * wrist * tool).x;
        }
        output tip: Point3 = arm * tool - base * arm * vec3(m, 0, 0);
    ";
    let short = short.replace(
        "let arm",
        "let wrist = frame(vec3(m, 0, 0), rot_x(arm_rotation + s)); let arm",
    );
    let long = "
        let base_origin = vec3(0, 0, l);
        let base_rotation = rot_z(q);
        let wrist_origin = vec3(m, 0, 0);
        let wrist_rotation = rot_x(arm_rotation + s);
        let arm_origin = base_origin + base_rotation * wrist_origin;
        let arm_rotation_ = base_rotation * wrist_rotation;
        let leg_1_ = rot_x(r + 0) * tool;
        w == leg_1_.z + (base_origin + base_rotation * wrist_origin + base_rotation * wrist_rotation * tool).x;
        let leg_2 = rot_x(r + 30deg) * tool;
        v == leg_2.z + (base_origin + base_rotation * wrist_origin + base_rotation * wrist_rotation * tool).x;
        output tip: Point3 = arm_origin + arm_rotation_ * tool
            - (base_origin + base_rotation * arm_origin + base_rotation * arm_rotation_ * vec3(m, 0, 0));
    ";
    assert_same(&arm(&short), &arm(long));
}
