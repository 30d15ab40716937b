"""The galleries of figures and of findings, drawn now, each with its code and its numbers."""

from __future__ import annotations

import importlib
import os
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
FIGURES = """# Figures of the paper

Each figure is drawn when this site is built; its numbers are asserted by its own `check()`.

"""
FINDINGS = """# Findings

Things that are proved with this library. "Proved" means: for the model and the numbers that are named.
Figures and numbers were made when this site was built; each module asserts more digits of them by its own `check()`.

"""


def galleries(folder: Path) -> dict[str, str]:
    """The two pages in MyST by their names; pictures go into `folder`. Modules work side by side."""
    findings, figures = (modules(EXAMPLES / name) for name in ("findings", "figures"))
    with ProcessPoolExecutor(max_workers=os.cpu_count()) as pool:
        made = dict(zip([*findings, *figures], pool.map(section, [*findings, *figures], [folder] * 99), strict=False))
    return {
        "index": FIGURES + "\n".join(made[one] for one in figures),
        "findings": FINDINGS + "\n".join(made[one] for one in findings),
    }


def modules(folder: Path) -> list[Path]:
    """The modules of a folder that can be drawn and checked."""
    texts = {source: source.read_text(encoding="utf-8") for source in sorted(folder.glob("*.py"))}
    return [one for one, text in texts.items() if "def visualize(" in text and "def check(" in text]


def section(source: Path, folder: Path) -> str:
    """Heading, words, picture and code of one module; made anew where it or the library has changed."""
    picture, words = folder / f"{source.stem}.svg", folder / "words" / f"{source.stem}.txt"
    if not (newer(picture, source) and newer(words, source)):
        words.parent.mkdir(parents=True, exist_ok=True)
        sys.path.insert(0, str(source.parent))
        module = importlib.import_module(source.stem)
        about = (module.__doc__ or "").split("\n")[0]
        words.write_text(about + "\n" + story(source, module), encoding="utf-8")
        module.visualize(picture)
    about, told = words.read_text(encoding="utf-8").split("\n", 1)
    code = os.path.relpath(source, folder)
    return f"""{told.strip()}

```{{figure}} {picture.name}
:alt: {about}
```

:::{{dropdown}} Code
```{{literalinclude}} {code}
:language: python
```
:::
"""


def story(source: Path, module: object) -> str:
    """The text beside a module with its numbers filled in; without one, the module's own first paragraphs."""
    text = source.with_suffix(".md")
    if text.exists():
        return text.read_text(encoding="utf-8").format_map(module.numbers())  # type: ignore[attr-defined]
    first, _, rest = (module.__doc__ or "").partition("\n")
    heading, _, about = first.partition(": ")
    return f"## {heading}\n\n{about[:1].upper()}{about[1:]}\n\n{rest.strip()}\n"


def newer(made: Path, source: Path) -> bool:
    """Of this build, or of one after the last change of its source and of the library."""
    if not made.exists():
        return False
    sources = [*(ROOT / "mpsolve").rglob("*.py"), *source.parent.glob("*.*")]
    return made.stat().st_mtime > max(path.stat().st_mtime for path in sources)
