#ifndef Varimarch_Testing_PyramidInChunks_h
#define Varimarch_Testing_PyramidInChunks_h

#include "Module/Paging/VoxelsInChunks.h"

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

  /// Voxels of level 0 per voxel of a level, along x, y and z.
  using ScaleOf = std::function<std::array<int, 3>(int level)>;

  static std::array<int, 3> EvenScale(int level) { return { 1 << level, 1 << level, 1 << level }; }
  static std::array<int, 3> ScaleThatKeepsSlices(int level)
  {
    return { 1 << level, 1 << level, 1 };
  }

  static std::array<int, 3> LevelSize(const std::array<int, 3>& scale)
  {
    return { 256 / scale[0], 256 / scale[1], 40 / scale[2] };
  }

  /// Every second, fourth and eighth voxel of a volume.
  std::string WritePyramid(const ValueAt& at, const ScaleOf& scaleOf = EvenScale)
  {
    return this->WriteLevels([&](int) { return at; }, scaleOf);
  }

  std::string WriteLevels(
    const std::function<ValueAt(int level)>& of, const ScaleOf& scaleOf = EvenScale)
  {
    std::filesystem::remove_all(this->folder.Path("p.zarr"));
    std::string dataSets;
    for (int level = 0; level < LevelCount; ++level)
    {
      const std::string number = std::to_string(level);
      const std::array<int, 3> scale = scaleOf(level);
      const Shape shape = { LevelSize(scale), { 64, 8, 8 } };
      this->WriteZarr(LevelOf(of(level), scale), shape);
      std::filesystem::create_directories(this->folder.Path("p.zarr"));
      std::filesystem::rename(this->folder.Path("a.zarr"), this->folder.Path("p.zarr/" + number));
      dataSets += (level > 0 ? ", " : "") + (R"({"path": ")" + number) +
        R"(", "coordinateTransformations": [{"type": "scale", "scale": [)" +
        std::to_string(scale[2]) + ", " + std::to_string(scale[1]) + ", " +
        std::to_string(scale[0]) + "]}]}";
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
  static vtkSmartPointer<vtkImageData> LevelOf(const ValueAt& at, const std::array<int, 3>& scale)
  {
    const std::array<int, 3> size = LevelSize(scale);
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(size.data());
    image->AllocateScalars(VTK_SHORT, 1);
    auto* const voxels = static_cast<short*>(image->GetScalarPointer());
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      voxels[i] = short(at(scale[0] * double(i % size[0]), scale[1] * double(i / size[0] % size[1]),
        scale[2] * double(i / (vtkIdType(size[0]) * size[1]))));
    }
    return image;
  }
};

#endif
