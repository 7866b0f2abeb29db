#!/bin/sh
# The gate: a line an equation, see gate.awk. Reads what make check has left in BUILD, and DATA; writes BUILD/gate.csv.
set -eu
LC_ALL=C awk -f paper/read.awk -f tests/project/gate.awk -v build="$BUILD" -v data="${DATA-data}" -v csv_file="$BUILD/gate.csv.tmp"
mv "$BUILD/gate.csv.tmp" "$BUILD/gate.csv"
