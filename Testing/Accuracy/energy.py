# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Whether light is neither made nor lost."""

import closed_forms
import numpy as np
from mapper import Stage
from page import table
from scenes import Scene
from vtkmodules.vtkCommonCore import vtkDoubleArray

#: Optical depth so thin that what is seen is the phase function.
THIN = 1e-9
#: Per half of the sphere; with the nodes crowded at the poles this is exact to 1e-9 even for droplets.
NODES = 48
PAIRS = 10


def line_table() -> vtkDoubleArray:
    """(1 + cos / 2) / 4 pi: a straight line, which any table holds."""
    values = vtkDoubleArray()
    for cosine in (-1, 1):
        values.InsertNextValue((1 + 0.5 * cosine) * closed_forms.ISOTROPIC)
    return values


#: Words, the settings of the medium, and the mean cosine where it is known.
PHASES = (
    ("isotropic", {"PhaseFunction": 0}, 0),
    ("Henyey–Greenstein, g = -0.9", {"PhaseFunction": 2, "Anisotropy": -0.9}, -0.9),
    ("Henyey–Greenstein, g = 0.6", {"PhaseFunction": 2, "Anisotropy": 0.6}, 0.6),
    ("Henyey–Greenstein, g = 0.99", {"PhaseFunction": 2, "Anisotropy": 0.99}, 0.99),
    ("double Henyey–Greenstein, 0.8 and -0.3", {
        "PhaseFunction": 3, "Anisotropy": 0.8, "BackAnisotropy": -0.3, "ForwardWeight": 0.7},
     0.7 * 0.8 - 0.3 * 0.3),
    ("Schlick, g = 0.6", {"PhaseFunction": 1, "Anisotropy": 0.6}, None),
    ("Schlick, g = 0.95", {"PhaseFunction": 1, "Anisotropy": 0.95}, None),
    ("Schlick, k = 0.9", {"PhaseFunction": 8, "Anisotropy": 0.9}, None),
    ("Rayleigh", {"PhaseFunction": 4}, 0),
    ("Draine, g = 0.6, alpha = 1", {"PhaseFunction": 5, "Anisotropy": 0.6}, None),
    ("droplets of 20 µm", {"PhaseFunction": 7, "DropletDiameter": 20}, None),
    ("tabulated, a straight line", {"PhaseFunction": 6, "PhaseTable": line_table()}, 1 / 6),
)


def cosines() -> tuple:
    """Nodes and weights of an integral over the cosine from -1 to 1: 1 - cos = s^4 in each half."""
    x, w = np.polynomial.legendre.leggauss(NODES)
    s, w = 0.5 * (x + 1), 0.5 * w
    half, weight = 1 - s ** 4, 4 * s ** 3 * w
    return np.concatenate([-half, half]), np.concatenate([weight, weight])


def phase_rows(options) -> list:
    """Radiance of a thin box over the directions of the light, divided by what is not the phase."""
    scene = Scene("thin", "uniform", THIN, 0, (0, 0, 1), points=2, pixels=2)
    nodes, weights = cosines()
    rows = []
    for words, settings, expected in options.progress(PHASES, "phase functions"):
        stage = Stage(scene)
        stage.look_parallel((0, 0, -1), (0, 1, 0), 0.3)
        for name, value in settings.items():
            getattr(stage.medium, "Set" + name)(value)
        reference, rgba = stage.truth(1e-10), [0.0] * 4
        values = {"reference": [], "mapper": []}
        for cosine in nodes:
            stage.light.SetPosition(np.sqrt(1 - cosine ** 2), 0, -cosine)
            reference.Radiance((0, 0, 2), (0, 0, -1), rgba)
            values["reference"].append(rgba[1] / THIN)
            values["mapper"].append(stage.fixed_step(0)[0, 0] / THIN)
        row = [words]
        for phase in map(np.array, values.values()):
            row += [abs(2 * np.pi * (weights * phase).sum() - 1),
                    f"{2 * np.pi * (weights * nodes * phase).sum():.5f}"]
        rows.append(row + ["–" if expected is None else f"{expected:.5f}"])
    return rows


def reciprocity(options) -> tuple:
    """Largest relative change of the light that a whole picture holds when view and light change
    places, over random pairs: of the reference, and of FixedStep."""
    random = np.random.default_rng(1)
    worst = np.zeros(2)
    for _ in options.progress(range(PAIRS), "reciprocity"):
        view, beam = random.normal(size=(2, 3))
        sums = []
        for towards, light in ((view, -beam), (beam, -view)):
            scene = Scene("pair", "cloud", 20, 0.5, tuple(light), pixels=48)
            stage = Stage(scene)
            stage.look_parallel(towards, (0.1, 1, 0.2), 0.9)
            sums.append([stage.reference(1e-4).sum(), stage.fixed_step(0.5).sum()])
        worst = np.maximum(worst, np.abs(np.subtract(*sums)) / sums[0])
    return tuple(worst)


def furnace_bound(options) -> float:
    """Largest L / (p E (1 - T)), which attenuation on the way in must keep below 1."""
    stage = Stage(Scene("bound", "cloud", 20, 0, (-0.6, 0.7, 0.3), pixels=options.pixels))
    radiance, alpha = stage.reference(1e-9), stage.reference(1e-9, channel=3)
    seen = alpha > 1e-6
    return float((radiance[seen] / (closed_forms.ISOTROPIC * alpha[seen])).max())


def measure(options) -> str:
    head = ["phase function", "reference: error of the integral", "mean cosine",
            "mapper: error of the integral", "mean cosine", "expected"]
    phases = table(head, phase_rows(options))
    by_reference, by_fixed_step = reciprocity(options)
    return f"""## Energy

**Phase functions integrate to 1.** What a box of optical depth {THIN:g} scatters towards a fixed eye,
as the light goes round it: {2 * NODES} angles, Gauss–Legendre, crowded at the poles.

{phases}

**Reciprocity.** View and light may change places without a change of the light in the picture
(parallel projection, directional light, the cloud, g = 0.5): over {PAIRS} random pairs the sum over 48 ×
48 pixels changes by at most {by_reference:.1e} of itself in the reference and {by_fixed_step:.1e} in
FixedStep at ½ voxel. Most of that is the pixels, which sample the two pictures on different lattices.

**A bound.** Single scattering of a beam is at most p E (1 − T): in the cloud, isotropic, the largest
ratio over the pixels is {furnace_bound(options):.4f}. (The furnace itself is form F above.)
"""
