// Editing of segments, on a grid of 1 x 2 x 3 mm that is turned.

#include "Scene/Segments/SegmentEditing.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

using namespace varimarch;

namespace
{

constexpr int EditedSide = 20;

class SegmentEditing : public testing::Test
{
protected:
  SegmentEditing()
  {
    for (auto* image : { &this->numbers, &this->scan })
    {
      *image = vtkSmartPointer<vtkImageData>::New();
      (*image)->SetDimensions(EditedSide, EditedSide, EditedSide);
      (*image)->SetSpacing(1.0, 2.0, 3.0);
      (*image)->SetOrigin(100.0, -50.0, 7.0);
      (*image)->SetDirectionMatrix(0, -1, 0, 1, 0, 0, 0, 0, 1);
    }
    this->numbers->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    this->scan->AllocateScalars(VTK_SHORT, 1);
    std::fill_n(this->At(0, 0, 0), this->numbers->GetNumberOfPoints(), std::uint8_t(0));
    std::fill_n(static_cast<short*>(this->scan->GetScalarPointer()),
      this->scan->GetNumberOfPoints(), short(0));
  }

  std::uint8_t* At(int x, int y, int z)
  {
    return static_cast<std::uint8_t*>(this->numbers->GetScalarPointer(x, y, z));
  }

  /// Sets a box of voxels in the numbers or the scan.
  template <class Number>
  void Fill(vtkImageData* image, const std::array<int, 6>& box, Number value)
  {
    for (int z = box[4]; z <= box[5]; ++z)
    {
      for (int y = box[2]; y <= box[3]; ++y)
      {
        for (int x = box[0]; x <= box[1]; ++x)
        {
          *static_cast<Number*>(image->GetScalarPointer(x, y, z)) = value;
        }
      }
    }
  }

  std::array<double, 3> PointAt(int x, int y, int z)
  {
    std::array<double, 3> point;
    this->numbers->TransformIndexToPhysicalPoint(x, y, z, point.data());
    return point;
  }

  int Count(int number)
  {
    return int(std::count(
      this->At(0, 0, 0), this->At(0, 0, 0) + this->numbers->GetNumberOfPoints(), number));
  }

  vtkSmartPointer<vtkImageData> numbers;
  vtkSmartPointer<vtkImageData> scan;
};

}

TEST_F(SegmentEditing, AConnectedRegionEndsWhereValuesOrVoxelsEnd)
{
  this->Fill<short>(this->scan, { 2, 5, 2, 5, 2, 5 }, 300);   // 64 voxels: bone
  this->Fill<short>(this->scan, { 6, 9, 2, 5, 2, 5 }, 100);   // soft tissue beside it
  this->Fill<short>(this->scan, { 12, 15, 2, 5, 2, 5 }, 300); // the table
  this->Fill<short>(this->scan, { 6, 6, 6, 6, 6, 6 }, 300);   // touches at a corner only
  this->Fill<std::uint8_t>(this->numbers, { 2, 2, 2, 2, 2, 2 }, 9);
  const LabelChange change =
    ConnectedRegion(this->numbers, 1, this->scan, this->PointAt(4, 4, 4), { 200, 400 });
  EXPECT_EQ(this->Count(1), 0);
  Apply(change, true, this->numbers);
  EXPECT_EQ(this->Count(1), 63); // another segment keeps its voxel
  EXPECT_EQ(*this->At(2, 2, 2), 9);
  EXPECT_EQ(change.box, (std::array<int, 6>{ 2, 5, 2, 5, 2, 5 }));
  Apply(change, false, this->numbers);
  EXPECT_EQ(this->Count(1), 0);
  EXPECT_TRUE(
    ConnectedRegion(this->numbers, 1, this->scan, this->PointAt(8, 4, 4), { 200, 400 }).IsEmpty());
}

// A disc of 4 mm in a slice across the third axis, whose voxels are 1 x 2 mm.
TEST_F(SegmentEditing, ABrushPaintsADiscInItsSliceOnly)
{
  const auto place = this->PointAt(10, 10, 10);
  const BrushStroke dot = { place, place, { 0.0, 0.0, 1.0 }, 4.0 };
  Apply(Painted(this->numbers, 2, dot), true, this->numbers);
  int expected = 0;
  for (int y = -3; y <= 3; ++y)
  {
    for (int x = -5; x <= 5; ++x)
    {
      const bool isIn = x * x + 4 * y * y <= 16;
      expected += isIn;
      EXPECT_EQ(*this->At(10 + x, 10 + y, 10), isIn ? 2 : 0) << x << ' ' << y;
    }
  }
  EXPECT_EQ(this->Count(2), expected);
}

TEST_F(SegmentEditing, AStrokeHasNoGapsAndIsErasedFromItsSegmentOnly)
{
  this->Fill<std::uint8_t>(this->numbers, { 8, 8, 10, 10, 10, 10 }, 7);
  const BrushStroke line = { this->PointAt(4, 10, 10), this->PointAt(15, 10, 10), { 0.0, 0.0, 1.0 },
    0.6 };
  Apply(Painted(this->numbers, 2, line), true, this->numbers);
  EXPECT_EQ(this->Count(2), 12); // also over the other segment
  EXPECT_EQ(this->Count(7), 0);
  *this->At(5, 10, 10) = 7;
  Apply(Erased(this->numbers, 2, line), true, this->numbers);
  EXPECT_EQ(this->Count(2), 0);
  EXPECT_EQ(this->Count(7), 1);
}

TEST_F(SegmentEditing, TwoChangesAreTakenBackAsOne)
{
  const auto a = this->PointAt(5, 10, 10);
  const auto b = this->PointAt(12, 11, 10);
  this->Fill<std::uint8_t>(this->numbers, { 6, 6, 10, 10, 10, 10 }, 7);
  const LabelChange first = Painted(this->numbers, 2, { a, a, { 0.0, 0.0, 1.0 }, 4.0 });
  Apply(first, true, this->numbers);
  const LabelChange second = Erased(this->numbers, 2, { a, b, { 0.0, 0.0, 1.0 }, 3.0 });
  Apply(second, true, this->numbers);
  const int left = this->Count(2);
  const LabelChange both = Joined(first, second, this->numbers);
  Apply(both, false, this->numbers);
  EXPECT_EQ(this->Count(2), 0);
  EXPECT_EQ(this->Count(7), 1);
  Apply(both, true, this->numbers);
  EXPECT_EQ(this->Count(2), left);
  EXPECT_GT(left, 0);
}

TEST_F(SegmentEditing, IslandsAreKeptBySize)
{
  this->Fill<std::uint8_t>(this->numbers, { 0, 3, 0, 3, 0, 3 }, 1);     // 64 voxels of 6 mm3
  this->Fill<std::uint8_t>(this->numbers, { 6, 8, 0, 2, 0, 2 }, 1);     // 27
  this->Fill<std::uint8_t>(this->numbers, { 12, 12, 0, 0, 0, 0 }, 1);   // 1
  this->Fill<std::uint8_t>(this->numbers, { 15, 19, 0, 9, 0, 9 }, 2);   // another segment
  const LabelChange large = WithoutSmallIslands(this->numbers, 1, 0.1); // 17 voxels
  Apply(large, true, this->numbers);
  EXPECT_EQ(this->Count(1), 64 + 27);
  Apply(LargestIsland(this->numbers, 1), true, this->numbers);
  EXPECT_EQ(this->Count(1), 64);
  EXPECT_EQ(this->Count(2), 500);
}

// More parts than a byte can count.
TEST_F(SegmentEditing, ManyIslandsAreKept)
{
  for (int i = 0; i < 1000; ++i)
  {
    *this->At(2 * (i % 10), 2 * (i / 10 % 10), 2 * (i / 100)) = 1;
  }
  EXPECT_TRUE(WithoutSmallIslands(this->numbers, 1, 0.001).IsEmpty());
}

TEST_F(SegmentEditing, ARangeOfWholeValuesEndsBetweenThem)
{
  this->Fill<short>(this->scan, { 2, 5, 2, 5, 2, 5 }, 300);
  const auto isFound = [&](const std::array<double, 2>& range) {
    return !ConnectedRegion(this->numbers, 1, this->scan, this->PointAt(4, 4, 4), range).IsEmpty();
  };
  EXPECT_TRUE(isFound({ 299.5, 300.5 }));
  EXPECT_FALSE(isFound({ 300.5, 400.0 }));
  this->Fill<short>(this->scan, { 2, 5, 2, 5, 2, 5 }, -300);
  EXPECT_FALSE(isFound({ -400.0, -300.5 }));
}

TEST_F(SegmentEditing, SmoothingRemovesSpikesFillsHolesAndLeavesOthers)
{
  this->Fill<std::uint8_t>(this->numbers, { 4, 14, 4, 14, 4, 14 }, 1);
  *this->At(15, 9, 9) = 1; // a spike
  *this->At(9, 9, 9) = 0;  // a hole
  *this->At(8, 9, 9) = 3;  // another segment
  Apply(Smoothed(this->numbers, 1, 2.0), true, this->numbers);
  EXPECT_EQ(*this->At(15, 9, 9), 0);
  EXPECT_EQ(*this->At(9, 9, 9), 1);
  EXPECT_EQ(*this->At(8, 9, 9), 3);
  EXPECT_EQ(*this->At(4, 9, 9), 1); // a flat face stays
}
