// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PrintedErrors.h"

#include "vtkObjectFactory.h"

namespace vtkMediumStress
{
namespace
{
/// Collects instead of printing.
class CollectingWindow : public vtkOutputWindow
{
public:
  static CollectingWindow* New();
  vtkTypeMacro(CollectingWindow, vtkOutputWindow);
  void DisplayErrorText(const char* text) override { this->Errors.emplace_back(text); }
  void DisplayGenericWarningText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayText(const char*) override {}
  std::vector<std::string> Errors;
};
vtkStandardNewMacro(CollectingWindow);
}

PrintedErrors::PrintedErrors()
  : Before(vtkOutputWindow::GetInstance())
  , Here(vtkSmartPointer<CollectingWindow>::New())
{
  vtkOutputWindow::SetInstance(this->Here);
}

PrintedErrors::~PrintedErrors()
{
  vtkOutputWindow::SetInstance(this->Before);
}

std::vector<std::string>& PrintedErrors::Get()
{
  return static_cast<CollectingWindow*>(this->Here.Get())->Errors;
}
}
