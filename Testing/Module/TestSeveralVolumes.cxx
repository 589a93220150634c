// Several volumes in one renderer.

#include "Module/HomogeneousScene.h"

#include <vtkVariationFieldGPUVolumeRayCastMapper.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using Adapter = vtkVariationFieldGPUVolumeRayCastMapper;

vtkVariationFieldVolumeMapper* DrawingMapper(vtkVariationFieldVolumeMapper* mapper)
{
  return mapper;
}

vtkVariationFieldVolumeMapper* DrawingMapper(Adapter* mapper)
{
  return mapper->GetVariationFieldMapper();
}

// A second cube of another material, which the test moves along the view.
template <class Mapper>
struct SecondCubeBy
{
  explicit SecondCubeBy(HomogeneousScene& scene)
  {
    this->mapper->SetInputData(HomogeneousCube(HomogeneousScene::SideMm));
    DrawingMapper(this->mapper)->SetErrorTolerance(0.0);
    this->volume->SetMapper(this->mapper);
    UseOneMaterial(this->volume->GetProperty(), { 0.1, 0.2, 0.9 }, 0.05);
    scene.renderer->AddVolume(this->volume);
  }

  vtkNew<Mapper> mapper;
  vtkNew<vtkVolume> volume;
};

using SecondCube = SecondCubeBy<vtkVariationFieldVolumeMapper>;

void ExpectMiddle(const std::vector<float>& picture, const std::array<double, 4>& truth)
{
  for (int channel = 0; channel < 4; ++channel)
  {
    EXPECT_NEAR(picture[4 * (16 * 32 + 16) + channel], truth[channel], 1e-4) << channel;
  }
}

}

TEST(SeveralVolumes, AreBlendedBackToFrontInWhateverOrderTheyWereAdded)
{
  const double seen = 1.0 - std::pow(0.95, HomogeneousScene::SideMm);
  const std::array<double, 4> second = { 0.1 * seen, 0.2 * seen, 0.9 * seen, seen };
  HomogeneousScene scene(0.05);
  const SecondCube other(scene);
  const std::array<double, 4> first = scene.Piece(HomogeneousScene::SideMm);
  // Render each position twice: a volume that is now drawn behind another must be rendered again.
  for (double zMm : { -20.0, 20.0, 20.0, -20.0, -20.0 })
  {
    other.volume->SetPosition(0.0, 0.0, zMm);
    ExpectMiddle(scene.Draw(), zMm > 0.0 ? Over(second, first) : Over(first, second));
  }
}

TEST(SeveralVolumes, OneInsideAnotherIsDrawnOverItInWhateverOrderTheyWereAdded)
{
  const double inside = 0.5 * HomogeneousScene::SideMm;
  const double seen = 1.0 - std::pow(0.95, inside);
  const std::array<double, 4> second = { 0.1 * seen, 0.2 * seen, 0.9 * seen, seen };
  HomogeneousScene scene(0.05);
  const SecondCube other(scene);
  other.mapper->SetInputData(HomogeneousCube(inside));
  const std::array<double, 4> first = scene.Piece(HomogeneousScene::SideMm);
  for (vtkVolume* addedLast : { scene.volume.Get(), other.volume.Get() })
  {
    scene.renderer->RemoveVolume(addedLast);
    scene.renderer->AddVolume(addedLast);
    ExpectMiddle(scene.Draw(), Over(second, first));
  }
}

TEST(SeveralVolumes, AreDrawnWhereTheyLeaveTheViewAndComeBack)
{
  const double seen = 1.0 - std::pow(0.95, HomogeneousScene::SideMm);
  const std::array<double, 4> second = { 0.1 * seen, 0.2 * seen, 0.9 * seen, seen };
  HomogeneousScene scene(0.05);
  const SecondCube other(scene);
  const std::array<double, 4> first = scene.Piece(HomogeneousScene::SideMm);
  for (int turn = 0; turn < 2; ++turn)
  {
    scene.volume->SetPosition(0.0, 0.0, 0.0);
    other.volume->SetPosition(500.0, 0.0, 0.0);
    ExpectMiddle(scene.Draw(), first);
    ExpectMiddle(scene.Draw(), first);
    scene.volume->SetPosition(500.0, 0.0, 0.0);
    other.volume->SetPosition(0.0, 0.0, 0.0);
    ExpectMiddle(scene.Draw(), second);
    ExpectMiddle(scene.Draw(), second);
  }
}

// A program that draws through the plugin has adapters.
TEST(SeveralVolumes, OfThePluginAreBlendedBackToFrontToo)
{
  const double seen = 1.0 - std::pow(0.95, HomogeneousScene::SideMm);
  const std::array<double, 4> second = { 0.1 * seen, 0.2 * seen, 0.9 * seen, seen };
  HomogeneousScene scene(0.05);
  const std::array<double, 4> first = scene.Piece(HomogeneousScene::SideMm);
  const SecondCubeBy<Adapter> other(scene);
  for (const bool areBothAdapters : { false, true })
  {
    vtkNew<Adapter> adapter;
    adapter->SetInputData(HomogeneousCube(HomogeneousScene::SideMm));
    adapter->GetVariationFieldMapper()->SetErrorTolerance(0.0);
    if (areBothAdapters)
    {
      scene.volume->SetMapper(adapter);
    }
    for (double zMm : { -20.0, 20.0, 20.0, -20.0, -20.0 })
    {
      other.volume->SetPosition(0.0, 0.0, zMm);
      ExpectMiddle(scene.Draw(), zMm > 0.0 ? Over(second, first) : Over(first, second));
      EXPECT_STREQ(other.mapper->GetReasonForVtkMapper(), "");
    }
  }
}
