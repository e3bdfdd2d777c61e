// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FormulaTypes.h
 * @brief The shaders' formulas as types, so that one test holds them in float and in double.
 */
#ifndef FormulaTypes_h
#define FormulaTypes_h

#include "vtkMediumFormulas.h"

#include <gtest/gtest.h>

#include <limits>

#define FORMULA_TYPE(Name)                                                                         \
  struct Name##Formulas                                                                            \
  {                                                                                                \
    using real = vtkMediumFormulas::Name::real;                                                    \
    using vec2 = vtkMediumFormulas::Name::vec2;                                                    \
    using vec3 = vtkMediumFormulas::Name::vec3;                                                    \
    static vec2 Angle(long double c) { return { real(1 - c), real(1 + c) }; }                      \
    static vec2 Angle(vec3 a, vec3 b) { return vtkMediumFormulas::Name::phaseAngle(a, b); }        \
    static real HenyeyGreenstein(vec2 angle, real g)                                               \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseHenyeyGreenstein(angle, g);                             \
    }                                                                                              \
    static real Schlick(vec2 angle, real k)                                                        \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseSchlick(angle, k);                                      \
    }                                                                                              \
    static real Isotropic() { return vtkMediumFormulas::Name::phaseIsotropic(); }                  \
    static real HenyeyGreenstein(long double c, real g)                                            \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseHenyeyGreenstein(Angle(c), g);                          \
    }                                                                                              \
    static real DoubleHenyeyGreenstein(long double c, real g, real second, real weight)            \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseDoubleHenyeyGreenstein(Angle(c), g, second, weight);    \
    }                                                                                              \
    static real Schlick(long double c, real k)                                                     \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseSchlick(Angle(c), k);                                   \
    }                                                                                              \
    static real SchlickFromG(real g) { return vtkMediumFormulas::Name::phaseSchlickFromG(g); }     \
    static real Rayleigh(long double c)                                                            \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseRayleigh(Angle(c));                                     \
    }                                                                                              \
    static real Draine(long double c, real g, real alpha)                                          \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseDraine(Angle(c), g, alpha);                             \
    }                                                                                              \
    static real Droplets(long double c, real g, real alpha, real second, real weight)              \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseDroplets(Angle(c), g, alpha, second, weight);           \
    }                                                                                              \
    static real TableCoordinate(long double c, real size)                                          \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseTableCoordinate(Angle(c), size);                        \
    }                                                                                              \
    static real MeanTransmittance(real x)                                                          \
    {                                                                                              \
      return vtkMediumFormulas::Name::segmentMeanTransmittance(x);                                 \
    }                                                                                              \
    static real MeanTransmittance(real first, real last)                                           \
    {                                                                                              \
      return vtkMediumFormulas::Name::segmentMeanTransmittance(first, last);                       \
    }                                                                                              \
    static vec3 MeanTransmittance(vec3 first, vec3 last)                                           \
    {                                                                                              \
      return vtkMediumFormulas::Name::segmentMeanTransmittance(first, last);                       \
    }                                                                                              \
    static vec3 MeanTransmittance(vec3 x)                                                          \
    {                                                                                              \
      return vtkMediumFormulas::Name::segmentMeanTransmittance(x);                                 \
    }                                                                                              \
    static real Transmittance(real x) { return vtkMediumFormulas::Name::transmittance(x); }        \
    static vec3 Transmittance(vec3 x) { return vtkMediumFormulas::Name::transmittance(x); }        \
    static vec2 RayBox(vec3 origin, vec3 direction)                                                \
    {                                                                                              \
      return vtkMediumFormulas::Name::rayBox(origin, direction);                                   \
    }                                                                                              \
    static real Attenuation(real r, vec3 abc)                                                      \
    {                                                                                              \
      return vtkMediumFormulas::Name::lightAttenuation(r, abc);                                    \
    }                                                                                              \
    static vec2 LightSegment(vec3 offset, vec3 direction, real width, real softening)              \
    {                                                                                              \
      return vtkMediumFormulas::Name::lightSegment(offset, direction, width, softening);           \
    }                                                                                              \
    static real Spot(real cosine, real cone, real exponent)                                        \
    {                                                                                              \
      return vtkMediumFormulas::Name::lightSpot(cosine, cone, exponent);                           \
    }                                                                                              \
    static vec3 LightDirection(vec3 offset, vec3 fallback)                                         \
    {                                                                                              \
      return vtkMediumFormulas::Name::lightDirection(offset, fallback);                            \
    }                                                                                              \
    static real Jitter(unsigned x, unsigned y, unsigned seed)                                      \
    {                                                                                              \
      return vtkMediumFormulas::Name::jitterOffset(x, y, seed);                                    \
    }                                                                                              \
  }

FORMULA_TYPE(Float);
FORMULA_TYPE(Double);
#undef FORMULA_TYPE

using FormulaTypes = ::testing::Types<FloatFormulas, DoubleFormulas>;

/// Rounding unit of a formula type.
template <typename F>
constexpr double Epsilon()
{
  return std::numeric_limits<typename F::real>::epsilon();
}

#endif
