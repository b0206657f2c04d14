"""What a notebook shows: tables and pages as HTML, and plots by matplotlib, which is imported for a plot only."""

from __future__ import annotations

import html
import math
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from kin._errors import KinError

if TYPE_CHECKING:
    from kin._answers import Forces
    from kin._kin import Cycle, Linkage, Mechanism, Quantity, Sweep


class _Scale(NamedTuple):
    """How a number is shown: what it is multiplied by, and its unit."""

    factor: float
    unit: str

    def label(self, name: str) -> str:
        return f"{name} [{self.unit}]" if self.unit else name


def _scale(measure: str | None, order: int = 0, *, length: str = "", time: str = "s", force: str = "") -> _Scale:
    """Degrees for angles, and units for derivatives by time. A unit that is not named leaves out those made of it."""
    force = force or ("N" if (length, time) == ("m", "s") else "")
    units = {
        "angle": "deg",
        "length": length,
        "number": "1",
        "force": force,
        "torque": force and length and f"{force}·{length}",
        "power": "W" if (force, length, time) == ("N", "m", "s") else force and length and f"{force}·{length}/{time}",
        "time": time,
    }
    unit = units.get(measure or "", "")
    if unit and order:
        unit += f"/{time}{('', '²', '³', '⁴')[order - 1]}"
    return _Scale(math.degrees(1.0) if measure == "angle" else 1.0, "" if unit == "1" else unit)


def _measure(sweep: Sweep) -> str:
    """What the variable of a sweep measures."""
    return "time" if sweep.variable == "time" else sweep.linkage.mechanism.measure_of(sweep.variable)


def _cell(cell: Any) -> str:
    if isinstance(cell, float):
        return f"{cell:.6g}".replace("-", "−")
    return html.escape(str(cell))


def _row(cells: Iterable[Any], tag: str) -> str:
    return "<tr>" + "".join(f"<{tag}>{_cell(cell)}</{tag}>" for cell in cells) + "</tr>"


def _table(head: Iterable[str], rows: Iterable[Iterable[Any]]) -> str:
    body = "".join(_row(row, "td") for row in rows)
    return f"<table><thead>{_row(head, 'th')}</thead><tbody>{body}</tbody></table>"


def _title(title: Any) -> str:
    return f"<p><b>{html.escape(str(title))}</b></p>"


def mechanism_as_html(mechanism: Mechanism) -> str:
    """The equations of a mechanism, and the names of its quantities."""
    names = {
        "dimensions": mechanism.dimensions,
        "inputs": mechanism.inputs,
        "unknowns": mechanism.unknowns,
        "outputs": mechanism.outputs,
        "assemblies": tuple(filter(None, mechanism.assemblies)),
    }
    rows = [(kind, ", ".join(of_kind)) for kind, of_kind in names.items() if of_kind]
    equations = f'<div style="width: fit-content">{mechanism.mathml}</div>'
    return _title(mechanism.name) + equations + _table((), rows)


def linkage_as_html(linkage: Linkage) -> str | None:
    """The page of a linkage; nothing where it needs more than the linkage, and then its text is shown."""
    try:
        return linkage.report()._repr_html_()
    except KinError:
        return None


def sweep_as_html(sweep: Sweep) -> str:
    """The extremes of unknowns and outputs along a sweep, and of their derivatives."""
    table, variable, mechanism = sweep.table(), _scale(_measure(sweep)), sweep.linkage.mechanism
    rows: list[tuple[Any, ...]] = []
    for name in table.names:
        quantity = sweep.of(name)
        if name == "time" or {name, name.rpartition("_")[0]} & set(mechanism.inputs):
            continue
        scale = _scale(quantity.measure, quantity.order)
        try:
            ends = quantity.lowest(), quantity.highest()
        except KinError as error:
            rows.append((scale.label(name), str(error), "", "", ""))
        else:
            cells = [number for end in ends for number in (end.value * scale.factor, end.at * variable.factor)]
            rows.append((scale.label(name), *cells))
    at = variable.label(f"at {sweep.variable}")
    limits = [(limit.kind, limit.at * variable.factor, limit.block) for limit in table.limits]
    return (
        _title(f"{sweep.linkage!r}, {len(sweep)} rows")
        + _table(("quantity", "lowest", at, "highest", at), rows)
        + (_table(("limit", at, "block"), limits) if limits else "")
    )


def cycle_as_html(cycle: Cycle) -> str:
    """The branches of a cycle, and the strokes of the unknowns along its circuits."""
    mechanism = cycle.linkage.mechanism
    moving = _scale(mechanism.measure_of(cycle.moving))
    branches = [
        (
            index,
            branch.circuit,
            branch.assembly or "",
            *(end * moving.factor for end in branch.range),
            "yes" if branch.is_full_revolution else "no",
        )
        for index, branch in enumerate(cycle.branches)
    ]
    strokes: list[tuple[Any, ...]] = []
    for circuit in range(len(cycle.circuits)):
        for name in mechanism.unknowns:
            scale = _scale(mechanism.measure_of(name))
            try:
                low, high = cycle.stroke(name, circuit)
            except KinError as error:
                strokes.append((circuit, scale.label(name), str(error), "", ""))
            else:
                ends = [end.value * scale.factor for end in (low, high)]
                strokes.append((circuit, scale.label(name), *ends, ends[1] - ends[0]))
    sides = [moving.label(f"{side} {cycle.moving}") for side in ("from", "to")]
    return (
        _title(repr(cycle.linkage))
        + _table(("branch", "circuit", "assembly", *sides, "full revolution"), branches)
        + _table(("circuit", "quantity", "lowest", "highest", "stroke"), strokes)
        + ("" if cycle.is_complete else "<p>The search is not complete: there may be other branches.</p>")
    )


def forces_as_html(forces: Forces) -> str:
    """The forces in all joints, and the efforts of the drives."""
    joints = [
        (name, force.on, force.by, force.x, force.y, force.moment, force.magnitude)
        if force
        else (name, "not determined", "", "", "", "", "")
        for name, force in forces.joints.items()
    ]
    efforts = [
        (name, "not determined" if effort is None else float(effort)) for name, effort in forces.efforts.items()
    ]
    head = ("joint", "force on", "by", "x", "y", "moment", "size")
    return _table(head, joints) + _table(("drive of", "effort"), efforts)


def plot(
    sweep: Sweep,
    quantities: tuple[str | Quantity, ...],
    *,
    length: str = "",
    time: str = "s",
    force: str = "",
    ax: Any = None,
) -> Any:
    """Plots quantities over a sweep: see `kin.Sweep.plot`."""
    from matplotlib import pyplot
    from matplotlib.ticker import MaxNLocator

    asked = quantities or sweep.linkage.mechanism.unknowns
    columns = [sweep.of(quantity) if isinstance(quantity, str) else quantity for quantity in asked]
    if ax is None:
        size = 6.4, 1.0 + 2.4 * len(columns)
        _, ax = pyplot.subplots(len(columns), sharex=True, figsize=size, layout="constrained")
    variable = _scale(_measure(sweep), length=length, time=time)
    together = len(columns) > 1 and not np.iterable(ax)
    axes = [ax] * len(columns) if together else np.atleast_1d(ax)
    if len(axes) != len(columns):
        raise ValueError(f"there are {len(columns)} quantities and {len(axes)} axes: give one for all or one for each")
    for axis, quantity in zip(axes, columns, strict=True):
        scale = _scale(quantity.measure, quantity.order, length=length, time=time, force=force)
        label = scale.label(quantity.name)
        axis.plot(sweep.at * variable.factor, quantity.column() * scale.factor, label=label)
        axis.set_ylabel("" if together else label)
        axis.grid(True, alpha=0.3)
        if variable.unit == "deg":
            axis.xaxis.set_major_locator(MaxNLocator(9, steps=[1, 3, 4.5, 6, 9, 10]))
    if together:
        ax.legend()
    axes[-1].set_xlabel(variable.label(sweep.variable))
    return ax
