"""Sweeps, tables, cycles, pages and code."""

import html
import math
import subprocess
import sys
import threading
import types

import numpy as np
import pytest

import kin


@pytest.fixture
def linkage():
    return kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)


@pytest.fixture
def turn(linkage):
    return linkage.sweep(theta2=(0, math.tau), rows=361, speed=10.0, assembly="open")


def test_peaks_are_those_of_a_fine_batch(linkage, turn):
    angles = np.linspace(0, math.tau, 1_000_001)
    jerk = linkage.solve_batch(theta2=(angles, 10.0), assembly="open").theta4.jerk
    highest, lowest = turn.of("theta4_jerk").highest(), turn.of("theta4_jerk").lowest()
    for found, index in [(highest, jerk.argmax()), (lowest, jerk.argmin())]:
        # a parabola about the extreme: the grid is off by its square
        assert abs(found.at - angles[index]) < 1e-5
        assert abs(found.value - jerk[index]) < 1e-6 * abs(jerk[index])
        assert found.kind == "inner"
    peak = turn.of("theta4_jerk").peak()
    assert peak == max(highest, lowest, key=lambda found: abs(found.value))


def test_extremes_crossings_dwells_and_means(turn):
    theta4 = turn.of("theta4")
    extremes = theta4.extremes()
    assert sorted(extreme.is_maximum for extreme in extremes if extreme.kind == "inner") == [False, True]
    middle = theta4.mean()
    assert middle.covered == 1.0 and middle.error < 1e-8
    crossings = theta4.crossings(middle.value)
    assert [crossing.is_rising for crossing in crossings] in ([True, False], [False, True])
    assert abs(turn.of("theta4_velocity").mean().value) < 1e-9
    assert turn.of("theta4_velocity").rms(over="input").value > 0
    highest = theta4.highest()
    [dwell] = theta4.dwells(highest.value, 0.01)
    assert dwell.start < highest.at < dwell.end
    assert abs(dwell.duration - (dwell.end - dwell.start) / 10) < 1e-9
    assert theta4.column().shape == (361,)


def test_sensitivities_of_a_peak(linkage, turn):
    found = turn.of("theta4_jerk").peak_sensitivities()
    assert found.peak == turn.of("theta4_jerk").peak()
    step = 1e-4
    ends = []
    for sign in (1, -1):
        other = kin.library.four_bar(r1=90, r2=30 + sign * step, r3=70, r4=60)
        sweep = other.sweep(theta2=(0, math.tau), rows=361, speed=10.0, assembly="open")
        ends.append(sweep.of("theta4_jerk").peak().value)
    assert math.isclose(found.by["r2"].value, (ends[0] - ends[1]) / (2 * step), rel_tol=1e-6)


def test_transmission_angle(turn):
    worst = turn.of_transmission_angle().lowest()
    # with the crank towards the ground: a triangle of 60, 70 and 60
    # where the pins are farthest apart, 120, or closest, 60: the law of cosines in the triangle of the dyad
    ends = [math.acos((70**2 + 60**2 - distance**2) / (2 * 70 * 60)) for distance in (120, 60)]
    assert math.isclose(worst.value, min(min(end, math.pi - end) for end in ends), rel_tol=1e-9)
    with pytest.raises(ValueError, match="FourBar has 1 dyads"):
        turn.of_transmission_angle(1)


def test_a_table(linkage, turn):
    table = turn.table()
    assert len(table) == len(turn) == 361 and table.solved.all() and table.limits == []
    assert table.names[:2] == ("theta2", "theta2_velocity") and "theta4_snap" in table
    assert list(table) == list(table.names) == list(table.to_dict())
    batch = linkage.solve_batch(theta2=(table["theta2"], 10.0), assembly="open")
    for order, rate in enumerate(("velocity", "acceleration", "jerk", "snap"), 1):
        assert (table[f"theta4_{rate}"] == batch.theta4.derivative(order)).all()
    assert table.units["theta4_jerk"] == "rad/T³"
    degrees = table.in_degrees().in_units("mm", "s")
    assert degrees.units["theta4_jerk"] == "deg/s³"
    assert np.allclose(degrees["theta4"], np.degrees(table["theta4"]), rtol=1e-15)
    with pytest.raises(KeyError, match="theta4_jerk"):
        table["theta4_jrek"]
    assert "<th>theta4_jerk [rad/T³]</th>" in table._repr_html_()
    assert table._repr_html_().count("<tr>") == 12


def test_a_table_for_pandas_and_polars(turn):
    table = turn.table()
    pandas, polars = pytest.importorskip("pandas"), pytest.importorskip("polars")
    for frame, kind in [(table.to_pandas(), pandas.DataFrame), (table.to_polars(), polars.DataFrame)]:
        assert isinstance(frame, kind)
        assert tuple(frame.columns) == table.names
        assert (np.asarray(frame["theta4_jerk"]) == table["theta4_jerk"]).all()


def test_a_table_for_arrow(turn):
    pyarrow, polars = pytest.importorskip("pyarrow"), pytest.importorskip("polars")
    table = turn.table()
    for frame in (pyarrow.table(table), polars.DataFrame(table)):
        names = frame.column_names if isinstance(frame, pyarrow.Table) else frame.columns
        assert tuple(names) == table.names
        assert (np.asarray(frame["theta4_jerk"]) == table["theta4_jerk"]).all()
    # a capsule that nobody reads frees its columns
    for _ in range(100):
        table.__arrow_c_stream__()


def test_names_with_a_dot(linkage, turn):
    assert turn.of("theta4.jerk").peak() == turn.of("theta4_jerk").peak()
    assert (turn.table()["theta4.jerk"] == turn.table()["theta4_jerk"]).all() and "theta4.jerk" in turn.table()
    assert linkage.cycle().peak("theta4.velocity") == linkage.cycle().peak("theta4_velocity")
    assert turn.of("theta4.jerk").name == "theta4_jerk" and turn.of("theta4.jerk").order == 3
    assert turn.variable == "theta2" and (turn.at == turn.table()["theta2"]).all()


def test_limits_of_a_table():
    linkage = kin.library.four_bar(r1=90, r2=30, r3=60, r4=45)
    table = linkage.sweep(theta2=(-3, 3), rows=601, assembly="open").table()
    # the distance of the pins is that of both links on one line: the law of cosines
    limit = math.acos((90**2 + 30**2 - 105**2) / (2 * 90 * 30))
    assert [found.at for found in table.limits] == pytest.approx([-limit, limit], abs=1e-12)
    assert table.limits[1].kind == "limit position" and table.limits[1].closes_before
    assert table.limits[0].block == "theta3, theta4"
    assert (table.solved == np.isnan(table.margin)).all()
    assert (np.isnan(table["theta4"]) == ~table.solved).all()


def test_laws(linkage):
    law = kin.rise("modified sine", 0.0, 1.5, 0.2) + kin.dwell(1.5, 0.1)
    assert law.duration == pytest.approx(0.3)
    table = linkage.sweep(theta2=law, rows=31, assembly="open").table()
    assert table["theta2"][[0, -1]].tolist() == [0.0, 1.5]
    assert abs(table["theta2_velocity"]).max() == pytest.approx(1.7596 * 1.5 / 0.2, rel=1e-2)
    assert abs(table["theta4_velocity"][25]) == 0.0
    with pytest.raises(ValueError, match='no shape of a rise is called "sine": there are "constant speed"'):
        kin.rise("sine", 0, 1, 1)
    for wrong in (0.0, -1.0, math.nan):
        with pytest.raises(ValueError, match="duration"):
            kin.rise("cycloidal", 0, 1, wrong)
    with pytest.raises(TypeError, match="leave out `speed`"):
        linkage.sweep(theta2=law, speed=1.0, assembly="open")
    jump = kin.dwell(0.0, 0.1) + kin.dwell(1.0, 0.1)
    with pytest.raises(kin.AnswerError, match="theta2"):
        linkage.sweep(theta2=jump, assembly="open").table()


def test_every_kind_of_law():
    for law, state in [
        (kin.constant_speed(1.0, 20.0, 0.5), (6.0, 20.0, 0.0, 0.0, 0.0)),
        (kin.s_curve(0.0, 1.0, velocity=2.0, acceleration=10.0, jerk=200.0, snap=1e6), None),
        (kin.rise((0.0, 1.0, 0.0), 0.0, 1.0, 0.5), (0.5, 4.0, None, None, None)),
        (kin.polynomial((0, 0, 0, 0), (10, 5, 0, 0), 0.5), None),
        # 5 + 2 cos ωt + sin 2ωt in the middle of its period
        (kin.fourier(5.0, [(2.0, 0.0), (0.0, 1.0)], 0.5), (3.0, 8 * math.pi, None, None, None)),
    ]:
        assert len(law.at(0.0)) == 5 and math.isfinite(law.duration)
        for found, expected in zip(law.at(0.25), state or ()):
            assert expected is None or found == pytest.approx(expected, abs=1e-9)
    # the trapezoid of the jerk takes 0.5 s at full speed, 0.2 s of acceleration, and 0.05 s until it is reached
    assert kin.s_curve(0, 1, velocity=2, acceleration=10, jerk=200).duration == pytest.approx(0.75)
    assert kin.polynomial((0, 0, 0), (10, 5, 0), 2.0).at(2.0)[:3] == pytest.approx((10, 5, 0))
    # a law at the end of another one
    assert (kin.constant_speed(0, 1, 1) + kin.dwell(1, 1)).at(1.5) == (1, 0, 0, 0, 0)
    for wrong, message in [
        (lambda: kin.rise((0.5, 0.5, 0.5), 0, 1, 1), "share"),
        (lambda: kin.s_curve(0, 0, velocity=1, acceleration=1, jerk=1), "0"),
        (lambda: kin.s_curve(0, 1, velocity=-1, acceleration=1, jerk=1), "velocity"),
        (lambda: kin.polynomial((0, 0), (1,), 1), "a state is the value"),
        (lambda: kin.fourier(0, [(1, 0)] * 17, 1), "there are 17 harmonics: give 16 at most"),
    ]:
        with pytest.raises(ValueError, match=message):
            wrong()


def test_several_inputs():
    linkage, at = kin.library.example("five_bar")
    way = linkage.sweep(alpha=(at["alpha"], at["alpha"] + 0.5), beta=at["beta"], rows=11, assembly="open")
    table = way.table()
    assert (table["beta"] == at["beta"]).all() and (table["beta_velocity"] == 0).all()
    law = kin.rise("cycloidal", at["alpha"], at["alpha"] + 0.5, 1.0)
    under_law = linkage.sweep(alpha=law, beta=at["beta"], rows=11, assembly="open").table()
    assert under_law["hand.x"][-1] == pytest.approx(table["hand.x"][-1], rel=1e-12)
    with pytest.raises(ValueError, match="`beta` has two ends beside the law of another input"):
        linkage.sweep(alpha=law, beta=(0, 1), assembly="open")
    with pytest.raises(ValueError, match="`beta` has 3 numbers: give the two ends of its way"):
        linkage.sweep(alpha=0, beta=(0, 1, 2), assembly="open")


@pytest.mark.parametrize(
    "ask, message",
    [
        (lambda sweep: sweep.of("theta4_jrek").peak(), "theta4_jerk"),
        (lambda sweep: sweep.of("theta4").crossings(math.nan), "level"),
        (lambda sweep: sweep.of("theta4").mean(over="way"), 'over="time" or over="input"'),
    ],
)
def test_questions_without_an_answer(turn, ask, message):
    with pytest.raises(ValueError, match=message):
        ask(turn)


def test_sweeps_that_cannot_be(linkage):
    for arguments in [{"theta2": (0, math.nan)}, {"theta2": (0, 1), "speed": 0.0}, {"theta2": (0, 1), "rows": 0}]:
        with pytest.raises(kin.AnswerError):
            linkage.sweep(**arguments, assembly="open").table()
    never = kin.library.four_bar(r1=900, r2=30, r3=70, r4=60).sweep(theta2=(0, 1), assembly="open")
    assert not never.table().solved.any()
    with pytest.raises(kin.AnswerError) as caught:
        never.of("theta4").peak()
    assert isinstance(caught.value.__cause__, kin.SolveError)
    unbounded = kin.library.four_bar(r1=90, r2=30, r3=60, r4=45).sweep(theta2=(0, 3), assembly="open")
    with pytest.raises(kin.AnswerError) as caught:
        unbounded.of("theta4_velocity").peak()
    assert caught.value.at == pytest.approx(math.acos((90**2 + 30**2 - 105**2) / (2 * 90 * 30)))


def test_a_cycle(linkage):
    cycle = linkage.cycle()
    assert cycle.is_complete and cycle.moving == "theta2" and len(cycle.circuits) == 2
    for index, circuit in enumerate(cycle.circuits):
        assert circuit.is_closed and abs(circuit.input_revolutions) == 1
        assert [cycle.branches[branch].circuit for branch in circuit.branches] == [index]
    assert {branch.assembly for branch in cycle.branches} == {"open", "crossed"}
    stroke = cycle.stroke("theta4")
    # the dead centres: crank and coupler on one line, 100 and 40 from pin to pin
    ends = [math.acos((90**2 + 60**2 - length**2) / (2 * 90 * 60)) for length in (100, 40)]
    assert stroke.length == pytest.approx(ends[0] - ends[1], abs=1e-12)
    assert cycle.peak("theta4_velocity").value != 0
    assert cycle.time_ratio("theta4") > 0
    assert cycle.worst_transmission().block == "theta3, theta4"
    pose = cycle.pose(0, 1.0, speed=10.0)
    assert pose.theta2.velocity == 10.0 and pose.assembly == cycle.branches[0].assembly
    for ask in (lambda: cycle.stroke("theta4", circuit=2), lambda: cycle.pose(5, 1.0)):
        with pytest.raises(IndexError):
            ask()
    with pytest.raises(kin.AnswerError):
        cycle.stroke("theta5")


def test_a_cycle_lives_longer_than_its_mechanism():
    cycle = kin.Mechanism(kin.library.four_bar.text)(r1=90, r2=30, r3=70, r4=60).cycle()
    expected = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60).cycle().stroke("theta4")
    found = []
    threads = [threading.Thread(target=lambda: found.append(cycle.stroke("theta4"))) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [expected] * 8


def test_a_cycle_over_one_of_several_inputs():
    linkage, at = kin.library.example("five_bar")
    with pytest.raises(TypeError, match="which input is meant\\? there are alpha, beta"):
        linkage.cycle(alpha=1.0)
    with pytest.raises(TypeError, match="missing: input `beta`"):
        linkage.cycle(moving="alpha")
    with pytest.raises(TypeError, match="`alpha` moves: leave out its value"):
        linkage.cycle(moving="alpha", alpha=1.0, beta=1.0)
    with pytest.raises(TypeError, match="inputs are alpha, beta"):
        linkage.cycle(moving="alpha", beta=1.0, gamma=1.0)
    cycle = linkage.cycle(moving="alpha", beta=at["beta"])
    [branch, *_] = [branch for branch in cycle.branches if branch.range[0] < at["alpha"] < branch.range[1]]
    pose = cycle.pose(cycle.branches.index(branch), at["alpha"])
    assert pose.beta.position == at["beta"]


def test_a_page(linkage, tmp_path):
    page = linkage.report(speed=10.0, length="mm", title="Press <1>")
    assert page.html.startswith("<!doctype html>") and "Press &lt;1&gt;" in page.html
    page.write(tmp_path / "press.html")
    assert (tmp_path / "press.html").read_text(encoding="utf-8") == page.html
    shown = page._repr_html_()
    assert shown.startswith('<iframe srcdoc="')
    assert html.unescape(shown.split('"')[1]) == page.html
    with pytest.raises(OSError):
        page.write(tmp_path / "no" / "folder.html")
    with pytest.raises(kin.AnswerError):
        linkage.report(moving="theta5")


def test_code(linkage, tmp_path):
    c = linkage.to_c()
    for file, text in [(f"{c.name}.h", c.header), (f"{c.name}.c", c.source), ("main.c", c.example)]:
        (tmp_path / file).write_text(text)
    command = ["cc", "-std=c99", "-ffp-contract=off", "main.c", f"{c.name}.c", "-lm", "-o", "main"]
    subprocess.run(command, cwd=tmp_path, check=True)
    # the inputs with all orders, and 1 for the assembly "open"
    printed = subprocess.run([tmp_path / "main"], input="1 10 0 0 0 1", check=True, capture_output=True, text=True)
    words = printed.stdout.split()
    found = dict(zip(words[::2], map(float, words[1::2])))
    pose = linkage.solve(theta2=(1.0, 10.0), assembly="open")
    assert found["theta4"] == pose.theta4.position and found["theta4_snap"] == pose.theta4.snap

    module = types.ModuleType("solver")
    sys.modules["solver"] = module
    exec(linkage.to_python(), vars(module))
    theta4 = module.solve({}, {"theta2": [1.0, 10.0]}, module.OPEN).theta4
    assert np.allclose(theta4.ravel(), pose.theta4.derivatives, rtol=1e-13)

    assert "r2 = 30.0" in c.header and "The dimensions are arguments" in linkage.mechanism.to_c(order=1).header
    assert len(linkage.to_javascript()) > len(linkage.to_javascript(order=1)) > 1000


def test_an_exact_table(linkage, turn):
    tolerances = np.array([1e-10, 1e-8, 1e-6, 1e-4])
    table = turn.exact_table(tolerances.tolist())
    assert table.names == ("theta3", "theta4") and table.range == (0.0, math.tau) and len(table) == table.rows
    for angle in np.linspace(0, 6.28, 100):
        pose = linkage.solve(theta2=(angle, 10.0), assembly="open")
        found = table.at(angle, speed=10.0)
        expected = np.array([pose.theta3.derivatives, pose.theta4.derivatives])[:, :4]
        # the tolerance of each order by the input, relative to its size, times the power of the speed
        assert (np.abs(found - expected) <= 10 * tolerances * 10.0 ** np.arange(4)).all()
    again = kin.ExactTable(bytes(table))
    assert again.at(1.0).tobytes() == table.at(1.0).tobytes()
    for wrong in (b"", b"kin", bytes(table)[:-1], bytes(1000)):
        with pytest.raises(ValueError):
            kin.ExactTable(wrong)
    with pytest.raises(ValueError):
        table.at(math.nan)
    with pytest.raises(kin.AnswerError, match="rounding is in the way"):
        turn.exact_table(1e-9)
    with pytest.raises(ValueError, match="give one tolerance, or a list"):
        turn.exact_table([])
    for tolerance in (0.0, -1.0, math.nan):
        with pytest.raises(kin.AnswerError):
            turn.exact_table(tolerance)
