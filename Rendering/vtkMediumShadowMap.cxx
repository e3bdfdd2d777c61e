// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumShadowMap.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkMediumAllocation.h"
#include "vtkMediumOpenGL.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace
{
// Of a view in the table: the rows of its matrix.
constexpr int RowsOfMatrix = 4;

//------------------------------------------------------------------------------
// All that a view's picture depends on.
vtkMediumSignature SignatureOf(const vtkMediumScene& scene, const vtkMediumShadowViews::View& view)
{
  vtkMediumSignature signature;
  const glm::dmat4 matrix = view.LocalToClip();
  for (int i = 0; i < 16; ++i)
  {
    signature.Add(matrix[i / 4][i % 4]);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    signature.Add(scene.Geometry.Center[axis]);
  }
  signature.Add(scene.Geometry.Length);
  signature.Add(vtkMediumSignature::OfCasters(scene));
  return signature;
}
}

//------------------------------------------------------------------------------
std::string vtkMediumShadowMap::Update(
  vtkOpenGLRenderWindow* window, const vtkMediumScene& scene, const vtkMediumPlan& plan)
{
  this->Complete = true;
  if (!plan.OpaqueShadows)
  {
    return {};
  }
  this->Window = window;
  std::vector<View> views;
  std::vector<int> faces; // of each light: the view, -1 for none
  for (const vtkMediumScene::Light& light : scene.Lights)
  {
    const vtkMediumShadowViews seen(light, scene.Geometry, plan.OpaqueShadowResolution);
    const int first = static_cast<int>(views.size());
    for (int view : seen.OfFace)
    {
      faces.push_back(view < 0 ? -1 : first + view);
    }
    views.insert(views.end(), seen.Views.begin(), seen.Views.end());
  }
  std::string refusal = this->Fit(views.size(), plan.OpaqueShadowResolution);
  if (refusal.empty())
  {
    this->DrawChanged(scene, views);
    refusal = this->UploadViews(views, faces)
      ? std::string()
      : "The device could not allocate a table of floats; free device memory.";
  }
  return refusal;
}

//------------------------------------------------------------------------------
// Makes the texture for so many views, if it is not there.
std::string vtkMediumShadowMap::Fit(std::size_t views, int pixels)
{
  int most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  const int count = std::max(static_cast<int>(views), 1);
  // As square as may be.
  const int columns = std::min(
    std::max(most / pixels, 1), static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))));
  const glm::ivec2 tiles(columns, (count + columns - 1) / columns);
  const bool kept = this->Map->GetHandle() && tiles == this->Tiles && pixels == this->Pixels;
  if (kept && this->Drawn.size() == views)
  {
    return {};
  }
  this->Drawn.assign(views, vtkMediumSignature());
  if (kept || (std::max(tiles.x, tiles.y) <= most / pixels && this->Allocate(tiles, pixels)))
  {
    return {};
  }
  this->ReleaseGraphicsResources(this->Window);
  std::ostringstream text;
  text << "The shadows of opaque geometry need " << count << " views of " << pixels << " x "
       << pixels << " pixels, of which the device holds no more than " << most
       << " along an edge of a texture; lower their resolution (SetOpaqueShadowResolution), free "
          "device memory, "
          "use fewer lights or switch these shadows off (OpaqueShadowsOff).";
  return text.str();
}

//------------------------------------------------------------------------------
bool vtkMediumShadowMap::Allocate(const glm::ivec2& tiles, int pixels)
{
  vtkTextureObject* map = this->Map;
  map->ReleaseGraphicsResources(this->Window);
  this->Framebuffer->ReleaseGraphicsResources(this->Window); // it would keep the old texture
  map->SetContext(this->Window);
  map->SetWrapS(vtkTextureObject::ClampToEdge);
  map->SetWrapT(vtkTextureObject::ClampToEdge);
  map->SetMinificationFilter(vtkTextureObject::Linear);
  map->SetMagnificationFilter(vtkTextureObject::Linear);
  map->SetDepthTextureCompare(true);
  map->SetDepthTextureCompareFunction(vtkTextureObject::Lequal);
  if (!map->AllocateDepth(tiles.x * pixels, tiles.y * pixels, vtkTextureObject::Float32) ||
    !vtkMediumIsAllocated(map))
  {
    return false;
  }
  this->Tiles = tiles;
  this->Pixels = pixels;
  vtkOpenGLState* state = this->Window->GetState();
  state->PushFramebufferBindings();
  this->Framebuffer->SetContext(this->Window);
  this->Framebuffer->Bind();
  this->Framebuffer->AddDepthAttachment(map);
  state->vtkglDrawBuffer(GL_NONE);
  state->vtkglReadBuffer(GL_NONE);
  const bool complete = glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  state->PopFramebufferBindings();
  return complete;
}

//------------------------------------------------------------------------------
glm::ivec2 vtkMediumShadowMap::CornerOf(std::size_t view) const
{
  const int number = static_cast<int>(view);
  return this->Pixels * glm::ivec2(number % this->Tiles.x, number / this->Tiles.x);
}

//------------------------------------------------------------------------------
void vtkMediumShadowMap::DrawChanged(const vtkMediumScene& scene, const std::vector<View>& views)
{
  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  const bool clamped = glIsEnabled(GL_DEPTH_CLAMP); // which vtkOpenGLState does not know
  glEnable(GL_DEPTH_CLAMP);
  state->PushFramebufferBindings();
  for (std::size_t i = 0; i < views.size() && this->Complete; ++i)
  {
    const vtkMediumSignature signature = SignatureOf(scene, views[i]);
    if (signature != this->Drawn[i])
    {
      this->Framebuffer->Bind();
      this->DrawView(scene, views[i], this->CornerOf(i));
      this->Complete = this->Window->GetAbortRender() == 0; // props draw nothing then
      this->Drawn[i] = this->Complete ? signature : vtkMediumSignature();
      ++this->Builds;
    }
  }
  state->PopFramebufferBindings();
  if (!clamped)
  {
    glDisable(GL_DEPTH_CLAMP);
  }
}

//------------------------------------------------------------------------------
void vtkMediumShadowMap::DrawView(
  const vtkMediumScene& scene, const View& view, const glm::ivec2& corner)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglViewport(corner.x, corner.y, this->Pixels, this->Pixels);
  state->vtkglScissor(corner.x, corner.y, this->Pixels, this->Pixels);
  const float farthest = 1;
  glClearBufferfv(GL_DEPTH, 0, &farthest);

  const vtkMediumScene::Box& box = scene.Geometry;
  const glm::dvec3 eye = box.Center + box.Length * view.Eye;
  const glm::dvec3 focus = eye + box.Length * view.Forward;
  vtkNew<vtkMatrix4x4> projection;
  for (int i = 0; i < 16; ++i)
  {
    const double unit = i % 4 < 3 ? box.Length : 1; // world to local
    projection->SetElement(i / 4, i % 4, view.Projection[i % 4][i / 4] / unit);
  }
  // A renderer of its own, for observers of the user's are told of each camera that it gets. It has no
  // lights, and must know so: without a colour, VTK's shaders may discard a surface as transparent.
  vtkNew<vtkOpenGLRenderer> renderer;
  vtkNew<vtkCamera> camera;
  camera->SetPosition(eye.x, eye.y, eye.z);
  camera->SetFocalPoint(focus.x, focus.y, focus.z);
  camera->SetViewUp(view.Up.x, view.Up.y, view.Up.z);
  camera->SetParallelProjection(view.Parallel);
  camera->SetExplicitProjectionTransformMatrix(projection);
  camera->UseExplicitProjectionTransformMatrixOn();
  renderer->SetRenderWindow(this->Window);
  renderer->SetActiveCamera(camera);
  renderer->AutomaticLightCreationOff();
  renderer->UpdateLights();
  for (const vtkMediumScene::Caster& caster : scene.Casters)
  {
    caster.Prop->RenderOpaqueGeometry(renderer);
  }
  renderer->SetRenderWindow(nullptr);
}

//------------------------------------------------------------------------------
bool vtkMediumShadowMap::UploadViews(const std::vector<View>& views, const std::vector<int>& faces)
{
  const glm::dvec2 size(this->Pixels * this->Tiles);
  std::vector<float> texels;
  for (int face : faces)
  {
    glm::dmat4 place(0);
    if (face >= 0)
    {
      // Clip coordinates, -w to w, to the part of the texture, and depths to 0…1.
      const glm::dvec2 corner = glm::dvec2(this->CornerOf(face)) / size;
      const glm::dvec3 half(0.5 * this->Pixels / size, 0.5);
      glm::dmat4 toTexture(1);
      for (int axis = 0; axis < 3; ++axis)
      {
        toTexture[axis][axis] = half[axis];
        toTexture[3][axis] = half[axis] + (axis < 2 ? corner[axis] : 0.0);
      }
      place = toTexture * views[face].LocalToClip();
      // Float is coarse beside the distance of a far light, so that is divided by.
      place /= std::max(std::abs(place[3][3]), 1.0);
    }
    for (int row = 0; row < RowsOfMatrix; ++row)
    {
      for (int column = 0; column < 4; ++column)
      {
        texels.push_back(static_cast<float>(place[column][row]));
      }
    }
  }
  vtkTextureObject* table = this->ViewTable;
  if (table->GetHandle() && texels == this->ViewTexels)
  {
    return true;
  }
  table->SetContext(this->Window);
  table->SetMinificationFilter(vtkTextureObject::Nearest);
  table->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->ViewTexels = texels;
  if (table->Create2DFromRaw(
        RowsOfMatrix, static_cast<int>(faces.size()), 4, VTK_FLOAT, texels.data()) &&
    vtkMediumIsAllocated(table))
  {
    return true;
  }
  table->ReleaseGraphicsResources(this->Window); // so that the next frame tries anew
  return false;
}

//------------------------------------------------------------------------------
void vtkMediumShadowMap::Activate(vtkShaderProgram* program, const vtkMediumPlan& plan)
{
  this->Active = plan.OpaqueShadows;
  if (this->Active)
  {
    this->Map->Activate();
    program->SetUniformi("shadowMap", this->Map->GetTextureUnit());
    this->ViewTable->Activate();
    program->SetUniformi("shadowViews", this->ViewTable->GetTextureUnit());
  }
}

//------------------------------------------------------------------------------
void vtkMediumShadowMap::Deactivate()
{
  if (this->Active)
  {
    this->ViewTable->Deactivate();
    this->Map->Deactivate();
    this->Active = false;
  }
}

//------------------------------------------------------------------------------
void vtkMediumShadowMap::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Map->ReleaseGraphicsResources(window);
  this->ViewTable->ReleaseGraphicsResources(window);
  this->Framebuffer->ReleaseGraphicsResources(window);
  this->Tiles = glm::ivec2(0);
  this->Drawn.clear();
}

//------------------------------------------------------------------------------
vtkTypeInt64 vtkMediumShadowMap::GetBytes() const
{
  const vtkTypeInt64 texels =
    static_cast<vtkTypeInt64>(this->Tiles.x) * this->Tiles.y * this->Pixels * this->Pixels;
  return static_cast<vtkTypeInt64>(sizeof(float)) * texels;
}
