// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumSignature.h"

#include <cstdint>

//------------------------------------------------------------------------------
void vtkMediumSignature::Add(const vtkMediumSignature& other)
{
  this->Values.insert(this->Values.end(), other.Values.begin(), other.Values.end());
}

//------------------------------------------------------------------------------
void vtkMediumSignature::Add(const glm::dvec3& value)
{
  this->Values.insert(this->Values.end(), { value.x, value.y, value.z });
}

//------------------------------------------------------------------------------
void vtkMediumSignature::Add(
  const vtkMediumScene::Coefficient& coefficient, const vtkMediumScene::Medium& content)
{
  this->Add(coefficient.Source);
  this->Add(coefficient.Component);
  this->Add(coefficient.Scale);
  if (coefficient.IsConstant())
  {
    return;
  }
  this->Add(content.Fields[coefficient.FieldIndex]);
  if (coefficient.Source == vtkMediumScene::Coefficient::Field)
  {
    return;
  }
  const vtkMediumFunction& function = content.Functions[coefficient.FunctionIndex];
  this->Add(function.GetMinimum());
  this->Add(function.GetMaximum());
  for (const glm::dvec4& sample : function.GetSamples())
  {
    if (coefficient.Source == vtkMediumScene::Coefficient::FunctionAlpha)
    {
      this->Add(sample.w);
    }
    else
    {
      this->Add(glm::dvec3(sample));
    }
  }
}

//------------------------------------------------------------------------------
void vtkMediumSignature::Add(const vtkMediumField& field)
{
  // An address has at most 48 bits in use, which a double holds exactly.
  this->Add(static_cast<double>(reinterpret_cast<std::uintptr_t>(field.Array.Get())));
  this->Add(static_cast<double>(field.Time));
  this->Add(field.OnCells);
  this->Add(field.Linear);
  this->Add(field.FirstComponent);
  this->Add(field.Components);
}

//------------------------------------------------------------------------------
void vtkMediumSignature::Add(const vtkMediumScene::Light& light)
{
  this->Add(light.Type);
  this->Add(light.Position);
  this->Add(light.Direction);
  this->Add(light.Irradiance);
  this->Add(light.Attenuation);
  this->Add(light.CosCone);
  this->Add(light.Exponent);
}

//------------------------------------------------------------------------------
void vtkMediumSignature::Add(const vtkMediumCut& cut)
{
  const auto add = [this](const vtkMediumCut::Plane& plane) {
    this->Add(plane.Normal);
    this->Add(plane.Offset);
  };
  for (const vtkMediumCut::Plane& plane : cut.Planes)
  {
    add(plane);
  }
  this->Add(cut.Regions);
  for (int axis = 0; axis < 3 && cut.CutsRegions(); ++axis)
  {
    add(cut.Lower[axis]);
    add(cut.Upper[axis]);
  }
}

//------------------------------------------------------------------------------
vtkMediumSignature vtkMediumSignature::OfExtinction(const vtkMediumScene& scene)
{
  vtkMediumSignature signature;
  const vtkMediumScene::Medium& content = scene.Content;
  for (int column = 0; column < 3; ++column)
  {
    signature.Add(scene.Geometry.BoxToLocalAxes[column]);
  }
  signature.Add(scene.Geometry.Length);
  signature.Add(content.Extinction, content);
  signature.Add(content.ExtinctionIsAbsorption);
  if (content.ExtinctionIsAbsorption)
  {
    signature.Add(content.Scattering, content);
    signature.Add(content.ScatteringIsAlbedo);
  }
  return signature;
}

//------------------------------------------------------------------------------
vtkMediumSignature vtkMediumSignature::OfCut(const vtkMediumScene& scene)
{
  vtkMediumSignature signature;
  signature.Add(scene.Cut);
  return signature;
}

//------------------------------------------------------------------------------
vtkMediumSignature vtkMediumSignature::OfCasters(const vtkMediumScene& scene)
{
  vtkMediumSignature signature;
  for (const vtkMediumScene::Caster& caster : scene.Casters)
  {
    signature.Add(static_cast<double>(reinterpret_cast<std::uintptr_t>(caster.Prop)));
    signature.Add(static_cast<double>(caster.Time));
  }
  return signature;
}

//------------------------------------------------------------------------------
vtkMediumSignature vtkMediumSignature::OfOccupancy(const vtkMediumScene& scene)
{
  vtkMediumSignature signature = OfExtinction(scene);
  signature.Add(scene.Content.Emission, scene.Content);
  return signature;
}

//------------------------------------------------------------------------------
vtkMediumSignature vtkMediumSignature::OfContentAndLights(const vtkMediumScene& scene)
{
  vtkMediumSignature signature = OfOccupancy(scene);
  const vtkMediumScene::Medium& content = scene.Content;
  signature.Add(content.Scattering, content);
  signature.Add(content.ScatteringIsAlbedo);
  signature.Add(content.DensityScale);
  for (int mask : content.Masks)
  {
    signature.Add(content.Fields[mask]);
  }
  for (double value : content.UserCode)
  {
    signature.Add(value);
  }
  signature.Add(content.Phase);
  signature.Add(content.Anisotropy, content);
  signature.Add(content.BackAnisotropy);
  signature.Add(content.ForwardWeight);
  signature.Add(content.DraineAlpha);
  for (double value : content.PhaseTable)
  {
    signature.Add(value);
  }
  for (const vtkMediumScene::Light& light : scene.Lights)
  {
    signature.Add(light);
  }
  signature.Add(scene.Cut);
  signature.Add(OfCasters(scene));
  return signature;
}

//------------------------------------------------------------------------------
vtkMediumSignature vtkMediumSignature::OfFrame(
  const vtkMediumScene& scene, const vtkMediumPlan::Settings& settings)
{
  vtkMediumSignature signature = OfContentAndLights(scene);
  signature.Add(scene.Scalars);
  for (int column = 0; column < 4; ++column)
  {
    signature.Add(glm::dvec3(scene.Eye.LocalToClip[column]));
    signature.Add(scene.Eye.LocalToClip[column].w);
  }
  for (double value :
    { double(settings.Integrator), double(settings.Output), settings.SampleDistance,
      settings.LightSampleDistance, double(settings.BinarySearchIterations), settings.Jitter,
      settings.TransmittanceThreshold, settings.PaperThreshold, double(settings.AssumeConvex),
      double(settings.CountTaps), double(settings.DepthDefinition), settings.DepthTransmittance,
      settings.MaximumError, double(settings.LightMethod), settings.LightTolerance,
      settings.PixelTolerance, double(settings.OnlyRough), double(settings.StretchSteps),
      double(settings.Hurried), settings.ControlledLightStep, settings.ControlledStep,
      double(settings.LightCacheBytes), double(settings.OpaqueShadowResolution) })
  {
    signature.Add(value);
  }
  return signature;
}
