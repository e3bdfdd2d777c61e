// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What cannot be drawn is refused by one error that names the value and the way out; the background
// stays, and the next valid frame is that of a fresh mapper.
#include "ClosedForms.h"

#include "vtkMatrix4x4.h"
#include "vtkOutputWindow.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"

#include <gtest/gtest.h>

#include <limits>

using namespace vtkMediumTest;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Counts the errors that VTK's other classes print.
class CountingWindow : public vtkOutputWindow
{
public:
  static CountingWindow* New();
  vtkTypeMacro(CountingWindow, vtkOutputWindow);
  void DisplayErrorText(const char* text) override { this->Errors.emplace_back(text); }
  void DisplayWarningText(const char*) override {}
  void DisplayText(const char*) override {}
  std::vector<std::string> Errors;
};
vtkStandardNewMacro(CountingWindow);

/// A valid scene that a test spoils and mends.
struct ValidScene : Scene
{
  explicit ValidScene(bool paper = false)
    : Scene(MakeBox(), 12)
  {
    this->Mapper->SetIntegrator(
      paper ? vtkSingleScatteringVolumeMapper::Paper : vtkSingleScatteringVolumeMapper::FixedStep);
    this->Renderer->SetBackground(0.2, 0.4, 0.6);
    this->AddBeam({ 0.3, -1, -0.2 });
  }
};

using Change = std::function<void(Scene&)>;

class BadInput : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Before = vtkOutputWindow::GetInstance();
    vtkOutputWindow::SetInstance(this->Other);
  }
  void TearDown() override { vtkOutputWindow::SetInstance(this->Before); }

  /// Spoils a scene: exactly one error with all of `words`, the background unchanged, frame after frame;
  /// then mends it: the frame of a fresh mapper.
  void ExpectRefusal(const std::vector<std::string>& words, const Change& spoil, const Change& mend,
    bool paper = false)
  {
    ValidScene scene(paper);
    scene.Volume->VisibilityOff();
    const std::vector<unsigned char> background = scene.RenderWindow();
    scene.Volume->VisibilityOn();
    spoil(scene);
    EXPECT_EQ(background, scene.RenderWindow());
    EXPECT_EQ(background, scene.RenderWindow()); // a cause that persists is reported once
    EXPECT_EQ(scene.Errors.size(), 1u);
    EXPECT_EQ(this->Other->Errors.size(), 0u)
      << (this->Other->Errors.empty() ? std::string() : this->Other->Errors[0]);
    for (const std::string& word : words)
    {
      const std::string said = scene.Errors.empty() ? std::string() : scene.Errors[0];
      EXPECT_NE(said.find(word), std::string::npos) << "'" << word << "' is not in: " << said;
    }
    mend(scene);
    ValidScene fresh(paper);
    EXPECT_EQ(fresh.Render().Values, scene.Render().Values);
    EXPECT_EQ(fresh.RenderWindow(), scene.RenderWindow());
    EXPECT_NE(background, scene.RenderWindow());
    EXPECT_LE(scene.Errors.size(), 1u);
    // The cause comes back: it is said again.
    spoil(scene);
    scene.RenderWindow();
    EXPECT_EQ(scene.Errors.size(), 2u);
  }

  vtkNew<CountingWindow> Other;
  vtkSmartPointer<vtkOutputWindow> Before;
};

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
    MendImage);
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
    MendImage, true);
}

TEST_F(BadInput, MoreThanFourComponentsAreRefused)
{
  for (bool property : { true, false })
  {
    ExpectRefusal(
      { "5" },
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
      });
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
    MendImage);
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
      [](Scene& scene) { scene.Mapper->SetPaperThreshold(0.5); }, true);
  }
}

TEST_F(BadInput, NegativeOrUnknownStepIsRefused)
{
  for (bool paper : { false, true })
  {
    for (double step : { -0.25, NaN, Infinity, -Infinity })
    {
      const std::string name = step == -0.25 ? "-0.25" : std::isnan(step) ? "nan" : "inf";
      ExpectRefusal(
        { name, "SetSampleDistance" },
        [step](Scene& scene) { scene.Mapper->SetSampleDistance(step); },
        [](Scene& scene) { scene.Mapper->SetSampleDistance(0); }, paper);
      ExpectRefusal(
        { name, "SetLightSampleDistance" },
        [step](Scene& scene) { scene.Mapper->SetLightSampleDistance(step); },
        [](Scene& scene) { scene.Mapper->SetLightSampleDistance(0); }, paper);
    }
  }
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
      [](Scene& scene) { scene.Mapper->SetJitter(0.2); }, true);
    ExpectRefusal(
      { name.str(), "SetTransmittanceThreshold", "[0, 1)" },
      [value](Scene& scene) { scene.Mapper->SetTransmittanceThreshold(value); },
      [](Scene& scene) { scene.Mapper->SetTransmittanceThreshold(1.0 / 1024); });
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
    true);
}

TEST_F(BadInput, OtherBlendModesAreRefused)
{
  ExpectRefusal(
    { "blend mode is 1", "SetBlendModeToComposite" },
    [](Scene& scene) { scene.Mapper->SetBlendModeToMaximumIntensity(); },
    [](Scene& scene) { scene.Mapper->SetBlendModeToComposite(); });
}

TEST_F(BadInput, CroppingPlanesThatAreNoneAreRefused)
{
  const Change mend = [](Scene& scene) { scene.Mapper->CroppingOff(); };
  for (double bad : { NaN, Infinity, -0.2 })
  {
    ExpectRefusal(
      { "Cropping along y", "-0.1", "lower plane first", "SetCroppingRegionPlanes" },
      [bad](Scene& scene) {
        scene.Mapper->CroppingOn();
        scene.Mapper->SetCroppingRegionPlanes(-0.3, 0.3, -0.1, bad, -0.3, 0.3);
      },
      mend);
  }
}

TEST_F(BadInput, ClippingPlanesThatAreNoneAreRefused)
{
  const Change mend = [](Scene& scene) { scene.Mapper->RemoveAllClippingPlanes(); };
  for (double bad : { NaN, Infinity, 0.0 })
  {
    ExpectRefusal(
      { "Clipping plane 0", "normal", "finite" },
      [bad](Scene& scene) {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(0, bad, 0);
        scene.Mapper->AddClippingPlane(plane);
      },
      mend);
  }
  ExpectRefusal(
    { "Clipping plane 1", "origin", "finite" },
    [](Scene& scene) {
      vtkNew<vtkPlane> good, plane;
      plane->SetOrigin(0, NaN, 0);
      scene.Mapper->AddClippingPlane(good);
      scene.Mapper->AddClippingPlane(plane);
    },
    mend);
  ExpectRefusal(
    { "vtkTransform", "SetTransform(nullptr)" },
    [](Scene& scene) {
      vtkNew<vtkPlane> plane;
      plane->SetTransform(vtkNew<vtkTransform>());
      scene.Mapper->AddClippingPlane(plane);
    },
    mend);
}

TEST_F(BadInput, MoreClippingPlanesThanCanBeHonouredAreRefused)
{
  ExpectRefusal(
    { "17 clipping planes", "16", "RemoveClippingPlane" },
    [](Scene& scene) {
      for (int i = 0; i < 20; ++i) // three of them touch nothing
      {
        vtkNew<vtkPlane> plane;
        plane->SetNormal(0, 0, 1);
        plane->SetOrigin(0, 0, -0.65 + 0.06 * i);
        scene.Mapper->AddClippingPlane(plane);
      }
    },
    [](Scene& scene) { scene.Mapper->RemoveAllClippingPlanes(); });
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
    [](Scene& scene) { scene.Volume->SetUserMatrix(nullptr); });
  ExpectRefusal(
    { "singular" },
    [](Scene& scene) {
      vtkSmartPointer<vtkImageData> image = MakeBox();
      image->SetSpacing(0.1, 0, 0.1);
      scene.Mapper->SetInputData(image);
    },
    MendImage);
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

TEST_F(BadInput, MasksThatDoNotFitAreRefused)
{
  const Change mend = [](Scene& scene) { scene.Mapper->SetMaskInput(nullptr); };
  const auto spoil = [](const glm::ivec3& points, int type, int components) {
    return [=](Scene& scene) {
      vtkNew<vtkImageData> mask;
      mask->SetDimensions(points.x, points.y, points.z);
      if (components > 0)
      {
        mask->AllocateScalars(type, components);
      }
      scene.Mapper->SetMaskInput(mask);
    };
  };
  ExpectRefusal({ "mask", "3 x 4 x 6", "3 x 4 x 5", "SetMaskInput" },
    spoil({ 3, 4, 6 }, VTK_UNSIGNED_CHAR, 1), mend);
  ExpectRefusal({ "mask", "float", "unsigned char" }, spoil({ 3, 4, 5 }, VTK_FLOAT, 1), mend);
  ExpectRefusal(
    { "mask", "2 components", "unsigned char" }, spoil({ 3, 4, 5 }, VTK_UNSIGNED_CHAR, 2), mend);
  ExpectRefusal({ "mask", "no scalars", "unsigned char" }, spoil({ 3, 4, 5 }, 0, 0), mend);
}
