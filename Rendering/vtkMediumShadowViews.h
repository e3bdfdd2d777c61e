// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumShadowViews
 * @brief From where, and how wide, a light looks at the volume, so that its depth can be drawn.
 *
 * A directional light has one parallel view that the volume fills. A positional one has one view that the
 * volume, or the light's cone, fills; if the light is inside of the volume or so near that the view would be
 * too wide, one on each face of a cube around the light that the volume is seen through. No OpenGL in it.
 */
#ifndef vtkMediumShadowViews_h
#define vtkMediumShadowViews_h

#include "vtkMediumScene.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumShadowViews
{
public:
  struct View
  {
    glm::dvec3 Eye{ 0 };            ///< local
    glm::dvec3 Forward{ 0, 0, -1 }; ///< local, unit
    glm::dvec3 Up{ 0, 1, 0 };       ///< local, unit, normal to Forward
    bool Parallel = false;
    glm::dmat4 Projection{
      1
    }; ///< to OpenGL's clip space, from local units along right, up, backward

    glm::dmat4 LocalToClip() const;
  };

  /// The cube's faces, by the axis of local space that points through them: +x, -x, +y, -y, +z, -z.
  static constexpr int Faces = 6;
  /// Nothing that is nearer to a light inside of the volume casts a shadow, local units.
  static constexpr double NearestDepth = 1e-3;

  /// The views of a light, whose pictures have so many pixels along an edge; one pixel of each edge is left
  /// free, so that interpolation between pixels keeps to the picture.
  vtkMediumShadowViews(
    const vtkMediumScene::Light& light, const vtkMediumScene::Box& box, int pixels);

  std::vector<View> Views;
  /// The view that looks through each face, -1 where there is no medium to be seen; the same for all
  /// where there is one view.
  std::array<int, Faces> OfFace;

private:
  void AddParallel(const glm::dvec3& direction);
  bool AddFitted(const vtkMediumScene::Light& light);
  void AddCone(const vtkMediumScene::Light& light, double tangent);
  void AddCube(const glm::dvec3& position);
  /// The corners of the volume as a view sees them: along right, up, forward.
  std::array<glm::dvec3, 8> Corners(const View& view) const;
  void Project(View& view, const glm::dvec2& lower, const glm::dvec2& upper, double nearest,
    double farthest) const;

  std::array<glm::dvec3, 8> LocalCorners;
  double Inner; ///< part of a picture's edge inside of the pixels that are left free
};

#endif
