//! The mechanisms of the library can be stored.

#[allow(clippy::wildcard_imports, reason = "all mechanisms are meant")]
use super::*;

crate::storable! {
    AndrewsSqueezer,
    Bennett,
    ChebyshevLinkage,
    ClassThreeTriad,
    FiveBar,
    FourBar,
    FreudensteinFourBar,
    GearedFiveBar,
    GeometricFourBar,
    HoekenLinkage,
    InvertedSliderCrank,
    JansenLeg,
    KlannLeg,
    OffsetSliderCrank,
    Pantograph,
    PeaucellierLinkage,
    RobertsLinkage,
    Rssp,
    Rssr,
    ScotchYoke,
    SliderCrank,
    SliderCrankFirstApproximation,
    SliderCrankHigherApproximation,
    SphericalFourBar,
    StephensonI,
    StephensonIByDyad,
    StephensonII,
    StephensonIIByElbow,
    StephensonIII,
    StephensonIIIByDyad,
    StewartGoughLeg,
    UniversalJoint,
    WattI,
    WattIByDyad,
    WattII,
    WattIIByCouplers,
    WhitworthQuickReturn
}
