// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumCut
 * @brief What is cut away of a volume: by clipping planes and by cropping.
 *
 * The medium is where every half-space of Planes and one of the kept Regions are; what is cut away holds
 * none, for eye rays and for light rays. All geometry is exact: along a ray it is a few intervals.
 *
 * Cropping divides the volume into 3 x 3 x 3 regions, numbered x + 3 y + 9 z as in vtkVolumeMapper. Where
 * the kept regions make a box, as the usual sub-volume does, that box is half-spaces and nothing else.
 */
#ifndef vtkMediumCut_h
#define vtkMediumCut_h

#include "vtkParticipatingMediumModule.h" // for the export macro

#include "vtkMediumCompatibility.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractVolumeMapper;
class vtkVolume;
VTK_ABI_NAMESPACE_END

class VTKPARTICIPATINGMEDIUM_EXPORT vtkMediumCut
{
public:
  /// A plane in the scene's local space.
  struct Plane
  {
    glm::dvec3 Normal{ 0, 0, 1 }; ///< unit
    double Offset = 0;

    /// The signed distance of a point, local units.
    double Distance(const glm::dvec3& local) const
    {
      return glm::dot(this->Normal, local) + this->Offset;
    }
  };

  /// The volume's box: local = Origin + Axes * box.
  struct Box
  {
    double Length;     ///< world units per local unit
    glm::dvec3 Center; ///< world position of the local origin
    glm::dmat3 Axes;
    glm::dvec3 Origin;
  };

  static constexpr int AllRegions = 0x7ffffff;

  /// A point is kept where its distance from each of them is >= 0. Planes that do not touch the volume are
  /// left out.
  std::vector<Plane> Planes;

  /// The kept regions, bit x + 3 y + 9 z of each; AllRegions: cropping is off, or is among the Planes.
  int Regions = AllRegions;
  Plane Lower[3]; ///< of cropping along each axis: region 0 is where the distance is < 0
  Plane Upper[3]; ///< region 2 is where the distance is >= 0

  bool CutsRegions() const { return this->Regions != AllRegions; }
  bool IsNone() const { return this->Planes.empty() && !this->CutsRegions(); }
  bool Keeps(const glm::dvec3& local) const;

  /// False where nothing of a parallelepiped with these corners can be kept; true where it may be.
  bool MayKeep(const glm::dvec3 corners[8]) const;

  /// Whether no light ray that begins in what is kept can leave it again on its way to a light: the way to a
  /// directional one, or the place of another, is on the kept side of every plane. Its optical depths are
  /// then those without the cut.
  bool HoldsWaysTo(const glm::dvec3& light, bool directional) const;

  /// Takes the clipping planes (world coordinates, kept where the normal points to) and the cropping (planes
  /// in the coordinates of the image, before the volume's matrix) of a mapper, which may be null. Returns an
  /// empty string, or what was wrong with them and how to mend it.
  std::string Gather(vtkAbstractVolumeMapper* mapper, vtkVolume* volume, const Box& box);

private:
  std::string GatherClipping(vtkAbstractVolumeMapper* mapper, const Box& box);
  std::string GatherCropping(vtkAbstractVolumeMapper* mapper, vtkVolume* volume, const Box& box);
  int FindDigit(int axis, const glm::dvec3& local) const;
  void AddUnlessBeside(const Plane& plane, const Box& box);
};

#endif
