#ifndef Varimarch_Testing_PyramidInChunks_h
#define Varimarch_Testing_PyramidInChunks_h

#include "Module/VoxelsInChunks.h"

#include <vtkNew.h>

#include <array>
#include <filesystem>
#include <functional>
#include <string>

/// Memory in which a brick has 8 or 4 cells along each side.
inline constexpr vtkIdType MemoryForBricksOf8 = 1000000;
inline constexpr vtkIdType MemoryForBricksOf4 = 3000000;

/// Volumes of shorts as OME-Zarr with four levels.
class PyramidInChunks : public VoxelsInChunks
{
protected:
  using ValueAt = std::function<int(double x, double y, double z)>; ///< in voxels of level 0

  static constexpr int LevelCount = 4;

  static std::array<int, 3> LevelSize(int level)
  {
    return { 256 >> level, 256 >> level, 40 >> level };
  }

  /// Every second, fourth and eighth voxel of a volume.
  std::string WritePyramid(const ValueAt& at)
  {
    return this->WriteLevels([&](int) { return at; });
  }

  std::string WriteLevels(const std::function<ValueAt(int level)>& of)
  {
    std::filesystem::remove_all(this->folder.Path("p.zarr"));
    std::string dataSets;
    for (int level = 0; level < LevelCount; ++level)
    {
      const std::string number = std::to_string(level);
      const std::string scale = std::to_string(1 << level);
      const Shape shape = { LevelSize(level), { 64, 8, 8 } };
      this->WriteZarr(LevelOf(of(level), level), shape);
      std::filesystem::create_directories(this->folder.Path("p.zarr"));
      std::filesystem::rename(this->folder.Path("a.zarr"), this->folder.Path("p.zarr/" + number));
      dataSets += (level > 0 ? ", " : "") + (R"({"path": ")" + number) +
        R"(", "coordinateTransformations": [{"type": "scale", "scale": [)" + scale + ", " + scale +
        ", " + scale + "]}]}";
    }
    this->folder.Write("p.zarr/.zattrs",
      R"({"multiscales": [{"version": "0.4", "axes": [{"name": "z", "type": "space"},
      {"name": "y", "type": "space"}, {"name": "x", "type": "space"}], "datasets": [)" +
        dataSets + "]}]}");
    return this->folder.Path("p.zarr");
  }

  /// Makes all chunks of a level unreadable.
  void DamageLevel(int level)
  {
    const std::string name = "p.zarr/" + std::to_string(level);
    for (const auto& file : std::filesystem::directory_iterator(this->folder.Path(name)))
    {
      if (file.path().filename() != ".zarray")
      {
        this->folder.Write(name + "/" + file.path().filename().string(), "half");
      }
    }
  }

private:
  static vtkSmartPointer<vtkImageData> LevelOf(const ValueAt& at, int level)
  {
    const std::array<int, 3> size = LevelSize(level);
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(size.data());
    image->AllocateScalars(VTK_SHORT, 1);
    auto* const voxels = static_cast<short*>(image->GetScalarPointer());
    const double scale = 1 << level;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      voxels[i] = short(at(scale * double(i % size[0]), scale * double(i / size[0] % size[1]),
        scale * double(i / (vtkIdType(size[0]) * size[1]))));
    }
    return image;
  }
};

#endif
