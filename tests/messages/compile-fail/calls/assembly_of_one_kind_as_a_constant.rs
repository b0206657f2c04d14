use kin_core::prelude::*;

mechanism! {
    pub struct Chain {
        pub a: Length,
        pub b: Length,
    }
    input s: Length;
    unknown alpha: Angle, beta: Angle, gamma: Angle, delta: Angle;
    a * cis(alpha) + b * cis(beta) == vec2(s, 0);
    a * cis(gamma) + b * cis(delta) == vec2(0, s);
}

fn main() {
    let chain: Chain = Chain { a: 3.0, b: 4.0 };
    let _ = chain.position(5.0, ChainAssembly::Open);
}
