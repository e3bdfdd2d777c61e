// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows 30 to 37: where the volume, the camera and the lights are, in which units.
#include "StressRefusal.h"
#include "vtkMediumTestMatrix.h"

#include "vtkMediumFormulas.h"

namespace vtkMediumStress
{
namespace
{
/// S; two frames of ErrorControlled may each be off by its error, estimated within a factor of two.
double SameFrames(const Trial& trial)
{
  return trial.Is(Mapper::ErrorControlled) ? 4 * ControlledError : Same;
}

/// A field without symmetry, linear in space. Paper fills all of it.
struct SlopeStage : Stage
{
  SlopeStage(Trial& trial, double unit = 1, const glm::dvec3& center = glm::dvec3(0))
    : Stage(trial, MakeSlope(unit, center))
  {
    if (trial.Is(vtkMediumStress::Mapper::Paper))
    {
      this->Mapper->SetPaperThreshold(0);
    }
    else
    {
      this->SetField(5 / unit);
    }
    this->SetSigma(5 / unit);
    this->SetSteps(0.02 * unit, 0.1 * unit);
    this->Place(glm::dmat3(1), unit, center);
  }

  static vtkSmartPointer<vtkImageData> MakeSlope(double unit, const glm::dvec3& center)
  {
    const glm::dvec3 size = unit * glm::dvec3(1, 0.75, 0.5);
    auto image = MakeImage(glm::ivec3(3), size, [&](const glm::dvec3& p) {
      return 0.2 + 0.5 * (p.x / size.x + 0.5) + 0.2 * (p.y / size.y + 0.5) +
        0.1 * (p.z / size.z + 0.5);
    });
    const glm::dvec3 origin = center - 0.5 * size;
    image->SetOrigin(origin.x, origin.y, origin.z);
    return image;
  }

  /// Camera and lights, turned about the world's origin.
  void Place(const glm::dmat3& turn, double unit, const glm::dvec3& center)
  {
    const glm::dvec3 up = turn * glm::dvec3(0, 1, 0);
    this->Look(turn * glm::dvec3(0.3, 0.2, -1), 2.5 * unit, center);
    this->Camera->SetViewUp(up.x, up.y, up.z);
    this->Renderer->RemoveAllLights();
    this->AddBeam(turn * glm::dvec3(1, -0.5, -0.3));
    this->AddPointLight(center + turn * (unit * glm::dvec3(0.2, 1, 0.5)))
      ->SetIntensity(unit * unit);
  }
};

/// The 24 rotations of a cube.
std::vector<glm::dmat3> CubeRotations()
{
  std::vector<glm::dmat3> rotations;
  for (int x = 0; x < 3; ++x)
  {
    for (int y = 0; y < 3; ++y)
    {
      for (int signs = 0; x != y && signs < 4; ++signs)
      {
        glm::dmat3 turn(0);
        turn[0][x] = signs & 1 ? -1 : 1;
        turn[1][y] = signs & 2 ? -1 : 1;
        turn[2] = glm::cross(turn[0], turn[1]);
        rotations.push_back(turn);
      }
    }
  }
  return rotations;
}

void Turned(Trial& trial)
{
  SlopeStage stage(trial);
  const Picture reference = stage.Render();
  for (const glm::dmat3& turn : CubeRotations())
  {
    SetUserMatrix(stage.Volume, turn, glm::dvec3(0));
    stage.Place(turn, 1, glm::dvec3(0));
    CheckSame(trial, reference, stage.Render(), SameFrames(trial), "all turned");
  }
}

void Units(Trial& trial)
{
  const Picture reference = SlopeStage(trial).Render();
  for (double unit : { 1e-12, 1e-6, 1e-3, 1e3, 1e6, 1e12 })
  {
    CheckSame(trial, reference, SlopeStage(trial, unit).Render(), SameFrames(trial),
      "unit " + std::to_string(unit));
  }
}

void Origins(Trial& trial)
{
  const Picture reference = SlopeStage(trial).Render();
  for (double far : { 1e6, 1e9 })
  {
    CheckSame(trial, reference, SlopeStage(trial, 1, { far, -2 * far, far }).Render(), 1e-3,
      "origin " + std::to_string(far));
  }
}

void Spacings(Trial& trial)
{
  SlopeStage stage(trial);
  const Picture reference = stage.Render();
  vtkImageData* image = vtkImageData::SafeDownCast(stage.Mapper->GetDataObjectInput());
  glm::dvec3 spacing, origin;
  image->GetSpacing(&spacing[0]);
  image->GetOrigin(&origin[0]);
  for (const glm::dvec3& ratio :
    { glm::dvec3(1e-9), { 1000, 1, 1 }, { 1, 1e-3, 1 }, { 1e3, 1, 1e-3 } })
  {
    const glm::dvec3 s = spacing * ratio, o = origin * ratio;
    image->SetSpacing(s.x, s.y, s.z);
    image->SetOrigin(o.x, o.y, o.z);
    stage.Volume->SetScale(1 / ratio.x, 1 / ratio.y, 1 / ratio.z);
    CheckSame(trial, reference, stage.Render(), SameFrames(trial), "spacing undone by the scale");
  }
}

void Matrices(Trial& trial)
{
  SlopeStage stage(trial);
  const Picture reference = stage.Render();
  const glm::dmat3 mirror(-1, 0, 0, 0, 1, 0, 0, 0, 1);
  SetUserMatrix(stage.Volume, mirror, glm::dvec3(0));
  stage.Place(mirror, 1, glm::dvec3(0));
  Picture mirrored = stage.Render();
  for (int y = 0; y < stage.Pixels; ++y)
  {
    for (int x = 0; x < stage.Pixels / 2; ++x)
    {
      const int here = 4 * (y * stage.Pixels + x),
                there = 4 * (y * stage.Pixels + stage.Pixels - 1 - x);
      std::swap_ranges(&mirrored.Values[here], &mirrored.Values[here] + 4, &mirrored.Values[there]);
    }
  }
  CheckSame(trial, reference, mirrored, SameFrames(trial), "mirrored");

  const glm::dmat3 shear(1, 0, 0, 0.6, 1, 0, 0.2, -0.4, 1);
  const glm::dvec3 beam = glm::normalize(glm::dvec3(0.3, -0.8, -0.4));
  Stage sheared(trial, MakeBox());
  sheared.AddBeam(beam);
  sheared.Look({ 0.2, 0.1, -1 }, 2.5);
  sheared.SetSigma(3);
  sheared.SetFineSteps(3);
  SetUserMatrix(sheared.Volume, shear, { 0.1, 0, 0 });
  TruthA truth{ -beam, 3 };
  truth.Shape.Axes = shear;
  truth.Shape.Origin = shear * glm::dvec3(-0.5) + glm::dvec3(0.1, 0, 0);
  truth.Check(sheared, "sheared", 2); // grazing rays meet oblique faces within some 1e-6

  CheckRefusal(
    trial, "singular", [](Stage& s) { SetUserMatrix(s.Volume, glm::dmat3(0), glm::dvec3(0)); },
    [](Stage& s) { s.Volume->SetUserMatrix(nullptr); });
}

/// In the formula itself: all combinations of tiny direction components and origins on faces.
void RaysAlongFaces(Trial& trial)
{
  for (float tiny : { 0.0f, -0.0f, 1e-38f, -1e-38f })
  {
    for (float x : { 0.0f, 0.5f, 1.0f })
    {
      for (float y : { 0.0f, 1.0f })
      {
        const glm::vec2 t =
          vtkMediumFormulas::Float::rayBox(glm::vec3(x, y, -1), glm::vec3(tiny, -tiny, 1));
        trial.Holds(t.x == 1 && t.y == 2, "a ray along a face hits");
      }
    }
  }
}

void CamerasOnFaces(Trial& trial)
{
  RaysAlongFaces(trial);
  const glm::dvec3 beam = glm::normalize(glm::dvec3(0.3, -0.8, -0.4));
  Stage stage(trial, MakeBox(), 9);
  stage.AddBeam(beam);
  stage.SetSigma(2);
  stage.SetFineSteps(2);
  // Nine pixels: the middle ones have a direction component of 0.
  for (const glm::dvec3& middle : { glm::dvec3(0), { 0, 0.2, 0.3 } })
  {
    stage.Look({ 0, 0, -1 }, 2, middle);
    TruthA{ -beam, 2 }.Check(stage, "zero direction components");
  }
  // On the face x = 1/2: pixels on its two sides, and the middle column along it, hit or not.
  stage.Look({ 0, 0, -1 }, 2, { 0.5, 0, 0 });
  const Picture picture = stage.Render();
  double peak = 0;
  const TruthA truth{ -beam, 2 };
  ForEachPixel(
    stage, [&](int, int, const Ray& ray) { peak = std::max(peak, truth.Radiance(ray)); });
  ForEachPixel(stage, [&](int x, int y, const Ray& ray) {
    const bool missed = x == 4 && picture.At(x, y, 3) == 0;
    trial.AtMost(missed ? 0 : QError(trial, picture.At(x, y), truth.Radiance(ray), peak),
      stage.Allowed(2), "along a face");
  });
}

void CrossedFace(Trial& trial)
{
  Stage stage(trial, MakeBox(), 8);
  stage.AddBeam({ 0.2, -1, 0.1 });
  stage.SetSteps(0.01, 1);
  Picture before;
  for (double distance : { 0.5 + 1e-6, 0.5, 0.5 - 1e-6 })
  {
    stage.Look({ 0, 0, -1 }, distance);
    stage.Camera->SetClippingRange(1e-7, 10);
    const Picture picture = stage.Render();
    if (!before.Values.empty())
    {
      CheckSame(trial, before, picture, trial.Is(Mapper::ErrorControlled) ? 2e-4 : 1e-4,
        "camera 1e-6 farther in");
    }
    before = picture;
  }
}

void NearPlaneInside(Trial& trial)
{
  const glm::dvec3 beam = glm::normalize(glm::dvec3(0.3, -0.8, 0.4));
  Stage stage(trial, MakeBox());
  stage.AddBeam(beam);
  stage.SetSigma(3);
  stage.SetFineSteps(3);
  for (double nearest : { 1e-4, 0.3, 0.9 })
  {
    stage.Look({ 0.1, 0.2, -1 }, 0.7);
    stage.Camera->SetClippingRange(nearest, 10);
    TruthA{ -beam, 3 }.Check(stage, "near plane, perspective");
    stage.LookParallel({ 0.1, 0.2, -1 }, 0.7, 0.6);
    stage.Camera->SetClippingRange(nearest, 10);
    TruthA{ -beam, 3 }.Check(stage, "near plane, parallel");
    stage.Camera->ParallelProjectionOff();
  }
}
}

std::vector<Row> PlacementRows()
{
  return {
    { 30, "TurningEverythingChangesNothing", "S; ErrorControlled: twice its error for each frame",
      Turned, {} },
    { 31, "UnitsDoNotMatter", "as row 30", Units, {} },
    { 32, "FarOriginsDoNotMatter", "1e-3: a double at 1e9 resolves 1e-7", Origins, {} },
    { 33, "SpacingIsOnlyAScale", "as row 30", Spacings, {} },
    { 34, "MirrorsAndShearsAreRightAndZeroIsRefused", "as row 30; truth A, twice Q; E", Matrices,
      {} },
    { 35, "RaysAlongAxesAndFacesHit", "Q", CamerasOnFaces, {} },
    { 36, "CrossingAFaceIsContinuous", "1e-4; ErrorControlled: its error, twice", CrossedFace, {} },
    { 37, "NearPlaneInsideLeavesNoHole", "as row 2", NearPlaneInside, {} },
  };
}
}
