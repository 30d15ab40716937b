"""Names for arrays of numbers, for annotations: what an array holds, whatever its shape."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Reals = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Integers = NDArray[np.int64]
Truths = NDArray[np.bool_]
