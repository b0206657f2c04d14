"""Answers: tuples with names."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from kin._kin import Linkage


class Peak(NamedTuple):
    """A value of a quantity along a sweep, and where."""

    #: The variable of the sweep: radians or the mechanism's unit of length of the input that moves, or the time.
    at: float
    #: The value with its sign.
    value: float
    #: "inner", or "limit", "kink", "end".
    kind: str


class Extreme(NamedTuple):
    """A point where a quantity is larger or smaller than on both sides."""

    at: float
    #: None if the quantity grows beyond all bounds there.
    value: float | None
    #: "inner", "limit", "kink", "end" or "unbounded".
    kind: str
    is_maximum: bool


class Crossing(NamedTuple):
    """A point where a quantity crosses a level."""

    at: float
    is_rising: bool


class Dwell(NamedTuple):
    """A part of a sweep on which a quantity keeps to a level."""

    start: float
    end: float
    #: In the unit of time.
    duration: float


class Mean(NamedTuple):
    """A mean along a sweep."""

    value: float
    #: The estimate of the error of the value.
    error: float
    #: The part of the sweep in which the mechanism closes, from 0 to 1.
    covered: float


class Sensitivity(NamedTuple):
    """The derivatives of a peak with respect to a dimension."""

    #: That of the value.
    value: float
    #: That of the place.
    at: float


class PeakSensitivities(NamedTuple):
    """A peak, and how it depends on every dimension."""

    peak: Peak
    #: By the names of the scalar dimensions.
    by: dict[str, Sensitivity]


class Limit(NamedTuple):
    """A point of a sweep where the mechanism begins or ceases to close."""

    at: float
    #: "limit position", "change point", "pole", or "end of a domain or range".
    kind: str
    #: The last row before it.
    row: int
    closes_before: bool
    #: The unknowns of the block that does not close, separated by commas.
    block: str


class Branch(NamedTuple):
    """A part of a circuit on which the input moves in one direction."""

    #: The smallest and the largest input.
    range: tuple[float, float]
    #: None if a position is chosen by values nearby.
    assembly: str | None
    #: The index of its circuit.
    circuit: int
    is_full_revolution: bool


class Circuit(NamedTuple):
    """Branches that are connected by limits and change points."""

    #: The indices of the branches.
    branches: tuple[int, ...]
    is_closed: bool
    #: The revolutions of the input once around, 0 if it swings; None if the circuit is not closed.
    input_revolutions: int | None


class CircuitPeak(NamedTuple):
    """A value of a quantity along a circuit, and where."""

    value: float
    #: The input there.
    input: float
    #: The index of the branch.
    branch: int


class Stroke(NamedTuple):
    """The range of a quantity along a circuit."""

    low: CircuitPeak
    high: CircuitPeak

    @property
    def length(self) -> float:
        """The difference of the largest and the smallest value."""
        return self.high.value - self.low.value


class WorstTransmission(NamedTuple):
    """The smallest transmission angle along a circuit."""

    #: The unknowns of the dyad, separated by commas.
    block: str
    #: The smaller of the angle and its supplement, in radians.
    angle: float
    input: float
    branch: int


class Force(NamedTuple):
    """The force in a joint."""

    x: float
    y: float
    z: float
    #: The moment of a slide.
    moment: float
    #: The size of the force.
    magnitude: float
    #: The body on which it acts.
    on: str
    #: The body that exerts it, which may be the ground.
    by: str


class Efficiency(NamedTuple):
    """Powers of drives and of friction: in a pose, or their means along a motion."""

    #: The power of all drives; below zero if loads drive them.
    input: float
    #: The power that friction turns into heat.
    heat: float

    @property
    def output(self) -> float:
        """The power that is left for the loads."""
        return self.input - self.heat

    @property
    def ratio(self) -> float | None:
        """The part of the power that passes the joints; zero or less if friction takes all; None without power."""
        part, whole = (self.input, self.output) if self.input < 0 else (self.output, self.input)
        return part / whole if whole else None


class ForcePlace(NamedTuple):
    """A place of a motion, and what the force there is at least."""

    force: float
    #: The first input that moves, its velocity and its acceleration.
    at: float
    velocity: float
    acceleration: float
    #: All scalar dimensions, of which those with tolerances are within them.
    dimensions: dict[str, float]


class ForceVerdict(NamedTuple):
    """Whether a force stays below a limit, for all inputs and all dimensions within tolerances."""

    #: "holds", "fails", or "undecided".
    answer: str
    #: A number that the force exceeds nowhere, if it holds.
    upper: float | None
    #: A place where it certainly fails.
    place: ForcePlace | None
    #: Why nothing is known, if it is undecided.
    reason: str


class PeakBounds(NamedTuple):
    """Bounds of the largest size of a force."""

    #: A place where the force is nearly as large as it can be.
    lower: ForcePlace
    #: A number that the force exceeds nowhere.
    upper: float


class Fitted(NamedTuple):
    """Dimensions that were fitted to measured numbers."""

    #: The linkage with these dimensions.
    linkage: Linkage
    #: For each column the root of the mean square of what it deviates; None if no row with a value closes.
    deviations: dict[str, float | None]
    #: The same with the dimensions at the start.
    deviations_at_start: dict[str, float | None]
    #: Whether no other dimensions nearby are better.
    is_minimum: bool
    #: The number of rows in which the linkage does not close.
    unclosed_rows: int


class Forces(NamedTuple):
    """The forces in a pose."""

    #: By the names of the joints; None where equilibrium alone does not determine a force.
    joints: dict[str, Force | None]
    #: The torque or force of the drive of each input, likewise.
    efforts: dict[str, float | None]
    #: The powers of drives and friction; None if one of them is not determined.
    efficiency: Efficiency | None

    def _repr_html_(self) -> str:
        from kin._show import forces_as_html

        return forces_as_html(self)


class C(NamedTuple):
    """A solver in C99."""

    #: The name of the files without their endings.
    name: str
    header: str
    source: str
    #: A program that calls the solver.
    example: str
