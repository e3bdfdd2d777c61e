// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Clipping planes and cropping, on eye rays and on light rays, in every integrator. The tolerances are those
// without a cut.
#include "CutScene.h"

#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"

using namespace vtkMediumTest;

namespace
{
constexpr double Voxel = ReferenceVoxel;

/// Fills the box with a homogeneous medium, which is what Paper draws.
void Fill(ReferenceScene& scene)
{
  scene.Mapper->SetInputData(MakeBox(ReferenceSize));
  scene.Medium->SetExtinctionArrayName(nullptr);
  scene.Medium->SetExtinctionScale(1);
  scene.Medium->SetExtinction(4, 5, 7);
}
}

class EachCut : public ::testing::TestWithParam<Cut>
{
};

INSTANTIATE_TEST_SUITE_P(Cut, EachCut, ::testing::ValuesIn(Cuts()),
  [](const ::testing::TestParamInfo<Cut>& cut) { return cut.param.Name; });

TEST_P(EachCut, FixedStepConvergesInSecondOrder)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  GetParam().Apply(scene);
  scene.FindTruth();
  ASSERT_GT(scene.Peak, 0.01);
  const double coarse = scene.Measure(0.5 * Voxel).RootMeanSquare;
  const ReferenceScene::Errors fine = scene.Measure(0.125 * Voxel);
  // The edges of the removed part's shadow bend the source, as those of the box do.
  EXPECT_GT(std::log(coarse / fine.RootMeanSquare) / std::log(4), 1.7);
  EXPECT_LT(fine.Largest, 1e-4);
  EXPECT_LT(fine.Alpha, 2e-5);
}

TEST_P(EachCut, ExactMeetsTheTruth)
{
  ReferenceScene scene(vtkMediumFixtures::Cloud);
  GetParam().Apply(scene);
  scene.Mapper->SetIntegratorToExact();
  scene.FindTruth();
  ASSERT_GT(scene.Peak, 0.01);
  const ReferenceScene::Errors errors = scene.Measure();
  EXPECT_LT(errors.Largest, 1e-4);
  EXPECT_LT(errors.Alpha, 2e-5);
}

TEST_P(EachCut, ErrorControlledKeepsTheError)
{
  for (vtkMediumFixtures::Fields field : { vtkMediumFixtures::Cloud, vtkMediumFixtures::Binary })
  {
    ReferenceScene scene(field);
    scene.Medium->SetExtinctionScale(6);
    GetParam().Apply(scene);
    scene.Mapper->SetIntegratorToErrorControlled();
    scene.FindTruth();
    const ReferenceScene::Errors errors = scene.Measure();
    EXPECT_LE(errors.Largest, 1.0 / 255);
    EXPECT_GE(scene.Mapper->GetEstimatedError(), errors.Largest);
  }
}

// A filled box: the paper's medium is the reference's, but for the paper's left Riemann sums.
TEST_P(EachCut, PaperConvergesToTheTruth)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  Fill(scene);
  scene.Medium->SetAnisotropy(0);
  scene.Mapper->SetIntegratorToPaper();
  scene.Mapper->SetJitter(0);
  GetParam().Apply(scene);
  scene.FindTruth();
  const ReferenceScene::Errors coarse = scene.Measure(Voxel);
  const ReferenceScene::Errors fine = scene.Measure(0.25 * Voxel);
  EXPECT_TRUE(scene.Scene::Errors.empty());
  EXPECT_GT(coarse.RootMeanSquare / fine.RootMeanSquare, 3.5); // first order: 4
  EXPECT_LT(fine.Largest, 0.03); // sigma h (1 + kappa) / 2: 2 % for kappa = 1
  EXPECT_LT(fine.Alpha, 1e-4);
}

// The half that is left, alone, under light that comes from the removed side.
TEST(Cut, RemovedHalfCastsNoShadow)
{
  using Mapper = vtkSingleScatteringVolumeMapper;
  for (int integrator :
    { Mapper::Paper, Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    // Of constant density, with a lattice plane where the halves meet.
    const auto one = [](const glm::dvec3&) { return 1.0; };
    vtkSmartPointer<vtkImageData> half = MakeImage({ 5, 5, 3 }, { 1, 1, 0.5 }, one);
    half->SetOrigin(-0.5, -0.5, -0.5);
    Scene alone(half), cut(MakeImage({ 5, 5, 5 }, glm::dvec3(1), one));
    for (Scene* scene : { &alone, &cut })
    {
      scene->Medium->SetExtinction(5);
      scene->Mapper->SetIntegrator(integrator);
      scene->Mapper->SetMaximumError(1e-3);
      scene->Mapper->SetJitter(0);
      scene->SetSteps(0.01, 0.01);
      scene->Look({ 0.3, -1, 0.4 }, 3);
      scene->AddBeam({ 0.2, -0.3, -1 });
    }
    const Picture shadowed = cut.Render();
    AddPlane(cut, { 0, 0, -1 }, glm::dvec3(0));
    const Picture expected = alone.Render();
    // S; the error-controlled pictures stay within their errors, each on its own.
    EXPECT_LT(
      Difference(expected, cut.Render()), integrator == Mapper::ErrorControlled ? 2e-3 : 2e-4)
      << integrator;
    EXPECT_GT(Difference(expected, shadowed), 0.1) << integrator;
  }
}

// Half-spaces by clipping planes and by cropping; on a volume that is turned, where the former stay in the
// world and the latter go with the volume.
TEST(Cut, ClippingIsInTheWorldAndCroppingInTheImage)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.SetSteps(0.25 * Voxel, 0.25 * Voxel);
  scene.Volume->RotateX(30);
  scene.Volume->SetPosition(0.1, 0.2, -0.1);
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(-0.2, 9, -9, 0.1, -9, 9);
  const Picture cropped = scene.Render();
  scene.Mapper->CroppingOff();
  vtkMatrix4x4* matrix = scene.Volume->GetMatrix();
  const auto toWorld = [matrix](const glm::dvec3& at, double w) {
    const double point[4] = { at.x, at.y, at.z, w };
    double world[4];
    matrix->MultiplyPoint(point, world);
    return glm::dvec3(world[0], world[1], world[2]);
  };
  AddPlane(scene, toWorld({ 1, 0, 0 }, 0), toWorld({ -0.2, 0, 0 }, 1));
  AddPlane(scene, toWorld({ 0, -1, 0 }, 0), toWorld({ 0, 0.1, 0 }, 1));
  EXPECT_LT(Difference(cropped, scene.Render()), 1e-5);
  scene.Mapper->RemoveAllClippingPlanes();
  EXPECT_GT(Difference(cropped, scene.Render()), 0.1);
}

// Regions that make a box are half-spaces; the same regions in two mappers' worth of pieces are not.
TEST(Cut, PiecesOfARayAddUpToItsInterval)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.Mapper->SetOutputToOpticalDepth();
  scene.Mapper->SetIntegratorToExact();
  Crop(scene, 0x7ffffff);
  const Picture whole = scene.Render();
  Picture sum = whole;
  std::fill(sum.Values.begin(), sum.Values.end(), 0.0f);
  for (int regions : { 0x5555555, 0x2aaaaaa }) // every other one: seven pieces a ray at most
  {
    Crop(scene, regions);
    const Picture part = scene.Render();
    for (std::size_t i = 0; i < sum.Values.size(); ++i)
    {
      sum.Values[i] += part.Values[i];
    }
  }
  for (std::size_t i = 3; i < sum.Values.size(); i += 4)
  {
    sum.Values[i] = whole.Values[i]; // 1 where there is a value
  }
  EXPECT_LT(Difference(whole, sum), 1e-5);
}

TEST(Cut, DistancesEndAtThePlane)
{
  using Mapper = vtkSingleScatteringVolumeMapper;
  for (int integrator : { Mapper::Paper, Mapper::FixedStep })
  {
    Scene scene(MakeBox(), 16);
    scene.Mapper->SetIntegrator(integrator);
    scene.SetSteps(0.013, 0.013);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, 0.4, -1));
    AddPlane(scene, normal, { 0, 0, 0.1 });
    AddPlane(scene, { 0, 0, 1 }, { 0, 0, -0.3 });
    scene.Mapper->SetOutputToFirstHit();
    const Picture first = scene.Render();
    scene.Mapper->SetOutputToDistance();
    const Picture distance = scene.Render();
    ForEachPixel(scene, [&](int x, int y, const Ray& ray) {
      const std::array<double, 2> box = Box(glm::dvec3(1)).Intersect(ray);
      const double begin = std::max(box[0],
        glm::dot(normal, glm::dvec3(0, 0, 0.1) - ray.Origin) / glm::dot(normal, ray.Direction));
      const double end = std::min(box[1], (-0.3 - ray.Origin.z) / ray.Direction.z);
      if (begin + 1e-3 < end)
      {
        ASSERT_NEAR(first.At(x, y), begin, 1e-5) << x << ", " << y;
        ASSERT_NEAR(distance.At(x, y), end - begin, 1e-5) << x << ", " << y;
      }
      ASSERT_EQ(first.At(x, y, 3), begin < end ? 1 : 0) << x << ", " << y;
    });
  }
}

TEST(Cut, MovingAPlaneCompilesAndBuildsNothing)
{
  using Mapper = vtkSingleScatteringVolumeMapper;
  for (int integrator : { Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    ReferenceScene scene(vtkMediumFixtures::Smooth);
    scene.Mapper->SetIntegrator(integrator);
    vtkSmartPointer<vtkPlane> plane = AddPlane(scene, { 1, 0.2, 0.1 }, { -0.2, 0, 0 });
    Crop(scene, VTK_CROP_FENCE);
    const Picture before = scene.Render();
    vtkMediumStatistics* done = scene.Mapper->GetStatistics();
    const vtkTypeInt64 compiles = done->GetProgramCompiles(), uploads = done->GetTextureUploads();
    const vtkTypeInt64 bricks = done->GetBrickBuilds(), calibrations = done->GetCalibrations();
    scene.Render();
    EXPECT_EQ(done->GetCalibrations(), calibrations);
    plane->SetOrigin(0.1, 0, 0);
    EXPECT_GT(Difference(before, scene.Render()), 0.01);
    scene.Mapper->SetCroppingRegionPlanes(-0.1, 0.1, -0.1, 0.1, -0.1, 0.1);
    scene.Render();
    EXPECT_EQ(done->GetTextureUploads(), uploads);
    EXPECT_EQ(done->GetBrickBuilds(), bricks);
    if (integrator == Mapper::ErrorControlled) // another step may need a march over several draws
    {
      EXPECT_EQ(done->GetCalibrations(), calibrations + 2);
    }
    else
    {
      EXPECT_EQ(done->GetProgramCompiles(), compiles);
    }
  }
}

TEST(Cut, CostsNothingWhereNothingIsCut)
{
  using Mapper = vtkSingleScatteringVolumeMapper;
  for (int integrator :
    { Mapper::Paper, Mapper::FixedStep, Mapper::ErrorControlled, Mapper::Exact })
  {
    ReferenceScene scene(vtkMediumFixtures::Smooth);
    if (integrator == Mapper::Paper)
    {
      Fill(scene);
    }
    scene.Mapper->SetIntegrator(integrator);
    scene.Mapper->GetStatistics()->CountTapsOn();
    scene.SetSteps(2 * Voxel, 2 * Voxel);
    const Picture before = scene.Render();
    vtkMediumStatistics* done = scene.Mapper->GetStatistics();
    const vtkTypeInt64 taps = done->GetTaps(), compiles = done->GetProgramCompiles();
    ASSERT_GT(taps, 0) << integrator;
    AddPlane(scene, { 1, 0, 0 }, { -0.6, 0, 0 }); // beside the volume
    Crop(scene, 0x7ffffff);                       // every region
    scene.Mapper->SetImageSampleDistance(
      2); // another frame, so that the next one is not this one again
    scene.Render();
    scene.Mapper->SetImageSampleDistance(1);
    EXPECT_EQ(before.Values, scene.Render().Values) << integrator;
    EXPECT_EQ(done->GetTaps(), taps) << integrator;
    EXPECT_EQ(done->GetProgramCompiles(), compiles) << integrator;
    scene.Mapper->SetCroppingRegionFlags(VTK_CROP_SUBVOLUME);
    scene.Render();
    EXPECT_LT(done->GetTaps(), taps) << integrator; // what is cut away is not looked up
  }
}

// A plane with every light on its kept side: caches of the whole volume are right.
TEST(Cut, LightCachesServeWhereNoLightRayIsCut)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.Medium->SetExtinctionScale(6);
  scene.Renderer->RemoveAllLights();
  scene.AddBeam({ 1, -0.8, -0.2 });
  scene.AddPointLight({ -0.9, 0.8, 0.5 });
  scene.Mapper->SetIntegratorToErrorControlled();
  vtkSmartPointer<vtkPlane> plane = AddPlane(scene, { -1, 0.5, 0 }, { 0.1, 0, 0 });
  scene.FindTruth();
  const ReferenceScene::Errors errors = scene.Measure();
  vtkMediumStatistics* done = scene.Mapper->GetStatistics();
  EXPECT_EQ(done->GetLightCacheBuilds(), 2);
  EXPECT_LE(errors.Largest, 1.0 / 255);
  EXPECT_GE(scene.Mapper->GetEstimatedError(), errors.Largest);
  EXPECT_GT(done->GetBricksLeapt(), 0) << "bricks of the part that is cut away";
  plane->SetOrigin(0.05, 0, 0);
  scene.Render();
  EXPECT_EQ(done->GetLightCacheBuilds(), 2) << "the plane moved, and no light";
}

// Jumps at voxels and a bent transfer function besides the planes.
TEST(Cut, ExactMeetsTheTruthBetweenVoxelsAndKnots)
{
  for (bool nearest : { false, true })
  {
    ReferenceScene scene(vtkMediumFixtures::Smooth, nearest);
    scene.Window->SetSize(24, 24);
    vtkNew<vtkPiecewiseFunction> extinction;
    extinction->AddPoint(0, 0);
    extinction->AddPoint(0.3, 1);
    extinction->AddPoint(1, 0.5);
    scene.Medium->SetExtinctionFunction(extinction);
    nearest ? scene.Property->SetInterpolationTypeToNearest()
            : scene.Property->SetInterpolationTypeToLinear();
    AddPlane(scene, { -1, 0.8, 0.3 }, { 0.05, 0, 0 });
    Crop(scene, VTK_CROP_INVERTED_FENCE);
    scene.Mapper->SetIntegratorToExact();
    scene.FindTruth();
    const ReferenceScene::Errors errors = scene.Measure();
    EXPECT_LT(errors.Largest, 1e-4) << nearest;
    EXPECT_LT(errors.Alpha, 1e-4) << nearest;
  }
}

// The eye in what is cut away, in what is left, and in parallel projection.
TEST(Cut, IsSeenFromWithinAndInParallel)
{
  for (int view = 0; view < 3; ++view)
  {
    ReferenceScene scene(vtkMediumFixtures::Smooth);
    scene.SetSteps(0.25 * Voxel, 0.25 * Voxel);
    AddPlane(scene, { -1, 0.2, 0.3 }, { 0.05, 0, 0 });
    Crop(scene, VTK_CROP_INVERTED_CROSS);
    view == 0     ? scene.Look({ -1, 0.2, 0.1 }, 0.3, { 0.05, 0, 0 })
      : view == 1 ? scene.Look({ 0.2, 1, 0.3 }, 0.2, { -0.3, 0.1, 0.4 })
                  : scene.LookParallel({ 0.3, -0.4, -1 }, 3, 0.6);
    scene.FindTruth();
    ASSERT_GT(scene.Peak, 0.01) << view;
    const ReferenceScene::Errors errors = scene.Measure();
    EXPECT_LT(errors.Largest, 5e-4) << view; // at a quarter of a voxel
    EXPECT_LT(errors.Alpha, 1e-4) << view;
  }
}

// Planes that meet leave regions between them empty; a plane along the view belongs to one side.
TEST(Cut, PlanesThatMeetAndPlanesAlongTheRayAreFinite)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.LookParallel({ 0, 0, -1 }, 3, 0.6);
  const Picture whole = scene.Render();
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionPlanes(0.1, 0.1, -0.05, -0.05, 0, 0);
  scene.Mapper->SetCroppingRegionFlags(0x7ffffff & ~VTK_CROP_SUBVOLUME);
  EXPECT_LT(Difference(whole, scene.Render()), 1e-2) << "pieces of nothing, steps of their own";
  scene.Mapper->SetCroppingRegionFlagsToSubVolume();
  const Picture nothing = scene.Render();
  EXPECT_EQ(*std::max_element(nothing.Values.begin(), nothing.Values.end()), 0);
  scene.Mapper->CroppingOff();
  AddPlane(scene, { 1, 0, 0 }, glm::dvec3(0)); // in which rays are
  EXPECT_TRUE(scene.Render().IsLight());
}

// Nested marches of 1000 x 1000 steps in four parts each, beyond what a draw may loop on some drivers.
TEST(Cut, LongMarchesArrive)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.Window->SetSize(8, 8);
  Crop(scene, 0x5555555);
  scene.FindTruth();
  const ReferenceScene::Errors errors = scene.Measure(1.8 / 1000);
  EXPECT_GT(scene.Mapper->GetStatistics()->GetPasses(), 1);
  EXPECT_LT(errors.Largest, 1e-4);
  EXPECT_LT(errors.Alpha, 2e-5);
}

// A plane with light from its removed side: caches of what is left, where they are accurate enough.
TEST(Cut, LightCachesKnowOfTheCut)
{
  ReferenceScene scene(vtkMediumFixtures::Smooth);
  scene.Mapper->SetInputData(
    vtkMediumFixtures::MakeImage(vtkMediumFixtures::Smooth, glm::ivec3(64), ReferenceSize));
  scene.Medium->SetExtinctionScale(6);
  scene.Renderer->RemoveAllLights();
  scene.AddBeam({ 1, -0.8, -0.2 });
  scene.Mapper->SetIntegratorToErrorControlled();
  scene.Mapper->SetLightCachesToAlways();
  vtkSmartPointer<vtkPlane> plane = AddPlane(scene, { 1, -0.5, 0.2 }, { 0.033, 0.01, 0 });
  scene.FindTruth();
  const ReferenceScene::Errors errors = scene.Measure();
  vtkMediumStatistics* done = scene.Mapper->GetStatistics();
  EXPECT_EQ(done->GetLightCacheBuilds(), 1);
  EXPECT_LE(errors.Largest, 1.0 / 255);
  EXPECT_GE(scene.Mapper->GetEstimatedError(), errors.Largest);
  scene.Camera->Azimuth(1);
  scene.Render();
  EXPECT_EQ(done->GetLightCacheBuilds(), 1);
  plane->SetOrigin(0.05, 0, 0);
  scene.Render();
  EXPECT_EQ(done->GetLightCacheBuilds(), 2) << "the plane moved";
  EXPECT_EQ(done->GetBrickBuilds(), 1);
}
