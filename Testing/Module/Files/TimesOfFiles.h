#ifndef Varimarch_Testing_TimesOfFiles_h
#define Varimarch_Testing_TimesOfFiles_h

// Files with several volumes, of which a reader reads one after another.
#include "PhantomFiles.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkVolumeFileReader.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

inline constexpr int timeCount = 4;

/// The phantom with 100 added for each time that has passed.
inline StoredVolume AtTime(int time)
{
  StoredVolume volume = phantom::Stored(0);
  for (double& value : volume.values)
  {
    value += 100.0 * time;
  }
  return volume;
}

/// The voxels of all times, one volume after another.
inline std::string VoxelsOfTimes(int count = timeCount, bool bigEndian = false)
{
  std::string bytes;
  for (int time = 0; time < count; ++time)
  {
    bytes += VoxelBytes(AtTime(time), bigEndian);
  }
  return bytes;
}

inline std::vector<double> ValuesOf(vtkImageData* image)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  std::vector<double> values;
  for (vtkIdType i = 0; scalars && i < scalars->GetNumberOfValues(); ++i)
  {
    values.push_back(scalars->GetVariantValue(i).ToDouble());
  }
  return values;
}

class VolumeTimes : public testing::Test
{
protected:
  /// Reads all times in an order that skips, repeats and goes back.
  void ExpectTimes(const std::string& path, const std::vector<double>& times, bool areSeconds)
  {
    this->reader->SetFileName(path.c_str());
    this->reader->Modified();
    for (const int time : { 0, 1, 3, 3, 2, 0 })
    {
      this->reader->SetTimeIndex(time);
      this->reader->Update();
      ASSERT_STREQ(this->reader->GetErrorMessage(), "") << path;
      EXPECT_EQ(ValuesOf(this->reader->GetOutput()), AtTime(time).values)
        << path << " at time " << time;
      EXPECT_EQ(this->reader->GetReadTime(), time);
    }
    ASSERT_EQ(this->reader->GetNumberOfTimes(), int(times.size())) << path;
    EXPECT_EQ(this->reader->HasTimesInSeconds(), areSeconds) << path;
    for (int time = 0; time < int(times.size()); ++time)
    {
      EXPECT_NEAR(this->reader->GetTimeValue(time), times[std::size_t(time)], 1e-6) << path;
    }
  }

  void ExpectSeconds(const std::string& path, const std::vector<double>& seconds)
  {
    this->ExpectTimes(path, seconds, true);
  }

  void ExpectNumbers(const std::string& path)
  {
    this->ExpectTimes(path, { 0.0, 1.0, 2.0, 3.0 }, false);
  }

  TemporaryFolder folder;
  vtkNew<vtkVolumeFileReader> reader;
};

#endif
