"""Python gives the numbers of Rust, to the last bit."""

import os
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest

import kin

RATES = (3.0, 0.5, -0.25, 0.125)


def bits(number: float) -> str:
    return struct.pack(">d", number).hex()


def at_speed(name):
    """A linkage that closes, and arguments of `solve` with the rates of the example in Rust."""
    linkage, at = kin.library.example(name)
    for quantity in linkage.mechanism.inputs:
        at[quantity] = (at[quantity], *RATES[: linkage.mechanism.order])
    return linkage, at


@pytest.fixture(scope="session")
def of_rust(pytestconfig):
    """The bits of every mechanism, from a program in Rust. No profile changes a bit, and `quick` is built soonest."""
    package = Path(__file__).parent.parent
    profile = os.environ.get("KIN_PROFILE", "quick")
    command = ["cargo", "run", "--profile", profile, "--locked", "--quiet", "--example", "numbers"]
    # the first build takes minutes, in which a person shall know what is waited for
    if terminal := pytestconfig.pluginmanager.get_plugin("terminalreporter"):
        terminal.write_line(f"\nbuilding the numbers of Rust: {' '.join(command)}")
    printed = subprocess.run(command, cwd=package, check=True, capture_output=True, text=True).stdout
    lines = [line.split() for line in printed.splitlines()]
    return {name: numbers for name, *numbers in lines}


def scalars(motion):
    """The motions of the coordinates of a point, or the motion itself."""
    if np.ndim(motion.position) == 0:
        return [motion]
    return [motion.x, motion.y, motion.z] if len(motion.position) == 3 else [motion.x, motion.y]


@pytest.mark.parametrize("name", kin.library.names())
def test_bits(name, of_rust):
    linkage, at = at_speed(name)
    pose = linkage.solve(**at)
    mechanism = linkage.mechanism
    motions = [scalar for name in (*mechanism.unknowns, *mechanism.outputs) for scalar in scalars(pose[name])]
    found = [bits(number) for motion in motions for number in motion.derivatives]
    assert found == of_rust[name]


def test_every_mechanism_is_compared(of_rust):
    assert list(of_rust) == kin.library.names()
    assert len(of_rust) == 37


@pytest.mark.parametrize("name", kin.library.names())
def test_a_batch_finds_the_poses_of_solve(name):
    linkage, at = at_speed(name)
    pose = linkage.solve(**at)
    batch = linkage.solve_batch(**at)
    many = linkage.solve_batch(**{name: (np.full(600, at[name][0]), *at[name][1:]) if name in linkage.mechanism.inputs
                                  else at[name] for name in at})
    assert batch.solved and many.solved.all()
    for quantity in (*linkage.mechanism.unknowns, *linkage.mechanism.outputs):
        for order, expected in enumerate(pose[quantity].derivatives):
            # an angle of a batch is within ±π, where that of a pose may be near another
            turns = "near" in at and order == 0 and quantity in linkage.mechanism.unknowns
            for found in (batch[quantity].derivative(order), many[quantity].derivative(order)[..., 599]):
                difference = np.abs(found - expected)
                if turns:
                    difference = np.minimum(difference, np.abs(difference - 2 * np.pi))
                # rounding, in a mechanism close to nothing singular
                assert np.all(difference <= 1e-11 * (1 + np.abs(expected).max())), (quantity, order)


@pytest.mark.parametrize("name", kin.library.names())
def test_the_jacobian_is_the_velocity_by_the_inputs(name):
    linkage, at = at_speed(name)
    pose = linkage.solve(**at)
    mechanism = linkage.mechanism
    motions = [scalar for name in (*mechanism.unknowns, *mechanism.outputs) for scalar in scalars(pose[name])]
    assert pose.rows == tuple(motion.name for motion in motions)
    velocities = np.array([motion.velocity for motion in motions])
    speeds = np.full(len(mechanism.inputs), RATES[0])
    assert np.allclose(pose.jacobian() @ speeds, velocities, rtol=1e-11, atol=1e-12)


def test_sensitivities_are_differences():
    dimensions = {"r1": 90.0, "r2": 30.0, "r3": 70.0, "r4": 60.0}
    pose = kin.library.four_bar(**dimensions).solve(theta2=1.0, assembly="open")
    step = 1e-5
    for column, name in enumerate(dimensions):
        ends = [
            kin.library.four_bar(**{**dimensions, name: dimensions[name] + sign * step}).solve(
                theta2=1.0, assembly="open"
            )
            for sign in (1, -1)
        ]
        for row, unknown in enumerate(("theta3", "theta4")):
            difference = (ends[0][unknown].position - ends[1][unknown].position) / (2 * step)
            assert abs(pose.sensitivities()[row, column] - difference) < 1e-9


def test_published_crank_rocker():
    """At θ2 = 0 the rocker follows by the law of cosines."""
    pose = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60).solve(theta2=0.0, assembly="open")
    # the triangle of 60 (ground less crank), the coupler 70 and the rocker 60
    inner = np.arccos((60**2 + 60**2 - 70**2) / (2 * 60 * 60))
    assert abs(pose.theta4.position - (np.pi - inner)) < 1e-14
