"""Quantities of pint."""

import numpy as np
import pytest

import kin

pint = pytest.importorskip("pint")
unit = pint.UnitRegistry()
CRANK = kin.library.slider_crank


def test_lengths_become_metres():
    press = CRANK(r=100 * unit.mm, l=0.3 * unit.m)
    assert press == CRANK(r=0.1, l=0.3)


def test_angles_and_speeds():
    press = CRANK(r=0.1, l=0.3)
    pose = press.solve(theta=(30 * unit.deg, 300 * unit.rpm, 2 * unit.deg / unit.s**2), assembly="open")
    plain = press.solve(theta=(kin.deg(30), kin.rpm(300), kin.deg(2)), assembly="open")
    for order in range(5):
        assert pose.s.derivative(order) == pytest.approx(plain.s.derivative(order), rel=1e-12)
    turn = press.sweep(theta=(0 * unit.deg, 360 * unit.deg), speed=300 * unit.rpm, assembly="open")
    expected = press.sweep(theta=(0, kin.deg(360)), speed=kin.rpm(300), assembly="open")
    assert turn.of("s_jerk").peak().value == pytest.approx(expected.of("s_jerk").peak().value, rel=1e-12)


def test_arrays():
    angles = np.linspace(0, 360, 50)
    cranks, motion = unit.Quantity([[50.0], [100.0]], "mm"), (unit.Quantity(angles, "deg"), 3 * unit.rpm)
    batch = CRANK.solve_batch(r=cranks, l=0.3, theta=motion, assembly="open")
    plain = CRANK.solve_batch(r=[[0.05], [0.1]], l=0.3, theta=(kin.deg(angles), kin.rpm(3)), assembly="open")
    assert np.allclose(batch.s.snap, plain.s.snap, rtol=1e-12)


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: CRANK(r=1 * unit.kg, l=1), "`r` is 1 kilogram: give a length"),
        (lambda: CRANK(r=1 * unit.deg, l=1), "`r` is 1 degree: give a length"),
        (lambda: CRANK(r=1, l=3).solve(theta=1 * unit.mm, assembly="open"), "`theta` is 1 millimeter: give an angle"),
        (
            lambda: CRANK(r=1, l=3).solve(theta=(1, 1 * unit.deg), assembly="open"),
            "`theta` is 1 degree: give an angle by time",
        ),
        (
            lambda: CRANK(r=1, l=3).solve_batch(theta=unit.Quantity([1, 2], "s"), assembly="open"),
            "`theta` is .1 2. second: give an angle",
        ),
    ],
)
def test_other_measures_are_refused(call, message):
    with pytest.raises(TypeError, match=message):
        call()
