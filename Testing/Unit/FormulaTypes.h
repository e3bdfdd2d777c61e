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
    static real Isotropic() { return vtkMediumFormulas::Name::phaseIsotropic(); }                  \
    static real HenyeyGreenstein(real c, real g)                                                   \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseHenyeyGreenstein(c, g);                                 \
    }                                                                                              \
    static real DoubleHenyeyGreenstein(real c, real g, real second, real weight)                   \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseDoubleHenyeyGreenstein(c, g, second, weight);           \
    }                                                                                              \
    static real Schlick(real c, real k) { return vtkMediumFormulas::Name::phaseSchlick(c, k); }    \
    static real SchlickFromG(real g) { return vtkMediumFormulas::Name::phaseSchlickFromG(g); }     \
    static real Rayleigh(real c) { return vtkMediumFormulas::Name::phaseRayleigh(c); }             \
    static real Draine(real c, real g, real alpha)                                                 \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseDraine(c, g, alpha);                                    \
    }                                                                                              \
    static real Droplets(real c, real g, real alpha, real second, real weight)                     \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseDroplets(c, g, alpha, second, weight);                  \
    }                                                                                              \
    static real TableCoordinate(real c, real size)                                                 \
    {                                                                                              \
      return vtkMediumFormulas::Name::phaseTableCoordinate(c, size);                               \
    }                                                                                              \
    static real MeanTransmittance(real x)                                                          \
    {                                                                                              \
      return vtkMediumFormulas::Name::segmentMeanTransmittance(x);                                 \
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
