//! Declarations that contain every function, operator and statement that a translated method may come from.

use kin_compiler::Declaration;
use kin_core::mechanism;
use kin_live::sheet::SheetCode;

use kin_agreement::{assert_agreement, samples};

/// Declares a mechanism by the macro and by its text, and compares both.
macro_rules! agrees {
    ($test:ident, $name:ident, { $($declaration:tt)* }) => {
        #[test]
        fn $test() {
            mechanism! { $($declaration)* }
            let [finite, ..] = assert_agreement::<$name>(stringify!($($declaration)*));
            assert!(finite > 5 * samples(), "{finite} results are finite");
        }
    };
}

agrees!(functions_of_numbers, Functions, {
    struct Functions { k: Scalar, p: Length }
    input t: Angle;
    unknown e: Scalar;
    let half = t / 2 + 30deg;
    let unused = half * half;
    e == tan(half) + sinh(t) * cosh(k) / tanh(t) - (asin(k / 4) + acos(t / 4) * atan(k)) + powi(k, 3) - t.powi(-2) + PI;
    output inverse: Scalar = asinh(t) + acosh(e) - atanh(k / 5) * -exp(k) + ln(e) + sqrt(k) + atan2(t, e);
    output circle: Length = p * sin(t) / (cos(t) - 2) + unused * p;
    output long: Scalar =
        t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t
        + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t
        + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t
        + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t
        + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t
        + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t
        + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t
        + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t
        + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t
        + t + t + t + t + t + t + t + t + t + t + t + t + t + t + t;
});

agrees!(vectors_of_the_plane, PlaneVectors, {
    struct PlaneVectors { a: Length, b: Length, k: Scalar, p: Point, v: Vector }
    input t: Angle;
    unknown u: Angle, s: Length;
    let arm = a * cis(t);
    let offset = (a + b - p + v - arm) / 2;
    arm + b * cis(u) == vec2(s, 0) + k * v;
    output turned: Point = (cis(t) * a + polar(s, u)) * cis(u) - -offset * k / (k + 3) - b;
    output measured: Length = norm(p) + dot(arm, p) / a - cross(offset, v) / (a + b) + p.x - (arm - p).y;
    output nothing: Vector = 0;
});

agrees!(vectors_of_space, SpaceVectors, {
    struct SpaceVectors { axis: Vector3, p: Point3, a: Length, bend: Angle }
    input t: Angle, r: Length;
    unknown x: Length, y: Length, z: Length, w: Length, h: Length;
    let arm = rot_y(bend) * vec3(a, r, 0);
    vec3(x, y, z) == rot_z(t) * (rot_x(bend) * rot_y(t) * p) + rot(axis, t) * arm - cross(axis, p) / a;
    vec2(w, h) == r * cis(t) + polar(a, bend);
    output out: Point3 = -vec3(x, y, z) + arm / 2 + bend * p - 0;
    output measured: Length = dot(p, axis) / norm(arm - p) + p.z * sin(t) + (rot_z(t) * rot(axis, bend) * arm).y;
    output corner: Point = vec2(w, h) - r * cis(t);
});

agrees!(slides_on_slides, Slides, {
    struct Slides { a: Length, bend: Angle }
    input t: Angle;
    unknown x: Length, s: Length;
    a * cis(t) == x + s * cis(bend);
});

agrees!(a_plane_chain_in_space, PlaneInSpace, {
    struct PlaneInSpace { a: Length, b: Length, c: Length }
    input t: Angle;
    unknown u: Angle, s: Length, x: Length, y: Length, z: Length;
    -a * cis(t) + b * cis(u) - s == 0;
    vec3(x, y, z) == rot_z(t) * vec3(a, 0, 0) + rot_z(t) * rot_x(u) * vec3(0, c, 0);
});

agrees!(statements_of_the_picture, Stated, {
    struct Stated { a: Length, b: Length, p: Point }
    input t: Angle;
    unknown u: Angle, s: Length;
    a * sin(t) == b * sin(u);
    s == a * cos(t) + b * cos(u);
    let pin = a * cis(t);
    ground 0;
    body crank: 0, pin;
    body rod: pin, piston;
    body lever: p, -p - pin;
    slide piston along vec2(1, 0);
    slide pin along pin - p on lever;
    output piston: Point = vec2(s, 0);
});

/// A formula about as deep as the compiler takes it, and a long row of abbreviations, fit on the stack of a test.
#[test]
fn deep_formulas() {
    let (opened, closed) = ("sin(-(".repeat(50), " + t) / 2)".repeat(50));
    let abbreviations: Vec<String> = (1..500).map(|n| format!("let a{n} = a{} + t;", n - 1)).collect();
    let head = "struct Deep { k: Scalar } input t: Angle; unknown e: Scalar; let a0 = k;";
    let text = format!("{head} {} e == {opened} a499 {closed};", abbreviations.concat());
    let declaration = Declaration::parse(&text).unwrap_or_else(|mistakes| panic!("{}", mistakes[0]));
    let code = SheetCode::new(&declaration.sheets().closure, 1, 1, 1).expect("it uses what is there");
    let (mut registers, mut found) = (vec![0.0; code.registers()], [0.0]);
    code.run(&[0.5], &[0.25], &[1.0], &mut registers, &mut found);
    let innermost = 0.5 + 499.0 * 0.25;
    let deep = (0..50).fold(innermost, |inner: f64, _| (-(inner + 0.25) / 2.0).sin());
    assert!((found[0] - (1.0 - deep)).abs() < 1e-12, "{found:?}");
}

#[test]
fn what_a_method_uses_has_to_be_there() {
    let text = "struct Crank { r: Length } input t: Angle; unknown x: Length; x == r * cos(t);";
    let declaration = Declaration::parse(text).unwrap_or_else(|mistakes| panic!("{}", mistakes[0]));
    let closure = &declaration.sheets().closure;
    assert!(SheetCode::new(closure, 1, 1, 1).is_some());
    for [parameters, inputs, unknowns] in [[0, 1, 1], [1, 0, 1], [1, 1, 0]] {
        assert_eq!(SheetCode::new(closure, parameters, inputs, unknowns), None);
    }
}
