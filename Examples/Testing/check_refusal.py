#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Gives programs what they cannot read, and checks that each says so in one line and ends with 2.

usage: check_refusal.py FOLDER PROGRAM ... -- PROGRAM ...; each is run with a path as last argument,
and --help must end with 0."""

import subprocess
import sys
from pathlib import Path


def unreadable(folder: Path) -> list[tuple[Path, str]]:
    """Paths that hold no volume, each with a word that the message must contain."""
    folder.mkdir(parents=True, exist_ok=True)
    empty_folder = folder / "empty_folder"
    empty_folder.mkdir(exist_ok=True)
    rubbish = [folder / f"rubbish.{kind}" for kind in ("vti", "nii", "nii.gz", "mha", "nrrd")]
    for path in rubbish:
        path.write_bytes(b"this is no volume" * 40)
    unknown = folder / "volume.xyz"
    unknown.write_bytes(b"0")
    cut = folder / "cut.vti"
    cut.write_text('<?xml version="1.0"?>\n<VTKFile type="ImageData" version="0.1">\n<ImageData')
    return [(path, "cannot read") for path in [*rubbish, cut, empty_folder]] + [
        (unknown, "unknown kind"), (folder / "missing.vti", "no such file")]


def main() -> int:
    folder, arguments = Path(sys.argv[1]), sys.argv[2:]
    programs, program = [], []
    for argument in [*arguments, "--"]:
        if argument == "--":
            programs.append(program)
            program = []
        else:
            program.append(argument)
    wrong = 0
    for program in programs:
        for path, word in unreadable(folder):
            done = subprocess.run([*program, str(path)], capture_output=True, text=True,
                                  check=False, timeout=60)
            lines = done.stderr.splitlines()
            fine = (done.returncode == 2 and len(lines) == 1 and str(path) in lines[0]
                    and word in lines[0])
            if not fine:
                wrong += 1
                print(f"{' '.join(program)} {path}: exit code {done.returncode}, expected 2; "
                      f"expected one line with '{word}', found:\n{done.stderr}")
        if subprocess.run([*program, "--help"], capture_output=True, check=False).returncode:
            wrong += 1
            print(f"{' '.join(program)} --help failed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
