//! The mechanisms that are refined, and that have pages.

/// Calls something with the type of the mechanism that has this name, such as `four_bar`:
/// `of_mechanism!(name, |M| pages::<M>(rows))`. The result is a [`Fault`](super::fault::Fault) that lists all names if
/// there is none.
macro_rules! of_mechanism {
    ($name:expr, |$M:ident| $call:expr) => {
        of_mechanism! {
            @of $name, $M, $call,
            kin_fit::TracedFourBar, kin_core::library::FourBar, kin_core::library::SliderCrank,
            kin_core::library::OffsetSliderCrank,
            kin_core::library::HoekenLinkage, kin_core::library::ChebyshevLinkage, kin_core::library::RobertsLinkage,
            kin_core::library::WattI, kin_core::library::WattII, kin_core::library::StephensonIII,
            kin_core::library::JansenLeg, kin_core::library::KlannLeg
        }
    };
    (@of $name:expr, $M:ident, $call:expr, $($mechanism:ty),+) => {{
        let wanted: &str = $name;
        let mut names = Vec::new();
        'found: {
            $(of_mechanism!(@try 'found wanted, names, $M, $call, $mechanism);)+
            Err($crate::fault::Fault::Wrong(format!(
                "`{wanted}` is no mechanism that this program refines or shows; there are {}",
                names.join(", ")
            )))
        }
    }};
    (@try $found:lifetime $wanted:ident, $names:ident, $M:ident, $call:expr, $mechanism:ty) => {{
        type $M = $mechanism;
        let description = <$M as kin_core::Mechanism>::DESCRIPTION;
        let name = kin_core::in_small_letters(description.name, '_');
        if name == $wanted {
            break $found $call;
        }
        $names.push(name);
    }};
}
pub(crate) use of_mechanism;
