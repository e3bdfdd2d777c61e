// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSingleScatteringReference
 * @brief The image of a participating medium on the CPU, in double precision, to a tolerance.
 *
 * What vtkSingleScatteringVolumeMapper approximates, this class computes: the radiance of single
 * scattering,
 *
 *     L = int T(t) [ sigma_e + sum_k sigma_s p(cos theta_k) E_k exp(-tau_k) ] dt
 *
 * to a given tolerance. It reads the scene as the mapper does (image, property or medium, matrix,
 * lights, camera; the meaning of each is documented there) and shares none of its formulas, so that
 * each can be held to the other. It needs no OpenGL and no window.
 *
 * @par Method
 * Each ray is cut at the cell faces of the grid, where a transfer function bends, at a light's nearest
 * point and at the edge of its cone. Each piece is integrated by Gauss-Legendre rules of 6 against 8
 * points and bisected until they agree. Optical depths are exact where the extinction is interpolated
 * from the data, since that is a cubic between cell faces. The agreement of two rules is an estimate:
 * on grids of 64^3 the error came out within 1.1 times a tolerance of 1e-9. A transfer function is the
 * mapper's table of 4096 straight intervals, and the tolerance is not met below the table's own
 * distance from a smooth function: 1e-8 of the peak where its curve is gentle, some 1e-7 where it is
 * steep. Positions have the resolution of a double, so an extinction of more than 1e7 a box is blurred.
 * Cropping and the clipping planes of the volume's mapper cut eye rays and light rays, to the same tolerance.
 * Opaque geometry is not seen.
 *
 * A ray is followed from next to the volume on, from however far away it comes; from n of the volume's
 * diagonals away its direction's last digit is n 1e-16 of a diagonal there. Refused are places beyond 1e150
 * diagonals, and media and lights whose optical depth, emission or scattered light may be beyond 1e290.
 *
 * Threaded with vtkSMPTools; the result does not depend on the number of threads.
 *
 * @par Parameters
 * | parameter | unit | range | default | meaning |
 * | --- | --- | --- | --- | --- |
 * | Tolerance | 1 | 1e-13 … 1 | 1e-9 | absolute error of the radiance, as a fraction of the peak |
 * | Anisotropy | 1 | -1 … 1 | 0 | mean cosine g of the phase function when no medium is set |
 * | ImageSize | pixels | >= 0 | 0, 0 | size of the image; 0: that of the renderer |
 * | PixelStride | pixels | >= 1 | 1 | only every so many pixels are computed along each axis |
 *
 * Events: StartEvent, ProgressEvent (its data is a pointer to the fraction that is done, a double)
 * and EndEvent, while GetColorImage runs. A cause that prevents a result is reported by one
 * vtkErrorMacro when a result is asked for, each time; setters report nothing.
 *
 * @sa vtkSingleScatteringVolumeMapper vtkParticipatingMedium
 */
#ifndef vtkSingleScatteringReference_h
#define vtkSingleScatteringReference_h

#include "vtkMediumCompatibility.h"
#include "vtkObject.h"
#include "vtkParticipatingMediumModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDoubleArray;
class vtkImageData;
class vtkLight;
class vtkPoints;
class vtkRenderer;
class vtkVolume;
VTK_ABI_NAMESPACE_END
class vtkParticipatingMedium;

class VTKPARTICIPATINGMEDIUM_EXPORT vtkSingleScatteringReference : public vtkObject
{
public:
  static vtkSingleScatteringReference* New();
  vtkTypeMacro(vtkSingleScatteringReference, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The grid. If none is set (default), it is the input of the volume's mapper. Where that is no vtkImageData
  /// either, has no scalars though no medium is set, or has fewer than two points along an axis: an error.
  void SetInputData(vtkImageData* input);
  vtkImageData* GetInputData();
  ///@}

  ///@{
  /// Where nothing is: as vtkSingleScatteringVolumeMapper::SetMaskInput documents it. Default: none.
  void SetMaskInput(vtkImageData* mask);
  vtkImageData* GetMaskInput();
  ///@}

  ///@{
  /// What fills the volume. If none is set (default), it is the volume's property.
  void SetMedium(vtkParticipatingMedium* medium);
  vtkParticipatingMedium* GetMedium();
  ///@}

  ///@{
  /// Its property and matrix are used and, when it has a mapper, the mapper's choice of the scalar
  /// array, its clipping planes and its cropping; their meaning is documented in
  /// vtkSingleScatteringVolumeMapper. If none is set: the identity, and a default property.
  void SetVolume(vtkVolume* volume);
  vtkVolume* GetVolume();
  ///@}

  ///@{
  /// Its lights and, for images, its active camera are used. As in a render, a renderer without lights
  /// has a headlight (unless AutomaticLightCreation is off), and head- and camera lights stand where
  /// the camera is now (unless LightFollowCamera is off). Needed for radiance, not for optical depth.
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /// The mean cosine g of Henyey and Greenstein's phase function, when no medium is set; -1 (back) to 1
  /// (forward), held at +-0.999. Outside [-1, 1], or NaN: an error, unless a medium is set. Default: 0.
  vtkSetMacro(Anisotropy, double);
  vtkGetMacro(Anisotropy, double);
  ///@}

  ///@{
  /// The largest error of the radiance, as a fraction of the peak; 1e-13 to 1, beyond which it is taken as
  /// the nearest of the two; NaN is an error. Default: 1e-9. The peak of an image is the largest radiance
  /// among 12 x 12 pixels that are estimated beforehand, so it is never above the image's true peak; that
  /// of a single ray is an estimate of its own radiance.
  vtkSetClampMacro(Tolerance, double, 1e-13, 1.0);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// Width and height of the image, pixels. When both are > 0, the camera's aspect ratio is width / height;
  /// else (0, 0 is the default) the renderer's size counts, and where it has no window that is an error.
  vtkSetVector2Macro(ImageSize, int);
  vtkGetVector2Macro(ImageSize, int);
  ///@}

  ///@{
  /// Compute only the pixels (i s, j s) of the full image, of a stride s from 1 to 2^20, beyond which it is taken
  /// as the nearest of the two. Default: 1, all.
  vtkSetClampMacro(PixelStride, int, 1, 1 << 20);
  vtkGetMacro(PixelStride, int);
  ///@}

  ///@{
  /// Set from an observer of ProgressEvent to stop GetColorImage, which then returns false. It is
  /// cleared when GetColorImage starts. Default: off.
  vtkSetMacro(AbortExecute, vtkTypeBool);
  vtkGetMacro(AbortExecute, vtkTypeBool);
  vtkBooleanMacro(AbortExecute, vtkTypeBool);
  ///@}

  /// Fills `image` with linear RGBA radiance, double, premultiplied: alpha is 1 - the mean of the three
  /// channels' transmittances. Pixel (i, j) is the ray through x = 2 (i + 1/2) / width - 1 and
  /// y = 2 (j + 1/2) / height - 1 of the viewport, from the near plane (or the eye) on. With a
  /// PixelStride s the image has ceil(width / s) x ceil(height / s) pixels and the spacing s. On error
  /// or abort returns false and leaves the image as it was.
  bool GetColorImage(vtkImageData* image);

  /// The radiance and alpha that arrive at `origin` (world) from `direction` (world, of any length
  /// > 0, pointing away from the eye), so along the whole ray origin + t direction, t >= 0. False, and
  /// zeros, on error.
  bool Radiance(const double origin[3], const double direction[3], double rgba[4]);

  ///@{
  /// The optical depth between two points (world): of the channels, or their mean. NaN on error.
  void OpticalDepth(const double a[3], const double b[3], double rgb[3]);
  double OpticalDepth(const double a[3], const double b[3]);
  ///@}

  ///@{
  /// The transmittance between two points (world): of the channels, or their mean. NaN on error.
  void Transmittance(const double a[3], const double b[3], double rgb[3]);
  double Transmittance(const double a[3], const double b[3]);
  ///@}

  /// The medium's shadow on geometry: fills `transmittance` with the transmittance of the medium between each
  /// point (world) and a light, a tuple of the three channels for each point, to the tolerance. Multiply a
  /// surface's share of that light by it. The light's colour, attenuation and cone are not in it, nor opaque
  /// geometry; a positional light shines from its position, whether it is on or not, and head- and camera
  /// lights stand as for an image. An array without a name gets the name LightTransmittance. Threaded. On
  /// error (a missing argument, a light without a place, what prevents an image) returns false and leaves
  /// the array as it was.
  bool LightTransmittance(vtkLight* light, vtkPoints* points, vtkDoubleArray* transmittance);

  /// The latest modification time of this object and of everything that a result depends on: the input, mask
  /// and medium, the volume with its matrix, property, mapper and clipping planes, the renderer with its camera
  /// and lights.
  vtkMTimeType GetMTime() override;

protected:
  vtkSingleScatteringReference();
  ~vtkSingleScatteringReference() override;

private:
  vtkSingleScatteringReference(const vtkSingleScatteringReference&) = delete;
  void operator=(const vtkSingleScatteringReference&) = delete;

  vtkImageData* FindInput();
  std::string CheckTolerance() const;
  std::string GatherMedium();
  std::string GatherLights();
  std::string GatherView(int size[2]);
  std::string FindPlace(const double world[3], double local[3]) const;
  bool Gather(bool lights);
  double EstimatePeak(const int size[2]);

  vtkSmartPointer<vtkImageData> InputData;
  vtkSmartPointer<vtkImageData> MaskInput;
  vtkSmartPointer<vtkParticipatingMedium> Medium;
  vtkSmartPointer<vtkVolume> Volume;
  vtkSmartPointer<vtkRenderer> Renderer;
  double Anisotropy = 0;
  double Tolerance = 1e-9;
  int ImageSize[2] = { 0, 0 };
  int PixelStride = 1;
  vtkTypeBool AbortExecute = false;

  struct Gathered;
  std::unique_ptr<Gathered> Scene;
};

#endif
