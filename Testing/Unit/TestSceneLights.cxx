// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Every kind of vtkLight as a fact of the scene. The image is a cube of 30 world units a side from
// (100, 0, 0), so a local unit is 30 sqrt(3) world units and the local origin is (115, 15, 15).
#include "MediumInput.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
const double Length = 30 * std::sqrt(3.0);
const glm::dvec3 Centre(115, 15, 15);

struct LitScene : MediumInput
{
  vtkNew<vtkRenderer> Renderer;

  LitScene()
  {
    this->Image->SetOrigin(100, 0, 0);
    this->Image->SetSpacing(15, 15, 15);
    this->Renderer->AutomaticLightCreationOff();
    EXPECT_EQ(this->GatherMedium(), "");
  }

  vtkSmartPointer<vtkLight> Add(const glm::dvec3& position, const glm::dvec3& focus)
  {
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetPosition(position.x, position.y, position.z);
    light->SetFocalPoint(focus.x, focus.y, focus.z);
    light->SetColor(1, 0.5, 0.25);
    light->SetIntensity(4);
    this->Renderer->AddLight(light);
    return light;
  }

  const vtkMediumScene::Light& Only()
  {
    EXPECT_EQ(this->Scene.GatherLights(this->Renderer), "");
    EXPECT_EQ(this->Scene.Lights.size(), 1u);
    return this->Scene.Lights.at(0);
  }

  /// Wherever it shines.
  vtkMediumScene::Light Read(vtkLight* source)
  {
    vtkMediumScene::Light light;
    EXPECT_EQ(this->Scene.ReadLight(this->Renderer, source, light), "");
    return light;
  }
};

void ExpectNear(const glm::dvec3& found, const glm::dvec3& expected)
{
  EXPECT_LT(glm::length(found - expected), 1e-12 * (1 + glm::length(expected)))
    << found.x << " " << found.y << " " << found.z << " instead of " << expected.x << " "
    << expected.y << " " << expected.z;
}

glm::dvec3 ToLocal(const glm::dvec3& world)
{
  return (world - Centre) / Length;
}
}

TEST(SceneLights, DirectionalLightTravelsFromItsPositionToItsFocalPoint)
{
  LitScene scene;
  vtkLight* light = scene.Add({ 5, 0, 0 }, { 2, 4, 0 });
  light->SetAttenuationValues(0, 0, 0); // of positional lights only
  light->SetConeAngle(10);
  const auto& found = scene.Only();
  EXPECT_EQ(found.Type, vtkMediumScene::Light::Directional);
  ExpectNear(found.Direction, { -0.6, 0.8, 0 });
  ExpectNear(found.Irradiance, { 4, 2, 1 });
}

TEST(SceneLights, PositionalLightAttenuatesByWorldDistance)
{
  LitScene scene;
  vtkLight* light = scene.Add({ 120, 40, -7 }, { 0, 0, 0 });
  light->PositionalOn();
  light->SetConeAngle(90);
  light->SetAttenuationValues(0.5, 0.25, 0.125);
  const auto& found = scene.Only();
  EXPECT_EQ(found.Type, vtkMediumScene::Light::Point);
  ExpectNear(found.Position, ToLocal({ 120, 40, -7 }));
  const double world = 17;
  const double r = world / Length;
  EXPECT_NEAR(found.Attenuation.x + r * (found.Attenuation.y + r * found.Attenuation.z),
    0.5 + 0.25 * world + 0.125 * world * world, 1e-10);
}

TEST(SceneLights, PointLightNeedsNoFocalPoint)
{
  LitScene scene;
  vtkLight* light = scene.Add(Centre, Centre); // inside the volume
  light->PositionalOn();
  light->SetConeAngle(120);
  const auto& found = scene.Only();
  EXPECT_EQ(found.Type, vtkMediumScene::Light::Point);
  ExpectNear(found.Position, glm::dvec3(0));
  EXPECT_NEAR(glm::length(found.Direction), 1, 1e-12);
}

TEST(SceneLights, SpotHasAConeAnExponentAndAnAxis)
{
  LitScene scene;
  vtkLight* light = scene.Add({ 115, 15, 100 }, { 115, 15, 0 });
  light->PositionalOn();
  light->SetConeAngle(30); // VTK's default is 30 too: the half angle
  light->SetExponent(7);
  const auto& found = scene.Only();
  EXPECT_EQ(found.Type, vtkMediumScene::Light::Spot);
  EXPECT_NEAR(found.CosCone, std::sqrt(0.75), 1e-12);
  EXPECT_EQ(found.Exponent, 7);
  ExpectNear(found.Direction, { 0, 0, -1 });
  light->SetConeAngle(89.999);
  EXPECT_EQ(scene.Only().Type, vtkMediumScene::Light::Spot);
}

// The volume's corners are half a local unit from its centre: from two units away they are within asin(1/4),
// 14.5 degrees.
TEST(SceneLights, SpotsWhoseConeMissesTheVolumeAreLeftOut)
{
  LitScene scene;
  const glm::dvec3 place = Centre + glm::dvec3(0, 0, 2 * Length);
  vtkLight* light = scene.Add(place, Centre);
  light->PositionalOn();
  light->SetConeAngle(5);
  const auto countAt = [&](double degrees) {
    const double angle = degrees * std::acos(-1.0) / 180;
    const glm::dvec3 focus = place + glm::dvec3(std::sin(angle), 0, -std::cos(angle));
    light->SetFocalPoint(focus.x, focus.y, focus.z);
    EXPECT_EQ(scene.Scene.GatherLights(scene.Renderer), "");
    return scene.Scene.Lights.size();
  };
  for (double degrees : { 0.0, 10.0, 19.3, -19.3 })
  {
    EXPECT_EQ(countAt(degrees), 1u) << degrees;
  }
  for (double degrees : { 19.6, -19.6, 90.0, 180.0 })
  {
    EXPECT_EQ(countAt(degrees), 0u) << degrees;
  }
  light->SetPosition(Centre.x, Centre.y, Centre.z); // from inside, every cone meets it
  light->SetFocalPoint(Centre.x + 1, Centre.y, Centre.z);
  EXPECT_EQ(scene.Scene.GatherLights(scene.Renderer), "");
  EXPECT_EQ(scene.Scene.Lights.size(), 1u);
}

TEST(SceneLights, TransformMatrixMovesPositionAndFocalPoint)
{
  LitScene scene;
  vtkLight* light = scene.Add({ 1, 0, 0 }, { 0, 0, 0 });
  light->PositionalOn();
  light->SetConeAngle(20);
  vtkNew<vtkTransform> transform;
  transform->Translate(10, 20, 30);
  transform->RotateZ(90);
  transform->Scale(3, 1, 1);
  light->SetTransformMatrix(transform->GetMatrix());
  const vtkMediumScene::Light found = scene.Read(light);
  ExpectNear(found.Position, ToLocal({ 10, 23, 30 }));
  ExpectNear(found.Direction, { 0, -1, 0 });
}

TEST(SceneLights, HeadlightShinesFromTheCameraOfNow)
{
  LitScene scene;
  vtkLight* light = scene.Add({ 9, 9, 9 }, { 0, 1, 0 });
  light->SetLightTypeToHeadlight();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 50);
  camera->SetFocalPoint(0, 0, 0);
  ExpectNear(scene.Only().Direction, { 0, 0, -1 });
  camera->SetPosition(30, 0, 40); // not rendered since
  ExpectNear(scene.Only().Direction, { -0.6, 0, -0.8 });
  light->PositionalOn();
  light->SetConeAngle(180);
  ExpectNear(scene.Only().Position, ToLocal({ 30, 0, 40 }));
}

TEST(SceneLights, CameraLightKeepsItsPlaceInTheCamerasFrame)
{
  LitScene scene;
  // Camera lights see the camera at (0, 0, 1), its focal point at the origin and up as y.
  vtkLight* light = scene.Add({ 0, 1, 0 }, { 0, 0, 0 });
  light->SetLightTypeToCameraLight();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(50, 0, 0);
  camera->SetViewUp(0, 0, 1);
  ExpectNear(scene.Only().Direction, { 0, 0, -1 });
  light->SetPosition(1, 0, 0); // right of a camera that looks along -x, with z up: +y
  ExpectNear(scene.Only().Direction, { 0, -1, 0 });
  light->PositionalOn();
  light->SetConeAngle(180);
  ExpectNear(scene.Only().Position, ToLocal({ 0, 50, 0 }));
  camera->SetViewUp(0, 1, 0);
  ExpectNear(scene.Only().Position, ToLocal({ 0, 0, -50 }));
}

TEST(SceneLights, MatchWhereVTKPutsThemWhenItRenders)
{
  LitScene scene;
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(3, -20, 11);
  camera->SetFocalPoint(1, 2, 3);
  camera->SetViewUp(0.2, 0.1, 1);
  for (int type :
    { VTK_LIGHT_TYPE_HEADLIGHT, VTK_LIGHT_TYPE_CAMERA_LIGHT, VTK_LIGHT_TYPE_SCENE_LIGHT })
  {
    scene.Renderer->RemoveAllLights();
    vtkLight* light = scene.Add({ 0.5, 2, 1 }, { 0.1, 0.2, 0.3 });
    light->SetLightType(type);
    light->PositionalOn();
    light->SetConeAngle(40);
    const vtkMediumScene::Light before = scene.Read(light);
    scene.Renderer->UpdateLightsGeometryToFollowCamera();
    glm::dvec3 position, focus;
    light->GetTransformedPosition(&position[0]);
    light->GetTransformedFocalPoint(&focus[0]);
    ExpectNear(before.Position, ToLocal(position));
    ExpectNear(before.Direction, glm::normalize(focus - position));
    ExpectNear(scene.Read(light).Position, before.Position);
  }
}

TEST(SceneLights, OnlyLightsThatShineAreGathered)
{
  LitScene scene;
  scene.Add({ 1, 0, 0 }, { 0, 0, 0 })->SwitchOff();
  scene.Add({ 1, 0, 0 }, { 0, 0, 0 })->SetIntensity(0);
  scene.Add({ 1, 0, 0 }, { 0, 0, 0 })->SetColor(0, 0, 0);
  vtkLight* ambient = scene.Add({ 1, 0, 0 }, { 0, 0, 0 });
  ambient->SetDiffuseColor(0, 0, 0);
  ambient->SetAmbientColor(1, 1, 1);
  ambient->SetSpecularColor(1, 1, 1);
  scene.Renderer->SetAmbient(1, 1, 1);
  ASSERT_EQ(scene.Scene.GatherLights(scene.Renderer), "");
  EXPECT_TRUE(scene.Scene.Lights.empty());
  for (int i = 0; i < 64; ++i)
  {
    scene.Add({ 1.0, double(i), 0 }, { 0, 0, 0 });
  }
  ASSERT_EQ(scene.Scene.GatherLights(scene.Renderer), "");
  EXPECT_EQ(scene.Scene.Lights.size(), 64u);
}

TEST(SceneLights, WithoutALightThatIsOnTheRenderersHeadlightCounts)
{
  LitScene scene;
  scene.Add({ 1, 0, 0 }, { 0, 0, 0 })->SwitchOff();
  scene.Renderer->AutomaticLightCreationOn();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0, -8, 0);
  camera->SetFocalPoint(0, 0, 0);
  ExpectNear(scene.Only().Direction, { 0, 1, 0 });
  ExpectNear(scene.Only().Irradiance, glm::dvec3(1));
}

TEST(SceneLights, BadLightsAreRefusedByName)
{
  const double infinite = std::numeric_limits<double>::infinity();
  struct
  {
    std::function<void(vtkLight*)> Break;
    const char* Word;
  } const table[] = {
    { [](vtkLight* l) { l->SetPosition(0, 0, 0); }, "need" },
    { [](vtkLight* l) { l->SetIntensity(-2); }, "-8" },
    { [](vtkLight* l) { l->SetIntensity(std::nan("")); }, "nan" },
    { [](vtkLight* l) { l->SetIntensity(1e300); }, "beyond a float" },
    { [=](vtkLight* l) { l->SetPosition(infinite, 0, 0); }, "inf" },
    { [](vtkLight* l) {
       l->PositionalOn();
       l->SetAttenuationValues(0, 0, 0);
     },
      "attenuation" },
    { [](vtkLight* l) {
       l->PositionalOn();
       l->SetAttenuationValues(1, -1, 0);
     },
      "-1" },
  };
  for (const auto& row : table)
  {
    LitScene scene;
    scene.Add({ 2, 0, 0 }, { 0, 0, 0 });
    vtkLight* light = scene.Add({ 1, 0, 0 }, { 0, 0, 0 });
    light->SetColor(4, 4, 4);
    row.Break(light);
    const std::string problem = scene.Scene.GatherLights(scene.Renderer);
    EXPECT_NE(problem.find(row.Word), std::string::npos) << row.Word << " not in: " << problem;
    EXPECT_TRUE(scene.Scene.Lights.empty());
    scene.Renderer->RemoveLight(light);
    EXPECT_EQ(scene.Scene.GatherLights(scene.Renderer), "");
    EXPECT_EQ(scene.Scene.Lights.size(), 1u);
  }
}

// Random bytes found directions of NaN here.
TEST(SceneLights, PlacesWhoseSquareIsBeyondADoubleHaveADirection)
{
  for (double far : { 1e-300, 1e200, 1e308 })
  {
    LitScene scene;
    scene.Add({ 0, 0.3 * far, 0 }, { -far, -far, 0 });
    const glm::dvec3 way = scene.Only().Direction;
    ExpectNear(way, glm::normalize(glm::dvec3(-1, -1.3, 0)));
  }
}
