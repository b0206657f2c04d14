"""Poses, and what cannot be solved."""

import math
import pickle

import numpy as np
import pytest

import kin


@pytest.fixture
def linkage():
    return kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)


def test_a_pose_has_attributes(linkage):
    pose = linkage.solve(theta2=[1.0, 10.0], assembly="open")
    assert pose.theta2.derivatives == [1.0, 10.0, 0.0, 0.0, 0.0]
    theta4 = pose.theta4
    assert theta4.derivatives == [theta4.position, theta4.velocity, theta4.acceleration, theta4.jerk, theta4.snap]
    assert float(theta4) == theta4.position == math.fabs(theta4)
    assert pose["theta4"].snap == theta4.snap
    assert pose.linkage == linkage
    assert pose.assembly == "open"
    assert {"theta2", "theta3", "theta4", "jacobian"} < set(dir(pose))
    assert pose.unknowns == {"theta3": pose.theta3.position, "theta4": pose.theta4.position}
    angles = pose.transmission_angles()
    assert list(angles) == ["theta3, theta4"]
    assert abs(angles["theta3, theta4"] - (pose.theta4.position - pose.theta3.position)) < 1e-14


def test_inputs_in_any_form(linkage):
    expected = linkage.solve(theta2=[1.0, 10.0], assembly="open").theta4.derivatives
    for theta2 in [(1, 10), np.array([1.0, 10.0]), [np.float64(1), np.int32(10)], np.array([1, 10]), [1, 10, 0, 0, 0]]:
        assert linkage.solve(theta2=theta2, assembly="open").theta4.derivatives == expected


def test_an_order_that_the_declaration_has_not():
    mechanism = kin.Mechanism(
        "struct Crank { r: Length } input theta: Angle; unknown x: Length; order = 1; x == r * cos(theta);"
    )
    pose = mechanism(r=1).solve(theta=[0.5, 1.0])
    assert pose.x.velocity == -math.sin(0.5)
    with pytest.raises(AttributeError, match="`x` has no jerk: it has 1 derivatives here"):
        pose.x.jerk
    with pytest.raises(ValueError, match="`theta` has 3 numbers"):
        mechanism(r=1).solve(theta=[0.5, 1.0, 2.0])


def test_points_have_coordinates():
    linkage, at = kin.library.example("five_bar")
    hand = linkage.solve(**at).hand
    assert hand.position.tolist() == [hand.x.position, hand.y.position]
    assert isinstance(hand.x.position, float)
    assert hand.x.name == "hand.x"
    with pytest.raises(AttributeError, match="`hand` is no point in space"):
        hand.z
    with pytest.raises(TypeError, match="more than one number"):
        float(hand)


def test_points_in_space():
    linkage, at = kin.library.example("rssr")
    pose = linkage.solve(**at)
    points = [name for name in linkage.mechanism.outputs if np.ndim(pose[name].position) == 1]
    for name in points:
        assert pose[name].z.position == pose[name].position[2]


@pytest.mark.parametrize(
    "arguments, error, message",
    [
        ({"theta2": 1.0}, TypeError, 'write assembly="open" or assembly="crossed"'),
        ({"theta2": 1.0, "assembly": "opne"}, ValueError, 'no assembly is called "opne": write assembly="open"'),
        ({"theta2": 1.0, "assembly": 0}, TypeError, "`assembly` is a name"),
        ({"theta2": 1.0, "assembly": "open", "near": [0, 0]}, TypeError, "and not both"),
        ({"theta2": 1.0, "near": [0]}, ValueError, "`near` has 1 numbers: give one for each of theta3, theta4"),
        ({"theta2": 1.0, "near": 3}, TypeError, "`near` is a pose, a dictionary of unknowns"),
        ({"theta2": 1.0, "near": {"theta3": 1}}, TypeError, "missing: unknown `theta4`"),
        ({"assembly": "open"}, TypeError, "missing: input `theta2`"),
        ({"theta2": 1, "theta3": 1, "assembly": "open"}, TypeError, "no input is called `theta3`: inputs are theta2"),
        ({"theta2": [], "assembly": "open"}, ValueError, "`theta2` has 0 numbers"),
        ({"theta2": [1] * 6, "assembly": "open"}, ValueError, "`theta2` has 6 numbers"),
        ({"theta2": "1", "assembly": "open"}, TypeError, "`theta2`: must be real number, not str"),
        ({"theta2": {1: 2}, "assembly": "open"}, (TypeError, KeyError), ""),
    ],
)
def test_mistakes_in_a_call(linkage, arguments, error, message):
    with pytest.raises(error) as caught:
        linkage.solve(**arguments)
    assert message in str(caught.value)


def test_out_of_reach():
    linkage = kin.library.four_bar(r1=90, r2=30, r3=60, r4=45)
    with pytest.raises(kin.SolveError) as caught:
        linkage.solve(theta2=3.0, assembly="open")
    error = caught.value
    assert error.kind == "out of reach"
    assert error.block == "theta3, theta4"
    assert error.inputs == {"theta2": 3.0}
    # the distance of the pins, and both links on one line
    assert abs(error.margin - (105 - math.hypot(90 - 30 * math.cos(3.0), 30 * math.sin(3.0)))) < 1e-12
    assert "theta3, theta4 cannot be found at theta2 = 3 rad (171.9°): out of reach" in str(error)
    assert isinstance(error, kin.KinError) and isinstance(error, ValueError)
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.margin, again.inputs) == (str(error), error.margin, error.inputs)


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_numbers_that_are_not_finite(linkage, value):
    for solve in [
        lambda: linkage.solve(theta2=value, assembly="open"),
        lambda: linkage.solve(theta2=[1.0, value], assembly="open"),
        lambda: kin.library.four_bar(r1=value, r2=30, r3=70, r4=60).solve(theta2=1.0, assembly="open"),
    ]:
        with pytest.raises(kin.SolveError) as caught:
            solve()
        assert caught.value.kind == "not finite" and caught.value.margin is None


def test_near_a_pose(linkage):
    pose = linkage.solve(theta2=0.0, assembly="crossed")
    for step in range(1, 100):
        pose = linkage.solve(theta2=0.1 * step, near=pose)
        assert pose.assembly == "crossed"
    near = {"theta3": pose.theta3.position + 4 * math.pi, "theta4": pose.theta4.position}
    assert abs(linkage.solve(theta2=9.9, near=near).theta3.position - near["theta3"]) < 1e-12
    assert linkage.solve(theta2=9.9, near=list(near.values())).unknowns == linkage.solve(theta2=9.9, near=near).unknowns
    with pytest.raises(ValueError, match="`near` is a pose of SliderCrank, and not of FourBar"):
        linkage.solve(theta2=1.0, near=kin.library.slider_crank(r=1, l=3).solve(theta=1.0, assembly="open"))


def test_coupled_blocks():
    linkage, at = kin.library.example("stephenson_ii")
    assert linkage.assemblies == ()
    pose = linkage.solve(**at)
    assert pose.assembly is None
    with pytest.raises(TypeError, match="positions of StephensonII are chosen by values of the unknowns, as in `near="):
        linkage.solve(**{name: value for name, value in at.items() if name != "near"})
    found = linkage.positions(**{name: at[name] for name in linkage.mechanism.inputs})
    assert any(
        all(abs(math.remainder(other[name].position - pose[name].position, math.tau)) < 1e-9 for name in pose.unknowns)
        for other in found
    )


def test_all_positions(linkage):
    assert [pose.assembly for pose in linkage.positions(theta2=[1.0, 10.0])] == ["open", "crossed"]
    assert linkage.positions(theta2=[1.0, 10.0])[0].theta4.velocity != 0
    assert kin.library.four_bar(r1=90, r2=30, r3=60, r4=45).positions(theta2=3.0) == []


def test_degrees_and_revolutions():
    assert kin.deg(180) == math.pi
    assert kin.deg((90.0, 180.0)) == (math.pi / 2, math.pi)
    assert kin.deg([90.0, 180.0]).tolist() == [math.pi / 2, math.pi]
    assert kin.deg(np.array([[90.0]])).shape == (1, 1)
    assert abs(kin.rpm(30) - math.pi) < 1e-15


def test_a_motion_is_followed():
    linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
    pose = linkage.solve(theta2=0.0, assembly="open")
    after = pose.track_to(theta2=(math.tau, 10.0))
    assert after.theta4.position == pytest.approx(pose.theta4.position, abs=1e-12)
    assert after.theta4.snap == pytest.approx(linkage.solve(theta2=(0.0, 10.0), assembly="open").theta4.snap)
    # the search follows even where no assembly has a name
    linkage, at = kin.library.example("stephenson_ii")
    [name] = linkage.mechanism.inputs
    start = linkage.solve(**at)
    there = start.track_to(**{name: at[name] + 0.05})
    back = there.track_to(**{name: at[name]})
    assert back.unknowns == pytest.approx(start.unknowns, abs=1e-10)


def test_a_motion_ends_at_a_limit():
    linkage = kin.library.four_bar(r1=90, r2=30, r3=60, r4=45)
    pose = linkage.solve(theta2=0.0, assembly="open")
    limit = math.acos((90**2 + 30**2 - 105**2) / (2 * 90 * 30))
    with pytest.raises(kin.TrackError) as caught:
        pose.track_to(theta2=2.5)
    error = caught.value
    assert error.kind == "limit position" and error.inputs["theta2"] == pytest.approx(limit, abs=1e-6)
    assert error.fraction == pytest.approx(limit / 2.5, abs=1e-6) and set(error.unknowns) == {"theta3", "theta4"}
    again = pickle.loads(pickle.dumps(error))
    assert (str(again), again.inputs) == (str(error), error.inputs)
    with pytest.raises(kin.TrackError, match="change point") as caught:
        kin.library.four_bar(r1=2, r2=1, r3=2, r4=1).solve(theta2=1.0, assembly="open").track_to(theta2=5.0)
    assert caught.value.kind == "change point"
