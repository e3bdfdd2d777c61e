// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What ErrorControlled asks of a scene: bricks, steps that were found, and light caches where they serve.
#include "vtkMediumPlan.h"

#include "vtkSingleScatteringVolumeMapper.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void vtkMediumPlan::PlanErrorControlled(const vtkMediumScene& scene, const Settings& settings)
{
  this->UseBricks = true;
  this->UseTiles = !scene.Content.Altered; // else bricks do not know where there is nothing
  const double voxel = scene.Geometry.VoxelLength / scene.Geometry.Length;
  this->EyeStep =
    std::max(settings.ControlledStep > 0 ? settings.ControlledStep : voxel, ShortestStep);
  // Optical depths and the last point of the medium are not seen through what is before them.
  const bool seenThrough = settings.Output != vtkSingleScatteringVolumeMapper::OpticalDepth &&
    settings.Output != vtkSingleScatteringVolumeMapper::Distance;
  this->EyeStretch = settings.StretchSteps && seenThrough ? ErrorStretch : 0;
  this->LeapEyeSteps = this->EyeStep <= LongestLeaptStep * voxel;
  this->LightStep = settings.ControlledLightStep > 0
    ? std::max(settings.ControlledLightStep, ShortestStep)
    : this->EyeStep;

  // A cache holds one grey optical depth for each lattice point, looked up trilinearly. That of the
  // whole volume is right under a cut where no light ray passes through what is cut away.
  vtkTypeInt64 voxels = 0;
  bool linear = !this->Fields.empty();
  for (const vtkMediumField& field : this->Fields)
  {
    linear = linear && field.Linear;
    const glm::ivec3& size = field.Dimensions;
    voxels = std::max(voxels, static_cast<vtkTypeInt64>(size.x) * size.y * size.z);
  }
  const int lights = static_cast<int>(scene.Lights.size());
  const bool rough = settings.LightMethod == MarchThenLookUp;
  const int channels = lights * ChannelsPerLight(rough); // of two bytes a voxel
  const vtkTypeInt64 bytes = 2 * voxels * channels;
  if (settings.LightMethod != March && this->Lit && linear && !scene.Content.ChromaticExtinction &&
    channels <= MostCacheTextures * CacheChannels && bytes <= settings.LightCacheBytes)
  {
    this->CachedLights = lights;
    this->QuickCaches = settings.Hurried;
    this->CacheRoughness = rough;
    this->OnlyRough = rough && settings.OnlyRough;
    this->PixelTolerance = settings.PixelTolerance;
    this->CutCaches = CutsLightRays(scene);
    this->LightTolerance = settings.LightTolerance;
    const double every = LookUpSpacing * voxel / (LightTapsPerIteration * this->LightStep);
    this->LightLookUpEvery = std::max(1, static_cast<int>(std::lround(every)));
  }
}
