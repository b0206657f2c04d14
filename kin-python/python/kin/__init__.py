"""Kinematics of mechanisms: positions and all derivatives from a loop closure.

>>> import kin
>>> linkage = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
>>> pose = linkage.solve(theta2=[1.0, 10.0], assembly="open")    # rad and rad/s
>>> round(pose.theta4.velocity, 4), round(pose.theta4.jerk, 1)
(2.9104, -2911.3)

Angles are in radians, lengths in any unit of the mechanism, time in the unit of the speeds that are given.
"""

from kin import library
from kin._errors import DeclarationError, KinError, Mistake, SolveError
from kin._kin import Batch, Linkage, Mechanism, Motion, Pose
from kin._units import deg, rpm

__all__ = [
    "Batch",
    "DeclarationError",
    "KinError",
    "Linkage",
    "Mechanism",
    "Mistake",
    "Motion",
    "Pose",
    "SolveError",
    "deg",
    "library",
    "rpm",
]
