//! Declarations that several tests use.

use proc_macro2::TokenStream;
use quote::quote;

/// The four-bar linkage by its vector loop.
pub(crate) fn four_bar() -> TokenStream {
    quote! {
        struct FourBar { r1: Length, r2: Length, r3: Length, r4: Length }
        input theta2: Angle;
        unknown theta3: Angle, theta4: Angle;
        r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
    }
}

/// The centric slider-crank by its coordinates.
pub(crate) fn slider_crank() -> TokenStream {
    quote! {
        struct SliderCrank { r: Length, l: Length }
        input theta: Angle;
        unknown phi: Angle, s: Length;
        r * sin(theta) == l * sin(phi);
        s == r * cos(theta) + l * cos(phi);
    }
}

/// The inverted slider-crank by its vector loop.
pub(crate) fn inverted_slider_crank() -> TokenStream {
    quote! {
        struct InvertedSliderCrank { r1: Length, r2: Length }
        input theta2: Angle;
        unknown r4: Length where r4 > 0, theta4: Angle;
        r1 + r2 * cis(theta2) == r4 * cis(theta4);
    }
}

/// A class III triad: four coupled unknowns, of which Newton's method finds two.
pub(crate) fn triad() -> TokenStream {
    quote! {
        pub struct Triad {
            crank: Length, a: Length, b: Length, c: Length, p: Length, q: Length, delta: Angle,
            pivot_b: Point, pivot_c: Point
        }
        input theta: Angle;
        unknown alpha: Angle, beta: Angle, gamma: Angle, phi: Angle;
        let joint = crank * cis(theta) + a * cis(alpha);
        joint + p * cis(phi) == pivot_b + b * cis(beta);
        joint + q * cis(phi + delta) == pivot_c + c * cis(gamma);
    }
}
