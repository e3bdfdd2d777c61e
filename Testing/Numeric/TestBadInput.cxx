// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What cannot be drawn is refused by one error that names the value and the way out; the background
// stays, and the next valid frame is that of a fresh mapper.
#include "BadInput.h"

#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"

using namespace vtkMediumTest;

namespace
{
const Change MendImage = [](Scene& scene) { scene.Mapper->SetInputData(MakeBox()); };
}

TEST_F(BadInput, NotAnImageIsRefused)
{
  ExpectRefusal(
    { "vtkPolyData", "vtkImageData" },
    [](Scene& scene) {
      vtkNew<vtkPolyData> surface;
      scene.Mapper->SetInputDataObject(surface);
    },
    MendImage, AllIntegrators);
}

TEST_F(BadInput, ImageWithoutScalarsIsRefused)
{
  ExpectRefusal(
    { "no scalars", "SetScalars" },
    [](Scene& scene) {
      vtkNew<vtkImageData> image;
      image->SetDimensions(4, 4, 4);
      scene.Mapper->SetInputData(image);
      scene.Mapper->SetMedium(nullptr);
    },
    [](Scene& scene) {
      MendImage(scene);
      scene.Mapper->SetMedium(scene.Medium);
    });
  ExpectRefusal(
    { "no scalars" },
    [](Scene& scene) {
      vtkNew<vtkImageData> image;
      image->SetDimensions(4, 4, 4);
      scene.Mapper->SetInputData(image);
    },
    MendImage, OnlyPaper);
}

TEST_F(BadInput, MoreThanFourComponentsAreRefused)
{
  for (bool property : { true, false })
  {
    ExpectRefusal(
      { "5 components", property ? "pick an array of one component" : "give an array of 1 to 4" },
      [property](Scene& scene) {
        vtkNew<vtkImageData> image;
        image->SetDimensions(4, 4, 4);
        image->AllocateScalars(VTK_UNSIGNED_CHAR, 5);
        std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 5 * 64, 1);
        scene.Mapper->SetInputData(image);
        scene.Mapper->SetMedium(property ? nullptr : scene.Medium.Get());
        scene.Medium->SetExtinctionArrayName("");
      },
      [](Scene& scene) {
        MendImage(scene);
        scene.Mapper->SetMedium(scene.Medium);
        scene.Medium->SetExtinctionArrayName(nullptr);
      },
      property ? AllIntegrators : AllButPaper);
  }
}

TEST_F(BadInput, FlatExtentIsRefused)
{
  ExpectRefusal(
    { "0..0", "two points" },
    [](Scene& scene) {
      scene.Mapper->SetInputData(
        MakeImage({ 4, 4, 2 }, glm::dvec3(1), [](const glm::dvec3&) { return 1.0; }));
      vtkImageData* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataObjectInput());
      image->SetDimensions(4, 4, 1);
      image->AllocateScalars(VTK_FLOAT, 1);
    },
    MendImage, AllIntegrators);
}

TEST_F(BadInput, ThresholdThatNothingPassesIsRefused)
{
  for (double threshold : { 1.5, Infinity, NaN })
  {
    ExpectRefusal(
      { "threshold",
        threshold == 1.5          ? "1.5"
          : std::isnan(threshold) ? "nan"
                                  : "inf",
        "SetPaperThreshold" },
      [threshold](Scene& scene) { scene.Mapper->SetPaperThreshold(threshold); },
      [](Scene& scene) { scene.Mapper->SetPaperThreshold(0.5); }, OnlyPaper);
  }
}

TEST_F(BadInput, NegativeOrUnknownStepIsRefused)
{
  for (double step : { -0.25, NaN, Infinity, -Infinity })
  {
    const std::string name = step == -0.25 ? "-0.25" : std::isnan(step) ? "nan" : "inf";
    ExpectRefusal(
      { name, "SetSampleDistance" },
      [step](Scene& scene) { scene.Mapper->SetSampleDistance(step); },
      [](Scene& scene) { scene.Mapper->SetSampleDistance(0); }, AllIntegrators);
    ExpectRefusal(
      { name, "SetLightSampleDistance" },
      [step](Scene& scene) { scene.Mapper->SetLightSampleDistance(step); },
      [](Scene& scene) { scene.Mapper->SetLightSampleDistance(0); }, AllIntegrators);
  }
}

// Clamping lets NaN through.
TEST_F(BadInput, UnknownImageSampleDistanceIsRefused)
{
  ExpectRefusal(
    { "nan", "SetImageSampleDistance", "1 to 10" },
    [](Scene& scene) { scene.Mapper->SetImageSampleDistance(NaN); },
    [](Scene& scene) { scene.Mapper->SetImageSampleDistance(1); }, AllIntegrators);
}

TEST_F(BadInput, MissingImagesAreNotFilled)
{
  ValidScene scene;
  const Picture valid = scene.Render();
  scene.Mapper->GetColorImage(nullptr);
  scene.Mapper->GetDepthImage(nullptr);
  ASSERT_EQ(scene.Errors.size(), 2u);
  for (const std::string& error : scene.Errors)
  {
    EXPECT_NE(error.find("give a vtkImageData"), std::string::npos) << error;
  }
  EXPECT_EQ(scene.Render().Values, valid.Values);
}

TEST_F(BadInput, ZeroStepIsOneVoxel)
{
  ValidScene scene;
  const Picture zero = scene.Render();
  scene.SetSteps(0.25, 0.25); // the shortest edge of a voxel of MakeBox
  EXPECT_EQ(zero.Values, scene.Render().Values);
  EXPECT_EQ(scene.Errors.size(), 0u);
}

TEST_F(BadInput, FractionsOutsideTheirIntervalAreRefused)
{
  for (double value : { -0.125, 1.0, 7.5, NaN })
  {
    std::ostringstream name;
    name << value;
    ExpectRefusal(
      { name.str(), "SetJitter", "[0, 1)" },
      [value](Scene& scene) { scene.Mapper->SetJitter(value); },
      [](Scene& scene) { scene.Mapper->SetJitter(0.2); }, AllIntegrators);
    ExpectRefusal(
      { name.str(), "SetTransmittanceThreshold", "[0, 1)" },
      [value](Scene& scene) { scene.Mapper->SetTransmittanceThreshold(value); },
      [](Scene& scene) { scene.Mapper->SetTransmittanceThreshold(1.0 / 1024); }, AllIntegrators);
  }
}

TEST_F(BadInput, AnisotropyBeyondOneIsRefused)
{
  for (double value : { -1.5, 1.5, NaN })
  {
    std::ostringstream name;
    name << value;
    ExpectRefusal(
      { name.str(), "nisotropy" }, [value](Scene& scene) { scene.Medium->SetAnisotropy(value); },
      [](Scene& scene) { scene.Medium->SetAnisotropy(0); });
    ExpectRefusal(
      { name.str(), "nisotropy" },
      [value](Scene& scene) {
        scene.Mapper->SetMedium(nullptr);
        scene.Mapper->SetAnisotropy(value);
      },
      [](Scene& scene) { scene.Mapper->SetMedium(scene.Medium); });
  }
}

TEST_F(BadInput, PaperWithoutLightIsRefused)
{
  ExpectRefusal(
    { "light", "vtkLight" }, [](Scene& scene) { scene.Renderer->RemoveAllLights(); },
    [](Scene& scene) {
      scene.AddBeam({ 0.3, -1, -0.2 });
    },
    OnlyPaper);
}

TEST_F(BadInput, OtherBlendModesAreRefused)
{
  const std::pair<int, const char*> modes[] = {
    { vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, "maximum intensity" },
    { vtkVolumeMapper::MINIMUM_INTENSITY_BLEND, "minimum intensity" },
    { vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, "average intensity" },
    { vtkVolumeMapper::ISOSURFACE_BLEND, "isosurface" },
    { vtkVolumeMapper::SLICE_BLEND, "slice" },
  };
  for (const auto& [mode, name] : modes)
  {
    ExpectRefusal(
      { name, "SetBlendModeToComposite", "SetBlendModeToAdditive" },
      [mode = mode](Scene& scene) { scene.Mapper->SetBlendMode(mode); },
      [](Scene& scene) { scene.Mapper->SetBlendModeToComposite(); }, AllIntegrators);
  }
}

TEST_F(BadInput, GradientsThatNoMediumKnowsAreRefused)
{
  auto mend = [](Scene& scene) {
    scene.Mapper->SetMedium(scene.Medium);
    scene.Property->DisableGradientOpacityOn();
  };
  ExpectRefusal(
    { "gradient opacity", "DisableGradientOpacityOn" },
    [](Scene& scene) {
      vtkNew<vtkPiecewiseFunction> edges;
      edges->AddPoint(0, 0);
      edges->AddPoint(1, 1);
      scene.Property->SetGradientOpacity(edges);
      scene.Property->DisableGradientOpacityOff();
      scene.Mapper->SetMedium(nullptr);
    },
    mend);
  ExpectRefusal(
    { "two-dimensional", "TF_1D" },
    [](Scene& scene) {
      scene.Property->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
      scene.Mapper->SetMedium(nullptr);
    },
    mend);
}

TEST_F(BadInput, SingularMatrixIsRefused)
{
  ExpectRefusal(
    { "singular" },
    [](Scene& scene) {
      vtkNew<vtkMatrix4x4> flat;
      flat->SetElement(2, 2, 0);
      scene.Volume->SetUserMatrix(flat);
    },
    [](Scene& scene) { scene.Volume->SetUserMatrix(nullptr); }, AllIntegrators);
  ExpectRefusal(
    { "singular" },
    [](Scene& scene) {
      vtkSmartPointer<vtkImageData> image = MakeBox();
      image->SetSpacing(0.1, 0, 0.1);
      scene.Mapper->SetInputData(image);
    },
    MendImage, AllIntegrators);
}

TEST_F(BadInput, LightsWithoutMeaningAreRefused)
{
  auto first = [](Scene& scene) {
    scene.Renderer->RemoveAllLights();
    return scene.AddBeam({ 0.3, -1, -0.2 });
  };
  const Change mend = [first](Scene& scene) { first(scene); };
  ExpectRefusal(
    { "-2" }, [first](Scene& scene) { first(scene)->SetIntensity(-2); }, mend);
  ExpectRefusal(
    { "nan" }, [first](Scene& scene) { first(scene)->SetIntensity(NaN); }, mend);
  ExpectRefusal(
    { "focal point" }, [first](Scene& scene) { first(scene)->SetPosition(0, 0, 0); }, mend);
  ExpectRefusal(
    { "attenuation" },
    [first](Scene& scene) {
      vtkSmartPointer<vtkLight> light = first(scene);
      light->SetPositional(true);
      light->SetAttenuationValues(0, 0, 0);
    },
    mend);
}
