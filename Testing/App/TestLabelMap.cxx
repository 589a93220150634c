#include "Scene/Segments/LabelMap.h"

#include <vtkMatrix3x3.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

using namespace varimarch;

namespace
{

using Labels = std::function<int(int x, int y, int z)>;

vtkSmartPointer<vtkImageData> Image(const std::array<int, 3>& size, const Labels& labelAt)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size.data());
  image->AllocateScalars(VTK_SHORT, 1);
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        image->SetScalarComponentFromDouble(x, y, z, 0, labelAt(x, y, z));
      }
    }
  }
  return image;
}

LoadedVolume VolumeOf(vtkImageData* image)
{
  LoadedVolume volume;
  volume.image = image;
  return volume;
}

// A scan of 12 x 10 x 8 voxels at an oblique angle.
LoadedVolume PlainScan()
{
  const auto image = Image({ 12, 10, 8 }, [](int x, int, int) { return x; });
  image->SetOrigin(5.0, -7.0, 11.0);
  image->SetSpacing(1.0, 1.5, 2.0);
  image->SetDirectionMatrix(0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, -1.0);
  return VolumeOf(image);
}

int NumberAt(const LabelMap& map, int x, int y, int z)
{
  return int(map.image->GetScalarComponentAsDouble(x, y, z, 0));
}

std::string ErrorOf(const LoadedVolume& labels, const LoadedVolume& scan)
{
  try
  {
    LabelMapOf(labels, "seg.nrrd", scan);
  }
  catch (const std::runtime_error& error)
  {
    return error.what();
  }
  return "";
}

std::string Joined(const std::vector<std::string>& warnings)
{
  std::string all;
  for (const std::string& warning : warnings)
  {
    all += warning + "\n";
  }
  return all;
}

}

TEST(LabelMap, IsOnTheGridOfTheScanWhateverFilesRound)
{
  const LoadedVolume scan = PlainScan();
  const auto labels = vtkSmartPointer<vtkImageData>::New();
  labels->CopyStructure(scan.image);
  EXPECT_TRUE(AreOnGridOf(labels, scan.image));
  labels->SetOrigin(5.0001, -7.0, 11.0);
  EXPECT_TRUE(AreOnGridOf(labels, scan.image));
  labels->SetOrigin(5.5, -7.0, 11.0);
  EXPECT_FALSE(AreOnGridOf(labels, scan.image));
  labels->CopyStructure(scan.image);
  labels->SetSpacing(1.0, 1.5, 2.1);
  EXPECT_FALSE(AreOnGridOf(labels, scan.image));
  labels->CopyStructure(scan.image);
  labels->SetDirectionMatrix(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
  EXPECT_FALSE(AreOnGridOf(labels, scan.image));
  labels->CopyStructure(scan.image);
  labels->SetDimensions(12, 10, 7);
  EXPECT_FALSE(AreOnGridOf(labels, scan.image));
}

TEST(LabelMap, OnTheGridOfTheScanKeepsEveryVoxel)
{
  const LoadedVolume scan = PlainScan();
  const auto image = Image({ 12, 10, 8 }, [](int x, int y, int z) { return (x + 2 * y + z) % 4; });
  image->SetOrigin(scan.image->GetOrigin());
  image->SetSpacing(scan.image->GetSpacing());
  image->SetDirectionMatrix(scan.image->GetDirectionMatrix());
  const LabelMap map = LabelMapOf(VolumeOf(image), "seg.nrrd", scan);
  ASSERT_EQ(map.segments.size(), 3);
  for (int z = 0; z < 8; ++z)
  {
    for (int y = 0; y < 10; ++y)
    {
      for (int x = 0; x < 12; ++x)
      {
        ASSERT_EQ(NumberAt(map, x, y, z), (x + 2 * y + z) % 4) << x << " " << y << " " << z;
      }
    }
  }
  EXPECT_EQ(map.image->GetScalarType(), VTK_UNSIGNED_CHAR);
  EXPECT_TRUE(map.warnings.empty()) << Joined(map.warnings);
}

// For every voxel of the scan, the voxel of the labels is found by hand: the positions are those of
// the images' own definition, origin + direction * spacing * index.
TEST(LabelMap, OnAnotherGridTakesTheNearestVoxel)
{
  const LoadedVolume scan = PlainScan();
  const auto labelAt = [](int x, int y, int z) { return 1 + (x + 3 * y + 5 * z) % 7; };
  const auto image = Image({ 30, 28, 26 }, labelAt);
  image->SetOrigin(-12.0, -15.0, -12.0);
  image->SetSpacing(1.3, 0.9, 1.1);
  image->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, 1);
  const LabelMap map = LabelMapOf(VolumeOf(image), "seg.nrrd", scan);
  int inside = 0;
  for (int z = 0; z < 8; ++z)
  {
    for (int y = 0; y < 10; ++y)
    {
      for (int x = 0; x < 12; ++x)
      {
        const double i[3] = { 1.0 * x, 1.5 * y, 2.0 * z };
        const double placeMm[3] = { 5.0 + 0.6 * i[0] - 0.8 * i[1], -7.0 + 0.8 * i[0] + 0.6 * i[1],
          11.0 - i[2] };
        const int nearest[3] = { int(std::lround((placeMm[0] + 12.0) / 1.3)),
          int(std::lround((placeMm[1] + 15.0) / 0.9)),
          int(std::lround((placeMm[2] + 12.0) / 1.1)) };
        const bool isInside = nearest[0] >= 0 && nearest[0] < 30 && nearest[1] >= 0 &&
          nearest[1] < 28 && nearest[2] >= 0 && nearest[2] < 26;
        inside += isInside ? 1 : 0;
        const int expected = isInside ? labelAt(nearest[0], nearest[1], nearest[2]) : 0;
        const int number = NumberAt(map, x, y, z);
        ASSERT_EQ(number == 0 ? 0 : map.segments[std::size_t(number - 1)].value, expected);
      }
    }
  }
  EXPECT_GT(inside, 500);
}

TEST(LabelMap, OfAPartOfTheScanIsEmptyElsewhere)
{
  const LoadedVolume scan = PlainScan();
  const auto image = Image({ 3, 2, 2 }, [](int, int, int) { return 4; });
  double placeMm[3];
  scan.image->TransformIndexToPhysicalPoint(5, 6, 3, placeMm);
  image->SetOrigin(placeMm);
  image->SetSpacing(scan.image->GetSpacing());
  image->SetDirectionMatrix(scan.image->GetDirectionMatrix());
  const LabelMap map = LabelMapOf(VolumeOf(image), "seg.nrrd", scan);
  EXPECT_EQ(map.sizes[0].voxels, 12);
  EXPECT_EQ(NumberAt(map, 5, 6, 3), 1);
  EXPECT_EQ(NumberAt(map, 7, 7, 4), 1);
  EXPECT_EQ(NumberAt(map, 4, 6, 3), 0);
  EXPECT_EQ(NumberAt(map, 8, 7, 4), 0);
  EXPECT_TRUE(map.warnings.empty()) << Joined(map.warnings);
}

TEST(LabelMap, SaysWhatLiesOutsideTheScan)
{
  const LoadedVolume scan = PlainScan();
  const auto image =
    Image({ 12, 10, 8 }, [](int x, int, int) { return x < 6 ? 1
                                                 : x == 11  ? 2
                                                            : 0; });
  double placeMm[3];
  scan.image->TransformIndexToPhysicalPoint(3, 0, 0, placeMm);
  image->SetOrigin(placeMm);
  image->SetSpacing(scan.image->GetSpacing());
  image->SetDirectionMatrix(scan.image->GetDirectionMatrix());
  const LabelMap map = LabelMapOf(VolumeOf(image), "seg.nrrd", scan);
  const std::string warnings = Joined(map.warnings);
  EXPECT_NE(warnings.find("Label 2."), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("Only 86 %"), std::string::npos) << warnings; // 6 of 7 layers
}

TEST(LabelMap, OfAnotherPlaceIsRefused)
{
  const LoadedVolume scan = PlainScan();
  const auto image = Image({ 4, 4, 4 }, [](int, int, int) { return 1; });
  image->SetOrigin(500.0, 0.0, 0.0);
  const std::string error = ErrorOf(VolumeOf(image), scan);
  EXPECT_EQ(error.rfind("Cannot draw the labels of seg.nrrd over the scan: expected labels within "
                        "the scan, at x ",
              0),
    0u)
    << error;
  EXPECT_NE(
    error.find("found labels within x 500 to 503, y 0 to 3, z 0 to 3 mm"), std::string::npos)
    << error;
}

TEST(LabelMap, OfAnotherFrameOfReferenceIsRefused)
{
  LoadedVolume scan = PlainScan();
  LoadedVolume labels = PlainScan();
  scan.frameOfReference = "1.2.3";
  EXPECT_EQ(ErrorOf(labels, scan), ""); // unknown
  labels.frameOfReference = "1.2.4";
  EXPECT_EQ(ErrorOf(labels, scan),
    "Cannot draw the labels of seg.nrrd over the scan: expected the scan's frame of reference "
    "1.2.3, found 1.2.4; choose the scan that the labels were drawn on.");
  labels.frameOfReference = "1.2.3";
  EXPECT_EQ(ErrorOf(labels, scan), "");
}

TEST(LabelMap, OfValuesThatAreNoLabelsIsRefused)
{
  LoadedVolume labels = PlainScan();
  vtkNew<vtkImageData> reals;
  reals->CopyStructure(labels.image);
  reals->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < reals->GetNumberOfPoints(); ++i)
  {
    static_cast<float*>(reals->GetScalarPointer())[i] = 0.25f;
  }
  labels.image = reals;
  EXPECT_EQ(ErrorOf(labels, PlainScan()),
    "Cannot draw the labels of seg.nrrd over the scan: expected whole numbers as labels, found "
    "0.25.");
}
