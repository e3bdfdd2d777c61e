// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumSelection.h"

#include "vtkMediumImages.h"
#include "vtkMediumOpenGL.h"
#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkHardwareSelector.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace
{
using Mapper = vtkSingleScatteringVolumeMapper;

constexpr vtkTypeInt64 Byte = 255; ///< the largest value of a colour channel
constexpr int PassBits = 24;       ///< that one pass of a selector holds

//------------------------------------------------------------------------------
bool IsPointPass(int pass)
{
  return pass == vtkHardwareSelector::POINT_ID_LOW24 ||
    pass == vtkHardwareSelector::POINT_ID_HIGH24;
}

//------------------------------------------------------------------------------
bool IsCellPass(int pass)
{
  return pass == vtkHardwareSelector::CELL_ID_LOW24 || pass == vtkHardwareSelector::CELL_ID_HIGH24;
}

//------------------------------------------------------------------------------
bool IsHighPass(int pass)
{
  return pass == vtkHardwareSelector::POINT_ID_HIGH24 ||
    pass == vtkHardwareSelector::CELL_ID_HIGH24;
}
}

//------------------------------------------------------------------------------
vtkMediumPlan::Settings vtkMediumSelection::FindSettings(const vtkMediumPlan::Settings& shown)
{
  vtkMediumPlan::Settings settings = shown;
  settings.CountTaps = false;
  if (shown.Integrator == Mapper::Paper)
  {
    settings.Output = Mapper::Distance;
    return settings;
  }
  settings.Integrator =
    shown.Integrator == Mapper::Exact ? int(Mapper::FixedStep) : shown.Integrator;
  settings.Output = Mapper::Depth;
  settings.DepthDefinition = Mapper::TransmittanceDepth;
  settings.DepthTransmittance = 1 - Threshold;
  return settings;
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMediumSelection::FindNumber(
  const glm::dvec3& box, const glm::ivec3& points, bool ofCell)
{
  const glm::ivec3 count = ofCell ? points - 1 : points;
  const glm::dvec3 at = box * glm::dvec3(points - 1);
  const glm::ivec3 index =
    glm::clamp(glm::ivec3(ofCell ? glm::floor(at) : glm::round(at)), glm::ivec3(0), count - 1);
  return index.x + vtkTypeInt64(count.x) * (index.y + vtkTypeInt64(count.y) * index.z);
}

//------------------------------------------------------------------------------
vtkMediumSelection::Texels vtkMediumSelection::FindTexels(vtkMediumFrame& frame,
  const vtkMediumScene& scene, const glm::ivec3& points, vtkHardwareSelector* selector)
{
  const int pass = selector->GetCurrentPass();
  const bool cells = IsCellPass(pass), numbers = cells || IsPointPass(pass);
  const float* color = selector->GetPropColorValue();
  const glm::ivec2 size = frame.GetViewport().Size;
  const std::vector<float> radiance = frame.DownloadRadiance(), hits = frame.DownloadHits();
  const std::vector<float> depths = vtkMediumImages::WindowDepths(hits, scene.Eye, size);
  Texels texels(radiance.size(), -1.0f);
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    if (!(radiance[4 * i + 3] > Threshold && hits[4 * i] > vtkMediumFrame::NoHit))
    {
      continue;
    }
    std::copy(color, color + 3, &texels[4 * i]);
    texels[4 * i + 3] = depths[i];
    if (numbers)
    {
      const glm::ivec2 pixel(i % size.x, i / size.x);
      const glm::dvec3 at = vtkMediumImages::FindPoint(scene.Eye, size, pixel, hits[4 * i]);
      vtkTypeInt64 number = FindNumber(scene.Geometry.LocalToBox(at), points, cells);
      number >>= IsHighPass(pass) ? PassBits : 0;
      for (int channel = 0; channel < 3; ++channel, number >>= 8)
      {
        texels[4 * i + channel] = static_cast<float>(number & Byte) / Byte;
      }
    }
  }
  return texels;
}

//------------------------------------------------------------------------------
std::string vtkMediumSelection::Show(
  vtkOpenGLRenderWindow* window, vtkMediumProgram& programs, const glm::ivec2& size, Texels& texels)
{
  vtkShaderProgram* program = programs.Use(window, { "Selection" }, "");
  if (!program)
  {
    return "The shader that shows a selection did not compile on this device; the compiler's words "
           "are above.";
  }
  vtkNew<vtkTextureObject> texture;
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  texture->Create2DFromRaw(size.x, size.y, 4, VTK_FLOAT, texels.data());

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  state->vtkglEnable(GL_DEPTH_TEST); // or no depth would be written
  state->vtkglDepthFunc(GL_ALWAYS);  // the eye rays have ended at what is in front
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_CULL_FACE);
  texture->Activate();
  program->SetUniformi("selected", texture->GetTextureUnit());
  programs.Draw();
  texture->Deactivate();
  texture->ReleaseGraphicsResources(window);
  return {};
}

//------------------------------------------------------------------------------
std::string vtkMediumSelection::Draw(vtkOpenGLRenderWindow* window, vtkMediumProgram& programs,
  vtkMediumFrame& frame, const vtkMediumScene& scene, const glm::ivec3& points,
  vtkHardwareSelector* selector)
{
  selector->BeginRenderProp();
  selector->UpdateMaximumPointId(FindNumber(glm::dvec3(1), points, false));
  selector->UpdateMaximumCellId(FindNumber(glm::dvec3(1), points, true));
  if (selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
  {
    selector->RenderCompositeIndex(1);
  }
  Texels texels = FindTexels(frame, scene, points, selector);
  const std::string problem = Show(window, programs, frame.GetViewport().Size, texels);
  selector->EndRenderProp();
  return problem;
}
