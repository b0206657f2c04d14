"""Exceptions."""

from __future__ import annotations

from typing import NamedTuple


class KinError(Exception):
    """All exceptions of kin that are not mistakes in a call."""


class Mistake(NamedTuple):
    """A mistake in a declaration, at the tokens from its start to its end. Lines and columns count from 1."""

    #: What is wrong, and then what to write instead.
    message: str
    #: What is wrong.
    fault: str
    #: What to write instead; None where the fault alone says it.
    advice: str | None
    line: int
    column: int
    end_line: int
    #: The column behind the last letter.
    end_column: int


class DeclarationError(KinError, ValueError):
    """A text declares no mechanism. The message shows each mistake with its line and a mark below the tokens at fault.

    >>> import kin
    >>> try:
    ...     kin.Mechanism("struct Crank { r: Length } input theta: Angle; unknown x: Length; x == q * cos(theta);")
    ... except kin.DeclarationError as error:
    ...     mistake = error.mistakes[0]
    >>> mistake.line, mistake.column, mistake.fault, mistake.advice
    (1, 72, 'no parameter, input, unknown, `let` or output is called `q`', 'did you mean `r`?')
    """

    #: All mistakes, in the order of the text; none if the declaration is too large.
    mistakes: list[Mistake]
    #: The text.
    text: str

    def __init__(self, message: str, mistakes: list[Mistake], text: str) -> None:
        super().__init__(message, mistakes, text)
        self.mistakes = mistakes
        self.text = text

    def __str__(self) -> str:
        return str(self.args[0])


class SolveError(KinError, ValueError):
    """A mechanism does not close at its inputs, or its position is singular.

    >>> import kin
    >>> linkage = kin.library.four_bar(r1=90, r2=30, r3=60, r4=45)
    >>> try:
    ...     linkage.solve(theta2=3.0, assembly="open")
    ... except kin.SolveError as error:
    ...     print(error.kind, error.block, error.margin < 0, error.inputs)
    out of reach theta3, theta4 True {'theta2': 3.0}
    """

    #: The unknowns of the block that is not solved, separated by commas.
    block: str
    #: The reason in two words: "out of reach", "singular", "out of range", "ambiguous", "outside domain", "not
    #: converged", "too many revolutions", "not finite".
    kind: str
    #: The missing length as a negative number; zero in a singular position; None if the reason is another one.
    margin: float | None
    #: The inputs, in radians and the mechanism's unit of length.
    inputs: dict[str, float]

    def __init__(self, message: str, block: str, kind: str, margin: float | None, inputs: dict[str, float]) -> None:
        super().__init__(message, block, kind, margin, inputs)
        self.block = block
        self.kind = kind
        self.margin = margin
        self.inputs = inputs

    def __str__(self) -> str:
        return str(self.args[0])


class TrackError(KinError, ValueError):
    """A motion ends before its target, or geometry does not determine how it goes on.

    >>> import kin
    >>> pose = kin.library.four_bar(r1=90, r2=30, r3=60, r4=45).solve(theta2=0.0, assembly="open")
    >>> try:
    ...     pose.track_to(theta2=3.0)
    ... except kin.TrackError as error:
    ...     print(error.kind, round(error.inputs["theta2"], 6))
    limit position 1.706354
    """

    #: "limit position", "change point", "pole", "too many steps" or "lost".
    kind: str
    #: The part of the way that is behind, from 0 to 1.
    fraction: float
    #: The inputs there.
    inputs: dict[str, float]
    #: The unknowns there.
    unknowns: dict[str, float]

    def __init__(
        self, message: str, kind: str, fraction: float, inputs: dict[str, float], unknowns: dict[str, float]
    ) -> None:
        super().__init__(message, kind, fraction, inputs, unknowns)
        self.kind = kind
        self.fraction = fraction
        self.inputs = inputs
        self.unknowns = unknowns

    def __str__(self) -> str:
        return str(self.args[0])


class AnswerError(KinError, ValueError):
    """A question to a sweep or a cycle has no answer."""

    #: The variable of the sweep at the point at fault, or None.
    at: float | None

    def __init__(self, message: str, at: float | None = None) -> None:
        super().__init__(message, at)
        self.at = at

    def __str__(self) -> str:
        return str(self.args[0])
