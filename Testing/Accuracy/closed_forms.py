# SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
# SPDX-License-Identifier: BSD-3-Clause
"""Media whose optical depth or single scattering is known as a formula, in double precision.

NumPy only; nothing of the renderer is used. Directions are unit vectors, lengths are world units, a
directional light has irradiance 1 and a point light intensity 1.
"""

import numpy as np

ISOTROPIC = 1 / (4 * np.pi)  #: phase function, per steradian


def rays(scene) -> tuple:
    """Origins and directions through the pixel centres, shape (pixels, pixels, 3), bottom row first."""
    eye = np.array(scene.eye, float)
    forward = -eye / np.linalg.norm(eye)
    right = np.cross(forward, [0, 1, 0])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    half = np.tan(np.radians(scene.view_angle / 2))
    at = (2 * np.arange(scene.pixels) + 1) / scene.pixels - 1
    direction = forward + half * (at[None, :, None] * right + at[:, None, None] * up)
    direction /= np.linalg.norm(direction, axis=-1, keepdims=True)
    return np.broadcast_to(eye, direction.shape), direction


def box_interval(origin, direction, size) -> tuple:
    """Distances at which rays enter and leave a box around the world's origin; nothing if enter >=
    leave."""
    with np.errstate(divide="ignore"):
        a, b = (-0.5 * size - origin) / direction, (0.5 * size - origin) / direction
    return np.maximum(np.minimum(a, b).max(-1), 0), np.maximum(a, b).min(-1)


def mean_transmittance(x):
    """(1 - exp(-x)) / x, without the loss of digits near 0."""
    safe = np.where(np.abs(x) < 1e-12, 1, x)
    return np.where(np.abs(x) < 1e-12, 1 - 0.5 * x, -np.expm1(-safe) / safe)


def henyey_greenstein(cosine, g):
    return (1 - g * g) * ISOTROPIC / (1 + g * g - 2 * g * cosine) ** 1.5


def box_radiance(origin, direction, size, to_light, sigma) -> np.ndarray:
    """Form A: a homogeneous box, its light from infinity, a phase function of 1 per steradian. Over a
    piece of length d whose light path grows from l0 to l1: sigma exp(-sigma (s + l0)) d
    phi(sigma (d + l1 - l0)), phi(x) = (1 - exp(-x)) / x; pieces end where the light's exit changes
    from one face of the box to another."""
    shape = direction.shape[:-1]
    result = np.zeros(shape)
    enter, leave = box_interval(origin, direction, size)
    lit = [axis for axis in range(3) if to_light[axis] != 0]

    def to_faces(point):
        return np.array([(0.5 * size[a] * np.sign(to_light[a]) - point[a]) / to_light[a] for a in lit])

    for index in zip(*np.nonzero(enter < leave)):
        o, d, t0, t1 = origin[index], direction[index], enter[index], leave[index]
        first, last = to_faces(o + t0 * d), to_faces(o + t1 * d)
        cuts = [t0, t1]
        for a in range(len(lit)):
            for b in range(a):
                f, h = first[a] - first[b], last[a] - last[b]
                if f * h < 0:
                    cuts.append(t0 + (t1 - t0) * f / (f - h))
        cuts.sort()
        for s0, s1 in zip(cuts, cuts[1:]):
            l0, l1 = to_faces(o + s0 * d).min(), to_faces(o + s1 * d).min()
            result[index] += (sigma * np.exp(-sigma * (s0 - t0 + l0)) * (s1 - s0)
                              * mean_transmittance(sigma * (s1 - s0 + l1 - l0)))
    return result


def sphere_radiance(chord, sigma, along: bool):
    """Form B: a chord of a homogeneous sphere, the light along the view or from the camera; isotropic."""
    return ISOTROPIC * sigma * chord * (
        np.exp(-sigma * chord) if along else mean_transmittance(2 * sigma * chord))


def point_light_radiance(origin, direction, enter, leave, light, sigma):
    """Form C: an isotropic point source in a homogeneous medium between two distances on each ray.
    Sun, Ramamoorthi, Narasimhan and Nayar (2005), doi:10.1145/1073204.1073309."""
    offset = light - origin
    foot = (offset * direction).sum(-1)
    away = np.sqrt(np.maximum((offset ** 2).sum(-1) - foot ** 2, 0))

    def integral(v):
        """Of exp(-u tan x) from 0 to v, by 64 Gauss-Legendre points."""
        nodes, weights = np.polynomial.legendre.leggauss(64)
        x = 0.5 * v[..., None] * (nodes + 1)
        return 0.5 * v * (np.exp(-(sigma * away)[..., None] * np.tan(x)) * weights).sum(-1)

    def angle(t):
        return np.pi / 4 + 0.5 * np.arctan((t - foot) / away)

    return (sigma * ISOTROPIC / away * np.exp(-sigma * (foot - enter))
            * 2 * (integral(angle(leave)) - integral(angle(enter))))


def exponential_depth(height, slope, length, scale):
    """Form D: extinction exp(-z / scale) along a way that starts at a height and climbs by slope."""
    return np.exp(-height / scale) * length * mean_transmittance(length * slope / scale)


def linear_depth(start, rate, length):
    """Form E: extinction start + rate s along the way."""
    return start * length + 0.5 * rate * length ** 2
