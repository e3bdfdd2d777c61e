// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Where the Exact integrator finds cells, and how much of its march a draw may do.
#include "vtkMediumPlan.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkMediumPlan::PlanExact(const vtkMediumScene& scene, const Capabilities& device)
{
  glm::ivec3 longest(1);
  for (int kind = 0; kind < 4; ++kind)
  {
    for (const vtkMediumField& field : this->Fields)
    {
      if (field.OnCells == (kind % 2 == 1) && field.Linear == (kind < 2))
      {
        const glm::dvec3 first = field.BoxToLattice(glm::dvec3(0));
        const glm::dvec3 last = field.BoxToLattice(glm::dvec3(1));
        // Linear between lattice points, or constant around each of them.
        this->Lattices.push_back({ last - first, first + (field.Linear ? 0.0 : 0.5) });
        longest += field.Dimensions;
        break;
      }
    }
  }
  if (this->Lattices.empty())
  {
    this->Lattices.emplace_back(); // a homogeneous box is one cell
  }
  // A light at a time, for a part of a cell marches seven light rays for each. Software renderers run
  // eight pixels in lockstep, which at worst spend their iterations one after the other.
  const int part = 7 * (longest.x + longest.y + longest.z + MostKeptParts);
  const int lockstep = 8;
  this->IterationBudget = std::max(device.LoopIterations / lockstep - part, 1);
  const int lights = this->Lit ? static_cast<int>(scene.Lights.size()) : 0;
  for (int light = 0; light < std::max(lights, 1); ++light)
  {
    this->Passes.push_back({ light, std::min(light + 1, lights), 0, 0 });
  }
}
