// Steps and estimates while the view moves: those of no other view.

#include "Module/Scenes/MapperScene.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace varimarch;

namespace
{

constexpr double MovingTolerance = 1.0 / 64.0;

// One half is smooth, the other half noise.
vtkSmartPointer<vtkImageData> SmoothBesideNoise()
{
  constexpr int Columns = 200;
  constexpr int Rows = 100;
  constexpr int Slices = 20;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> value(0.0f, 1.0f);
  vtkNew<vtkFloatArray> values;
  for (int i = 0; i < Columns * Rows * Slices; ++i)
  {
    const bool isSmooth = i % Columns < Columns / 2;
    values->InsertNextValue(isSmooth ? 0.3f + 0.01f * float(i / (Columns * Rows)) : value(random));
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Columns, Rows, Slices);
  image->SetOrigin(-0.5 * (Columns - 1), -0.5 * (Rows - 1), -0.5 * (Slices - 1));
  image->GetPointData()->SetScalars(values);
  return image;
}

// Shows the smooth half up to a column, in parallel projection.
class SmoothHalf
{
public:
  SmoothHalf()
    : scene(SmoothBesideNoise(), 96)
  {
    this->scene.opacities->RemoveAllPoints();
    this->scene.opacities->AddPoint(0.3, 0.0);
    this->scene.opacities->AddPoint(0.55, 0.02);
    this->scene.opacities->AddPoint(0.6, 0.7);
    this->scene.opacities->AddPoint(0.65, 0.0);
    this->scene.mapper->SetErrorTolerance(MovingTolerance);
    this->PanTo(-50.5);
  }

  void PanTo(double x) { this->scene.LookDown({ x, 0.0, 0.0 }, 50.0); }

  void ExpectKept(WayToDraw draw)
  {
    const std::vector<float> drawn = (this->scene.*draw)();
    const std::vector<float> truth = this->scene.Truth(1e-3);
    const ImageError error = CompareImages(drawn.data(), truth.data(), truth.size() / 4);
    EXPECT_LE(error.percentile999, 255.0 * MovingTolerance);
    EXPECT_TRUE(this->scene.mapper->GetErrorToleranceIsKept());
    EXPECT_GT(255.0 * this->scene.mapper->GetEstimatedError(), 0.5 * error.percentile999);
  }

  MapperScene scene;
};

}

TEST(MovingViews, DoNotTakeTheStepsOfAViewWithoutNoise)
{
  for (const WayToDraw draw : WaysToDraw())
  {
    SmoothHalf half;
    (half.scene.*draw)();
    half.PanTo(-46.0);
    half.ExpectKept(draw);
  }
}

// The peak of the transfer function lies between all samples of a view without noise, too.
TEST(MovingViews, AreNotKeptByPeaksThatNoSampleMeets)
{
  SmoothHalf half;
  half.scene.opacities->RemoveAllPoints();
  half.scene.opacities->AddPoint(0.6, 0.0);
  half.scene.opacities->AddPoint(0.6001, 1.0);
  half.scene.opacities->AddPoint(0.6002, 0.0);
  half.scene.Draw();
  half.PanTo(-46.0);
  half.ExpectKept(&MapperScene::Draw);
}
