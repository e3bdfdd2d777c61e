// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// What a fuzzed scene does beside setting and rendering: what few users set, what is asked of a mapper
// between frames, and what an observer changes while a frame is being drawn.
#include "FuzzedInput.h"
#include "FuzzedScene.h"

#include "vtkHardwareSelector.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkPropPicker.h"

#include <array>
#include <sstream>
#include <vector>

namespace vtkMediumStress
{
namespace
{
constexpr std::size_t MostBytes = 600;
constexpr int Oddness = 2; ///< the less, the more numbers there are; most settings shall be drawn
}

//------------------------------------------------------------------------------
/// Every setter of a medium and a property, and what a mapper and a window have beside the usual.
void FuzzedScene::ChangeRest()
{
  std::vector<std::uint8_t> random(MostBytes);
  for (std::uint8_t& byte : random)
  {
    byte = static_cast<std::uint8_t>(this->Whole(256));
  }
  vtkMediumFuzz::Bytes bytes(random.data(), random.size());
  bytes.Oddness = Oddness;
  if (this->Chance(0.2))
  {
    vtkMediumFuzz::FillMedium(bytes, this->Scene->Medium);
  }
  if (this->Chance(0.2))
  {
    vtkMediumFuzz::FillProperty(bytes, this->Scene->Property);
  }
  vtkSingleScatteringVolumeMapper* mapper = this->Scene->Mapper;
  mapper->SetAutoAdjustSampleDistances(this->Chance(0.7));
  mapper->SetImageSampleDistance(this->Chance(0.1) ? this->Or(1 + 3 * this->Unit()) : 1);
  mapper->SetMaskInput(nullptr);
  if (this->Chance(0.1))
  {
    vtkNew<vtkImageData> mask;
    mask->DeepCopy(mapper->GetDataObjectInput());
    mask->GetPointData()->SetScalars(nullptr);
    bool onCells = false;
    vtkDataArray* values = vtkMediumFuzz::AddArray(bytes, mask, "mask", onCells);
    onCells ? mask->GetCellData()->SetScalars(values) : mask->GetPointData()->SetScalars(values);
    mapper->SetMaskInput(mask);
  }
  this->Scene->Window->SetDesiredUpdateRate(this->Chance(0.2) ? 50 : 0.0001);
  this->Scene->Window->SetStereoTypeToSplitViewportHorizontal();
  this->Scene->Window->SetStereoRender(this->Chance(0.05));
}

//------------------------------------------------------------------------------
/// Listens to the frames' beginnings, steps and ends.
void FuzzedScene::Listen()
{
  vtkNew<vtkCallbackCommand> listener;
  listener->SetClientData(this);
  listener->SetCallback([](vtkObject*, unsigned long, void* scene, void*) {
    static_cast<FuzzedScene*>(scene)->Interrupt();
  });
  for (unsigned long event : { vtkCommand::VolumeMapperRenderStartEvent,
         vtkCommand::VolumeMapperRenderProgressEvent, vtkCommand::VolumeMapperRenderEndEvent })
  {
    this->Scene->Mapper->AddObserver(event, listener);
  }
}

//------------------------------------------------------------------------------
/// While a frame is being drawn: sets what comes, asks for what is not there yet, or aborts it.
void FuzzedScene::Interrupt()
{
  if (!this->Chance(this->Interruptions))
  {
    return;
  }
  this->Interrupted = true;
  using Change = void (FuzzedScene::*)();
  const Change changes[] = { &FuzzedScene::ChangeImage, &FuzzedScene::ChangeMatrix,
    &FuzzedScene::ChangeMapper, &FuzzedScene::ChangeCuts, &FuzzedScene::ChangeMedium,
    &FuzzedScene::ChangeProperty };
  const int number = this->Whole(8);
  if (number < 6)
  {
    (this->*changes[number])();
  }
  else if (number == 6)
  {
    vtkNew<vtkImageData> image;
    this->Scene->Mapper->GetColorImage(image);
    this->Scene->Mapper->GetDepthImage(image);
  }
  else
  {
    this->Scene->Window->SetAbortRender(1);
  }
}

//------------------------------------------------------------------------------
std::string FuzzedScene::Describe()
{
  std::ostringstream text;
  this->Scene->Mapper->Print(text);
  this->Scene->Medium->Print(text);
  this->Scene->Property->Print(text);
  this->Scene->Mapper->GetDataObjectInput()->Print(text);
  this->Scene->Volume->GetMatrix()->Print(text);
  this->Scene->Camera->Print(text);
  this->Scene->Renderer->GetLights()->InitTraversal();
  while (vtkLight* light = this->Scene->Renderer->GetLights()->GetNextItem())
  {
    light->Print(text);
  }
  return text.str();
}

//------------------------------------------------------------------------------
/// Between two frames: a description, a copy, a selection, a pick. Nothing of it may end the process.
void FuzzedScene::Ask()
{
  vtkSingleScatteringVolumeMapper* mapper = this->Scene->Mapper;
  std::ostringstream text;
  switch (this->Whole(8))
  {
    case 0:
      mapper->Print(text);
      this->Scene->Medium->Print(text);
      break;
    case 1:
    {
      vtkNew<vtkSingleScatteringVolumeMapper> copy;
      copy->ShallowCopy(mapper);
      mapper->ShallowCopy(copy);
      break;
    }
    case 2:
    {
      vtkNew<vtkHardwareSelector> selector;
      selector->SetRenderer(this->Scene->Renderer);
      const int* size = this->Scene->Window->GetSize();
      selector->SetArea(0, 0, size[0] - 1, size[1] - 1);
      selector->CaptureBuffers();
      selector->ClearBuffers();
      break;
    }
    case 3:
    {
      vtkNew<vtkPropPicker> picker;
      picker->Pick(this->Whole(16), this->Whole(16), 0, this->Scene->Renderer);
      break;
    }
    default:
      break;
  }
}
}
