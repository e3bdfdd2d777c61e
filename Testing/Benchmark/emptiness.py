# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""What is saved where almost nothing is: a ball in a volume that is 95 % empty, with all that the renderer
does about it and by plain steps."""

import numpy as np
from points import moved_frames, setting, stage_of

EMPTY = 0.95
#: Code of the user that changes nothing; what bricks and light caches know is then not relied on.
POINT, CODE = "//VTK::Medium::Coefficients::Impl", "// as they are\n"
#: In words, the method and the output.
CASES = {"eye rays": ("ErrorControlled", "OpticalDepth"),
         "eye and light rays": ("ErrorControlled", "Radiance"),
         "without light caches": ("ErrorControlled, no cache", "Radiance")}


def ball(points: int) -> np.ndarray:
    """1 in a ball, 0 elsewhere, [z, y, x]."""
    x = np.linspace(-0.5, 0.5, points)
    away = x[:, None, None] ** 2 + x[:, None] ** 2 + x ** 2
    return (away < (3 * (1 - EMPTY) / (4 * np.pi)) ** (2 / 3)).astype(np.float32)


def taps_of(stage) -> int:
    stage.error_controlled()
    return moved_frames(stage, 1)["taps"]


def measure(points: int = 128, pixels: int = 128) -> dict:
    """Taps of each case: {skipping, plain}."""
    grid = ball(points)
    what = setting("binary", points, pixels, grid=grid, words="a ball")
    found = {"points": points, "pixels": pixels, "empty": float((grid == 0).mean()), "taps": {}}
    for words, (method, output) in CASES.items():
        stage = stage_of(what, method)
        getattr(stage.mapper, f"SetOutputTo{output}")()
        skipping = taps_of(stage)
        stage.volume.GetShaderProperty().AddFragmentShaderReplacement(POINT, True, CODE, False)
        found["taps"][words] = {"skipping": skipping, "plain": taps_of(stage)}
    return found
