// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StressRefusal.h
 * @brief The law E: exactly one error event with a clear message, the background unchanged, and the next
 * valid frame as if nothing had been.
 */
#ifndef StressRefusal_h
#define StressRefusal_h

#include "StressStage.h"

namespace vtkMediumStress
{
using Change = std::function<void(Stage&)>;

/// Spoils a valid scene, looks, mends it and looks again. The message must contain `word`. What VTK
/// itself prints meanwhile (a driver's compile log) may be let pass.
inline void CheckRefusal(Trial& trial, const std::string& word, const Change& spoil,
  const Change& mend, bool letVTKSpeak = false)
{
  Stage stage(trial, MakeBox(), 8);
  stage.Renderer->SetBackground(0.2, 0.4, 0.6);
  stage.AddBeam({ 0.3, -1, -0.2 });
  stage.Mapper->SetMaximumError(0.01);
  stage.Volume->VisibilityOff();
  const std::vector<unsigned char> background = stage.RenderWindow();
  stage.Volume->VisibilityOn();
  const Picture valid = stage.Render();
  {
    PrintedErrors printed;
    spoil(stage);
    trial.Holds(stage.RenderWindow() == background, word + ": the background stays");
    trial.Holds(stage.RenderWindow() == background, word + ": the background stays, again");
    trial.Holds(letVTKSpeak || printed.Get().empty(), word + ": VTK prints nothing");
  }
  trial.Holds(stage.Errors.size() == 1,
    word + ": one error event, not " + std::to_string(stage.Errors.size()));
  trial.Holds(!stage.Errors.empty() && stage.Errors[0].find(word) != std::string::npos,
    "'" + word + "' is in: " + (stage.Errors.empty() ? "" : stage.Errors[0]));
  mend(stage);
  stage.Errors.clear();
  trial.Holds(stage.Render().Values == valid.Values, word + ": the next valid frame is right");
}

inline void UseBox(Stage& stage)
{
  stage.Mapper->SetInputData(MakeBox());
}
}

#endif
