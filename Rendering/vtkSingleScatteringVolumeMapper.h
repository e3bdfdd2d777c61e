// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSingleScatteringVolumeMapper
 * @brief Renders a vtkImageData as a participating medium lit by single scattering.
 *
 * Each eye ray gathers the light that the renderer's vtkLights send into the medium, weakened on its
 * way in and on its way out (Beer's law) and turned towards the eye by a phase function:
 *
 *     L = int T(t) [ sigma_e + sum_k sigma_s p(cos theta_k) E_k exp(-tau_k) ] dt
 *
 * Lengths are world units. The phase function integrates to 1 over the sphere. An image is linear radiance,
 * premultiplied, without any tone mapping: a light's colour times its intensity is the irradiance on a plane
 * normal to the beam (a positional light: divided by a + b r + c r^2, its AttenuationValues), so an isotropic
 * medium of albedo 1 shows about 1/(4 pi) of it: raise intensities to taste. The ambient and specular colours
 * of lights and the renderer's ambient light are ignored. Without a light that is on (AutomaticLightCreation
 * off) a medium is black, or shows its emission; that is an error only in Paper, for Radiance.
 *
 * Without a medium, the volume's vtkVolumeProperty is the medium: the scalar opacity function and
 * ScalarOpacityUnitDistance give the extinction, sigma_t = -ln(1 - alpha) / unit distance (alpha is taken as
 * at most 1 - 2^-24), and the colour function gives the albedo.
 *
 * The input is a vtkImageData of any scalar type; its point or cell scalars are chosen as in any
 * vtkVolumeMapper. NaN and -Inf voxels count as the smallest, +Inf as the largest finite value of the data,
 * with one warning. The camera may be anywhere, also inside the volume.
 *
 * Whatever cannot be drawn right is refused by one vtkErrorMacro that says what was found and what to do; the
 * frame keeps its background and the next valid frame is drawn. A cause that persists is reported once, until
 * it changes or a frame succeeds. Refused are: an input that is not a vtkImageData, has no scalars, has fewer
 * than two points along an axis or a singular matrix; blend modes other than composite and additive; a
 * gradient opacity other than 1 and two-dimensional transfer functions; clipping and cropping planes that are
 * none; outputs that depth peeling cannot mix; a window without OpenGL 3.2; and the parameter values named
 * below. Where a range is called clamped, a number outside of it is taken as the nearest one in it.
 *
 * @par Clipping and cropping
 * Clipping planes (AddClippingPlane; world coordinates; kept is the side that the normal points to) and
 * cropping (SetCropping, 27 regions, planes in the coordinates of the image, before the volume's matrix) cut
 * eye rays and light rays alike: what is cut away neither shines nor casts a shadow. Rays are cut exactly at
 * the planes, whatever the step. At most 16 planes may cut the volume, the faces of a cropped box among them.
 * Refused are a plane with numbers that are not finite, a zero normal or a transform, and cropping planes in
 * the wrong order. What moving a plane costs, and masks: Documentation/cutting.md.
 *
 * @par Blend modes
 * Composite blending is what a medium does. Additive blending is a radiograph: no light is followed, the
 * extinction is added up along each eye ray, and Radiance becomes OpticalDepth, which is shown as
 * 1 - exp(-tau); other outputs stay what they are. The other modes combine scalars, not a medium.
 *
 * @par Shader code
 * The volume's vtkShaderProperty may put GLSL at four points of the shaders (Documentation/shaders.md), no more.
 *
 * @par Picking and selection
 * vtkHardwareSelector, and what uses it (vtkPropPicker, vtkRenderer::PickProp), see the medium where more than
 * 3/255 of the light from behind is lost, as with VTK's own volume mapper. The depth, and the number of the
 * point or cell, are those of that place; with Paper, of the first hit; while RenderToImage is on there are
 * none. vtkCellPicker and vtkVolumePicker know no vtkParticipatingMedium; see Documentation/geometry.md.
 *
 * @par The integrators
 * | name | what it does | order |
 * | --- | --- | --- |
 * | Paper | the algorithm of Han, Ki and Oh (GPU Ray Marching for Real-Time Rendering of Participating Media): a homogeneous medium fills the voxels at or above a threshold; linear then binary search finds its surface; left Riemann sums | 1 |
 * | FixedStep | any medium; nested midpoint marching with a closed form in each segment | 2 |
 * | ErrorControlled | any medium; the longest step that keeps MaximumError, found from probe pixels; bricks and light caches; closed forms of homogeneous boxes | 2 |
 * | Exact | any medium; cell by cell on eye and light rays, refined to 1e-4 of the peak; slow | – |
 *
 * @sa vtkParticipatingMedium vtkSingleScatteringReference vtkMediumStatistics
 */
#ifndef vtkSingleScatteringVolumeMapper_h
#define vtkSingleScatteringVolumeMapper_h

#include "vtkMediumCompatibility.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkVolumeMapper.h"

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkWindow;
VTK_ABI_NAMESPACE_END
class vtkMediumRenderer;
class vtkMediumStatistics;
class vtkParticipatingMedium;

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkSingleScatteringVolumeMapper : public vtkVolumeMapper
{
public:
  static vtkSingleScatteringVolumeMapper* New();
  vtkTypeMacro(vtkSingleScatteringVolumeMapper, vtkVolumeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How the integral is computed; see the table above.
  enum Integrators
  {
    Paper,
    FixedStep,
    ErrorControlled,
    Exact,
  };

  /// What the image holds.
  enum Outputs
  {
    Radiance,      ///< radiance, premultiplied; alpha is 1 - mean transmittance
    FirstHit,      ///< distance along the eye ray to the first point of the medium, world units
    Distance,      ///< distance from the first to the last point of the medium, world units
    Transmittance, ///< transmittance along the eye ray, R, G and B
    OpticalDepth,  ///< optical depth along the eye ray, R, G and B
    Depth,         ///< distance along the eye ray, world units, as DepthDefinition has it
    SampleCount,   ///< look-ups in the medium's textures, on the eye ray and its light rays
    ErrorEstimate, ///< how wrong Radiance would be, as a radiance
  };

  /// What "depth" means where a medium has no surface.
  enum DepthDefinitions
  {
    FirstHitDepth,       ///< where the extinction is first above zero
    MeanScatteringDepth, ///< the mean of where the light that reaches the eye was scattered or emitted
    TransmittanceDepth, ///< where the transmittance falls to DepthTransmittance
  };

  /// When ErrorControlled uses light caches.
  enum LightCacheUses
  {
    CachesWhereAccurate,
    CachesAlways,
    CachesNever,
  };

  /// Phase functions that need no medium to be set.
  enum PhaseFunctions
  {
    HenyeyGreenstein,
    Schlick,
  };

  ///@{
  /// The medium that fills the volume. Default: none, the volume's property is the medium. Values are interpolated
  /// as that property says in either case: SetInterpolationTypeToLinear, as VTK's default is the nearest value.
  void SetMedium(vtkParticipatingMedium* medium);
  vtkParticipatingMedium* GetMedium();
  ///@}

  ///@{
  /// Where nothing is: an image of the input's dimensions whose point or cell scalars, one component of unsigned
  /// char, are 0 where there is no medium, for eye rays and light rays. A voxel is taken out as a whole, with a
  /// sharp border: a cell, or what is nearest to a point; the data are interpolated as if there were no mask. The
  /// input's ghosts (vtkGhostType other than 0, as vtkUniformGrid::BlankPoint and BlankCell set it) are left out by
  /// the same rule; call Modified() on the input after blanking. Other dimensions or types: an error at the next
  /// Render. Default: none.
  void SetMaskInput(vtkImageData* mask);
  vtkImageData* GetMaskInput();
  ///@}

  ///@{
  /// Mean cosine g of the phase function when no medium is set, -1 (back) to 1 (forward), and which phase
  /// function it parametrises (clamped). |g| > 0.999 is taken as 0.999. Outside [-1, 1], or NaN: an error at the
  /// next Render. Schlick's k is 1.55 g - 0.55 g^3, at most 0.999 in magnitude; its mean cosine is not exactly g.
  /// Default: 0, isotropic; Henyey-Greenstein. Paper always uses Schlick's, also with a medium.
  vtkSetMacro(Anisotropy, double);
  vtkGetMacro(Anisotropy, double);
  vtkSetClampMacro(PhaseFunction, int, HenyeyGreenstein, Schlick);
  vtkGetMacro(PhaseFunction, int);
  void SetPhaseFunctionToHenyeyGreenstein() { this->SetPhaseFunction(HenyeyGreenstein); }
  void SetPhaseFunctionToSchlick() { this->SetPhaseFunction(Schlick); }
  ///@}

  ///@{
  /// The integrator; clamped. Default: ErrorControlled.
  vtkSetClampMacro(Integrator, int, Paper, Exact);
  vtkGetMacro(Integrator, int);
  void SetIntegratorToPaper() { this->SetIntegrator(Paper); }
  void SetIntegratorToFixedStep() { this->SetIntegrator(FixedStep); }
  void SetIntegratorToErrorControlled() { this->SetIntegrator(ErrorControlled); }
  void SetIntegratorToExact() { this->SetIntegrator(Exact); }
  ///@}

  ///@{
  /// ErrorControlled: the largest error of any pixel, as a fraction of the image's peak radiance, that
  /// the step is chosen for. It is met by estimate, not by proof; see GetEstimatedError. Outside (0, 1], or
  /// NaN: an error at the next Render. Default: 1/255.
  vtkSetMacro(MaximumError, double);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /// ErrorControlled (clamped): whether light comes from caches, one look-up for a light ray, or from marched
  /// light rays. Caches have an error of their own, on data that change abruptly from voxel to voxel, which no
  /// step mends. WhereAccurate (default) takes them in pixels where MaximumError leaves room for that error, and
  /// in others marches each light ray until its cache is accurate enough; Always takes them and lets
  /// GetEstimatedError say what that costs; Never marches. Caches serve up to 16 lights and media of grey
  /// extinction with linear interpolation, and take 2 bytes a voxel for each light, at most 1 GiB; where light rays
  /// are marched up to them, 4 bytes and 8 lights. Beyond that light rays are marched to their ends.
  vtkSetClampMacro(LightCaches, int, CachesWhereAccurate, CachesNever);
  vtkGetMacro(LightCaches, int);
  void SetLightCachesToWhereAccurate() { this->SetLightCaches(CachesWhereAccurate); }
  void SetLightCachesToAlways() { this->SetLightCaches(CachesAlways); }
  void SetLightCachesToNever() { this->SetLightCaches(CachesNever); }
  ///@}

  ///@{
  /// Whether the renderer's visible opaque geometry casts shadows into the medium, with edges as wide as a
  /// pixel of the light's view of the volume, which has OpaqueShadowResolution (16 to 8192, clamped) pixels an
  /// edge; see Documentation/shadows.md. Default: off, for outlines, axes and widgets cast shadows too; 1024.
  vtkSetMacro(OpaqueShadows, bool);
  vtkGetMacro(OpaqueShadows, bool);
  vtkBooleanMacro(OpaqueShadows, bool);
  vtkSetClampMacro(OpaqueShadowResolution, int, 16, 8192);
  vtkGetMacro(OpaqueShadowResolution, int);
  ///@}

  ///@{
  /// ErrorControlled: whether a frame keeps to the time that the render window has for it
  /// (vtkProp::GetAllocatedRenderTime) where that is less than a second, as while a user interacts with it. Such a
  /// frame finds no step, looks light up in caches that are quickly built, takes steps up to twice as long and lets
  /// up to 8 x 8 pixels share a ray; scattering stays on. The next at rest is as accurate as ever. Default: on.
  vtkSetMacro(AutoAdjustSampleDistances, bool);
  vtkGetMacro(AutoAdjustSampleDistances, bool);
  vtkBooleanMacro(AutoAdjustSampleDistances, bool);
  ///@}

  ///@{
  /// Pixels of the window between eye rays, along each axis, 1 (default) to 10, clamped; NaN: an error at the next
  /// Render. Between them the picture is interpolated, also across edges of opaque geometry; float images have a
  /// value for each ray.
  vtkSetClampMacro(ImageSampleDistance, double, 1, 10);
  vtkGetMacro(ImageSampleDistance, double);
  ///@}

  /// The largest error that the last ErrorControlled frame was estimated to have, of the image's peak radiance,
  /// by its steps and light caches together; 0 where it has a closed form, and before any frame; -1 while another
  /// integrator is set and where the frame had to keep to a time.
  double GetEstimatedError();

  ///@{
  /// Paper, FixedStep: the longest step along eye rays, and along light rays, world units. 0 (default): one voxel's
  /// shortest edge for eye rays, and their step for light rays. Below 1/100000 of the volume's diagonal it is taken
  /// as that. Negative, infinite or NaN: an error at the next Render, also in integrators that have steps of their own.
  vtkSetMacro(SampleDistance, double);
  vtkGetMacro(SampleDistance, double);
  vtkSetMacro(LightSampleDistance, double);
  vtkGetMacro(LightSampleDistance, double);
  ///@}

  ///@{
  /// Paper: how often a hit that the linear search brackets is halved, 0 to 10, clamped (2^-10 of a step is finer
  /// than float resolves on a long ray). Default: 5.
  vtkSetClampMacro(BinarySearchIterations, int, 0, 10);
  vtkGetMacro(BinarySearchIterations, int);
  ///@}

  ///@{
  /// Paper: each eye ray starts its samples late by one random number in [0, Jitter) of a step, from a table that
  /// is the same in every frame; a small jitter trades rings for little noise. Outside [0, 1), or NaN: an error at
  /// the next Render, of any integrator. Default: 0.2.
  vtkSetMacro(Jitter, double);
  vtkGetMacro(Jitter, double);
  ///@}

  ///@{
  /// A ray stops where its transmittance falls below this; the error is at most this fraction of the brightest
  /// remaining source. 0 never stops early. Outside [0, 1), or NaN: an error at the next Render. Default: 1/1024.
  vtkSetMacro(TransmittanceThreshold, double);
  vtkGetMacro(TransmittanceThreshold, double);
  ///@}

  ///@{
  /// Paper: voxels whose scalar is at or above this value are filled (in the data's units). A threshold above the
  /// data's range, which nothing passes, and NaN are errors at the next Render with Paper. Default: 0.5.
  vtkSetMacro(PaperThreshold, double);
  vtkGetMacro(PaperThreshold, double);
  ///@}

  ///@{
  /// Paper: on, eye rays and light rays end at their first exit, as the paper has it, which leaves holes where the
  /// filled part is not convex. Off (default), both go on through every filled interval to the volume's end.
  vtkSetMacro(AssumeConvex, bool);
  vtkGetMacro(AssumeConvex, bool);
  vtkBooleanMacro(AssumeConvex, bool);
  ///@}

  ///@{
  /// What the image holds; clamped. Default: Radiance. On screen, distances are shown as grey: FirstHit and Depth
  /// as 1 at the nearest corner of the volume down to 0 at the farthest, Distance as a fraction of the volume's
  /// diagonal, OpticalDepth as 1 - transmittance, SampleCount as a fraction of 1000, ErrorEstimate 64 times as
  /// bright; as float images (GetColorImage) they are in their own units.
  /// ErrorEstimate compares the frame with one of twice its steps and takes a third of the change, the error of a
  /// method of second order (Richardson). The error of light caches is not in it, as both frames look light up in
  /// the same caches; with ErrorControlled, GetEstimatedError has both.
  /// The Paper integrator knows Radiance, FirstHit and Distance, and Exact has no step to estimate from: what an
  /// integrator does not know is an error at the next Render.
  vtkSetClampMacro(Output, int, Radiance, ErrorEstimate);
  vtkGetMacro(Output, int);
  void SetOutputToRadiance() { this->SetOutput(Radiance); }
  void SetOutputToFirstHit() { this->SetOutput(FirstHit); }
  void SetOutputToDistance() { this->SetOutput(Distance); }
  void SetOutputToTransmittance() { this->SetOutput(Transmittance); }
  void SetOutputToOpticalDepth() { this->SetOutput(OpticalDepth); }
  void SetOutputToDepth() { this->SetOutput(Depth); }
  void SetOutputToSampleCount() { this->SetOutput(SampleCount); }
  void SetOutputToErrorEstimate() { this->SetOutput(ErrorEstimate); }
  ///@}

  ///@{
  /// What the Depth output means; clamped. Default: FirstHitDepth.
  vtkSetClampMacro(DepthDefinition, int, FirstHitDepth, TransmittanceDepth);
  vtkGetMacro(DepthDefinition, int);
  void SetDepthDefinitionToFirstHit() { this->SetDepthDefinition(FirstHitDepth); }
  void SetDepthDefinitionToMeanScattering() { this->SetDepthDefinition(MeanScatteringDepth); }
  void SetDepthDefinitionToTransmittance() { this->SetDepthDefinition(TransmittanceDepth); }
  ///@}

  ///@{
  /// TransmittanceDepth: the mean transmittance that marks the depth, in (0, 1); a ray that keeps more
  /// than that has no depth. Outside (0, 1), or NaN: an error at the next Render. Default: 0.5.
  vtkSetMacro(DepthTransmittance, double);
  vtkGetMacro(DepthTransmittance, double);
  ///@}

  ///@{
  /// On: Render draws nothing into the window but keeps its result for GetColorImage and GetDepthImage, which also
  /// work when this is off. Default: off.
  vtkSetMacro(RenderToImage, bool);
  vtkGetMacro(RenderToImage, bool);
  vtkBooleanMacro(RenderToImage, bool);
  ///@}

  /// The last frame as float RGBA, linear and premultiplied, a value for each eye ray (the viewport's size, by
  /// ImageSampleDistance), first row at the bottom. Outputs but Radiance: their value in R, G and B, with alpha 1
  /// where the ray has one, else all 0; Transmittance and OpticalDepth have one on every ray. An error, and `image`
  /// stays as it was, where there is none: before the first frame, after an aborted one, with depth peeling.
  void GetColorImage(vtkImageData* image);

  /// The window depth (0 near plane, 1 far) of the first point of the medium on each eye ray, else 1: one float
  /// for each ray; size, order and errors are those of GetColorImage.
  void GetDepthImage(vtkImageData* image);

  /// Counters and times of what the mapper did. Never null.
  vtkMediumStatistics* GetStatistics();

  /// Takes the settings of another mapper of this class, its medium, mask and input connection, not what it drew;
  /// of any other vtkVolumeMapper its input connection, blend mode, cropping, clipping planes and choice of
  /// scalars; of any other vtkAbstractMapper its clipping planes.
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  /// Draws a frame. Events: VolumeMapperRenderStartEvent; VolumeMapperRenderProgressEvent after each draw
  /// of a march that is integrated, with a pointer to the fraction done (double); VolumeMapperRenderEndEvent.
  /// After each draw CheckAbortStatus is asked: an aborted frame is not shown and leaves no image.
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;
  /// Gives back all that is held on the device, whichever window is named (null: nothing); the next frame builds
  /// it anew. VTK calls it when the window goes.
  void ReleaseGraphicsResources(vtkWindow* window) override;
  /// The latest of this object's, its medium's and its mask's modification times.
  vtkMTimeType GetMTime() override;

protected:
  vtkSingleScatteringVolumeMapper();
  ~vtkSingleScatteringVolumeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkSingleScatteringVolumeMapper(const vtkSingleScatteringVolumeMapper&) = delete;
  void operator=(const vtkSingleScatteringVolumeMapper&) = delete;

  // Each returns an empty string, or why the frame cannot be drawn right.
  std::string Draw(vtkRenderer* renderer, vtkVolume* volume);
  std::string CheckContract();
  void Report(const std::string& refusal);

  vtkSmartPointer<vtkImageData> MaskInput;
  vtkSmartPointer<vtkParticipatingMedium> Medium;
  double Anisotropy = 0;
  int PhaseFunction = HenyeyGreenstein;
  int Integrator = ErrorControlled;
  double MaximumError = 1.0 / 255;
  int LightCaches = CachesWhereAccurate;
  bool OpaqueShadows = false;
  int OpaqueShadowResolution = 1024;
  bool AutoAdjustSampleDistances = true;
  double ImageSampleDistance = 1;
  double SampleDistance = 0;
  double LightSampleDistance = 0;
  int BinarySearchIterations = 5;
  double Jitter = 0.2;
  double TransmittanceThreshold = 1.0 / 1024;
  double PaperThreshold = 0.5;
  bool AssumeConvex = false;
  int Output = Radiance;
  int DepthDefinition = FirstHitDepth;
  double DepthTransmittance = 0.5;
  bool RenderToImage = false;

  vtkSmartPointer<vtkMediumStatistics> Statistics;
  std::unique_ptr<vtkMediumRenderer> Drawing;
  std::string LastRefusal;
};

#endif
