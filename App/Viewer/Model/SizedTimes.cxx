#include "Viewer/Model/SizedTimes.h"

#include "Scene/SceneVolumes.h"
#include "Viewer/Model/MemoryLimit.h"

#include <vtkImageData.h>

#include <stdexcept>
#include <string>
#include <variant>

namespace varimarch
{

SizedTimes::SizedTimes(const Scene& scene, int volume, const LoadedVolume& shown)
  : reader(WithinMemory(std::get<FileSource>(VolumeSourceOf(scene, volume))))
  , size(SizeOf(shown))
{
}

SizedTimes::Size SizedTimes::SizeOf(const LoadedVolume& volume)
{
  const int* const sides = volume.image->GetDimensions();
  return { sides[0], sides[1], sides[2], volume.image->GetNumberOfScalarComponents() };
}

LoadedVolume SizedTimes::Read(int time, const LoadObserver& observer)
{
  LoadedVolume volume = this->reader.Read(time, observer);
  const auto textOf = [](const Size& size)
  {
    return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
      std::to_string(size[2]) + " voxels of " + std::to_string(size[3]) + " components";
  };
  if (const Size found = SizeOf(volume); found != this->size)
  {
    throw std::runtime_error("Cannot show the time of number " + std::to_string(time) +
      ", counted from 0: expected " + textOf(this->size) + " as at the other times, found " +
      textOf(found));
  }
  return volume;
}

}
