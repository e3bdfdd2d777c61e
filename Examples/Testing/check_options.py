#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Gives the command line bad options, and checks that it says so in one line and ends with 2.

usage: check_options.py VOLUME COMMAND ..."""

import subprocess
import sys

#: Options, and a word that the message must contain.
BAD = (
    (["--size", "0x10"], "1 … 16384"),
    (["--size", "wide"], "--size"),
    (["--step", "-1"], "--step"),
    (["--step", "nan"], "--step"),
    (["--anisotropy", "2"], "-1 … 1"),
    (["--light", "0,0,0"], "no direction"),
    (["--light", "1,2"], "3 numbers"),
    (["--range", "5,1", "--medium", "ramp"], "LOW < HIGH"),
    (["--integrator", "best"], "invalid choice"),
    (["--integrator", "paper", "--threshold", "1e9"], "threshold"),
    (["--output", "/dev/null/picture.png"], "/dev/null"),
)


def main() -> int:
    volume, command = sys.argv[1], sys.argv[2:]
    wrong = 0
    for options, word in BAD:
        done = subprocess.run([*command, volume, "--size", "16x16", "--step", "20", *options],
                              capture_output=True, text=True, check=False, timeout=60)
        lines = done.stderr.splitlines()
        if done.returncode != 2 or len(lines) != 1 or word not in lines[0]:
            wrong += 1
            print(f"{options}: exit code {done.returncode}, expected 2 and one line with '{word}', "
                  f"found:\n{done.stderr}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
