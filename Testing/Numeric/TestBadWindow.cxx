// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Windows and inputs that VTK itself keeps from the mapper, or that have nothing to show.
#include "BadInput.h"

#include "vtkObjectFactory.h"

using namespace vtkMediumTest;

namespace
{
/// A window of another graphics system.
class OtherWindow : public vtkRenderWindow
{
public:
  static OtherWindow* New();
  vtkTypeMacro(OtherWindow, vtkRenderWindow);
};
vtkStandardNewMacro(OtherWindow);
}

TEST(BadWindow, WithoutOpenGLIsRefusedOnce)
{
  Scene scene(MakeBox(), 12);
  scene.AddBeam({ 0, -1, 0 });
  vtkNew<OtherWindow> other;
  vtkNew<vtkRenderer> renderer;
  renderer->SetRenderWindow(other);
  scene.Mapper->Render(renderer, scene.Volume);
  scene.Mapper->Render(renderer, scene.Volume);
  ASSERT_EQ(scene.Errors.size(), 1u);
  EXPECT_NE(scene.Errors[0].find("OtherWindow"), std::string::npos) << scene.Errors[0];
  EXPECT_NE(scene.Errors[0].find("3.2"), std::string::npos) << scene.Errors[0];
  renderer->SetRenderWindow(nullptr);
  EXPECT_GT(scene.Render().Mean(), 0);
  EXPECT_EQ(scene.Errors.size(), 1u);
}

TEST(BadWindow, MissingWindowIsRefusedOnce)
{
  Scene scene(MakeBox(), 12);
  scene.AddBeam({ 0, -1, 0 });
  vtkNew<vtkRenderer> renderer;
  scene.Mapper->Render(renderer, scene.Volume);
  ASSERT_EQ(scene.Errors.size(), 1u);
  EXPECT_NE(scene.Errors[0].find("none"), std::string::npos) << scene.Errors[0];
  EXPECT_GT(scene.Render().Mean(), 0);
}

TEST(BadWindow, ViewportWithoutPixelsShowsNothing)
{
  Scene scene(MakeBox(), 12);
  scene.AddBeam({ 0, -1, 0 });
  Scene fresh(MakeBox(), 12);
  fresh.AddBeam({ 0, -1, 0 });
  scene.Renderer->SetViewport(0.5, 0.5, 0.5, 0.5);
  scene.Window->Render();
  EXPECT_EQ(scene.Errors.size(), 0u) << scene.Errors[0];
  scene.Renderer->SetViewport(0, 0, 1, 1);
  EXPECT_EQ(fresh.Render().Values, scene.Render().Values);
}

TEST(BadWindow, VolumeWithoutInputShowsNothingAndComesBack)
{
  // vtkVolume asks its mapper to render only when there is an input; VTK's pipeline reports the rest.
  Scene scene(MakeBox(), 12);
  scene.AddBeam({ 0, -1, 0 });
  const Picture valid = scene.Render();
  vtkObject::GlobalWarningDisplayOff();
  scene.Mapper->RemoveAllInputConnections(0);
  const std::vector<unsigned char> shown = scene.RenderWindow();
  vtkObject::GlobalWarningDisplayOn();
  for (unsigned char byte : shown)
  {
    ASSERT_EQ(byte, 0);
  }
  EXPECT_LE(scene.Errors.size(), 1u);
  scene.Mapper->SetInputData(MakeBox());
  EXPECT_EQ(valid.Values, scene.Render().Values);
}

TEST(BadWindow, MissingInputIsNamedByTheMapper)
{
  Scene scene(MakeBox(), 12);
  scene.AddBeam({ 0, -1, 0 });
  scene.Render();
  scene.Mapper->RemoveAllInputConnections(0);
  scene.Mapper->Render(scene.Renderer, scene.Volume);
  ASSERT_EQ(scene.Errors.size(), 1u);
  EXPECT_NE(scene.Errors[0].find("missing"), std::string::npos) << scene.Errors[0];
}

// Some versions of VTK cull what has no bounds before it comes to the mapper; then there is no error but from the
// mapper itself.
TEST(BadWindow, EmptyImageShowsTheBackgroundAndIsRefusedOnce)
{
  for (int integrator : AllIntegrators)
  {
    SCOPED_TRACE(testing::Message() << "integrator " << integrator);
    ValidScene scene(integrator);
    const Picture valid = scene.Render();
    scene.Volume->VisibilityOff();
    const std::vector<unsigned char> background = scene.RenderWindow();
    scene.Volume->VisibilityOn();
    scene.Mapper->SetInputData(vtkNew<vtkImageData>());
    EXPECT_EQ(background, scene.RenderWindow());
    EXPECT_EQ(background, scene.RenderWindow());
    scene.Mapper->Render(scene.Renderer, scene.Volume);
    ASSERT_EQ(scene.Errors.size(), 1u);
    EXPECT_NE(scene.Errors[0].find("extent 0..-1"), std::string::npos) << scene.Errors[0];
    EXPECT_NE(scene.Errors[0].find("two points"), std::string::npos) << scene.Errors[0];
    scene.Mapper->SetInputData(MakeBox());
    EXPECT_EQ(scene.Render().Values, valid.Values);
    EXPECT_EQ(scene.Errors.size(), 1u);
  }
}
