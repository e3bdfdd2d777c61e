// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkMediumStatistics.h"
#include "vtkParticipatingMedium.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSingleScatteringVolumeMapper);

struct vtkSingleScatteringVolumeMapper::Internals
{
};

vtkSingleScatteringVolumeMapper::vtkSingleScatteringVolumeMapper()
  : Statistics(vtkSmartPointer<vtkMediumStatistics>::New())
  , Resources(new Internals)
{
}
vtkSingleScatteringVolumeMapper::~vtkSingleScatteringVolumeMapper() = default;
void vtkSingleScatteringVolumeMapper::SetMedium(vtkParticipatingMedium* medium)
{
  if (this->Medium != medium)
  {
    this->Medium = medium;
    this->Modified();
  }
}
vtkParticipatingMedium* vtkSingleScatteringVolumeMapper::GetMedium()
{
  return this->Medium;
}
vtkMediumStatistics* vtkSingleScatteringVolumeMapper::GetStatistics()
{
  return this->Statistics;
}
void vtkSingleScatteringVolumeMapper::GetColorImage(vtkImageData*) {}
void vtkSingleScatteringVolumeMapper::GetDepthImage(vtkImageData*) {}
void vtkSingleScatteringVolumeMapper::Render(vtkRenderer*, vtkVolume*) {}
void vtkSingleScatteringVolumeMapper::ReleaseGraphicsResources(vtkWindow*) {}
vtkMTimeType vtkSingleScatteringVolumeMapper::GetMTime()
{
  return this->Superclass::GetMTime();
}
int vtkSingleScatteringVolumeMapper::FillInputPortInformation(int port, vtkInformation* info)
{
  return this->Superclass::FillInputPortInformation(port, info);
}
void vtkSingleScatteringVolumeMapper::Refuse(const std::string&) {}
void vtkSingleScatteringVolumeMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
