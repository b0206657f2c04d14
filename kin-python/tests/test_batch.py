"""Whole arrays."""

import gc
import multiprocessing
import threading

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import kin

FOUR_BAR = kin.library.four_bar
DIMENSIONS = {"r1": 90.0, "r2": 30.0, "r3": 70.0, "r4": 60.0}


def solve(**given):
    return FOUR_BAR.solve_batch(**{**DIMENSIONS, "assembly": "open", **given})


def test_dimensions_and_inputs_broadcast():
    cranks = np.linspace(10, 40, 7)[:, None]
    angles = np.linspace(0, 6, 50)
    batch = solve(r2=cranks, theta2=(angles, 10.0))
    assert batch.shape == batch.solved.shape == batch.margin.shape == batch.theta4.jerk.shape == (7, 50)
    assert len(batch) == 7
    for row in range(7):
        for column in (0, 20, 49):
            if batch.solved[row, column]:
                linkage = FOUR_BAR(**{**DIMENSIONS, "r2": cranks[row, 0]})
                pose = linkage.solve(theta2=(angles[column], 10.0), assembly="open")
                assert abs(batch.theta4.snap[row, column] - pose.theta4.snap) <= 1e-10 * abs(pose.theta4.snap)


def test_masks_and_margins():
    linkage = FOUR_BAR(r1=90, r2=30, r3=60, r4=45)
    angles = np.linspace(-3, 3, 1001)
    batch = linkage.solve_batch(theta2=angles, assembly="open")
    distance = np.hypot(90 - 30 * np.cos(angles), 30 * np.sin(angles))
    assert (batch.solved == (distance <= 105)).all()
    assert np.isnan(batch.theta4.position[~batch.solved]).all()
    assert np.isfinite(batch.theta4.snap[batch.solved]).all()
    assert np.isnan(batch.margin[batch.solved]).all()
    assert np.allclose(batch.margin[~batch.solved], (105 - distance)[~batch.solved], rtol=0, atol=1e-11)
    index, error = batch.first_failure
    assert index == 0 and isinstance(error, kin.SolveError) and error.inputs == {"theta2": -3.0}
    assert linkage.solve_batch(theta2=0.0, assembly="open").first_failure is None


def test_limit_positions_are_singular():
    # both links on one line, in numbers without rounding
    batch = solve(r1=np.full(3, 4.0), r2=1.0, r3=2.0, r4=1.0, theta2=(0.0, 1.0))
    assert not batch.solved.any() and batch.singular.all()


@pytest.mark.parametrize("shape", [(), (0,), (3, 0), (1,), (2, 3, 4), (511,), (8192,), (8193,), (8703,), (8704,)])
def test_shapes(shape):
    batch = solve(theta2=np.full(shape, 1.0))
    assert batch.shape == batch.theta3.position.shape == shape
    assert batch.solved.all()
    assert repr(batch) == f"<kin.Batch of {int(np.prod(shape))} poses: theta3, theta4>"


def test_points_have_their_coordinates_first():
    linkage, at = kin.library.example("five_bar")
    alpha = at["alpha"] + np.linspace(0, 0.1, 20).reshape(4, 5)
    hand = linkage.solve_batch(**{**at, "alpha": alpha}).hand
    assert hand.position.shape == (2, 4, 5) and hand.x.position.shape == (4, 5)
    assert np.shares_memory(hand.position, hand.x.position)
    pose = linkage.solve(**{**at, "alpha": alpha[2, 3]})
    assert np.allclose(hand.position[:, 2, 3], pose.hand.position, rtol=1e-14)
    assert np.isclose(linkage.solve_batch(**at)["hand.y"].position, hand.y.position[0, 0], rtol=1e-14)


def test_columns_are_not_copied():
    batch = solve(theta2=np.linspace(0, 1, 1000))
    column = batch.theta4.position
    assert column is batch.theta4.position
    kept = column.copy()
    del batch
    gc.collect()
    assert (column == kept).all() and column.flags.writeable


def test_orders():
    batch = solve(theta2=(np.linspace(0, 1, 10), 10.0), order=1)
    assert len(batch.theta4.derivatives) == 2
    assert (batch.theta4.velocity == solve(theta2=(np.linspace(0, 1, 10), 10.0)).theta4.velocity).all()
    with pytest.raises(AttributeError, match="`theta4` has no jerk"):
        batch.theta4.jerk
    with pytest.raises(ValueError, match="FourBar has derivatives up to order 4"):
        solve(theta2=1.0, order=5)


@pytest.mark.parametrize(
    "angles",
    [
        np.linspace(0, 1, 40).astype(np.float32),
        np.linspace(0, 1, 40).astype(np.float16),
        np.linspace(0, 1, 40).astype(">f8"),
        np.arange(40),
        np.arange(40, dtype=np.uint8),
        np.linspace(0, 1, 80)[::2],
        np.linspace(0, 1, 40)[::-1],
        np.asfortranarray(np.linspace(0, 1, 40).reshape(5, 8)),
        np.linspace(0, 1, 40).reshape(5, 8).T,
        np.broadcast_to(np.linspace(0, 1, 8), (5, 8)),
        np.lib.stride_tricks.sliding_window_view(np.linspace(0, 1, 40), 3),
    ],
)
def test_memory_of_any_kind(angles):
    angles.flags.writeable = False
    expected = solve(theta2=np.ascontiguousarray(angles, dtype=np.float64))
    found = solve(theta2=angles)
    assert found.shape == angles.shape
    assert (found.theta4.snap == expected.theta4.snap).all()


@pytest.mark.parametrize("angles", [np.ones(3) + 1j, np.array(["1"]), np.array([None]), np.array([True]), object()])
def test_no_real_numbers(angles):
    with pytest.raises(TypeError, match="`theta2` is an array of .*: give real numbers"):
        solve(theta2=angles)


def test_mistakes_in_a_call():
    with pytest.raises(TypeError, match=r"`theta2` is a list, .* write a tuple .* `theta2=\(angles, 10.0\)`"):
        solve(theta2=[1.0, 10.0])
    with pytest.raises(ValueError, match=r"do not broadcast against each other: r1 \(3,\), theta2 \(4,\)"):
        solve(r1=np.ones(3), theta2=np.ones(4))
    with pytest.raises(ValueError, match="`theta2` has 0 entries"):
        solve(theta2=())
    with pytest.raises(ValueError, match="`theta2`: .*inhomogeneous"):
        solve(theta2=([[1.0], [1.0, 2.0]],))
    with pytest.raises(TypeError, match="no dimension or input is called `r5`: dimensions are r1, r2, r3, r4; inputs"):
        solve(theta2=1.0, r5=1.0)
    with pytest.raises(OverflowError):
        solve(theta2=1.0, threads=-1)


@given(
    arrays.arrays(np.float64, st.integers(0, 40), elements=st.floats(allow_nan=True, allow_infinity=True)),
    st.floats(allow_nan=True, allow_infinity=True),
)
@settings(deadline=None, max_examples=200)
def test_any_numbers(angles, dimension):
    """Numbers are finite where a pose is found, and NaN elsewhere, whatever is given; `solve` agrees."""
    batch = solve(r2=dimension, theta2=(angles, 10.0))
    for order in range(5):
        for quantity in (batch.theta3, batch.theta4):
            assert (np.isfinite(quantity.derivative(order)) == batch.solved).all()
            assert (np.isnan(quantity.derivative(order)) == ~batch.solved).all()
    linkage = FOUR_BAR(**{**DIMENSIONS, "r2": dimension})
    for angle, is_solved in zip(angles, batch.solved):
        try:
            linkage.solve(theta2=(angle, 10.0), assembly="open")
        except kin.SolveError:
            assert not is_solved
        else:
            assert is_solved


def test_threads_change_no_bit():
    angles = np.linspace(-3, 3, 50_001)
    one = solve(r3=60, r4=45, theta2=(angles, 10.0), threads=1)
    for threads in (None, 0, 2, 3, 64):
        many = solve(r3=60, r4=45, theta2=(angles, 10.0), threads=threads)
        assert one.theta4.snap.tobytes() == many.theta4.snap.tobytes()
        assert one.margin.tobytes() == many.margin.tobytes()
        assert str(one.first_failure) == str(many.first_failure)


def test_other_threads_run_meanwhile():
    """The interpreter is not blocked: a thread counts while a batch is solved."""
    counted, ended = [0], threading.Event()

    def count():
        while not ended.is_set():
            counted[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    before = counted[0]
    solve(theta2=(np.linspace(0, 6, 2_000_000), 10.0), threads=1)
    during = counted[0] - before
    ended.set()
    thread.join()
    # the interpreter hands itself over every 5 ms; without that the counter would stand almost still
    assert during > 1000


def test_many_threads_share_a_linkage():
    linkage = FOUR_BAR(**DIMENSIONS)
    expected = linkage.solve_batch(theta2=np.linspace(0, 6, 20_000), assembly="open").theta4.position
    wrong = []

    def work():
        for _ in range(5):
            found = linkage.solve_batch(theta2=np.linspace(0, 6, 20_000), assembly="open").theta4.position
            if not (found == expected).all():
                wrong.append(found)

    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def _largest(linkage):
    batch = linkage.solve_batch(theta2=(np.linspace(0, 6, 50_000), 10.0), assembly="open", threads=2)
    return batch.theta4.jerk.max()


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_processes(method):
    """A process that is forked after a batch solves batches, too."""
    linkage = FOUR_BAR(**DIMENSIONS)
    expected = _largest(linkage)
    with multiprocessing.get_context(method).Pool(2) as pool:
        assert pool.map(_largest, [linkage] * 3) == [expected] * 3


def test_coupled_blocks():
    linkage, at = kin.library.example("stephenson_ii")
    name = linkage.mechanism.inputs[0]
    pose = linkage.solve(**at)
    batch = linkage.solve_batch(**{name: at[name] + np.linspace(0, 0.01, 100)}, near=pose)
    assert batch.solved.all()
    for unknown in linkage.mechanism.unknowns:
        assert abs(batch[unknown].position[0] - pose[unknown].position) < 1e-11


def kept(shape, orders=5):
    """Arrays for a batch, which nothing has written to."""
    return {name: tuple(np.full(shape, 7.0) for _ in range(orders)) for name in ("theta3", "theta4")}


def same(one, other):
    mine, others = ((*batch.theta3.derivatives, *batch.theta4.derivatives) for batch in (one, other))
    return all(mine.tobytes() == others.tobytes() for mine, others in zip(mine, others, strict=True)) and all(
        getattr(one, name).tobytes() == getattr(other, name).tobytes() for name in ("solved", "singular", "margin")
    )


@pytest.mark.parametrize("shape", [(), (0,), (3, 5), (20_000,)])
@pytest.mark.parametrize("order", [0, 2, None])
def test_a_batch_is_solved_into_another(shape, order):
    angles = np.linspace(-3, 3, int(np.prod(shape))).reshape(shape)
    expected = solve(r3=60, r4=45, theta2=(angles, 10.0), order=order)
    first = solve(theta2=(angles, 3.0), order=order)
    memory = [first.solved, first.singular, first.margin, *first.theta3.derivatives, *first.theta4.derivatives]
    again = solve(r3=60, r4=45, theta2=(angles, 10.0), order=order, out=first)
    used = [again.solved, again.singular, again.margin, *again.theta3.derivatives, *again.theta4.derivatives]
    assert all(one is other for one, other in zip(memory, used, strict=True))
    assert same(again, expected) and again.shape == shape
    assert str(again.first_failure) == str(expected.first_failure)


def test_a_batch_is_solved_into_arrays():
    angles = np.linspace(-3, 3, 12_000).reshape(3, 4000)
    expected = solve(r3=60, r4=45, theta2=(angles, 10.0))
    out = {**kept(angles.shape), "solved": np.ones(angles.shape, bool), "margin": np.zeros(angles.shape)}
    found = solve(r3=60, r4=45, theta2=(angles, 10.0), out=out)
    assert found.theta4.snap is out["theta4"][4] and found.solved is out["solved"] and found.margin is out["margin"]
    assert same(found, expected)
    # rows of one array, a list, and one array for positions alone; what is left out is allocated
    rows = np.zeros((5, *angles.shape))
    found = FOUR_BAR(**DIMENSIONS).solve_batch(theta2=(angles, 10.0), assembly="open", out={"theta3": list(rows)})
    assert (rows[4] == solve(theta2=(angles, 10.0)).theta3.snap).all()
    assert not np.shares_memory(rows, found.theta4.snap)
    positions = np.zeros(angles.shape)
    assert solve(theta2=angles, order=0, out={"theta4": positions}).theta4.position is positions
    assert (positions == solve(theta2=angles).theta4.position).all()


def test_points_are_solved_into_arrays():
    linkage, at = kin.library.example("five_bar")
    alpha = at["alpha"] + np.linspace(0, 0.1, 20).reshape(4, 5)
    expected = linkage.solve_batch(**{**at, "alpha": alpha}).hand.position
    hand = np.zeros((2, 4, 5))
    linkage.solve_batch(**{**at, "alpha": alpha}, order=0, out={"hand": hand})
    assert (hand == expected).all()
    with pytest.raises(ValueError, match=r"the position of `hand` has the shape \(4, 5\), and \(2, 4, 5\) is needed"):
        linkage.solve_batch(**{**at, "alpha": alpha}, order=0, out={"hand": hand[0]})


def test_inputs_may_be_the_memory_of_the_result():
    angles = np.linspace(0, 3, 20_000)
    expected = solve(theta2=angles, order=0).theta4.position
    solve(theta2=angles, order=0, out={"theta4": angles})
    assert (angles == expected).all()


def read_only(array):
    array.flags.writeable = False
    return array


@pytest.mark.parametrize(
    "out, kind, message",
    [
        (3, TypeError, "`out` is a kin.Batch, or a dictionary of arrays by the names of unknowns and outputs"),
        ({"theta4": 3}, TypeError, "`out`: the position of `theta4` is of the type int: give an array of NumPy"),
        ({"theta4": np.zeros(9, "f4")}, TypeError, "position of `theta4` is an array of float32: give one of float64"),
        ({"theta4": np.zeros(9, ">f8")}, TypeError, "an array of >f8: give one of float64, in the byte order"),
        ({"solved": np.zeros(9)}, TypeError, "`out`: `solved` is an array of float64: give one of bool"),
        ({"solved": (np.zeros(9, "?"),) * 2}, TypeError, "`out`: give one array for `solved`"),
        ({"theta4": np.zeros(8)}, ValueError, r"position of `theta4` has the shape \(8,\), and \(9,\) is needed"),
        ({"theta4": np.zeros((9, 1))}, ValueError, r"has the shape \(9, 1\), and \(9,\) is needed"),
        ({"theta4": np.zeros(18)[::2]}, ValueError, "numbers of the position of `theta4` do not lie one after the"),
        ({"theta4": np.zeros(73, "u1")[1:].view("f8")}, ValueError, "numbers of the position of `theta4` do not lie"),
        ({"theta4": read_only(np.zeros(9))}, ValueError, "`out`: the position of `theta4` is read-only"),
        ({"theta4": (np.zeros(9),) * 2}, ValueError, "arrays of `theta4` is 2, and 1 are needed: its position$"),
        ({"theta5": np.zeros(9)}, ValueError, "called `theta5`: there are theta3, theta4, and solved, singular and"),
        ({7: np.zeros(9)}, TypeError, "'int' object"),
    ],
)  # fmt: skip
def test_mistakes_in_memory(out, kind, message):
    with pytest.raises(kind, match=message):
        solve(theta2=np.linspace(0, 1, 9), order=0, out=out)


def test_more_mistakes_in_memory():
    angles = np.linspace(0, 1, 9)
    with pytest.raises(ValueError, match="is 1, and 5 are needed: its position and 4 derivatives"):
        solve(theta2=angles, out=solve(theta2=angles, order=0))
    with pytest.raises(ValueError, match=r"has the shape \(9,\), and \(8,\) is needed"):
        solve(theta2=angles[1:], out=solve(theta2=angles))
    with pytest.raises(ValueError, match="called `phi`"):
        solve(theta2=angles, out=kin.library.slider_crank.solve_batch(r=1, l=3, theta=angles, assembly="open"))
    shared = np.zeros(10)
    for one, other in ((shared[:9], shared[1:]), (shared[:9], shared[:9])):
        with pytest.raises(ValueError, match="`out`: two arrays share memory, or another batch is being solved into"):
            solve(theta2=angles, order=0, out={"theta3": one, "theta4": other})
    assert (shared == 0).all()


def test_two_batches_at_once_do_not_share_memory():
    angles = np.linspace(0, 6, 200_000)
    memory = solve(theta2=(angles, 10.0))
    ended, refused = threading.Event(), []

    def again():
        while not ended.is_set():
            try:
                solve(theta2=(angles, 10.0), threads=1, out=memory)
            except ValueError as error:
                refused.append(str(error))

    threads = [threading.Thread(target=again) for _ in range(2)]
    for thread in threads:
        thread.start()
    threading.Event().wait(0.5)
    ended.set()
    for thread in threads:
        thread.join()
    assert set(refused) == {"`out`: two arrays share memory, or another batch is being solved into it"}
