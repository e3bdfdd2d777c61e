// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeReader.h"

#include "vtkDICOMImageReader.h"
#include "vtkImageData.h"
#include "vtkImageFlip.h"
#include "vtkLogger.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkPointData.h"
#include "vtkStringOutputWindow.h"
#include "vtkXMLImageDataReader.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
bool NameEndsIn(std::string name, const std::vector<std::string>& endings)
{
  std::transform(
    name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::any_of(endings.begin(), endings.end(), [&](const std::string& ending) {
    return name.size() >= ending.size() &&
      name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
  });
}

//------------------------------------------------------------------------------
// The words of the first error in what VTK wrote to its output window,
// "ERROR: In <file>, line <n>\n<class> (<address>): <words>\n", or nothing.
std::string FirstError(const std::string& text)
{
  const std::size_t error = text.find("ERROR:");
  if (error == std::string::npos)
  {
    return {};
  }
  const std::size_t address = text.find("): ", error);
  const std::size_t begin = address == std::string::npos ? error : address + 3;
  return text.substr(begin, text.find('\n', begin) - begin);
}

//------------------------------------------------------------------------------
// Keeps what VTK would print, so that it becomes one exception, for as long as it lives.
class Messages
{
public:
  Messages()
    : Previous(vtkOutputWindow::GetInstance())
    , Verbosity(vtkLogger::GetCurrentVerbosityCutoff())
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::SetInstance(this->Window);
  }
  ~Messages()
  {
    vtkOutputWindow::SetInstance(this->Previous);
    vtkLogger::SetStderrVerbosity(this->Verbosity);
  }
  std::string Get() { return this->Window->GetOutput(); }

private:
  vtkSmartPointer<vtkOutputWindow> Previous;
  vtkLogger::Verbosity Verbosity;
  vtkNew<vtkStringOutputWindow> Window;
};

//------------------------------------------------------------------------------
template <typename Reader>
vtkSmartPointer<vtkImageData> Update(Reader* reader, const std::string& path)
{
  Messages messages;
  std::string complaint = "its content is not what its name says";
  if (std::filesystem::is_directory(path) || reader->CanReadFile(path.c_str()))
  {
    reader->Update();
    complaint = FirstError(messages.Get());
  }
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  if (complaint.empty() &&
    (image->GetNumberOfPoints() == 0 || !image->GetPointData()->GetScalars()))
  {
    complaint = "there are no voxels in it";
  }
  if (!complaint.empty())
  {
    throw std::runtime_error(path + ": " + reader->GetClassName() +
      " cannot read it: " + complaint + "; give a complete file of that kind");
  }
  return image;
}

//------------------------------------------------------------------------------
// The image with its voxels in the reverse order along an axis.
vtkSmartPointer<vtkImageData> Reversed(vtkImageData* image, int axis)
{
  vtkNew<vtkImageFlip> flip;
  flip->SetInputData(image);
  flip->SetFilteredAxis(axis);
  flip->Update();
  return flip->GetOutput();
}

//------------------------------------------------------------------------------
template <typename Reader>
vtkSmartPointer<vtkImageData> ReadFile(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  return Update(reader.Get(), path);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> VolumeReader::Read(const std::string& path)
{
  if (path.empty())
  {
    throw std::runtime_error("no volume; name a file (--help tells which)");
  }
  if (!std::filesystem::exists(path))
  {
    throw std::runtime_error(path + ": no such file or folder; check the path");
  }
  if (std::filesystem::is_directory(path))
  {
    vtkNew<vtkDICOMImageReader> reader;
    reader->SetDirectoryName(path.c_str());
    // VTK gives axial slices as left, front, down; half a turn makes right, front, up of it.
    return Reversed(Reversed(Update(reader.Get(), path), 0), 2);
  }
  if (NameEndsIn(path, { ".vti" }))
  {
    return ReadFile<vtkXMLImageDataReader>(path);
  }
  if (NameEndsIn(path, { ".nii", ".nii.gz" }))
  {
    return ReadFile<vtkNIFTIImageReader>(path);
  }
  if (NameEndsIn(path, { ".mhd", ".mha" }))
  {
    return ReadFile<vtkMetaImageReader>(path);
  }
  if (NameEndsIn(path, { ".nrrd", ".nhdr" }))
  {
    return ReadFile<vtkNrrdReader>(path);
  }
  throw std::runtime_error(path +
    ": unknown kind of file; expected a DICOM folder or one of .vti "
    ".nii .nii.gz .mhd .mha .nrrd .nhdr");
}
