// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Media and lights up to what a double can say, and beyond. Random bytes found NaN here.
#include "ReferenceSetting.h"

#include "vtkPiecewiseFunction.h"

#include <gtest/gtest.h>

using namespace ReferenceTests;

namespace
{
double Ramp(const glm::dvec3& box)
{
  return 0.2 + 0.6 * box.x + 0.2 * box.y * box.z;
}

const glm::dvec3 Origin(-1, 0.3, 0.6), Along(1, 0.1, 0);

struct RampSetting : Setting
{
  explicit RampSetting(double sigma = 1, double size = 1)
    : Setting(MakeGrid({ 5, 4, 3 }, glm::dvec3(size), Ramp), sigma)
  {
    this->AddDirectionalLight({ 0, 0, -1 });
  }

  void ExpectRefusal(const char* what, const char* value)
  {
    Errors errors(this->Reference);
    EXPECT_EQ(this->Radiance(Origin, Along), glm::dvec4(0));
    EXPECT_TRUE(errors.IsOne(what) && errors.IsOne(value)) << what;
  }
};
}

TEST(ReferenceRange, OpticalDepthsBeyondADoubleAreRefused)
{
  RampSetting setting(1e300, 1e20);
  setting.ExpectRefusal("extinction", "1e+300");
  Errors errors(setting.Reference);
  EXPECT_TRUE(std::isnan(setting.OpticalDepth({ 0, 0, 0 }, { 1, 1, 1 })));
  EXPECT_TRUE(errors.IsOne("DensityScale"));
  setting.Medium->SetDensityScale(1e-320);
  EXPECT_GT(setting.OpticalDepth(glm::dvec3(0), glm::dvec3(1e20)), 0.1);
}

TEST(ReferenceRange, AFactorBeyondADoubleMayBeMadeUpForByAnother)
{
  const double size = 1e100; // its product with the density is beyond a double
  RampSetting small(1), large(1e-300, size);
  large.Medium->SetDensityScale(1e200);
  const double truth = small.OpticalDepth(glm::dvec3(0), glm::dvec3(1));
  EXPECT_NEAR(large.OpticalDepth(glm::dvec3(0), glm::dvec3(size)) / truth, 1, 1e-13);
}

TEST(ReferenceRange, EmissionBeyondADoubleIsRefused)
{
  RampSetting setting;
  setting.Medium->SetEmission(1e290, 0, 1e300);
  setting.ExpectRefusal("emission", "1e+300");
  setting.Medium->SetEmission(0, 0, 1e280);
  const glm::dvec4 bright = setting.Radiance(Origin, Along);
  EXPECT_GT(bright.z, 1e279);
  EXPECT_LT(bright.z, 1e281);
}

TEST(ReferenceRange, LightsWhoseAttenuationIsNoneAreRefused)
{
  RampSetting setting;
  const auto lamp = setting.AddPointLight({ 0.5, 0.5, 0.5 });
  lamp->SetAttenuationValues(0, 0, 1e-270);
  setting.ExpectRefusal("attenuation", "e+293");
  lamp->SetAttenuationValues(0, 0, 1);
  EXPECT_GT(setting.Radiance(Origin, Along).x, 0);
}

// Random bytes found it cutting all of a ray as finely as its deepest channel needs.
TEST(ReferenceRange, AChannelIsTheSameHoweverDeepAnotherIs)
{
  RampSetting setting;
  setting.AddPointLight({ 0.2, 1.3, 0.4 });
  setting.Medium->SetExtinctionScale(1.5, 2, 3);
  const glm::dvec4 truth = setting.Radiance(Origin, Along);
  for (double deep : { 1e3, 1e6, 1e12, 1e100 })
  {
    setting.Medium->SetExtinctionScale(1.5, 2, deep);
    const glm::dvec4 found = setting.Radiance(Origin, Along);
    EXPECT_NEAR(found.x / truth.x, 1, 1e-8) << deep;
    EXPECT_NEAR(found.y / truth.y, 1, 1e-8) << deep;
  }
}

// Nothing is left of the light that comes from behind, and what is emitted before it is.
TEST(ReferenceRange, TheDeepestMediumIsOpaqueAndFinite)
{
  RampSetting setting(1e280);
  setting.Medium->SetEmission(1e280, 1e280, 1e280);
  const glm::dvec4 rgba = setting.Radiance(Origin, Along);
  EXPECT_EQ(rgba.w, 1);
  EXPECT_GT(rgba.x, 0.9); // emission over extinction, within the ramp
  EXPECT_LT(rgba.x, 10);
}

// The bends of a function are found in a field of any unit.
TEST(ReferenceRange, FieldsInUnitsWhoseSquareIsBeyondADouble)
{
  double truth = 0;
  for (double unit : { 1.0, std::ldexp(1, -660), std::ldexp(1, 660), std::ldexp(1, 990) })
  {
    const auto image = MakeGrid({ 4, 4, 4 }, glm::dvec3(1), [unit](const glm::dvec3& box) {
      return unit * Ramp({ box.z, box.y, box.x });
    });
    Setting setting(image, 1);
    vtkNew<vtkPiecewiseFunction> function;
    function->AddPoint(0.3 * unit, 0);
    function->AddPoint(0.5 * unit, 4);
    function->AddPoint(0.6 * unit, 1);
    setting.Medium->SetExtinctionFunction(function);
    const double depth = setting.OpticalDepth({ 0.1, 0.2, 0 }, { 0.7, 0.9, 1 });
    truth = unit == 1 ? depth : truth;
    EXPECT_NEAR(depth / truth, 1, 1e-9) << unit;
  }
  EXPECT_GT(truth, 0.1);
}
