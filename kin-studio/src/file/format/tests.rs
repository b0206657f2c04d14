use kin_declarations::{Kind, Scale, declaration};
use proc_macro2::TokenStream;

use super::{WIDTH, atoms, formatted, is_same};
use crate::library::DESIGNS;

/// The tokens of a text with blanks instead of its first line, if the text can be read.
fn tokens(text: &str) -> Option<TokenStream> {
    let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
    format!("{}\n{rest}", " ".repeat(first.len())).parse().ok()
}

/// The text in one form, which a second run leaves unchanged.
fn checked(text: &str) -> Option<String> {
    let before = tokens(text)?;
    let once = formatted(text, &before);
    let after = tokens(&once).unwrap_or_else(|| panic!("{text}\n{once}"));
    assert!(is_same((text, &before), (&once, &after)), "{text}\n{once}");
    assert_eq!(formatted(&once, &after), once, "{text}");
    Some(once)
}

/// Tokens and comments stay, and a text in form stays as it is.
#[test]
fn only_blanks_change() {
    let [wiper, platform] = [
        include_str!("../../../tests/program/wiper.kin"),
        include_str!("../../../tests/program/platform.kin"),
    ];
    for text in [wiper, platform] {
        assert_eq!(checked(text).as_deref(), Some(text));
    }
    for design in DESIGNS {
        let text = format!("kin 1\n{}", design.declaration());
        let text = checked(&text).expect("the library can be read");
        let too_long = text
            .lines()
            .find(|line| line.chars().count() > WIDTH && !line.contains("//"));
        assert_eq!(too_long, None);
        // without line ends, comments are those of one line
        let bare: Vec<&str> = text.lines().filter(|line| !line.contains("//")).collect();
        checked(&format!("kin 1\n{}", bare[1..].join(" "))).expect("it can be read");
    }
    let mut read = 0;
    for kind in Kind::ALL {
        for seed in 0..200 {
            let text = format!("kin 1\n{}", declaration(kind, seed, Scale::Small));
            read += usize::from(checked(&text).is_some());
        }
    }
    assert!(read > 600, "{read} can be read");
}

#[test]
fn comments_have_two_ends() {
    let text = "kin 1\na /* one /* two */ three */ == /**/ b; // end";
    let row = atoms(text, &tokens(text).expect("it can be read"));
    let words: Vec<&str> = row.iter().map(|atom| atom.text).collect();
    assert_eq!(
        words,
        ["a", "/* one /* two */ three */", "==", "/**/", "b", ";", "// end"]
    );
}

#[test]
fn a_file_in_any_form() {
    let text = "\
kin 1   
// a comment before
/// Doc.
pub  struct Wiper{ground:Length,crank:Length, // trailing crank
 rod:Length,rocker:Length,
 /// doc of the blade
 blade:Length}   // after the struct


input theta:Angle;unknown phi:Angle  in -PI/2..PI,psi:Angle where psi>-1;
input
  /// one
  a: Length,
  /// two
  b: Length;
crank*cis( theta )+rod*cis(phi)==ground+-rocker*cis(psi)+ground+rocker*cis(psi)
+ground+rocker*cis(psi)-ground+rocker*cis(psi);
output tip:Point=ground+blade*cis(psi) // why
  + (crank - 1) // and
  ;
slide tip - crank along -vec2(1,0) on lever;
for (a,b) in[(a1,b1),(a2,-b2)]{a==b;let c=a/-b;}; /* block */ order=6;
for a in [a1, // one
a2] {
   // inside

   a==b; // behind


   b==c;
   // last
}
dimensions{ground=200mm;crank=40mm;rod=190 mm; p=(1,2cm);rocker=60mm;
// c
blade=450mm;}
motion{theta=0deg..360deg at 45 rpm by modified-sine; x = 20mm/s}
assembly=x=0mm,y=-2mm;
";
    insta::assert_snapshot!(checked(text).expect("it can be read"));
}
