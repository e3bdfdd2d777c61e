// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// How the fields lie in 3D textures of the device.
#include "vtkMediumPlan.h"

#include <algorithm>
#include <sstream>

//------------------------------------------------------------------------------
void vtkMediumPlan::PlanFolds(const Capabilities& device)
{
  this->LargestTexture = device.TextureSize3D;
  for (const vtkMediumField& field : this->Fields)
  {
    const glm::ivec3& size = field.Dimensions;
    this->Folds.emplace_back(size, device.TextureSize3D);
    this->Folded |= this->Folds.back().IsFolded();
    if (this->Refusal.empty() && !this->Folds.back().IsPossible())
    {
      std::ostringstream text;
      text << "The image has " << std::max({ size.x, size.y, size.z })
           << " values along an axis, but the device's largest 3D texture has "
           << device.TextureSize3D << ", in which all " << size.x << " x " << size.y << " x "
           << size.z << " have no room in blocks either; resample the image or render a part of it "
           << "(vtkImageResize, vtkExtractVOI).";
      this->Refusal = text.str();
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkMediumPlan::FieldDefines() const
{
  return (this->Folded ? "#define FOLDED\n#define FIELD_COUNT " : "#define FIELD_COUNT ") +
    std::to_string(this->Fields.size()) + "\n";
}
