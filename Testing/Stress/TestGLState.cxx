// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What a frame leaves behind in OpenGL, and in memory after many of them.
#include "OpaquePlane.h"
#include "StressStage.h"

#include "vtkOpenGLState.h"
#include "vtkShaderProperty.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <memory>
#include <unistd.h>

using namespace vtkMediumStress;

namespace
{
constexpr int Integrators[] = { Mapper::Paper, Mapper::FixedStep, Mapper::ErrorControlled,
  Mapper::Exact };

struct Field
{
  GLenum Name;
  const char* Words;
  int Count; ///< of numbers
};

const Field Switches[] = {
  { GL_BLEND, "blend", 1 },
  { GL_CULL_FACE, "cull face", 1 },
  { GL_DEPTH_TEST, "depth test", 1 },
  { GL_MULTISAMPLE, "multisample", 1 },
  { GL_SCISSOR_TEST, "scissor test", 1 },
  { GL_STENCIL_TEST, "stencil test", 1 },
  { GL_TEXTURE_CUBE_MAP_SEAMLESS, "seamless cube maps", 1 },
};

/// What vtkOpenGLState answers for from its cache.
const Field Tracked[] = {
  { GL_ACTIVE_TEXTURE, "active texture", 1 },
  { GL_BLEND_DST_ALPHA, "blend destination alpha", 1 },
  { GL_BLEND_DST_RGB, "blend destination colour", 1 },
  { GL_BLEND_SRC_ALPHA, "blend source alpha", 1 },
  { GL_BLEND_SRC_RGB, "blend source colour", 1 },
  { GL_COLOR_CLEAR_VALUE, "clear colour", 4 },
  { GL_COLOR_WRITEMASK, "colour mask", 4 },
  { GL_CULL_FACE_MODE, "cull face mode", 1 },
  { GL_DEPTH_FUNC, "depth function", 1 },
  { GL_DEPTH_WRITEMASK, "depth mask", 1 },
  { GL_SCISSOR_BOX, "scissor", 4 },
  { GL_VIEWPORT, "viewport", 4 },
};

/// What it does not cache, or not in each version, but relies on.
const Field Bound[] = {
  { GL_BLEND_EQUATION_ALPHA, "blend equation alpha", 1 },
  { GL_BLEND_EQUATION_RGB, "blend equation colour", 1 },
  { GL_DEPTH_CLAMP, "depth clamp", 1 },
  { GL_DEPTH_CLEAR_VALUE, "clear depth", 1 },
  { GL_DRAW_FRAMEBUFFER_BINDING, "drawn framebuffer", 1 },
  { GL_READ_FRAMEBUFFER_BINDING, "read framebuffer", 1 },
  { GL_DRAW_BUFFER, "draw buffer", 1 },
  { GL_PACK_ALIGNMENT, "pack alignment", 1 },
  { GL_UNPACK_ALIGNMENT, "unpack alignment", 1 },
  { GL_PIXEL_PACK_BUFFER_BINDING, "pixel pack buffer", 1 },
  { GL_PIXEL_UNPACK_BUFFER_BINDING, "pixel unpack buffer", 1 },
  { GL_STENCIL_WRITEMASK, "stencil mask", 1 },
};

using State = std::map<std::string, std::vector<float>>;

std::vector<float> Ask(const std::function<void(GLenum, GLfloat*)>& get, const Field& field)
{
  std::array<GLfloat, 4> values{};
  get(field.Name, values.data());
  return { values.begin(), values.begin() + field.Count };
}

/// The state of the context, and whether VTK's copy of it is right.
State Capture(vtkOpenGLRenderWindow* window, const char* when)
{
  vtkOpenGLState* state = window->GetState();
  State captured;
  for (const Field& field : Switches)
  {
    captured[field.Words] = { glIsEnabled(field.Name) ? 1.0f : 0.0f };
    EXPECT_EQ(state->GetEnumState(field.Name), captured[field.Words][0] != 0)
      << "VTK's copy of: " << field.Words << ", " << when;
  }
  for (const Field& field : Tracked)
  {
    captured[field.Words] = Ask([](GLenum name, GLfloat* v) { glGetFloatv(name, v); }, field);
    if (field.Name == GL_COLOR_CLEAR_VALUE)
    {
      EXPECT_EQ(Ask([&](GLenum name, GLfloat* v) { state->vtkglGetFloatv(name, v); }, field),
        captured[field.Words])
        << "VTK's copy of: " << field.Words << ", " << when;
    }
    else if (field.Name == GL_VIEWPORT || field.Name == GL_SCISSOR_BOX)
    {
      std::array<int, 4> copy{};
      state->vtkglGetIntegerv(field.Name, copy.data());
      EXPECT_EQ(std::vector<float>(copy.begin(), copy.end()), captured[field.Words])
        << "VTK's copy of: " << field.Words << ", " << when;
    }
  }
  for (const Field& field : Bound)
  {
    captured[field.Words] = Ask([](GLenum name, GLfloat* v) { glGetFloatv(name, v); }, field);
  }
  return captured;
}

/// Compares what the mapper found with what it left.
struct StateWatch
{
  Stage& Scene;
  State Before;
  int Frames = 0;

  explicit StateWatch(Stage& stage)
    : Scene(stage)
  {
    for (unsigned long event :
      { vtkCommand::VolumeMapperRenderStartEvent, vtkCommand::VolumeMapperRenderEndEvent })
    {
      vtkNew<vtkCallbackCommand> listener;
      listener->SetClientData(this);
      listener->SetCallback([](vtkObject*, unsigned long when, void* watch, void*) {
        static_cast<StateWatch*>(watch)->Look(when == vtkCommand::VolumeMapperRenderStartEvent);
      });
      stage.Mapper->AddObserver(event, listener);
    }
  }

  void Look(bool before)
  {
    vtkOpenGLRenderWindow* window = vtkOpenGLRenderWindow::SafeDownCast(this->Scene.Window);
    const State state = Capture(window, before ? "before" : "after");
    if (before)
    {
      this->Before = state;
      return;
    }
    ++this->Frames;
    for (const auto& field : this->Before)
    {
      EXPECT_EQ(field.second, state.at(field.first)) << field.first;
    }
  }
};

/// A field with lights of each kind and opaque geometry in them, so that every texture is in use.
struct BusyStage : Stage
{
  explicit BusyStage(Trial& trial, int pixels = 16)
    : Stage(trial,
        MakeImage(glm::ivec3(9), glm::dvec3(1),
          [](const glm::dvec3& p) { return std::max(1 - glm::length(p), 0.0); }),
        pixels)
  {
    if (!trial.Is(vtkMediumStress::Mapper::Paper))
    {
      this->SetField(3);
    }
    this->Mapper->SetMaximumError(0.01);
    this->AddBeam({ 1, -1, -0.3 });
    this->AddPointLight({ 1, 1, 1 });
    vtkMediumTest::Quad{ { 0.1, 0.1, 0.1 }, { 0.2, 0, 0.1 }, { 0, 0.2, 0.1 } }.AddTo(
      this->Renderer);
    this->Mapper->OpaqueShadowsOn();
    this->Mapper->SetOpaqueShadowResolution(64);
    this->Look({ 0.3, 0.2, -1 }, 2);
    this->SetSteps(0.1, 0.1);
  }
};

/// Of the process, in MiB.
double ResidentMemory()
{
  std::ifstream file("/proc/self/statm");
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576;
}

/// Runs a change 100 times and says how much memory the last 60 of them cost.
double Growth(const char* name, const std::function<void()>& change)
{
  double before = 0;
  for (int i = 0; i < 100; ++i)
  {
    if (i == 40)
    {
      before = ResidentMemory();
    }
    change();
  }
  const double growth = ResidentMemory() - before;
  std::cout << name << ": " << before << " MiB after 40 times, " << growth << " more after 100\n";
  WriteMemory(name, before, growth);
  return growth;
}
}

TEST(GLState, IsTheSameBeforeAndAfterAFrame)
{
  for (int integrator : Integrators)
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    Trial trial(integrator);
    BusyStage stage(trial);
    StateWatch watch(stage);
    stage.Render();
    stage.Look({ 1, 0.2, 0 }, 2); // without anything to build
    stage.Render();
    stage.Mapper->RenderToImageOn();
    stage.Render();
    stage.Volume->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Medium::Color::Impl", true, "color *= 0.5;", false);
    stage.Render();
    EXPECT_EQ(watch.Frames, 4);
  }
}

TEST(GLState, IsTheSameAfterARefusedFrame)
{
  Trial trial(Mapper::FixedStep);
  BusyStage stage(trial);
  StateWatch watch(stage);
  stage.Mapper->SetSampleDistance(-1);
  stage.Window->Render();
  EXPECT_EQ(stage.Errors.size(), 1u);
  EXPECT_EQ(watch.Frames, 1);
}

// What grows is held against what VTK's own empty window costs, as drivers keep some of each context.
TEST(Contexts, HundredWindowsCostNoMemory)
{
  const double vtk = Growth("a window of VTK without a volume", [] {
    vtkNew<vtkRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    window->SetOffScreenRendering(1);
    window->SetSize(16, 16);
    window->AddRenderer(renderer);
    window->Render();
  });
  const double ours = Growth("a window with a volume", [] {
    Trial trial(Mapper::FixedStep);
    BusyStage(trial).Render();
  });
  EXPECT_LT(ours, vtk + 6); // 0.1 MiB a window
}

TEST(Contexts, HundredSizesCostNoMemory)
{
  Trial trial(Mapper::FixedStep);
  BusyStage stage(trial);
  int number = 0;
  EXPECT_LT(Growth("another size of the window",
              [&] {
                const int size = 8 + ++number * 37 % 61;
                stage.Window->SetSize(size, size);
                EXPECT_EQ(stage.Render().Size, glm::ivec2(size));
              }),
    6);
}

TEST(Contexts, HundredHandOversCostNoMemory)
{
  Trial trial(Mapper::FixedStep);
  BusyStage stage(trial);
  const Picture first = stage.Render();
  vtkNew<vtkRenderWindow> other;
  other->SetMultiSamples(0);
  other->SetOffScreenRendering(1);
  other->SetSize(16, 16);
  vtkRenderWindow* windows[2] = { other, stage.Window };
  int number = 0;
  EXPECT_LT(Growth("the volume handed to another window",
              [&] {
                vtkRenderWindow* to = windows[number % 2];
                windows[++number % 2]->RemoveRenderer(stage.Renderer);
                to->AddRenderer(stage.Renderer);
                to->Render();
                vtkNew<vtkImageData> image;
                stage.Mapper->GetColorImage(image);
                EXPECT_EQ(first.Values, Picture(image).Values);
              }),
    6);
  EXPECT_TRUE(stage.Errors.empty());
}
