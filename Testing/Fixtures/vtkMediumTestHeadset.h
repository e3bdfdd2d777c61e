// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkMediumTestHeadset.h
 * @brief A stand-in for a headset: a window that draws two eyes by matrices of its own.
 *
 * It does what VTK's windows for OpenVR and OpenXR do: for every frame the runtime gives each eye a view
 * matrix and an asymmetric projection, the camera hands them out through GetKeyMatrices by its LeftEye
 * flag, and the renderers are drawn once for each eye.
 */
#ifndef vtkMediumTestHeadset_h
#define vtkMediumTestHeadset_h

#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>

namespace vtkMediumTest
{
/// What a runtime says of an eye: its pose in the world, and the tangents of the half angles that its
/// display spans to the left (< 0), right, bottom (< 0) and top.
struct EyePose
{
  glm::dvec3 Position{ 0 }, Right{ 1, 0, 0 }, Up{ 0, 1, 0 };
  double TanLeft = -1, TanRight = 1, TanBottom = -1, TanTop = 1;

  /// World to view, for column vectors.
  void GetView(vtkMatrix4x4* matrix) const
  {
    const glm::dvec3 axes[3] = { this->Right, this->Up, glm::cross(this->Right, this->Up) };
    matrix->Identity();
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        matrix->SetElement(row, column, axes[row][column]);
      }
      matrix->SetElement(row, 3, -glm::dot(axes[row], this->Position));
    }
  }

  /// View to clip, for column vectors.
  void GetProjection(double nearest, double farthest, vtkMatrix4x4* matrix) const
  {
    const double width = this->TanRight - this->TanLeft, height = this->TanTop - this->TanBottom;
    matrix->Zero();
    matrix->SetElement(0, 0, 2 / width);
    matrix->SetElement(0, 2, (this->TanRight + this->TanLeft) / width);
    matrix->SetElement(1, 1, 2 / height);
    matrix->SetElement(1, 2, (this->TanTop + this->TanBottom) / height);
    matrix->SetElement(2, 2, -(farthest + nearest) / (farthest - nearest));
    matrix->SetElement(2, 3, -2 * farthest * nearest / (farthest - nearest));
    matrix->SetElement(3, 2, -1);
  }
};

class HeadsetCamera : public vtkOpenGLCamera
{
public:
  static HeadsetCamera* New();
  vtkTypeMacro(HeadsetCamera, vtkOpenGLCamera);

  EyePose Eyes[2]; ///< left, right
  double Nearest = 0.01, Farthest = 100;

  void GetKeyMatrices(vtkRenderer*, vtkMatrix4x4*& worldToView, vtkMatrix3x3*& normals,
    vtkMatrix4x4*& viewToClip, vtkMatrix4x4*& worldToClip) override
  {
    const EyePose& eye = this->Eyes[this->GetLeftEye() ? 0 : 1];
    vtkNew<vtkMatrix4x4> view, projection, both;
    eye.GetView(view);
    eye.GetProjection(this->Nearest, this->Farthest, projection);
    vtkMatrix4x4::Multiply4x4(projection, view, both);
    // As the base class, it hands out transposed matrices.
    vtkMatrix4x4::Transpose(view, this->WCVCMatrix);
    vtkMatrix4x4::Transpose(projection, this->VCDCMatrix);
    vtkMatrix4x4::Transpose(both, this->WCDCMatrix);
    worldToView = this->WCVCMatrix;
    normals = this->NormalMatrix;
    viewToClip = this->VCDCMatrix;
    worldToClip = this->WCDCMatrix;
  }

protected:
  HeadsetCamera() = default;
};
vtkStandardNewMacro(HeadsetCamera);

/// Eyes as far apart as `separation`, looking along -z at first, each seeing more of its own side.
struct Headset
{
  vtkNew<HeadsetCamera> Camera;

  /// Stands at `position`, turned by `yaw` about the y axis, radians, with displays tilted outwards by
  /// `tilt` radians each.
  void Stand(const glm::dvec3& position, double separation, double yaw = 0, double tilt = 0)
  {
    for (int i = 0; i < 2; ++i)
    {
      const double side = i == 0 ? -1 : 1, turn = yaw - side * tilt;
      EyePose& eye = this->Camera->Eyes[i];
      eye.Right = { std::cos(turn), 0, -std::sin(turn) };
      eye.Position =
        position + 0.5 * side * separation * glm::dvec3(std::cos(yaw), 0, -std::sin(yaw));
      eye.TanLeft = i == 0 ? -1.1 : -0.8;
      eye.TanRight = i == 0 ? 0.8 : 1.1;
      eye.TanBottom = -1.2;
      eye.TanTop = 0.9;
    }
    this->Camera->Modified();
  }

  /// Lets a window draw the left eye, then the right one, in every Render.
  void PutOn(vtkRenderWindow* window, vtkRenderer* renderer)
  {
    renderer->SetActiveCamera(this->Camera);
    window->SetStereoTypeToSplitViewportHorizontal();
    window->StereoRenderOn();
  }
};
}

#endif
