"""Numbers in the units of drawings: degrees, and revolutions per minute."""

from __future__ import annotations

import math
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

_RADIANS = math.pi / 180.0


@overload
def deg(degrees: float) -> float: ...
@overload
def deg(degrees: tuple[float, ...]) -> tuple[float, ...]: ...
@overload
def deg(degrees: list[float] | NDArray[Any]) -> NDArray[np.float64]: ...
def deg(
    degrees: float | tuple[float, ...] | list[float] | NDArray[Any],
) -> float | tuple[float, ...] | NDArray[np.float64]:
    """Radians of an angle in degrees; of a tuple, of each of its entries; else of an array.

    >>> import kin
    >>> kin.deg(180.0)
    3.141592653589793
    >>> kin.deg((90.0, 360.0))    # an angle, and its velocity
    (1.5707963267948966, 6.283185307179586)
    """
    if isinstance(degrees, tuple):
        return tuple(deg(angle) for angle in degrees)
    if isinstance(degrees, (int, float)):
        return degrees * _RADIANS
    return np.asarray(degrees, dtype=np.float64) * _RADIANS


def rpm(revolutions: float) -> float:
    """Radians per second of a speed in revolutions per minute.

    >>> import kin
    >>> round(kin.rpm(60.0), 12)
    6.28318530718
    """
    return revolutions * (math.tau / 60.0)
