// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CutScene.h
 * @brief The scene of ReferenceScene with clipping planes and cropping.
 */
#ifndef CutScene_h
#define CutScene_h

#include "ReferenceScene.h"

#include "vtkPlane.h"

#include <ostream>

namespace vtkMediumTest
{
inline vtkSmartPointer<vtkPlane> AddPlane(
  Scene& scene, const glm::dvec3& normal, const glm::dvec3& origin)
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetNormal(normal.x, normal.y, normal.z);
  plane->SetOrigin(origin.x, origin.y, origin.z);
  scene.Mapper->AddClippingPlane(plane);
  return plane;
}

/// Crops to the regions around the middle of a box of ReferenceSize.
inline void Crop(Scene& scene, int regions)
{
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(-0.2, 0.15, -0.1, 0.17, -0.33, 0.21);
  scene.Mapper->SetCroppingRegionFlags(regions);
}

/// How a scene is cut.
struct Cut
{
  const char* Name; ///< of letters
  void (*Apply)(Scene& scene);
};

inline void PrintTo(const Cut& cut, std::ostream* os)
{
  *os << cut.Name;
}

/// Between them: half-spaces alone, regions alone, and both.
inline const std::vector<Cut>& Cuts()
{
  static const std::vector<Cut> cuts = {
    { "Plane",
      [](Scene& scene) {
        AddPlane(scene, { -1, 0.8, 0.3 }, { 0.05, 0, 0 });
      } },
    { "ThreePlanes",
      [](Scene& scene) {
        AddPlane(scene, { 1, 0.1, -0.3 }, { -0.3, 0, 0 });
        AddPlane(scene, { 0.2, -1, 0.4 }, { 0, 0.2, 0 });
        AddPlane(scene, { -0.5, -0.2, -1 }, { 0, 0, 0.4 });
      } },
    { "SubVolume", [](Scene& scene) { Crop(scene, VTK_CROP_SUBVOLUME); } },
    { "Fence", [](Scene& scene) { Crop(scene, VTK_CROP_FENCE); } },
    { "InvertedFence", [](Scene& scene) { Crop(scene, VTK_CROP_INVERTED_FENCE); } },
    { "Cross", [](Scene& scene) { Crop(scene, VTK_CROP_CROSS); } },
    { "InvertedCrossAndPlane",
      [](Scene& scene) {
        Crop(scene, VTK_CROP_INVERTED_CROSS);
        AddPlane(scene, { -0.6, 0.5, 1 }, { 0, 0, -0.2 });
      } },
  };
  return cuts;
}
}

#endif
