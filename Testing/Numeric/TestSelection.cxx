// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Selectors and pickers find the medium where the picture shows it, and nothing where light passes.
#include "ClosedForms.h"
#include "OpaquePlane.h"

#include "vtkCellPicker.h"
#include "vtkHardwareSelector.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPropPicker.h"
#include "vtkSelection.h"
#include "vtkVolumePicker.h"

#include <gtest/gtest.h>

using namespace vtkMediumTest;

namespace
{
constexpr int Side = 24;
constexpr double Threshold = 3.0 / 255; // that of the mapper's documentation

struct BallScene : Scene
{
  explicit BallScene(int integrator = vtkSingleScatteringVolumeMapper::FixedStep)
    : Scene(MakeImage(glm::ivec3(17), glm::dvec3(1),
              [](const glm::dvec3& p) { return std::max(1 - 2 * glm::length(p), 0.0); }),
        Side)
  {
    this->Mapper->SetIntegrator(integrator);
    this->Mapper->SetPaperThreshold(0.2);
    this->Medium->SetExtinction(3);
    if (integrator != vtkSingleScatteringVolumeMapper::Paper)
    {
      this->Medium->SetExtinctionArrayName("density");
      this->Medium->SetExtinctionScale(0.6);
    }
    this->AddBeam({ 1, -1, -0.3 });
    this->Look({ 0.3, 0.2, -1 }, 2);
  }
};

/// A selector that has captured the whole window.
struct Selector
{
  vtkNew<vtkHardwareSelector> Hardware;

  explicit Selector(Scene& scene, int association = vtkDataObject::FIELD_ASSOCIATION_CELLS)
  {
    this->Hardware->SetRenderer(scene.Renderer);
    this->Hardware->SetArea(0, 0, scene.Pixels - 1, scene.Pixels - 1);
    this->Hardware->SetFieldAssociation(association);
    EXPECT_TRUE(this->Hardware->CaptureBuffers());
  }
  ~Selector() { this->Hardware->ClearBuffers(); }

  vtkHardwareSelector::PixelInformation At(int x, int y)
  {
    const unsigned int pixel[2] = { unsigned(x), unsigned(y) };
    return this->Hardware->GetPixelInformation(pixel);
  }
};
}

TEST(Selection, HardwareSelectorSeesWhatTransmittanceShows)
{
  for (int integrator :
    { vtkSingleScatteringVolumeMapper::Paper, vtkSingleScatteringVolumeMapper::FixedStep,
      vtkSingleScatteringVolumeMapper::ErrorControlled, vtkSingleScatteringVolumeMapper::Exact })
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    BallScene scene(integrator);
    const Picture picture = scene.Render();
    Selector selector(scene);
    int seen = 0, faint = 0;
    for (int y = 0; y < Side; ++y)
    {
      for (int x = 0; x < Side; ++x)
      {
        const double alpha = picture.At(x, y, 3);
        if (std::abs(alpha - Threshold) > 1e-3) // the steps of a selection are not the picture's
        {
          const bool expected = alpha > Threshold;
          EXPECT_EQ(selector.At(x, y).Prop, expected ? scene.Volume.Get() : nullptr)
            << x << ", " << y << ": alpha " << alpha;
          seen += expected;
          faint += !expected && alpha > 0;
        }
      }
    }
    EXPECT_GT(seen, 50);
    EXPECT_TRUE(faint > 5 || integrator == vtkSingleScatteringVolumeMapper::Paper);
    EXPECT_TRUE(scene.Errors.empty());
  }
}

TEST(Selection, PointsAndCellsAreThoseWhereTheThresholdIsReached)
{
  // 5 x 7 x 9 points in a homogeneous box: light is lost at the same depth behind each face.
  const glm::dvec3 size(1, 0.7, 0.9);
  const glm::ivec3 points(5, 7, 9);
  const double sigma = 0.1, depth = -std::log1p(-Threshold) / sigma; // 0.118, behind the first cell
  for (bool cells : { false, true })
  {
    Scene scene(MakeImage(points, size, [](const glm::dvec3&) { return 1.0; }), Side);
    scene.Medium->SetExtinction(sigma);
    scene.SetSteps(0.01, 1);
    scene.Look({ 0.3, 0.2, -1 }, 2);
    scene.Window->Render();
    Selector selector(scene,
      cells ? vtkDataObject::FIELD_ASSOCIATION_CELLS : vtkDataObject::FIELD_ASSOCIATION_POINTS);
    const glm::ivec3 count = cells ? points - 1 : points;
    const glm::dvec3 spacing = size / glm::dvec3(points - 1);
    int hits = 0;
    ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
      const std::array<double, 2> t = Box(size).Intersect(ray);
      const vtkHardwareSelector::PixelInformation found = selector.At(x, y);
      if (t[1] - t[0] < 1.01 * depth)
      {
        EXPECT_TRUE(!found.Valid || t[1] - t[0] > 0.99 * depth);
        return;
      }
      ASSERT_TRUE(found.Valid) << x << ", " << y;
      ++hits;
      const vtkIdType id = found.AttributeID;
      ASSERT_LT(id, vtkIdType(count.x) * count.y * count.z);
      const glm::dvec3 index(id % count.x, id / count.x % count.y, id / count.x / count.y);
      const glm::dvec3 voxel = (index + (cells ? 0.5 : 0.0)) * spacing - 0.5 * size;
      const glm::dvec3 place = ray.Origin + (t[0] + depth) * ray.Direction;
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_LT(std::abs(voxel[axis] - place[axis]), 0.51 * spacing[axis]) << x << ", " << y;
      }
    });
    EXPECT_GT(hits, 100);
  }
}

TEST(Selection, OpaqueGeometryIsSeenBeforeAndThroughFaintMedia)
{
  BallScene scene;
  scene.Medium->SetExtinctionScale(3);
  scene.Look({ 0, 0, -1 }, 4);
  const int middle = Side / 2;
  EXPECT_EQ(Selector(scene).At(middle, middle).Prop, scene.Volume.Get());
  vtkSmartPointer<vtkActor> behind = Plane{ { 0, 0, 1 }, -0.6 }.AddTo(scene.Renderer);
  EXPECT_EQ(Selector(scene).At(middle, middle).Prop, scene.Volume.Get());
  EXPECT_EQ(Selector(scene).At(2, middle).Prop, behind.Get()); // beside the ball
  scene.Medium->SetExtinctionScale(0.01);
  EXPECT_EQ(Selector(scene).At(middle, middle).Prop, behind.Get());
  scene.Medium->SetExtinctionScale(3);
  vtkSmartPointer<vtkActor> before = Plane{ { 0, 0, 1 }, 0.6 }.AddTo(scene.Renderer);
  EXPECT_EQ(Selector(scene).At(middle, middle).Prop, before.Get());
}

TEST(Selection, VolumesAreToldApart)
{
  BallScene scene;
  vtkNew<vtkSingleScatteringVolumeMapper> mapper;
  mapper->SetInputData(vtkImageData::SafeDownCast(scene.Mapper->GetDataObjectInput()));
  mapper->SetMedium(scene.Medium);
  vtkNew<vtkVolume> second;
  second->SetMapper(mapper);
  second->SetProperty(scene.Property);
  second->SetPosition(1.2, 0, 0);
  scene.Renderer->AddVolume(second);
  scene.Look({ 0, 0, -1 }, 4, { 0.6, 0, 0 });
  scene.Window->Render();
  Selector selector(scene);
  vtkSmartPointer<vtkSelection> selection =
    vtkSmartPointer<vtkSelection>::Take(selector.Hardware->GenerateSelection());
  EXPECT_EQ(selection->GetNumberOfNodes(), 2u);
  EXPECT_EQ(selector.At(Side * 3 / 10, Side / 2).Prop, scene.Volume.Get());
  EXPECT_EQ(selector.At(Side * 7 / 10, Side / 2).Prop, second.Get());
  EXPECT_EQ(selector.At(Side / 2, Side / 2).Prop, nullptr);
}

TEST(Selection, LeavesThePictureAlone)
{
  BallScene scene;
  scene.Renderer->SetBackground(0.2, 0.4, 0.6);
  const Picture before = scene.Render();
  const std::vector<unsigned char> shown = scene.RenderWindow();
  {
    Selector selector(scene);
    vtkNew<vtkImageData> image;
    scene.Mapper->GetColorImage(image);
    EXPECT_EQ(before.Values, Picture(image).Values);
  }
  EXPECT_EQ(shown, scene.RenderWindow());
}

TEST(Selection, NothingIsSelectedWhereNothingIsShown)
{
  BallScene scene;
  scene.Mapper->RenderToImageOn();
  EXPECT_EQ(Selector(scene).At(Side / 2, Side / 2).Prop, nullptr);
  scene.Mapper->RenderToImageOff();
  scene.Volume->PickableOff();
  EXPECT_EQ(Selector(scene).At(Side / 2, Side / 2).Prop, nullptr);
  scene.Volume->PickableOn();
  EXPECT_EQ(Selector(scene).At(Side / 2, Side / 2).Prop, scene.Volume.Get());
}

TEST(Selection, PropPickerFindsThePlace)
{
  // A homogeneous box, seen along -z: the threshold is reached 0.06 behind the face at z = 0.5.
  Scene scene(MakeBox(), Side);
  const double sigma = 0.2;
  scene.Medium->SetExtinction(sigma);
  scene.SetSteps(0.01, 1);
  scene.Look({ 0, 0, -1 }, 4);
  scene.Camera->SetClippingRange(3, 5);
  scene.Window->Render();
  vtkNew<vtkPropPicker> picker;
  EXPECT_TRUE(picker->Pick(Side / 2, Side / 2, 0, scene.Renderer));
  EXPECT_EQ(picker->GetViewProp(), scene.Volume.Get());
  double at[3];
  picker->GetPickPosition(at);
  EXPECT_NEAR(at[2], 0.5 + std::log1p(-Threshold) / sigma, 2e-3); // 24 bits of depth and a slant
  EXPECT_FALSE(picker->Pick(0, 0, 0, scene.Renderer));
}

// Where the property is the medium, its opacity is above zero where light is lost, and nowhere else.
TEST(Selection, VolumePickersMissWhereTransmittanceIsOne)
{
  BallScene scene;
  scene.Mapper->SetMedium(nullptr);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.3, 0);
  opacity->AddPoint(1, 0.9);
  scene.Property->SetScalarOpacity(opacity);
  scene.Property->SetScalarOpacityUnitDistance(0.2);
  scene.SetSteps(0.01, 1);
  scene.Mapper->SetOutputToTransmittance();
  const Picture picture = scene.Render();
  vtkNew<vtkCellPicker> cells;
  vtkNew<vtkVolumePicker> voxels;
  int seen = 0, clear = 0;
  for (vtkCellPicker* picker : { cells.Get(), static_cast<vtkCellPicker*>(voxels) })
  {
    picker->SetVolumeOpacityIsovalue(1e-6);
    for (int y = 0; y < Side; ++y)
    {
      for (int x = 0; x < Side; ++x)
      {
        const double lost = 1 - picture.At(x, y, 0);
        if (lost == 0 || lost > 1e-3) // between the two, a ray grazes the ball
        {
          EXPECT_EQ(picker->Pick(x + 0.5, y + 0.5, 0, scene.Renderer), lost > 0) << x << ", " << y;
          seen += lost > 0;
          clear += lost == 0;
        }
      }
    }
  }
  EXPECT_GT(seen, 100);
  EXPECT_GT(clear, 100);
}

// These look at the data and the property, at the opacity of one unit distance, with a medium and without.
class VolumePickers : public testing::TestWithParam<bool>
{
};

TEST_P(VolumePickers, FindTheOpacityOfTheProperty)
{
  BallScene scene;
  if (!GetParam())
  {
    scene.Mapper->SetMedium(nullptr);
  }
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0, 0);
  opacity->AddPoint(1, 1);
  scene.Property->SetScalarOpacity(opacity);
  scene.Look({ 0, 0, -1 }, 2);
  scene.Window->Render();
  for (bool cropper : { false, true })
  {
    vtkSmartPointer<vtkCellPicker> picker = cropper
      ? vtkSmartPointer<vtkCellPicker>(vtkSmartPointer<vtkVolumePicker>::New())
      : vtkSmartPointer<vtkCellPicker>::New();
    for (double isovalue : { 0.05, 0.5 })
    {
      picker->SetVolumeOpacityIsovalue(isovalue);
      ASSERT_TRUE(picker->Pick(Side / 2, Side / 2, 0, scene.Renderer));
      EXPECT_EQ(picker->GetVolume(), scene.Volume.Get());
      double at[3];
      picker->GetPickPosition(at);
      // The opacity is 1 - 2 r, on a lattice of 1/16.
      EXPECT_NEAR(glm::length(glm::dvec3(at[0], at[1], at[2])), 0.5 - 0.5 * isovalue, 0.02);
      EXPECT_FALSE(picker->Pick(0, 0, 0, scene.Renderer));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Selection, VolumePickers, testing::Bool());
