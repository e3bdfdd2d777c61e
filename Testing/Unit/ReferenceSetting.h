// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ReferenceSetting.h
 * @brief A grid, a medium, lights and the reference that reads them, for tests of the reference.
 */
#ifndef ReferenceSetting_h
#define ReferenceSetting_h

#include "vtkMediumClosedForms.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkSingleScatteringReference.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace ReferenceTests
{
using namespace vtkMediumTest; // the closed forms

using Density = std::function<double(const glm::dvec3& box)>;

/// A grid over [0, size] with the scalars "density" in double, on `points` points or on the cells
/// between them; the density is given in box coordinates.
inline vtkSmartPointer<vtkImageData> MakeGrid(
  const glm::ivec3& points, const glm::dvec3& size, const Density& density, bool onCells = false)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points.x, points.y, points.z);
  const glm::dvec3 spacing = size / glm::dvec3(points - 1);
  image->SetSpacing(spacing.x, spacing.y, spacing.z);
  const glm::ivec3 n = onCells ? points - 1 : points;
  vtkNew<vtkDoubleArray> values;
  values->SetName("density");
  for (int k = 0; k < n.z; ++k)
  {
    for (int j = 0; j < n.y; ++j)
    {
      for (int i = 0; i < n.x; ++i)
      {
        const glm::dvec3 at(i, j, k);
        values->InsertNextValue(
          density(onCells ? (at + 0.5) / glm::dvec3(n) : at / glm::dvec3(n - 1)));
      }
    }
  }
  onCells ? image->GetCellData()->SetScalars(values) : image->GetPointData()->SetScalars(values);
  return image;
}

/// Extinction: sigma x the grid's density; albedo 1, isotropic, no lights until they are added.
struct Setting
{
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkParticipatingMedium> Medium;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkSingleScatteringReference> Reference;

  Setting(vtkImageData* image, double sigma)
  {
    this->Property->SetInterpolationTypeToLinear();
    this->Volume->SetProperty(this->Property);
    this->Medium->SetExtinctionArrayName("");
    this->Medium->SetExtinctionScale(sigma);
    this->Renderer->AutomaticLightCreationOff();
    this->Reference->SetInputData(image);
    this->Reference->SetVolume(this->Volume);
    this->Reference->SetMedium(this->Medium);
    this->Reference->SetRenderer(this->Renderer);
  }

  /// A beam along `direction` with irradiance 1 on a plane normal to it.
  vtkSmartPointer<vtkLight> AddDirectionalLight(const glm::dvec3& direction)
  {
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetLightTypeToSceneLight();
    light->SetPosition(-direction.x, -direction.y, -direction.z);
    light->SetFocalPoint(0, 0, 0);
    this->Renderer->AddLight(light);
    return light;
  }

  /// A source of intensity 1 that falls off with the square of the distance.
  vtkSmartPointer<vtkLight> AddPointLight(const glm::dvec3& position)
  {
    auto light = vtkSmartPointer<vtkLight>::New();
    light->SetLightTypeToSceneLight();
    light->SetPositional(true);
    light->SetConeAngle(180);
    light->SetPosition(position.x, position.y, position.z);
    light->SetAttenuationValues(0, 0, 1);
    this->Renderer->AddLight(light);
    return light;
  }

  glm::dvec4 Radiance(const glm::dvec3& origin, const glm::dvec3& direction)
  {
    glm::dvec4 rgba;
    this->Reference->Radiance(&origin[0], &direction[0], &rgba[0]);
    return rgba;
  }

  double OpticalDepth(const glm::dvec3& a, const glm::dvec3& b)
  {
    return this->Reference->OpticalDepth(&a[0], &b[0]);
  }
};

/// The errors that an object reports while this lives.
struct Errors
{
  std::vector<std::string> Messages;
  vtkNew<vtkCallbackCommand> Command;
  vtkObject* Source;

  explicit Errors(vtkObject* source)
    : Source(source)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void* message) {
      static_cast<Errors*>(self)->Messages.emplace_back(static_cast<char*>(message));
    });
    source->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~Errors() { this->Source->RemoveObserver(this->Command); }

  bool IsOne(const char* part) const
  {
    return this->Messages.size() == 1 && this->Messages[0].find(part) != std::string::npos;
  }
};
}

#endif
