// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumContent.h"

#include "vtkColorTransferFunction.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int Count = vtkMediumFunction::DefaultIntervals + 1;

/// More than the colour functions of one medium.
constexpr std::size_t MostTables = 8;

//------------------------------------------------------------------------------
// VTK is asked for each colour by itself: its tables (9.1) are black where a value meets the first
// node, and are spaced logarithmically on a logarithmic scale.
std::vector<glm::dvec3> SampleEach(
  vtkColorTransferFunction* function, double minimum, double maximum)
{
  std::vector<glm::dvec3> colors(Count);
  for (int i = 0; i < Count; ++i)
  {
    function->GetColor(vtkMediumFunction::GetPlace(minimum, maximum, i, Count - 1), &colors[i][0]);
  }
  return colors;
}

//------------------------------------------------------------------------------
// Whether all nodes have colours of 0 to 1. VTK's search of CIEDE2000 paths reads beyond its memory with others.
bool HasColors(vtkColorTransferFunction* function)
{
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6]; // x, r, g, b, midpoint, sharpness
    function->GetNodeValue(i, node);
    if (!std::all_of(node + 1, node + 4, [](double c) { return c >= 0 && c <= 1; }))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// CIEDE2000 searches a path through the colour space for 30 ms or more at each call, so its colours
// are looked up in one table from the first node to the last, with 16 values for each of ours. NaN where there
// is no such path, which the caller refuses as any other.
std::vector<glm::dvec3> SampleFromTable(
  vtkColorTransferFunction* function, double minimum, double maximum)
{
  if (!HasColors(function))
  {
    return std::vector<glm::dvec3>(Count, glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
  }
  const double first = function->GetRange()[0], last = function->GetRange()[1];
  const bool logarithmic = function->GetScale() == VTK_CTF_LOG10 && first > 0;
  std::vector<glm::dvec3> table(16 * Count), colors(Count);
  function->GetTable(first, last, static_cast<int>(table.size()), &table[0][0]);
  glm::dvec3 below(0), above(0);
  if (minimum < first)
  {
    function->GetColor(minimum, &below[0]);
  }
  if (maximum > last)
  {
    function->GetColor(maximum, &above[0]);
  }
  for (int i = 0; i < Count; ++i)
  {
    const double value = vtkMediumFunction::GetPlace(minimum, maximum, i, Count - 1);
    if (value < first || value > last)
    {
      colors[i] = value < first ? below : above;
      continue;
    }
    const double fraction = logarithmic ? std::log(value / first) / std::log(last / first)
                                        : (value - first) / (last - first);
    const double position = fraction * (table.size() - 1);
    const std::size_t index = std::min(static_cast<std::size_t>(position), table.size() - 2);
    colors[i] = glm::mix(table[index], table[index + 1], position - index);
  }
  return colors;
}
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> vtkMediumSampleColors(std::vector<vtkMediumScene::ColorTable>& tables,
  vtkColorTransferFunction* function, double minimum, double maximum)
{
  const vtkMTimeType time = function->GetMTime();
  for (const vtkMediumScene::ColorTable& table : tables)
  {
    if (table.Time == time && table.Minimum == minimum && table.Maximum == maximum)
    {
      return table.Colors;
    }
  }
  const bool slow = function->GetColorSpace() == VTK_CTF_LAB_CIEDE2000 &&
    function->GetRange()[1] > function->GetRange()[0];
  if (tables.size() >= MostTables)
  {
    tables.erase(tables.begin());
  }
  tables.push_back({ time, minimum, maximum,
    slow ? SampleFromTable(function, minimum, maximum) : SampleEach(function, minimum, maximum) });
  return tables.back().Colors;
}
