// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Light gathered over a segment of constant source and constant extinction, in closed form.
// GLSL and C++ both compile this text; see vtkMediumFormulas.h.

// (1 - exp(-x)) / x for x >= 0: the mean transmittance over a segment of optical depth x. The
// quotient cancels for small x (relative error 1e-4 at x = 3e-4 in float), so its Taylor series
// takes over below x = 0.166, where five terms leave a relative error of 2.2e-7.
real segmentMeanTransmittance(real x)
{
  real series = real(1.0) -
    x * (real(0.5) -
      x * (real(1.0 / 6.0) - x * (real(1.0 / 24.0) - x * real(1.0 / 120.0))));
  real quotient = (real(1.0) - exp(-min(x, real(80.0)))) / max(x, real(0.166));
  return x < real(0.166) ? series : quotient;
}

vec3 segmentMeanTransmittance(vec3 x)
{
  return vec3(segmentMeanTransmittance(x.r), segmentMeanTransmittance(x.g),
    segmentMeanTransmittance(x.b));
}

// The mean of exp(-tau) over a segment along which tau grows or falls linearly, from first to last.
real segmentMeanTransmittance(real first, real last)
{
  return exp(-min(min(first, last), real(80.0))) * segmentMeanTransmittance(abs(last - first));
}

vec3 segmentMeanTransmittance(vec3 first, vec3 last)
{
  return vec3(segmentMeanTransmittance(first.r, last.r),
    segmentMeanTransmittance(first.g, last.g), segmentMeanTransmittance(first.b, last.b));
}
