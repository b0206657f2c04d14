"""Writes the files of this folder with pylinkage, and beside each the positions that pylinkage computes.

pip install pylinkage==1.3.0 && python make.py
"""

import json
import math
from pathlib import Path

import pylinkage
from pylinkage.mechanism import (
    ArcDriverLink,
    DriverLink,
    GroundJoint,
    GroundLink,
    Link,
    Mechanism,
    PrismaticJoint,
    RevoluteJoint,
    TrackerJoint,
    fourbar,
    mechanism_to_json,
    slider_crank,
)

FOLDER = Path(__file__).parent
SAMPLES = 12


def drawn(name, ground, joints, motor, links, arc=None, trackers=()):
    """A mechanism from coordinates; `motor` is the driven link, and the first joint of it turns."""
    at = {key: GroundJoint(key, position=place) for key, place in ground.items()}
    for key, place in joints.items():
        at[key] = RevoluteJoint(key, position=place) if len(place) == 2 else PrismaticJoint(
            key, position=place[:2], axis=place[2], line_point=place[:2]
        )
    fixed, tip = motor
    angle = math.atan2(joints[tip][1] - ground[fixed][1], joints[tip][0] - ground[fixed][0])
    shared = {"joints": [at[fixed], at[tip]], "motor_joint": at[fixed], "angular_velocity": math.tau / 360}
    if arc:
        crank = ArcDriverLink("crank", arc_start=angle + arc[0], arc_end=angle + arc[1], initial_angle=angle, **shared)
    else:
        crank = DriverLink("crank", initial_angle=angle, **shared)
    bodies = [GroundLink("frame", joints=[at[key] for key in ground]), crank]
    bodies += [Link(key, joints=[at[joint] for joint in through]) for key, through in links.items()]
    followers = [TrackerJoint(*tracker) for tracker in trackers]
    return Mechanism(name=name, joints=[*at.values(), *followers], links=bodies, ground=bodies[0])


def jansen():
    """Jansen's leg from its holy numbers, at the crank's angle 0."""
    place = {"o": (0.0, 0.0), "g": (-38.0, -7.8), "a": (15.0, 0.0)}

    def meet(p, rp, q, rq, side):
        (px, py), (qx, qy) = place[p], place[q]
        dx, dy = qx - px, qy - py
        d = math.hypot(dx, dy)
        along = (rp**2 - rq**2 + d**2) / (2 * d)
        across = side * math.sqrt(rp**2 - along**2)
        return px + (along * dx - across * dy) / d, py + (along * dy + across * dx) / d

    place["b"] = meet("a", 50.0, "g", 41.5, -1)
    place["b"] = max(place["b"], meet("a", 50.0, "g", 41.5, 1), key=lambda point: point[1])
    place["c"] = min((meet("g", 40.1, "b", 55.8, side) for side in (1, -1)), key=lambda point: point[0])
    place["d"] = min((meet("a", 61.9, "g", 39.3, side) for side in (1, -1)), key=lambda point: point[1])
    place["e"] = min((meet("c", 39.4, "d", 36.7, side) for side in (1, -1)), key=lambda point: point[0])
    place["f"] = min((meet("e", 65.7, "d", 49.0, side) for side in (1, -1)), key=lambda point: point[1])
    ground = {key: place.pop(key) for key in ("o", "g")}
    links = {
        "upper": ("a", "b"), "knee": ("g", "b", "c"), "lower": ("a", "d"), "hip": ("g", "d"),
        "shin": ("c", "e"), "foot": ("d", "e", "f"),
    }
    return drawn("Jansen leg", ground, place, ("o", "a"), links)


def klann():
    ground = {"o": (0.0, 0.0), "m": (-24.0, 11.0), "n": (-26.0, -8.0)}
    joints = {"a": (-3.0, -9.0), "b": (-22.0, 5.0), "c": (-37.0, 14.0), "d": (-22.0, 36.0), "f": (-73.0, -45.0)}
    links = {"rocker": ("n", "b"), "coupler": ("a", "b", "c"), "arm": ("m", "d"), "leg": ("d", "c", "f")}
    return drawn("Klann leg", ground, joints, ("o", "a"), links)


FILES = {
    "four_bar": fourbar(1.0, 3.0, 3.0, 4.0),
    "four_bar_crossed": fourbar(2.0, 5.0, 4.0, 6.0, initial_angle=0.7, branch=0, name="crossed four-bar"),
    "drag_link": fourbar(4.0, 3.5, 5.0, 2.0, initial_angle=1.0, omega=-math.tau / 90, name="drag link"),
    "slider_crank": slider_crank(1.0, 3.0, initial_angle=0.5),
    "slider_crank_offset": slider_crank(
        10.0, 40.0, initial_angle=0.5, slide_through=(0.0, -4.0), slide_direction=(3.0, 1.0), name="offset"
    ),
    "six_bar_watt": drawn(
        "Watt", {"o": (0, 0), "d": (8, 0)}, {"a": (1, 2), "b": (7, 6), "c": (10, 5), "e": (4, 8), "f": (11, 10)},
        ("o", "a"), {"coupler": ("a", "b", "e"), "rocker": ("d", "b", "c"), "upper": ("e", "f"), "tool": ("c", "f")},
    ),
    "six_bar_stephenson": drawn(
        "Stephenson III", {"o": (0, 0), "d": (6, 0), "g": (12, 1)},
        {"a": (0.5, 1.5), "b": (5, 4), "e": (4, 6), "f": (10, 7)},
        ("o", "a"), {"coupler": ("a", "b", "e"), "rocker": ("d", "b"), "rod": ("e", "f"), "output": ("g", "f")},
    ),
    "six_bar_slider": drawn(
        "press", {"o": (0, 0), "d": (5, 1)}, {"a": (1, 1), "b": (4, 4), "s": (9, 3, (1.0, 0.5))},
        ("o", "a"), {"coupler": ("a", "b"), "rocker": ("d", "b"), "rod": ("b", "s")},
    ),
    "chebyshev": drawn(
        "Chebyshev lambda", {"o": (0, 0), "d": (4, 0)}, {"a": (-1, 1.7), "b": (4.5, 4.97), "p": (10, 8.24)},
        ("o", "a"), {"coupler": ("a", "b", "p"), "rocker": ("d", "b")},
    ),
    "arc": drawn(
        "arc", {"o": (0, 0), "d": (8, 0)}, {"a": (0, 4), "b": (6, 6)}, ("o", "a"),
        {"coupler": ("a", "b"), "rocker": ("d", "b")}, arc=(-0.3, 0.5),
    ),
    "tracker": drawn(
        "tracker", {"o": (0, 0), "d": (6, 0)}, {"a": (1, 1), "b": (5, 4)}, ("o", "a"),
        {"coupler": ("a", "b"), "rocker": ("d", "b")},
        trackers=[("mid", (3.0, 4.0), "mid", [], None, None, "a", "b", 2.5, 0.4)],
    ),
    "jansen": jansen(),
    "klann": klann(),
}

for name, mechanism in FILES.items():
    mechanism_to_json(mechanism, FOLDER / f"{name}.json")
    tip = next(link for link in mechanism.links if hasattr(link, "motor_joint"))
    period = mechanism.get_rotation_period()
    start = tip.current_angle
    rows = []
    try:
        for number, places in enumerate(mechanism.step(), 1):
            if number % max(1, period // SAMPLES) == 0:
                rows.append([tip.current_angle - start, [list(place) for place in places]])
    except Exception as error:  # the crank of a rocker stops
        print(name, error)
    text = ",\n".join(json.dumps(row) for row in rows)
    (FOLDER / f"{name}.positions").write_text(f'{{"version": "{pylinkage.__version__}", "rows": [\n{text}\n]}}\n')
    print(name, period, len(rows))
