# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers as Markdown, and pictures."""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (after the choice of a backend without windows)
import numpy as np  # noqa: E402


def number(value) -> str:
    """Errors with two digits, words as they are."""
    if isinstance(value, str):
        return value
    return "0" if value == 0 else f"{value:.1e}"


def table(head: list, rows: list) -> str:
    lines = [head, ["---"] * len(head)] + [[number(cell) for cell in row] for row in rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def largest_error(image: np.ndarray, truth: np.ndarray, where=None) -> float:
    """Largest absolute error over the pixels, as a fraction of the truth's peak."""
    error = np.abs(image - truth)
    return float((error if where is None else error[where]).max() / truth.max())


def mean_error(image: np.ndarray, truth: np.ndarray) -> float:
    """Mean absolute error over the pixels, as a fraction of the truth's peak."""
    return float(np.abs(image - truth).mean() / truth.max())


def slope(steps, errors) -> float:
    """Of a straight line through log error against log step, by least squares."""
    return float(np.polyfit(np.log(steps), np.log(errors), 1)[0])


def plot_convergence(path: Path, panels: list) -> None:
    """One panel for each (title, {curve: (steps, errors)}), with lines of first and second order."""
    figure, axes = plt.subplots(1, len(panels), figsize=(2.5 * len(panels), 2.8), sharey=True)
    for axis, (title, curves) in zip(axes, panels):
        for name, (steps, errors) in curves.items():
            axis.loglog(steps, errors, "o-", markersize=3, linewidth=1, label=name)
        steps, errors = next(iter(curves.values()))
        for order, style in ((1, ":"), (2, "--")):
            axis.loglog(steps, errors[0] * (np.array(steps) / steps[0]) ** order, style,
                        color="grey", linewidth=0.8)
        axis.axhline(1 / 255, color="grey", linewidth=0.4)
        axis.set_title(title, fontsize=9)
        axis.set_xlabel("step / voxel", fontsize=8)
        axis.tick_params(labelsize=7)
        axis.legend(fontsize=7)
    axes[0].set_ylabel("error / peak", fontsize=8)
    save(figure, path)


def plot_pictures(path: Path, panels: list) -> None:
    """One panel for each (title, image, lowest, highest); a range around 0 is shown in two colours."""
    figure, axes = plt.subplots(1, len(panels), figsize=(2.2 * len(panels), 2.2))
    for axis, (title, image, lowest, highest) in zip(axes, panels):
        axis.imshow(image, origin="lower", vmin=lowest, vmax=highest, interpolation="nearest",
                    cmap="coolwarm" if lowest < 0 else "gray")
        axis.set_title(title, fontsize=7)
        axis.set_axis_off()
    save(figure, path)


def save(figure, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)
