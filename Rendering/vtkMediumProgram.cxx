// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumProgram.h"

#include "vtkMediumShaderTexts.h"
#include "vtkMediumUserCode.h"

#include "vtkOpenGLQuadHelper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTimerLog.h"

//------------------------------------------------------------------------------
vtkMediumProgram::vtkMediumProgram() = default;

//------------------------------------------------------------------------------
vtkMediumProgram::~vtkMediumProgram() = default;

//------------------------------------------------------------------------------
std::string vtkMediumProgram::Assemble(
  const std::vector<std::string>& files, const std::string& defines)
{
  std::string text = vtkMediumShaderText("Prologue");
  text += defines;
  for (const std::string& file : files)
  {
    text += vtkMediumShaderText(file);
  }
  return text;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkMediumProgram::Use(vtkOpenGLRenderWindow* window,
  const std::vector<std::string>& files, const std::string& defines, const vtkMediumUserCode* code)
{
  std::string key = defines;
  for (const std::string& file : files)
  {
    key += file + ' ';
  }
  const bool altered = code && !code->IsEmpty();
  key += altered ? code->GetKey(files) : std::string();
  vtkShaderProgram* program = this->UseKey(window, key, [&]() {
    std::string text = vtkMediumProgram::Assemble(files, defines);
    if (altered)
    {
      code->Insert(text);
    }
    return text;
  });
  if (program && altered)
  {
    code->SetUniforms(program);
  }
  return program;
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkMediumProgram::Use(vtkOpenGLRenderWindow* window, const std::string& text)
{
  return this->UseKey(window, text, [&text]() { return text; });
}

//------------------------------------------------------------------------------
vtkShaderProgram* vtkMediumProgram::UseKey(vtkOpenGLRenderWindow* window, const std::string& key,
  const std::function<std::string()>& assemble)
{
  std::unique_ptr<vtkOpenGLQuadHelper>& quad = this->Quads[key];
  if (!quad)
  {
    const double before = vtkTimerLog::GetUniversalTime();
    quad.reset(new vtkOpenGLQuadHelper(window, nullptr, assemble().c_str(), nullptr));
    this->CompileMilliseconds += 1e3 * (vtkTimerLog::GetUniversalTime() - before);
    ++this->Compiles;
  }
  this->Current = quad.get();
  if (!quad->Program || !quad->Program->GetCompiled())
  {
    return nullptr;
  }
  // Another pass may have made its own program current since the last draw.
  window->GetShaderCache()->ReadyShaderProgram(quad->Program);
  return quad->Program;
}

//------------------------------------------------------------------------------
void vtkMediumProgram::Draw()
{
  this->Current->Render();
}

//------------------------------------------------------------------------------
void vtkMediumProgram::ReleaseGraphicsResources(vtkWindow* window)
{
  for (auto& entry : this->Quads)
  {
    entry.second->ReleaseGraphicsResources(window);
  }
  this->Quads.clear();
  this->Current = nullptr;
}
