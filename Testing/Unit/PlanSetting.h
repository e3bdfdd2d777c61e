// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PlanSetting.h
 * @brief A scene to plan for, and what a plan has chosen.
 */
#ifndef PlanSetting_h
#define PlanSetting_h

#include "vtkMediumPlan.h"
#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkFloatArray.h"

#include <gtest/gtest.h>

namespace vtkMediumTest
{
using Mapper = vtkSingleScatteringVolumeMapper;
using Coefficient = vtkMediumScene::Coefficient;
using Settings = vtkMediumPlan::Settings;
using Device = vtkMediumPlan::Capabilities;

/// A cube of 100^3 points whose extinction is one linear array, under one directional light.
inline vtkMediumScene MakeScene()
{
  vtkMediumScene scene;
  vtkMediumField field;
  field.Array = vtkSmartPointer<vtkFloatArray>::New();
  field.Dimensions = { 100, 100, 100 };
  field.Maximum = 1;
  scene.Scalars = field;
  scene.Content.Fields.push_back(field);
  scene.Content.Extinction = { Coefficient::Field, 0, -1, -1, glm::dvec3(2) };
  scene.Content.Scattering.Scale = glm::dvec3(1);
  scene.Geometry.Length = 10;
  scene.Geometry.VoxelLength = 0.1;
  scene.Lights.resize(1);
  scene.Lights[0].Irradiance = glm::dvec3(1);
  return scene;
}

inline Settings With(int integrator)
{
  Settings settings;
  settings.Integrator = integrator;
  return settings;
}

inline bool Has(const vtkMediumPlan& plan, const std::string& define)
{
  return plan.ShaderDefines.find("#define " + define) != std::string::npos;
}

inline bool Reads(const vtkMediumPlan& plan, const std::string& file)
{
  for (const std::string& name : plan.ShaderFiles)
  {
    if (name == file)
    {
      return true;
    }
  }
  return false;
}
}

#endif
