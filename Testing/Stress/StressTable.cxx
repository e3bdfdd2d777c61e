// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Registers a test for each cell, and writes what was measured: as one JSON object a line, appended to
// the file that the environment's STRESS_RESULTS names.
#include "StressTable.h"

#include "vtkRenderWindow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace vtkMediumStress
{
namespace
{
constexpr int Integrators[] = { Mapper::Paper, Mapper::FixedStep, Mapper::ErrorControlled,
  Mapper::Exact };
const char* const Names[] = { "Paper", "FixedStep", "ErrorControlled", "Exact" };

std::string InWords(double value)
{
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return text.str();
}

std::string Quoted(const std::string& words)
{
  std::string quoted = "\"";
  for (char c : words)
  {
    quoted += c == '"' || c == '\\' ? std::string("\\") + c
      : c == '\n'                   ? std::string(" ")
                                    : std::string(1, c);
  }
  return quoted + '"';
}

void Write(const Row& row, int integrator, const char* verdict, const std::string& measured,
  const std::string& allowed)
{
  if (const char* name = std::getenv("STRESS_RESULTS"))
  {
    std::ofstream(name, std::ios::app)
      << "{\"row\": " << row.Number << ", \"law\": " << Quoted(row.Law)
      << ", \"tolerance\": " << Quoted(row.Tolerance) << ", \"integrator\": \"" << Names[integrator]
      << "\", \"verdict\": \"" << verdict << "\", \"measured\": " << Quoted(measured)
      << ", \"allowed\": " << Quoted(allowed) << "}\n";
  }
}

class CellTest : public testing::Test
{
public:
  CellTest(const Row& row, int integrator)
    : Law(row)
    , Integrator(integrator)
  {
  }

  void TestBody() override
  {
    PrintedErrors printed;
    Trial trial(this->Integrator);
    const auto limit = this->Law.Limits.find(this->Integrator);
    const bool limited = limit != this->Law.Limits.end();
    trial.Limit = limited ? limit->second.Ratio : 1;
    this->Law.Run(trial);
    EXPECT_TRUE(printed.Get().empty()) << "VTK printed: " << printed.Get().front();
    EXPECT_TRUE(!limited || trial.Nearest > 1) << "the law holds here: its known limit is to go";
    std::string allowed = trial.Allowed;
    allowed += limited ? std::string("; ") + limit->second.Why : std::string();
    Write(this->Law, this->Integrator,
      testing::Test::HasFailure() ? "fails"
        : limited                 ? "limit"
                                  : "holds",
      trial.Measured, allowed);
  }

private:
  const Row& Law;
  int Integrator;
};

const std::vector<Row>& Table()
{
  static std::vector<Row> table;
  if (table.empty())
  {
    for (auto rows : { OpticalDepthRows, MarchRows, LightRows, PhaseRows, EnergyRows, PlacementRows,
           DepthRows, DataRows, FoldRows, FunctionRows, FrameRows, FaultRows })
    {
      const std::vector<Row> some = rows();
      table.insert(table.end(), some.begin(), some.end());
    }
  }
  return table;
}

void Register()
{
  for (const Row& row : Table())
  {
    std::ostringstream suite;
    suite << "Stress/Row" << std::setw(2) << std::setfill('0') << row.Number << '_' << row.Law;
    for (int integrator : Integrators)
    {
      if (row.LeftOut.count(integrator) == 0)
      {
        testing::RegisterTest(suite.str().c_str(), Names[integrator], nullptr, nullptr, __FILE__,
          __LINE__,
          [&row, integrator]() -> testing::Test* { return new CellTest(row, integrator); });
      }
    }
  }
}
}

bool Trial::Note(double nearness, const std::string& measured, const std::string& allowed)
{
  if (!(nearness <= this->Nearest))
  {
    this->Nearest = std::isnan(nearness) ? HUGE_VAL : nearness;
    this->Measured = measured;
    this->Allowed = allowed;
  }
  return nearness <= this->Limit;
}

void Trial::AtMost(double measured, double allowed, const std::string& what)
{
  const double nearness = allowed > 0 ? measured / allowed : measured > 0 ? HUGE_VAL : 0;
  EXPECT_TRUE(this->Note(nearness, InWords(measured), InWords(allowed)))
    << what << ": " << measured << ", allowed " << this->Limit << " times " << allowed;
}

void Trial::Reaches(double measured, double needed, const std::string& what)
{
  const double nearness = measured > 0 ? needed / measured : HUGE_VAL;
  EXPECT_TRUE(this->Note(nearness, InWords(measured), ">= " + InWords(needed)))
    << what << ": " << measured << ", needed " << needed << " / " << this->Limit;
}

void Trial::Holds(bool holds, const std::string& what)
{
  EXPECT_TRUE(holds) << what;
  if (!holds)
  {
    this->Note(HUGE_VAL, "fails: " + what, "holds");
  }
}

/// The OpenGL renderer's own name.
static std::string FindRenderer()
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->Render();
  const std::string words = window->ReportCapabilities(), label = "OpenGL renderer string:";
  const std::size_t at = words.find(label) + label.size();
  const std::string name = words.substr(at, words.find('\n', at) - at);
  return name.substr(name.find_first_not_of(' '));
}

/// Whether the renderer is the one that the environment's STRESS_RENDERER names, if it names one.
static bool HasRenderer()
{
  const char* wanted = std::getenv("STRESS_RENDERER");
  const std::string name = wanted ? FindRenderer() : std::string();
  if (!wanted || name.find(wanted) != std::string::npos)
  {
    return true;
  }
  std::cout << "skipped: the OpenGL renderer is " << name << ", not " << wanted << "\n";
  return false;
}

void WriteMemory(const char* change, double resident, double growth)
{
  if (const char* name = std::getenv("STRESS_RESULTS"))
  {
    std::ofstream(name, std::ios::app)
      << "{\"memory\": " << Quoted(change) << ", \"resident\": " << resident
      << ", \"growth\": " << growth << "}\n";
  }
}

/// As the first record.
static void WriteRenderer()
{
  std::ofstream(std::getenv("STRESS_RESULTS"), std::ios::app)
    << "{\"renderer\": " << Quoted(FindRenderer()) << "}\n";
}

static void WriteLeftOut()
{
  for (const Row& row : Table())
  {
    for (const auto& cell : row.LeftOut)
    {
      Write(row, cell.first, "left out", cell.second, "");
    }
  }
}
}

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  vtkMediumStress::Register();
  if (!testing::GTEST_FLAG(list_tests) && !vtkMediumStress::HasRenderer())
  {
    return 77; // ctest's SKIP_RETURN_CODE
  }
  if (std::getenv("STRESS_RESULTS") && !testing::GTEST_FLAG(list_tests))
  {
    vtkMediumStress::WriteRenderer();
    vtkMediumStress::WriteLeftOut();
  }
  return RUN_ALL_TESTS();
}
