// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkParticipatingMedium
 * @brief What fills a volume: extinction, albedo, emission and phase function, in physical units.
 *
 * A medium weakens light by its extinction sigma_t = sigma_a + sigma_s, of which the albedo
 * sigma_s / sigma_t is scattered and the rest absorbed; it may glow by itself; and its phase
 * function says where scattered light goes. It is stated either as extinction and albedo (the
 * default), or as absorption and scattering; the other two coefficients are then not looked at.
 *
 * With nothing set, the medium is homogeneous: extinction 1, albedo 1, no emission, isotropic. Only
 * where an array is named or a function is set do the arrays of the input image matter.
 *
 * @par Coefficients
 * Extinction, Absorption, Scattering, Albedo and Emission (X below) are each one of
 * - a constant, grey or RGB: SetX;
 * - an array of the image, times XScale: SetXArrayName. The name is looked up in the point data,
 *   then in the cell data; the empty name "" is the scalars that the mapper has chosen; NULL (None
 *   in Python, the default) goes back to the constant;
 * - a transfer function of one component of that array, or of the scalars where none is named,
 *   times XScale: SetXFunction (grey) or SetXColorFunction (RGB). Setting one of the two clears the
 *   other; NULL takes it away and leaves the other, so that without either the array or the constant
 *   counts again.
 *
 * XScale, a factor for each channel, counts where there is an array or a function, is finite and >= 0,
 * 1 by default, and what comes of the product is in the range of the quantity. It does not scale
 * a constant.
 *
 * @par Components
 * An array has 1 to 4 components. With XComponent at -1 (the default) they mean what they mean to a
 * vtkVolumeProperty of dependent components:
 * | components | Albedo, Scattering, Emission | Extinction, Absorption |
 * | --- | --- | --- |
 * | 1 | grey | grey |
 * | 2 | grey, from the first | grey, from the second |
 * | 3 | RGB | RGB |
 * | 4 | RGB, from the first three | grey, from the fourth |
 *
 * XComponent from 0 on picks one component as a grey value; one that the array does not have, or below
 * -1, is an error. A function reads one component: XComponent, or the first (Extinction and Absorption:
 * the last).
 *
 * @par Units
 * | quantity | unit | range |
 * | --- | --- | --- |
 * | Extinction, Absorption, Scattering | 1 / length unit | >= 0 |
 * | Albedo | 1 | 0 to 1 |
 * | Emission | radiance / length unit | >= 0 |
 * | Anisotropy | 1 | -1 to 1; beyond +-0.999 taken as +-0.999 |
 *
 * The length unit is LengthUnit world units long, so in an image in millimetres a LengthUnit of
 * 1000 makes the coefficients those per metre. DensityScale multiplies extinction, absorption,
 * scattering and emission.
 *
 * Values are checked when the medium is rendered, those that its parametrization and its phase function
 * use. A value out of range, a NaN, a missing array or a wrong number of components is reported in one
 * error that names it, and nothing is drawn. Only Parametrization and PhaseFunction are held in their range
 * as they are set: a number that names none is taken as the nearest that does.
 *
 * @sa vtkSingleScatteringVolumeMapper vtkSingleScatteringReference
 */
#ifndef vtkParticipatingMedium_h
#define vtkParticipatingMedium_h

#include "vtkMediumCompatibility.h"
#include "vtkObject.h"
#include "vtkParticipatingMediumModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkColorTransferFunction;
class vtkDoubleArray;
class vtkPiecewiseFunction;
VTK_ABI_NAMESPACE_END

class VTKPARTICIPATINGMEDIUM_EXPORT vtkParticipatingMedium : public vtkObject
{
public:
  static vtkParticipatingMedium* New();
  vtkTypeMacro(vtkParticipatingMedium, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The latest of this object's, its functions' and its phase table's modification times.
  vtkMTimeType GetMTime() override;

  enum Parametrizations
  {
    ExtinctionAndAlbedo,
    AbsorptionAndScattering,
  };

  ///@{
  /// Which two coefficients state the medium; clamped to those two. Default: ExtinctionAndAlbedo.
  vtkSetClampMacro(Parametrization, int, ExtinctionAndAlbedo, AbsorptionAndScattering);
  vtkGetMacro(Parametrization, int);
  void SetParametrizationToExtinctionAndAlbedo() { this->SetParametrization(ExtinctionAndAlbedo); }
  void SetParametrizationToAbsorptionAndScattering()
  {
    this->SetParametrization(AbsorptionAndScattering);
  }
  ///@}

  ///@{
  /// Extinction sigma_t: what is lost of a beam per length, to absorption and scattering together.
  /// In ExtinctionAndAlbedo. Default: 1, constant; scale 1.
  void SetExtinction(double grey) { this->SetExtinction(grey, grey, grey); }
  void SetExtinction(double r, double g, double b);
  double* GetExtinction() VTK_SIZEHINT(3);
  void SetExtinctionArrayName(const char* name);
  const char* GetExtinctionArrayName();
  void SetExtinctionComponent(int component);
  int GetExtinctionComponent();
  void SetExtinctionScale(double grey) { this->SetExtinctionScale(grey, grey, grey); }
  void SetExtinctionScale(double r, double g, double b);
  double* GetExtinctionScale() VTK_SIZEHINT(3);
  void SetExtinctionFunction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetExtinctionFunction();
  void SetExtinctionColorFunction(vtkColorTransferFunction* function);
  vtkColorTransferFunction* GetExtinctionColorFunction();
  ///@}

  ///@{
  /// Albedo sigma_s / sigma_t: which part of the extinction is scattering. In ExtinctionAndAlbedo.
  /// Default: 1, constant; scale 1.
  void SetAlbedo(double grey) { this->SetAlbedo(grey, grey, grey); }
  void SetAlbedo(double r, double g, double b);
  double* GetAlbedo() VTK_SIZEHINT(3);
  void SetAlbedoArrayName(const char* name);
  const char* GetAlbedoArrayName();
  void SetAlbedoComponent(int component);
  int GetAlbedoComponent();
  void SetAlbedoScale(double grey) { this->SetAlbedoScale(grey, grey, grey); }
  void SetAlbedoScale(double r, double g, double b);
  double* GetAlbedoScale() VTK_SIZEHINT(3);
  void SetAlbedoFunction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetAlbedoFunction();
  void SetAlbedoColorFunction(vtkColorTransferFunction* function);
  vtkColorTransferFunction* GetAlbedoColorFunction();
  ///@}

  ///@{
  /// Absorption sigma_a: what is lost of a beam per length to absorption. In
  /// AbsorptionAndScattering. Default: 0, constant; scale 1.
  void SetAbsorption(double grey) { this->SetAbsorption(grey, grey, grey); }
  void SetAbsorption(double r, double g, double b);
  double* GetAbsorption() VTK_SIZEHINT(3);
  void SetAbsorptionArrayName(const char* name);
  const char* GetAbsorptionArrayName();
  void SetAbsorptionComponent(int component);
  int GetAbsorptionComponent();
  void SetAbsorptionScale(double grey) { this->SetAbsorptionScale(grey, grey, grey); }
  void SetAbsorptionScale(double r, double g, double b);
  double* GetAbsorptionScale() VTK_SIZEHINT(3);
  void SetAbsorptionFunction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetAbsorptionFunction();
  void SetAbsorptionColorFunction(vtkColorTransferFunction* function);
  vtkColorTransferFunction* GetAbsorptionColorFunction();
  ///@}

  ///@{
  /// Scattering sigma_s: what is scattered out of a beam per length. In AbsorptionAndScattering.
  /// Default: 1, constant; scale 1.
  void SetScattering(double grey) { this->SetScattering(grey, grey, grey); }
  void SetScattering(double r, double g, double b);
  double* GetScattering() VTK_SIZEHINT(3);
  void SetScatteringArrayName(const char* name);
  const char* GetScatteringArrayName();
  void SetScatteringComponent(int component);
  int GetScatteringComponent();
  void SetScatteringScale(double grey) { this->SetScatteringScale(grey, grey, grey); }
  void SetScatteringScale(double r, double g, double b);
  double* GetScatteringScale() VTK_SIZEHINT(3);
  void SetScatteringFunction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetScatteringFunction();
  void SetScatteringColorFunction(vtkColorTransferFunction* function);
  vtkColorTransferFunction* GetScatteringColorFunction();
  ///@}

  ///@{
  /// Emission sigma_e: the radiance that the medium itself adds per length, with or without lights.
  /// Default: 0, constant; scale 1.
  void SetEmission(double grey) { this->SetEmission(grey, grey, grey); }
  void SetEmission(double r, double g, double b);
  double* GetEmission() VTK_SIZEHINT(3);
  void SetEmissionArrayName(const char* name);
  const char* GetEmissionArrayName();
  void SetEmissionComponent(int component);
  int GetEmissionComponent();
  void SetEmissionScale(double grey) { this->SetEmissionScale(grey, grey, grey); }
  void SetEmissionScale(double r, double g, double b);
  double* GetEmissionScale() VTK_SIZEHINT(3);
  void SetEmissionFunction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetEmissionFunction();
  void SetEmissionColorFunction(vtkColorTransferFunction* function);
  vtkColorTransferFunction* GetEmissionColorFunction();
  ///@}

  ///@{
  /// Anisotropy g of the phase functions that have one, -1 (back) to 1 (forward): a constant, one
  /// component of an array (the only one, or AnisotropyComponent), or a function of it. Beyond +-0.999 it is
  /// taken as that; beyond +-1, or NaN: an error at the next Render. It has no scale. Default: 0.
  void SetAnisotropy(double g);
  double GetAnisotropy();
  void SetAnisotropyArrayName(const char* name);
  const char* GetAnisotropyArrayName();
  void SetAnisotropyComponent(int component);
  int GetAnisotropyComponent();
  void SetAnisotropyFunction(vtkPiecewiseFunction* function);
  vtkPiecewiseFunction* GetAnisotropyFunction();
  ///@}

  ///@{
  /// Multiplies extinction, absorption, scattering and emission; finite and >= 0. Default: 1.
  vtkSetMacro(DensityScale, double);
  vtkGetMacro(DensityScale, double);
  ///@}

  ///@{
  /// The length of the unit in which the coefficients are given, in world units; finite and > 0.
  /// Default: 1.
  vtkSetMacro(LengthUnit, double);
  vtkGetMacro(LengthUnit, double);
  ///@}

  /// The phase functions; each integrates to 1 over the sphere.
  enum PhaseFunctions
  {
    Isotropic,              ///< 1 / 4 pi
    Schlick,                ///< of k = 1.55 g - 0.55 g^3, g the Anisotropy; |k| is held at 0.999
    HenyeyGreenstein,       ///< of mean cosine Anisotropy
    DoubleHenyeyGreenstein, ///< ForwardWeight of Anisotropy's lobe, the rest of BackAnisotropy's
    Rayleigh,               ///< 3 / 16 pi (1 + cos^2)
    Draine,                 ///< of g = Anisotropy and DraineAlpha
    Tabulated,              ///< PhaseTable
    Droplets,               ///< fog and cloud of DropletDiameter
    SchlickK,               ///< Schlick's, with Anisotropy as k itself
  };

  ///@{
  /// The phase function; clamped to those above. Default: HenyeyGreenstein, which is isotropic at the
  /// default Anisotropy, 0. The mapper's Paper integrator takes Schlick's in any case.
  vtkSetClampMacro(PhaseFunction, int, Isotropic, SchlickK);
  vtkGetMacro(PhaseFunction, int);
  void SetPhaseFunctionToIsotropic() { this->SetPhaseFunction(Isotropic); }
  void SetPhaseFunctionToSchlick() { this->SetPhaseFunction(Schlick); }
  void SetPhaseFunctionToHenyeyGreenstein() { this->SetPhaseFunction(HenyeyGreenstein); }
  void SetPhaseFunctionToDoubleHenyeyGreenstein()
  {
    this->SetPhaseFunction(DoubleHenyeyGreenstein);
  }
  void SetPhaseFunctionToRayleigh() { this->SetPhaseFunction(Rayleigh); }
  void SetPhaseFunctionToDraine() { this->SetPhaseFunction(Draine); }
  void SetPhaseFunctionToTabulated() { this->SetPhaseFunction(Tabulated); }
  void SetPhaseFunctionToDroplets() { this->SetPhaseFunction(Droplets); }
  void SetPhaseFunctionToSchlickK() { this->SetPhaseFunction(SchlickK); }
  ///@}

  ///@{
  /// g of the second lobe of DoubleHenyeyGreenstein, -1 to 1; beyond +-0.999 taken as that. Default: -0.5.
  vtkSetMacro(BackAnisotropy, double);
  vtkGetMacro(BackAnisotropy, double);
  ///@}

  ///@{
  /// Weight of the first lobe of DoubleHenyeyGreenstein, 0 to 1. Default: 0.5.
  vtkSetMacro(ForwardWeight, double);
  vtkGetMacro(ForwardWeight, double);
  ///@}

  ///@{
  /// alpha of Draine's function, 0 to 1e30: 0 is Henyey-Greenstein, 1 Cornette-Shanks (with
  /// g = 0, Rayleigh). Default: 1.
  vtkSetMacro(DraineAlpha, double);
  vtkGetMacro(DraineAlpha, double);
  ///@}

  ///@{
  /// Diameter of the water droplets of Droplets, micrometres, 5 to 50: the range of the fit to Mie
  /// theory by Jendersie and d'Eon (2023), doi:10.1145/3587421.3595409. Default: 20.
  vtkSetMacro(DropletDiameter, double);
  vtkGetMacro(DropletDiameter, double);
  ///@}

  ///@{
  /// The table of Tabulated: at least two values per steradian, finite and >= 0, at equally spaced
  /// cosines from -1 (back) to 1 (forward), linear in between. 2 pi times the integral over the
  /// cosine must be 1 within 1e-3. One component. Default: none.
  void SetPhaseTable(vtkDoubleArray* table);
  vtkDoubleArray* GetPhaseTable();
  ///@}

  /// Takes all values of another medium, and shares its functions and its phase table. Of NULL, or of itself:
  /// nothing happens.
  void ShallowCopy(vtkParticipatingMedium* other);

#ifndef __VTK_WRAP__
  /// Where a coefficient comes from, as set above.
  struct Source
  {
    std::array<double, 3> Value{ { 0, 0, 0 } };
    std::array<double, 3> Scale{ { 1, 1, 1 } };
    bool HasArray = false;
    std::string ArrayName;
    int Component = -1;
    vtkSmartPointer<vtkPiecewiseFunction> Function;
    vtkSmartPointer<vtkColorTransferFunction> ColorFunction;
  };

  enum Coefficients
  {
    ExtinctionCoefficient,
    AlbedoCoefficient,
    AbsorptionCoefficient,
    ScatteringCoefficient,
    EmissionCoefficient,
    AnisotropyCoefficient,
    NumberOfCoefficients,
  };

  const Source& GetSource(Coefficients coefficient) const
  {
    return this->Sources[coefficient];
  }
#endif

protected:
  vtkParticipatingMedium();
  ~vtkParticipatingMedium() override;

private:
  vtkParticipatingMedium(const vtkParticipatingMedium&) = delete;
  void operator=(const vtkParticipatingMedium&) = delete;

#ifndef __VTK_WRAP__
  void Assign(std::array<double, 3>& target, double r, double g, double b);
  void AssignArrayName(Source& source, const char* name);
  void AssignFunction(Source& source, vtkPiecewiseFunction* function);
  void AssignColorFunction(Source& source, vtkColorTransferFunction* function);

  std::array<Source, NumberOfCoefficients> Sources;
#endif
  int Parametrization = ExtinctionAndAlbedo;
  double DensityScale = 1;
  double LengthUnit = 1;
  int PhaseFunction = HenyeyGreenstein;
  double BackAnisotropy = -0.5;
  double ForwardWeight = 0.5;
  double DraineAlpha = 1;
  double DropletDiameter = 20;
  vtkSmartPointer<vtkDoubleArray> PhaseTable;
};

#endif
