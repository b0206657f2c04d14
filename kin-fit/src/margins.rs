//! Margins of a block by which its links turn.

use kin_core::BlockForm;

use crate::functions::Change;

fn absolute(value: Change) -> Change {
    if value.value < 0.0 { -value } else { value }
}

fn smaller(one: Change, other: Change) -> Change {
    if other.value < one.value { other } else { one }
}

/// Grashof's margin of a four-bar with this driver: the middle links less the shortest and the longest link.
pub(crate) fn grashof(form: &BlockForm<Change>, input: &str) -> Option<Change> {
    let BlockForm::FourBar {
        driver,
        ground,
        crank,
        coupler,
        rocker,
    } = *form
    else {
        return None;
    };
    let mut links = [ground, crank, coupler, rocker];
    links.sort_by(|one, other| one.value.total_cmp(&other.value));
    let [shortest, one, other, longest] = links;
    (driver == input).then(|| one + other - shortest - longest)
}

/// The margin by which the driver turns fully: its pin passes all distances from the other pivot between the difference
/// and the sum of ground and crank, which the other two links must reach.
pub(crate) fn driver_turns(form: &BlockForm<Change>, input: &str) -> Option<Change> {
    match *form {
        BlockForm::FourBar {
            driver,
            ground,
            crank,
            coupler,
            rocker,
        } if driver == input => {
            let far = coupler + rocker - ground - crank;
            let close = absolute(ground - crank) - absolute(coupler - rocker);
            Some(smaller(far, close))
        }
        BlockForm::SliderCrank {
            driver,
            crank,
            coupler,
            offset,
        } if driver == input => Some(coupler - crank - absolute(offset)),
        BlockForm::InvertedSliderCrank {
            driver,
            ground,
            crank,
            offset,
        } if driver == input => Some(absolute(ground - crank) - absolute(offset)),
        _ => None,
    }
}
