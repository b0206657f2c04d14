//! The names of the library's mechanisms, in one list for all that visits every one of them.

/// Calls a macro with the names of all mechanisms of the [library](crate::library), in alphabetical order and without
/// commas.
///
/// ```
/// use kin_core::library::*;
/// use kin_core::Mechanism;
///
/// macro_rules! orders {
///     ($($mechanism:ident)+) => { [$((stringify!($mechanism), <$mechanism>::DESCRIPTION.order)),+] };
/// }
///
/// let orders = kin_core::each_library_mechanism!(orders);
/// assert!(orders.contains(&("FourBar", 4)));
/// ```
#[macro_export]
#[doc(hidden)]
macro_rules! each_library_mechanism {
    ($call:ident) => {
        $call! {
            AndrewsSqueezer Bennett ChebyshevLinkage ClassThreeTriad FiveBar FourBar FreudensteinFourBar GearedFiveBar
            GeometricFourBar HoekenLinkage InvertedSliderCrank JansenLeg KlannLeg OffsetSliderCrank Pantograph
            PeaucellierLinkage RobertsLinkage Rssp Rssr ScotchYoke SliderCrank SliderCrankFirstApproximation
            SliderCrankHigherApproximation SphericalFourBar StephensonI StephensonIByDyad StephensonII
            StephensonIIByElbow StephensonIII StephensonIIIByDyad StewartGoughLeg UniversalJoint WattI WattIByDyad
            WattII WattIIByCouplers WhitworthQuickReturn
        }
    };
}
