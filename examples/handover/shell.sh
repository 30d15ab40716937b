#!/bin/sh
# What another solver takes from mpsolve, from the shell: one JSON file for each question, and the tables that
# read_seeds, read_receptance and read_onset (.m for MATLAB and Octave, .mpl for Maple) import.
#
#     sh examples/handover/shell.sh        (in the folder of the project; writes into the working directory)
set -eu
case=examples/dimensionless.toml

# the induced frequencies, proved: roots[].re.value and roots[].im.value, as many digits as you ask for
mpsolve certify $case --digits 20 --json -o induced.certificate.json > induced.json
# the receptance G(xi, omega) of the track, as JSON and for text import: xi ahead of the force is positive
mpsolve receptance $case --xi=-1.5,0,1.5 --omega 0.02,0.3,15 --json -o receptance.json
mpsolve receptance $case --xi=-1.5,0,1.5 --omega 0.02,0.3,15 -o receptance.csv
# receptance and dynamic stiffness between the contacts: contacts.G_re[omega][i][j], contacts.K_re
mpsolve receptance $case --omega 0.02,0.3,15 --contacts --json -o contacts.json
# a box of parameters all over which it is proved stable: answer.stable, answer.over
mpsolve robust $case --over v=0..0.6 --over scale.mass=0.9..1.1 --json > box.json
# the first unstable velocity, proved: answer.value.decimal
mpsolve onset $case --over v=0..1 --digits 20 --json > onset.json
