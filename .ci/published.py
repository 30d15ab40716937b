"""Checks what is published: python .ci/published.py SDIST WHEEL

The sdist holds every file of the repository that its tests, examples and certificates need, the wheel every file of
the package and nothing else; both carry the licence. Exit status 1, with what is wrong, otherwise.
"""

from __future__ import annotations

import sys
import tarfile
import zipfile
from pathlib import Path

ROOT = Path(__file__).parents[1]
FOLDERS = ("mpsolve", "tests", "examples", "certs", "docs", ".ci")
FILES = ("README.md", "CHANGELOG.md", "CITATION.cff", "LICENSE", "pyproject.toml", "MANIFEST.in")
IGNORED = ("__pycache__", ".pyc", "docs/_build", "jupyter_execute", "_generated")


def here(folder: str) -> set[str]:
    """The files of the folder, without what running leaves behind."""
    found = (path for path in (ROOT / folder).rglob("*") if path.is_file())
    return {str(path.relative_to(ROOT)) for path in found if not any(part in str(path) for part in IGNORED)}


def wrong(sdist: str, wheel: str) -> list[str]:
    """A sentence for each file that is missing or does not belong."""
    with tarfile.open(sdist) as archive:
        carried = {member.name.partition("/")[2] for member in archive.getmembers() if member.isfile()}
    with zipfile.ZipFile(wheel) as archive:
        installed = set(archive.namelist())
    wanted = set(FILES).union(*map(here, FOLDERS))
    said = [f"the sdist lacks {name}" for name in sorted(wanted - carried)]
    package = {name for name in installed if ".dist-info/" not in name}
    said += [f"the wheel lacks {name}" for name in sorted(here("mpsolve") - package)]
    said += [f"the wheel has {name}, which is not in the package" for name in sorted(package - here("mpsolve"))]
    if not any(name.endswith("/licenses/LICENSE") for name in installed):
        said.append("the wheel lacks the licence")
    return said


if __name__ == "__main__":
    found = wrong(*sys.argv[1:3])
    print("\n".join(found) or "the sdist and the wheel are complete")
    sys.exit(bool(found))
