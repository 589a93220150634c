// An input that changes with every frame, as the times of a scan do.
#include "Module/MapperScene.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <vector>

namespace
{

constexpr int timeCount = 20;

/// The torso at several times, with values that shift a little from one to the next.
std::vector<vtkSmartPointer<vtkImageData>> Times()
{
  std::vector<vtkSmartPointer<vtkImageData>> times;
  for (int time = 0; time < timeCount; ++time)
  {
    times.push_back(SmallTorso());
    vtkDataArray* const values = times.back()->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
    {
      values->SetComponent(i, 0, values->GetComponent(i, 0) + 3.0 * time);
    }
  }
  return times;
}

double ResidentBytes()
{
  double pages = 0.0;
  double resident = 0.0;
  std::ifstream("/proc/self/statm") >> pages >> resident;
  return resident * double(sysconf(_SC_PAGESIZE));
}

}

TEST(InputOfTimes, GrowsNoMemoryInAThousandFrames)
{
  const auto times = Times();
  MapperScene scene(times.front(), 32);
  double afterHundred = 0.0;
  vtkIdType graphicsAfterHundred = 0;
  for (int frame = 0; frame < 1000; ++frame)
  {
    scene.mapper->SetInputData(times[std::size_t(frame % timeCount)]);
    scene.window->Render();
    if (frame == 99)
    {
      afterHundred = ResidentBytes();
      graphicsAfterHundred = scene.mapper->GetGraphicsMemoryBytes();
    }
  }
  EXPECT_EQ(scene.mapper->GetVolumeTextureBuilds(), 1000) << "each frame draws its own time";
  EXPECT_LE(scene.mapper->GetGraphicsMemoryBytes(), graphicsAfterHundred);
  // A copy of each of the 900 volumes of 69 kB would be 62 MB; heaps vary by a few.
  EXPECT_LT(ResidentBytes() - afterHundred, 8e6);
}

TEST(InputOfTimes, ReusesTheStepsOfOneTimeForTheNextFew)
{
  const auto times = Times();
  MapperScene scene(times.front(), 64);
  scene.mapper->SetErrorTolerance(1.0 / 64.0);
  const auto draw = [&](int time)
  {
    scene.mapper->SetInputData(times[std::size_t(time)]);
    return scene.DrawByProcessor();
  };
  for (int time = 0; time < timeCount - 1; ++time)
  {
    draw(time);
  }
  // The first two are no series yet; then there is one for each eight.
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 4);
  const std::vector<float> played = draw(timeCount - 1);
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 4);
  scene.DrawByProcessor();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), 5) << "a still image has steps of its own";
  scene.mapper->SetErrorTolerance(1.0 / 1024.0);
  const std::vector<float> exact = scene.DrawByProcessor();
  double largest = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    largest = std::max(largest, std::abs(double(exact[i]) - played[i]));
  }
  EXPECT_LT(largest, 1.0 / 64.0);
}
