# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""``python3 -m participating_media`` is the command line ``participating-media``."""

import sys

from .command_line import main

if __name__ == "__main__":
    sys.exit(main())
