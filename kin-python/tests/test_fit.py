"""Dimensions from measured numbers."""

import numpy as np
import pytest

import kin

FOUR_BAR = kin.library.four_bar
RIGHT = {"r1": 90.0, "r2": 30.0, "r3": 82.0, "r4": 57.0}
GUESS = FOUR_BAR(r1=90, r2=30, r3=80, r4=60)
ANGLES = np.linspace(0, 6, 25)


def measured():
    return FOUR_BAR.solve_batch(**RIGHT, theta2=ANGLES, assembly="open").theta4.position


@pytest.mark.parametrize("vary", [("r3", "r4"), {"r3": (40, 100), "r4": None}])
def test_dimensions_are_found_again(vary):
    fitted = GUESS.fit({"theta2": ANGLES, "theta4": measured()}, vary=vary, assembly="open")
    assert fitted.linkage.dimensions == pytest.approx(RIGHT, rel=1e-7)
    assert fitted.is_minimum and fitted.unclosed_rows == 0
    assert fitted.deviations["theta4"] < 1e-8 < fitted.deviations_at_start["theta4"]
    assert GUESS.dimensions["r3"] == 80


def test_noise_is_averaged_out():
    noise = np.random.default_rng(1).normal(0, 1e-3, len(ANGLES))
    fitted = GUESS.fit({"theta2": ANGLES, "theta4": measured() + noise}, vary=["r3", "r4"], assembly="open")
    # two of 25 freedoms are used up
    assert 0.5e-3 < fitted.deviations["theta4"] < 1.2e-3
    assert abs(fitted.linkage.dimensions["r4"] - 57) < 0.5


def test_numbers_that_are_not_known():
    angles, rockers = ANGLES.copy(), measured()
    angles[3], rockers[7] = np.nan, np.nan
    fitted = GUESS.fit({"theta2": angles, "theta4": rockers}, vary=["r3", "r4"], assembly="open")
    assert fitted.linkage.dimensions == pytest.approx(RIGHT, rel=1e-6)


def test_data_frames():
    pandas, polars = pytest.importorskip("pandas"), pytest.importorskip("polars")
    columns = {"theta2": ANGLES, "theta4": measured()}
    for data in (pandas.DataFrame(columns), polars.DataFrame(columns)):
        if not isinstance(data, pandas.DataFrame):
            data = data.to_dict()
        fitted = GUESS.fit(data, vary="r4", assembly="open")
        assert fitted.linkage.dimensions["r4"] != 60


def test_mistakes():
    data = {"theta2": ANGLES, "theta4": measured()}
    with pytest.raises(ValueError, match="no dimension is called `r5`: dimensions are r1, r2, r3, r4"):
        GUESS.fit(data, vary=["r5"], assembly="open")
    with pytest.raises(ValueError, match="no quantity is called `theta5`: there are theta2, theta3, theta4"):
        GUESS.fit({**data, "theta5": ANGLES}, assembly="open")
    with pytest.raises(ValueError, match="`theta4` has 24 numbers, and the column before it 25"):
        GUESS.fit({**data, "theta4": ANGLES[:24]}, assembly="open")
    with pytest.raises(kin.AnswerError, match="r3"):
        GUESS.fit(data, vary={"r3": (100, 40)}, assembly="open")
    with pytest.raises(kin.AnswerError, match="closes in no row"):
        FOUR_BAR(r1=900, r2=30, r3=70, r4=60).fit(data, vary=["r2"], assembly="open")
