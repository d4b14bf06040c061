#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# slice_fmu.sh BERM LIBRARIES DRIVER [NAME=VALUE...]: writes the units of slice.toml here, unpacks them, runs the motion beside them, and drives them, with these variables of the environment.
set -e
case_file=$(dirname "$0")/slice.toml
rm -rf unit* run
"$1" fmu "$case_file" --set 'stage.follow.until.time="10 ms"' -o unit
"$1" run "$case_file" --threads 1 -o run --set stage.follow.drive.y.hold=false --set 'stage.follow.drive.x.velocity="0.2 m/s"' --set 'stage.follow.drive.y.velocity="-0.0625 m/s"' --set 'stage.follow.until.time="4 ms"'
for version in 2 3; do python3 -m zipfile --extract "unit.fmi$version.fmu" "unit $version"; done
env -u LD_LIBRARY_PATH "$3" "$PWD" alone
libraries=$2 driver=$3
shift 3
env "$@" LD_LIBRARY_PATH="$libraries" "$driver" "$PWD"
