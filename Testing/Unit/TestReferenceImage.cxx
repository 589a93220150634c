#include "Core/Reference/ReferenceIntegrator.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <stdexcept>

using namespace varimarch;

namespace
{

/// A block of 11 x 11 x 11 voxels that transmits half of the light per 10 mm.
class ReferenceImageOfABlock : public testing::Test
{
protected:
  /// @param nearPlane  distance from an eye 20 voxels in front of the block, in voxels
  ReferenceView View(double nearPlane) const
  {
    const glm::dmat4 clipFromEye = glm::ortho(-10.0, 10.0, -10.0, 10.0, nearPlane, 100.0);
    const glm::dmat4 eyeFromGrid =
      glm::lookAt(glm::dvec3(5.0, 5.0, 30.0), glm::dvec3(5.0), glm::dvec3(0.0, 1.0, 0.0));
    return { ComputePixelRays(clipFromEye * eyeFromGrid, this->box), glm::dmat3(2.0), 40, 20 };
  }

  float Alpha(const ReferenceImage& image, int column, int row) const
  {
    return image.rgba[4 * (std::size_t(row) * image.width + column) + 3];
  }

  std::vector<float> voxels = std::vector<float>(1331, 1.0f);
  ScalarGrid<float> grid{ voxels.data(), glm::ivec3(11) };
  Box box{ glm::dvec3(0.0), glm::dvec3(10.0) };
  ReferenceIntegrator integrator{ ReferenceScene{ [this](glm::ivec3 cell)
    { return CornersOfCell(this->grid, cell); },
    this->box, TransferFunction({}, { { 0.0, 0.5 } }, 10.0) } };
};

}

TEST_F(ReferenceImageOfABlock, HasItsDepthInTheWorldAndItsSilhouette)
{
  const ReferenceImage image = DrawReference(this->integrator, this->View(1.0)).value();
  EXPECT_FLOAT_EQ(this->Alpha(image, 20, 10), 0.75f);
  EXPECT_FLOAT_EQ(this->Alpha(image, 10, 5), 0.75f);
  EXPECT_EQ(this->Alpha(image, 9, 10), 0.0f);
  EXPECT_EQ(this->Alpha(image, 20, 4), 0.0f);
  EXPECT_LT(image.largestError, 1e-9);
}

TEST_F(ReferenceImageOfABlock, IsCutByTheNearPlane)
{
  const ReferenceImage image = DrawReference(this->integrator, this->View(25.0)).value();
  EXPECT_FLOAT_EQ(this->Alpha(image, 20, 10), 0.5f);
}

TEST_F(ReferenceImageOfABlock, RowZeroIsTheLowest)
{
  for (int i = 0; i < 1331; ++i)
  {
    this->voxels[i] = i / 11 % 11 < 5 ? 1.0f : std::nanf("");
  }
  const ReferenceImage image = DrawReference(this->integrator, this->View(1.0)).value();
  EXPECT_GT(this->Alpha(image, 20, 6), 0.5f);
  EXPECT_EQ(this->Alpha(image, 20, 13), 0.0f);
}

TEST_F(ReferenceImageOfABlock, ReportsProgressUntilItIsDone)
{
  double last = 0.0;
  const auto image = DrawReference(this->integrator, this->View(1.0),
    [&](double part)
    {
      EXPECT_GT(part, last);
      last = part;
      return true;
    });
  EXPECT_TRUE(image.has_value());
  EXPECT_EQ(last, 1.0);
}

TEST_F(ReferenceImageOfABlock, CanBeGivenUp)
{
  int calls = 0;
  const auto image = DrawReference(this->integrator, this->View(1.0),
    [&](double)
    {
      ++calls;
      return false;
    });
  EXPECT_FALSE(image.has_value());
  EXPECT_EQ(calls, 1);
}

TEST_F(ReferenceImageOfABlock, WithoutPixelsIsRefused)
{
  ReferenceView view = this->View(1.0);
  view.width = 0;
  EXPECT_THROW(DrawReference(this->integrator, view), std::invalid_argument);
}
