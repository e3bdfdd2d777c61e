// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What a change has to be computed anew for, by the counters: a row for each kind of change, as
// Module/Documentation/variants.md lists them.
#include "CutScene.h"

#include "vtkColorTransferFunction.h"
#include "vtkLightCollection.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"

using namespace vtkMediumTest;

namespace
{
/// Counts since creation, or what one frame added to them.
struct Work
{
  vtkTypeInt64 Uploads = 0;
  vtkTypeInt64 Bricks = 0;
  vtkTypeInt64 Caches = 0;
  vtkTypeInt64 CacheUploads = 0;
  vtkTypeInt64 Calibrations = 0;
  vtkTypeInt64 Reused = 0;

  bool operator==(const Work& other) const
  {
    return this->Uploads == other.Uploads && this->Bricks == other.Bricks &&
      this->Caches == other.Caches && this->CacheUploads == other.CacheUploads &&
      this->Calibrations == other.Calibrations && this->Reused == other.Reused;
  }
};

void PrintTo(const Work& work, std::ostream* os)
{
  *os << "uploads " << work.Uploads << ", bricks " << work.Bricks << ", caches " << work.Caches
      << ", cache uploads " << work.CacheUploads << ", calibrations " << work.Calibrations
      << ", reused " << work.Reused;
}

constexpr int Lights = 3;
constexpr int CacheTextures = 1;

/// A cloud under three lights, mapped by two functions as a vtkVolumeProperty has them. All light comes from
/// caches.
struct FunctionScene : ReferenceScene
{
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> Colour;

  FunctionScene()
    : ReferenceScene(vtkMediumFixtures::Cloud)
  {
    this->Mapper->SetIntegratorToErrorControlled();
    this->Mapper->SetLightCachesToAlways();
    this->Mapper->SetMaximumError(4.0 / 255);
    this->Opacity->AddPoint(0, 0);
    this->Opacity->AddPoint(1, 0.9);
    this->Colour->AddRGBPoint(0, 1, 0.5, 0.2);
    this->Colour->AddRGBPoint(1, 0.3, 0.6, 1);
    this->UseProperty();
  }

  void UseProperty()
  {
    this->Mapper->SetMedium(nullptr);
    this->Property->SetScalarOpacity(this->Opacity);
    this->Property->SetColor(this->Colour);
    this->Property->SetScalarOpacityUnitDistance(0.4);
  }

  void UseMedium()
  {
    this->Medium->SetExtinctionScale(6);
    this->Mapper->SetMedium(this->Medium);
  }

  Work Count()
  {
    vtkMediumStatistics* done = this->Mapper->GetStatistics();
    return { done->GetTextureUploads(), done->GetBrickBuilds(), done->GetLightCacheBuilds(),
      done->GetLightCacheUploads(), done->GetCalibrations(), done->GetFramesReused() };
  }

  Work RenderAndCount()
  {
    const Work before = this->Count();
    this->Render();
    const Work after = this->Count();
    return { after.Uploads - before.Uploads, after.Bricks - before.Bricks,
      after.Caches - before.Caches, after.CacheUploads - before.CacheUploads,
      after.Calibrations - before.Calibrations, after.Reused - before.Reused };
  }

  vtkLight* GetLight(int number)
  {
    return vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(number));
  }

  vtkDataArray* GetScalars() { return this->Mapper->GetInput()->GetPointData()->GetScalars(); }
};

struct Row
{
  const char* Change;
  bool OfMedium; ///< else of the volume's property
  void (*Apply)(FunctionScene&);
  Work Expected;
};

void PrintTo(const Row& row, std::ostream* os)
{
  *os << row.Change;
}

const Row Rows[] = {
  { "Nothing", false, [](FunctionScene&) {}, { 0, 0, 0, 0, 0, 1 } },
  { "CameraABit", false, [](FunctionScene& s) { s.Camera->Azimuth(2); }, {} },
  { "CameraFar", false, [](FunctionScene& s) { s.Camera->Azimuth(60); }, { 0, 0, 0, 0, 1 } },
  { "LightColour", false, [](FunctionScene& s) { s.GetLight(0)->SetDiffuseColor(0.2, 0.4, 0.9); },
    { 0, 0, 0, 0, 1 } },
  { "LightIntensity", false, [](FunctionScene& s) { s.GetLight(1)->SetIntensity(3); },
    { 0, 0, 0, 0, 1 } },
  { "LightPose", false, [](FunctionScene& s) { s.GetLight(0)->SetPosition(-2, 2, 2); },
    { 0, 0, 1, CacheTextures, 1 } },
  { "LightOff", false, [](FunctionScene& s) { s.GetLight(2)->SwitchOff(); },
    { 0, 0, 0, CacheTextures, 1 } },
  { "LightOutOfReach", false, [](FunctionScene& s) { s.GetLight(2)->SetFocalPoint(0, -9, 0); },
    { 0, 0, 0, CacheTextures, 1 } },
  { "ColourFunction", false, [](FunctionScene& s) { s.Colour->AddRGBPoint(0.5, 0.9, 0.1, 0.4); },
    { 1, 0, 0, 0, 1 } },
  { "OpacityFunction", false, [](FunctionScene& s) { s.Opacity->AddPoint(0.5, 0.2); },
    { 1, 1, Lights, CacheTextures, 1 } },
  { "Anisotropy", false, [](FunctionScene& s) { s.Mapper->SetAnisotropy(-0.3); },
    { 0, 0, 0, 0, 1 } },
  { "AlbedoOfAMedium", true, [](FunctionScene& s) { s.Medium->SetAlbedo(0.5); },
    { 0, 0, 0, 0, 1 } },
  { "AnisotropyOfAMedium", true, [](FunctionScene& s) { s.Medium->SetAnisotropy(-0.3); },
    { 0, 0, 0, 0, 1 } },
  { "PhaseFunction", true, [](FunctionScene& s) { s.Medium->SetPhaseFunctionToRayleigh(); },
    { 0, 0, 0, 0, 1 } },
  { "DensityScale", true, [](FunctionScene& s) { s.Medium->SetDensityScale(0.5); },
    { 0, 0, 0, CacheTextures, 1 } },
  { "ExtinctionScale", true, [](FunctionScene& s) { s.Medium->SetExtinctionScale(3); },
    { 0, 1, Lights, CacheTextures, 1 } },
  { "Data", false,
    [](FunctionScene& s) {
      s.GetScalars()->SetTuple1(12345, 0.7);
      s.GetScalars()->Modified();
    },
    { 1, 1, Lights, CacheTextures, 1 } },
  { "ClippingPlaneBesideAllLightRays", false,
    [](FunctionScene& s) {
      AddPlane(s, { 0, 0, 1 }, { 0, 0, -0.9 }); // leaves everything
    },
    { 0, 0, 0, 0, 0, 1 } },
  { "Cropping", false, [](FunctionScene& s) { Crop(s, VTK_CROP_SUBVOLUME); },
    { 0, 0, Lights, CacheTextures, 1 } },
  { "Output", false, [](FunctionScene& s) { s.Mapper->SetOutputToSampleCount(); }, {} },
  { "OutputWithoutLight", false, [](FunctionScene& s) { s.Mapper->SetOutputToTransmittance(); },
    { 0, 0, 0, 0, 1 } },
  { "PixelsOfARay", false, [](FunctionScene& s) { s.Mapper->SetImageSampleDistance(2); }, {} },
};

struct RecomputingTest : testing::TestWithParam<Row>
{
};
}

TEST_P(RecomputingTest, DoesWhatTheChangeAsksForAndNoMore)
{
  FunctionScene scene;
  if (GetParam().OfMedium)
  {
    scene.UseMedium();
  }
  const Work first = scene.RenderAndCount();
  ASSERT_EQ(first.Caches, Lights);
  ASSERT_EQ(first.Bricks, 1);
  GetParam().Apply(scene);
  EXPECT_EQ(scene.RenderAndCount(), GetParam().Expected);
  EXPECT_EQ(scene.RenderAndCount(), (Work{ 0, 0, 0, 0, 0, 1 })) << "and once only";
  EXPECT_TRUE(scene.Scene::Errors.empty());
}

INSTANTIATE_TEST_SUITE_P(Of, RecomputingTest, testing::ValuesIn(Rows),
  [](const auto& parameters) { return std::string(parameters.param.Change); });
