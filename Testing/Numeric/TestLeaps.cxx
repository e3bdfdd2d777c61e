// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Leaping empty space changes what a frame costs and not what it shows: ErrorControlled without caches
// beside itself with user code, whose coefficients bricks know nothing about; and with caches beside itself
// in air that is too thin to see, in which no brick is empty.
#include "CutScene.h"

#include "vtkShaderProperty.h"

using namespace vtkMediumTest;

namespace
{
constexpr int Few = 57, Many = 113; // seven and fourteen bricks along each edge

/// Data that leaping could get wrong, by lattice point.
struct Data
{
  const char* Name;
  double (*Of)(const glm::ivec3& at);
};

void PrintTo(const Data& data, std::ostream* os)
{
  *os << data.Name;
}

const Data AllData[] = {
  { "HotVoxelOnABrickBorder",
    [](const glm::ivec3& at) { return at == glm::ivec3(24, 32, 24) ? 1.0 : 0.0; } },
  { "HotVoxelInsideOfABrick",
    [](const glm::ivec3& at) { return at == glm::ivec3(27, 29, 20) ? 1.0 : 0.0; } },
  { "CheckerboardInABall",
    [](const glm::ivec3& at) {
      return glm::length(glm::dvec3(at) - 30.0) < 9 && (at.x + at.y + at.z) % 2 ? 1.0 : 0.0;
    } },
  { "ShellOfOneVoxel",
    [](const glm::ivec3& at) {
      return std::abs(glm::length(glm::dvec3(at) - 28.0) - 18) < 0.5 ? 1.0 : 0.0;
    } },
  { "CrossedSheets", [](const glm::ivec3& at) { return at.x == 8 || at.y == 40 ? 1.0 : 0.0; } },
};

/// The same everywhere but for cuts along z, as the tests below need it.
const Cut AllCuts[] = {
  { "Whole", [](Scene&) {} },
  { "Plane",
    [](Scene& scene) {
      AddPlane(scene, { -1, 0.6, 0 }, { 0.21, 0, 0 });
    } },
  { "CroppedToARing",
    [](Scene& scene) {
      scene.Mapper->CroppingOn();
      scene.Mapper->SetCroppingRegionPlanes(-0.2, 0.13, -0.11, 0.17, -2, 2);
      scene.Mapper->SetCroppingRegionFlags(~(VTK_CROP_SUBVOLUME) & ((1 << 27) - 1));
    } },
};

/// Where haze is.
enum Hazes
{
  NoHaze,
  TwoSheets, ///< before and behind all
  Faces,     ///< of the box
};

bool IsHazy(Hazes haze, const glm::ivec3& at, int last)
{
  const bool sheets = at.z == 0 || at.z == last;
  return haze != NoHaze &&
    (sheets || (haze == Faces && (at.x == 0 || at.x == last || at.y == 0 || at.y == last)));
}

/// The data between sheets of haze, in which all eye rays begin and end: both ways then take their samples at
/// the same places.
struct LeapScene : Scene
{
  explicit LeapScene(const Data& data, int points = Few, Hazes haze = TwoSheets, double air = 0)
    : Scene(MakeImage(glm::ivec3(points), glm::dvec3(1),
              [&](const glm::dvec3& p) {
                const glm::ivec3 at(glm::round((p + 0.5) * double(points - 1)));
                return IsHazy(haze, at, points - 1) ? 0.01 : std::max(data.Of(at), air);
              }),
        40)
  {
    this->Mapper->SetIntegratorToErrorControlled();
    this->Mapper->SetLightCachesToNever();
    this->Mapper->SetMaximumError(0.01);
    this->Mapper->SetTransmittanceThreshold(0);
    this->Mapper->GetStatistics()->CountTapsOn();
    this->Medium->SetExtinctionArrayName("");
    this->Medium->SetExtinctionScale(40);
    this->LookParallel({ 0, 0, -1 }, 2, 0.52);
    this->AddBeam({ 1, -0.8, -0.2 });
    this->AddPointLight({ 0.9, 0.6, 0.4 });
  }

  Picture RenderPlainly()
  {
    vtkShaderProperty* code = this->Volume->GetShaderProperty();
    code->AddFragmentShaderReplacement(
      "//VTK::Medium::Coefficients::Impl", true, "// as they are\n", false);
    const Picture picture = this->Render();
    code->ClearAllFragmentShaderReplacements();
    return picture;
  }
};

struct LeapsTest : testing::TestWithParam<std::tuple<Data, Cut>>
{
};

struct LeapsInAirTest : testing::TestWithParam<std::tuple<Data, bool>>
{
};

struct MovedCutsTest : testing::TestWithParam<Data>
{
};

/// Leaping and plainly, by turns.
void ExpectLeapsToShowWhatStepsShow(LeapScene& scene)
{
  vtkMediumStatistics* statistics = scene.Mapper->GetStatistics();
  const Picture leapt = scene.Render();
  const vtkTypeInt64 taps = statistics->GetTaps();
  const double step = statistics->GetEyeStep();
  EXPECT_GT(statistics->GetBricksLeapt(), 0);
  const Picture plain = scene.RenderPlainly();
  EXPECT_EQ(statistics->GetBricksLeapt(), 0);
  EXPECT_NEAR(statistics->GetEyeStep(), step, 1e-4 * step);
  ASSERT_TRUE(plain.IsLight());
  ASSERT_TRUE(scene.Errors.empty());
  // The steps that the two find differ by rounding, and so do the places of their samples.
  EXPECT_LT(Difference(leapt, plain), 2e-5) << "of a picture whose alpha is up to 1";
  EXPECT_LE(taps, 1.01 * statistics->GetTaps()) << "asking is a tap, too";
}
}

TEST_P(LeapsTest, ShowWhatStepsShow)
{
  LeapScene scene(std::get<0>(GetParam()));
  std::get<1>(GetParam()).Apply(scene);
  ExpectLeapsToShowWhatStepsShow(scene);
}

INSTANTIATE_TEST_SUITE_P(Of, LeapsTest,
  testing::Combine(testing::ValuesIn(AllData), testing::ValuesIn(AllCuts)),
  [](const auto& parameters) {
    return std::string(std::get<0>(parameters.param).Name) + std::get<1>(parameters.param).Name;
  });

// Faces of bricks are at multiples of 1/7 from -1/2 on: on them, beside them and between them.
TEST_P(MovedCutsTest, ShowWhatStepsShow)
{
  LeapScene scene(GetParam());
  vtkSmartPointer<vtkPlane> plane = AddPlane(scene, { -1, 0.6, 0 }, { 0.3, 0, 0 });
  scene.Mapper->CroppingOn();
  scene.Mapper->SetCroppingRegionFlags(~(VTK_CROP_SUBVOLUME) & ((1 << 27) - 1));
  for (double at : { 1.0 / 14, 1.0 / 14 + 1e-3, 0.13, 0.2, 3.0 / 14 })
  {
    SCOPED_TRACE(at);
    scene.Mapper->SetCroppingRegionPlanes(-at, 0.5 * at, -1.5 * at, at, -2, 2);
    ExpectLeapsToShowWhatStepsShow(scene);
    plane->SetOrigin(0.5 - 2 * at, 0, 0);
    ExpectLeapsToShowWhatStepsShow(scene);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, MovedCutsTest, testing::ValuesIn(AllData),
  [](const auto& parameters) { return std::string(parameters.param.Name); });

// Rays of a perspective view, and light that is marched or from caches. Marched, samples are at places that
// differ by the rounding of the steps; with caches both take the shortest step, and are off by the build of the
// caches of lamps, which interpolates more of them where less is occupied.
TEST_P(LeapsInAirTest, ShowWhatStepsThroughAirShow)
{
  const auto& [data, caches] = GetParam();
  LeapScene leaping(data, Few, Faces), airy(data, Few, Faces, 1e-9);
  for (LeapScene* scene : { &leaping, &airy })
  {
    caches ? scene->Mapper->SetLightCachesToAlways() : scene->Mapper->SetLightCachesToNever();
    scene->Mapper->SetMaximumError(caches ? 1e-5 : 0.01);
    scene->Camera->ParallelProjectionOff();
    scene->Look({ 0.4, -0.3, -1 }, 2.4);
  }
  const Picture leapt = leaping.Render(), plain = airy.Render();
  vtkMediumStatistics *few = leaping.Mapper->GetStatistics(), *all = airy.Mapper->GetStatistics();
  EXPECT_GT(few->GetBricksLeapt(), 0);
  EXPECT_EQ(all->GetBricksLeapt(), 0);
  EXPECT_LT(2 * few->GetTaps(), all->GetTaps());
  EXPECT_NEAR(few->GetEyeStep(), all->GetEyeStep(), caches ? 0 : 1e-3 * all->GetEyeStep());
  for (vtkMediumStatistics* each : { few, all })
  {
    EXPECT_EQ(each->GetLightMethod(),
      caches ? vtkMediumStatistics::LightLookedUp : vtkMediumStatistics::LightMarched);
  }
  ASSERT_TRUE(leapt.IsLight() && plain.IsLight());
  EXPECT_LT(Difference(leapt, plain), 2e-4) << "of a picture whose alpha is up to 1";
}

INSTANTIATE_TEST_SUITE_P(Of, LeapsInAirTest,
  testing::Combine(testing::ValuesIn(AllData), testing::Bool()), [](const auto& parameters) {
    return std::string(std::get<0>(parameters.param).Name) +
      (std::get<1>(parameters.param) ? "LookedUp" : "Marched");
  });

// A ball: 95 in 100 voxels are empty.
TEST(Leaps, TakeAnEighthOfTheTapsWhereAlmostAllIsEmpty)
{
  const Data ball = { "Ball",
    [](const glm::ivec3& at) { return glm::length(glm::dvec3(at) - 52.0) < 26 ? 1.0 : 0.0; } };
  for (bool lit : { false, true })
  {
    LeapScene scene(ball, Many, NoHaze);
    scene.Mapper->SetLightCachesToWhereAccurate();
    lit ? scene.Mapper->SetOutputToRadiance() : scene.Mapper->SetOutputToOpticalDepth();
    vtkDataArray* density = scene.Mapper->GetInput()->GetPointData()->GetScalars();
    const vtkIdType voxels = density->GetNumberOfTuples();
    vtkIdType empty = 0;
    for (vtkIdType i = 0; i < voxels; ++i)
    {
      empty += density->GetComponent(i, 0) == 0;
    }
    ASSERT_NEAR(static_cast<double>(empty) / voxels, 0.95, 0.005);
    scene.Render();
    const vtkTypeInt64 taps = scene.Mapper->GetStatistics()->GetTaps();
    scene.RenderPlainly();
    const vtkTypeInt64 plain = scene.Mapper->GetStatistics()->GetTaps();
    EXPECT_LT(8 * taps, plain) << taps << " of " << plain;
  }
}
