// Matter whose values do not change over two voxels has no gradient, and so no lit surface: where
// it shines, a difference is the rounding of places or weights.

#include "Module/Scenes/MapperScene.h"

#include <vtkCamera.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkVolumeProperty.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace varimarch;

namespace
{

constexpr int Side = 8;
constexpr float Ambient = 0.25f;

using Values = std::function<float(int x, int y)>;

vtkSmartPointer<vtkImageData> Columns(const Values& values)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  vtkNew<vtkFloatArray> scalars;
  for (int i = 0; i < Side * Side * Side; ++i)
  {
    scalars->InsertNextValue(values(i % Side, i / Side % Side));
  }
  image->GetPointData()->SetScalars(scalars);
  return image;
}

// Columns of voxels along the view, seen at least a voxel from their sides.
class ColumnsScene : public MapperScene
{
public:
  explicit ColumnsScene(const Values& values)
    : MapperScene(Columns(values), 48)
  {
    this->opacities->RemoveAllPoints();
    this->opacities->AddPoint(0.1, 0.05);
    this->opacities->AddPoint(0.9, 0.6);
    this->LookDown({ 3.47, 3.53, 3.5 }, 1.9);
    this->renderer->GetActiveCamera()->Roll(17.0);
  }

  // The largest difference between the lit image and the ambient part of the one without light.
  float MostShine(WayToDraw draw)
  {
    vtkVolumeProperty* const property = this->volume->GetProperty();
    property->ShadeOff();
    const std::vector<float> plain = (this->*draw)();
    property->ShadeOn();
    property->SetAmbient(Ambient);
    property->SetDiffuse(1.0);
    property->SetSpecular(0.0);
    const std::vector<float> lit = (this->*draw)();
    float most = 0.0f;
    for (std::size_t i = 0; i < plain.size(); ++i)
    {
      const float expected = (i % 4 == 3 ? 1.0f : Ambient) * plain[i];
      most = std::max(most, std::abs(lit[i] - expected));
    }
    return most;
  }
};

}

TEST(EvenMatter, HasNoSurface)
{
  for (const WayToDraw draw : WaysToDraw())
  {
    ColumnsScene even([](int, int) { return 0.3f; });
    EXPECT_LT(even.MostShine(draw), 2.0f);
  }
}

TEST(EvenMatter, HasNoSurfaceOnASpline)
{
  ColumnsScene even([](int, int) { return 0.3f; });
  even.mapper->CubicInterpolationOn();
  EXPECT_LT(even.MostShine(&MapperScene::DrawByProcessor), 2.0f);
}

TEST(EvenMatter, HasNoSurfaceIfEverySecondVoxelIsTheSame)
{
  ColumnsScene columns([](int x, int y) { return (x + y) % 2 == 0 ? 0.37f : 0.81f; });
  EXPECT_LT(columns.MostShine(&MapperScene::DrawByProcessor), 2.0f);
}
