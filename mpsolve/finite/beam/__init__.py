"""The paper's finite beam, Section 4.1: (41) and (52), in its own units; an independent second way to the motion."""
