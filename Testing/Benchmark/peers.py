# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""The same picture by what others wrote, in the Python that has them (peer_frames.py). Each function returns
records, and why there are none."""

import dataclasses
import json
import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from points import errors, pixels_like, record

#: Names the Python with vtk and mitsuba; and says why there is none.
VARIABLE, REASON = "PARTICIPATING_MEDIA_PEERS_PYTHON", "PARTICIPATING_MEDIA_NO_PEERS"
#: Steps of VTK's scattering in voxels. Finer ones of larger volumes end in llvmpipe's loop limit.
SMALL_STEPS, LARGE_STEPS = (1, 0.5, 0.25), (2, 1.5, 1)
#: Paths of each pixel, and the relative RMSE that their time is told for.
SAMPLES, RMSE = (64, 256), 0.01
#: Seconds that one renderer may take for one scene.
PATIENCE = 1800


def frames_of(renderer: str, what, knobs, folder: str) -> tuple:
    """What peer_frames.py printed, or why it did not."""
    python = os.environ.get(VARIABLE, "")
    if not python:
        return None, os.environ.get(REASON, f"{VARIABLE} names no Python that has {renderer}")
    job = Path(folder) / "job.json"
    job.write_text(json.dumps({"renderer": renderer, "scene": dataclasses.asdict(what.scene),
                               "knobs": knobs, "folder": folder}), encoding="utf-8")
    command = [python, str(Path(__file__).with_name("peer_frames.py")), str(job)]
    clean = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    try:
        run = subprocess.run(command, text=True, capture_output=True, env=clean, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return None, f"it took more than {PATIENCE} s"
    if run.returncode:
        return None, "it did not run: " + (run.stderr.strip().splitlines() or ["no word"])[-1]
    return json.loads(run.stdout.splitlines()[-1]), ""


def fitted(image, truth) -> np.ndarray:
    """The image times the factor that brings it closest to the truth, by least squares: in its favour."""
    seen = pixels_like(image, truth)
    return image * float((seen * truth).sum() / (seen * seen).sum())


def records_of(method: str, renderer: str, what, knobs, truth, dense=None) -> tuple:
    """Errors are over the truth's pixels; dense: the truth of all of them. VTK's brightness is fitted."""
    with tempfile.TemporaryDirectory() as folder:
        found, why = frames_of(renderer, what, knobs, folder)
        records = []
        for frame in found["frames"] if found else []:
            image = np.load(frame["image"])
            if renderer == "vtk":
                image = fitted(image, truth if dense is None else dense)
            known = errors(image, truth)
            if dense is not None:
                known["max_error_all"] = errors(image, dense)["max_error"]
            records.append(record(
                method=method, field=what.scene.grid, knob=frame["knob"], device=found["version"],
                scene=what.words, volume=list(what.values().shape[::-1]),
                image=[what.scene.pixels] * 2, camera_moved=frame["camera_moved"], **known))
    return records, why


def vtk_scattering(what, steps, truth, dense=None) -> tuple:
    return records_of("VTK scattering", "vtk", what, steps, truth, dense)


def mitsuba(what, truth) -> tuple:
    return records_of("Mitsuba", "mitsuba", what, SAMPLES, truth)


def mitsuba_at_rmse(found: dict) -> float:
    """Milliseconds at RMSE, since noise falls as 1/√samples."""
    return found["camera_moved"]["median"] * (found["relative_rmse"] / RMSE) ** 2
