#ifndef Varimarch_Testing_RefinedLevels_h
#define Varimarch_Testing_RefinedLevels_h

// Volumes in their file that are drawn by coarse voxels, except where the image needs theirs.

#include "Module/Paging/TorsoOnDisk.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

inline constexpr double Steps = 0.005; ///< error that is left to steps and floats

inline double LargestDifference(const std::vector<float>& one, const std::vector<float>& other)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    largest = std::max(largest, std::abs(double(one[i]) - double(other[i])));
  }
  return largest;
}

class RefinedLevels : public TorsoOnDisk
{
protected:
  static constexpr int Side = 64;

  /// A file of voxels, Side along each axis.
  template <class Voxel = std::int16_t>
  vtkImageData* ReadVoxels(const std::function<int(int x, int y, int z)>& at)
  {
    std::vector<Voxel> voxels;
    for (int i = 0; i < Side * Side * Side; ++i)
    {
      voxels.push_back(Voxel(at(i % Side, i / Side % Side, i / Side / Side)));
    }
    const std::string path = this->folder.Write("voxels.raw",
      { reinterpret_cast<const char*>(voxels.data()), sizeof(Voxel) * voxels.size() });
    this->reader->SetRawDimensions(Side, Side, Side);
    this->reader->SetRawScalarType(vtkTypeTraits<Voxel>::VTKTypeID());
    this->reader->SetRawSpacing(1.0, 1.0, 1.0);
    constexpr vtkIdType TooLittle = 800000;
    return this->Read(path, TooLittle);
  }

  /// Fog that is thicker for larger values.
  static void UseFog(MapperScene& scene, double least, double most)
  {
    scene.opacities->RemoveAllPoints();
    scene.opacities->AddPoint(0.0, least);
    scene.opacities->AddPoint(1000.0, most);
    scene.mapper->ProcessorMarchingOn();
    constexpr vtkIdType EnoughToKeepPages = vtkIdType(1) << 40;
    scene.mapper->SetMaximumHostMemory(EnoughToKeepPages);
  }

  /// The last of the images that begin with the coarse level.
  static std::vector<float> DrawAll(MapperScene& scene)
  {
    scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
    std::vector<float> drawn = scene.Draw();
    while (scene.mapper->GetDrawnPart() < 1.0)
    {
      drawn = scene.Draw();
    }
    return drawn;
  }

  /// Renders a window until nothing more is refined, or a hundred times.
  /// @return the number of images
  static int RenderAll(MapperScene& scene)
  {
    scene.mapper->SetLevelOfDetail(vtkVariationFieldVolumeMapper::RefinedLevel);
    int images = 0;
    do
    {
      scene.window->Render();
      ++images;
    } while (scene.mapper->GetDrawnPart() < 1.0 && images < 100);
    return images;
  }
};

inline int Waves(int x, int y, int z)
{
  return 500 + int(std::lround(300.0 * std::sin(0.2 * x) * std::cos(0.25 * y) + 2.0 * z));
}

#endif
