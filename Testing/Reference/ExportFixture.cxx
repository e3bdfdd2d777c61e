// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes a procedural volume of vtkMediumFixtures.h as raw 32-bit floats, x fastest, so that other
// renderers get the very same grid.
//
// usage: ExportFixture smooth|cloud|binary|faded-cloud POINTS FILE

#include "vtkMediumFixtures.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

int main(int argc, char* argv[])
{
  const std::string name = argc == 4 ? argv[1] : "";
  const int points = argc == 4 ? std::atoi(argv[2]) : 0;
  for (const auto field : { vtkMediumFixtures::Smooth, vtkMediumFixtures::Cloud,
         vtkMediumFixtures::Binary, vtkMediumFixtures::FadedCloud })
  {
    if (name != vtkMediumFixtures::Name(field) || points < 2)
    {
      continue;
    }
    const auto image = vtkMediumFixtures::MakeImage(field, glm::ivec3(points));
    std::ofstream file(argv[3], std::ios::binary);
    file.write(static_cast<const char*>(image->GetScalarPointer()),
      static_cast<std::streamsize>(image->GetNumberOfPoints() * sizeof(float)));
    if (!file)
    {
      std::cerr << "Cannot write " << argv[3] << "; name a file in a folder that exists.\n";
      return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
  }
  std::cerr
    << "usage: ExportFixture smooth|cloud|binary|faded-cloud POINTS FILE, with at least 2 points\n";
  return EXIT_FAILURE;
}
