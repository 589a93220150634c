// Trial images see what an image shows, whatever pattern the data have.

#include "Module/Scenes/MapperScene.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <string>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double SearchTolerance = 1.0 / 64.0;

// Noise in some columns of voxels along z, and elsewhere one value, which is not visible.
vtkSmartPointer<vtkImageData> NoiseWhere(
  const glm::ivec2& columns, const std::function<bool(int x, int y)>& isNoise)
{
  constexpr int Slices = 6;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> value(0.0f, 1.0f);
  vtkNew<vtkFloatArray> values;
  for (int z = 0; z < Slices; ++z)
  {
    for (int i = 0; i < columns.x * columns.y; ++i)
    {
      values->InsertNextValue(isNoise(i % columns.x, i / columns.x) ? value(random) : 0.75f);
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(columns.x, columns.y, Slices);
  image->SetSpacing(1.0, 1.0, 2.0);
  image->SetOrigin(-0.5 * (columns.x - 1), -0.5 * (columns.y - 1), 0.0);
  image->GetPointData()->SetScalars(values);
  return image;
}

// An image along z in parallel projection, in which only the noise is visible, at a thin peak.
class NoiseAlongZ
{
public:
  NoiseAlongZ(vtkImageData* image, int size, double halfMm)
    : scene(image, size)
  {
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(0.55, 0.0);
    this->scene.opacities->AddPoint(0.6, 0.5);
    this->scene.opacities->AddPoint(0.65, 0.0);
    this->scene.LookDown(glm::dvec3(0.0), halfMm);
    this->scene.mapper->SetErrorTolerance(SearchTolerance);
  }

  void ExpectKept(const std::string& what)
  {
    const std::vector<float> truth = this->scene.Truth(1e-3);
    for (const WayToDraw draw : WaysToDraw())
    {
      const std::vector<float> drawn = (this->scene.*draw)();
      const ImageError error = CompareImages(drawn.data(), truth.data(), truth.size() / 4);
      EXPECT_LE(error.percentile999, 255.0 * SearchTolerance) << what;
      EXPECT_GT(this->scene.mapper->GetEstimatedError(), 0.1 * SearchTolerance) << what;
    }
  }

  MapperScene scene;
};

}

// Trial rays in a grid would all meet columns without noise: each second, or each fourth along a
// diagonal.
TEST(TrialImages, SeeNoiseBetweenColumnsOfOneValue)
{
  NoiseAlongZ(NoiseWhere({ 193, 193 }, [](int x, int) { return x % 2 == 0; }), 192, 96.0)
    .ExpectKept("columns");
  NoiseAlongZ(NoiseWhere({ 193, 193 }, [](int, int y) { return y % 4 == 0; }), 192, 96.0)
    .ExpectKept("rows");
  NoiseAlongZ(NoiseWhere({ 193, 193 }, [](int x, int y) { return (x + y) % 4 == 0; }), 192, 96.0)
    .ExpectKept("diagonals");
}

// All pixels of a small image are tried: some of them alone show noise.
TEST(TrialImages, SeeAllPixelsOfASmallImage)
{
  constexpr int Side = 57;
  for (int row = 0; row < Side; row += 7)
  {
    NoiseAlongZ scene(
      NoiseWhere({ Side, Side }, [=](int, int y) { return y == row; }), Side - 1, 0.5 * (Side - 1));
    scene.ExpectKept("row " + std::to_string(row));
  }
}
