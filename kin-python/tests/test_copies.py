"""Everything that a user holds can be copied and pickled, and then gives the same numbers to the last bit."""

import copy
import inspect
import pickle
import subprocess
import sys

import numpy as np
import pytest

import kin

FOUR_BAR = kin.library.four_bar(r1=90, r2=30, r3=70, r4=60)
TURN = FOUR_BAR.sweep(theta2=(0.0, 6.0), rows=31, speed=10.0, assembly="open")
PRESS = kin.library.slider_crank(r=0.1, l=0.3)
LOADS = PRESS.loads().torque(-200.0, "s").inertia(0.01, "phi")
STROKE = PRESS.sweep(theta=(0.0, 6.0), speed=10.0, assembly="open")
PUMP = kin.Mechanism("""
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
""")(r=0.05, l=0.15)
PUMPING = PUMP.sweep(theta=(0.0, 6.0), rows=21, speed=kin.rpm(900), assembly="open")
ALL_LOADS = (
    PUMP.loads()
    .gravity((0, -9.81))
    .mass(0.8, "piston")
    .mass_of("rod", 0.4, np.array([0.07, 0.001]), 1e-3)
    .inertia(0.002, "phi")
    .force([-200, 3], "piston")
    .torque(1.5, "phi")
    .spring(500.0, 0.1, (0.3, 0.0), "piston")
    .damper(3.0, (0.0, 0.2), "piston")
    .pin_friction("pin", 0.1, 0.012)
    .slide_friction("piston", 0.1, 0.02)
    .about_to_move(theta=1.0)
)
LAWS = [
    kin.rise("modified sine", 0.0, 1.5, 0.2),
    kin.rise((0.25, 0.0, 0.75), 0.0, 1.5, 0.2),
    kin.dwell(1.5, 0.1),
    kin.constant_speed(0.1, 3.0, 0.7),
    kin.s_curve(0.0, 1.0, velocity=2.0, acceleration=10.0, jerk=200.0),
    kin.s_curve(0.0, 1.0, velocity=2.0, acceleration=10.0, jerk=200.0, snap=9000.0),
    kin.polynomial((0.0, 0.0, 0.0), (10.0, 5.0, 0.0), 2.0),
    kin.fourier(0.1, [(0.2, 0.3), (0.0, 1e-3)], 2.0),
    kin.rise("cycloidal", 0.0, 1.5, 0.2) + kin.dwell(1.5, 0.1) + kin.rise("3-4-5", 1.5, 0.0, 0.3),
]
COUPLED, NEAR = kin.library.example("stephenson_ii")


def batch():
    return FOUR_BAR.solve_batch(theta2=(np.linspace(0, 6, 20).reshape(4, 5), 10.0), assembly="open")


def numbers_of_batch(found):
    columns = [column.tobytes() for motion in (found.theta3, found.theta4) for column in motion.derivatives]
    return [*columns, found.solved.tobytes(), found.singular.tobytes(), found.margin.tobytes(), found.shape]


def numbers_of_motion(motion):
    return [motion.name, repr(motion), *(np.asarray(value).tobytes() for value in motion.derivatives)]


def numbers_of_pose(pose):
    return [*map(numbers_of_motion, (pose[name] for name in pose.unknowns)), pose.assembly, pose.jacobian().tobytes()]


def numbers_of_law(law):
    return [law.duration, *(law.at(law.duration * share) for share in np.linspace(0, 1, 50))]


def numbers_of_table(table):
    return [(name, table[name].tobytes(), table.units[name]) for name in table.names] + [table.limits]


def numbers_of_loads(loads):
    return repr(PUMP.forces(loads, theta=(0.3, 90.0, 7.0), assembly="open"))


def numbers_of_sweep(turn):
    return [turn.at.tobytes(), turn.variable, repr(turn.linkage), numbers_of_table(turn.table())]


def numbers_of_cycle(cycle):
    return [cycle.moving, cycle.circuits, cycle.branches, cycle.stroke(cycle.linkage.mechanism.unknowns[0])]


def numbers_of_quantity(quantity):
    return [quantity.name, quantity.measure, quantity.order, quantity.column().tobytes(), quantity.peak()]


def numbers_of_proof(proof):
    return [proof.peak(0.5), proof.below(1e4)]


def error(function, **arguments):
    with pytest.raises(kin.KinError) as raised:
        function(**arguments)
    return raised.value


def numbers_of_error(error):
    return [str(error), vars(error)]


HELD = {
    "Mechanism": [(FOUR_BAR.mechanism, lambda mechanism: (mechanism.text, repr(mechanism)))],
    "Linkage": [(FOUR_BAR, lambda linkage: (linkage, linkage.dimensions))],
    "Pose": [
        (FOUR_BAR.solve(theta2=(1.0, 10.0, 3.0), assembly="crossed"), numbers_of_pose),
        (COUPLED.solve(**NEAR), numbers_of_pose),
    ],
    "Motion": [
        (FOUR_BAR.solve(theta2=(1.0, 10.0), assembly="open").theta4, numbers_of_motion),
        (PUMP.solve(theta=(1.0, 10.0), assembly="open").pin, numbers_of_motion),
        (PUMP.solve_batch(theta=(np.ones(3), 10.0), assembly="open").pin, numbers_of_motion),
    ],
    "Batch": [(batch(), numbers_of_batch)],
    "Sweep": [
        (TURN, numbers_of_sweep),
        (FOUR_BAR.sweep(theta2=LAWS[-1], rows=9, assembly="crossed"), numbers_of_sweep),
        (COUPLED.sweep(**{**NEAR, COUPLED.mechanism.inputs[0]: (NEAR[COUPLED.mechanism.inputs[0]], 0.9)}, rows=5),
         numbers_of_sweep),
    ],
    "Quantity": [
        (TURN.of("theta4.jerk"), numbers_of_quantity),
        (TURN.of_transmission_angle(), numbers_of_quantity),
        (STROKE.of_effort(LOADS, order=1), numbers_of_quantity),
        (STROKE.of_power(LOADS), numbers_of_quantity),
        (PUMPING.of_reaction(ALL_LOADS, "pin", "x", order=1), numbers_of_quantity),
        (PUMPING.of_heat(ALL_LOADS), numbers_of_quantity),
    ],
    "Table": [
        (TURN.table(), numbers_of_table),
        (TURN.table().in_degrees().in_units("mm", "s"), numbers_of_table),
        (kin.library.four_bar(r1=90, r2=30, r3=60, r4=45).sweep(theta2=(-3, 3), rows=9, assembly="open").table(),
         numbers_of_table),
    ],
    "ExactTable": [(FOUR_BAR.sweep(theta2=(0, 6), assembly="open").exact_table([1e-6, 1e-4]), bytes)],
    "Law": [(law, numbers_of_law) for law in LAWS],
    "Loads": [(ALL_LOADS, numbers_of_loads), (PUMP.loads(), numbers_of_loads)],
    "Cycle": [
        (FOUR_BAR.cycle(), numbers_of_cycle),
        (kin.library.example("five_bar")[0].cycle(moving="alpha", beta=2.0), numbers_of_cycle),
    ],
    "ForceProof": [
        (PUMPING.proof(PUMP.loads().mass(0.8, "piston"), "pin", part="x", tolerances={"r": 1e-4}), numbers_of_proof),
        (PUMPING.proof(PUMP.loads().mass(0.8, "piston"), speeds=(90, 95), budget=2000), numbers_of_proof),
    ],
    "Page": [(FOUR_BAR.report(speed=10.0), lambda page: page.html)],
    "Peak": [(TURN.of("theta4").peak(), lambda peak: peak)],
    "Extreme": [(TURN.of("theta4").extremes()[0], lambda extreme: extreme)],
    "Crossing": [(TURN.of("theta4").crossings(2.0)[0], lambda crossing: crossing)],
    "Dwell": [(TURN.of("theta4").dwells(2.0, 0.1)[0], lambda dwell: dwell)],
    "Mean": [(TURN.of("theta4").mean(), lambda mean: mean)],
    "PeakSensitivities": [(TURN.of("theta4").peak_sensitivities(), lambda found: found)],
    "Sensitivity": [(TURN.of("theta4").peak_sensitivities().by["r2"], lambda found: found)],
    "Limit": [(kin.Limit(1.0, "limit position", 3, True, "theta3, theta4"), lambda limit: limit)],
    "Branch": [(FOUR_BAR.cycle().branches[0], lambda branch: branch)],
    "Circuit": [(FOUR_BAR.cycle().circuits[0], lambda circuit: circuit)],
    "Stroke": [(FOUR_BAR.cycle().stroke("theta4"), lambda stroke: (stroke, stroke.length))],
    "CircuitPeak": [(FOUR_BAR.cycle().peak("theta4"), lambda peak: peak)],
    "WorstTransmission": [(FOUR_BAR.cycle().worst_transmission(), lambda worst: worst)],
    "Forces": [(PUMP.forces(ALL_LOADS, theta=1.0, assembly="open"), repr)],
    "Force": [(PUMP.forces(ALL_LOADS, theta=1.0, assembly="open").joints["pin"], lambda force: force)],
    "Efficiency": [(PUMPING.efficiency(ALL_LOADS), lambda found: (found, found.ratio))],
    "ForcePlace": [(kin.ForcePlace(1.0, 2.0, 3.0, 4.0, {"r": 1.0}), lambda place: place)],
    "ForceVerdict": [(kin.ForceVerdict("holds", 1.0, None, ""), lambda verdict: verdict)],
    "PeakBounds": [(kin.PeakBounds(kin.ForcePlace(1.0, 2.0, 3.0, 4.0, {}), 2.0), lambda bounds: bounds)],
    "Fitted": [(kin.Fitted(FOUR_BAR, {"theta4": 0.1}, {"theta4": None}, True, 0), lambda fitted: fitted)],
    "C": [(FOUR_BAR.to_c(order=0), lambda c: c)],
    "SolveError": [(error(FOUR_BAR.mechanism(r1=90, r2=30, r3=60, r4=45).solve, theta2=3.0, assembly="open"),
                    numbers_of_error)],
    "TrackError": [(error(FOUR_BAR.mechanism(r1=90, r2=30, r3=60, r4=45).solve(theta2=0.0, assembly="open").track_to,
                          theta2=3.0), numbers_of_error)],
    "AnswerError": [(error(TURN.of("nothing").peak), numbers_of_error)],
    "DeclarationError": [(error(kin.Mechanism, text="struct Crank { r: Length }"), numbers_of_error)],
    "Mistake": [(error(kin.Mechanism, text="struct Crank { r: Length }").mistakes[0], lambda mistake: mistake)],
    "KinError": [(kin.KinError("no"), numbers_of_error)],
}  # fmt: skip
CASES = [(name, value, numbers) for name, all_of_class in HELD.items() for value, numbers in all_of_class]
COPIES = {
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
    **{f"pickle {version}": lambda value, version=version: pickle.loads(pickle.dumps(value, version))
       for version in range(pickle.HIGHEST_PROTOCOL + 1)},
}  # fmt: skip


@pytest.mark.parametrize("way", COPIES)
@pytest.mark.parametrize("name, value, numbers", CASES, ids=[name for name, _, _ in CASES])
def test_a_copy_has_the_same_numbers(name, value, numbers, way):
    copied = COPIES[way](value)
    assert type(copied) is type(value) is getattr(kin, name)
    assert repr(numbers(copied)) == repr(numbers(value))


def test_every_class_is_copied():
    assert set(HELD) == {name for name in kin.__all__ if inspect.isclass(getattr(kin, name))}


def test_a_deep_copy_has_memory_of_its_own():
    found = batch()
    shallow, deep = copy.copy(found), copy.deepcopy(found)
    assert shallow.theta4.jerk is found.theta4.jerk
    kept = found.theta4.jerk.copy()
    found.theta4.jerk[:] = 0.0
    found.solved[:] = False
    assert (deep.theta4.jerk == kept).all() and deep.solved.all()


def test_the_first_failure_is_pickled():
    found = FOUR_BAR.mechanism.solve_batch(r1=90, r2=30, r3=60, r4=45, theta2=np.linspace(1, 3, 9), assembly="open")
    index, failure = pickle.loads(pickle.dumps(found)).first_failure
    assert index == found.first_failure[0] and vars(failure) == vars(found.first_failure[1])


def test_loads_keep_the_vectors_that_were_given():
    """An array that changes after the call changes neither the loads nor their copy."""
    force = np.array([-200.0, 0.0])
    loads = PUMP.loads().force(force, "piston")
    expected = numbers_of_loads(loads)
    force[0] = 0.0
    assert numbers_of_loads(pickle.loads(pickle.dumps(loads))) == expected == numbers_of_loads(loads)


def test_columns_of_a_table_are_read_only():
    """Otherwise they would differ from what Arrow and a copy get."""
    with pytest.raises(ValueError, match="read-only"):
        TURN.table()["theta4"][0] = 0.0


def test_a_list_of_limits_is_the_callers():
    table = HELD["Table"][-1][0]
    limits = table.limits
    assert limits
    limits.clear()
    assert table.limits


def test_another_process_has_the_same_numbers(tmp_path):
    file = tmp_path / "loads.pickle"
    file.write_bytes(pickle.dumps((PUMP, ALL_LOADS, PUMPING.of_reaction(ALL_LOADS, "pin"))))
    program = (
        f"import pickle\npump, loads, pin = pickle.load(open({str(file)!r}, 'rb'))\n"
        "print(repr(pump.forces(loads, theta=(0.3, 90.0, 7.0), assembly='open')), pin.peak())"
    )
    printed = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
    assert printed == f"{numbers_of_loads(ALL_LOADS)} {PUMPING.of_reaction(ALL_LOADS, 'pin').peak()}\n"
