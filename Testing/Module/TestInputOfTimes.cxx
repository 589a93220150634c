// An input that changes with every frame, as the times of a scan do.
#include "Module/MapperScene.h"

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
