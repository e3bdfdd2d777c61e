// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class Stage
 * @brief A small off-screen window with views, volumes and lights, set in a line each.
 *
 * Volumes are centred at the world's origin and about 1 long; the lights of a view are those that a
 * test adds. Nothing depends on time, on random numbers or on the size of the screen.
 */
#ifndef Stage_h
#define Stage_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSingleScatteringVolumeMapper.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/vec3.hpp>

class Stage
{
public:
  explicit Stage(int width = 200, int height = 200);
  ~Stage();

  vtkRenderWindow* GetWindow() { return this->Window; }

  /// A view from column left to right of the window, 0 to 1. A stage without any gets one that
  /// fills the window at first use. All that is added goes to the newest view.
  vtkRenderer* AddView(double left = 0, double right = 1);
  vtkRenderer* GetView();

  /// A volume with a mapper of its own, which integrates by FixedStep.
  vtkVolume* AddVolume(vtkImageData* image, vtkVolumeProperty* medium);
  static vtkSingleScatteringVolumeMapper* GetMapper(vtkVolume* volume);

  /// Geometry of one colour, which no light changes.
  vtkActor* AddActor(vtkPolyDataAlgorithm* source, const glm::dvec3& color);

  /// A light at infinity, or at a place; `irradiance` is what arrives on a surface that faces it.
  vtkLight* AddSun(const glm::dvec3& towards, const glm::dvec3& color, double irradiance);
  vtkLight* AddLamp(const glm::dvec3& place, const glm::dvec3& color, double irradiance);

  /// The newest view's camera looks from that direction at all that was added, z up.
  void LookFrom(const glm::dvec3& direction, double zoom = 1);

  /// Blobs in the sun, a post behind their middle and one before it, for views of two eyes; returns the
  /// camera that looks at them.
  vtkCamera* LookAtPosts();

  /// A medium of that extinction, per unit of length, times the voxels' density of 0 to 1.
  static vtkSmartPointer<vtkVolumeProperty> Medium(double extinction, const glm::dvec3& albedo);

  /// A cube 1 long with so many points; the density of a point at x, each coordinate -1/2 to 1/2.
  template <class Density>
  static vtkSmartPointer<vtkImageData> Voxels(const glm::ivec3& points, Density density)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(points.x, points.y, points.z);
    image->SetSpacing(1.0 / (points.x - 1), 1.0 / (points.y - 1), 1.0 / (points.z - 1));
    image->SetOrigin(-0.5, -0.5, -0.5);
    vtkNew<vtkFloatArray> values;
    values->SetName("density");
    values->SetNumberOfTuples(image->GetNumberOfPoints());
    for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
    {
      glm::dvec3 x;
      image->GetPoint(id, &x[0]);
      values->SetValue(id, static_cast<float>(density(x)));
    }
    image->GetPointData()->SetScalars(values);
    return image;
  }

  /// Five blobs that have grown together, and fade out before the cube's faces.
  static vtkSmartPointer<vtkImageData> Blobs(const glm::ivec3& points);

private:
  vtkNew<vtkRenderWindow> Window;
  vtkRenderer* View = nullptr;
};

#endif
