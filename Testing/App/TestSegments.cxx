#include "Scene/Segments/Segments.h"

#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkNew.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

using namespace varimarch;

namespace
{

vtkSmartPointer<vtkImageData> Image(const std::vector<double>& values, int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(int(values.size()), 1, 1);
  image->AllocateScalars(type, 1);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    image->SetScalarComponentFromDouble(int(i), 0, 0, 0, values[i]);
  }
  return image;
}

std::vector<int> ValuesOf(const std::vector<Segment>& segments)
{
  std::vector<int> values;
  for (const Segment& segment : segments)
  {
    values.push_back(segment.value);
  }
  return values;
}

std::string ErrorOf(vtkImageData* image)
{
  try
  {
    std::vector<std::string> warnings;
    SegmentsOf(image, {}, warnings);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

}

TEST(Segments, AreThoseThatAreKnownAndThenTheOtherValues)
{
  const auto image = Image({ 0, 7, 2035, 0, -4, 7 }, VTK_INT);
  std::vector<std::string> warnings;
  const auto segments =
    SegmentsOf(image, { { 9, "spleen", glm::dvec3(0.5) }, { 7, "liver", {} } }, warnings);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(ValuesOf(segments), (std::vector<int>{ 9, 7, -4, 2035 }));
  EXPECT_EQ(segments[1].name, "liver");
  EXPECT_EQ(segments[3].name, "Label 2035");
  EXPECT_NE(segments[2].rgb, segments[3].rgb);
  const auto numbers = SegmentNumbers(image, segments);
  const auto* const voxels = static_cast<const unsigned char*>(numbers->GetScalarPointer());
  EXPECT_EQ(std::vector<int>(voxels, voxels + 6), (std::vector<int>{ 0, 2, 4, 0, 3, 2 }));
}

TEST(Segments, OfRealNumbersAreWholeOnes)
{
  std::vector<std::string> warnings;
  EXPECT_EQ(ValuesOf(SegmentsOf(Image({ 0, 3, 1e6 }, VTK_FLOAT), {}, warnings)),
    (std::vector<int>{ 3, 1000000 }));
  EXPECT_EQ(ErrorOf(Image({ 0, 0.5 }, VTK_FLOAT)), "expected whole numbers as labels, found 0.5");
  EXPECT_EQ(
    ErrorOf(Image({ 0, 1e12 }, VTK_DOUBLE)), "expected whole numbers as labels, found 1e+12");
  EXPECT_EQ(ErrorOf(Image({ 0, NAN }, VTK_FLOAT)), "expected whole numbers as labels, found nan");
}

TEST(Segments, TheSmallestOfMoreThanMasksCanTellApartShareOne)
{
  std::vector<double> values;
  for (int label = 1; label <= MostSegments; ++label)
  {
    values.push_back(20 * label); // sparse numbers
    values.push_back(20 * label);
  }
  std::vector<std::string> warnings;
  EXPECT_EQ(SegmentsOf(Image(values, VTK_INT), {}, warnings).size(), std::size_t(MostSegments));
  EXPECT_TRUE(warnings.empty());
  values.push_back(7);
  values.push_back(8);
  values.push_back(9);
  const auto image = Image(values, VTK_INT);
  const std::vector<Segment> segments = SegmentsOf(image, {}, warnings);
  ASSERT_EQ(segments.size(), std::size_t(MostSegments));
  EXPECT_EQ(segments.back().name, "4 small segments");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("257 segments"), std::string::npos) << warnings[0];
  const auto numbers = SegmentNumbers(image, segments);
  const auto* const voxels = static_cast<const unsigned char*>(numbers->GetScalarPointer());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const std::size_t label = std::size_t(values[i]) / 20;
    EXPECT_EQ(voxels[i], label > 0 && label < std::size_t(MostSegments) ? label : MostSegments);
  }
}

TEST(Segments, OfAScanAreTooMany)
{
  std::vector<double> values;
  for (int value = 0; value <= MostLabels; ++value)
  {
    values.push_back(value);
  }
  EXPECT_EQ(ErrorOf(Image(values, VTK_SHORT)), "");
  values.push_back(-1);
  EXPECT_EQ(
    ErrorOf(Image(values, VTK_SHORT)), "expected at most 2000 different labels, found more");
}

// A box has the mean chord 3 abc / (ab + bc + ca) along its axes, weighted by their shadows.
TEST(Segments, HaveTheSizeOfTheirBox)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(9, 10, 11);
  image->SetSpacing(1.0, 2.0, 0.5);
  image->SetDirectionMatrix(0, 0.6, 0.8, -1, 0, 0, 0, 0.8, -0.6);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const vtkIdType x = i % 9;
    const vtkIdType y = i / 9 % 10;
    const vtkIdType z = i / 90;
    const bool isInBox = x < 4 && y >= 2 && y < 8 && z >= 3;
    static_cast<unsigned char*>(image->GetScalarPointer())[i] = isInBox ? 2 : x == 6 ? 1 : 0;
  }
  const std::vector<SegmentSize> sizes = SizesOf(image, 3);
  EXPECT_EQ(sizes[1].voxels, 4 * 6 * 8);
  EXPECT_NEAR(sizes[1].volumeMl, 4 * 12 * 4 * 1e-3, 1e-12);
  EXPECT_NEAR(sizes[1].thicknessMm, 3.0 * 4 * 12 * 4 / (4 * 12 + 12 * 4 + 4 * 4), 1e-9);
  EXPECT_EQ(sizes[0].voxels, 110);
  EXPECT_EQ(sizes[2].voxels, 0);
  EXPECT_EQ(sizes[2].thicknessMm, 0.0);
}

namespace
{

/// A colour as CIELab, as a dichromat sees it.
/// @param seen  rows of a matrix for linear RGB
glm::dvec3 LabSeen(const glm::dvec3& rgb, const std::array<glm::dvec3, 3>& seen)
{
  glm::dvec3 linear;
  for (int i = 0; i < 3; ++i)
  {
    linear[i] = rgb[i] <= 0.04045 ? rgb[i] / 12.92 : std::pow((rgb[i] + 0.055) / 1.055, 2.4);
  }
  glm::dvec3 coded;
  for (int i = 0; i < 3; ++i)
  {
    const double part = std::clamp(glm::dot(seen[std::size_t(i)], linear), 0.0, 1.0);
    coded[i] = part <= 0.0031308 ? 12.92 * part : 1.055 * std::pow(part, 1.0 / 2.4) - 0.055;
  }
  glm::dvec3 lab;
  vtkMath::RGBToLab(&coded.x, &lab.x);
  return lab;
}

}

// The matrices for missing red and green are those of F. Viénot, H. Brettel and J. Mollon, Color
// Research and Application 24, 1999, 243-252; that for missing blue is of G. Machado, M. Oliveira
// and L. Fernandes, IEEE Transactions on Visualization and Computer Graphics 15, 2009, 1291-1298.
TEST(Segments, HaveFirstColoursThatEveryKindOfColourVisionTellsApart)
{
  const std::array<glm::dvec3, 3> usual = { { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } };
  const std::array<glm::dvec3, 3> protan = { { { 0.11238, 0.88762, 0.0 }, { 0.11238, 0.88762, 0.0 },
    { 0.00401, -0.00401, 1.0 } } };
  const std::array<glm::dvec3, 3> deutan = { { { 0.29275, 0.70725, 0.0 }, { 0.29275, 0.70725, 0.0 },
    { -0.02234, 0.02234, 1.0 } } };
  const std::array<glm::dvec3, 3> tritan = { { { 1.255528, -0.076749, -0.178779 },
    { -0.078411, 0.930809, 0.147602 }, { 0.004733, 0.691367, 0.303900 } } };
  for (const auto& seen : { usual, protan, deutan, tritan })
  {
    for (int a = 1; a <= 7; ++a)
    {
      for (int b = 1; b < a; ++b)
      {
        // Two colours that differ by 2.3 can just be told apart side by side.
        EXPECT_GT(
          glm::distance(LabSeen(ColorOfLabel(a), seen), LabSeen(ColorOfLabel(b), seen)), 15.0)
          << a << " and " << b;
      }
    }
  }
  EXPECT_NE(ColorOfLabel(8), ColorOfLabel(9));
}
