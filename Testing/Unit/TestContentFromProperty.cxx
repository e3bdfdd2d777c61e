// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// A volume property as a medium: sigma_t = -ln(1 - alpha) / unit distance, colour = albedo.
#include "MediumInput.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
// 4096 intervals over the scalars' range, as the function table has: with scalars of 0 to 4096,
// whole numbers are samples and need no interpolation.
constexpr int Last = 4096;

// A row of voxels with the scalars 0 to 4096.
struct RampInput : MediumInput
{
  RampInput()
    : MediumInput(Last + 1, 2, 2)
  {
    this->Scalars = this->Add("ramp", 1, [](vtkIdType i, int) { return double(i % (Last + 1)); });
  }
};
}

TEST(ContentFromProperty, OpacityIsWhatTheUnitDistanceAbsorbs)
{
  for (double unit : { 0.01, 1.0, 250.0 })
  {
    RampInput input;
    vtkPiecewiseFunction* opacity = input.Property->GetScalarOpacity();
    opacity->AddPoint(0, 0);
    opacity->AddPoint(Last, 1);
    input.Property->SetScalarOpacityUnitDistance(unit);
    ASSERT_EQ(input.GatherProperty(), "");
    EXPECT_FALSE(input.Scene.Content.ChromaticExtinction);
    for (int s : { 0, 1, 100, 2048, 4000, 4095 })
    {
      const double sigma = input.AtPoint(s, 0, 0).Extinction.g;
      EXPECT_NEAR(1 - std::exp(-sigma * unit), s / double(Last), 1e-12) << s;
    }
    EXPECT_EQ(input.AtPoint(0, 0, 0).Extinction.r, 0);
  }
}

TEST(ContentFromProperty, OpacityOneIsClampedToTheLargestFloatBelow)
{
  RampInput input;
  input.Property->GetScalarOpacity()->AddPoint(0, 1);
  input.Property->SetScalarOpacityUnitDistance(2);
  ASSERT_EQ(input.GatherProperty(), "");
  EXPECT_NEAR(input.AtPoint(7, 0, 0).Extinction.r, 24 * std::log(2.0) / 2, 1e-6);
}

TEST(ContentFromProperty, ThinOpacityKeepsItsRelativeAccuracy)
{
  RampInput input;
  input.Property->GetScalarOpacity()->AddPoint(0, 1e-12);
  ASSERT_EQ(input.GatherProperty(), "");
  EXPECT_NEAR(input.AtPoint(7, 0, 0).Extinction.r / 1e-12, 1, 1e-10);
}

TEST(ContentFromProperty, AlbedoIsVTKsColourInEveryColourSpaceAndScale)
{
  for (int space : { VTK_CTF_RGB, VTK_CTF_HSV, VTK_CTF_LAB, VTK_CTF_DIVERGING,
         VTK_CTF_LAB_CIEDE2000, VTK_CTF_STEP })
  {
    for (int scale : { VTK_CTF_LINEAR, VTK_CTF_LOG10 })
    {
      RampInput input;
      vtkColorTransferFunction* color = input.Property->GetRGBTransferFunction();
      color->RemoveAllPoints();
      color->SetColorSpace(space);
      color->SetScale(scale);
      color->AddRGBPoint(1, 0.9, 0.1, 0.2);
      color->AddRGBPoint(300, 0.2, 0.8, 0.3, 0.3, 0.4);
      color->AddRGBPoint(4096, 0.1, 0.3, 0.7);
      input.Property->GetScalarOpacity()->AddPoint(0, 0.5);
      ASSERT_EQ(input.GatherProperty(), "");
      // CIEDE2000 takes VTK 30 ms a colour, so few are compared; it rounds them to 1/255, and where
      // it jumps an interpolated table may be on either side.
      const bool slow = space == VTK_CTF_LAB_CIEDE2000;
      for (int s : { 1, 150, 1000, 10, 299, 300, 301, 2500, 4095 })
      {
        if (slow && s != 1 && s != 150 && s != 1000)
        {
          continue;
        }
        const auto found = input.AtPoint(s, 0, 0);
        double expected[3];
        color->GetColor(s, expected);
        for (int c = 0; c < 3; ++c)
        {
          EXPECT_NEAR(
            found.Scattering[c] / found.Extinction[c], expected[c], slow ? 1.01 / 255 : 1e-9)
            << "space " << space << " scale " << scale << " scalar " << s;
        }
      }
    }
  }
}

TEST(ContentFromProperty, AChangedColourFunctionIsSampledAnew)
{
  RampInput input;
  input.Property->GetScalarOpacity()->AddPoint(0, 0.5);
  vtkColorTransferFunction* color = input.Property->GetRGBTransferFunction();
  const auto albedo = [&]() {
    EXPECT_EQ(
      input.Scene.GatherVolume(input.Image, input.Scalars, false, input.Volume, nullptr, 0), "");
    const auto found = input.AtPoint(1024, 0, 0);
    return found.Scattering.g / found.Extinction.g;
  };
  EXPECT_NEAR(albedo(), 1, 1e-12);
  color->AddRGBPoint(0, 0.25, 0.25, 0.25);
  EXPECT_NEAR(albedo(), 0.25, 1e-12);
  EXPECT_NEAR(albedo(), 0.25, 1e-12);
  input.Scalars->SetComponent(0, 0, -4096); // another range
  input.Scalars->Modified();
  color->AddRGBPoint(2048, 0.75, 0.75, 0.75);
  EXPECT_NEAR(albedo(), 0.5, 1e-12);
  for (int i = 0; i < 20; ++i)
  {
    color->AddRGBPoint(0, 0.02 * i, 0.02 * i, 0.02 * i);
    EXPECT_NEAR(albedo(), 0.5 * (0.02 * i + 0.75), 1e-12);
  }
}

TEST(ContentFromProperty, MidpointAndSharpnessOfTheOpacityAreVTKs)
{
  RampInput input;
  vtkPiecewiseFunction* opacity = input.Property->GetScalarOpacity();
  opacity->AddPoint(0, 0.1, 0.25, 0.6);
  opacity->AddPoint(2000, 0.9, 0.5, 1);
  opacity->AddPoint(4096, 0.2);
  ASSERT_EQ(input.GatherProperty(), "");
  for (int s = 0; s < Last; s += 61)
  {
    const double expected = -std::log1p(-opacity->GetValue(s));
    EXPECT_NEAR(input.AtPoint(s, 0, 0).Extinction.r, expected, 1e-12) << s;
  }
  // Nodes inside the range, and the midpoints (500 and 3048) where the curve bends or jumps.
  EXPECT_EQ(input.Scene.Content.Functions[0].GetKnots(), (std::vector<double>{ 500, 2000, 3048 }));
}

TEST(ContentFromProperty, OneColourChannelIsAGreyAlbedo)
{
  RampInput input;
  input.Property->GetScalarOpacity()->AddPoint(0, 0.5);
  vtkNew<vtkPiecewiseFunction> grey;
  grey->AddPoint(0, 0.25);
  grey->AddPoint(4096, 0.75);
  input.Property->SetColor(grey);
  ASSERT_EQ(input.Property->GetColorChannels(), 1);
  ASSERT_EQ(input.GatherProperty(), "");
  const auto found = input.AtPoint(2048, 1, 1);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(found.Scattering[c] / found.Extinction[c], 0.5, 1e-12);
  }
}

TEST(ContentFromProperty, EveryScalarTypeGivesTheSameMedium)
{
  for (int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE })
  {
    MediumInput input;
    input.Scalars = input.Add(
      "s", 1, [](vtkIdType i, int) { return double(4 * i); }, false, type);
    input.Property->GetScalarOpacity()->AddPoint(0, 0);
    input.Property->GetScalarOpacity()->AddPoint(104, 0.5);
    ASSERT_EQ(input.GatherProperty(), "") << type;
    // Point 13 is the middle of the range: scalar 52, opacity 0.25.
    EXPECT_NEAR(input.AtPoint(1, 1, 1).Extinction.r, -std::log(0.75), 1e-12) << type;
  }
}

TEST(ContentFromProperty, InterpolationIsThePropertys)
{
  MediumInput input(2, 2, 2);
  input.Scalars = input.Add("s", 1, [](vtkIdType i, int) { return i % 2 ? 1.0 : 0.0; });
  input.Property->GetScalarOpacity()->AddPoint(0, 0.25);
  input.Property->GetScalarOpacity()->AddPoint(1, 0.75);
  ASSERT_EQ(input.GatherProperty(), "");
  EXPECT_NEAR(input.Scene.Evaluate({ 0.5, 0.3, 0.7 }).Extinction.r, -std::log(0.5), 1e-12);
  input.Property->SetInterpolationTypeToNearest();
  ASSERT_EQ(input.GatherProperty(), "");
  EXPECT_NEAR(input.Scene.Evaluate({ 0.45, 0.3, 0.7 }).Extinction.r, -std::log(0.75), 1e-12);
  EXPECT_NEAR(input.Scene.Evaluate({ 0.55, 0.3, 0.7 }).Extinction.r, -std::log(0.25), 1e-12);
}

TEST(ContentFromProperty, CellScalarsLieHalfACellInside)
{
  MediumInput input(3, 2, 2);
  input.OnCells = true;
  input.Scalars = input.Add(
    "s", 1, [](vtkIdType i, int) { return double(i); }, true);
  input.Property->GetScalarOpacity()->AddPoint(0, 0);
  input.Property->GetScalarOpacity()->AddPoint(1, 0.5);
  ASSERT_EQ(input.GatherProperty(), "");
  EXPECT_EQ(input.Scene.Evaluate({ 0.2, 0.5, 0.5 }).Extinction.r, 0);
  EXPECT_NEAR(input.Scene.Evaluate({ 0.5, 0.5, 0.5 }).Extinction.r, -std::log(0.75), 1e-12);
  EXPECT_NEAR(input.Scene.Evaluate({ 0.8, 0.5, 0.5 }).Extinction.r, -std::log(0.5), 1e-12);
}

TEST(ContentFromProperty, NonFiniteVoxelsCountAsTheSmallestOrLargestFiniteValue)
{
  MediumInput input;
  input.Scalars = input.Add("s", 1, [](vtkIdType i, int) {
    return i == 0 ? std::numeric_limits<double>::quiet_NaN()
      : i == 2    ? std::numeric_limits<double>::infinity()
      : i == 6    ? -std::numeric_limits<double>::infinity()
                  : double(i);
  });
  input.Property->GetScalarOpacity()->AddPoint(1, 0.125);
  input.Property->GetScalarOpacity()->AddPoint(26, 0.75);
  ASSERT_EQ(input.GatherProperty(), "");
  EXPECT_NEAR(input.AtPoint(0, 0, 0).Extinction.r, -std::log(0.875), 1e-12);
  EXPECT_NEAR(input.AtPoint(2, 0, 0).Extinction.r, -std::log(0.25), 1e-12);
  EXPECT_NEAR(input.AtPoint(0, 2, 0).Extinction.r, -std::log(0.875), 1e-12);
}

TEST(ContentFromProperty, AConstantArrayIsAHomogeneousMedium)
{
  MediumInput input;
  input.Scalars = input.Add("s", 1, [](vtkIdType, int) { return 3.0; });
  input.Property->GetScalarOpacity()->AddPoint(0, 0);
  input.Property->GetScalarOpacity()->AddPoint(6, 1);
  ASSERT_EQ(input.GatherProperty(), "");
  EXPECT_NEAR(input.Scene.Evaluate({ 0.1, 0.6, 0.7 }).Extinction.r, std::log(2.0), 1e-12);
}

namespace
{
struct BadProperty
{
  const char* Name;
  std::function<void(MediumInput&)> Break;
  std::vector<std::string> Words;
};

using I = MediumInput;
const BadProperty BadProperties[] = {
  { "ZeroUnitDistance", [](I& i) { i.Property->SetScalarOpacityUnitDistance(0); },
    { "ScalarOpacityUnitDistance", "> 0" } },
  { "NaNUnitDistance", [](I& i) { i.Property->SetScalarOpacityUnitDistance(std::nan("")); },
    { "ScalarOpacityUnitDistance", "nan" } },
  { "AnisotropyOutOfRange", [](I& i) { i.Anisotropy = -1.25; }, { "anisotropy", "-1.25" } },
  { "NaNAnisotropy", [](I& i) { i.Anisotropy = std::nan(""); }, { "anisotropy", "nan" } },
  { "ColourAboveOne", [](I& i) { i.Property->GetRGBTransferFunction()->AddRGBPoint(0, 1, 1.5, 1); },
    { "colour function", "1.5", "0 to 1" } },
  { "NaNOpacity", [](I& i) { i.Property->GetScalarOpacity()->AddPoint(0, std::nan("")); },
    { "opacity", "not a number" } },
  { "NoScalars", [](I& i) { i.Scalars = nullptr; }, { "no scalars" } },
  { "ManyComponents", [](I& i) { i.Scalars = i.Add("rgb", 3, [](vtkIdType, int) { return 0.5; }); },
    { "3 components", "vtkParticipatingMedium" } },
  { "WrongLength", [](I& i) { i.OnCells = true; }, { "27 tuples", "8 cells" } },
  { "NothingFinite",
    [](I& i) { i.Scalars = i.Add("n", 1, [](vtkIdType, int) { return std::nan(""); }); },
    { "no finite value" } },
};

class ContentFromPropertyErrors : public ::testing::TestWithParam<BadProperty>
{
};
}

TEST_P(ContentFromPropertyErrors, OneMessageNamesTheValueAndTheFix)
{
  MediumInput input;
  input.Scalars = input.Add("s", 1, [](vtkIdType i, int) { return i / 26.0; });
  ASSERT_EQ(input.GatherProperty(), "");
  GetParam().Break(input);
  const std::string problem = input.GatherProperty();
  for (const std::string& word : GetParam().Words)
  {
    EXPECT_NE(problem.find(word), std::string::npos) << word << " not in: " << problem;
  }
}

INSTANTIATE_TEST_SUITE_P(Bad, ContentFromPropertyErrors, ::testing::ValuesIn(BadProperties),
  [](const ::testing::TestParamInfo<BadProperty>& info) { return info.param.Name; });

// Random bytes found values beyond the range, and NaN of a width beyond double.
TEST(ContentFromProperty, TablesAreSampledWithinTheirRange)
{
  for (const glm::dvec2& range : { glm::dvec2(-0.3, 0.1), { 1e8, 1e8 + 1e-3 }, { -7, 7e307 } })
  {
    vtkMediumFunction function;
    function.Sample(range.x, range.y, {}, [&](double value) {
      EXPECT_GE(value, range.x);
      EXPECT_LE(value, range.y);
      return glm::dvec4(value > range.x ? 1 : 0.25);
    });
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(function.Evaluate(infinity).x, 1);
    EXPECT_EQ(function.Evaluate(-infinity).x, 0.25);
    EXPECT_EQ(function.Evaluate(std::nan("")).x, 0.25);
  }
}

TEST(ContentFromProperty, ValuesFurtherApartThanADoubleCanSayAreRefused)
{
  MediumInput input;
  const double largest = std::numeric_limits<double>::max();
  input.Scalars =
    input.Add("apart", 1, [&](vtkIdType i, int) { return i % 2 ? largest : -largest; });
  EXPECT_NE(input.GatherProperty().find("further apart"), std::string::npos);
}

// Random bytes made VTK read beyond its memory here.
TEST(ContentFromProperty, ColoursBeyondTheColourSpaceAreRefused)
{
  for (double bad : { 1e12, -1.0, std::nan("") })
  {
    RampInput input;
    vtkNew<vtkColorTransferFunction> color;
    color->SetColorSpaceToLabCIEDE2000();
    color->AddRGBPoint(0, 0.1, 0.2, 0.3);
    color->AddRGBPoint(Last, 0.9, bad, 0.3);
    input.Property->SetColor(color);
    EXPECT_NE(input.GatherProperty().find("colour function"), std::string::npos) << bad;
  }
}
