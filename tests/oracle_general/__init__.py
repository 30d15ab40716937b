"""An independent second way to what the general engine proves: residue sums and counts in floats, and in mpmath.

Nothing of the package is imported: D and N of each track and M, C, K, B of each vehicle are typed here by hand, so
that a slip in the package's models is found too. A problem is plain data:

    {"track": {"model": "string", "T": "27000", "m": "1.07", "k": "500", "c": "2"},
     "vehicles": [{"model": "mass", "M": "8.5", "at": "0"}], "v": "100"}
"""

from oracle_general.count import Alarm, count_below, turning
from oracle_general.floats import Floats
from oracle_general.precise import Precise
from oracle_general.roots import growing, roots_in_rectangle

__all__ = ["Alarm", "Floats", "Precise", "count_below", "growing", "roots_in_rectangle", "turning"]
