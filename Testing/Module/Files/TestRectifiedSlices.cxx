// Tilted, uneven or missing slices resampled on an even grid: each voxel is compared with the
// function of space that was scanned.
#include "PhantomFiles.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace
{

// The scanned function rises evenly, by at most 2 per voxel; stored values are multiples of 0.01.
// The error allows for their rounding and for a thousandth of a voxel in the position.
constexpr double StoredUnit = 0.01;
constexpr double LargestError = 0.5 * StoredUnit + 2e-3;

double ScannedAt(const glm::dvec3& worldMm)
{
  return glm::dot(glm::dvec3(0.9, 1.1, 0.7), worldMm) - 20.0;
}

/// A scan of slices with 13 x 10 voxels.
struct Scan
{
  /// @param axesMm   column 2 is the direction along which the slices lie
  /// @param heights  positions of the slices, in lengths of that direction
  Scan(const glm::dmat3& axesMm, const std::vector<double>& heights)
    : axesMm(axesMm)
    , normal(glm::normalize(glm::cross(axesMm[0], axesMm[1])))
  {
    for (const double height : heights)
    {
      this->positionsMm.push_back(glm::dvec3(-4.0, 3.0, 11.0) + axesMm[2] * height);
    }
  }

  void Write(const TemporaryFolder& folder) const
  {
    for (std::size_t slice = 0; slice < this->positionsMm.size(); ++slice)
    {
      StoredVolume stored;
      stored.dimensions = { this->size.x, this->size.y, 1 };
      stored.axesMm = this->axesMm;
      for (int i = 0; i < this->size.x * this->size.y; ++i)
      {
        const glm::dvec3 index(i % this->size.x, i / this->size.x, 0);
        stored.values.push_back(
          std::round(ScannedAt(this->positionsMm[slice] + this->axesMm * index) / StoredUnit));
      }
      DicomOptions options;
      options.slope = StoredUnit;
      options.instance = int(slice);
      std::ostringstream position;
      position.precision(10);
      const glm::dvec3& positionMm = this->positionsMm[slice];
      position << positionMm.x << '\\' << positionMm.y << '\\' << positionMm.z;
      options.position = position.str();
      folder.Write("scan/" + std::to_string(slice), DicomBytes(stored, 0, options));
    }
  }

  /// Depth of a position inside the slices around it, in voxels; < 0 outside.
  double DepthInSlices(const glm::dvec3& worldMm) const
  {
    constexpr double SameMm = 1e-6;
    double depth = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < this->positionsMm.size(); ++i)
    {
      const double heightMm = this->HeightMm(worldMm) - this->HeightMm(this->positionsMm[i]);
      const std::size_t next = heightMm > 0.0 ? i + 1 : i - 1;
      const bool isNeighbour = std::abs(heightMm) < SameMm ||
        (next < this->positionsMm.size() &&
          (this->HeightMm(worldMm) - this->HeightMm(this->positionsMm[next])) * heightMm <
            -SameMm * std::abs(heightMm));
      for (int axis = 0; isNeighbour && axis < 2; ++axis)
      {
        const glm::dvec3& stepMm = this->axesMm[axis];
        const double index =
          glm::dot(worldMm - this->positionsMm[i], stepMm) / glm::dot(stepMm, stepMm);
        depth = std::min({ depth, index, this->size[axis] - 1.0 - index });
      }
    }
    return depth;
  }

  double HeightMm(const glm::dvec3& worldMm) const { return glm::dot(worldMm, this->normal); }

  glm::ivec2 size = { 13, 10 };
  glm::dmat3 axesMm;
  glm::dvec3 normal;
  std::vector<glm::dvec3> positionsMm;
};

std::vector<double> Evenly(int count)
{
  std::vector<double> heights;
  for (int i = 0; i < count; ++i)
  {
    heights.push_back(i);
  }
  return heights;
}

/// The slices are tilted by 20 degrees against the motion of the table.
glm::dmat3 Tilted()
{
  const double tilt = glm::radians(20.0);
  return { glm::dvec3(0.7, 0.0, 0.0), 1.1 * glm::dvec3(0.0, std::cos(tilt), -std::sin(tilt)),
    glm::dvec3(0.0, 0.0, 2.5) };
}

glm::dmat3 Upright()
{
  return { glm::dvec3(0.7, 0.0, 0.0), glm::dvec3(0.0, 1.1, 0.0), glm::dvec3(0.0, 0.0, 2.5) };
}

glm::dvec3 PlaceOf(vtkImageData* image, int i, int j, int k)
{
  glm::dvec3 worldMm;
  image->TransformIndexToPhysicalPoint(i, j, k, &worldMm[0]);
  return worldMm;
}

void ExpectOrthonormal(vtkImageData* image)
{
  vtkNew<vtkMatrix3x3> product;
  vtkNew<vtkMatrix3x3> transposed;
  vtkMatrix3x3::Transpose(image->GetDirectionMatrix(), transposed);
  vtkMatrix3x3::Multiply3x3(transposed, image->GetDirectionMatrix(), product);
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_NEAR(product->GetData()[i], i % 4 == 0 ? 1.0 : 0.0, 1e-12);
  }
}

/// Requires that each voxel has the scanned value, or the lowest value outside the scan, and that
/// the whole scan is covered.
void ExpectTrue(const Scan& scan, vtkImageData* image)
{
  double lowest = std::numeric_limits<double>::infinity();
  for (const glm::dvec3& positionMm : scan.positionsMm)
  {
    lowest = std::min(lowest, ScannedAt(positionMm));
    for (const glm::dvec3 corner :
      { glm::dvec3(0.0), glm::dvec3(scan.size.x - 1, scan.size.y - 1, 0) })
    {
      const glm::dvec3 worldMm = positionMm + scan.axesMm * corner;
      double index[3];
      image->TransformPhysicalPointToContinuousIndex(&worldMm[0], index);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_GE(index[axis], -2e-3);
        EXPECT_LE(index[axis], image->GetDimensions()[axis] - 1 + 2e-3);
      }
    }
  }
  const int* const count = image->GetDimensions();
  for (int voxel = 0; voxel < count[0] * count[1] * count[2]; ++voxel)
  {
    const int i = voxel % count[0];
    const int j = voxel / count[0] % count[1];
    const int k = voxel / count[0] / count[1];
    const glm::dvec3 worldMm = PlaceOf(image, i, j, k);
    const double depth = scan.DepthInSlices(worldMm);
    if (std::abs(depth) > 2e-3 || depth == 0.0)
    {
      EXPECT_NEAR(image->GetScalarComponentAsDouble(i, j, k, 0),
        depth >= 0.0 ? ScannedAt(worldMm) : lowest, LargestError)
        << i << ' ' << j << ' ' << k << " lies " << depth << " voxels inside";
    }
  }
}

class RectifiedSlices : public testing::Test
{
protected:
  vtkImageData* Read(const Scan& scan, bool rectify = true)
  {
    scan.Write(this->folder);
    this->reader->SetFileName(this->folder.Path("scan").c_str());
    this->reader->SetRectifySlices(rectify);
    this->reader->Update();
    EXPECT_STREQ(this->reader->GetErrorMessage(), "");
    return this->reader->GetOutput();
  }

  bool IsTold(const std::string& words)
  {
    vtkStringArray* const warnings = this->reader->GetWarnings();
    for (vtkIdType i = 0; i < warnings->GetNumberOfValues(); ++i)
    {
      if (warnings->GetValue(i).find(words) != std::string::npos)
      {
        return true;
      }
    }
    return false;
  }

  TemporaryFolder folder;
  vtkNew<vtkVolumeFileReader> reader;
};

TEST_F(RectifiedSlices, StandUprightForATiltedGantry)
{
  const Scan scan(Tilted(), Evenly(9));
  vtkImageData* const image = this->Read(scan);
  ExpectOrthonormal(image);
  EXPECT_EQ(image->GetDimensions()[0], 13);
  // A slice is shifted by 2.5 mm * sin(20 degrees) / 1.1 mm = 0.777 voxels against the one before
  // it.
  EXPECT_EQ(image->GetDimensions()[1], 10 + int(std::ceil(8 * 0.777)));
  EXPECT_EQ(image->GetDimensions()[2], 9);
  EXPECT_NEAR(image->GetSpacing()[2], 2.5 * std::cos(glm::radians(20.0)), 1e-6);
  ExpectTrue(scan, image);
  EXPECT_TRUE(this->reader->HasIrregularSlices());
  EXPECT_TRUE(this->IsTold("tilted by 20 degrees."));
  EXPECT_TRUE(this->IsTold("resampled on an even grid"));
}

TEST_F(RectifiedSlices, StandUprightForAGantryTiltedBothWays)
{
  glm::dmat3 axesMm = Tilted();
  axesMm[2].x = -0.9;
  const Scan scan(axesMm, Evenly(6));
  vtkImageData* const image = this->Read(scan);
  ExpectOrthonormal(image);
  ExpectTrue(scan, image);
}

TEST_F(RectifiedSlices, AtUnevenDistancesLieWhereTheyWereScanned)
{
  const Scan scan(Upright(), { 0.0, 1.0, 2.0, 3.3, 4.1, 5.1, 6.6, 7.6, 8.6 });
  vtkImageData* const image = this->Read(scan);
  ExpectOrthonormal(image);
  EXPECT_EQ(image->GetDimensions()[1], 10);
  ExpectTrue(scan, image);
  EXPECT_TRUE(this->IsTold("Slices are 2 to 3.75 mm apart"));
  EXPECT_FALSE(this->IsTold("drawn"));
}

TEST_F(RectifiedSlices, AreInterpolatedWhereSomeAreMissing)
{
  std::vector<double> heights = Evenly(14);
  heights.erase(heights.begin() + 6, heights.begin() + 8);
  const Scan scan(Upright(), heights);
  vtkImageData* const image = this->Read(scan);
  EXPECT_EQ(image->GetDimensions()[2], 14);
  EXPECT_NEAR(image->GetSpacing()[2], 2.5, 1e-9);
  ExpectTrue(scan, image);
  EXPECT_TRUE(this->IsTold("2 slices are missing between \"5\" and \"6\""));
}

TEST_F(RectifiedSlices, MayBeTiltedAndUnevenAtOnce)
{
  const Scan scan(Tilted(), { 0.0, 1.0, 2.0, 3.3, 6.3, 7.3 });
  vtkImageData* const image = this->Read(scan);
  ExpectOrthonormal(image);
  ExpectTrue(scan, image);
  this->Read(scan, false);
  EXPECT_FALSE(this->IsTold("shapes are correct"));
  EXPECT_TRUE(this->IsTold("are drawn"));
}

TEST_F(RectifiedSlices, AreAsDenseAsTheScanIsAnywhere)
{
  const Scan scan(Upright(), { 0.0, 1.0, 2.0, 3.0, 5.0, 7.0, 9.0, 11.0, 13.0 });
  EXPECT_EQ(this->Read(scan)->GetDimensions()[2], 14);
  EXPECT_NEAR(this->reader->GetOutput()->GetSpacing()[2], 2.5, 1e-9);
}

TEST_F(RectifiedSlices, StayUnchangedIfAlreadyEven)
{
  const Scan scan(Upright(), Evenly(9));
  vtkNew<vtkImageData> asScanned;
  asScanned->DeepCopy(this->Read(scan, false));
  vtkImageData* const image = this->Read(scan);
  EXPECT_FALSE(this->reader->HasIrregularSlices());
  EXPECT_EQ(this->reader->GetWarnings()->GetNumberOfValues(), 0);
  ASSERT_EQ(image->GetNumberOfPoints(), asScanned->GetNumberOfPoints());
  EXPECT_EQ(std::memcmp(image->GetScalarPointer(), asScanned->GetScalarPointer(),
              std::size_t(image->GetNumberOfPoints()) * image->GetScalarSize()),
    0);
  EXPECT_EQ(PlaceOf(image, 12, 9, 8), PlaceOf(asScanned, 12, 9, 8));
}

TEST_F(RectifiedSlices, StayAsScannedUnlessAskedFor)
{
  const Scan scan(Tilted(), Evenly(9));
  EXPECT_EQ(this->Read(scan, false)->GetDimensions()[1], 10);
  EXPECT_TRUE(this->reader->HasIrregularSlices());
  EXPECT_TRUE(this->IsTold("each slice is drawn at its true position"));
}

// Whether slices with these axes and heights are resampled if only misplaced ones are to be.
struct ByDefault
{
  glm::dmat3 axesMm;
  std::vector<double> heights;
  bool areRectified;
};

TEST_F(RectifiedSlices, AreByDefaultThoseThatWouldBeDrawnElsewhere)
{
  for (const auto& [axesMm, heights, areRectified] :
    { ByDefault{ Tilted(), Evenly(9), false }, ByDefault{ Upright(), { 0, 1, 2, 5, 6, 7 }, true },
      ByDefault{ Tilted(), { 0, 1, 2, 5, 6, 7 }, true },
      ByDefault{ Upright(), { 0, 1, 2, 7, 8, 9 }, false } })
  {
    SCOPED_TRACE(testing::PrintToString(heights));
    TemporaryFolder own;
    const Scan scan(axesMm, heights);
    scan.Write(own);
    vtkNew<vtkVolumeFileReader> chooser;
    chooser->SetFileName(own.Path("scan").c_str());
    chooser->RectifyMisplacedSlicesOn();
    chooser->Update();
    EXPECT_EQ(chooser->HasRectifiedSlices(), areRectified);
    EXPECT_TRUE(chooser->HasIrregularSlices());
    if (areRectified)
    {
      ExpectTrue(scan, chooser->GetOutput());
    }
  }
}

// Even slices between them would not fit the memory.
TEST_F(RectifiedSlices, LeaveOutASliceThatIsFarFromAllOthers)
{
  Scan(Upright(), { 0.0, 1.0, 2.0, 1e11 }).Write(this->folder);
  this->reader->SetFileName(this->folder.Path("scan").c_str());
  this->reader->RectifySlicesOn();
  this->reader->Update();
  EXPECT_EQ(std::string(this->reader->GetErrorMessage()), "");
  EXPECT_EQ(this->reader->GetOutput()->GetDimensions()[2], 3);
  EXPECT_EQ(this->reader->GetNumberOfDICOMKinds(), 2);
}

TEST_F(RectifiedSlices, CanBeStoppedWhileTheyAreMade)
{
  Scan(Tilted(), Evenly(9)).Write(this->folder);
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void* partDone)
    {
      const double part = *static_cast<double*>(partDone);
      const bool isRectifying = 0.85 < part && part < 0.95;
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(isRectifying ? 1 : 0);
    });
  this->reader->AddObserver(vtkCommand::ProgressEvent, stop);
  this->reader->SetFileName(this->folder.Path("scan").c_str());
  this->reader->RectifySlicesOn();
  this->reader->Update();
  EXPECT_EQ(this->reader->GetErrorCode(), (unsigned long)vtkErrorCode::UserError);
  EXPECT_EQ(this->reader->GetOutput()->GetNumberOfPoints(), 0);
}

}
