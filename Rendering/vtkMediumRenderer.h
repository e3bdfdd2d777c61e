// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumRenderer
 * @brief The story of a frame: facts, decisions, resources, one draw.
 *
 * Private to the module; vtkSingleScatteringVolumeMapper is its face.
 */
#ifndef vtkMediumRenderer_h
#define vtkMediumRenderer_h

#include "vtkMediumAccelerator.h"
#include "vtkMediumCompatibility.h"
#include "vtkMediumFrame.h"
#include "vtkMediumFrameBudget.h"
#include "vtkMediumPeel.h"
#include "vtkMediumPlan.h"
#include "vtkMediumProgram.h"
#include "vtkMediumScene.h"
#include "vtkMediumShadowMap.h"
#include "vtkMediumStepControl.h"
#include "vtkMediumTextures.h"

#include "vtkWeakPointer.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractVolumeMapper;
class vtkDataArray;
class vtkHardwareSelector;
class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkVolume;
class vtkWindow;
VTK_ABI_NAMESPACE_END
class vtkMediumStatistics;
class vtkParticipatingMedium;

class vtkMediumRenderer
{
public:
  /// What is to be drawn, and how.
  struct Request
  {
    vtkRenderer* Renderer = nullptr;
    vtkVolume* Volume = nullptr;
    vtkImageData* Input = nullptr;
    vtkAbstractVolumeMapper* Mapper = nullptr; ///< whose clipping planes and cropping count
    vtkImageData* Mask = nullptr;              ///< may be null
    vtkDataArray* Scalars = nullptr;
    bool ScalarsOnCells = false;
    vtkParticipatingMedium* Medium = nullptr; ///< null: the volume's property
    double Anisotropy = 0;                    ///< of the property
    vtkMediumScene::Phases Phase = vtkParticipatingMedium::HenyeyGreenstein; ///< of the property
    double MaximumError = 0;                                                 ///< ErrorControlled
    bool AlwaysCache = false;   ///< ErrorControlled: light caches whatever their error
    double PixelEdge = 1;       ///< pixels of the window that share a ray, along each axis
    double Seconds = 1e9;       ///< ErrorControlled: the time that the window has for this frame
    bool OpaqueShadows = false; ///< opaque geometry casts shadows into the medium
    bool Show = true;           ///< in the window
    vtkMediumFrame::Progress Progress;       ///< told after each draw of the frame; false stops it
    vtkHardwareSelector* Selector = nullptr; ///< to be shown where the medium is, see Select
    vtkMediumPeel::Caller Peeling;           ///< the pass that peels the volume, if one does
    vtkMediumPlan::Settings Settings;
  };

  /// Draws a frame and writes down what it took. Returns an empty string, or why the frame cannot be
  /// drawn right.
  std::string Draw(const Request& request, vtkMediumStatistics* statistics);

  /// Draws the current pass of the request's selector. What the last frame left stays.
  std::string Select(const Request& request);

  /// The last frame: what it holds, and the scene that it was drawn from.
  vtkMediumFrame& GetFrame() { return this->Frame; }
  /// The same frame in steps of twice the length, where the output is an error estimate.
  vtkMediumFrame& GetCoarserFrame() { return this->Coarser; }
  const vtkMediumScene& GetScene() const { return this->Scene; }
  int GetOutput() const { return this->Output; }
  /// Whether the last frame is in pieces, between layers of depth peeling.
  bool IsInPieces() const { return this->InPieces; }
  /// Of the last ErrorControlled frame; 0 if it has a closed form, -1 if it was hurried, and its error
  /// nobody's guess.
  double GetEstimatedError() const
  {
    const double found = this->ClosedForm ? 0 : this->StepControl.GetEstimatedError();
    return this->Economy.Hurried ? -1 : found;
  }
  /// Values that were NaN or infinite in the fields that the last Draw uploaded.
  vtkTypeInt64 GetNonFinite() const { return this->Textures.GetNonFinite(); }

  /// Gives back what is held in a window; any window will do, the one in use counts.
  void ReleaseGraphicsResources(vtkWindow* window);
  vtkWindow* GetWindow() const;

private:
  std::string UseWindow(vtkRenderer* renderer);
  /// Where the renderer draws, in pixels of the window or of the tile that it is.
  static vtkMediumFrame::Viewport FindViewport(vtkRenderer* renderer);
  std::string Gather(const Request& request);
  std::string GatherView(vtkRenderer* renderer);
  std::string Prepare(const Request& request, const vtkMediumPlan::Capabilities& device,
    const vtkMediumPlan& draft, vtkMediumPlan::Settings& settings, vtkMediumStatistics* statistics);
  std::string FindStep(const Request& request, const vtkMediumPlan::Capabilities& device,
    vtkMediumStepControl::CacheUses caches);
  std::vector<float> IntegrateProbes(const glm::ivec2& pixels,
    const vtkMediumPlan::Settings& settings, const vtkMediumPlan::Capabilities& device,
    std::string& refusal);
  std::string DrawFrame(
    const Request& request, const vtkMediumPlan::Settings& settings, const vtkMediumPlan& plan);
  std::string IntegrateFrame(vtkMediumFrame& frame, const Request& request,
    const vtkMediumPlan& plan, const vtkMediumFrame::Viewport& viewport, bool mayBeHidden,
    vtkTextureObject* ends = nullptr);
  std::string DrawPieces(
    const Request& request, const vtkMediumPlan& plan, const vtkMediumFrame::Viewport& viewport);
  std::string DrawSelection(const Request& request, const vtkMediumPlan& plan);
  std::string Integrate(vtkMediumFrame& frame, const vtkMediumPlan& plan,
    const vtkMediumFrame::Progress& progress = {});
  static vtkMediumPlan::Capabilities FindCapabilities();
  void ReleaseUnread(const Request& request, const vtkMediumPlan& draft);
  void CountWork(const vtkMediumPlan& plan, vtkMediumStatistics* statistics);

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkMediumScene Scene;
  vtkMediumTextures Textures;
  vtkMediumAccelerator Accelerator;
  vtkMediumShadowMap ShadowMap;
  vtkMediumProgram Programs;
  vtkMediumStepControl StepControl;
  vtkMediumFrameBudget Budget;
  vtkMediumFrameBudget::Economy Economy; ///< of the last frame
  bool ClosedForm = false;               ///< the last frame was not marched
  vtkMediumPeel Peel;
  vtkMediumFrame Probe; ///< what StepControl asks for, and the second piece of a frame in pieces
  vtkMediumFrame
    Coarser; ///< what an error estimate compares Frame with; shown and read as long as that
  vtkMediumFrame Frame;
  vtkMediumSignature FrameSignature; ///< of what Frame holds; empty: of nothing
  bool Reused = false;               ///< the last Draw showed what Frame held already
  bool InPieces = false;             ///< Frame holds a piece of each ray only
  int Output = 0;
};

#endif
