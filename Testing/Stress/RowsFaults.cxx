// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Row 57: devices that fail. One clear error, the background stays, and what comes next is right.
#include "GLFault.h"
#include "OpaquePlane.h"
#include "StressRefusal.h"

#include <dlfcn.h>

#include <memory>

#if !VTK_MODULE_ENABLE_VTK_glad
/// These two stand before those of libGL in the order of symbols, for VTK's libraries too.
extern "C" __attribute__((visibility("default"))) void glTexImage2D(GLenum target, GLint level,
  GLint format, GLsizei width, GLsizei height, GLint border, GLenum pixels, GLenum type,
  const void* data)
{
  using Function =
    void (*)(GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*);
  static const Function real = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glTexImage2D"));
  const bool deny = vtkMediumStress::GLFault::Denies2D(format);
  real(deny ? GLenum(GL_NONE) : target, level, format, width, height, border, pixels, type, data);
}

extern "C" __attribute__((visibility("default"))) void glGetIntegerv(GLenum name, GLint* value)
{
  using Function = void (*)(GLenum, GLint*);
  static const Function real = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glGetIntegerv"));
  real(name, value);
  vtkMediumStress::GLFault::Answer(name, value);
}
#endif

namespace vtkMediumStress
{
namespace
{
/// A change that needs a new program, texture and framebuffer.
void Unsettle(Stage& stage)
{
  stage.Mapper->ReleaseGraphicsResources(stage.Window);
  stage.Medium->SetPhaseFunctionToSchlickK();
  stage.Medium->SetAnisotropy(0.3);
  stage.Medium->SetExtinctionArrayName("");
}

void Settle(Stage& stage)
{
  stage.Medium->SetPhaseFunctionToHenyeyGreenstein();
  stage.Medium->SetAnisotropy(0);
  stage.Medium->SetExtinctionArrayName(nullptr);
  stage.Watch.Forget();
}

void CheckFault(Trial& trial, GLFault::Kinds kind, const std::string& word)
{
  std::unique_ptr<GLFault> fault;
  CheckRefusal(
    trial, word,
    [&](Stage& stage) {
      Unsettle(stage);
      if (trial.Is(
            Mapper::Paper)) // which takes no coefficient from an array, and reads the scalars
      {
        stage.Medium->SetExtinctionArrayName(nullptr);
      }
      fault.reset(new GLFault(kind));
    },
    [&](Stage& stage) {
      stage.Window->MakeCurrent();
      fault.reset();
      Settle(stage);
    },
    true);
}

/// No shadow map of geometry out of the view; without these shadows the frame is drawn.
void CheckShadowMapFault(Trial& trial)
{
  std::unique_ptr<GLFault> fault;
  CheckRefusal(
    trial, "shadows of opaque geometry",
    [&](Stage& stage) {
      vtkMediumTest::Quad{ { -5, 4, -5 }, { 10, 0, 0 }, { 0, 0, 10 } }.AddTo(stage.Renderer);
      stage.Mapper->OpaqueShadowsOn();
      fault.reset(new GLFault(GLFault::NoMemoryForDepth));
    },
    [&](Stage& stage) {
      stage.Window->MakeCurrent();
      fault.reset();
      stage.Mapper->OpaqueShadowsOff();
      stage.Watch.Forget();
    },
    true);
}

/// The same program, refused before, compiles once the device can and the resources were released.
void CheckRecompiles(Trial& trial)
{
  Stage stage(trial, MakeBox(), 8);
  stage.AddBeam({ 0.3, -1, -0.2 });
  {
    PrintedErrors printed;
    Stage other(trial, MakeBox(), 8);
    GLFault fault(GLFault::ShaderDoesNotCompile);
    stage.Window->Render();
  }
  trial.Holds(stage.Errors.size() == 1, "one error event");
  stage.Errors.clear();
  stage.Mapper->ReleaseGraphicsResources(stage.Window);
  trial.Holds(stage.Render().Mean() > 0, "the shader compiles after all");
}

void Faults(Trial& trial)
{
  CheckFault(trial, GLFault::ShaderDoesNotCompile, "did not compile");
  CheckRecompiles(trial);
  CheckFault(trial, GLFault::NoFloatTargets, "float image");
  CheckFault(trial, GLFault::NoMemoryFor2D, "could not allocate");
  CheckFault(trial, GLFault::NoMemoryFor3D, "could not allocate");
  CheckShadowMapFault(trial);
  CheckFault(trial, GLFault::NoTextures3D, "largest 3D texture has 0");
}
}

std::vector<Row> FaultRows()
{
  return {
    { 57, "FailingDevicesAreReportedOnce",
      "E: no compiler, no float targets, no memory for 2D and 3D textures, no 3D textures", Faults,
      {} },
  };
}
}
