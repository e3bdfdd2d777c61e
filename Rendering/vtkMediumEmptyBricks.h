// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumEmptyBricks
 * @brief How far around each brick there is nothing, so that rays may leap there.
 *
 * A brick's reach is the number of bricks, itself counted, that are empty in every direction: all bricks
 * whose indices differ from its own by less than the reach in each axis are empty. 0: it is not empty
 * itself. That is its chessboard distance to the nearest brick that is not empty, which two passes with
 * weights of 1 find exactly (Rosenfeld and Pfaltz, Distance functions on digital pictures, 1968). What is
 * beyond the volume counts as empty.
 */
#ifndef vtkMediumEmptyBricks_h
#define vtkMediumEmptyBricks_h

#include "vtkMediumBricks.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumEmptyBricks
{
public:
  /// The largest reach that is told.
  static constexpr unsigned char Farthest = 255;

  void Build(const vtkMediumBricks& bricks);

  /// By brick, in the order of vtkMediumBricks::GetIndex.
  const std::vector<unsigned char>& GetReaches() const { return this->Reaches; }

private:
  std::vector<unsigned char> Reaches;
};

#endif
