// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumBricks
 * @brief Where the medium is: the range of extinction in each brick of 8x8x8 lattice cells.
 *
 * A brick's range covers all that interpolation inside of it can give: the lattice values 8b to 8b + 8
 * of each axis, both included, and the extinction function between any two of them. The ranges of the
 * scalars are kept while the fields stay the same, so that a new extinction function is a pass over
 * bricks and not over voxels. Extinction is per local unit for a DensityScale of 1, as in
 * vtkMediumExtinctionGrid, whose lattice the bricks divide; bricks at the border of a cell array's
 * lattice reach on to the box's faces.
 */
#ifndef vtkMediumBricks_h
#define vtkMediumBricks_h

#include "vtkMediumCoefficientBounds.h"
#include "vtkMediumExtinctionGrid.h"
#include "vtkMediumScene.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumBricks
{
public:
  /// Lattice cells along each edge of a brick.
  static constexpr int Edge = 8;

  enum Classes : unsigned char
  {
    Empty,   ///< neither extinction nor emission
    Uniform, ///< extinction > 0, or emission, the same at all its points
    Mixed,
  };

  /// What eye rays through a square of pixels can meet.
  struct Tiles
  {
    glm::ivec2 Count{ 0 }; ///< tiles along x and y; the first is at the viewport's lower left
    int Edge = 8;          ///< pixels along the edge of a tile
    std::vector<glm::vec2> Ranges; ///< first and last t along the eye rays; first > last: nothing
    glm::ivec4 Scissor{ 0 };       ///< x, y, width, height in pixels; width 0: nothing in view
    std::size_t CutAway = 0;       ///< bricks that are not empty but cut away
  };

  /// Divides the lattice of `grid`, which is of the same scene, and classifies all bricks.
  void Build(const vtkMediumScene& scene, const vtkMediumExtinctionGrid& grid);

  const glm::ivec3& GetCount() const { return this->Count; }
  std::size_t GetIndex(const glm::ivec3& brick) const
  {
    return brick.x + this->Count.x * (brick.y + static_cast<std::size_t>(this->Count.y) * brick.z);
  }
  Classes GetClass(const glm::ivec3& brick) const { return this->Class[this->GetIndex(brick)]; }
  /// Least and largest extinction, per local unit.
  const glm::vec2& GetRange(const glm::ivec3& brick) const
  {
    return this->Ranges[this->GetIndex(brick)];
  }
  /// Bricks of a class.
  std::size_t GetNumberOf(Classes which) const { return this->Numbers[which]; }

  ///@{
  /// A brick's corners in lattice coordinates.
  glm::dvec3 GetLower(const glm::ivec3& brick) const;
  glm::dvec3 GetUpper(const glm::ivec3& brick) const;
  ///@}

  /// How often voxels were read, since creation: once for each change of a field.
  int GetNumberOfReads() const { return this->Reads; }

  /// Projects the bricks that are neither empty nor cut away to tiles of a viewport of width x height pixels. For every
  /// eye ray through a pixel (anywhere in it) the part inside such a brick is within the tile's range,
  /// which runs along vtkMediumScene::View's t in local units. Ranges start at 0 in perspective.
  Tiles ProjectToTiles(const vtkMediumScene& scene, int width, int height, int edge = 8) const;

private:
  /// The scalars of one coefficient.
  struct ScalarRanges
  {
    const void* Array = nullptr; ///< with MTime and the rest: what the ranges are of
    unsigned long long MTime = 0;
    int FirstComponent = 0, LastComponent = 0;
    std::vector<glm::dvec2> Ranges; ///< by brick; one for all where the field is on another lattice
  };

  void ReadRanges(ScalarRanges& ranges, const vtkMediumField& field, bool sameLattice) const;
  void Classify(const vtkMediumScene& scene);

  glm::ivec3 Count{ 0 };
  glm::ivec3 Dimensions{ 0 };
  bool OnCells = false;
  bool Linear = true;
  glm::dmat3 LatticeToLocalAxes{ 1 };
  glm::dvec3 LatticeToLocalOrigin{ 0 };
  vtkMediumCoefficientBounds Bounds[3]; ///< extinction, scattering, emission
  ScalarRanges Scalars[3];
  std::vector<glm::vec2> Ranges;
  std::vector<Classes> Class;
  std::size_t Numbers[3] = { 0, 0, 0 };
  int Reads = 0;
};

#endif
