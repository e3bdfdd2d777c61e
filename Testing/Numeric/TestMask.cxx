// SPDX-FileCopyrightText: Copyright (c) The ParticipatingMedia developers
// SPDX-License-Identifier: BSD-3-Clause
// Masks and ghosts, on eye rays and on light rays, in every integrator.
#include "ReferenceScene.h"

#include "vtkDataSetAttributes.h"

using namespace vtkMediumTest;

namespace
{
using Mapper = vtkSingleScatteringVolumeMapper;

/// Few, for the edges of shadows make the reference slow.
constexpr int Pixels = 24;

/// Blocks of 6 x 6 x 6 voxels, some of which are left out.
bool IsLeftOut(const glm::ivec3& voxel)
{
  const glm::ivec3 block = voxel / 6;
  return vtkMediumFixtures::Random(block.x + 16 * (block.y + 16 * block.z), 4) < 0.4;
}

vtkSmartPointer<vtkUnsignedCharArray> MakeBytes(const glm::ivec3& n, bool leftOutIsZero)
{
  auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
  for (int i = 0; i < n.x * n.y * n.z; ++i)
  {
    const bool out = IsLeftOut({ i % n.x, i / n.x % n.y, i / n.x / n.y });
    bytes->InsertNextValue(out == leftOutIsZero ? 0 : 7);
  }
  return bytes;
}

vtkSmartPointer<vtkImageData> MakeMask(vtkImageData* input, bool onCells)
{
  auto mask = vtkSmartPointer<vtkImageData>::New();
  glm::ivec3 points;
  input->GetDimensions(&points[0]);
  mask->SetDimensions(&points[0]);
  onCells ? mask->GetCellData()->SetScalars(MakeBytes(points - 1, true))
          : mask->GetPointData()->SetScalars(MakeBytes(points, true));
  return mask;
}

struct MaskedScene : ReferenceScene
{
  vtkSmartPointer<vtkImageData> Mask;

  explicit MaskedScene(vtkMediumFixtures::Fields field, bool maskOnCells = false)
    : ReferenceScene(field)
    , Mask(MakeMask(vtkImageData::SafeDownCast(this->Mapper->GetDataObjectInput()), maskOnCells))
  {
    this->Window->SetSize(Pixels, Pixels);
    this->Renderer->RemoveAllLights();
    this->AddBeam({ 1, -0.8, -0.2 });
    this->Mapper->SetMaskInput(this->Mask);
    this->Reference->SetMaskInput(this->Mask);
  }
};
}

TEST(Mask, ExactMeetsTheTruth)
{
  for (bool onCells : { false, true })
  {
    MaskedScene scene(vtkMediumFixtures::Smooth, onCells);
    scene.Mapper->SetIntegratorToExact();
    scene.FindTruth();
    ASSERT_GT(scene.Peak, 0.01);
    const ReferenceScene::Errors errors = scene.Measure();
    EXPECT_LT(errors.Largest, 1e-4) << onCells;
    EXPECT_LT(errors.Alpha, 2e-5) << onCells;
  }
}

// Steps that fall across a voxel's border count it on one side: first order, as with nearest voxels.
TEST(Mask, FixedStepConvergesToTheTruth)
{
  MaskedScene scene(vtkMediumFixtures::Smooth);
  scene.FindTruth();
  const double coarse = scene.Measure(0.5 * ReferenceVoxel).RootMeanSquare;
  const double fine = scene.Measure(0.125 * ReferenceVoxel).RootMeanSquare;
  EXPECT_GT(std::log(coarse / fine) / std::log(4), 0.8);
  EXPECT_LT(fine, 1e-3);
}

TEST(Mask, ErrorControlledKeepsTheError)
{
  MaskedScene scene(vtkMediumFixtures::Smooth);
  scene.Medium->SetExtinctionScale(6);
  scene.Mapper->SetIntegratorToErrorControlled();
  scene.Mapper->SetMaximumError(0.02);
  scene.FindTruth();
  const ReferenceScene::Errors errors = scene.Measure();
  EXPECT_LE(errors.Largest, 0.02);
  EXPECT_GE(scene.Mapper->GetEstimatedError(), errors.Largest);
}

TEST(Mask, PaperConvergesToTheTruth)
{
  MaskedScene scene(vtkMediumFixtures::Smooth);
  scene.Mapper->SetPaperThreshold(0); // every voxel
  scene.Medium->SetExtinctionArrayName(nullptr);
  scene.Medium->SetExtinctionScale(1);
  scene.Medium->SetAnisotropy(0);
  scene.Mapper->SetIntegratorToPaper();
  scene.Mapper->SetJitter(0);
  scene.Mapper->SetBinarySearchIterations(10);
  scene.FindTruth();
  const ReferenceScene::Errors coarse = scene.Measure(ReferenceVoxel);
  const ReferenceScene::Errors fine = scene.Measure(0.25 * ReferenceVoxel);
  EXPECT_TRUE(scene.Scene::Errors.empty());
  EXPECT_GT(coarse.RootMeanSquare / fine.RootMeanSquare, 3);
  EXPECT_LT(fine.RootMeanSquare, 2e-3);
}

// The same renderer on a volume with zeros in place of what is left out.
TEST(Mask, MaskAndGhostsAreVoxelsOfZeroUnderNearestInterpolation)
{
  for (bool onCells : { false, true })
  {
    for (int integrator : { Mapper::FixedStep, Mapper::Exact })
    {
      Picture pictures[3];
      for (int way = 0; way < 3; ++way) // zeros, a mask, ghosts
      {
        ReferenceScene scene(vtkMediumFixtures::Smooth, onCells);
        scene.Window->SetSize(Pixels, Pixels);
        scene.Property->SetInterpolationTypeToNearest();
        scene.Mapper->SetIntegrator(integrator);
        vtkImageData* image = vtkImageData::SafeDownCast(scene.Mapper->GetDataObjectInput());
        vtkDataSetAttributes* data = onCells
          ? static_cast<vtkDataSetAttributes*>(image->GetCellData())
          : static_cast<vtkDataSetAttributes*>(image->GetPointData());
        const glm::ivec3 n(ReferencePoints - (onCells ? 1 : 0));
        vtkSmartPointer<vtkUnsignedCharArray> ghosts = MakeBytes(n, false);
        ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
        for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples() && way == 0; ++i)
        {
          if (ghosts->GetValue(i) != 0)
          {
            data->GetScalars()->SetTuple1(i, 0);
          }
        }
        scene.Mapper->SetMaskInput(way == 1 ? MakeMask(image, onCells) : nullptr);
        if (way == 2)
        {
          data->AddArray(ghosts);
        }
        pictures[way] = scene.Render();
      }
      EXPECT_LT(Difference(pictures[0], pictures[1]), 2e-4) << integrator; // S
      EXPECT_LT(Difference(pictures[0], pictures[2]), 2e-4) << integrator;
    }
  }
}

TEST(Mask, IsUploadedOnceAndCompiledOnlyWhereThereIsOne)
{
  MaskedScene scene(vtkMediumFixtures::Smooth);
  vtkMediumStatistics* done = scene.Mapper->GetStatistics();
  scene.Mapper->SetMaskInput(nullptr);
  const Picture whole = scene.Render();
  const vtkTypeInt64 compiles = done->GetProgramCompiles(), uploads = done->GetTextureUploads();
  vtkNew<vtkImageData> all;
  all->DeepCopy(scene.Mask);
  all->GetPointData()->GetScalars()->Fill(1);
  scene.Mapper->SetMaskInput(all); // leaves nothing out
  EXPECT_EQ(whole.Values, scene.Render().Values);
  EXPECT_EQ(done->GetProgramCompiles(), compiles);
  EXPECT_EQ(done->GetTextureUploads(), uploads);
  scene.Mapper->SetMaskInput(scene.Mask);
  EXPECT_GT(Difference(whole, scene.Render()), 0.01);
  EXPECT_EQ(done->GetProgramCompiles(), compiles + 1);
  EXPECT_EQ(done->GetTextureUploads(), uploads + 1);
  scene.Render();
  EXPECT_EQ(done->GetTextureUploads(), uploads + 1);
  scene.Mask->GetPointData()->GetScalars()->Fill(0); // changed in place
  scene.Mask->GetPointData()->GetScalars()->Modified();
  const Picture nothing = scene.Render();
  EXPECT_EQ(*std::max_element(nothing.Values.begin(), nothing.Values.end()), 0);
  EXPECT_EQ(done->GetTextureUploads(), uploads + 2);
  EXPECT_EQ(done->GetProgramCompiles(), compiles + 1);
}
