// Mixtures of two components with light and gradient opacity, compared with the reference.

#include "Frame/VolumeGeometry.h"
#include "Module/Scenes/ComponentVolumes.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

struct MixtureLook
{
  bool shaded;
  bool gradientOpacity;
};

namespace
{

const glm::ivec3 size(17, 17, 17);
const glm::dvec3 spacing(1.0, 1.5, 0.8);
const double weights[] = { 1.0, 0.7 };
const double speculars[] = { 0.2, 0.5 };

// The second component's opacity is multiplied by 0.2 where it is flat, and by 1 from this gradient
// on.
constexpr double SteepGradient = 15.0;

class BallScene
{
public:
  explicit BallScene(MixtureLook look)
    : look(look)
    , scene(Balls(), 48)
    , geometry(VolumeGeometryOf(this->scene.image, this->scene.volume))
  {
    vtkVolumeProperty* property = this->scene.volume->GetProperty();
    property->SetShade(look.shaded);
    for (int component = 0; component < 2; ++component)
    {
      SetLook(property, component, looks[component]);
      property->SetSpecular(component, speculars[component]);
      property->SetComponentWeight(component, weights[component]);
    }
    vtkNew<vtkPiecewiseFunction> factors;
    factors->AddPoint(0.0, 0.2);
    factors->AddPoint(SteepGradient, 1.0);
    if (look.gradientOpacity)
    {
      property->SetGradientOpacity(1, factors);
    }
    const auto* interleaved = static_cast<const short*>(this->scene.image->GetScalarPointer());
    for (int i = 0; i < 2 * size.x * size.y * size.z; ++i)
    {
      this->voxels[i % 2].push_back(interleaved[i]);
    }
  }

  OpticalProperties MaterialAt(glm::dvec3 position, const Ray& rayGrid) const
  {
    glm::dvec3 emission(0.0);
    double extinction = 0.0;
    for (int component = 0; component < 2; ++component)
    {
      const ScalarGrid<short> grid(this->voxels[component].data(), size);
      const glm::dvec3 gradient = grid.Gradient(position);
      const double opacity = OpacityOf(looks[component], grid.Value(position));
      const double absorbed =
        weights[component] * -std::log1p(-this->Factor(component, gradient) * opacity);
      emission += absorbed * this->Emitted(component, gradient, rayGrid);
      extinction += absorbed;
    }
    return { extinction > 0.0 ? emission / extinction : emission, extinction };
  }

  MixtureLook look;
  MapperScene scene;
  VolumeGeometry geometry;

private:
  static vtkSmartPointer<vtkImageData> Balls()
  {
    const auto image = ImageOf(VTK_SHORT, 2, BallValue, size);
    image->SetSpacing(spacing.x, spacing.y, spacing.z);
    return image;
  }

  double Factor(int component, glm::dvec3 gradient) const
  {
    const double mean = (spacing.x + spacing.y + spacing.z) / 3.0;
    const double magnitude = mean * glm::length(gradient / spacing);
    const double part = std::min(magnitude, SteepGradient) / SteepGradient;
    return this->look.gradientOpacity && component == 1 ? 0.2 + 0.8 * part : 1.0;
  }

  glm::dvec3 Emitted(int component, glm::dvec3 gradient, const Ray& rayGrid) const
  {
    const glm::dvec3 color = looks[component].color;
    const glm::dvec3 normal = this->geometry.WorldFromGridNormal() * gradient;
    const glm::dvec3 toEye = this->geometry.WorldFromGridDirection() * rayGrid.direction;
    const double facing = std::abs(glm::dot(glm::normalize(normal), glm::normalize(toEye)));
    return this->look.shaded
      ? color * (0.1 + 0.7 * facing) + speculars[component] * std::pow(facing, 10.0)
      : color;
  }

  std::vector<short> voxels[2];
};

}

class MixtureOfBalls : public testing::TestWithParam<MixtureLook>
{
};

TEST_P(MixtureOfBalls, IsThatOfTheReference)
{
  BallScene balls(GetParam());
  const ImageError error = balls.scene.ErrorOf(
    [&](glm::dvec3 position, const Ray& rayGrid) { return balls.MaterialAt(position, rayGrid); });
  EXPECT_LT(error.rootMeanSquare, 0.5);
  EXPECT_LT(error.largest, 8.0);
  const std::vector<float> drawn = balls.scene.Draw();
  EXPECT_GT(*std::max_element(drawn.begin(), drawn.end()), 0.5) << "the image is empty";

  // The field leaves out what is invisible in both components, and nothing else.
  balls.scene.mapper->SetAccelerationModeToOff();
  const std::vector<float> withoutField = balls.scene.Draw();
  EXPECT_LT(CompareImages(drawn.data(), withoutField.data(), 48 * 48).largest, 3.0);
}

INSTANTIATE_TEST_SUITE_P(ShadedOrNot, MixtureOfBalls,
  testing::Values(
    MixtureLook{ false, false }, MixtureLook{ true, false }, MixtureLook{ true, true }));
