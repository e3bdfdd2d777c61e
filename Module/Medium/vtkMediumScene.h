// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumScene
 * @brief The facts of a frame: everything it depends on, gathered once, in double.
 *
 * The mapper and vtkSingleScatteringReference both render from a scene and from nothing else. It
 * holds no OpenGL and no decisions; vtkMediumPlan makes those.
 *
 * @par Spaces
 * - world: VTK's world coordinates and units;
 * - local: parallel to world, origin at the centre of the volume, scaled so that the longest
 *   diagonal of the volume is 1. Angles and ratios of lengths are those of the world, whatever the
 *   spacing, the direction matrix and the volume's own matrix are, and float suffices;
 * - box: the unit cube that the image's bounds make, (0,0,0) at the first point, (1,1,1) at the
 *   last.
 */
#ifndef vtkMediumScene_h
#define vtkMediumScene_h

#include "vtkParticipatingMediumModule.h" // for the export macro

#include "vtkMediumCompatibility.h"
#include "vtkMediumCut.h"
#include "vtkMediumField.h"
#include "vtkMediumFunction.h"
#include "vtkMediumMask.h"
#include "vtkParticipatingMedium.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractVolumeMapper;
class vtkImageData;
class vtkLight;
class vtkMatrix4x4;
class vtkProp;
class vtkRenderer;
class vtkVolume;
VTK_ABI_NAMESPACE_END
class vtkParticipatingMedium;

class VTKPARTICIPATINGMEDIUM_EXPORT vtkMediumScene
{
public:
  /// Where the volume is.
  struct Box
  {
    double Length = 1;              ///< world units per local unit
    glm::dvec3 Center{ 0 };         ///< world position of the local origin
    glm::dmat3 BoxToLocalAxes{ 1 }; ///< columns: the box's edges in local space
    glm::dvec3 BoxToLocalOrigin{ 0 };
    glm::dmat3 LocalToBoxAxes{ 1 };
    glm::dvec3 LocalToBoxOrigin{ 0 };
    double VoxelLength = 0; ///< the shortest edge of a voxel, world units

    /// Further from the volume than so many of its diagonals is no place: squares of it are beyond a double.
    static constexpr double Farthest = 1e150;

    /// False also for what is not a number.
    static bool IsPlace(const glm::dvec3& local)
    {
      return std::abs(local.x) <= Farthest && std::abs(local.y) <= Farthest &&
        std::abs(local.z) <= Farthest;
    }

    glm::dvec3 WorldToLocal(const glm::dvec3& world) const
    {
      return (world - this->Center) / this->Length;
    }
    glm::dvec3 LocalToBox(const glm::dvec3& local) const
    {
      return this->LocalToBoxAxes * local + this->LocalToBoxOrigin;
    }
    glm::dvec3 BoxToLocal(const glm::dvec3& box) const
    {
      return this->BoxToLocalAxes * box + this->BoxToLocalOrigin;
    }
  };

  /// What a coefficient is at a point:
  /// Scale x { 1 | field components | rgb of a function | a of a function }.
  struct Coefficient
  {
    enum Sources
    {
      Constant,
      Field,         ///< the field's value (1 component: grey, 3: RGB)
      FunctionRGB,   ///< the colour channels of a function of the field's first component
      FunctionAlpha, ///< its alpha channel
    };
    Sources Source = Constant;
    int FieldIndex = -1;
    int FunctionIndex = -1;
    int Component = -1; ///< of the field; -1: all three as RGB, or the only one
    glm::dvec3 Scale{ 0 };

    bool IsConstant() const { return this->Source == Constant; }
    bool IsZero() const { return this->Scale == glm::dvec3(0); }
  };

  /// Formulas/vtkMediumPhase.glsl has their formulas.
  using Phases = vtkParticipatingMedium::PhaseFunctions;

  /// What fills the volume. Lengths are world units.
  struct Medium
  {
    std::vector<vtkMediumField> Fields;
    std::vector<vtkMediumFunction> Functions; ///< each reads the first component of a field

    /// sigma_t per world unit, or sigma_a where ExtinctionIsAbsorption is set.
    Coefficient Extinction;
    bool ExtinctionIsAbsorption = false;
    /// sigma_s per world unit, or the albedo sigma_s / sigma_t where ScatteringIsAlbedo is set.
    Coefficient Scattering;
    bool ScatteringIsAlbedo = true;
    Coefficient Emission;    ///< sigma_e, radiance per world unit
    double DensityScale = 1; ///< multiplies extinction, scattering and emission
    std::vector<int> Masks;  ///< fields of 0 and 1 that do so too, voxel by voxel

    Phases Phase = vtkParticipatingMedium::HenyeyGreenstein;
    Coefficient Anisotropy;         ///< g (SchlickK: k) of the first lobe; one value or a field
    double BackAnisotropy = 0;      ///< g of the second lobe of DoubleHenyeyGreenstein and Droplets
    double ForwardWeight = 1;       ///< weight of their first lobe, 0 to 1
    double DraineAlpha = 0;         ///< alpha of Draine's function, >= 0
    std::vector<double> PhaseTable; ///< values per steradian at equally spaced cosines -1…1

    bool ChromaticExtinction = false; ///< sigma_t differs between R, G and B

    /// Code of the user alters the coefficients of the picture: none is known to be zero or constant.
    bool Altered = false;
    std::vector<double> UserCode; ///< same values, same code and same uniforms of it; empty: none
  };

  /// The coefficients at one point, per world unit.
  struct Coefficients
  {
    glm::dvec3 Extinction{ 0 };
    glm::dvec3 Scattering{ 0 };
    glm::dvec3 Emission{ 0 };
    double Anisotropy = 0;
  };

  struct Light
  {
    enum Types
    {
      Directional,
      Point,
      Spot,
    };
    Types Type = Directional;
    glm::dvec3 Position{ 0 };          ///< local; Point and Spot
    glm::dvec3 Direction{ 0, 0, 1 };   ///< unit; the way the light travels; Directional and Spot
    glm::dvec3 Irradiance{ 0 };        ///< colour x intensity
    glm::dvec3 Attenuation{ 1, 0, 0 }; ///< a, b, c of 1/(a + b r + c r^2), r in local units
    double CosCone = -1;               ///< Spot: cosine of the cone's half angle
    double Exponent = 1;               ///< Spot: fall-off inside the cone
  };

  /// The eye rays. Through the point (x, y) of the viewport, both in -1…1, goes the ray
  /// (Origin + x OriginX + y OriginY) + t normalize(Direction + x DirectionX + y DirectionY),
  /// local units; in perspective OriginX and OriginY are zero, in parallel DirectionX and Y are.
  struct View
  {
    bool Parallel = false;
    glm::dvec3 Origin{ 0 }, OriginX{ 0 }, OriginY{ 0 };
    glm::dvec3 Direction{ 0, 0, -1 }, DirectionX{ 0 }, DirectionY{ 0 };
    double Start = 0; ///< t from which distances count: the eye, or the near plane in parallel
    glm::dvec4 ClipZ{ 0 }, ClipW{ 0 }; ///< rows z and w of the local-to-clip matrix
    glm::dmat4 LocalToClip{ 1 };
  };

  /// Opaque geometry that stands in the light; valid while the frame is drawn that it was gathered for.
  struct Caster
  {
    vtkProp* Prop = nullptr;
    vtkMTimeType Time = 0; ///< when what it shows changed last
  };

  Box Geometry;
  Medium Content;
  vtkMediumCut Cut; ///< what is clipped and cropped away
  /// The input's active scalars, which the Paper integrator compares with its threshold. Without an
  /// Array where there are none, which only a vtkParticipatingMedium may do without.
  vtkMediumField Scalars;
  std::vector<Light> Lights;
  std::vector<Caster>
    Casters; ///< of shadows into the volume; empty: none, or they are not asked for
  View Eye;

  /// Gathers geometry and content from the input, the volume's property and matrix, and the medium
  /// if there is one. Returns an empty string, or what was wrong: what was found, what was expected
  /// and what to do. On failure the scene must not be rendered.
  std::string GatherVolume(vtkImageData* input, vtkDataArray* scalars, bool onCells,
    vtkVolume* volume, vtkParticipatingMedium* medium, double anisotropy);

  /// Adds what leaves voxels out: the input's ghosts, and a mask, which may be null. After GatherVolume.
  std::string GatherMask(vtkImageData* input, vtkImageData* mask);

  /// Gathers clipping planes and cropping from a mapper, which may be null. After GatherVolume.
  std::string GatherCut(vtkAbstractVolumeMapper* mapper, vtkVolume* volume);

  /// Gathers the lights of the renderer that are switched on; where none is and the renderer
  /// creates lights automatically, its headlight. Head- and camera lights stand where the
  /// renderer's camera is now. Only the diffuse colour lights a medium: ambient and specular
  /// colours, and the renderer's ambient light, are ignored. A cone of 90 degrees or more is no
  /// spot. Lights that are black, and spots whose cone misses the volume, are left out. After GatherVolume.
  std::string GatherLights(vtkRenderer* renderer);

  /// What one light is. Without a renderer, head- and camera lights stand where they were put last. After
  /// GatherVolume.
  std::string ReadLight(vtkRenderer* renderer, vtkLight* source, Light& light) const;

  /// Gathers the renderer's visible props with opaque geometry: vtkProp3D of every kind but volumes.
  void GatherCasters(vtkRenderer* renderer);

  /// Takes the eye rays from a world-to-clip matrix (OpenGL's clip space, column vectors).
  /// After GatherVolume. Returns what is wrong with the matrix, or an empty string.
  std::string GatherView(vtkMatrix4x4* worldToClip);

  /// The coefficients at a box coordinate, as the equation of single scattering needs them.
  Coefficients Evaluate(const glm::dvec3& box) const;

  /// The colours of a transfer function at equally spaced values of a range, kept from one
  /// gathering to the next: VTK needs up to a second for them. A modification time belongs to one
  /// function.
  struct ColorTable
  {
    vtkMTimeType Time = 0;
    double Minimum = 0;
    double Maximum = 0;
    std::vector<glm::dvec3> Colors;
  };

private:
  std::vector<ColorTable> ColorTables;
  vtkMediumMask Mask;

  glm::dvec3 EvaluateCoefficient(
    const Coefficient& coefficient, const std::vector<glm::dvec4>& fields) const;
};

#endif
