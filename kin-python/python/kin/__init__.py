"""Kinematics of mechanisms: positions and all derivatives from a loop closure.

>>> import kin
>>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
>>> pose = linkage.solve(theta2=[1.0, 10.0], assembly="open")    # rad and rad/s
>>> round(pose.theta4.velocity, 4), round(pose.theta4.jerk, 1)
(2.5091, -696.8)

Angles are in radians, lengths in any unit of the mechanism, time in the unit of the speeds that are given.
"""

from kin import library
from kin._answers import (
    Branch,
    C,
    Circuit,
    CircuitPeak,
    Crossing,
    Dwell,
    Extreme,
    Force,
    Forces,
    Limit,
    Mean,
    Peak,
    PeakSensitivities,
    Sensitivity,
    Stroke,
    WorstTransmission,
)
from kin._errors import AnswerError, DeclarationError, KinError, Mistake, SolveError
from kin._kin import (
    Batch,
    Cycle,
    ExactTable,
    Law,
    Linkage,
    Loads,
    Mechanism,
    Motion,
    Page,
    Pose,
    Quantity,
    Sweep,
    Table,
    dwell,
    rise,
)
from kin._units import deg, rpm

__all__ = [
    "AnswerError",
    "Batch",
    "Branch",
    "C",
    "Circuit",
    "CircuitPeak",
    "Crossing",
    "Cycle",
    "DeclarationError",
    "Dwell",
    "ExactTable",
    "Extreme",
    "Force",
    "Forces",
    "KinError",
    "Law",
    "Limit",
    "Linkage",
    "Loads",
    "Mean",
    "Mechanism",
    "Mistake",
    "Motion",
    "Page",
    "Peak",
    "PeakSensitivities",
    "Pose",
    "Quantity",
    "Sensitivity",
    "SolveError",
    "Stroke",
    "Sweep",
    "Table",
    "WorstTransmission",
    "deg",
    "dwell",
    "library",
    "rise",
    "rpm",
]
