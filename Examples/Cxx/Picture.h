// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Picture.h
 * @brief What the examples share: their command line, and a window written to a PNG file.
 */
#ifndef Picture_h
#define Picture_h

#include <map>
#include <string>

class vtkRenderWindow;
class vtkSingleScatteringVolumeMapper;

namespace Picture
{
/// The command line of an example.
struct Options
{
  std::string Input;  ///< the volume to read; empty where none was named
  std::string Output; ///< the PNG to write
  int Size = 512;     ///< pixels along an edge of each picture
  double Step = 0;    ///< longest step along a ray, world units
  bool Interactive = false;
};

/// Reads [INPUT] [--output PNG] [--size PIXELS] [--step LENGTH] [--interactive] over the defaults.
/// Prints the usage and ends the program for --help (exit code 0) and for anything else (2).
Options ReadOptions(int argc, char* argv[], const std::string& purpose, const Options& defaults);

/// Renders two frames, writes the PNG, prints its path, the second frame's time and what each
/// mapper did; then, if interactive, lets the user turn the volume until the window is closed.
/// Returns the exit code: 0, or 2 when a mapper refused its frame or the file was not written.
int Finish(vtkRenderWindow* window,
  const std::map<std::string, vtkSingleScatteringVolumeMapper*>& mappers, const Options& options);
}

#endif
