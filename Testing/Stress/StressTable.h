// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file StressTable.h
 * @brief The stress matrix: a law a row, an integrator a column, a measured number a cell.
 *
 * A row is a function that is run once for each integrator. It compares what it measures with what it
 * allows through Trial; the worst such pair is the cell's entry in Module/Documentation/stability.md.
 * Each cell is a test of its own, Stress/Row02_RadianceIsTruthA.FixedStep. A cell that is left out says
 * why, and so does a law that is known not to hold.
 */
#ifndef StressTable_h
#define StressTable_h

#include "PrintedErrors.h"

#include "vtkSingleScatteringVolumeMapper.h"

#include <map>
#include <string>
#include <vector>

namespace vtkMediumStress
{
using Mapper = vtkSingleScatteringVolumeMapper;

/// One run of a row.
class Trial
{
public:
  explicit Trial(int integrator)
    : Integrator(integrator)
  {
  }

  /// The law: measured <= allowed. NaN fails.
  void AtMost(double measured, double allowed, const std::string& what);

  /// The law: measured >= needed.
  void Reaches(double measured, double needed, const std::string& what);

  /// The law: it holds.
  void Holds(bool holds, const std::string& what);

  bool Is(int integrator) const { return this->Integrator == integrator; }

  const int Integrator;
  /// The pair that came nearest to failing, or failed; in words.
  std::string Measured = "holds", Allowed = "holds";
  /// The largest measured / allowed; needed / measured of a lower bound.
  double Nearest = -1;
  /// Up to this Nearest a number that misses its law is a known limit, not a failure.
  double Limit = 1;

private:
  bool Note(double nearness, const std::string& measured, const std::string& allowed);
};

/// A law that an integrator is known to miss.
struct KnownLimit
{
  double Ratio;    ///< what is measured is at most this times what is allowed, and more than once
  const char* Why; ///< to be told to a user
};

/// A law of the matrix.
struct Row
{
  int Number;
  const char* Law;       ///< what is asserted, as a name
  const char* Tolerance; ///< and why it is that
  void (*Run)(Trial& trial);
  std::map<int, const char*> LeftOut;    ///< integrators that have no cell here, and why
  std::map<int, KnownLimit> Limits = {}; ///< integrators that miss the law, how far, and why
};

/// Rows by theme.
std::vector<Row> OpticalDepthRows();
std::vector<Row> MarchRows();
std::vector<Row> LightRows();
std::vector<Row> PhaseRows();
std::vector<Row> EnergyRows();
std::vector<Row> PlacementRows();
std::vector<Row> DepthRows();
std::vector<Row> DataRows();
std::vector<Row> FoldRows();
std::vector<Row> FunctionRows();
std::vector<Row> FrameRows();
std::vector<Row> FaultRows();

/// Takes resident memory, MiB, after a change was made 40 times and what it grew by until the hundredth
/// time into the results.
void WriteMemory(const char* change, double resident, double growth);

/// Reasons that several rows share.
constexpr const char* DrawsHomogeneous = "draws homogeneous media only, by its definition";
constexpr const char* ChoosesSteps = "chooses its steps itself";
}

#endif
