// Blanked points and cells, and ghosts, are left out.

#include "Module/Scenes/MapperScene.h"

#include <vtkCellData.h>
#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkUniformGrid.h>
#include <vtkUnsignedCharArray.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace varimarch;

namespace
{

// 9 points of 1 mm per side. Each mm absorbs half of the light. Seen along z in parallel
// projection, 0.5 mm per pixel.
class BlankedScene : public MapperScene
{
public:
  explicit BlankedScene(vtkUniformGrid* grid)
    : MapperScene(grid, 16)
  {
    this->opacities->RemoveAllPoints();
    this->opacities->AddPoint(0.0, 0.5);
    this->mapper->SetEarlyTerminationTransmittance(0.0);
    this->LookDown({ 4.0, 4.0, 4.0 }, 4.0);
  }

  /// Length of the material along the ray at x, y [mm]; pixel centres are at 0.25 and 0.75.
  double LengthMm(double x, double y)
  {
    const std::size_t pixel = std::size_t(y / 0.5) * 16 + std::size_t(x / 0.5);
    const auto lengthIn = [&](const std::vector<float>& drawn)
    { return -std::log2(1.0 - drawn[4 * pixel + 3]); };
    const double marched = lengthIn(this->DrawByProcessor());
    EXPECT_TRUE(this->ShaderParts().empty());
    const double drawn = lengthIn(this->Draw());
    EXPECT_NEAR(marched, drawn, 1e-3) << "the processor's and the shader's";
    return drawn;
  }
};

vtkSmartPointer<vtkUniformGrid> Grid(bool ofCells)
{
  auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->SetDimensions(9, 9, 9);
  vtkSmartPointer<vtkDataArray> values;
  values.TakeReference(vtkDataArray::CreateDataArray(VTK_UNSIGNED_CHAR));
  values->SetName("values");
  values->SetNumberOfTuples(ofCells ? grid->GetNumberOfCells() : grid->GetNumberOfPoints());
  values->Fill(7.0);
  if (ofCells)
  {
    grid->GetCellData()->SetScalars(values);
  }
  else
  {
    grid->GetPointData()->SetScalars(values);
  }
  return grid;
}

constexpr double LengthError = 1e-3; // [mm]: rounding of floats over 8 mm

vtkIdType PointAt(int x, int y, int z)
{
  return (z * 9 + y) * 9 + x;
}

vtkIdType CellAt(int x, int y, int z)
{
  return (z * 8 + y) * 8 + x;
}

}

TEST(Blanking, APointRemovesTheCellsAroundIt)
{
  const auto grid = Grid(false);
  grid->BlankPoint(PointAt(3, 4, 5));
  BlankedScene scene(grid);
  EXPECT_NEAR(scene.LengthMm(3.25, 4.25), 6.0, LengthError);
  EXPECT_NEAR(scene.LengthMm(2.25, 3.25), 6.0, LengthError);
  EXPECT_NEAR(scene.LengthMm(4.25, 4.25), 8.0, LengthError);
  // Without interpolation, the point is a box of its own.
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  EXPECT_NEAR(scene.LengthMm(3.25, 4.25), 7.0, LengthError);
  EXPECT_NEAR(scene.LengthMm(2.25, 3.25), 8.0, LengthError);
}

TEST(Blanking, APointRemovesTheCellsAroundItForCellData)
{
  const auto grid = Grid(true);
  grid->BlankPoint(PointAt(3, 4, 5));
  BlankedScene scene(grid);
  for (const int interpolation : { VTK_LINEAR_INTERPOLATION, VTK_NEAREST_INTERPOLATION })
  {
    scene.volume->GetProperty()->SetInterpolationType(interpolation);
    EXPECT_NEAR(scene.LengthMm(3.25, 4.25), 6.0, LengthError);
    EXPECT_NEAR(scene.LengthMm(2.75, 3.75), 6.0, LengthError);
    EXPECT_NEAR(scene.LengthMm(4.25, 4.25), 8.0, LengthError);
    EXPECT_NEAR(scene.LengthMm(3.25, 5.25), 8.0, LengthError);
  }
}

TEST(Blanking, ACellIsLeftOutAndNoMore)
{
  for (const bool ofCells : { false, true })
  {
    const auto grid = Grid(ofCells);
    grid->BlankCell(CellAt(3, 4, 5));
    BlankedScene scene(grid);
    for (const int interpolation : { VTK_LINEAR_INTERPOLATION, VTK_NEAREST_INTERPOLATION })
    {
      scene.volume->GetProperty()->SetInterpolationType(interpolation);
      EXPECT_NEAR(scene.LengthMm(3.25, 4.75), 7.0, LengthError) << ofCells;
      EXPECT_NEAR(scene.LengthMm(2.75, 4.75), 8.0, LengthError) << ofCells;
      EXPECT_NEAR(scene.LengthMm(3.25, 5.25), 8.0, LengthError) << ofCells;
    }
  }
}

TEST(Blanking, ChangedFlagsChangeThePicture)
{
  const auto grid = Grid(false);
  BlankedScene scene(grid);
  EXPECT_NEAR(scene.LengthMm(3.25, 4.75), 8.0, LengthError);
  const std::vector<std::string> before = scene.ShaderParts();
  const auto setBlank = [&](int z, bool blank)
  {
    blank ? grid->BlankCell(CellAt(3, 4, z)) : grid->UnBlankCell(CellAt(3, 4, z));
    grid->GetCellGhostArray()->Modified();
  };
  setBlank(5, true);
  setBlank(1, true);
  EXPECT_NEAR(scene.LengthMm(3.25, 4.75), 6.0, LengthError);
  setBlank(5, false);
  EXPECT_NEAR(scene.LengthMm(3.25, 4.75), 7.0, LengthError);
  setBlank(1, false);
  EXPECT_NEAR(scene.LengthMm(3.25, 4.75), 8.0, LengthError);
  EXPECT_EQ(scene.ShaderParts(), before) << "a volume without gaps has a cost";
}

TEST(Blanking, TheNanColorDoesNotApplyToBlankedPoints)
{
  const auto grid = Grid(false);
  grid->BlankCell(CellAt(3, 4, 5));
  BlankedScene scene(grid);
  scene.mapper->SetNanOpacity(1.0);
  EXPECT_NEAR(scene.LengthMm(3.25, 4.75), 7.0, LengthError);
}

TEST(Blanking, FacesOfBlankedVoxelsAreNoSurfaces)
{
  const auto grid = Grid(false);
  for (vtkIdType point = 0; point < grid->GetNumberOfPoints(); ++point)
  {
    grid->GetPointData()->GetScalars()->SetComponent(point, 0, double(point * 37 % 101));
    if (point % 11 == 0)
    {
      grid->BlankPoint(point);
    }
  }
  MapperScene scene(grid, 48);
  scene.volume->GetProperty()->SetInterpolationTypeToNearest();
  scene.mapper->SetBlendModeToIsoSurface();
  scene.volume->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 50.0);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 0.3);
  EXPECT_LT(scene.Error().percentile999, 1.0) << "of 255";
}

TEST(Blanking, NormalsBesideABlankedCellAreThoseOfTheData)
{
  // A ramp along z has the same normal everywhere, towards the eye.
  const auto grid = Grid(false);
  for (int i = 0; i < 9 * 81; ++i)
  {
    grid->GetPointData()->GetScalars()->SetComponent(i, 0, 20.0 * (i / 81));
  }
  grid->BlankCell(CellAt(4, 4, 7)); // on the visible face
  BlankedScene scene(grid);
  scene.opacities->RemoveAllPoints();
  scene.opacities->AddPoint(0.0, 1.0);
  scene.colors->RemoveAllPoints();
  scene.colors->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  vtkVolumeProperty* const property = scene.volume->GetProperty();
  property->ShadeOn();
  property->SetAmbient(0.0);
  property->SetDiffuse(0.8);
  property->SetSpecular(0.0);
  const std::vector<float> drawn = scene.Draw();
  EXPECT_NEAR(drawn[4 * (8 * 16 + 8)], 0.8, 1e-3) << "the voxel behind the cell";
  EXPECT_NEAR(drawn[4 * (8 * 16 + 7)], 0.8, 1e-3) << "beside it";
}
