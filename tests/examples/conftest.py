"""The files and folders of examples are modules in these tests: `import paper` is examples/paper."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "examples"))
