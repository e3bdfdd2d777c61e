// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "vtkMediumStatistics.h"
#include "vtkSingleScatteringVolumeMapper.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace
{
//------------------------------------------------------------------------------
[[noreturn]] void ExitWithUsage(
  const std::string& program, const std::string& purpose, const std::string& mistake)
{
  std::ostream& out = mistake.empty() ? std::cout : std::cerr;
  if (!mistake.empty())
  {
    out << program << ": " << mistake << "\n";
  }
  out << "usage: " << program << " [INPUT] [--output PNG] [--size PIXELS] [--step LENGTH]"
      << " [--interactive]\n"
      << purpose << "\n";
  std::exit(mistake.empty() ? EXIT_SUCCESS : 2);
}

//------------------------------------------------------------------------------
// The largest R, G or B of the last frame; above 1 the 8-bit picture is clipped.
double PeakRadiance(vtkSingleScatteringVolumeMapper* mapper)
{
  vtkNew<vtkImageData> image;
  mapper->GetColorImage(image);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  double peak = 0;
  for (int channel = 0; scalars && channel < 3; ++channel)
  {
    peak = std::max(peak, scalars->GetRange(channel)[1]);
  }
  return peak;
}

//------------------------------------------------------------------------------
bool WritePNG(vtkRenderWindow* window, const std::string& path)
{
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code failure;
  if (!folder.empty() && (std::filesystem::create_directories(folder, failure), failure))
  {
    return false;
  }
  vtkNew<vtkWindowToImageFilter> frame;
  frame->SetInput(window);
  frame->ReadFrontBufferOff();
  frame->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputConnection(frame->GetOutputPort());
  writer->Write();
  return writer->GetErrorCode() == 0;
}

//------------------------------------------------------------------------------
double RenderMilliseconds(vtkRenderWindow* window)
{
  const auto start = std::chrono::steady_clock::now();
  window->Render();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
    .count();
}
}

//------------------------------------------------------------------------------
Picture::Options Picture::ReadOptions(
  int argc, char* argv[], const std::string& purpose, const Options& defaults)
{
  Options options = defaults;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const bool takesValue = argument == "--output" || argument == "--size" || argument == "--step";
    if (takesValue && i + 1 == argc)
    {
      ExitWithUsage(argv[0], purpose, argument + " needs a value");
    }
    if (argument == "--help")
    {
      ExitWithUsage(argv[0], purpose, "");
    }
    else if (argument == "--output")
    {
      options.Output = argv[++i];
    }
    else if (argument == "--size")
    {
      options.Size = std::atoi(argv[++i]);
    }
    else if (argument == "--step")
    {
      options.Step = std::atof(argv[++i]);
    }
    else if (argument == "--interactive")
    {
      options.Interactive = true;
    }
    else if (argument[0] != '-' && options.Input.empty())
    {
      options.Input = argument;
    }
    else
    {
      ExitWithUsage(argv[0], purpose, "unexpected argument " + argument);
    }
  }
  if (options.Size < 1 || options.Size > 16384)
  {
    ExitWithUsage(argv[0], purpose, "--size must be 1 to 16384 pixels");
  }
  return options;
}

//------------------------------------------------------------------------------
int Picture::Finish(vtkRenderWindow* window,
  const std::map<std::string, vtkSingleScatteringVolumeMapper*>& mappers, const Options& options)
{
  window->SetOffScreenRendering(!options.Interactive);
  window->SetMultiSamples(0);
  window->Render();
  for (const auto& [name, mapper] : mappers)
  {
    mapper->GetStatistics()->CountTapsOn();
  }
  const double milliseconds = RenderMilliseconds(window);
  if (!WritePNG(window, options.Output))
  {
    std::cerr << "cannot write " << options.Output << "; give another path\n";
    return 2;
  }
  std::cout << options.Output << ": frame " << milliseconds << " ms\n";
  for (const auto& [name, mapper] : mappers)
  {
    vtkMediumStatistics* done = mapper->GetStatistics();
    if (done->GetFrames() == 0)
    {
      return 2; // the mapper has said why
    }
    std::cout << "  " << name << ": integrated " << done->GetIntegrateMilliseconds() << " ms in "
              << done->GetPasses() << " passes, largest value " << PeakRadiance(mapper) << ", "
              << done->GetGPUBytes() / 1048576.0 << " MiB of textures, " << done->GetRays()
              << " rays, " << done->GetTaps() << " taps\n";
  }
  if (options.Interactive)
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    vtkNew<vtkInteractorStyleTrackballCamera> trackball;
    interactor->SetRenderWindow(window);
    interactor->SetInteractorStyle(trackball);
    std::cout << std::flush;
    interactor->Start();
  }
  return EXIT_SUCCESS;
}
