use kin_core::prelude::*;

mechanism! {
    struct Press { crank: Length, rod: Length }
    input theta: Angle;
    unknown phi: Angle, stroke: Length;

    crank * cis(theta) + rod * cis(phi) == vec2(stroke, 0);
    fn half(x: Length) -> Length { x / 2 }
    output middle: Length = half(rod);
}

fn main() {}
