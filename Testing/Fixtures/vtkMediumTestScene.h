// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumTestScene.h
 * @brief A window, a renderer, a camera and a volume, and the float picture that comes of them.
 *
 * The window is off screen and black; there are no lights until a test adds some. The medium is set on
 * the mapper: homogeneous, albedo 1, isotropic, of extinction 1 per world unit. FixedStep draws it.
 */
#ifndef vtkMediumTestScene_h
#define vtkMediumTestScene_h

#include "vtkMediumTestPicture.h"

#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMediumStatistics.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSingleScatteringVolumeMapper.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <vector>

namespace vtkMediumTest
{
/// A value at a position in the image's own coordinates: its centre is 0, its edges are `size` long.
using Density = std::function<double(const glm::dvec3& position)>;

/// An image centred on the origin whose active scalars are the density on its points, or its cells.
inline vtkSmartPointer<vtkImageData> MakeImage(const glm::ivec3& points, const glm::dvec3& size,
  const Density& density, bool onCells = false, int type = VTK_FLOAT)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points.x, points.y, points.z);
  const glm::dvec3 spacing = size / glm::dvec3(points - 1);
  image->SetSpacing(spacing.x, spacing.y, spacing.z);
  image->SetOrigin(-0.5 * size.x, -0.5 * size.y, -0.5 * size.z);
  auto values = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  values->SetName("density");
  const glm::ivec3 n = onCells ? points - 1 : points;
  values->SetNumberOfTuples(static_cast<vtkIdType>(n.x) * n.y * n.z);
  for (vtkIdType id = 0; id < values->GetNumberOfTuples(); ++id)
  {
    const glm::dvec3 at(id % n.x, id / n.x % n.y, id / n.x / n.y);
    values->SetTuple1(id, density((at + (onCells ? 0.5 : 0.0)) * spacing - 0.5 * size));
  }
  onCells ? image->GetCellData()->SetScalars(values) : image->GetPointData()->SetScalars(values);
  return image;
}

/// A box of density 1.
inline vtkSmartPointer<vtkImageData> MakeBox(
  const glm::dvec3& size = glm::dvec3(1), bool onCells = false)
{
  return MakeImage(
    { 3, 4, 5 }, size, [](const glm::dvec3&) { return 1.0; }, onCells);
}

struct Scene
{
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkCamera> Camera;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkVolumeProperty> Property;
  vtkNew<vtkParticipatingMedium> Medium;
  vtkNew<vtkSingleScatteringVolumeMapper> Mapper;
  int Pixels;
  std::vector<std::string> Errors; ///< that the mapper reported, in order

  /// In a window of its own, or in one that other scenes had before.
  explicit Scene(vtkImageData* image, int pixels = 32, vtkRenderWindow* window = nullptr)
    : Window(window ? window : vtkSmartPointer<vtkRenderWindow>::New().Get())
    , Pixels(pixels)
    , Borrowed(window != nullptr)
  {
    this->Mapper->SetInputData(image);
    this->Mapper->SetMedium(this->Medium);
    this->Mapper->SetIntegratorToFixedStep();
    this->Property->SetInterpolationTypeToLinear();
    this->Volume->SetProperty(this->Property);
    this->Volume->SetMapper(this->Mapper);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetActiveCamera(this->Camera);
    this->Renderer->AddVolume(this->Volume);
    this->Window->SetMultiSamples(0);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(pixels, pixels);
    this->Window->AddRenderer(this->Renderer);
    this->Look({ 0, 0, -1 }, 3);
    vtkNew<vtkCallbackCommand> listener;
    listener->SetClientData(this);
    listener->SetCallback([](vtkObject*, unsigned long, void* scene, void* words) {
      static_cast<Scene*>(scene)->Errors.push_back(static_cast<const char*>(words));
    });
    this->Listener = this->Mapper->AddObserver(vtkCommand::ErrorEvent, listener);
  }

  ~Scene()
  {
    this->Mapper->RemoveObserver(this->Listener);
    if (this->Borrowed)
    {
      this->Window->RemoveRenderer(this->Renderer);
    }
  }

  /// Looks along `direction` at `focus` from `distance` before it.
  void Look(const glm::dvec3& direction, double distance, const glm::dvec3& focus = glm::dvec3(0))
  {
    const glm::dvec3 forward = glm::normalize(direction);
    const glm::dvec3 eye = focus - distance * forward;
    const glm::dvec3 up = std::abs(forward.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    this->Camera->SetPosition(eye.x, eye.y, eye.z);
    this->Camera->SetFocalPoint(focus.x, focus.y, focus.z);
    this->Camera->SetViewUp(up.x, up.y, up.z);
    this->Camera->SetClippingRange(0.01 * distance, 10 * distance);
  }

  void LookParallel(const glm::dvec3& direction, double distance, double halfHeight)
  {
    this->Look(direction, distance);
    this->Camera->ParallelProjectionOn();
    this->Camera->SetParallelScale(halfHeight);
  }

  /// A beam along `direction` of the irradiance 1 on a plane normal to it.
  vtkSmartPointer<vtkLight> AddBeam(const glm::dvec3& direction)
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
    vtkSmartPointer<vtkLight> light = this->AddBeam({ 0, 0, 1 });
    light->SetPositional(true);
    light->SetConeAngle(180);
    light->SetPosition(position.x, position.y, position.z);
    light->SetFocalPoint(position.x, position.y, position.z + 1);
    light->SetAttenuationValues(0, 0, 1);
    return light;
  }

  /// Renders and reads the float image.
  Picture Render()
  {
    this->Window->Render();
    vtkNew<vtkImageData> image;
    this->Mapper->GetColorImage(image);
    return Picture(image);
  }

  /// The float image of the last frame's window depths.
  Picture Depths()
  {
    vtkNew<vtkImageData> image;
    this->Mapper->GetDepthImage(image);
    return Picture(image);
  }

  /// Renders and reads what the window shows, RGB bytes.
  std::vector<unsigned char> RenderWindow()
  {
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> bytes;
    this->Window->GetPixelData(0, 0, this->Pixels - 1, this->Pixels - 1, 0, bytes);
    return { bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues() };
  }

  /// Steps of both rays, world units.
  void SetSteps(double eye, double light)
  {
    this->Mapper->SetSampleDistance(eye);
    this->Mapper->SetLightSampleDistance(light);
  }

private:
  bool Borrowed;
  unsigned long Listener = 0;
};
}

#endif
