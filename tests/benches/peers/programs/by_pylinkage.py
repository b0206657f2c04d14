"""The positions of a sweep through pylinkage, by its compiled loop. It finds joints; both unknowns follow from them."""

import numpy as np
from pylinkage import Crank, Ground, RRPDyad, RRRDyad
from pylinkage.simulation import Linkage


def solver(linkage, columns):
    """A function that sweeps the whole turn of the columns."""
    angle = columns[4 if linkage == "four_bar" else 2]
    step = angle[1] - angle[0]
    build = {"four_bar": four_bar, "slider_crank": slider_crank}[linkage]
    sweep, unknowns = build(columns[:, 0], step, angle[0] - step)
    sweep.compile()
    count = len(angle)
    return lambda _: unknowns(sweep.step_fast(count))


def four_bar(dimensions, step, start):
    r1, r2, r3, r4 = dimensions[:4]
    origin, pivot = Ground(0.0, 0.0), Ground(r1, 0.0)
    crank = Crank(anchor=origin, radius=r2, angular_velocity=step, initial_angle=start)
    # a hint above the ground: the open assembly
    rocker = RRRDyad(crank.output, pivot, distance1=r3, distance2=r4, x=r1, y=r4)

    def unknowns(trajectory):
        pin, joint = trajectory[:, 2].T, trajectory[:, 3].T
        return [
            np.arctan2(joint[1] - pin[1], joint[0] - pin[0]),
            np.arctan2(joint[1], joint[0] - r1),
        ]

    return Linkage([origin, pivot, crank, rocker]), unknowns


def slider_crank(dimensions, step, start):
    r, l = dimensions[:2]
    origin, left, right = Ground(0.0, 0.0), Ground(0.0, 0.0), Ground(1.0, 0.0)
    crank = Crank(anchor=origin, radius=r, angular_velocity=step, initial_angle=start)
    slider = RRPDyad(crank.output, left, right, distance=l, x=r + l, y=0.0)

    def unknowns(trajectory):
        pin, piston = trajectory[:, 3].T, trajectory[:, 4].T
        return [np.arctan2(pin[1] - piston[1], piston[0] - pin[0]), piston[0]]

    return Linkage([origin, left, right, crank, slider]), unknowns
