from __future__ import annotations

import sys
from collections.abc import Callable

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

np.seterr(all="ignore")


