// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// The medium's shadow on points of geometry: Beer's law on the way to each kind of light.
#include "ReferenceSetting.h"
#include "vtkMediumFixtures.h"

#include "vtkCallbackCommand.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <string>

using namespace ReferenceTests;

namespace
{
const glm::dvec3 Size(1, 0.7, 1.3);

vtkSmartPointer<vtkPoints> RandomPoints(int count)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (int i = 0; i < count; ++i)
  {
    glm::dvec3 at;
    for (int axis = 0; axis < 3; ++axis)
    {
      at[axis] = 3 * vtkMediumFixtures::Random(3 * i + axis, 8) - 1;
    }
    points->InsertNextPoint(&at[0]); // a third of them inside of the box
  }
  return points;
}

/// The way through the box from a point along a direction, so far.
double WayThrough(const glm::dvec3& point, const glm::dvec3& direction, double far)
{
  Box box(Size);
  box.Origin = glm::dvec3(0);
  const std::array<double, 2> t = box.Intersect({ point, direction, 0 });
  return std::max(std::min(t[1], far) - t[0], 0.0);
}

/// Against exp(-sigma way) in three channels, for a light that is `towards` and `far` from a point.
void ExpectBeersLaw(Setting& setting, vtkLight* light,
  const std::function<std::pair<glm::dvec3, double>(const glm::dvec3&)>& wayToLight)
{
  const glm::dvec3 sigma(0.5, 2, 7);
  setting.Medium->SetExtinctionScale(sigma.x, sigma.y, sigma.z);
  const auto points = RandomPoints(500);
  vtkNew<vtkDoubleArray> found;
  ASSERT_TRUE(setting.Reference->LightTransmittance(light, points, found));
  ASSERT_EQ(found->GetNumberOfTuples(), points->GetNumberOfPoints());
  ASSERT_EQ(found->GetNumberOfComponents(), 3);
  EXPECT_STREQ(found->GetName(), "LightTransmittance");
  int weakened = 0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 point;
    points->GetPoint(i, &point[0]);
    const auto way = wayToLight(point);
    const double length = WayThrough(point, way.first, way.second);
    weakened += length > 0;
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(found->GetComponent(i, c), std::exp(-sigma[c] * length), 1e-12) << i;
    }
  }
  EXPECT_GT(weakened, 50);
}

vtkSmartPointer<vtkImageData> UniformGrid()
{
  return MakeGrid({ 4, 3, 5 }, Size, [](const glm::dvec3&) { return 1.0; });
}
}

//------------------------------------------------------------------------------
TEST(LightTransmittance, OfABeamIsBeersLaw)
{
  Setting setting(UniformGrid(), 1);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -1, 0.4));
  ExpectBeersLaw(setting, setting.AddDirectionalLight(direction),
    [&](const glm::dvec3&) { return std::make_pair(-direction, 1e300); });
}

//------------------------------------------------------------------------------
// Also of one that stands inside of the medium, is switched off, or lights a cone only.
TEST(LightTransmittance, OfALampIsBeersLaw)
{
  for (const glm::dvec3& place : { glm::dvec3(0.4, 2, 0.3), glm::dvec3(0.3, 0.4, 0.5) })
  {
    Setting setting(UniformGrid(), 1);
    const auto lamp = setting.AddPointLight(place);
    lamp->SetFocalPoint(0, 0, 0);
    lamp->SetConeAngle(20);
    lamp->SwitchOff();
    ExpectBeersLaw(setting, lamp, [&](const glm::dvec3& point) {
      return std::make_pair(glm::normalize(place - point), glm::length(place - point));
    });
  }
}

//------------------------------------------------------------------------------
TEST(LightTransmittance, IsThatBetweenTwoPoints)
{
  auto wavy = [](const glm::dvec3& box) { return 0.5 + 0.5 * std::sin(9 * box.x + 5 * box.z); };
  Setting setting(MakeGrid({ 9, 8, 7 }, Size, wavy), 4);
  setting.Volume->SetPosition(0.2, -0.1, 0.3);
  setting.Volume->RotateX(20);
  const glm::dvec3 place(1.5, 1.2, -0.4);
  const auto lamp = setting.AddPointLight(place);
  const auto points = RandomPoints(40);
  vtkNew<vtkDoubleArray> found;
  ASSERT_TRUE(setting.Reference->LightTransmittance(lamp, points, found));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double truth = setting.Reference->Transmittance(points->GetPoint(i), &place[0]);
    EXPECT_NEAR(found->GetComponent(i, 1), truth, 1e-12);
  }
}

//------------------------------------------------------------------------------
TEST(LightTransmittance, RefusesWhatIsMissingAndLeavesTheArray)
{
  Setting setting(UniformGrid(), 1);
  std::string words;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&words);
  listener->SetCallback([](vtkObject*, unsigned long, void* text, void* data) {
    *static_cast<std::string*>(text) = static_cast<const char*>(data);
  });
  setting.Reference->AddObserver(vtkCommand::ErrorEvent, listener);
  const auto points = RandomPoints(3);
  const auto light = setting.AddDirectionalLight({ 0, 0, 0 });
  vtkNew<vtkDoubleArray> array;
  array->InsertNextValue(5);
  EXPECT_FALSE(setting.Reference->LightTransmittance(nullptr, points, array));
  EXPECT_NE(words.find("The light of"), std::string::npos) << words;
  EXPECT_FALSE(setting.Reference->LightTransmittance(light, nullptr, array));
  EXPECT_NE(words.find("The points of"), std::string::npos) << words;
  EXPECT_FALSE(setting.Reference->LightTransmittance(light, points, nullptr));
  EXPECT_NE(words.find("The array to fill of"), std::string::npos) << words;
  EXPECT_FALSE(setting.Reference->LightTransmittance(light, points, array));
  EXPECT_NE(words.find("focal point"), std::string::npos) << words;
  EXPECT_EQ(array->GetNumberOfValues(), 1);
  light->SetPosition(0, 0, 1);
  EXPECT_TRUE(setting.Reference->LightTransmittance(light, points, array));
  EXPECT_EQ(array->GetNumberOfTuples(), 3);
}
