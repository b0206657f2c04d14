//! Snapshots of two expansions: a closed form, and a block that is torn. They show every change of the generated code
//! as its readers see it. What other declarations compute is tested where they are compiled.

use proc_macro2::TokenStream;
use quote::quote;

use crate::expand::expand;
use crate::testing::declarations::triad;

/// The expansion as `cargo expand` would show it.
fn pretty(declaration: &TokenStream) -> String {
    let tokens = expand(quote!((::kin_core) #declaration));
    let file = syn::parse2(tokens).expect("an expansion is a list of items");
    prettyplease::unparse(&file)
}

fn four_bar() -> TokenStream {
    quote! {
        /// Planar four-bar linkage.
        pub struct FourBar {
            /// Ground.
            pub r1: Length,
            pub r2: Length,
            pub r3: Length,
            pub r4: Length,
        }
        input theta2: Angle;
        unknown theta3: Angle, theta4: Angle;
        r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    }
}

/// The lines of an expansion without the formulas to be read, which are constants.
fn lines_of_code(expansion: &str) -> usize {
    let (mut count, mut end) = (0, None);
    for line in expansion.lines().map(str::trim) {
        if let Some(last) = end {
            end = (line != last).then_some(last);
        } else if line == "#[cfg_attr(" {
            end = Some(")]");
        } else if line.starts_with("const FORMULAS") {
            end = Some(");");
        } else {
            count += 1;
        }
    }
    count
}

/// Code that is the same for all mechanisms belongs in `kin-core`, not in every expansion.
#[test]
fn an_expansion_is_short() {
    let lines = lines_of_code(&pretty(&four_bar()));
    assert!(lines <= 1050, "{lines} lines");
}

/// Only editors read the dead function in front, but every build has to skip it.
#[test]
fn the_part_for_editors_is_short() {
    let text = pretty(&four_bar());
    let lines = text.lines().take_while(|line| *line != "};").count() + 1;
    assert!(
        text.lines().take(lines).any(|line| line.contains("fn declaration")),
        "{text}"
    );
    assert!(lines <= 40, "{lines} lines");
}

/// A chain of scalar equations, with ranges and three choices.
fn geometric_four_bar() -> TokenStream {
    quote! {
        pub struct GeometricFourBar { pub r1: Length, pub r2: Length, pub r3: Length, pub r4: Length }
        input theta2: Angle;
        unknown e: Length where e > 0, alpha: Angle, gamma: Angle in 0.0..=PI, beta: Angle, theta4: Angle,
            theta3: Angle;
        e.powi(2) == r1.powi(2) + r2.powi(2) - 2 * r1 * r2 * cos(theta2);
        sin(alpha) == r2 * sin(theta2) / e;
        cos(gamma) == (r3.powi(2) + r4.powi(2) - e.powi(2)) / (2 * r3 * r4);
        sin(beta) == r3 * sin(gamma) / e;
        alpha + beta + theta4 == PI;
        theta3 == theta4 - gamma;
    }
}

/// Two loops, one of them a polar form, with a point, a length and a range that is checked at run time.
fn quick_return() -> TokenStream {
    quote! {
        struct QuickReturn { pivot: Point, crank: Length, lever: Length, rod: Length, height: Length }
        input theta: Angle;
        unknown slide: Length where slide > 0, phi: Angle, psi: Angle in -PI/4..=PI/4, stroke: Length;
        pivot + crank * cis(theta) == slide * cis(phi);
        lever * cis(phi) + rod * cis(psi) == vec2(stroke, height);
        output tip: Point = lever * cis(phi);
        output leverage: Scalar = slide / crank;
    }
}

/// A chain of directions: two loops, one of which uses the direction found by the other, and a rack that needs an
/// angle.
fn directions() -> TokenStream {
    quote! {
        pub struct Press { r1: Length, r2: Length, r3: Length, r4: Length, rod: Length, pinion: Length }
        input theta2: Angle;
        unknown theta3: Direction, theta4: Direction, phi: Direction, s: Length, rack: Length;
        r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
        r4 * cis(theta4) + rod * cis(phi) == vec2(s, 0);
        rack == pinion * phi;
    }
}

#[test]
fn triad_expansion() {
    insta::assert_snapshot!(pretty(&triad()));
}

#[test]
fn four_bar_expansion() {
    insta::assert_snapshot!(pretty(&four_bar()));
}

/// A block that no rule solves is factored once, for the rates of all orders and the sensitivities to all parameters.
#[test]
fn factors_are_shared() {
    let ring = quote! {
        pub struct Ring { side: Length, leg: Length, tie: Length, radius: Length }
        input theta: Angle;
        unknown a: Angle, b: Angle, c: Angle, d: Angle, e: Angle, f: Angle;
        let first = polar(radius, 0) + leg * cis(a);
        let second = polar(radius, 2 * PI / 3) + leg * cis(b);
        let third = polar(radius, 4 * PI / 3) + leg * cis(c);
        first + side * cis(d) + tie * cis(e) == second;
        second + side * cis(e) + tie * cis(f) == third;
        third + side * cis(f) + tie * cis(d + theta) == first;
        with sensitivities;
    };
    let code = pretty(&ring);
    assert_eq!(code.matches("solve::factor(").count(), 1);
    // four orders of rates, and five orders of sensitivities to four parameters
    assert_eq!(code.matches("solve::Factors::solve(").count(), 4 + 5 * 4);
}

/// The same declaration gives the same bytes.
#[test]
fn expansion_is_deterministic() {
    let mut sensitive = quick_return();
    sensitive.extend(quote!(with sensitivities;));
    for declaration in [
        four_bar(),
        geometric_four_bar(),
        quick_return(),
        directions(),
        sensitive,
    ] {
        assert_eq!(expand(declaration.clone()).to_string(), expand(declaration).to_string());
    }
}

/// Writes the expansions of all library mechanisms into a folder, so that two versions of the macro can be compared.
#[test]
#[ignore = "writes files: KIN_EXPANSIONS=folder"]
fn expansions_of_the_library() {
    let folder = std::path::PathBuf::from(std::env::var("KIN_EXPANSIONS").expect("KIN_EXPANSIONS is a folder"));
    for declared in crate::testing::library::library() {
        let text = pretty(&declared.declaration);
        std::fs::write(folder.join(declared.name), text).expect("the folder can be written to");
    }
}
