// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PrintedErrors.h
 * @brief Collects what VTK would print.
 */
#ifndef PrintedErrors_h
#define PrintedErrors_h

#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace vtkMediumStress
{
/// What VTK's other classes print while it exists.
class PrintedErrors
{
public:
  PrintedErrors();
  ~PrintedErrors();
  std::vector<std::string>& Get();

private:
  vtkSmartPointer<vtkOutputWindow> Before, Here;
};
}

#endif
