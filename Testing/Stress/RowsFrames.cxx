// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Rows 49, 53, 54, 59 and 60: several volumes, windows and frames.
#include "FuzzedScene.h"
#include "StressStage.h"

#include "vtkMediumTestHeadset.h"

#include "vtkHardwareSelector.h"
#include "vtkSingleScatteringReference.h"

namespace vtkMediumStress
{
namespace
{
vtkSmartPointer<vtkImageData> MakeMedium(const Trial& trial)
{
  return trial.Is(Mapper::Paper)
    ? MakeImage(
        glm::ivec3(9), glm::dvec3(1), [](const glm::dvec3& p) { return 1 - glm::length(p); })
    : vtkMediumFixtures::MakeImage(vtkMediumFixtures::Smooth, glm::ivec3(9));
}

/// A field, or in Paper a ball.
struct FieldStage : Stage
{
  explicit FieldStage(Trial& trial, int pixels = 16)
    : Stage(trial, MakeMedium(trial), pixels)
  {
    if (!trial.Is(vtkMediumStress::Mapper::Paper))
    {
      this->SetField(3);
    }
    this->SetSigma(2);
    this->AddBeam({ 1, -1, -0.3 });
    this->Look({ 0.3, 0.2, -1 }, 2);
    this->SetSteps(0.05, 0.05);
  }
};

/// Cropping a volume to its front or back half is the same: what is left out casts no shadow.
void CropHalves(Stage& whole, const Picture& one, const Picture& front)
{
  Trial& trial = whole.Cell;
  whole.Mapper->CroppingOn();
  Picture halves[2] = { one, one };
  for (int half : { 0, 1 })
  {
    whole.Mapper->SetCroppingRegionPlanes(-1, 1, -1, 1, half == 0 ? 0 : -1, half == 0 ? 1 : 0);
    whole.Mapper->SetCroppingRegionFlagsToSubVolume();
    halves[half] = whole.Render();
  }
  double worst = 0;
  for (std::size_t i = 3; i < one.Values.size(); i += 4)
  {
    worst = std::max(worst,
      std::abs((1.0 - halves[0].Values[i]) * (1.0 - halves[1].Values[i]) - (1.0 - one.Values[i])));
  }
  trial.AtMost(worst, Same, "product of the cropped halves' transmittances");
  // Their steps begin elsewhere than those of a volume of its own.
  trial.AtMost(Difference(front, halves[0]),
    trial.Is(Mapper::Paper)         ? 0.01
      : trial.Is(Mapper::FixedStep) ? Same
                                    : 4e-4,
    "a cropped half is a volume of its own");
}

/// Front and back half as volumes of their own: their transmittances multiply, and as documented neither
/// darkens the other's light.
void SplitVolume(Trial& trial)
{
  const glm::dvec3 beam = glm::normalize(glm::dvec3(0, -1, -0.5));
  Stage whole(trial, MakeBox());
  whole.SetSigma(2);
  whole.SetFineSteps(2);
  whole.LookParallel({ 0, 0, -1 }, 2, 0.45);
  whole.AddBeam(beam);
  const Picture one = whole.Render();

  Stage halves(trial, MakeBox({ 1, 1, 0.5 }));
  halves.SetSigma(2);
  halves.SetFineSteps(2);
  halves.LookParallel({ 0, 0, -1 }, 2, 0.45);
  halves.AddBeam(beam);
  halves.Volume->SetPosition(0, 0, 0.25);
  vtkNew<vtkSingleScatteringVolumeMapper> mapper;
  mapper->SetInputData(MakeBox({ 1, 1, 0.5 }));
  mapper->SetMedium(halves.Medium);
  mapper->SetIntegrator(trial.Integrator);
  mapper->SetTransmittanceThreshold(0);
  mapper->SetJitter(0);
  mapper->SetSampleDistance(halves.Mapper->GetSampleDistance());
  mapper->SetLightSampleDistance(0.3);
  vtkNew<vtkVolume> back;
  back->SetMapper(mapper);
  back->SetPosition(0, 0, -0.25);
  halves.Renderer->AddVolume(back);
  const Picture front = halves.Render();
  vtkNew<vtkImageData> image;
  mapper->GetColorImage(image);
  const Picture behind(image);
  double worst = 0;
  for (std::size_t i = 3; i < one.Values.size(); i += 4)
  {
    worst = std::max(
      worst, std::abs((1.0 - front.Values[i]) * (1.0 - behind.Values[i]) - (1.0 - one.Values[i])));
  }
  trial.AtMost(worst, Same, "product of the halves' transmittances");
  trial.AtMost(Difference(front, behind), trial.Is(Mapper::ErrorControlled) ? 4e-4 : 1e-5,
    "neither shadows the other: the halves look the same");
  CropHalves(whole, one, front);
}

/// What a selector finds in a viewport of the window's lower right quarter is what its picture shows.
void SelectInViewport(FieldStage& stage, const Picture& picture)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetArea(16, 0, 31, 15);
  stage.Cell.Holds(selector->CaptureBuffers(), "a selector captures the viewport");
  int wrong = 0, seen = 0;
  const double least = 3.0 / 255; // of the light that is lost, as the mapper documents
  for (unsigned y = 0; y < 16; ++y)
  {
    for (unsigned x = 0; x < 16; ++x)
    {
      const unsigned pixel[2] = { 16 + x, y };
      const bool found = selector->GetPixelInformation(pixel).Prop == stage.Volume.Get();
      const double alpha = picture.At(x, y, 3);
      seen += found;
      wrong += found != (alpha > least) && std::abs(alpha - least) > 2e-3;
    }
  }
  selector->ClearBuffers();
  stage.Cell.Holds(seen > 20, "the selector sees the volume");
  stage.Cell.Holds(wrong == 0, "the selector sees what the picture shows");
}

void OddSizes(Trial& trial)
{
  FieldStage whole(trial);
  const Picture reference = whole.Render();
  FieldStage stage(trial);
  stage.Window->SetSize(32, 32);
  stage.Renderer->SetViewport(0.5, 0, 1, 0.5);
  CheckSame(trial, reference, stage.Render(), Same, "a viewport of a window is its own image");
  SelectInViewport(stage, reference);
  for (const glm::ivec2& size : { glm::ivec2(1, 1), { 1, 40 }, { 64, 3 }, { 32, 32 } })
  {
    stage.Window->SetSize(size.x, size.y);
    stage.Renderer->SetViewport(0, 0, 1, 1);
    const Picture picture = stage.Render();
    trial.Holds(picture.Size == size, "the image follows the window's size");
  }
  stage.Renderer->SetViewport(0.5, 0.5, 0.5, 0.5);
  stage.Window->Render();
  trial.Holds(stage.Errors.empty(), "a viewport without pixels shows nothing and says nothing");
  stage.Renderer->SetViewport(0.5, 0, 1, 0.5);
  CheckSame(trial, reference, stage.Render(), Same, "and back");
}

void Released(Trial& trial)
{
  FieldStage stage(trial, 8), other(trial, 8);
  stage.AddBeam({ 0.2, -1, 0.1 }); // so that a table of lights is read
  const Picture first = stage.Render(), second = other.Render();
  vtkTypeInt64 bytes = 0; // from the first return on, which needs no probes any more
  for (int i = 0; i < 100; ++i)
  {
    stage.Mapper->ReleaseGraphicsResources(stage.Window);
    trial.Holds(first.Values == stage.Render().Values, "released and back, to the bit");
    const vtkTypeInt64 now = stage.Mapper->GetStatistics()->GetGPUBytes();
    trial.Holds(i == 0 || now == bytes, "bytes on the device stay");
    bytes = now;
    trial.Holds(i % 10 != 0 || second.Values == other.Render().Values, "the other window as well");
  }
  trial.Holds(
    stage.Mapper->GetStatistics()->GetFramesReused() == 0, "each frame was integrated anew");
}

/// The accurate modes against the reference, within half of what two renderers may differ.
void AgainstReference(Trial& trial)
{
  Stage stage(trial, vtkMediumFixtures::MakeImage(vtkMediumFixtures::Cloud, glm::ivec3(12)), 12);
  stage.SetField(5);
  stage.AddBeam({ 1, -0.8, -0.2 });
  stage.AddPointLight({ -0.9, 0.8, 0.5 });
  stage.Look({ 0.4, -0.3, -1 }, 2.2);
  stage.Medium->SetAnisotropy(0.4);
  stage.SetSteps(0.005, 0.01);
  const Picture picture = stage.Render();
  vtkNew<vtkSingleScatteringReference> reference;
  reference->SetVolume(stage.Volume);
  reference->SetMedium(stage.Medium);
  reference->SetRenderer(stage.Renderer);
  reference->SetTolerance(1e-6);
  vtkNew<vtkImageData> image;
  trial.Holds(reference->GetColorImage(image), "there is a reference");
  const double* truth = static_cast<const double*>(image->GetScalarPointer());
  double worst = 0, peak = 0;
  for (std::size_t i = 0; i < picture.Values.size(); ++i)
  {
    worst = std::max(worst, std::abs(picture.Values[i] - truth[i]) / (i % 4 == 3 ? 10 : 1));
    peak = i % 4 == 3 ? peak : std::max(peak, truth[i]);
  }
  trial.AtMost(worst / peak, 5e-4, "error, of the peak");
}

/// Seeds from 0 on, whatever integrators they choose; frames of 2 s on an idle machine are hangs, and
/// the longest of these take a fiftieth of it.
void RandomSettings(Trial& trial)
{
  int drawn = 0, refused = 0;
  vtkNew<vtkRenderWindow> window;
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    FuzzedScene scene(seed, window);
    for (int frame = 0; frame < FuzzedScene::Frames; ++frame)
    {
      const std::string problem = scene.Frame(frame);
      trial.Holds(problem.empty(), "seed " + std::to_string(seed) + ": " + problem);
      ++(scene.WasRefused() ? refused : drawn);
    }
  }
  trial.Holds(drawn > 100 && refused > 100, "both kinds occur");
}

/// Two eyes of a headset in one place see the same to the bit, and eyes apart do not.
void SameEyes(Trial& trial)
{
  FieldStage stage(trial);
  Headset headset;
  headset.PutOn(stage.Window, stage.Renderer);
  std::vector<Picture> eyes;
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(&eyes);
  listener->SetCallback([](vtkObject* mapper, unsigned long, void* pictures, void*) {
    vtkNew<vtkImageData> image;
    static_cast<Mapper*>(mapper)->GetColorImage(image);
    static_cast<std::vector<Picture>*>(pictures)->emplace_back(image);
  });
  const unsigned long watch =
    stage.Mapper->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, listener);
  for (double separation : { 0.0, 0.1 })
  {
    eyes.clear();
    headset.Stand({ 0.1, 0.1, 0.5 }, separation); // on a face of the volume
    headset.Camera->Eyes[1].TanLeft = headset.Camera->Eyes[0].TanLeft;
    headset.Camera->Eyes[1].TanRight = headset.Camera->Eyes[0].TanRight;
    stage.Render();
    trial.Holds(eyes.size() == 2, "two eyes, two pictures");
    trial.Holds(eyes.size() == 2 && (eyes[0].Values == eyes[1].Values) == (separation == 0),
      "eyes in one place see the same, to the bit; eyes apart do not");
  }
  stage.Mapper->RemoveObserver(watch);
}

/// A frame again: as it was kept, integrated anew after another one, and in another mapper.
void SameTwice(Trial& trial)
{
  FieldStage stage(trial);
  stage.Mapper->SetJitter(0.2);
  const Picture first = stage.Render();
  trial.Holds(first.Values == stage.Render().Values, "the same frame again, to the bit");
  stage.Medium->SetAlbedo(0.5);
  trial.Holds(first.Values != stage.Render().Values, "another medium is another frame");
  stage.Medium->SetAlbedo(1);
  const vtkTypeInt64 reused = stage.Mapper->GetStatistics()->GetFramesReused();
  trial.Holds(first.Values == stage.Render().Values, "integrated anew, to the bit");
  trial.Holds(stage.Mapper->GetStatistics()->GetFramesReused() == reused, "it was integrated anew");
  FieldStage fresh(trial);
  fresh.Mapper->SetJitter(0.2);
  trial.Holds(first.Values == fresh.Render().Values, "a fresh mapper's frame, to the bit");
  SameEyes(trial);
}
}

std::vector<Row> FrameRows()
{
  return {
    { 49, "SplitVolumesMultiplyTheirTransmittances",
      "S; the halves are alike, as neither darkens the other's light, and so are cropped ones; "
      "Paper's surface steps begin elsewhere there: 1e-2",
      SplitVolume, {} },
    { 53, "OddSizesAndViewportsAreTheirOwnImages", "S", OddSizes, {} },
    { 54, "ReleasedResourcesComeBackBitwise", "bitwise, 100 times; equal bytes on the device",
      Released, {} },
    { 59, "RenderersAgree",
      "5e-4 of the peak against the reference, so 1e-3 between any two renderers", AgainstReference,
      { { Mapper::Paper, DrawsHomogeneous } } },
    { 58, "RandomSettingsAreDrawnOrRefused",
      "each frame finite and >= 0, or refused by one error; more than a hundred of each kind",
      RandomSettings,
      { { Mapper::Paper, "is among the settings of FixedStep's cell" },
        { Mapper::ErrorControlled, "is among the settings of FixedStep's cell" },
        { Mapper::Exact, "is among the settings of FixedStep's cell" } } },
    { 60, "SameFrameTwiceIsIdentical", "bitwise", SameTwice, {} },
  };
}
}
