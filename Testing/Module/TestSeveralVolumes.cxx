// Several volumes in one renderer.

#include "Module/HomogeneousScene.h"

#include <vtkCullerCollection.h>
#include <vtkFrustumCoverageCuller.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{

// A second cube of another material, beside the scene's along the view.
struct SecondCube
{
  explicit SecondCube(HomogeneousScene& scene, double zMm)
  {
    this->mapper->SetInputData(HomogeneousCube(HomogeneousScene::SideMm));
    this->mapper->SetErrorTolerance(0.0);
    this->volume->SetMapper(this->mapper);
    this->volume->SetPosition(0.0, 0.0, zMm);
    UseOneMaterial(this->volume->GetProperty(), { 0.1, 0.2, 0.9 }, 0.05);
    scene.renderer->AddVolume(this->volume);
  }

  vtkNew<vtkVariationFieldVolumeMapper> mapper;
  vtkNew<vtkVolume> volume;
};

}

TEST(SeveralVolumes, BesideEachOtherAreBlendedInTheOrderOfTheRenderersCuller)
{
  const double seen = 1.0 - std::pow(0.95, HomogeneousScene::SideMm);
  const std::array<double, 4> second = { 0.1 * seen, 0.2 * seen, 0.9 * seen, seen };
  for (double zMm : { -20.0, 20.0 })
  {
    HomogeneousScene scene(0.05);
    const SecondCube other(scene, zMm);
    vtkNew<vtkFrustumCoverageCuller> culler;
    culler->SetSortingStyleToBackToFront();
    scene.renderer->GetCullers()->RemoveAllItems();
    scene.renderer->AddCuller(culler);
    const std::array<double, 4> first = scene.Piece(HomogeneousScene::SideMm);
    const std::array<double, 4> truth = zMm > 0.0 ? Over(second, first) : Over(first, second);
    const std::vector<float> drawn = scene.Draw();
    for (int channel = 0; channel < 4; ++channel)
    {
      EXPECT_NEAR(drawn[4 * (16 * 32 + 16) + channel], truth[channel], 1e-4) << zMm;
    }
  }
}
