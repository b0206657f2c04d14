"""A race on one core: poses of a four-bar linkage over a revolution, through snap, and positions alone.

    pip install ./kin-python casadi jax pylinkage numba    # each but kin may be left out
    python kin-python/benches/race.py [poses]

kin's batch in Rust takes part if cargo is there. All others than kin and pylinkage are given the closed form by hand,
without checks of the reach. All must find the same numbers.
"""

from __future__ import annotations

import os

# before NumPy and JAX start their threads
for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[variable] = "1"
os.environ["XLA_FLAGS"] = "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1"

import subprocess
import sys
import time
import types
from collections.abc import Callable, Iterator
from importlib import import_module, metadata
from pathlib import Path
from typing import Any

import numpy as np

import kin

PACKAGE = Path(__file__).resolve().parent.parent
sys.path.append(str(PACKAGE.parent / "tests/benches/peers/programs"))

DIMENSIONS = {"r1": 90.0, "r2": 30.0, "r3": 70.0, "r4": 60.0}
SPEED = 10.0
RUNS = 7

#: A contestant solves both unknowns, with all orders or their positions, as rows of an array.
Solver = Callable[[], Any]


def contestants(angles: np.ndarray, orders: int) -> Iterator[tuple[str, Solver]]:
    """The name and the solver of each that is installed."""
    linkage = kin.library.four_bar(**DIMENSIONS)
    crank = (angles, SPEED)[:orders]

    def by_kin() -> list[Any]:
        batch = linkage.solve_batch(theta2=crank, assembly="open", order=orders - 1, threads=1)
        return [*batch.theta3.derivatives, *batch.theta4.derivatives]

    yield "kin", by_kin

    memory = linkage.solve_batch(theta2=crank, assembly="open", order=orders - 1, threads=1)

    def by_kin_again() -> list[Any]:
        batch = linkage.solve_batch(theta2=crank, assembly="open", order=orders - 1, threads=1, out=memory)
        return [*batch.theta3.derivatives, *batch.theta4.derivatives]

    yield "kin, into memory it has used", by_kin_again

    tape = types.ModuleType("tape")
    sys.modules["tape"] = tape
    exec(linkage.to_python(order=orders - 1), vars(tape))

    def by_tape() -> list[Any]:
        pose = tape.solve({}, {"theta2": list(crank)}, tape.OPEN)
        return [*np.atleast_2d(pose.theta3), *np.atleast_2d(pose.theta4)]

    yield "NumPy, by kin's to_python", by_tape

    four_bar = import_module("closed_forms").four_bar
    wanted = [order + 5 * unknown for unknown in (0, 1) for order in range(orders)]

    def closed_form(package: Any, angle: Any) -> list[Any]:
        motion = [angle, SPEED, 0.0, 0.0, 0.0]
        all_orders = four_bar(package, list(DIMENSIONS.values()), motion)
        return [all_orders[index] for index in wanted]

    if package := installed("casadi"):
        angle = package.SX.sym("angle")
        found = package.cse(package.horzcat(*closed_form(package, angle)).T)
        solve = package.Function("solve", [angle], [found]).map(len(angles))
        yield "CasADi, by its machine", lambda: np.asarray(solve(angles.reshape(1, -1)))

    if package := installed("jax"):
        package.config.update("jax_enable_x64", True)
        compiled = package.jit(lambda angle: closed_form(package.numpy, angle))
        on_device = package.numpy.asarray(angles)
        yield "JAX, compiled", lambda: package.block_until_ready(compiled(on_device))

    if orders == 1 and installed("pylinkage"):
        columns = np.zeros((9, len(angles)))
        columns[:4], columns[4] = np.array([list(DIMENSIONS.values())]).T, angles
        sweep = import_module("by_pylinkage").solver("four_bar", columns)
        yield "pylinkage", lambda: sweep(None)


def installed(name: str) -> Any:
    try:
        return import_module(name)
    except ImportError:
        print(f"{name} is not installed")
        return None


def seconds(solve: Solver) -> float:
    """The shortest of several runs, after one that may compile."""
    solve()
    best = float("inf")
    for _ in range(RUNS):
        start = time.perf_counter()
        solve()
        best = min(best, time.perf_counter() - start)
    return best


def of_rust(count: int) -> list[float]:
    """The times of kin-live's batch, which an example of this package prints."""
    command = ["cargo", "run", "--release", "--locked", "--quiet", "--example", "batch", "--", str(count)]
    try:
        printed = subprocess.run(command, cwd=PACKAGE, check=True, capture_output=True, text=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        print(f"without kin in Rust: {error}")
        return []
    return [float(line) for line in printed.split()]


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    angles = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    rust = of_rust(count)
    for index, (title, orders) in enumerate([("through snap", 5), ("positions alone", 1)]):
        print(f"\n{count} poses of a four-bar linkage on one core, {title}: ns per pose, and times those of kin")
        times: list[tuple[str, float]] = []
        expected = None
        for name, solve in contestants(angles, orders):
            found = np.array([np.unwrap(row) if row_is_angle(orders, at) else row for at, row in enumerate(solve())])
            expected = found if expected is None else expected
            found[0::orders] -= 2.0 * np.pi * np.round((found[0::orders] - expected[0::orders]) / (2.0 * np.pi))
            scale = np.abs(expected).max(axis=1, keepdims=True)
            assert np.abs(found - expected).max() <= 1e-9 * scale.max(), name
            assert (np.abs(found - expected) <= 1e-9 * scale).all(), name
            times.append((name, seconds(solve)))
        if rust:
            times.insert(2, ("kin's batch in Rust", rust[index]))
        for name, own in times:
            print(f"{name:30} {own / count * 1e9:8.1f} {own / times[0][1]:8.2f}")


def row_is_angle(orders: int, row: int) -> bool:
    return row % orders == 0


if __name__ == "__main__":
    names = ("kin-mechanisms", "numpy", "casadi", "jax", "pylinkage", "numba")
    versions = []
    for package in names:
        try:
            versions.append(f"{package} {metadata.version(package)}")
        except metadata.PackageNotFoundError:
            pass
    print(", ".join(versions))
    main()
