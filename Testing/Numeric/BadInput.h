// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BadInput.h
 * @brief A valid scene that a test spoils, and what must then happen: one error, no change on screen.
 */
#ifndef BadInput_h
#define BadInput_h

#include "ClosedForms.h"

#include "vtkOutputWindow.h"

#include <gtest/gtest.h>

#include <limits>

namespace vtkMediumTest
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Counts the errors that VTK's other classes print.
class CountingWindow : public vtkOutputWindow
{
public:
  static CountingWindow* New();
  vtkTypeMacro(CountingWindow, vtkOutputWindow);
  void DisplayErrorText(const char* text) override { this->Errors.emplace_back(text); }
  void DisplayWarningText(const char*) override {}
  void DisplayText(const char*) override {}
  std::vector<std::string> Errors;
};
inline CountingWindow* CountingWindow::New()
{
  VTK_STANDARD_NEW_BODY(CountingWindow);
}

/// The integrators that a cause is tried with.
const std::vector<int> OnlyPaper = { vtkSingleScatteringVolumeMapper::Paper };
const std::vector<int> AllButPaper = { vtkSingleScatteringVolumeMapper::FixedStep,
  vtkSingleScatteringVolumeMapper::ErrorControlled, vtkSingleScatteringVolumeMapper::Exact };
const std::vector<int> AllIntegrators = { vtkSingleScatteringVolumeMapper::Paper,
  vtkSingleScatteringVolumeMapper::FixedStep, vtkSingleScatteringVolumeMapper::ErrorControlled,
  vtkSingleScatteringVolumeMapper::Exact };

/// A valid scene that a test spoils and mends. Its emission comes from the scalars, so that no integrator has
/// a closed form for it.
struct ValidScene : Scene
{
  explicit ValidScene(int integrator = vtkSingleScatteringVolumeMapper::FixedStep)
    : Scene(MakeBox(), 12)
  {
    this->Mapper->SetIntegrator(integrator);
    if (integrator != vtkSingleScatteringVolumeMapper::Paper)
    {
      this->Medium->SetEmissionArrayName("");
      this->Medium->SetEmissionScale(0.01);
    }
    this->Renderer->SetBackground(0.2, 0.4, 0.6);
    this->AddBeam({ 0.3, -1, -0.2 });
  }
};

using Change = std::function<void(Scene&)>;

/// What the tests of refusals share.
class BadInput : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Before = vtkOutputWindow::GetInstance();
    vtkOutputWindow::SetInstance(this->Other);
  }
  void TearDown() override { vtkOutputWindow::SetInstance(this->Before); }

  /// Spoils a scene of each integrator: exactly one error with all of `words`, the background unchanged, frame
  /// after frame; then mends it: the frame of a fresh mapper.
  void ExpectRefusal(const std::vector<std::string>& words, const Change& spoil, const Change& mend,
    const std::vector<int>& integrators = AllButPaper)
  {
    for (int integrator : integrators)
    {
      SCOPED_TRACE(testing::Message() << "integrator " << integrator);
      this->ExpectRefusalBy(integrator, words, spoil, mend);
    }
  }

  vtkNew<CountingWindow> Other;
  vtkSmartPointer<vtkOutputWindow> Before;

private:
  void ExpectRefusalBy(
    int integrator, const std::vector<std::string>& words, const Change& spoil, const Change& mend)
  {
    ValidScene scene(integrator);
    scene.Volume->VisibilityOff();
    const std::vector<unsigned char> background = scene.RenderWindow();
    scene.Volume->VisibilityOn();
    spoil(scene);
    EXPECT_EQ(background, scene.RenderWindow());
    EXPECT_EQ(background, scene.RenderWindow()); // a cause that persists is reported once
    EXPECT_EQ(scene.Errors.size(), 1u);
    EXPECT_EQ(this->Other->Errors.size(), 0u)
      << (this->Other->Errors.empty() ? std::string() : this->Other->Errors[0]);
    for (const std::string& word : words)
    {
      const std::string said = scene.Errors.empty() ? std::string() : scene.Errors[0];
      EXPECT_NE(said.find(word), std::string::npos) << "'" << word << "' is not in: " << said;
    }
    mend(scene);
    ValidScene fresh(integrator);
    EXPECT_EQ(fresh.Render().Values, scene.Render().Values);
    EXPECT_EQ(fresh.RenderWindow(), scene.RenderWindow());
    EXPECT_NE(background, scene.RenderWindow());
    EXPECT_LE(scene.Errors.size(), 1u);
    // The cause comes back: it is said again.
    spoil(scene);
    scene.RenderWindow();
    EXPECT_EQ(scene.Errors.size(), 2u);
  }
};
}

#endif
