// A single image is seen in its own plane, however it lies in the patient.

#include "Scene/Slices/SlicePicture.h"

#include <vtkImageData.h>
#include <vtkNew.h>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace varimarch;

namespace
{

constexpr int ImageSide = 40;

// An image of 40 x 40 pixels of 1 mm around the world's origin, all 100.
vtkSmartPointer<vtkImageData> ImageWithAxes(const glm::dmat3& axes)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(ImageSide, ImageSide, 1);
  const glm::dvec3 origin = -0.5 * (ImageSide - 1) * (axes[0] + axes[1]);
  image->SetOrigin(origin.x, origin.y, origin.z);
  const glm::dmat3 rows = glm::transpose(axes);
  image->SetDirectionMatrix(&rows[0][0]);
  image->AllocateScalars(VTK_SHORT, 1);
  std::fill_n(static_cast<short*>(image->GetScalarPointer()), ImageSide * ImageSide, short(100));
  return image;
}

// The part of a view of 26 x 26 mm in which the image is seen.
double PartSeen(vtkImageData* image, const SingleImage& single)
{
  SliceRequest request = { single.plane, { 0.0, 0.0, 0.0 }, 1.0, 26, 26, 100.0, 50.0, 0.0 };
  request.turn = single.turn;
  const auto pixels = SlicePicture(image, request);
  return double(std::count(pixels.begin(), pixels.end(), 255)) / double(pixels.size());
}

}

TEST(SingleImage, IsSeenInItsOwnPlane)
{
  const glm::dmat3 straight(1.0);
  const glm::dmat3 coronal(1, 0, 0, 0, 0, -1, 0, 1, 0);
  const glm::dmat3 sagittal(0, 1, 0, 0, 0, -1, -1, 0, 0);
  const glm::dmat3 oblique(
    glm::rotate(glm::dmat4(1.0), glm::radians(35.0), glm::normalize(glm::dvec3(1.0, 2.0, 0.5))));
  for (const glm::dmat3& first : { straight, coronal, sagittal })
  {
    for (const glm::dmat3& axes : { first, oblique * first })
    {
      const auto image = ImageWithAxes(axes);
      const auto single = SingleImageOf(image);
      ASSERT_TRUE(single);
      const auto through = AxesOf(single->plane, single->turn).through;
      EXPECT_NEAR(
        std::abs(glm::dot(glm::dvec3(through[0], through[1], through[2]), axes[2])), 1.0, 1e-9);
      EXPECT_EQ(PartSeen(image, *single), 1.0);
    }
    EXPECT_EQ(SingleImageOf(ImageWithAxes(first))->turn, SliceTurn());
  }
  EXPECT_EQ(SingleImageOf(ImageWithAxes(coronal))->plane, SlicePlane::Coronal);
  EXPECT_EQ(SingleImageOf(ImageWithAxes(sagittal))->plane, SlicePlane::Sagittal);
}

TEST(SingleImage, IsNoVolumeAndNoLine)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 2);
  EXPECT_FALSE(SingleImageOf(image));
  image->SetDimensions(4, 1, 1);
  EXPECT_FALSE(SingleImageOf(image));
  image->SetDimensions(1, 4, 4);
  EXPECT_EQ(SingleImageOf(image)->plane, SlicePlane::Sagittal);
}
