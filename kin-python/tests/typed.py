"""What mypy --strict accepts of a user's program. tests/test_package.py runs mypy."""

import numpy as np
from numpy.typing import NDArray

import kin

four_bar: kin.Mechanism = kin.library.four_bar
linkage: kin.Linkage = four_bar(r1=90, r2=30, r3=70, r4=60)
pose = linkage.solve(theta2=[1.0, 10.0], assembly="open")
jerk: float = pose.theta4.jerk
later = linkage.solve(theta2=kin.deg(60), near=pose)
angles: NDArray[np.float64] = np.linspace(0, 6, 100)
batch = four_bar.solve_batch(r1=90, r2=angles[:, None], r3=70, r4=60, theta2=(angles, 10.0), assembly="open")
jerks: NDArray[np.float64] = batch.theta4.jerk
turn = linkage.sweep(theta2=(0.0, 6.0), rows=100, speed=10.0, assembly="open")
peak: kin.Peak = turn.of("theta4_jerk").peak()
column: NDArray[np.float64] = turn.table().in_degrees()["theta4"]
length: float = linkage.cycle().stroke("theta4").length
source: str = linkage.to_c(order=1).source
law: kin.Law = kin.rise("cycloidal", 0.0, 1.0, 0.1) + kin.dwell(1.0, 0.2)
try:
    linkage.solve(theta2=3.0, assembly="open")
except kin.SolveError as error:
    margin: float | None = error.margin
