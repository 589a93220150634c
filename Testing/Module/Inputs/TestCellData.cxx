// Cell data: a cell is a voxel at its centre, and the volume extends as far as the cells do.

#include "Module/Scenes/MapperScene.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

constexpr int CellDataSize = 64;

// 4 x 5 x 6 cells of 1 mm with a single value, in a named array.
vtkSmartPointer<vtkDataArray> ConstantArray(const char* name, int count, double value)
{
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(VTK_FLOAT));
  array->SetName(name);
  array->SetNumberOfTuples(count);
  array->Fill(value);
  return array;
}

// Each mm of value 1 absorbs half of the light, each mm of value 2 three quarters. Seen along z.
class TwoArrays : public MapperScene
{
public:
  TwoArrays()
    : MapperScene(Image(), 16)
  {
    this->opacities->RemoveAllPoints();
    this->opacities->AddPoint(1.0, 0.5);
    this->opacities->AddPoint(2.0, 0.75);
    this->LookDown({ 2.0, 2.5, 3.0 }, 4.0); // a pixel is 0.5 mm
  }

  /// Number of times that the light is halved along the ray of a pixel.
  double Halvings(int column, int row)
  {
    return -std::log2(1.0 - this->Draw()[4 * (row * 16 + column) + 3]);
  }

private:
  static vtkSmartPointer<vtkImageData> Image()
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(5, 6, 7);
    image->GetCellData()->SetScalars(ConstantArray("cells", 120, 1.0));
    image->GetCellData()->AddArray(ConstantArray("dense", 120, 2.0));
    image->GetPointData()->AddArray(ConstantArray("points", 210, 2.0));
    return image;
  }
};

}

class CellDataOfBlend : public testing::TestWithParam<int>
{
};

TEST_P(CellDataOfBlend, IsTheTruth)
{
  for (const int mode :
    { vtkVariationFieldVolumeMapper::CellField, vtkVariationFieldVolumeMapper::OpticalField })
  {
    MapperScene scene(TorsoOfCells(), CellDataSize);
    scene.mapper->SetBlendMode(GetParam());
    scene.mapper->SetAccelerationMode(mode);
    scene.mapper->AutoAdjustSampleDistancesOff();
    scene.mapper->SetSampleDistance(0.3);
    EXPECT_LT(scene.Error().rootMeanSquare, 0.4);
    scene.volume->GetProperty()->SetInterpolationTypeToNearest();
    EXPECT_LT(scene.Error().rootMeanSquare, 0.4);
    const std::vector<float> drawn = scene.Draw();
    EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.1f) << "nothing is visible";
  }
}

INSTANTIATE_TEST_SUITE_P(SomeBlends, CellDataOfBlend,
  testing::Values(int(vtkVolumeMapper::COMPOSITE_BLEND),
    int(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND), int(vtkVolumeMapper::ADDITIVE_BLEND)));

TEST(CellData, ReachesAsFarAsTheCellsDo)
{
  TwoArrays scene;
  EXPECT_NEAR(scene.Halvings(8, 8), 6.0, 1e-3);
  EXPECT_NEAR(scene.Halvings(4, 3), 6.0, 1e-3) << "in the outermost half of a cell";
  EXPECT_EQ(scene.Halvings(3, 8), 0.0) << "beside the volume";
}

TEST(CellData, AnArrayIsFoundByModeNameAndNumber)
{
  TwoArrays scene;
  scene.mapper->SetScalarModeToUseCellFieldData();
  scene.mapper->SelectScalarArray("dense");
  EXPECT_NEAR(scene.Halvings(8, 8), 12.0, 0.02);
  scene.mapper->SelectScalarArray(0);
  EXPECT_NEAR(scene.Halvings(8, 8), 6.0, 1e-3);
  scene.mapper->SetScalarModeToUsePointFieldData();
  scene.mapper->SelectScalarArray("points");
  EXPECT_NEAR(scene.Halvings(8, 8), 12.0, 0.02);
  scene.mapper->SetScalarModeToUseCellData();
  EXPECT_NEAR(scene.Halvings(8, 8), 6.0, 1e-3);
}

TEST(SampleDistance, IsLockedToTheSpacingAsVtkHasIt)
{
  MapperScene scene(SmallTorso(), CellDataSize);
  scene.mapper->AutoAdjustSampleDistancesOff();
  scene.mapper->LockSampleDistanceToInputSpacingOn();
  scene.Draw();
  const double* const spacing = scene.image->GetSpacing();
  const double mean = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  // Half of the mean spacing, shorter by the cube root of the voxel count below a million.
  const double expected = 0.5 * mean * std::cbrt(40.0 * 36.0 * 24.0 / 1e6);
  EXPECT_NEAR(scene.mapper->GetUsedSampleDistance(), expected, 0.1 * expected);
  EXPECT_EQ(scene.mapper->GetUsedSampleDistance(), scene.mapper->GetSampleDistance());
}
