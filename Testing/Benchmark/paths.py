# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Imported first: where the modules are that the benchmark shares with the other measurements."""

import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[2]
sys.path[1:1] = [str(PROJECT / folder) for folder in ("Testing/Accuracy", "Testing/Reference",
                                                      "Examples/Data")]
sys.dont_write_bytecode = True
