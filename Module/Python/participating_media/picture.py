# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Renders a window to a PNG file and says what the mapper did."""

from __future__ import annotations

import os
import sys
import time
from contextlib import contextmanager
from pathlib import Path

from vtkmodules.vtkCommonCore import vtkLogger, vtkObject, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkWindowToImageFilter

from .vtkParticipatingMediaRendering import vtkSingleScatteringVolumeMapper


class RenderingError(RuntimeError):
    """A frame was refused; the message says what was found and what to do."""


def require_display() -> None:
    """Raises :class:`RenderingError` where VTK could only abort: before 9.4 it needs X."""
    version = (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion())
    if sys.platform.startswith("linux") and version < (9, 4) and not os.environ.get("DISPLAY"):
        raise RenderingError("no X display, which this VTK needs; run it under 'xvfb-run -a'")


@contextmanager
def errors_raised(*objects: vtkObject):
    """Turns the first VTK error of the objects inside the block into a :class:`RenderingError`."""
    messages: list[str] = []

    def keep(_caller, _event, message):
        messages.append(message)

    keep.CallDataType = "string0"
    tags = [(item, item.AddObserver("ErrorEvent", keep)) for item in objects]
    verbosity = vtkLogger.GetCurrentVerbosityCutoff()
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        yield
    finally:
        vtkLogger.SetStderrVerbosity(verbosity)
        for item, tag in tags:
            item.RemoveObserver(tag)
    if messages:
        # VTK writes "ERROR: In <file>, line <n>\n<class> (<address>): <message>\n\n".
        raise RenderingError(" ".join(messages[0].split("): ", 1)[-1].split()))


def render(window: vtkRenderWindow, *mappers: vtkSingleScatteringVolumeMapper) -> float:
    """Renders one frame and returns its wall-clock milliseconds; raises :class:`RenderingError`."""
    require_display()
    with errors_raised(*mappers):
        start = time.perf_counter()
        window.Render()
        return 1000 * (time.perf_counter() - start)


def peak_radiance(mapper: vtkSingleScatteringVolumeMapper) -> float:
    """The largest R, G or B of the last frame; above 1 an 8-bit picture of it is clipped."""
    image = vtkImageData()
    mapper.GetColorImage(image)
    scalars = image.GetPointData().GetScalars()
    return max(scalars.GetRange(channel)[1] for channel in range(3)) if scalars else 0.0


def write_png(window: vtkRenderWindow, path: str | os.PathLike[str]) -> None:
    """Writes the last frame of the window, and makes the folder for it."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    frame = vtkWindowToImageFilter()
    frame.SetInput(window)
    frame.ReadFrontBufferOff()
    frame.ShouldRerenderOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(path))
    writer.SetInputConnection(frame.GetOutputPort())
    with errors_raised(writer):
        writer.Write()


def statistics_line(mapper: vtkSingleScatteringVolumeMapper) -> str:
    """What the mapper did in its last frame, in one line."""
    done = mapper.GetStatistics()
    line = (f"integrated {done.GetIntegrateMilliseconds():.1f} ms in {done.GetPasses()} passes, "
            f"largest value {peak_radiance(mapper):.3f}, "
            f"{done.GetGPUBytes() / 2**20:.1f} MiB of textures")
    if done.GetCountTaps():
        line += f", {done.GetRays()} rays, {done.GetTaps()} taps"
    return line


def finish(window: vtkRenderWindow, mappers: dict[str, vtkSingleScatteringVolumeMapper],
           output: str | os.PathLike[str], interactive: bool = False) -> None:
    """Renders two frames, writes the PNG, prints its path, the second frame's time and what each
    mapper did; then, if interactive, lets the user turn the volume until the window is closed."""
    window.SetOffScreenRendering(not interactive)
    window.SetMultiSamples(0)
    render(window, *mappers.values())
    for mapper in mappers.values():
        mapper.GetStatistics().CountTapsOn()
    milliseconds = render(window, *mappers.values())
    write_png(window, output)
    print(f"{output}: frame {milliseconds:.1f} ms")
    for name, mapper in mappers.items():
        print(f"  {name}: {statistics_line(mapper)}")
    if interactive:
        interact(window)


def interact(window: vtkRenderWindow) -> None:
    """Gives the window to the user, with the trackball, until it is closed."""
    import vtkmodules.vtkRenderingUI  # noqa: F401  registers the platform's interactor
    from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
    from vtkmodules.vtkRenderingCore import vtkRenderWindowInteractor

    interactor = vtkRenderWindowInteractor()
    interactor.SetRenderWindow(window)
    interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
    interactor.Start()
