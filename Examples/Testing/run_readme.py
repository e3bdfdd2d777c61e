#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the README's Python program as it stands there.

usage: run_readme.py README.md FOLDER"""

import os
import re
import sys
from pathlib import Path


def main() -> None:
    readme, folder = Path(sys.argv[1]), Path(sys.argv[2])
    program = re.search(r"```python\n(.*?)```", readme.read_text(encoding="utf-8"), re.DOTALL)
    folder.mkdir(parents=True, exist_ok=True)
    os.chdir(folder)
    exec(compile(program.group(1), str(readme), "exec"), {"__name__": "__main__"})


if __name__ == "__main__":
    main()
