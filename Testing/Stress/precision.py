# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""How the float renderer and the double reference bear sizes and origins from 1e-12 to 1e16.

The same scene in other units and elsewhere has the same picture; the truth is the reference's at size 1
about the origin. Called by precision, which writes Module/Documentation/precision.md with it."""

import datetime
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (after the choice of a backend without windows)
import numpy as np  # noqa: E402
from participating_media import (  # noqa: E402
    vtkParticipatingMedium, vtkSingleScatteringReference, vtkSingleScatteringVolumeMapper)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonCore import vtkOutputWindow  # noqa: E402
from vtkmodules.vtkCommonDataModel import vtkImageData  # noqa: E402
from vtkmodules.vtkRenderingCore import (  # noqa: E402
    vtkLight, vtkRenderer, vtkRenderWindow, vtkVolume, vtkVolumeProperty)

POINTS, PIXELS = 17, 24
SIZES = [10.0 ** exponent for exponent in range(-12, 13, 2)]
#: Distances of the volume's centre from the world's origin, in sizes of the volume.
ORIGINS = [0.0] + [10.0 ** exponent for exponent in range(1, 17)]
#: What counts as right: one level of a display of 8 bits, and the stress matrix' tolerance.
VISIBLE, TIGHT = 1 / 255, 1e-3


def density() -> np.ndarray:
    """Two soft blobs."""
    at = np.linspace(-0.5, 0.5, POINTS)
    z, y, x = np.meshgrid(at, at, at, indexing="ij")
    return (np.exp(-((x - 0.1) ** 2 + y ** 2 + (z + 0.15) ** 2) / 0.03)
            + 0.7 * np.exp(-((x + 0.15) ** 2 + (y - 0.1) ** 2 + (z - 0.1) ** 2) / 0.02))


class Stage:
    def __init__(self, size: float, far: float):
        center = size * far * np.array([1.0, -1.0, 1.0])
        image = vtkImageData()
        image.SetDimensions(POINTS, POINTS, POINTS)
        image.SetSpacing(3 * [size / (POINTS - 1)])
        image.SetOrigin(*(center - size / 2))
        image.GetPointData().SetScalars(numpy_to_vtk(density().ravel(), deep=True))
        self.medium = vtkParticipatingMedium()
        self.medium.SetExtinctionArrayName("")
        self.medium.SetExtinctionScale(6 / size)
        self.mapper = vtkSingleScatteringVolumeMapper()
        self.mapper.SetInputData(image)
        self.mapper.SetMedium(self.medium)
        self.mapper.SetIntegratorToFixedStep()
        self.mapper.SetTransmittanceThreshold(0)
        self.mapper.SetSampleDistance(size / 300)
        self.mapper.SetLightSampleDistance(size / 150)
        self.volume = vtkVolume()
        self.volume.SetMapper(self.mapper)
        smooth = vtkVolumeProperty()
        smooth.SetInterpolationTypeToLinear()
        self.volume.SetProperty(smooth)
        self.renderer = vtkRenderer()
        self.renderer.AutomaticLightCreationOff()
        self.renderer.AddVolume(self.volume)
        light = vtkLight()
        light.SetPosition(1, 2, 0.5)
        self.renderer.AddLight(light)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*(center + size * np.array([0.4, 0.6, 2.2])))
        camera.SetFocalPoint(*center)
        camera.SetClippingRange(0.1 * size, 10 * size)
        self.window = vtkRenderWindow()
        self.window.SetMultiSamples(0)
        self.window.SetOffScreenRendering(1)
        self.window.SetSize(PIXELS, PIXELS)
        self.window.AddRenderer(self.renderer)

    def rendered(self):
        """The mapper's radiance, or None where there is none."""
        refusals = []
        self.mapper.AddObserver("ErrorEvent", lambda *_: refusals.append(1))
        self.window.Render()
        image = vtkImageData()
        self.mapper.GetColorImage(image)
        if refusals or not image.GetPointData().GetScalars():
            return None  # refused, or nothing was in view
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(-1, 4)[:, 0].astype(float)

    def reference(self):
        reference = vtkSingleScatteringReference()
        reference.SetVolume(self.volume)
        reference.SetMedium(self.medium)
        reference.SetRenderer(self.renderer)
        reference.SetTolerance(1e-7)
        image = vtkImageData()
        self.window.Render()
        if not reference.GetColorImage(image):
            return None
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(-1, 4)[:, 0]


def error(picture, truth) -> float:
    return np.nan if picture is None else float(np.abs(picture - truth).max() / truth.max())


def number(value: float) -> str:
    return "none" if np.isnan(value) else f"{value:.1e}"


def plot(path: Path, panels: list) -> None:
    figure, axes = plt.subplots(1, 2, figsize=(8, 3), sharey=True)
    for axis, (title, places, curves) in zip(axes, panels):
        for name, errors in curves.items():
            axis.loglog(places, np.maximum(errors, 1e-17), "o-", markersize=3, linewidth=1, label=name)
        axis.axhline(VISIBLE, color="grey", linewidth=0.5)
        axis.set_xlabel(title, fontsize=9)
        axis.tick_params(labelsize=7)
        axis.legend(fontsize=7)
    axes[0].set_ylabel("largest error / peak", fontsize=9)
    figure.tight_layout()
    figure.savefig(path, dpi=110, metadata={"Software": None})


def first_above(places, errors, bound) -> str:
    bad = [place for place, value in zip(places, errors) if not value <= bound]
    return f"{bad[0]:.0e}" if bad else "nowhere here"


def table(head: str, places, curves) -> str:
    rows = "\n".join(f"| {place:.0e} | " + " | ".join(number(e[i]) for e in curves.values()) + " |"
                     for i, place in enumerate(places))
    return f"| {head} | {' | '.join(curves)} |\n| --- | --- | --- |\n{rows}"


def main() -> None:
    vtkOutputWindow.GetInstance().SetDisplayModeToNever()
    output = Path(sys.argv[1])
    truth = Stage(1, 0).reference()

    def errors(stages) -> dict:
        stages = list(stages)
        return {"FixedStep, float": [error(stage.rendered(), truth) for stage in stages],
                "reference, double": [error(stage.reference(), truth) for stage in stages]}

    sizes = errors(Stage(size, 0) for size in SIZES)
    origins = errors(Stage(1, far) for far in ORIGINS)
    (output.parent / "images").mkdir(exist_ok=True)
    plot(output.parent / "images/precision.png",
         [("size of the volume, world units", SIZES, sizes),
          ("distance from the world's origin / size", ORIGINS[1:],
           {name: values[1:] for name, values in origins.items()})])
    renderer, double = origins.values()
    output.write_text(f"""# How far from size 1 and from the origin

Made on {datetime.date.today().isoformat()} by `Testing/Stress/precision`. The same two soft blobs,
{POINTS}³ points and {PIXELS} × {PIXELS} pixels, in other units (size, extinction, camera and steps scaled
alike) and at other places. Largest error of the radiance over the pixels, as a fraction of the peak,
against the double-precision reference at size 1 about the origin; about {origins["FixedStep, float"][0]:.0e}
of it is the step's own.

![Largest error over size and over distance from the origin](images/precision.png)

Size does not matter: positions are taken in the volume's own units before they become float. Distance
from the origin matters to every renderer whose input is double: a place far away has no digits left for
what is inside the volume. VTK's camera matrix is one of those places.

| from which distance / size on is it wrong by more than | FixedStep | reference |
| --- | --- | --- |
| {TIGHT:.0e} of the peak | {first_above(ORIGINS, renderer, TIGHT)} | {first_above(ORIGINS, double, TIGHT)} |
| 1/255 of the peak | {first_above(ORIGINS, renderer, VISIBLE)} | {first_above(ORIGINS, double, VISIBLE)} |

{table("size", SIZES, sizes)}

{table("distance / size", ORIGINS, origins)}
""")


if __name__ == "__main__":
    main()
