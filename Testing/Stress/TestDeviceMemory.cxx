// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What a change made needless leaves the device: afterwards there are as many textures, and bytes in the
// statistics, as if it had never been there.
#include "OpaquePlane.h"
#include "StressStage.h"

#include "vtkActorCollection.h"
#include "vtkMediumStatistics.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

using namespace vtkMediumStress;

namespace
{
struct MemoryScene : Scene
{
  MemoryScene()
    : Scene(vtkMediumFixtures::MakeImage(vtkMediumFixtures::Smooth, glm::ivec3(20)), 48)
  {
    this->Medium->SetExtinctionArrayName("");
    this->Medium->SetExtinctionScale(4);
    this->AddBeam({ 0.3, -1, -0.2 });
    this->Mapper->SetLightCachesToAlways();
    this->Mapper->SetMaximumError(0.05);
    this->Look({ 0.4, -0.3, -1 }, 2.4);
  }

  vtkTypeInt64 GetBytes() { return this->Mapper->GetStatistics()->GetGPUBytes(); }

  /// In this window's context.
  int CountTextures()
  {
    constexpr GLuint most = 4096; // names are given in order
    this->Window->MakeCurrent();
    int count = 0;
    for (GLuint name = 1; name < most; ++name)
    {
      count += glIsTexture(name) == GL_TRUE;
    }
    return count;
  }
};

void MaskAll(MemoryScene& s)
{
  s.Mapper->SetMaskInput(vtkMediumTest::MakeImage(
    glm::ivec3(20), glm::dvec3(1), [](const glm::dvec3& at) { return at.x > 0 ? 1 : 0; }, false,
    VTK_UNSIGNED_CHAR));
}

/// Not the volume, which would release all that it has.
void RemoveActors(MemoryScene& s)
{
  while (vtkActor* actor = s.Renderer->GetActors()->GetLastActor())
  {
    s.Renderer->RemoveActor(actor);
  }
}

struct Change
{
  const char* Name;
  void (*Before)(MemoryScene&);
  void (*After)(MemoryScene&);
  bool VTKKeeps = false; ///< textures of a pass of its own
};

void PrintTo(const Change& change, std::ostream* os)
{
  *os << change.Name;
}

const Change Changes[] = {
  { "Integrator", [](MemoryScene& s) { s.Mapper->SetIntegratorToErrorControlled(); },
    [](MemoryScene& s) { s.Mapper->SetIntegratorToFixedStep(); } },
  { "CarriedMarch", [](MemoryScene& s) { s.Mapper->SetIntegratorToExact(); },
    [](MemoryScene& s) { s.Mapper->SetIntegratorToFixedStep(); } },
  { "Mask", MaskAll, [](MemoryScene& s) { s.Mapper->SetMaskInput(nullptr); } },
  { "Array", [](MemoryScene&) {},
    [](MemoryScene& s) { s.Medium->SetExtinctionArrayName(nullptr); } },
  { "LastLight", [](MemoryScene& s) { s.Mapper->SetIntegratorToErrorControlled(); },
    [](MemoryScene& s) {
      s.Mapper->SetIntegratorToErrorControlled();
      s.Renderer->RemoveAllLights();
    } },
  { "LightCaches", [](MemoryScene& s) { s.Mapper->SetIntegratorToErrorControlled(); },
    [](MemoryScene& s) {
      s.Mapper->SetIntegratorToErrorControlled();
      s.Mapper->SetLightCachesToNever();
    } },
  { "FewerLights",
    [](MemoryScene& s) {
      s.Mapper->SetIntegratorToErrorControlled();
      for (int i = 0; i < 4; ++i) // more than share a texture
      {
        s.AddBeam({ 0.2 * i, -1, 0.1 });
      }
    },
    [](MemoryScene& s) {
      s.Mapper->SetIntegratorToErrorControlled();
      s.Renderer->RemoveAllLights();
      s.AddBeam({ 0.3, -1, -0.2 });
    } },
  { "OpaqueShadows",
    [](MemoryScene& s) {
      Quad{ { -5, 4, -5 }, { 10, 0, 0 }, { 0, 0, 10 } }.AddTo(s.Renderer);
      s.Mapper->OpaqueShadowsOn();
    },
    [](MemoryScene& s) {
      RemoveActors(s);
      s.Mapper->OpaqueShadowsOff();
    } },
  { "ErrorEstimate", [](MemoryScene& s) { s.Mapper->SetOutputToErrorEstimate(); },
    [](MemoryScene& s) { s.Mapper->SetOutputToRadiance(); } },
  { "Peeling",
    [](MemoryScene& s) {
      Plane{ { 0, 0, 1 }, 0.6 }.AddTo(s.Renderer)->GetProperty()->SetOpacity(0.5);
      s.Window->SetAlphaBitPlanes(1);
      s.Renderer->UseDepthPeelingOn();
      s.Renderer->UseDepthPeelingForVolumesOn();
    },
    [](MemoryScene& s) {
      s.Window->SetAlphaBitPlanes(1);
      RemoveActors(s);
      s.Renderer->UseDepthPeelingOff();
      s.Renderer->UseDepthPeelingForVolumesOff();
    },
    true },
};

class DeviceMemory : public testing::TestWithParam<Change>
{
};
}

TEST_P(DeviceMemory, IsThatOfWhatIsDrawn)
{
  MemoryScene scene;
  GetParam().Before(scene);
  scene.Window->Render();
  const vtkTypeInt64 before = scene.GetBytes();
  const int texturesBefore = scene.CountTextures();
  GetParam().After(scene);
  scene.Window->Render();
  MemoryScene fresh;
  GetParam().After(fresh);
  fresh.Window->Render();
  ASSERT_TRUE(scene.Errors.empty());
  EXPECT_LT(scene.GetBytes(), before);
  EXPECT_LT(scene.CountTextures(), texturesBefore);
  EXPECT_EQ(scene.GetBytes(), fresh.GetBytes());
  EXPECT_TRUE(GetParam().VTKKeeps || scene.CountTextures() == fresh.CountTextures());
}

INSTANTIATE_TEST_SUITE_P(After, DeviceMemory, testing::ValuesIn(Changes),
  [](const auto& parameters) { return std::string(parameters.param.Name); });

// A selection or an output without light between two frames takes nothing away that is wanted again.
TEST(DeviceMemoryIsKept, WhileAnOutputNeedsNoLight)
{
  MemoryScene scene;
  scene.Mapper->SetIntegratorToErrorControlled();
  scene.Window->Render();
  vtkMediumStatistics* done = scene.Mapper->GetStatistics();
  const vtkTypeInt64 uploads = done->GetLightCacheUploads();
  scene.Mapper->SetOutputToTransmittance();
  scene.Window->Render();
  scene.Mapper->SetOutputToRadiance();
  scene.Window->Render();
  EXPECT_EQ(done->GetLightCacheUploads(), uploads);
}

// And what was taken away comes back.
TEST(DeviceMemoryIsKept, ForAsLongAsItsIntegratorDraws)
{
  MemoryScene scene;
  scene.Mapper->SetIntegratorToErrorControlled();
  const Picture first = scene.Render();
  vtkMediumStatistics* done = scene.Mapper->GetStatistics();
  const vtkTypeInt64 builds = done->GetLightCacheBuilds(), uploads = done->GetLightCacheUploads();
  scene.Mapper->SetIntegratorToFixedStep();
  scene.Window->Render();
  scene.Mapper->SetIntegratorToErrorControlled();
  EXPECT_EQ(scene.Render().Values, first.Values);
  EXPECT_EQ(done->GetLightCacheBuilds(), builds) << "it is not made anew";
  EXPECT_EQ(done->GetLightCacheUploads(), uploads + 1);
}
