//! Outlines of typical declarations.

use proc_macro2::TokenStream;
use quote::quote;

use crate::mistakes::Mistakes;
use crate::translate::sheets;
use crate::translate::tree::{Sheets, Step, Tree, TreeKind};
use crate::{model, syntax};

/// The outline of a declaration in one line: ground, bodies, slides and points, by the numbers of the joints.
fn outlined(statements: &TokenStream) -> String {
    let mut mistakes = Mistakes::new();
    let declaration = quote! {
        struct M { a: Length, b: Length, c: Length, p: Point, bend: Angle, ratio: Scalar }
        input t: Angle;
        #statements
        output used: Vector = p * ratio + (a + b + c) * cis(bend);
    };
    let Some(declaration) = syntax::parse(declaration, &mut mistakes) else {
        return "no struct".to_owned();
    };
    let Some(model) = model::build(&declaration, &mut mistakes) else {
        return mistakes.into_messages().join("; ");
    };
    let sheets = sheets(&declaration, &model);
    // what is guessed is declared by the statements that the guess shows
    if let Some(guess) = &sheets.outline.guess
        && !sheets.outline.bodies.is_empty()
    {
        let guess: TokenStream = guess.parse().expect("statements are tokens");
        let declared = outlined(&quote!(#statements #guess));
        // the joints may have other numbers
        let joined = |text: &str| -> Vec<usize> {
            let mut counts: Vec<usize> = text.split(']').map(|part| part.matches(',').count()).collect();
            counts.sort_unstable();
            counts
        };
        let drawn = print(&sheets);
        assert_eq!(joined(&declared), joined(&drawn), "{declared}\n{drawn}\n{guess}");
    }
    print(&sheets)
}

fn print(
    Sheets {
        outline,
        skeleton_points,
        ..
    }: &Sheets,
) -> String {
    let mut parts = vec![format!("ground {:?}", outline.ground)];
    parts.extend(
        outline
            .bodies
            .iter()
            .map(|body| format!("{} {:?}", body.name, body.joints)),
    );
    let directions = skeleton_points.results.iter().skip(outline.joints);
    parts.extend(outline.slides.iter().zip(directions).map(|(slide, direction)| {
        let guide = slide.guide.map_or("ground", |body| &outline.bodies[body].name);
        format!("{} slides on {guide} along {}", slide.joint, printed(direction))
    }));
    parts.extend(outline.points.iter().map(|(name, joint)| format!("{name} is {joint}")));
    parts.join(", ")
}

fn printed(tree: &Tree) -> String {
    match &tree.kind {
        TreeKind::Number(value) => value.to_string(),
        TreeKind::Call(operation, arguments) => {
            let arguments: Vec<String> = arguments.iter().map(printed).collect();
            format!("{operation:?}({})", arguments.join(", "))
        }
        TreeKind::Chain { first, steps } => match steps.as_slice() {
            [Step::Minus(operand)] => format!("{} - {}", printed(first), printed(operand)),
            steps => format!("{} {steps:?}", printed(first)),
        },
        kind => format!("{kind:?}"),
    }
}

#[test]
fn every_angle_is_a_body() {
    let declaration = quote! {
        unknown u: Angle, v: Angle;
        a * cis(t) + b * cis(u) == p + c * cis(v);
    };
    assert_eq!(outlined(&declaration), "ground [0, 3], a [0, 1], b [1, 2], c [2, 3]");
}

#[test]
fn a_loop_that_comes_to_zero_is_the_same() {
    let declaration = quote! {
        unknown u: Angle, v: Angle;
        let pin = a * cis(t);
        (pin + b * cis(u)) - (p + c * cis(v)) == 0;
    };
    assert_eq!(outlined(&declaration), "ground [0, 3], a [0, 1], b [1, 2], c [2, 3]");
}

#[test]
fn terms_that_turn_together_are_one_body() {
    let declaration = quote! {
        unknown u: Angle, v: Angle, w: Angle, x: Angle;
        let tilted = u - bend;
        a * cis(t) + b * cis(u) == p + c * cis(v);
        a * cis(t) + c * cis(tilted) + a * cis(w) == b * cis(x);
        output tip: Point = a * cis(t) + vec2(a, b) * cis(u + PI / 2);
    };
    assert_eq!(
        outlined(&declaration),
        "ground [0, 3], a [0, 1], b [1, 2, 4, 6], c [2, 3], a [4, 5], b [0, 5], tip is 6"
    );
}

#[test]
fn terms_of_variable_length_are_slides() {
    let on_ground = quote! {
        unknown u: Angle, s: Length;
        a * cis(t) + b * cis(-u) == vec2(s, c);
    };
    assert_eq!(
        outlined(&on_ground),
        "ground [0], a [0, 1], b [1, 2], 2 slides on ground along Vector(1, 0)"
    );
    let on_a_lever = quote! {
        unknown u: Angle, s: Length;
        p + a * cis(t) == polar(s, u);
    };
    assert_eq!(
        outlined(&on_a_lever),
        "ground [0, 1], a [1, 2], s [0], 2 slides on s along Cis(Unknown(0))"
    );
}

#[test]
fn a_slide_on_a_slide_has_a_body_between() {
    let declaration = quote! {
        unknown x: Length, s: Length;
        a * cis(t) == x + s * cis(bend);
    };
    assert_eq!(
        outlined(&declaration),
        "ground [0], a [0, 1], s [2], 2 slides on ground along Vector(1, 0), \
         1 slides on s along Cis(Parameter(5))"
    );
}

#[test]
fn points_that_continue_no_body_belong_to_none() {
    let declaration = quote! {
        unknown u: Angle, v: Angle;
        a * cis(t) + b * cis(u) == p + c * cis(v);
        output between: Point = a / 2 * cis(t) + b / 2 * cis(u);
        output pin: Point = a * cis(t);
    };
    assert_eq!(
        outlined(&declaration),
        "ground [0, 3], a [0, 1], b [1, 2], c [2, 3], between is 4, pin is 1"
    );
}

#[test]
fn scalar_equations_are_no_picture() {
    let declaration = quote! {
        unknown u: Length;
        u == a * t;
    };
    assert_eq!(outlined(&declaration), "ground []");
}

#[test]
fn rotations_of_space_are_compared_as_a_whole() {
    let declaration = quote! {
        unknown u: Angle, v: Angle, w: Angle;
        rot_z(t) * vec3(a, 0, 0) + rot_z(t) * rot_x(bend) * vec3(b, 0, 0) + rot_z(u) * rot_x(v) * vec3(0, 0, c)
            == vec3(p.x, p.y, 0) + rot_y(w) * vec3(0, 0, a);
    };
    assert_eq!(outlined(&declaration), "ground [0, 3], a [0, 1], c [1, 2], a [2, 3]");
}

#[test]
fn statements_replace_what_follows_from_the_equations() {
    let declaration = quote! {
        unknown u: Angle, s: Length;
        a * sin(t) == b * sin(u);
        s == a * cos(t) + b * cos(u);
        let pin = a * cis(t);
        ground 0;
        body crank: 0, pin;
        body rod: a * cis(t), piston;
        body lever: p;
        slide piston along vec2(1, 0);
        slide pin along pin - p on lever;
        output piston: Point = vec2(s, 0);
    };
    assert_eq!(
        outlined(&declaration),
        "ground [0], crank [0, 1], rod [1, 2], lever [3], \
         2 slides on ground along Vector(1, 0), \
         1 slides on lever along Local(Abbreviation(0)) - Parameter(3), piston is 2"
    );
}

/// A word that begins a statement of the picture may be the name of a quantity.
#[test]
fn words_of_the_picture_are_names_as_well() {
    let declaration = quote! {
        unknown slide: Length, body: Angle;
        let ground = p + a * cis(t);
        ground - b * cis(body) == slide * cis(bend) + c * 0;
    };
    assert_eq!(outlined(&declaration).matches("slides").count(), 1);
}
