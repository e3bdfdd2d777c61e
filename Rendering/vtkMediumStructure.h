// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumStructure
 * @brief The structural choices of a shader program, written as preprocessor definitions.
 *
 * Only structure becomes text: which coefficient reads which texture, which kinds of light there are,
 * which phase function. Every number stays a uniform, so that changing one compiles nothing.
 */
#ifndef vtkMediumStructure_h
#define vtkMediumStructure_h

#include "vtkMediumScene.h"
#include "vtkParticipatingMediaRenderingModule.h" // for the export macro

#include <string>
#include <vector>

class VTKPARTICIPATINGMEDIARENDERING_EXPORT vtkMediumStructure
{
public:
  /// Whether the extinction is the same everywhere, so that optical depths are lengths.
  static bool HasConstantExtinction(const vtkMediumScene::Medium& content);
  static std::string ContentDefines(const vtkMediumScene::Medium& content);
  /// How the Exact integrator takes the mean of the extinction over a segment.
  static std::string ExactDefines(const vtkMediumScene::Medium& content);
  /// MASK, the product of masks that are the textures of these numbers; nothing where there are none.
  static std::string MaskDefines(const std::vector<int>& textures);
  static std::string CutDefines(const vtkMediumCut& cut);
  static std::string LightDefines(const std::vector<vtkMediumScene::Light>& lights);
  /// Which formula PHASE is; `schlick` asks for Schlick's whatever the content says.
  static std::string PhaseDefines(const vtkMediumScene::Medium& content, bool schlick);
};

#endif
