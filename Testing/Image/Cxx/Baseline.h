// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Baseline.h
 * @brief Compares what a window shows with a picture that was looked at and found right.
 *
 * VTK's own comparison hardly sees brightness (9.1 finds no difference between a grey of 100 and
 * one of 60), so pixels are compared as well. And a comparison that accepts anything is no test:
 * each test also draws its scene with one deliberate mistake, and that picture must be rejected.
 */
#ifndef Baseline_h
#define Baseline_h

#include "vtkRenderWindow.h"

#include <functional>
#include <string>

namespace Baseline
{
/// Renders the window and compares it with the baseline (-V FILE among the arguments); then lets
/// `makeMistake` change the scene, renders again, and wants that picture to be rejected. `mistake`
/// says what was done. Returns EXIT_SUCCESS or EXIT_FAILURE. With
/// PARTICIPATING_MEDIA_UPDATE_BASELINES in the environment the baseline is written first.
int Compare(int argc, char* argv[], vtkRenderWindow* window, const std::string& mistake,
  const std::function<void()>& makeMistake);
}

#endif
