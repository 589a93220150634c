#include "Scene/Images/DifferencePicture.h"

#include <gtest/gtest.h>

#include <array>

using namespace varimarch;

namespace
{

constexpr int Width = 320;

vtkSmartPointer<vtkImageData> FloatPicture(float value)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(Width, 2, 1);
  picture->AllocateScalars(VTK_FLOAT, 4);
  auto* channel = static_cast<float*>(picture->GetScalarPointer());
  std::fill(channel, channel + 4 * picture->GetNumberOfPoints(), value);
  return picture;
}

std::array<double, 3> PixelOf(vtkImageData* picture, int x, int y)
{
  return { picture->GetScalarComponentAsDouble(x, y, 0, 0),
    picture->GetScalarComponentAsDouble(x, y, 0, 1),
    picture->GetScalarComponentAsDouble(x, y, 0, 2) };
}

TEST(DifferencePicture, ScaleRunsFromATenthToAHundred)
{
  const auto truth = FloatPicture(0.5f);
  const auto same = FloatPicture(0.5f);
  const auto far = FloatPicture(0.5f);
  // A difference in one channel alone must be visible.
  far->SetScalarComponentFromDouble(3, 1, 0, 3, 0.5 + 100.5 / 255.0);
  EXPECT_EQ(PixelOf(DifferencePicture(same, truth), 3, 1), (std::array<double, 3>{ 0, 34, 78 }));
  EXPECT_EQ(PixelOf(DifferencePicture(far, truth), 3, 1), (std::array<double, 3>{ 254, 232, 56 }));
  EXPECT_EQ(PixelOf(DifferencePicture(far, truth), 2, 1), (std::array<double, 3>{ 0, 34, 78 }));
}

TEST(DifferencePicture, GetsALabelledScale)
{
  const auto truth = FloatPicture(0.0f);
  const auto labelled = WithDifferenceScale(DifferencePicture(truth, truth));
  EXPECT_EQ(labelled->GetDimensions()[1], 2 + DifferenceScaleHeight);
  // Text makes dark pixels at the bottom, which is otherwise white.
  int dark = 0;
  for (int x = 0; x < Width; ++x)
  {
    for (int y = 0; y < 20; ++y)
    {
      dark += labelled->GetScalarComponentAsDouble(x, y, 0, 0) < 128.0;
    }
  }
  EXPECT_GT(dark, 50);
}

TEST(ComparisonSheet, HoldsEveryPictureWhole)
{
  const auto truth = FloatPicture(0.0f);
  const auto difference = DifferencePicture(truth, truth);
  const auto sheet =
    ComparisonSheet({ { "a", "", difference, nullptr }, { "b", "", difference, difference } });
  int pixels = 0;
  for (int y = 0; y < sheet->GetDimensions()[1]; ++y)
  {
    for (int x = 0; x < sheet->GetDimensions()[0]; ++x)
    {
      pixels += PixelOf(sheet, x, y) == std::array<double, 3>{ 0, 34, 78 };
    }
  }
  EXPECT_GE(pixels, 3 * 2 * Width);
}

}
