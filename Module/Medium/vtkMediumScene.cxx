// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumScene.h"

#include "vtkMediumContent.h"
#include "vtkMediumRange.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
//------------------------------------------------------------------------------
glm::dmat4 ToGlm(vtkMatrix4x4* matrix) // VTK stores rows, GLM columns
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
bool IsFinite(const glm::dmat4& matrix)
{
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 4; ++row)
    {
      if (!std::isfinite(matrix[column][row]))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
glm::dvec4 Row(const glm::dmat4& matrix, int row)
{
  return { matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row] };
}

//------------------------------------------------------------------------------
// Points the rays from the near plane to the far plane, clip z / w grows along them, and measures t in
// local units along the central one.
void OrientRays(vtkMediumScene::View& view)
{
  const double w = view.ClipW.w;
  const glm::dvec3 forward = view.Parallel ? glm::dvec3(view.ClipZ) / w : glm::dvec3(view.ClipW);
  const double sign = glm::dot(forward, view.Direction) < 0 ? -1 : 1;
  const double scale = sign / glm::length(view.Direction);
  view.Direction *= scale;
  view.DirectionX *= scale;
  view.DirectionY *= scale;
  if (view.Parallel) // clip z = -w at the near plane
  {
    view.Start = -(glm::dot(view.ClipZ, glm::dvec4(view.Origin, 1)) + w) /
      glm::dot(glm::dvec3(view.ClipZ), view.Direction);
  }
}

//------------------------------------------------------------------------------
// "" or that the eye rays begin nowhere.
std::string CheckEye(const vtkMediumScene::View& view, const vtkMediumScene::Box& box)
{
  using Box = vtkMediumScene::Box;
  std::ostringstream problem;
  if (!Box::IsPlace(view.Origin) || !Box::IsPlace(view.OriginX) || !Box::IsPlace(view.OriginY) ||
    !(std::abs(view.Start) <= Box::Farthest))
  {
    const glm::dvec3 start = view.Start * view.Direction;
    const glm::dvec3 eye = box.Center + box.Length * (view.Origin + start);
    problem << "The camera is at (" << eye.x << ", " << eye.y << ", " << eye.z << "), more than "
            << Box::Farthest << " times the volume's diagonal of " << box.Length
            << " away from it, or its view is as wide; place it nearer.";
  }
  return problem.str();
}

/// The shortest edge of a volume, of its diagonal: its inverse, times that of a matrix that is all but
/// singular, is a float.
constexpr double ThinnestBox = 1e-20;

//------------------------------------------------------------------------------
std::string GatherBox(vtkMediumScene::Box& box, vtkImageData* input, vtkVolume* volume)
{
  int extent[6];
  input->GetExtent(extent);
  const glm::dvec3 first(extent[0], extent[2], extent[4]);
  const glm::dvec3 size(extent[1] - extent[0], extent[3] - extent[2], extent[5] - extent[4]);
  std::ostringstream problem;
  if (size.x < 1 || size.y < 1 || size.z < 1)
  {
    problem << "The input image has the extent " << extent[0] << ".." << extent[1] << ", "
            << extent[2] << ".." << extent[3] << ", " << extent[4] << ".." << extent[5]
            << "; a volume needs at least two points along each axis.";
    return problem.str();
  }

  const glm::dmat4 indexToWorld =
    ToGlm(volume->GetMatrix()) * ToGlm(input->GetIndexToPhysicalMatrix());
  const glm::dmat3 axes = glm::dmat3(indexToWorld);
  const double determinant = glm::determinant(axes);
  const double edges = glm::length(axes[0]) * glm::length(axes[1]) * glm::length(axes[2]);
  if (!IsFinite(indexToWorld) || !(std::abs(determinant) > 1e-12 * edges))
  {
    problem << "The matrix from image indices to world coordinates is singular (determinant "
            << determinant
            << "); give the image a spacing > 0 and a direction matrix, and the volume a matrix, "
               "with a volume.";
    return problem.str();
  }

  const glm::dmat3 worldEdges(axes[0] * size.x, axes[1] * size.y, axes[2] * size.z);
  box.Length = 0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const glm::dvec3 signs(1, corner & 1 ? -1 : 1, corner & 2 ? -1 : 1);
    box.Length = std::max(box.Length, glm::length(worldEdges * signs));
  }
  const double thickness = std::min(
    { glm::length(worldEdges[0]), glm::length(worldEdges[1]), glm::length(worldEdges[2]) });
  if (!std::isfinite(box.Length) || !(thickness > ThinnestBox * box.Length))
  {
    problem << "The volume is " << box.Length << " world units across, but " << thickness
            << " along its shortest edge; give the image a spacing, and the volume a matrix, of "
               "which the renderer's floats can hold the ratio (up to "
            << 1 / ThinnestBox << ").";
    return problem.str();
  }
  box.Center = glm::dvec3(indexToWorld * glm::dvec4(first + 0.5 * size, 1));
  box.BoxToLocalAxes = worldEdges / box.Length;
  box.BoxToLocalOrigin = -(box.BoxToLocalAxes * glm::dvec3(0.5));
  box.LocalToBoxAxes = glm::inverse(box.BoxToLocalAxes);
  box.LocalToBoxOrigin = glm::dvec3(0.5);
  box.VoxelLength = std::min({ glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]) });
  return {};
}
}

//------------------------------------------------------------------------------
std::string vtkMediumScene::GatherVolume(vtkImageData* input, vtkDataArray* scalars, bool onCells,
  vtkVolume* volume, vtkParticipatingMedium* medium, double anisotropy)
{
  this->Geometry = Box();
  this->Content = Medium();
  this->Scalars = vtkMediumField();
  std::string problem = GatherBox(this->Geometry, input, volume);
  if (!problem.empty())
  {
    return problem;
  }
  if (!scalars && !medium)
  {
    return "The input image has no scalars; give it a point or cell array and make it active "
           "(SetScalars, or SelectScalarArray on the mapper), or set a vtkParticipatingMedium.";
  }
  if (scalars)
  {
    problem =
      vtkMediumFieldFromArray(this->Scalars, input, scalars, onCells, volume->GetProperty());
    if (!problem.empty())
    {
      return problem;
    }
  }
  problem = medium ? vtkMediumContentFromMedium(this->Content, this->ColorTables, input, scalars,
                       onCells, volume->GetProperty(), medium)
                   : vtkMediumContentFromProperty(this->Content, this->ColorTables, input, scalars,
                       onCells, volume->GetProperty(), anisotropy);
  return problem.empty() ? vtkMediumCheckRange(*this) : problem;
}

//------------------------------------------------------------------------------
std::string vtkMediumScene::GatherMask(vtkImageData* input, vtkImageData* mask)
{
  const std::string problem = this->Mask.Gather(input, mask);
  for (const vtkMediumField& field : this->Mask.Fields)
  {
    this->Content.Masks.push_back(static_cast<int>(this->Content.Fields.size()));
    this->Content.Fields.push_back(field);
  }
  return problem;
}

//------------------------------------------------------------------------------
std::string vtkMediumScene::GatherCut(vtkAbstractVolumeMapper* mapper, vtkVolume* volume)
{
  const Box& box = this->Geometry;
  return this->Cut.Gather(
    mapper, volume, { box.Length, box.Center, box.BoxToLocalAxes, box.BoxToLocalOrigin });
}

//------------------------------------------------------------------------------
std::string vtkMediumScene::GatherView(vtkMatrix4x4* worldToClip)
{
  glm::dmat4 localToWorld(this->Geometry.Length);
  localToWorld[3] = glm::dvec4(this->Geometry.Center, 1);
  const glm::dmat4 matrix = ToGlm(worldToClip) * localToWorld;

  // A ray is the set of points with (row x - x row w) . p = 0 and (row y - y row w) . p = 0: its
  // direction is the cross product of the two normals, which is linear in x and y.
  const glm::dvec4 rowX = Row(matrix, 0), rowY = Row(matrix, 1), rowW = Row(matrix, 3);
  View& view = this->Eye;
  view = View();
  view.LocalToClip = matrix;
  view.ClipZ = Row(matrix, 2);
  view.ClipW = rowW;
  view.Direction = glm::cross(glm::dvec3(rowX), glm::dvec3(rowY));
  view.DirectionX = glm::cross(glm::dvec3(rowY), glm::dvec3(rowW));
  view.DirectionY = glm::cross(glm::dvec3(rowW), glm::dvec3(rowX));

  const glm::dmat3 normals =
    glm::transpose(glm::dmat3(glm::dvec3(rowX), glm::dvec3(rowY), glm::dvec3(rowW)));
  view.Parallel = glm::dvec3(rowW) == glm::dvec3(0);
  const double size = glm::length(glm::dvec3(rowX)) * glm::length(glm::dvec3(rowY)) *
    (view.Parallel ? 1.0 : glm::length(glm::dvec3(rowW)));
  const double determinant =
    view.Parallel ? glm::length(view.Direction) : std::abs(glm::determinant(normals));
  if (!IsFinite(matrix) || !(determinant > 1e-14 * size))
  {
    std::ostringstream problem;
    problem << "The camera's world-to-clip matrix is singular (determinant " << determinant
            << "); check its position, the view angle, the clipping range and the window's size.";
    return problem.str();
  }

  if (view.Parallel)
  {
    // The point nearest to the local origin on each ray: normals . p = (x w - rowX.w, ...).
    const glm::dmat3 inverse = glm::inverse(glm::transpose(
      glm::dmat3(glm::dvec3(rowX), glm::dvec3(rowY), glm::normalize(view.Direction))));
    view.Origin = inverse * glm::dvec3(-rowX.w, -rowY.w, 0);
    view.OriginX = inverse * glm::dvec3(rowW.w, 0, 0);
    view.OriginY = inverse * glm::dvec3(0, rowW.w, 0);
    view.DirectionX = view.DirectionY = glm::dvec3(0);
  }
  else
  {
    view.Origin = glm::inverse(normals) * -glm::dvec3(rowX.w, rowY.w, rowW.w);
  }

  OrientRays(view);
  return CheckEye(view, this->Geometry);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkMediumScene::EvaluateCoefficient(
  const Coefficient& coefficient, const std::vector<glm::dvec4>& fields) const
{
  switch (coefficient.Source)
  {
    case Coefficient::Field:
    {
      const glm::dvec4& value = fields[coefficient.FieldIndex];
      const vtkMediumField& field = this->Content.Fields[coefficient.FieldIndex];
      const int component =
        field.Components < 3 ? std::max(coefficient.Component, 0) : coefficient.Component;
      return coefficient.Scale * (component < 0 ? glm::dvec3(value) : glm::dvec3(value[component]));
    }
    case Coefficient::FunctionRGB:
    case Coefficient::FunctionAlpha:
    {
      const glm::dvec4 value = this->Content.Functions[coefficient.FunctionIndex].Evaluate(
        fields[coefficient.FieldIndex].x);
      return coefficient.Scale *
        (coefficient.Source == Coefficient::FunctionRGB ? glm::dvec3(value) : glm::dvec3(value.w));
    }
    default:
      return coefficient.Scale;
  }
}

//------------------------------------------------------------------------------
vtkMediumScene::Coefficients vtkMediumScene::Evaluate(const glm::dvec3& box) const
{
  std::vector<glm::dvec4> fields;
  for (const vtkMediumField& field : this->Content.Fields)
  {
    fields.push_back(field.Interpolate(box));
  }
  const Medium& content = this->Content;
  double density = content.DensityScale;
  for (int mask : content.Masks)
  {
    density *= fields[mask].x;
  }
  Coefficients result;
  result.Extinction = density * this->EvaluateCoefficient(content.Extinction, fields);
  const glm::dvec3 scattering = this->EvaluateCoefficient(content.Scattering, fields);
  result.Scattering =
    content.ScatteringIsAlbedo ? scattering * result.Extinction : density * scattering;
  if (content.ExtinctionIsAbsorption)
  {
    result.Extinction += result.Scattering;
  }
  result.Emission = density * this->EvaluateCoefficient(content.Emission, fields);
  result.Anisotropy = this->EvaluateCoefficient(content.Anisotropy, fields).x;
  return result;
}
