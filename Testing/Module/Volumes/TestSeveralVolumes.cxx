// Several volumes in one renderer.

#include "Module/Scenes/HomogeneousScene.h"

#include <vtkPlane.h>
#include <vtkVariationFieldGPUVolumeRayCastMapper.h>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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

namespace
{

// Volumes of one cube that are cut along x, y or z into slabs of different colours.
struct SlabsOfACube
{
  SlabsOfACube(HomogeneousScene& newScene, const std::vector<std::array<double, 2>>& ends,
    glm::dvec3 normal, bool crops)
    : scene(newScene)
    , image(HomogeneousCube(HomogeneousScene::SideMm))
  {
    this->scene.renderer->RemoveVolume(this->scene.volume);
    for (const auto& [lower, upper] : ends)
    {
      vtkNew<vtkVariationFieldVolumeMapper> mapper;
      mapper->SetErrorTolerance(0.0);
      mapper->SetInputData(this->image);
      crops ? Crop(mapper, normal, lower, upper) : Clip(mapper, normal, lower, upper);
      vtkNew<vtkVolume> volume;
      volume->SetMapper(mapper);
      this->volumes.push_back(volume);
      this->colors.push_back({ this->volumes.size() == 1 ? 1.0 : 0.0,
        this->volumes.size() == 2 ? 1.0 : 0.0, this->volumes.size() == 3 ? 1.0 : 0.0 });
      UseOneMaterial(volume->GetProperty(), this->colors.back(), Opacity);
    }
  }

  // Adds the volumes to the renderer in an order, and expects them to be blended by places.
  void ExpectOrder(
    const std::vector<std::size_t>& added, const std::vector<std::size_t>& backToFront)
  {
    for (vtkVolume* volume : this->volumes)
    {
      this->scene.renderer->RemoveVolume(volume);
    }
    for (const std::size_t i : added)
    {
      this->scene.renderer->AddVolume(this->volumes[i]);
    }
    const double seen = 1.0 - std::pow(1.0 - Opacity, HomogeneousScene::SideMm / 2.0);
    std::array<double, 4> truth = { 0.0, 0.0, 0.0, 0.0 };
    for (const std::size_t i : backToFront)
    {
      const std::array<double, 3>& rgb = this->colors[i];
      truth = Over({ seen * rgb[0], seen * rgb[1], seen * rgb[2], seen }, truth);
    }
    ExpectMiddle(this->scene.Draw(), truth);
  }

  std::vector<vtkSmartPointer<vtkVolume>> volumes;

private:
  static constexpr double Opacity = 0.05;

  static void Clip(vtkVolumeMapper* mapper, glm::dvec3 normal, double lower, double upper)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      const glm::dvec3 place = normal * (sign > 0.0 ? lower : upper);
      vtkNew<vtkPlane> plane;
      plane->SetNormal(sign * normal.x, sign * normal.y, sign * normal.z);
      plane->SetOrigin(place.x, place.y, place.z);
      mapper->AddClippingPlane(plane);
    }
  }

  static void Crop(vtkVolumeMapper* mapper, glm::dvec3 normal, double lower, double upper)
  {
    double planes[6] = { -100.0, 100.0, -100.0, 100.0, -100.0, 100.0 };
    const int axis = normal.x > 0.0 ? 0 : normal.y > 0.0 ? 1 : 2;
    planes[2 * axis] = lower;
    planes[2 * axis + 1] = upper;
    mapper->SetCroppingRegionPlanes(planes);
    mapper->SetCroppingRegionFlagsToSubVolume();
    mapper->CroppingOn();
  }

  HomogeneousScene& scene;
  vtkSmartPointer<vtkImageData> image;
  std::vector<std::array<double, 3>> colors;
};

}

TEST(SeveralVolumes, CutFromOneBoxAreBlendedByWhatIsLeftInWhateverOrderTheyWereAdded)
{
  const double half = HomogeneousScene::SideMm / 2.0;
  for (const bool crops : { false, true })
  {
    HomogeneousScene scene(0.05);
    SlabsOfACube halves(scene, { { -half, 0.0 }, { 0.0, half } }, { 0.0, 0.0, 1.0 }, crops);
    halves.ExpectOrder({ 0, 1 }, { 0, 1 });
    halves.ExpectOrder({ 1, 0 }, { 0, 1 });
    vtkCamera* const camera = scene.renderer->GetActiveCamera();
    double position[3];
    camera->GetPosition(position);
    camera->SetPosition(position[0], position[1], -position[2]);
    halves.ExpectOrder({ 0, 1 }, { 1, 0 });
    halves.ExpectOrder({ 1, 0 }, { 1, 0 });
  }
}

TEST(SeveralVolumes, OverEachOtherInOnePlaceAreDrawnInTheOrderOfTheirAddition)
{
  const double quarter = HomogeneousScene::SideMm / 4.0;
  HomogeneousScene scene(0.05);
  SlabsOfACube same(scene, { { -quarter, quarter }, { -quarter, quarter }, { -quarter, quarter } },
    { 0.0, 0.0, 1.0 }, false);
  std::vector<std::size_t> order = { 0, 1, 2 };
  do
  {
    same.ExpectOrder(order, order);
  } while (std::next_permutation(order.begin(), order.end()));
}

// The centre of the long part is nearer to the camera than that of the part in front of it.
TEST(SeveralVolumes, BesideAPlaneAreBlendedByItsSidesAndNotByTheirCentres)
{
  HomogeneousScene scene(0.05);
  const double half = HomogeneousScene::SideMm / 2.0;
  SlabsOfACube parts(scene, { { -half, 0.0 }, { 0.0, half } }, { 0.0, 0.0, 1.0 }, false);
  UseOneMaterial(parts.volumes[0]->GetProperty(), { 1.0, 0.0, 0.0 }, 0.9);
  UseOneMaterial(parts.volumes[1]->GetProperty(), { 0.0, 1.0, 0.0 }, 0.9);
  parts.volumes[0]->SetScale(30.0, 1.0, 1.0);
  parts.volumes[0]->SetPosition(30.0 * half - 4.0, 0.0, 0.0);
  vtkCamera* const camera = scene.renderer->GetActiveCamera();
  camera->ParallelProjectionOff();
  camera->SetPosition(200.0, 0.0, 40.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetViewAngle(2.0);
  camera->SetClippingRange(1.0, 1000.0);
  for (const std::vector<std::size_t>& added :
    std::vector<std::vector<std::size_t>>{ { 0, 1 }, { 1, 0 } })
  {
    for (vtkVolume* volume : parts.volumes)
    {
      scene.renderer->RemoveVolume(volume);
    }
    for (const std::size_t i : added)
    {
      scene.renderer->AddVolume(parts.volumes[i]);
    }
    const std::vector<float> picture = scene.Draw();
    const float* const middle = &picture[4 * (16 * 32 + 16)];
    EXPECT_GT(middle[1], middle[0]) << "the part in front is green";
  }
}
