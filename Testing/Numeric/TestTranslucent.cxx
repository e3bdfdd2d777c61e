// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Translucent geometry with a volume. VTK draws all of it before all volumes, with depth peeling and
// without, so it is right behind the medium; in front of it, a renderer of a layer above is. Where peeling
// takes volumes too (UseDepthPeelingForVolumes), it is right anywhere.
#include "OpaquePlane.h"

#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace vtkMediumTest;

namespace
{
constexpr int Side = 16;
constexpr double Opacity = 0.6;
const glm::dvec3 Background(0.2, 0.4, 0.6), Glass(0.9, 0.3, 0.1);

/// A box in a beam, and a pane of glass with an unlit colour, across the whole view at a height z.
struct GlassScene : Scene
{
  explicit GlassScene(bool peeling)
    : Scene(MakeBox(), Side)
  {
    this->Medium->SetExtinction(1);
    this->AddBeam({ 0.3, -1, -0.2 })->SetIntensity(6);
    this->Renderer->SetBackground(Background.x, Background.y, Background.z);
    this->Renderer->SetUseDepthPeeling(peeling);
    this->Window->SetAlphaBitPlanes(1);
  }

  void AddGlass(vtkRenderer* renderer, double z)
  {
    vtkSmartPointer<vtkActor> glass = Plane{ { 0, 0, 1 }, z }.AddTo(renderer);
    glass->GetProperty()->SetOpacity(Opacity);
    glass->GetProperty()->SetColor(Glass.x, Glass.y, Glass.z);
    glass->GetProperty()->LightingOff();
  }

  /// The largest difference of the window from the float image, composed with `before` it and `behind` it.
  double DifferenceFrom(bool before, bool behind)
  {
    const std::vector<unsigned char> shown = this->RenderWindow();
    vtkNew<vtkImageData> image;
    this->Mapper->GetColorImage(image);
    const Picture medium(image);
    double largest = 0;
    for (int y = 0; y < Side; ++y)
    {
      for (int x = 0; x < Side; ++x)
      {
        for (int c = 0; c < 3; ++c)
        {
          const double far = behind ? this->Over(Background[c], c) : Background[c];
          const double seen = medium.At(x, y, c) + (1 - medium.At(x, y, 3)) * far;
          const double expected = before ? this->Over(seen, c) : seen;
          const double found = shown[3 * (y * Side + x) + c] / 255.0;
          largest = std::max(largest, std::abs(found - std::min(expected, 1.0)));
        }
      }
    }
    return largest;
  }

private:
  static double Over(double behind, int channel)
  {
    return Opacity * Glass[channel] + (1 - Opacity) * behind;
  }
};

constexpr double Rounding = 2.5 / 255; // of up to three blends into eight bits
}

TEST(Translucent, GlassBehindTheMediumIsSeenThroughIt)
{
  for (bool peeling : { false, true })
  {
    SCOPED_TRACE(testing::Message() << "peeling " << peeling);
    GlassScene scene(peeling);
    EXPECT_LT(scene.DifferenceFrom(false, false), Rounding);
    scene.AddGlass(scene.Renderer, -0.6);
    EXPECT_LT(scene.DifferenceFrom(false, true), Rounding);
    EXPECT_GT(scene.DifferenceFrom(false, false), 10 * Rounding);
    EXPECT_EQ(scene.Renderer->GetLastRenderingUsedDepthPeeling(), peeling);
    EXPECT_TRUE(scene.Errors.empty());
  }
}

TEST(Translucent, GlassInFrontIsDrawnBehindAllVolumes)
{
  for (bool peeling : { false, true })
  {
    SCOPED_TRACE(testing::Message() << "peeling " << peeling);
    GlassScene scene(peeling);
    scene.AddGlass(scene.Renderer, 0.6);
    EXPECT_LT(scene.DifferenceFrom(false, true), Rounding); // the limit, as documented
    EXPECT_GT(scene.DifferenceFrom(true, false), 5 * Rounding);
  }
}

TEST(Translucent, GlassInFrontIsRightInALayerAbove)
{
  GlassScene scene(false);
  vtkNew<vtkRenderer> above;
  above->SetActiveCamera(scene.Camera);
  above->SetLayer(1);
  scene.Window->SetNumberOfLayers(2);
  scene.Window->AddRenderer(above);
  scene.AddGlass(above, 0.6);
  scene.AddGlass(scene.Renderer, -0.6);
  EXPECT_LT(scene.DifferenceFrom(true, true), Rounding);
  EXPECT_TRUE(scene.Errors.empty());
}

namespace
{
// Eight bits in each of some ten blends into the targets of peeling.
constexpr double PeelRounding = 6.0 / 255;

/// A scene whose volume is peeled, at a distance of 3.
struct PeeledScene : GlassScene
{
  explicit PeeledScene(int integrator)
    : GlassScene(true)
  {
    this->Mapper->SetIntegrator(integrator);
    this->Mapper->SetJitter(0); // Paper: each piece of a ray would have its own
    this->SetSteps(0.01, 0.05);
    this->Renderer->UseDepthPeelingForVolumesOn();
    this->Renderer->SetMaximumNumberOfPeels(10);
  }

  /// The medium beyond a height, as a camera sees it whose near plane is there: light is not cut.
  Picture Below(double z)
  {
    this->Renderer->UseDepthPeelingForVolumesOff();
    double range[2];
    this->Camera->GetClippingRange(range);
    this->Camera->SetClippingRange(3 - z, range[1]);
    const Picture picture = this->Render();
    this->Camera->SetClippingRange(range);
    this->Renderer->UseDepthPeelingForVolumesOn();
    return picture;
  }

  /// The largest difference of the window from panes at these heights, highest first, before `behind`.
  double DifferenceFrom(const std::vector<double>& panes, const glm::dvec3& behind)
  {
    const std::vector<unsigned char> shown = this->RenderWindow();
    std::vector<Picture> below{ this->Below(2) };
    for (double z : panes)
    {
      below.push_back(this->Below(z));
    }
    below.push_back(this->Below(-0.4999)); // a volume behind the near plane as a whole is not drawn
    double largest = 0;
    for (std::size_t i = 0; i < shown.size(); ++i)
    {
      const int pixel = static_cast<int>(i / 3), x = pixel % Side, y = pixel / Side, c = i % 3;
      double seen = behind[c];
      for (std::size_t layer = panes.size() + 1; layer-- > 0;)
      {
        seen = layer < panes.size() ? Opacity * Glass[c] + (1 - Opacity) * seen : seen;
        const Picture &whole = below[layer], &rest = below[layer + 1];
        const double passes = (1 - whole.At(x, y, 3)) / (1 - rest.At(x, y, 3));
        seen = whole.At(x, y, c) - passes * rest.At(x, y, c) + passes * seen;
      }
      largest = std::max(largest, std::abs(shown[i] / 255.0 - std::min(seen, 1.0)));
    }
    return largest;
  }
};

class PeeledVolumes : public testing::TestWithParam<int>
{
};
}

TEST_P(PeeledVolumes, MixWithGlassBeforeInAndBehindThem)
{
  for (bool parallel : { false, true })
  {
    SCOPED_TRACE(testing::Message() << "parallel " << parallel);
    PeeledScene scene(GetParam());
    scene.Camera->SetParallelProjection(parallel);
    scene.Camera->SetParallelScale(0.8);
    EXPECT_LT(scene.DifferenceFrom({}, Background), PeelRounding);
    std::vector<double> panes;
    for (double z : { -0.49, -0.2, 0.2, 0.6 }) // inside, and before all
    {
      const std::vector<double> before = panes;
      scene.AddGlass(scene.Renderer, z);
      panes.insert(panes.begin(), z);
      EXPECT_LT(scene.DifferenceFrom(panes, Background), PeelRounding) << z;
      EXPECT_GT(scene.DifferenceFrom(before, Background), 2 * PeelRounding) << z;
    }
    EXPECT_TRUE(scene.Errors.empty());
  }
}

TEST_P(PeeledVolumes, EndAtOpaqueGeometry)
{
  const glm::dvec3 paint(0.1, 0.8, 0.3);
  PeeledScene scene(GetParam());
  vtkSmartPointer<vtkActor> wall = Plane{ { 0, 0, 1 }, -0.25 }.AddTo(scene.Renderer);
  wall->GetProperty()->SetColor(paint.x, paint.y, paint.z);
  wall->GetProperty()->LightingOff();
  const std::vector<double> panes{ 0.3, 0.1 };
  for (double z : { 0.3, 0.1, -0.4 })
  {
    scene.AddGlass(scene.Renderer, z);
  }
  EXPECT_LT(scene.DifferenceFrom(panes, paint), PeelRounding);
  EXPECT_GT(scene.DifferenceFrom(panes, Background), 2 * PeelRounding);
  EXPECT_TRUE(scene.Errors.empty());
}

// Shadow maps are drawn in the middle of a peel, of actors that are marked as peeled.
TEST_P(PeeledVolumes, KeepTheShadowsOfOpaqueGeometry)
{
  auto shadowed = [](PeeledScene& scene) {
    scene.Mapper->OpaqueShadowsOn();
    Quad{ { -0.3, 0.7, -0.6 }, { 0.5, 0, 0 }, { 0, 0, 1 } }.AddTo(scene.Renderer);
  };
  PeeledScene scene(GetParam());
  const std::vector<unsigned char> bright = scene.RenderWindow();
  shadowed(scene);
  const std::vector<unsigned char> peeled = scene.RenderWindow();
  EXPECT_EQ(scene.Mapper->GetStatistics()->GetShadowMapBuilds(), 1);
  PeeledScene whole(GetParam());
  shadowed(whole);
  whole.Renderer->UseDepthPeelingForVolumesOff();
  const std::vector<unsigned char> expected = whole.RenderWindow();
  int darker = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(peeled[i], expected[i], 3) << i;
    darker += bright[i] - expected[i] > 12;
  }
  EXPECT_GT(darker, 30);
}

INSTANTIATE_TEST_SUITE_P(Translucent, PeeledVolumes,
  testing::Values(vtkSingleScatteringVolumeMapper::Paper,
    vtkSingleScatteringVolumeMapper::FixedStep, vtkSingleScatteringVolumeMapper::ErrorControlled,
    vtkSingleScatteringVolumeMapper::Exact));

TEST(Translucent, PeelingShowsRadianceInTheWindowOnly)
{
  const std::function<void(PeeledScene&)> causes[] = {
    [](PeeledScene& scene) { scene.Mapper->SetOutputToTransmittance(); },
    [](PeeledScene& scene) { scene.Mapper->SetBlendModeToAdditive(); },
    [](PeeledScene& scene) { scene.Mapper->RenderToImageOn(); },
  };
  for (const auto& cause : causes)
  {
    PeeledScene scene(vtkSingleScatteringVolumeMapper::FixedStep);
    scene.AddGlass(scene.Renderer, 0.1);
    cause(scene);
    scene.Window->Render();
    scene.Window->Render();
    ASSERT_EQ(scene.Errors.size(), 1u);
    EXPECT_NE(scene.Errors[0].find("UseDepthPeelingForVolumesOff"), std::string::npos);
    scene.Mapper->SetOutputToRadiance();
    scene.Mapper->SetBlendModeToComposite();
    scene.Mapper->RenderToImageOff();
    const std::vector<unsigned char> mixed = scene.RenderWindow();
    EXPECT_EQ(scene.Errors.size(), 1u);
    scene.Render(); // a picture of which there are only pieces
    EXPECT_EQ(scene.Errors.size(), 2u);
    scene.Renderer->UseDepthPeelingForVolumesOff();
    const Picture whole = scene.Render();
    EXPECT_GT(whole.At(Side / 2, Side / 2, 3), 0.5);
    scene.Renderer->UseDepthPeelingForVolumesOn();
    EXPECT_EQ(scene.RenderWindow(), mixed);
    EXPECT_EQ(scene.Errors.size(), 2u);
  }
}

// As VTK's own mapper: by the order of adding, or from the back to the front by the culler.
TEST(Translucent, VolumesAreSortedWhereTheCullerDoesSo)
{
  for (bool nearFirst : { false, true })
  {
    GlassScene scene(false);
    scene.Renderer->SetBackground(0, 0, 0);
    scene.Medium->SetExtinction(5);
    scene.Medium->SetAlbedo(0); // black
    vtkNew<vtkParticipatingMedium> white;
    white->SetExtinction(5);
    vtkNew<vtkSingleScatteringVolumeMapper> mapper;
    mapper->SetInputDataObject(scene.Mapper->GetDataObjectInput());
    mapper->SetMedium(white);
    vtkNew<vtkVolume> nearer;
    nearer->SetMapper(mapper);
    nearer->SetPosition(0, 0, 1.2);
    scene.Look({ 0, 0, -1 }, 6);
    if (nearFirst)
    {
      scene.Renderer->RemoveVolume(scene.Volume);
    }
    scene.Renderer->AddVolume(nearer);
    scene.Renderer->AddVolume(scene.Volume);
    const std::size_t middle = 3 * (Side / 2 * Side + Side / 2);
    const int byOrder = scene.RenderWindow()[middle];
    vtkFrustumCoverageCuller::SafeDownCast(scene.Renderer->GetCullers()->GetLastItem())
      ->SetSortingStyleToBackToFront();
    const int sorted = scene.RenderWindow()[middle];
    EXPECT_GT(sorted, 20);
    EXPECT_EQ(nearFirst ? byOrder < 10 : byOrder == sorted, true) << byOrder << ", " << sorted;
  }
}
