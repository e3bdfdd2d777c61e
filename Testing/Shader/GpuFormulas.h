// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GpuFormulas.h
 * @brief Evaluates the shaders' formulas on the device, for a table of arguments.
 */
#ifndef GpuFormulas_h
#define GpuFormulas_h

#include "EvaluateFormulas.h"
#include "vtkMediumFoldUniforms.h"
#include "vtkMediumProgram.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkPixelBufferObject.h"
#include "vtkRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// Up to eight arguments of a formula, in the order of EvaluateFormulas.glsl.
using Arguments = std::array<float, 8>;

class GpuFormulas
{
public:
  enum Formula
  {
    PhaseIsotropic,
    PhaseHenyeyGreenstein,
    PhaseSchlick,
    PhaseSchlickFromG,
    PhaseDoubleHenyeyGreenstein,
    PhaseRayleigh,
    PhaseDraine,
    PhaseDroplets,
    PhaseTableCoordinate,
    SegmentMeanTransmittance,
    Transmittance,
    RayBox,
    LightAttenuation,
    LightSpot,
    LightDirection,
    JitterOffset,
    PhaseAngle,
    LightSegment,
    FieldInterpolate, ///< of the field that SetField gave; with FIELD_COUNT 1; FOLDED, of lattice coordinates
  };

  explicit GpuFormulas(const std::string& defines = "#define FIELD_COUNT 0\n")
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(16, 16);
    this->Window->Render();
    this->GL = vtkOpenGLRenderWindow::SafeDownCast(this->Window);
    const std::string text = vtkMediumProgram::Assemble(
      { "Phase", "Segment", "Transmittance", "RayBox", "Light", "Jitter", "Fold", "Fields" },
      defines);
    this->Quad.reset(
      new vtkOpenGLQuadHelper(this->GL, nullptr, (text + EvaluateFormulas).c_str(), nullptr));
  }

  ~GpuFormulas()
  {
    this->Field->ReleaseGraphicsResources(this->GL);
    this->Quad->ReleaseGraphicsResources(this->GL);
  }

  /// A field of one component as the mapper's textures hold it, x fastest, on a device with this limit.
  void SetField(const glm::ivec3& dimensions, std::vector<float> values, int limit = 256)
  {
    this->Fold = vtkMediumFold(dimensions, limit);
    const glm::ivec3 size = this->Fold.GetSize();
    values = this->Fold.Fold(std::move(values), 1);
    this->Field->SetContext(this->GL);
    this->Field->SetMinificationFilter(vtkTextureObject::Linear);
    this->Field->SetMagnificationFilter(vtkTextureObject::Linear);
    this->Field->SetWrapS(vtkTextureObject::ClampToEdge);
    this->Field->SetWrapT(vtkTextureObject::ClampToEdge);
    this->Field->SetWrapR(vtkTextureObject::ClampToEdge);
    this->Field->Create3DFromRaw(size.x, size.y, size.z, 1, VTK_FLOAT, values.data());
  }

  bool IsCompiled() const { return this->Quad->Program && this->Quad->Program->GetCompiled(); }

  /// One result of up to four numbers for each row of the table.
  std::vector<glm::vec4> Evaluate(Formula formula, std::vector<Arguments> table)
  {
    const std::size_t count = table.size();
    const unsigned int width = 256, height = static_cast<unsigned int>((count + 255) / 256);
    table.resize(std::size_t(width) * height);
    vtkNew<vtkTextureObject> arguments, results;
    arguments->SetContext(this->GL);
    arguments->SetMinificationFilter(vtkTextureObject::Nearest);
    arguments->SetMagnificationFilter(vtkTextureObject::Nearest);
    arguments->Create2DFromRaw(2 * width, height, 4, VTK_FLOAT, table.data());
    results->SetContext(this->GL);
    results->Create2D(width, height, 4, VTK_FLOAT, false);

    vtkOpenGLState* state = this->GL->GetState();
    state->PushFramebufferBindings();
    vtkNew<vtkOpenGLFramebufferObject> target;
    target->SetContext(this->GL);
    target->Bind();
    target->AddColorAttachment(0, results);
    target->ActivateDrawBuffers(1);
    state->vtkglViewport(0, 0, width, height);
    state->vtkglScissor(0, 0, width, height);
    state->vtkglDisable(0x0BE2); // GL_BLEND
    state->vtkglDisable(0x0B71); // GL_DEPTH_TEST
    this->GL->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
    arguments->Activate();
    this->Quad->Program->SetUniformi("arguments", arguments->GetTextureUnit());
    this->Quad->Program->SetUniformi("formula", formula);
    if (this->Field->GetHandle())
    {
      this->Field->Activate();
      const int unit = this->Field->GetTextureUnit();
      this->Quad->Program->SetUniform1iv("fields", 1, &unit);
      vtkMediumSetFoldUniforms(this->Quad->Program, "fieldFolds[0]", this->Fold);
    }
    const float outputSize[2] = { static_cast<float>(width), static_cast<float>(height) };
    this->Quad->Program->SetUniform2f("outputSize", outputSize);
    this->Quad->Render();
    arguments->Deactivate();
    if (this->Field->GetHandle())
    {
      this->Field->Deactivate();
    }
    state->PopFramebufferBindings();

    std::vector<glm::vec4> values(table.size());
    unsigned int size[2] = { width, height };
    vtkIdType increments[2] = { 0, 0 };
    vtkPixelBufferObject* buffer = results->Download();
    buffer->Download2D(VTK_FLOAT, &values[0][0], size, 4, increments);
    buffer->Delete();
    target->ReleaseGraphicsResources(this->GL);
    arguments->ReleaseGraphicsResources(this->GL);
    results->ReleaseGraphicsResources(this->GL);
    values.resize(count);
    return values;
  }

private:
  vtkNew<vtkRenderWindow> Window;
  vtkOpenGLRenderWindow* GL = nullptr;
  vtkNew<vtkTextureObject> Field;
  vtkMediumFold Fold;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

#endif
