// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumFormulas.h
 * @brief The formulas of the shaders, compiled as C++ in float and in double.
 *
 * The files in Formulas/ are written in the common subset of GLSL and C++ with GLM: `real` is the
 * number type, `vec2`, `vec3` and `vec4` are its vectors, `uint` has 32 bits, and every literal
 * that meets a `real` is wrapped in `real(...)` so that float stays float. Tests hold these texts
 * to plain definitions; the shaders compile the very same text.
 */
#ifndef vtkMediumFormulas_h
#define vtkMediumFormulas_h

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace vtkMediumFormulas
{
using uint = unsigned int;
namespace Float
{
namespace
{
using real = float;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
using namespace glm;
#include "Formulas/vtkMediumFormulas.inl"
}
}
namespace Double
{
namespace
{
using real = double;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
using namespace glm;
#include "Formulas/vtkMediumFormulas.inl"
}
}
}

#endif
