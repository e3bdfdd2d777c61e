// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumStatistics
 * @brief What the mapper did: work of the last frame, and totals since it was created.
 *
 * Owned by vtkSingleScatteringVolumeMapper and updated by each Render. Taps, the number of lattice
 * look-ups on eye and light rays, and the number of rays are counted by the shader itself, and only
 * while CountTaps is on, since reading them back costs a few milliseconds.
 *
 * Before the first frame all numbers are 0, but PixelEdge, which is 1, and LightMethod, which is
 * LightMarched. A frame that is refused or aborted leaves the numbers of the last one that was drawn, but for
 * its times.
 *
 * @sa vtkSingleScatteringVolumeMapper::GetStatistics
 */
#ifndef vtkMediumStatistics_h
#define vtkMediumStatistics_h

#include "vtkObject.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumStatistics : public vtkObject
{
public:
  static vtkMediumStatistics* New();
  vtkTypeMacro(vtkMediumStatistics, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether each frame counts its taps and rays. Default: off.
  vtkSetMacro(CountTaps, bool);
  vtkGetMacro(CountTaps, bool);
  vtkBooleanMacro(CountTaps, bool);
  ///@}

  ///@{
  /// Of the last frame: look-ups in the medium's textures, on eye and light rays; 0 unless CountTaps.
  vtkGetMacro(Taps, vtkTypeInt64);
  /// Of the last frame: eye rays that met the volume; 0 unless CountTaps.
  vtkGetMacro(Rays, vtkTypeInt64);
  /// Of the last frame: those of them that were integrated a second time, with light rays marched, since
  /// what their look-ups in light caches may err by added up to more than MaximumError; 0 unless CountTaps.
  vtkGetMacro(RaysRefined, vtkTypeInt64);
  /// Of the last frame: full-screen draws over which its marches were split.
  vtkGetMacro(Passes, vtkTypeInt64);
  ///@}

  /// Of the last frame: pixels of the window that shared an eye ray, along each axis; 1 or more.
  vtkGetMacro(PixelEdge, double);

  /// Of the last frame: the longest that a step of an eye ray may have been, world units. Paper and FixedStep:
  /// SampleDistance, or one voxel; ErrorControlled: what it found, or what a hurried frame made of that (steps
  /// grow behind what hides them); in closed form: the volume's diagonal, as no ray is longer. Exact goes cell by
  /// cell, so that this is only what FixedStep would take.
  vtkGetMacro(EyeStep, double);

  /// How the last frame found the transmittance to a light.
  enum LightMethods
  {
    LightMarched,           ///< along the whole light ray, or not at all
    LightLookedUp,          ///< in the light's cache
    LightMarchedToItsCache, ///< in the light's cache, and where that is not accurate enough for a pixel,
                            ///< along the light ray until it is
    LightInClosedForm ///< by formula, as all of the frame: a homogeneous box in directional light
  };
  /// One of LightMethods. Paper, FixedStep and Exact march, but for Exact's closed forms.
  vtkGetMacro(LightMethod, int);

  ///@{
  /// Of the last frame: bricks of 8 x 8 x 8 cells that eye rays may have to enter, and bricks that are
  /// empty or cut away and were leapt; both 0 in integrators without bricks.
  vtkGetMacro(BricksVisited, vtkTypeInt64);
  vtkGetMacro(BricksLeapt, vtkTypeInt64);
  ///@}

  ///@{
  /// Of the last frame, wall-clock milliseconds: gathering facts and deciding; uploading textures
  /// and drawing shadow maps; building bricks and light caches; finding the step; compiling programs; integrating, up to the
  /// driver's completion; the whole of Render.
  vtkGetMacro(GatherMilliseconds, double);
  vtkGetMacro(UploadMilliseconds, double);
  vtkGetMacro(BuildMilliseconds, double);
  vtkGetMacro(CalibrateMilliseconds, double);
  vtkGetMacro(CompileMilliseconds, double);
  vtkGetMacro(IntegrateMilliseconds, double);
  vtkGetMacro(FrameMilliseconds, double);
  ///@}

  ///@{
  /// Since creation: frames drawn, those of them that only showed again what was integrated for the one
  /// before, textures uploaded (not counting the lights' few numbers), programs
  /// compiled, bricks built for an extinction, light caches built, textures of light caches uploaded (up to
  /// four lights each, for a new density scale too), views of opaque geometry that were drawn
  /// for its shadows (one for a light, up to six for one inside of the volume or near it), copies of the
  /// depth of opaque geometry that may hide the volume, and steps found from probe pixels.
  vtkGetMacro(Frames, vtkTypeInt64);
  vtkGetMacro(FramesReused, vtkTypeInt64);
  vtkGetMacro(TextureUploads, vtkTypeInt64);
  vtkGetMacro(ProgramCompiles, vtkTypeInt64);
  vtkGetMacro(BrickBuilds, vtkTypeInt64);
  vtkGetMacro(LightCacheBuilds, vtkTypeInt64);
  vtkGetMacro(LightCacheUploads, vtkTypeInt64);
  vtkGetMacro(ShadowMapBuilds, vtkTypeInt64);
  vtkGetMacro(OpaqueDepthCopies, vtkTypeInt64);
  vtkGetMacro(Calibrations, vtkTypeInt64);
  ///@}

  /// Bytes of textures and framebuffers held on the device now.
  vtkGetMacro(GPUBytes, vtkTypeInt64);

protected:
  vtkMediumStatistics();
  ~vtkMediumStatistics() override;

private:
  friend class vtkMediumRenderer;
  friend class vtkSingleScatteringVolumeMapper;

  bool CountTaps = false;
  vtkTypeInt64 Taps = 0;
  vtkTypeInt64 Rays = 0;
  vtkTypeInt64 RaysRefined = 0;
  vtkTypeInt64 Passes = 0;
  int LightMethod = LightMarched;
  double PixelEdge = 1;
  double EyeStep = 0;
  double GatherMilliseconds = 0;
  double UploadMilliseconds = 0;
  double BuildMilliseconds = 0;
  double CalibrateMilliseconds = 0;
  double CompileMilliseconds = 0;
  double IntegrateMilliseconds = 0;
  double FrameMilliseconds = 0;
  vtkTypeInt64 Frames = 0;
  vtkTypeInt64 FramesReused = 0;
  vtkTypeInt64 TextureUploads = 0;
  vtkTypeInt64 ProgramCompiles = 0;
  vtkTypeInt64 BricksVisited = 0;
  vtkTypeInt64 BricksLeapt = 0;
  vtkTypeInt64 BrickBuilds = 0;
  vtkTypeInt64 LightCacheBuilds = 0;
  vtkTypeInt64 LightCacheUploads = 0;
  vtkTypeInt64 ShadowMapBuilds = 0;
  vtkTypeInt64 OpaqueDepthCopies = 0;
  vtkTypeInt64 Calibrations = 0;
  vtkTypeInt64 GPUBytes = 0;

  vtkMediumStatistics(const vtkMediumStatistics&) = delete;
  void operator=(const vtkMediumStatistics&) = delete;
};

#endif
