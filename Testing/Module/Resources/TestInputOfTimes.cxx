// An input that changes with every frame, as the times of a scan do.
#include "Module/Scenes/MapperScene.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <unistd.h>

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

constexpr double Tolerance = 1.0 / 64.0;

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

// The values spread from one time to the next, and at once, so that steps must become shorter.
TEST(InputOfTimes, KeepsTheToleranceAtEachTime)
{
  auto times = Times();
  for (std::size_t time = 0; time < times.size(); ++time)
  {
    vtkDataArray* const values = times[time]->GetPointData()->GetScalars();
    const double spread = time < times.size() / 2 ? 0.05 + 0.1 * double(time) : 3.0;
    for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
    {
      values->SetComponent(i, 0, spread * values->GetComponent(i, 0));
    }
  }
  MapperScene scene(times.front(), 64);
  scene.mapper->SetErrorTolerance(Tolerance);
  for (const auto& time : times)
  {
    scene.image = time;
    scene.mapper->SetInputData(time);
    const std::vector<float> drawn = scene.DrawByProcessor();
    const std::vector<float> truth = scene.Truth();
    const varimarch::ImageError error =
      varimarch::CompareImages(drawn.data(), truth.data(), truth.size() / 4);
    EXPECT_LE(error.percentile999, 255.0 * Tolerance);
    EXPECT_TRUE(scene.mapper->GetErrorToleranceIsKept());
  }
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), timeCount);
}

TEST(InputOfTimes, SearchesAndReadsEachTimeOnce)
{
  const auto times = Times();
  MapperScene scene(times.front(), 64);
  scene.mapper->SetErrorTolerance(Tolerance);
  const auto play = [&]
  {
    std::vector<std::vector<float>> images;
    for (const auto& time : times)
    {
      scene.mapper->SetInputData(time);
      images.push_back(scene.DrawByProcessor());
    }
    return images;
  };
  const auto first = play();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), timeCount);
  EXPECT_EQ(scene.mapper->GetBrickRangesBuilds(), timeCount);
  EXPECT_EQ(play(), first);
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), timeCount);
  EXPECT_EQ(scene.mapper->GetBrickRangesBuilds(), timeCount);

  // Voxels that have changed are new.
  times.front()->GetPointData()->GetScalars()->SetComponent(0, 0, 500.0);
  times.front()->GetPointData()->GetScalars()->Modified();
  play();
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), timeCount + 1);
  EXPECT_EQ(scene.mapper->GetBrickRangesBuilds(), timeCount + 1);
}

// Ranges that are kept count as memory of the program.
TEST(InputOfTimes, ReadsEachTimeAgainWhereMemoryIsShort)
{
  const auto times = Times();
  MapperScene scene(times.front(), 64);
  scene.mapper->SetErrorTolerance(Tolerance);
  scene.mapper->SetMaximumHostMemory(1000);
  for (int i = 0; i < 2 * timeCount; ++i)
  {
    scene.mapper->SetInputData(times[std::size_t(i % timeCount)]);
    scene.DrawByProcessor();
  }
  EXPECT_EQ(scene.mapper->GetBrickRangesBuilds(), 2 * timeCount);
}

TEST(InputOfTimes, HasStepsOfOneViewForAllTimesNearIt)
{
  const auto times = Times();
  MapperScene scene(times.front(), 64);
  scene.mapper->SetErrorTolerance(Tolerance);
  for (int image = 0; image < 4 * timeCount; ++image)
  {
    scene.mapper->SetInputData(times[std::size_t(image % timeCount)]);
    scene.renderer->GetActiveCamera()->Azimuth(0.02);
    scene.DrawByProcessor();
  }
  EXPECT_EQ(scene.mapper->GetToleranceSearches(), timeCount);
}

// Each image builds the field of its time.
TEST(InputOfTimes, AreDrawnInTheTimeThatIsAllowedWhileSomebodyPlaysThem)
{
  const auto times = Times();
  MapperScene scene(times.front(), 32);
  constexpr double MoreThanAnyMachine = 1e6;
  scene.window->SetDesiredUpdateRate(MoreThanAnyMachine);
  for (int frame = 0; frame < 6; ++frame)
  {
    scene.mapper->SetInputData(times[std::size_t(frame)]);
    scene.window->Render();
  }
  EXPECT_EQ(scene.mapper->GetVolumeTextureBuilds(), 6);
  EXPECT_GT(scene.mapper->GetUsedImageSampleDistance(), 1.0);
}
