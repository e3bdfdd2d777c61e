// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumFrame
 * @brief The float images that a frame is integrated into, and the draws that fill and show them.
 *
 * Two sets of targets, so that a march too long for one draw is carried from one set to the other:
 * radiance (R, G, B, alpha), hits (first, last, look-ups, rays) and, if carried, the march's state.
 */
#ifndef vtkMediumFrame_h
#define vtkMediumFrame_h

#include "vtkMediumAccelerator.h"
#include "vtkMediumCompatibility.h"
#include "vtkMediumOpaqueDepth.h"
#include "vtkMediumPlan.h"
#include "vtkMediumProgram.h"
#include "vtkMediumShadowMap.h"
#include "vtkMediumTextures.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
VTK_ABI_NAMESPACE_END

class vtkMediumFrame
{
public:
  /// The t of a first hit where the ray met nothing; rays may start anywhere, also at t < 0.
  static constexpr float NoHit = -1e30f;

  /// The count of rays of a pixel whose march goes on in the next draw.
  static constexpr float Unfinished = 0.5f;

  /// The viewport that the frame is shown in, window pixels.
  struct Viewport
  {
    glm::ivec2 Origin{ 0 };
    glm::ivec2 Size{ 0 };
    glm::ivec2 FirstPixel{ 0 }; ///< in the whole viewport, of which a tiled window shows a part
    double PixelEdge = 1;       ///< pixels of the window that share a ray, along each axis

    /// The rays of the integrated frame, at most PixelEdge pixels apart.
    glm::ivec2 GetRays() const
    {
      return glm::ivec2(glm::ceil(glm::dvec2(this->Size) / this->PixelEdge));
    }
  };

  /// How the shown frame is made of the integrated one; see Shaders/vtkMediumDisplay.glsl.
  struct Shown
  {
    enum Contents
    {
      Radiance,
      Transmittance,
      OpticalDepth,
      FirstHit,
      Distance,
      Count,
      Error,
    };
    Contents Content = Radiance;
    double Nearest = 0; ///< the value that is shown as 0
    double Scale = 1;   ///< 1 / (the value that is shown as 1, less that)
  };

  /// What the shaders read.
  struct Resources
  {
    vtkMediumProgram& Programs;
    vtkMediumTextures& Textures;
    vtkMediumAccelerator& Accelerator;
    vtkMediumShadowMap& ShadowMap;
  };

  /// Told after each draw which part of the frame is integrated, 0 to 1; false stops there.
  using Progress = std::function<bool(double fraction)>;

  /// Makes the targets, of a march that is carried on or a frame that is finished if so, and copies
  /// the depth of what is drawn already, or takes it that nothing is.
  /// Returns an empty string, or what the device could not do.
  std::string Begin(vtkOpenGLRenderWindow* window, const Viewport& viewport, bool carry,
    bool copyDepth, bool finish = false);

  /// Until the next Begin, rays begin and end at these depths instead; see Shaders/vtkMediumEyeRay.glsl.
  void SetEnds(vtkTextureObject* ends) { this->Ends = ends; }

  /// Integrates the plan's passes into the targets. False if the program does not compile.
  bool Integrate(const Resources& resources, const vtkMediumScene& scene, const vtkMediumPlan& plan,
    const Progress& progress = {});
  /// Whether the last Integrate went to its end.
  bool IsComplete() const { return this->Complete; }

  /// Lets code of the user alter the integrated colour. False if the program does not compile.
  bool Finish(vtkMediumProgram& programs, const vtkMediumScene& scene, const vtkMediumPlan& plan);

  /// Blends the result over the viewport; an Error is its difference from `coarser`. False if the
  /// program does not compile.
  bool Show(vtkMediumProgram& programs, const Shown& shown, vtkMediumFrame& coarser);

  /// The integrated targets, four floats a ray, first row at the bottom; empty before any frame and
  /// after one that was stopped.
  std::vector<float> DownloadRadiance() { return this->Download(0); }
  std::vector<float> DownloadHits() { return this->Download(1); }
  /// What the look-ups of light of each ray may err by, radiance; empty where that was not asked for.
  std::vector<float> DownloadBounds();
  /// The radiance where it is.
  vtkTextureObject* GetRadiance() { return this->Textures[this->Result][0]; }
  const Viewport& GetViewport() const { return this->View; }
  /// Draws that the last Integrate needed.
  int GetDraws() const { return this->Draws; }

  vtkTypeInt64 GetBytes() const;
  /// Depth buffers copied, since creation.
  int GetDepthCopies() const { return this->Depth.GetCopies(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  static constexpr int Targets = 3;

  std::vector<float> Download(int target);
  std::vector<float> Read(int target);
  void SetFrameUniforms(
    vtkShaderProgram* program, const vtkMediumScene& scene, const vtkMediumPlan& plan);
  void SetContentUniforms(
    vtkShaderProgram* program, const vtkMediumScene& scene, const vtkMediumPlan& plan);
  bool DrawPlan(const Resources& resources, const vtkMediumScene& scene, const vtkMediumPlan& plan,
    const Progress& progress);
  bool DrawPasses(vtkMediumProgram& programs, vtkShaderProgram* program, const vtkMediumPlan& plan,
    const Progress& progress);
  bool IsOver();
  void DrawPass(
    vtkMediumProgram& programs, vtkShaderProgram* program, const vtkMediumPlan::Pass& pass);
  /// Empty, or why the device cannot draw into the targets.
  std::string CheckTargets();
  void BindTargets(int set);
  void ClearTargets(int set);
  void ReleaseUnusedTargets();

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Textures[2][Targets];
  vtkMediumOpaqueDepth Depth;
  vtkTextureObject* Ends = nullptr; ///< what rays read: the depth, or what was set instead
  vtkOpenGLRenderWindow* Window = nullptr;
  Viewport View;
  int UsedTargets = 2;
  int UsedSets = 1;
  int Draws = 0;
  bool Complete = false;
  int Result = 0; ///< the set that holds the integrated frame
};

#endif
