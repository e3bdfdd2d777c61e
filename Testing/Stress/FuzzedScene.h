// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzedScene.h
 * @brief A scene in which everything that a user can set is random: mostly sensible, now and then not.
 */
#ifndef FuzzedScene_h
#define FuzzedScene_h

#include "GLWatch.h"
#include "StressTable.h"
#include "vtkMediumTestScene.h"

#include <memory>
#include <random>

namespace vtkMediumStress
{
class FuzzedScene
{
public:
  static constexpr int Frames = 3; ///< of a setting; each changes some of what the one before set

  /// In a window of its own, or in one that others had before, which is much faster.
  explicit FuzzedScene(unsigned seed, vtkRenderWindow* window = nullptr);
  ~FuzzedScene();

  /// Sets, renders and looks. Empty, or what is wrong.
  std::string Frame(int number);

  /// The setting as it is now, as VTK prints it.
  std::string Describe();

  /// Whether the last frame was refused.
  bool WasRefused() const { return this->Refused; }

private:
  double Unit(); ///< 0 to 1
  int Whole(int count);
  bool Chance(double part) { return this->Unit() < part; }
  double Length();            ///< 1e-3 to 1e3, evenly in the logarithm
  double Odd();               ///< a number that nobody would type
  double Or(double sensible); ///< that, or now and then an odd one

  void ChangeImage();
  void ChangeMatrix();
  void ChangeMapper();
  void ChangeCuts();
  void ChangeMedium();
  void ChangeProperty();
  void ChangeLights();
  void ChangeCamera();
  void ChangeRest();
  void Listen();
  void Interrupt();
  void Ask();
  void LengthenSteps();
  std::string Judge(const vtkMediumTest::Picture& picture);

  std::mt19937 Generator;
  std::unique_ptr<PrintedErrors> Printed;
  std::unique_ptr<vtkMediumTest::Scene> Scene;
  GLWatch Watch;
  double Size = 1; ///< of the volume's longest edge
  bool Refused = false;
  double Interruptions = 0; ///< how probable one is at each event of this setting
  bool Interrupted = false; ///< in this frame
};
}

#endif
