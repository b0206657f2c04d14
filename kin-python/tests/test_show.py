"""What a notebook shows."""

import html
import math
import re
import subprocess
import sys

import numpy as np
import pytest

import kin

pyplot = pytest.importorskip("matplotlib.pyplot")
pyplot.switch_backend("agg")


@pytest.fixture
def linkage():
    return kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)


@pytest.fixture
def turn(linkage):
    return linkage.sweep(theta2=(0, math.tau), speed=10.0, assembly="open")


@pytest.fixture(autouse=True)
def figures_are_closed():
    yield
    pyplot.close("all")


def cells(shown):
    """The texts of all cells of tables, row by row."""
    rows = re.findall(r"<tr>(.*?)</tr>", shown)
    return [[html.unescape(cell) for cell in re.findall(r"<t[hd]>(.*?)</t[hd]>", row)] for row in rows]


def test_a_mechanism_shows_its_equations(linkage):
    shown = linkage.mechanism._repr_html_()
    assert "<math" in shown and ["dimensions", "r1, r2, r3, r4"] in cells(shown)


def test_a_linkage_shows_its_page(linkage):
    assert linkage._repr_html_() == linkage.report()._repr_html_()
    # two inputs, and nothing closes where both are zero
    assert kin.library.four_bar(r1=900, r2=30, r3=70, r4=60)._repr_html_() is None


def test_a_sweep_shows_its_extremes(turn):
    rows = cells(turn._repr_html_())
    assert rows[0] == ["quantity", "lowest", "at theta2 [deg]", "highest", "at theta2 [deg]"]
    jerk = turn.of("theta4_jerk")
    [shown] = [row for row in rows if row[0] == "theta4_jerk [deg/s³]"]
    expected = [math.degrees(number) for end in (jerk.lowest(), jerk.highest()) for number in (end.value, end.at)]
    assert [float(number.replace("−", "-")) for number in shown[1:]] == pytest.approx(expected, rel=1e-5)


def test_a_sweep_shows_its_limits():
    swing = kin.library.four_bar(r1=90, r2=30, r3=60, r4=45).sweep(theta2=(0, 3), assembly="open")
    rows = cells(swing._repr_html_())
    assert ["limit position", "112.024", "theta3, theta4"] in rows
    [velocity] = [row for row in rows if row[0].startswith("theta4_velocity")]
    assert "bounds" in velocity[1]


def test_a_sweep_over_time(linkage):
    law = kin.rise("cycloidal", 0, 1, 0.5)
    assert "at time [s]" in cells(linkage.sweep(theta2=law, assembly="open")._repr_html_())[0]


def test_a_cycle_shows_branches_and_strokes(linkage):
    rows = cells(linkage.cycle()._repr_html_())
    assert ["0", "0", "open", "−202.249", "157.751", "yes"] in rows
    assert ["0", "theta4 [deg]", "99.0564", "159.258", "60.2016"] in rows


def test_forces_show_both_bodies():
    pendulum, loads = pendulum_with_loads()
    rows = cells(pendulum.forces(loads, theta=0.0)._repr_html_())
    assert ["ground_arm", "arm", "ground", "0", "19.62", "0", "19.62"] in rows


def pendulum_with_loads():
    pendulum = kin.Mechanism(
        """
        struct Pendulum { length: Length }
        input theta: Angle;
        unknown x: Length;
        x == length * cos(theta);
        output bob: Point = length * cis(theta);
        ground 0;
        body arm: 0, bob;
        """
    )(length=0.4)
    return pendulum, pendulum.loads().gravity((0, -9.81)).mass(2.0, "bob")


def test_a_plot_has_degrees_and_units(turn):
    axes = turn.plot("theta4", "theta4.jerk")
    assert [axis.get_ylabel() for axis in axes] == ["theta4 [deg]", "theta4_jerk [deg/s³]"]
    assert axes[1].get_xlabel() == "theta2 [deg]"
    [line] = axes[1].lines
    table = turn.table().in_degrees()
    assert np.allclose(line.get_xdata(), table["theta2"]) and np.allclose(line.get_ydata(), table["theta4_jerk"])
    assert len(turn.plot()) == 2    # both unknowns


def test_plots_of_one_quantity(turn):
    axis = turn.plot("theta4")
    assert len(axis.lines) == 1
    assert turn.of("theta3").plot(ax=axis) is axis and len(axis.lines) == 2
    assert turn.of_transmission_angle().plot().get_ylabel() == "transmission angle [deg]"
    both = pyplot.figure().subplots()
    assert turn.plot("theta3", "theta4.jerk", ax=both) is both
    assert [text.get_text() for text in both.get_legend().get_texts()] == ["theta3 [deg]", "theta4_jerk [deg/s³]"]
    with pytest.raises(ValueError, match="there are 2 quantities and 1 axes"):
        turn.plot("theta3", "theta4", ax=[axis])
    with pytest.raises(kin.AnswerError, match="theta5"):
        turn.plot("theta5")


def test_plots_of_forces():
    pendulum, loads = pendulum_with_loads()
    turn = pendulum.sweep(theta=(0, math.tau), speed=3.0)
    force, effort, power = turn.of_reaction(loads, "ground_arm"), turn.of_effort(loads), turn.of_power(loads)
    labels = [axis.get_ylabel() for axis in turn.plot(force, effort, power, length="m")]
    assert labels == ["force in ground_arm [N]", "effort of theta [N·m]", "power of theta [W]"]
    labels = [axis.get_ylabel() for axis in turn.plot(force, effort, power, "x", length="mm", force="N")]
    assert labels == ["force in ground_arm [N]", "effort of theta [N·mm]", "power of theta [N·mm/s]", "x [mm]"]
    # units that are not named are left out
    assert turn.plot(effort).get_ylabel() == "effort of theta"


def test_matplotlib_is_imported_late():
    program = "import sys, kin; kin.library.example('four_bar')[0].cycle(); print('matplotlib' in sys.modules)"
    printed = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True)
    assert printed.stdout.strip() == "False"
