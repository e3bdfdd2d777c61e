// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// An interactive session, hurried frames and frames at rest by turns: the first frame at rest compiles what
// hurried ones will need, whatever a user turns, and frames at rest a bounded number of programs altogether.
#include "CutScene.h"

#include "vtkLightCollection.h"
#include "vtkPiecewiseFunction.h"

using namespace vtkMediumTest;

namespace
{
constexpr double Interacting = 15, AtRest = 0.0001; // VTK's own desired frames a second

/// Everything is there from the start that a session will turn: three lights, a function, a plane that cuts.
struct SessionScene : ReferenceScene
{
  vtkNew<vtkPiecewiseFunction> Extinction;
  vtkSmartPointer<vtkPlane> Plane;

  explicit SessionScene(vtkMediumFixtures::Fields field)
    : ReferenceScene(field)
  {
    this->Mapper->SetIntegratorToErrorControlled();
    this->Extinction->AddPoint(0, 0);
    this->Extinction->AddPoint(1, 1);
    this->Medium->SetExtinctionFunction(this->Extinction);
    this->Medium->SetExtinctionScale(6);
    this->Plane = AddPlane(*this, { -1, 0.8, 0.3 }, { 0.2, 0, 0 });
  }

  vtkLight* GetLight(int number)
  {
    return vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(number));
  }

  vtkTypeInt64 RenderAndCountCompiles(double rate)
  {
    this->Window->SetDesiredUpdateRate(rate);
    EXPECT_TRUE(this->Render().IsLight());
    return this->Mapper->GetStatistics()->GetProgramCompiles();
  }
};

struct Turn
{
  const char* Name;
  void (*Apply)(SessionScene& scene, int frame);
};

const Turn Turns[] = {
  { "camera", [](SessionScene& s, int) { s.Camera->Azimuth(7); } },
  { "zoom", [](SessionScene& s, int) { s.Camera->Dolly(1.1); } },
  { "camera into the volume",
    [](SessionScene& s, int frame) {
      s.Look({ 1, 0.2, 0.3 }, 0.1 * (frame + 1));
    } },
  { "camera out of it",
    [](SessionScene& s, int) {
      s.Look({ 0.4, -0.3, -1 }, 2.4);
    } },
  { "parallel camera",
    [](SessionScene& s, int frame) { s.Camera->SetParallelProjection(frame % 2); } },
  { "light's place",
    [](SessionScene& s, int frame) { s.GetLight(0)->SetPosition(1, 1, 0.3 * frame); } },
  { "lamp's place",
    [](SessionScene& s, int frame) { s.GetLight(1)->SetPosition(-0.9, 0.8 - 0.5 * frame, 0.3); } },
  { "light's colour",
    [](SessionScene& s, int frame) { s.GetLight(0)->SetDiffuseColor(1, 0.4 * frame, 0.1); } },
  { "intensity", [](SessionScene& s, int frame) { s.GetLight(2)->SetIntensity(2 + frame); } },
  { "albedo", [](SessionScene& s, int frame) { s.Medium->SetAlbedo(0.9 - 0.2 * frame); } },
  { "anisotropy", [](SessionScene& s, int frame) { s.Medium->SetAnisotropy(0.5 - 0.2 * frame); } },
  { "extinction", [](SessionScene& s, int frame) { s.Medium->SetExtinctionScale(5 + 2 * frame); } },
  { "density", [](SessionScene& s, int frame) { s.Medium->SetDensityScale(0.8 + 0.3 * frame); } },
  { "function",
    [](SessionScene& s, int frame) { s.Extinction->AddPoint(0.5, 0.2 + 0.2 * frame); } },
  { "plane", [](SessionScene& s, int frame) { s.Plane->SetOrigin(0.1 * frame, 0, 0); } },
  { "size of the window",
    [](SessionScene& s, int frame) { s.Window->SetSize(48 + 8 * frame, 48); } },
  { "pixels of a ray",
    [](SessionScene& s, int frame) { s.Mapper->SetImageSampleDistance(1 + frame % 2); } },
};
}

//------------------------------------------------------------------------------
TEST(Session, CompilesNothingWhileInteracting)
{
  for (vtkMediumFixtures::Fields field : { vtkMediumFixtures::Smooth, vtkMediumFixtures::Cloud })
  {
    SessionScene scene(field);
    vtkTypeInt64 compiles = scene.RenderAndCountCompiles(AtRest);
    for (const Turn& turn : Turns)
    {
      for (int frame = 0; frame < 2; ++frame)
      {
        turn.Apply(scene, frame);
        EXPECT_EQ(scene.RenderAndCountCompiles(Interacting), compiles) << turn.Name << ", hurried";
      }
      compiles = scene.RenderAndCountCompiles(AtRest); // another way to the lights may serve now
    }
    EXPECT_LE(compiles, 7) << "six of one scene, and the picture's way into the window";
    EXPECT_TRUE(scene.Scene::Errors.empty());
  }
}

//------------------------------------------------------------------------------
// What changes the structure is compiled when it first does, and not when it comes back.
TEST(Session, CompilesOnceForWhatItSwitches)
{
  const Turn switches[] = {
    { "a light more", [](SessionScene& s, int frame) { s.GetLight(2)->SetSwitch(frame % 2); } },
    { "another kind of light",
      [](SessionScene& s, int frame) { s.GetLight(2)->SetConeAngle(frame % 2 ? 60 : 180); } },
    { "no anisotropy",
      [](SessionScene& s, int frame) { s.Medium->SetAnisotropy(frame % 2 ? 0.4 : 0); } },
    { "a colour of the extinction",
      [](SessionScene& s, int frame) { s.Medium->SetExtinctionScale(6, 6, frame % 2 ? 6 : 7); } },
    { "cropping", [](SessionScene& s, int frame) { s.Mapper->SetCropping((frame + 1) % 2); } },
    { "integrator",
      [](SessionScene& s, int frame) {
        frame % 2 ? s.Mapper->SetIntegratorToErrorControlled()
                  : s.Mapper->SetIntegratorToFixedStep();
      } },
  };
  SessionScene scene(vtkMediumFixtures::Smooth);
  scene.Mapper->SetCroppingRegionPlanes(-0.2, 0.15, -0.1, 0.17, -0.33, 0.21);
  scene.Mapper->SetCroppingRegionFlagsToFence();
  scene.RenderAndCountCompiles(AtRest);
  for (const Turn& turn : switches)
  {
    vtkTypeInt64 compiles = 0;
    for (int frame = 0; frame < 6; ++frame)
    {
      turn.Apply(scene, frame);
      scene.RenderAndCountCompiles(Interacting);
      const vtkTypeInt64 now = scene.RenderAndCountCompiles(AtRest);
      EXPECT_TRUE(frame < 2 || now == compiles) << turn.Name << ", frame " << frame;
      compiles = now;
    }
  }
}
