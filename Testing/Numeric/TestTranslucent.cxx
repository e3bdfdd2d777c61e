// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Translucent geometry with a volume: VTK draws all of it before all volumes, with depth peeling and
// without. So it is right behind the medium; in front of it, a renderer of a layer above is.
#include "OpaquePlane.h"

#include "vtkCullerCollection.h"
#include "vtkFrustumCoverageCuller.h"
#include "vtkProperty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
