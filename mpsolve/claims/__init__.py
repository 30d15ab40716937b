"""The claims of a paper, checked anew: what a claim is, how a paper is loaded, checked and reported.

The papers themselves are folders of data outside this package, as `examples/paper`.
"""

from mpsolve.claims.claim import Claim, Finding, Paper, Printed, Verdict

__all__ = ["Claim", "Finding", "Paper", "Printed", "Verdict"]
