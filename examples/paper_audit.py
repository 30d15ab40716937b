"""The paper on trial: every claim checked anew, the certificates under certs/paper/, the report as a page beside it.

    python examples/paper_audit.py

takes minutes; `mpsolve audit --only xii` looks at some claims only.
"""

from __future__ import annotations

from pathlib import Path

from mpsolve.audit.page import page
from mpsolve.audit.run import Report, all_claims, audit
from mpsolve.audit.tables import summary
from mpsolve.files import write_whole

HERE = Path(__file__).resolve().parent
FOLDER = HERE.parent / "certs" / "paper"
PAGE = HERE / "paper_audit.html"
CLAIMS = all_claims()


def visualize(report: Report, path: Path = PAGE) -> Path:
    """The report as one self-contained HTML page."""
    return write_whole(path, page(report))


def main() -> None:
    """Checks every claim, and writes the certificates and the page."""
    report = audit(CLAIMS)
    report.save_certificates(FOLDER)
    visualize(report)
    print(summary(report))


if __name__ == "__main__":
    main()
