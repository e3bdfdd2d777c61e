// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Baseline.h"

#include "vtkCallbackCommand.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkTesting.h"
#include "vtkTrivialProducer.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>

namespace
{
// Drivers round differently, by a level or two of 255, and send a few pixels at a silhouette to its
// other side. More than that is a different picture.
constexpr double LargestMean = 0.5;       // grey levels, over all pixels and channels
constexpr int DifferentLevel = 8;         // a pixel that differs by more is a different one
constexpr double LargestFraction = 0.002; // of the pixels may be different ones
// A mistake that is found by a hair would be missed by the next driver.
constexpr double Margin = 4;
// A frame that was refused shows its background only; every scene fills more of its picture.
constexpr double SmallestSubject = 0.02;
// VTK's comparison in its strictest form, with the threshold that VTK gives its own tests.
constexpr double ThresholdOfVTK = 0.05;

//------------------------------------------------------------------------------
struct Difference
{
  double Mean = 255;
  double Fraction = 1;
  int Largest = 255;

  bool IsSmall() const { return this->Mean <= LargestMean && this->Fraction <= LargestFraction; }
  bool IsLarge() const
  {
    return this->Mean >= Margin * LargestMean || this->Fraction >= Margin * LargestFraction;
  }
};

std::ostream& operator<<(std::ostream& out, const Difference& difference)
{
  return out << "mean " << difference.Mean << ", " << 100 * difference.Fraction
             << " % of the pixels differ by more than " << DifferentLevel << ", largest "
             << difference.Largest;
}

//------------------------------------------------------------------------------
bool ShowsSomething(vtkImageData* picture)
{
  const auto* values = static_cast<const unsigned char*>(picture->GetScalarPointer());
  const vtkIdType pixels = picture->GetNumberOfPoints();
  const int channels = picture->GetNumberOfScalarComponents();
  vtkIdType seen = 0;
  for (vtkIdType pixel = 0; pixel < pixels; ++pixel)
  {
    // Other than the corner's pixel, which is background in some scenes and medium in others.
    seen += !std::equal(values, values + channels, values + channels * pixel);
  }
  return seen >= SmallestSubject * pixels;
}

//------------------------------------------------------------------------------
using Picture = vtkSmartPointer<vtkImageData>;

// Counts what VTK reports as errors while it lives.
class ErrorCount
{
public:
  ErrorCount()
  {
    this->Command->SetClientData(&this->Count);
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    this->Tag = vtkOutputWindow::GetInstance()->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~ErrorCount() { vtkOutputWindow::GetInstance()->RemoveObserver(this->Tag); }
  ErrorCount(const ErrorCount&) = delete;
  void operator=(const ErrorCount&) = delete;

  int Count = 0;

private:
  vtkNew<vtkCallbackCommand> Command;
  unsigned long Tag;
};

//------------------------------------------------------------------------------
// What the window shows; null if there was an error.
Picture Capture(vtkRenderWindow* window)
{
  const ErrorCount errors;
  window->Render();
  vtkNew<vtkWindowToImageFilter> frame;
  frame->SetInput(window);
  frame->ReadFrontBufferOff();
  frame->ShouldRerenderOff();
  frame->Update();
  return errors.Count == 0 && ShowsSomething(frame->GetOutput()) ? frame->GetOutput() : nullptr;
}

//------------------------------------------------------------------------------
Picture Read(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

//------------------------------------------------------------------------------
bool Write(vtkImageData* picture, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetCompressionLevel(9);
  writer->SetInputData(picture);
  writer->Write();
  return writer->GetErrorCode() == 0;
}

//------------------------------------------------------------------------------
// All is different if the sizes are.
Difference Compare(vtkImageData* a, vtkImageData* b)
{
  const int* size = a->GetDimensions();
  const int channels = a->GetNumberOfScalarComponents();
  if (!std::equal(size, size + 3, b->GetDimensions()) ||
    channels != b->GetNumberOfScalarComponents())
  {
    return {};
  }
  const auto* p = static_cast<const unsigned char*>(a->GetScalarPointer());
  const auto* q = static_cast<const unsigned char*>(b->GetScalarPointer());
  const vtkIdType pixels = a->GetNumberOfPoints();
  Difference result;
  result.Largest = 0;
  vtkIdType sum = 0, different = 0;
  for (vtkIdType pixel = 0; pixel < pixels; ++pixel)
  {
    int largest = 0;
    for (int channel = 0; channel < channels; ++channel, ++p, ++q)
    {
      const int difference = std::abs(*p - *q);
      sum += difference;
      largest = std::max(largest, difference);
    }
    different += largest > DifferentLevel;
    result.Largest = std::max(result.Largest, largest);
  }
  result.Mean = sum / static_cast<double>(pixels * channels);
  result.Fraction = different / static_cast<double>(pixels);
  return result;
}

//------------------------------------------------------------------------------
// VTK's verdict and what it wrote; it leaves the picture and its difference in the folder.
int CompareAsVTK(
  int argc, char* argv[], vtkImageData* picture, const std::string& folder, std::ostream& report)
{
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, argv);
  testing->AddArgument("-T");
  testing->AddArgument(folder.c_str());
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(picture);
  return testing->RegressionTest(producer, ThresholdOfVTK, report);
}

//------------------------------------------------------------------------------
std::string GetArgument(int argc, char* argv[], const std::string& name)
{
  char** end = argv + argc;
  char** found = std::find(argv, end, name);
  return found == end || found + 1 == end ? std::string() : found[1];
}

//------------------------------------------------------------------------------
bool Check(bool holds, const std::string& failure)
{
  if (!holds)
  {
    std::cout << "FAILED: " << failure << "\n";
  }
  return holds;
}
}

//------------------------------------------------------------------------------
int Baseline::Compare(int argc, char* argv[], vtkRenderWindow* window, const std::string& mistake,
  const std::function<void()>& makeMistake)
{
  const std::string path = GetArgument(argc, argv, "-V");
  const std::string folder = GetArgument(argc, argv, "-T");
  const Picture picture = Capture(window);
  if (!Check(picture, "the picture is empty, or there was an error"))
  {
    return EXIT_FAILURE;
  }
  if (std::getenv("PARTICIPATING_MEDIA_UPDATE_BASELINES"))
  {
    Check(Write(picture, path), path + " cannot be written");
    std::cout << "Wrote " << path << "; look at it before it is committed\n";
  }
  if (!Check(std::filesystem::exists(path), path + " is missing; see Testing/Image/README.md"))
  {
    return EXIT_FAILURE;
  }
  const Picture baseline = Read(path);

  const Difference difference = ::Compare(picture, baseline);
  std::cout << "As it should be: " << difference << "\n";
  bool good = Check(difference.IsSmall(), "the picture differs from its baseline");
  good &= Check(CompareAsVTK(argc, argv, picture, folder, std::cout) == vtkTesting::PASSED,
    "VTK's comparison rejects the picture");

  makeMistake();
  const Picture wrong = Capture(window);
  if (!Check(wrong, "the picture with " + mistake + " is empty, or there was an error"))
  {
    return EXIT_FAILURE;
  }
  const Difference rejected = ::Compare(wrong, baseline);
  const std::string wrongFolder = folder + "/Wrong";
  std::filesystem::create_directories(wrongFolder);
  Write(wrong, wrongFolder + "/" + std::filesystem::path(path).filename().string());
  std::ostringstream report; // it says that the test failed, which is what is wanted
  const bool seenByVTK = CompareAsVTK(argc, argv, wrong, wrongFolder, report) != vtkTesting::PASSED;
  std::cout << "With " << mistake << ": " << rejected << "; VTK's comparison "
            << (seenByVTK ? "rejects" : "accepts") << " it\n";
  good &= Check(rejected.IsLarge(), "the picture with " + mistake + " is not clearly rejected");
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}
