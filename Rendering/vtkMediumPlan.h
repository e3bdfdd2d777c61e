// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumPlan
 * @brief What a scene needs and what it does not, decided before anything is drawn.
 *
 * A plan is a pure function of the scene, the settings and what the device can do. It has no OpenGL
 * in it, so that each decision is a row in a table of unit tests.
 */
#ifndef vtkMediumPlan_h
#define vtkMediumPlan_h

#include "vtkMediumFold.h"
#include "vtkMediumScene.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <memory>
#include <string>
#include <vector>

class vtkMediumUserCode;

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumPlan
{
public:
  /// How the transmittance to a light is found.
  enum LightMethods
  {
    March,           ///< along the whole light ray
    LookUp,          ///< in the light's cache
    MarchThenLookUp, ///< in pixels whose look-ups may err by too much, along the light ray until the
                     ///< cache is accurate enough
  };

  /// What the user asked for; the mapper's members, with its enumerations.
  struct Settings
  {
    int Integrator = 1;
    int Output = 0;
    double SampleDistance = 0;      ///< world units; 0: one voxel
    double LightSampleDistance = 0; ///< world units; 0: the eye ray's
    int BinarySearchIterations = 5;
    double Jitter = 0.2;
    double TransmittanceThreshold = 1.0 / 1024;
    double PaperThreshold = 0.5;
    bool AssumeConvex = false;
    bool CountTaps = false;
    int DepthDefinition = 0;
    double DepthTransmittance = 0.5;
    double MaximumError = 1.0 / 255;
    LightMethods LightMethod = LookUp; ///< ErrorControlled
    double LightTolerance = 0; ///< MarchThenLookUp: radiance a local unit that look-ups may err by
    double PixelTolerance = 0; ///< MarchThenLookUp: radiance that those of a pixel may err by
    bool OnlyRough = false;    ///< MarchThenLookUp: only the pixels whose look-ups may err by more
    bool StretchSteps = true;  ///< ErrorControlled: eye steps grow where little is seen of them
    bool Hurried = false;      ///< ErrorControlled: caches of lights that moved may be coarse
    double ControlledLightStep = 0; ///< ErrorControlled: of marched light rays; 0: the eye's
    double ControlledStep =
      0; ///< ErrorControlled: the step that was found, local units; 0: a voxel
    std::shared_ptr<const vtkMediumUserCode> UserCode; ///< null: none
    int OpaqueShadowResolution =
      1024; ///< pixels along the edge of a light's view of opaque geometry
    vtkTypeInt64 LightCacheBytes = vtkTypeInt64(1) << 30; ///< the most that light caches may take
  };

  /// What the device can do.
  struct Capabilities
  {
    /// Loop iterations that one fragment may spend in one draw. Mesa's software renderers end every
    /// loop of a fragment, in silence, once 65,536 iterations have been spent in it.
    int LoopIterations = 65536;
    int TextureSize3D = 2048;
    /// The filter of 3D textures rounds its weights, as GPUs do (to 1/256).
    bool CoarseFilter = false;
  };

  /// Where the cells are in which the fields are smooth: box x Scale + Bias is an integer on a face.
  struct Lattice
  {
    glm::dvec3 Scale{ 1 };
    glm::dvec3 Bias{ 0 };
  };

  /// A part of the frame that one draw integrates.
  struct Pass
  {
    int FirstLight = 0, LastLight = 0; ///< [first, last)
    int FirstStep = 0, LastStep = 0;   ///< [first, last) along the eye ray
  };

  /// The homogeneous medium of the Paper integrator, per local unit.
  struct Homogeneous
  {
    glm::dvec3 Extinction{ 0 };
    glm::dvec3 Scattering{ 0 };
  };

  /// The shortest step, as a fraction of the volume's diagonal; beyond it float adds only rounding.
  static constexpr double ShortestStep = 1.0 / 100000;
  /// The longest step, longer than every ray; what a user sets may be more than a float holds.
  static constexpr double LongestStep = 2;
  /// Textures for the caches of lights, and so the lights that have caches; the light rays of more are
  /// marched.
  static constexpr int MostCacheTextures = 4;
  static constexpr int CacheChannels = 4; ///< of a texture
  static constexpr int MostCachedLights = MostCacheTextures * CacheChannels;
  /// Pixels along the edge of a tile.
  static constexpr int TileEdge = 8;
  /// Voxels; longer steps of eye rays do not ask for empty bricks, which costs as much as a step.
  static constexpr double LongestLeaptStep = 2;
  /// What is seen of a segment's error falls with the transmittance T before it, and that error grows with
  /// the cube of its length: with segments of T^(-1/3) all do the same harm.
  static constexpr double ErrorStretch = 1.0 / 3;
  static constexpr double LongestStretch = 8; ///< of a step
  /// Exact: what a part of a cell may be off by, of the radiance so far.
  static constexpr double ExactTolerance = 4e-6;
  /// Exact: parts of a cell in which a field counts as linear where a function maps it.
  static constexpr int ExactParts = 3;
  /// From look-up to look-up of a light ray that is marched until its cache is accurate enough, voxels.
  static constexpr double LookUpSpacing = 2;
  /// Clipping planes that cut the volume; a cropped sub-volume may need six of them.
  static constexpr int MostClippingPlanes = 16;
  /// Parts into which cropping may divide a ray.
  static constexpr int MostKeptParts = 4;
  /// Look-ups in one iteration of a light ray's loop.
  static constexpr int LightTapsPerIteration = 4;

  vtkMediumPlan(const vtkMediumScene& scene, const Settings& settings, const Capabilities& device);

  /// Empty, or why the frame cannot be drawn right: what was found, expected, and what to do.
  std::string Refusal;

  bool UseBricks = false;    ///< bricks are built
  bool UseTiles = false;     ///< eye rays keep to the tiles that bricks were projected to
  bool LeapEyeSteps = false; ///< and leap the empty bricks between; light rays always do
  int CachedLights = 0; ///< the first so many lights have a light cache; 0: light rays are marched
  bool QuickCaches = false; ///< caches of lights that moved may be coarse
  bool CutCaches = false; ///< light caches are those of what a cut leaves, not of the whole volume
  bool CacheRoughness = false; ///< caches say by how much look-ups may err
  double PixelTolerance =
    0; ///< with CacheRoughness: radiance that those of a pixel may err by; infinite: any
  /// With CacheRoughness: what integrates the pixels whose look-ups may err by more; drawn over this plan.
  std::shared_ptr<const vtkMediumPlan> Rough;
  bool OnlyRough = false;    ///< this is such a plan: light is marched until its cache is accurate
  double LightTolerance = 0; ///< with OnlyRough: radiance a local unit that look-ups may err by
  int LightLookUpEvery = 1;  ///< with OnlyRough: iterations from look-up to look-up
  bool ClosedForm = false;   ///< no ray is marched: a homogeneous box has a closed form
  bool ConstantExtinction = false; ///< the optical depth of a light ray is its length
  bool OpaqueShadows = false;      ///< opaque geometry stands in the light
  int OpaqueShadowResolution = 0;
  bool ReadsFunctions = false;         ///< the tables of the scene's functions are needed
  bool ReadsFunctionIntegrals = false; ///< Exact: and those of their integrals
  bool ReadsJitter = false;            ///< Paper: the table of random numbers is needed
  bool Lit = false;   ///< light rays are marched: there is light, and something scatters it
  double EyeStep = 0; ///< local units
  double EyeStretch =
    0; ///< eye steps grow with the transmittance before them to the power of minus this
  double LightStep = 0; ///< local units
  double TransmittanceThreshold = 0;
  double DepthTransmittance = 0;
  double Jitter = 0;         ///< Paper: fraction of a step
  double PaperThreshold = 0; ///< Paper: in the units of the texture, 0…1 over the field's range
  Homogeneous Filled;        ///< Paper
  std::vector<vtkMediumField> Fields; ///< the textures that the integrator reads, by number
  std::vector<vtkMediumFold> Folds;   ///< how they lie in these textures
  bool Folded = false;                ///< one of them, at least, lies in blocks
  int LargestTexture = 0;             ///< texels along an axis of a 3D texture, at most
  std::vector<Pass> Passes;
  std::vector<Lattice> Lattices; ///< Exact
  /// Exact: loop iterations after which a draw hands over to the next; each pass is drawn until every
  /// march is over. 0 in the other integrators.
  int IterationBudget = 0;

  std::shared_ptr<const vtkMediumUserCode> UserCode; ///< null: none
  bool Finishes = false;                ///< code of the user has the last word on the colour
  std::vector<std::string> ShaderFiles; ///< in order, without prefix and suffix
  std::string ShaderDefines;            ///< the structural choices, as preprocessor lines

  /// The same plan in steps of twice the length.
  vtkMediumPlan Coarser() const;

  /// Channels that a light takes of a texture of caches.
  static constexpr int ChannelsPerLight(bool roughness) { return roughness ? 2 : 1; }
  /// The lights that share a texture of caches.
  int GetLightsPerTexture() const { return CacheChannels / ChannelsPerLight(this->CacheRoughness); }
  int GetCacheTextures() const
  {
    return (this->CachedLights + this->GetLightsPerTexture() - 1) / this->GetLightsPerTexture();
  }

  /// Whether marches are carried from draw to draw.
  bool NeedsState() const
  {
    return this->Passes.size() > 1 || this->IterationBudget > 0 || this->CacheRoughness;
  }

  /// Where the volume can be seen: x, y, width, height in pixels; zero size where it cannot.
  static glm::ivec4 FindScissor(const vtkMediumScene::View& eye, const vtkMediumScene::Box& box,
    const glm::ivec2& viewportSize);

private:
  void Validate(const Settings&);
  void PlanFolds(const Capabilities&);
  std::string FieldDefines() const;
  void ValidateCut(const vtkMediumCut&);
  void PlanUserCode(const Settings&);
  static bool CutsLightRays(const vtkMediumScene&);
  void ChooseSteps(const vtkMediumScene&, const Settings&);
  void PlanPaper(const vtkMediumScene&, const Settings&);
  static std::vector<vtkMediumField> PaperFields(const vtkMediumScene&);
  bool HasClosedForm(const vtkMediumScene&, const Settings&) const;
  void PlanClosedForm(const vtkMediumScene&, const Capabilities&);
  void PlanErrorControlled(const vtkMediumScene&, const Settings&);
  void PlanExact(const vtkMediumScene&, const Capabilities&);
  std::string OutputDefines(const Settings&) const;
  std::string PaperDefines(const Settings&) const;
  int CountLightIterations(bool paper) const;
  void SplitIntoPasses(const vtkMediumScene&, const Settings&, const Capabilities&);
  void ChooseProgram(const vtkMediumScene&, const Settings&, const Capabilities&);
  void ChooseShaderFiles(const vtkMediumScene&, int integrator);
  void ChooseIntegratorFiles(int integrator);
  void ChooseLightFiles();
};

#endif
