// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Which scenes need no march.
#include "PlanSetting.h"

using namespace vtkMediumTest;

//------------------------------------------------------------------------------
TEST(Plan, MarchesNoHomogeneousBoxInDirectionalLight)
{
  vtkMediumScene scene = MakeScene();
  scene.Content.Fields.clear();
  scene.Content.Extinction = { Coefficient::Constant, -1, -1, -1, glm::dvec3(2) };
  scene.Lights.resize(3, scene.Lights[0]);
  for (int integrator : { Mapper::ErrorControlled, Mapper::Exact })
  {
    const vtkMediumPlan plan(scene, With(integrator), Device());
    EXPECT_TRUE(plan.ClosedForm);
    EXPECT_TRUE(Reads(plan, "ClosedForm"));
    EXPECT_FALSE(Reads(plan, "FixedStep") || Reads(plan, "Exact") || Reads(plan, "LightRay"));
    EXPECT_FALSE(plan.UseBricks) << "nor is a step looked for";
    ASSERT_EQ(plan.Passes.size(), 1u);
    EXPECT_EQ(plan.Passes[0].LastLight, 3);
  }
  EXPECT_FALSE(vtkMediumPlan(scene, With(Mapper::FixedStep), Device()).ClosedForm)
    << "steps that were asked for are taken";
  EXPECT_FALSE(vtkMediumPlan(MakeScene(), With(Mapper::Exact), Device()).ClosedForm) << "data";

  vtkMediumScene lamp = scene, clipped = scene, cropped = scene;
  lamp.Lights[1].Type = vtkMediumScene::Light::Point;
  clipped.Cut.Planes.emplace_back();
  cropped.Cut.Regions = 1;
  for (const vtkMediumScene& other : { lamp, clipped, cropped })
  {
    EXPECT_FALSE(vtkMediumPlan(other, With(Mapper::ErrorControlled), Device()).ClosedForm);
  }
  clipped.Lights.clear();
  EXPECT_TRUE(vtkMediumPlan(clipped, With(Mapper::ErrorControlled), Device()).ClosedForm)
    << "planes that cut no light ray are in the ends of eye rays";
  Settings mean = With(Mapper::Exact);
  mean.Output = Mapper::Depth;
  mean.DepthDefinition = Mapper::MeanScatteringDepth;
  EXPECT_FALSE(vtkMediumPlan(scene, mean, Device()).ClosedForm);
}
