"""Loads, and the forces that they cause, beside closed forms."""

import math

import pytest

import kin

PUMP = """
    /// Slider-crank in metres.
    struct Pump { r: Length, l: Length }
    input theta: Angle;
    unknown phi: Angle, s: Length;
    r * cis(theta) + l * cis(phi) == vec2(s, 0);
    output pin: Point = r * cis(theta);
    output piston: Point = vec2(s, 0);
    ground 0;
    body crank: 0, pin;
    body rod: pin, piston;
    slide piston along vec2(1, 0);
"""
R, L, MASS, SPEED = 0.05, 0.15, 0.8, kin.rpm(900)


@pytest.fixture
def pump():
    return kin.Mechanism(PUMP)(r=R, l=L)


@pytest.fixture
def turn(pump):
    return pump.sweep(theta=(0, math.tau), speed=SPEED, assembly="open")


def test_inertia_of_a_piston(pump, turn):
    loads = pump.loads().mass(MASS, "piston")
    # at the dead centre it is slowed down by r ω² (1 + r / l), and the rod lies along the slide
    largest = MASS * R * SPEED**2 * (1 + R / L)
    peak = turn.of_reaction(loads, "pin").peak()
    assert peak.value == pytest.approx(largest, rel=1e-9)
    forces = pump.forces(loads, theta=(0.0, SPEED), assembly="open")
    assert forces.joints["pin"].magnitude == pytest.approx(largest, rel=1e-12)
    assert abs(forces.joints["pin"].x) == pytest.approx(largest, rel=1e-12)
    # the rod pulls the piston back, and so the crank's pin pulls the rod
    assert (forces.joints["pin"].on, forces.joints["pin"].by) == ("rod", "crank") and forces.joints["pin"].x < 0
    assert abs(forces.efforts["theta"]) < 1e-9
    assert turn.of_power(loads).mean().value == pytest.approx(0.0, abs=1e-8)


def test_a_force_on_a_piston(pump, turn):
    by_torque = pump.loads().torque(-200.0, "s")
    by_force = pump.loads().force((-200.0, 0.0), "piston")
    for theta in (0.3, 1.2, 4.0):
        pose = pump.solve(theta=theta, assembly="open")
        # virtual work: the effort times the way of the crank is the force times that of the piston
        expected = 200.0 * pose.jacobian()[pose.rows.index("s"), 0]
        for loads in (by_torque, by_force):
            efforts = pump.forces(loads, theta=theta, assembly="open").efforts
            assert efforts["theta"] == pytest.approx(expected, rel=1e-12)
    effort, power = turn.of_effort(by_force), turn.of_power(by_force, "theta")
    assert power.highest().value == pytest.approx(SPEED * effort.highest().value, rel=1e-12)
    assert turn.of_effort(by_force, order=1).column().shape == (361,)


def test_every_kind_of_load(pump):
    loads = pump.loads()
    assert set(loads.points) == {"pin", "piston"} and set(loads.bodies) == {"crank", "rod"}
    assert set(loads.angles) == {"theta", "phi", "s"}
    for more in (
        loads.gravity((0, -9.81)).mass_of("rod", 0.4, (L / 2, 0), 1e-3),
        loads.gravity((0, -9.81)).mass_of("crank", 0.4, "pin", 1e-3),
        loads.inertia(1e-3, "phi"),
        loads.spring(1e4, 0.1, (0.3, 0.0), "piston"),
        loads.damper(10.0, "piston", (0.3, 0.0, 0.0)),
    ):
        assert pump.forces(more, theta=(1.0, SPEED), assembly="open").efforts["theta"] != 0.0
    assert pump.forces(loads, theta=(1.0, SPEED), assembly="open").efforts["theta"] == 0.0


def test_sensitivities_of_a_force(pump, turn):
    loads = pump.loads().mass(MASS, "piston")
    found = turn.of_reaction(loads, "pin").peak_sensitivities()
    # of m ω² (r + r² / l)
    assert found.by["r"].value == pytest.approx(MASS * SPEED**2 * (1 + 2 * R / L), rel=1e-7)
    assert found.by["l"].value == pytest.approx(-MASS * SPEED**2 * (R / L) ** 2, rel=1e-7)
    with pytest.raises(TypeError, match="have no sensitivities"):
        turn.of_effort(loads).peak_sensitivities()


def test_friction_on_a_slide(pump, turn):
    # a constant force returns what it takes, and so the drive brings the heat alone
    loads = pump.loads().force((-200.0, 0.0), "piston")
    rough = loads.pin_friction("pin", 0.1, 0.012).slide_friction("piston", 0.1)
    heat = turn.of_heat(rough).mean().value
    assert heat > 1.0 and turn.of_power(rough).mean().value == pytest.approx(heat, rel=1e-6)
    assert abs(turn.of_power(loads).mean().value) < 1e-8
    mean = turn.efficiency(rough)
    assert mean.heat == pytest.approx(heat) and abs(mean.output) < 1e-4 * heat
    found = pump.forces(rough, theta=(1.0, SPEED), assembly="open")
    assert found.efficiency.heat > 0
    # without friction in the pin, its normal force on the slide is the one of statics: F tan φ, and the effort
    # balances F and μ N at the slide's speed
    pose = pump.solve(theta=1.0, assembly="open")
    drive = pump.forces(loads.slide_friction("piston", 0.1), theta=(1.0, 1.0), assembly="open")
    slope = math.tan(-pose.phi.position)
    # the slide moves towards the crank, and friction pushes it away: N = (F - μ N) tan φ
    normal = 200.0 * slope / (1 + 0.1 * slope)
    by_theta = pose.jacobian()[pose.rows.index("s"), 0]
    assert drive.efforts["theta"] == pytest.approx((200.0 - 0.1 * normal) * by_theta, rel=1e-9)


def test_friction_at_rest(pump):
    loads = pump.loads().force((-200.0, 0.0), "piston").slide_friction("piston", 0.1)
    efforts = [
        pump.forces(loads.about_to_move(theta=sense), theta=1.0, assembly="open").efforts["theta"] for sense in (1, -1)
    ]
    middle = pump.forces(pump.loads().force((-200.0, 0.0), "piston"), theta=1.0, assembly="open").efforts["theta"]
    assert efforts[1] < middle < efforts[0]
    with pytest.raises(TypeError, match="no input is called `phi`: inputs are theta"):
        loads.about_to_move(phi=1.0)


@pytest.mark.parametrize(
    "add, message",
    [
        (lambda loads: loads.pin_friction("pin", -0.1, 0.01), "the coefficient is -0.1"),
        (lambda loads: loads.pin_friction("piston", 0.1, 0.01), "it is a slide, which has no radius"),
        (lambda loads: loads.slide_friction("pim", 0.1), "pim"),
    ],
)
def test_friction_that_cannot_be(pump, turn, add, message):
    loads = add(pump.loads().mass(1.0, "piston"))
    for ask in (
        lambda: turn.of_power(loads).mean(),
        lambda: pump.forces(loads, theta=1.0, assembly="open"),
        lambda: turn.efficiency(loads),
    ):
        with pytest.raises(kin.AnswerError, match=message):
            ask()


def test_proofs_of_a_force(pump, turn):
    loads = pump.loads().mass(MASS, "piston")
    force = turn.proof(loads, "pin", tolerances={"r": 1e-4})
    # at the dead centre m ω² (r + r² / l), which grows with r
    largest = MASS * SPEED**2 * ((R + 1e-4) + (R + 1e-4) ** 2 / L)
    assert force.below(1.001 * largest).answer == "holds" and force.below(1.001 * largest).upper <= 1.001 * largest
    failed = force.below(0.999 * largest)
    assert failed.answer == "fails" and failed.place.force > 0.999 * largest
    assert abs(failed.place.dimensions["r"] - R) <= 1.0001e-4
    bounds = force.peak(1e-3)
    assert bounds.lower.force <= largest <= bounds.upper <= 1.0011 * bounds.lower.force
    faster = turn.proof(loads, "pin", speeds=(0.9 * SPEED, 1.1 * SPEED)).peak()
    assert faster.upper > 1.2 * turn.of_reaction(loads, "pin").peak().value
    effort = turn.proof(loads).peak()
    assert effort.lower.force <= abs(turn.of_effort(loads).peak().value) <= effort.upper
    undecided = turn.proof(loads, "pin", tolerances={"r": 1e-4}, budget=1).below(1.0000001 * largest)
    assert undecided.answer == "undecided" and undecided.reason


def test_proofs_that_cannot_be(pump, turn):
    loads = pump.loads().mass(MASS, "piston")
    for ask, message in [
        (lambda: turn.proof(loads, "pin", tolerances={"q": 1e-4}).peak(), "q"),
        (lambda: turn.proof(loads.slide_friction("piston", 0.1), "pin").peak(), "friction"),
        (lambda: turn.proof(loads, "pin").below(-1.0), "limit"),
    ]:
        with pytest.raises(kin.AnswerError, match=message):
            ask()
    with pytest.raises(TypeError, match="laws have no proofs"):
        pump.sweep(theta=kin.rise("cycloidal", 0, 1, 1), assembly="open").proof(loads, "pin")


def test_mistakes(pump, turn):
    loads = pump.loads()
    with pytest.raises(ValueError, match="there is no point `pim`; there is `pin`, `piston`"):
        loads.mass(1.0, "pim")
    with pytest.raises(ValueError, match="there is no body `rot`"):
        loads.mass_of("rot", 1.0, "pin", 0.0)
    with pytest.raises(TypeError, match="`force` is a vector: give two or three numbers"):
        loads.force(3.0, "pin")
    with pytest.raises(TypeError, match="`place` is a vector"):
        loads.spring(1.0, 1.0, "pin", (1, 2, 3, 4))
    with pytest.raises(kin.AnswerError, match="pim"):
        turn.of_reaction(loads.mass(1.0, "piston"), "pim").peak()
    with pytest.raises(ValueError, match='no part of a force is called "w"'):
        turn.of_reaction(loads, "pin", part="w")
    with pytest.raises(TypeError, match="no input is called `phi`"):
        turn.of_power(loads, "phi")
    other = kin.library.slider_crank(r=1, l=3)
    with pytest.raises(ValueError, match="these loads are not those of SliderCrank: make them by its `loads`"):
        other.forces(loads, theta=1.0, assembly="open")
    with pytest.raises(kin.SolveError):
        kin.Mechanism(PUMP)(r=R, l=R / 2).forces(loads, theta=1.5, assembly="open")


def test_bodies_are_stated():
    unstated = kin.Mechanism(PUMP.split("ground")[0])(r=R, l=L)
    with pytest.raises(kin.AnswerError, match="body"):
        unstated.forces(unstated.loads(), theta=1.0, assembly="open")
