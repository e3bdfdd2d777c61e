// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Homogeneous boxes in directional light, which ErrorControlled and Exact do not march: against the
// reference, against FixedStep, which does, and by what it costs.
#include "ReferenceScene.h"

using namespace vtkMediumTest;

namespace
{
constexpr double Rounding = 5e-6; // of the peak: float's, in exponents of at most 20

/// A box of three different edges with RGB extinction, emission and five lights, two of them along axes.
struct HomogeneousScene : ReferenceScene
{
  HomogeneousScene()
    : ReferenceScene(vtkMediumFixtures::Smooth)
  {
    this->Medium->SetExtinctionArrayName(nullptr);
    this->Medium->SetExtinction(2, 6, 15);
    this->Medium->SetEmission(0.02, 0, 0.01);
    this->Renderer->RemoveAllLights();
    this->AddBeam({ 1, -0.8, -0.2 });
    this->AddBeam({ -0.3, 0.1, 0.9 });
    this->AddBeam({ 0, 0, -1 });
    this->AddBeam({ -1, 0, 0 });
    vtkSmartPointer<vtkLight> coloured = this->AddBeam({ 0.2, 1, -0.5 });
    coloured->SetDiffuseColor(0.2, 1, 0.5);
    this->Mapper->SetIntegratorToErrorControlled();
    this->Mapper->GetStatistics()->CountTapsOn();
  }

  void ExpectTruth()
  {
    this->FindTruth();
    ASSERT_GT(this->Peak, 0.01);
    const Errors errors = this->Measure();
    EXPECT_LT(errors.Largest, Rounding);
    EXPECT_LT(errors.Alpha, Rounding);
    vtkMediumStatistics* done = this->Mapper->GetStatistics();
    EXPECT_EQ(done->GetLightMethod(), vtkMediumStatistics::LightInClosedForm);
  }
};
}

TEST(HomogeneousBox, IsItsTruthFromOutside)
{
  HomogeneousScene scene;
  scene.ExpectTruth();
}

TEST(HomogeneousBox, IsItsTruthFromInside)
{
  HomogeneousScene scene;
  scene.Camera->SetPosition(0.1, 0.2, 0.3);
  scene.Camera->SetFocalPoint(-0.2, 0.1, -1);
  scene.Renderer->ResetCameraClippingRange();
  scene.ExpectTruth();
}

TEST(HomogeneousBox, IsItsTruthWhenTurnedAndSheared)
{
  HomogeneousScene scene;
  scene.Volume->RotateWXYZ(40, 1, 2, 3);
  scene.Volume->SetScale(1, 0.5, 0.8);
  scene.ExpectTruth();
}

TEST(HomogeneousBox, TakesNoStepNoTapAndNoCalibration)
{
  HomogeneousScene scene;
  scene.Render();
  vtkMediumStatistics* done = scene.Mapper->GetStatistics();
  EXPECT_EQ(done->GetTaps(), 0);
  EXPECT_GT(done->GetRays(), 0);
  EXPECT_EQ(done->GetPasses(), 1);
  EXPECT_EQ(done->GetCalibrations(), 0);
  EXPECT_EQ(done->GetBrickBuilds(), 0);
  EXPECT_EQ(done->GetTextureUploads(), 0);
  EXPECT_EQ(scene.Mapper->GetEstimatedError(), 0);
}

// The plain way, whose error falls with the square of the step to where both agree.
TEST(HomogeneousBox, IsWhatStepsConvergeTo)
{
  HomogeneousScene scene;
  const Picture formula = scene.Render();
  scene.Mapper->SetIntegratorToFixedStep();
  double before = 0;
  for (double step : { 0.02, 0.005, 0.00125 })
  {
    scene.SetSteps(step, step);
    const Picture marched = scene.Render();
    EXPECT_EQ(scene.Mapper->GetStatistics()->GetLightMethod(), vtkMediumStatistics::LightMarched);
    double largest = 0;
    for (std::size_t i = 0; i < formula.Values.size(); ++i)
    {
      largest = std::max(largest, double(std::abs(formula.Values[i] - marched.Values[i])));
    }
    EXPECT_TRUE(before == 0 || largest < before / 4) << "step " << step; // kinks: less than order 2
    before = largest;
  }
  EXPECT_LT(before, 2e-4);
}
