// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumReferencePhase.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double FullSphere = 4 * Pi; ///< steradians
constexpr double Sharpest = 0.999;    ///< where |g| and |k| are held; 1 would be a delta

//------------------------------------------------------------------------------
double Held(double parameter)
{
  return std::max(-Sharpest, std::min(Sharpest, parameter));
}

//------------------------------------------------------------------------------
// Henyey and Greenstein 1941, with 1 + g^2 - 2 g c = (1 - g)^2 + 2 g (1 - c).
double HenyeyGreenstein(double g, double cosine)
{
  const double distance = (1 - g) * (1 - g) + 2 * g * (1 - cosine);
  return (1 - g * g) / (FullSphere * std::pow(distance, 1.5));
}

//------------------------------------------------------------------------------
// Draine 2003, eq. 4, as normalised by Jendersie and d'Eon 2023.
double Draine(double g, double alpha, double cosine)
{
  return HenyeyGreenstein(g, cosine) * (1 + alpha * cosine * cosine) /
    (1 + alpha * (1 + 2 * g * g) / 3);
}

//------------------------------------------------------------------------------
// Blasi, Le Saec and Schlick 1993.
double Schlick(double k, double cosine)
{
  const double ellipse = 1 - k * cosine;
  return (1 - k * k) / (FullSphere * ellipse * ellipse);
}

//------------------------------------------------------------------------------
double Table(const std::vector<double>& values, double cosine)
{
  const double last = static_cast<double>(values.size()) - 1;
  if (last < 1)
  {
    return values.empty() ? 0 : values.front();
  }
  const double position = std::max(0.0, std::min(last, (cosine + 1) / 2 * last));
  const std::size_t index = static_cast<std::size_t>(std::min(position, last - 1));
  return values[index] + (position - index) * (values[index + 1] - values[index]);
}
}

//------------------------------------------------------------------------------
double vtkMediumReferencePhase(
  const vtkMediumScene::Medium& medium, double anisotropy, double cosine)
{
  const double first = Held(anisotropy);
  const double second = Held(medium.BackAnisotropy);
  const double weight = medium.ForwardWeight;
  switch (medium.Phase)
  {
    case vtkParticipatingMedium::Schlick:
      return Schlick(Held(1.55 * anisotropy - 0.55 * std::pow(anisotropy, 3)), cosine);
    case vtkParticipatingMedium::SchlickK:
      return Schlick(first, cosine);
    case vtkParticipatingMedium::HenyeyGreenstein:
      return HenyeyGreenstein(first, cosine);
    case vtkParticipatingMedium::DoubleHenyeyGreenstein:
      return weight * HenyeyGreenstein(first, cosine) +
        (1 - weight) * HenyeyGreenstein(second, cosine);
    case vtkParticipatingMedium::Rayleigh:
      return 3 * (1 + cosine * cosine) / (16 * Pi);
    case vtkParticipatingMedium::Draine:
      return Draine(first, medium.DraineAlpha, cosine);
    case vtkParticipatingMedium::Droplets:
      return weight * Draine(first, medium.DraineAlpha, cosine) +
        (1 - weight) * HenyeyGreenstein(second, cosine);
    case vtkParticipatingMedium::Tabulated:
      return Table(medium.PhaseTable, cosine);
    default:
      return 1 / FullSphere;
  }
}
