#ifndef Varimarch_Testing_VoxelsInChunks_h
#define Varimarch_Testing_VoxelsInChunks_h

#include "Module/Files/PhantomFiles.h"
#include "Scene/Volumes/ProceduralVolume.h"
#include "Support/UserFaults.h"

#include <vtkVolumeFileReader.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

/// Memory in which the voxels do not fit. The program has more, so that what was read is dropped
/// again and again.
inline constexpr vtkIdType LessThanTheVoxels = 1200000;

/// The shape of a volume of shorts as Zarr, x first.
struct Shape
{
  std::array<int, 3> size;
  std::array<int, 3> chunk;
};

// The rows of a unit begin and end inside pages, and at their borders.
inline constexpr Shape uneven = { { 203, 89, 71 }, { 32, 16, 8 } };
inline constexpr Shape even = { { 256, 64, 72 }, { 64, 16, 8 } };

/// A reader, and volumes of shorts in chunks that it leaves there.
class VoxelsInChunks : public testing::Test
{
protected:
  void SetUp() override
  {
    if (!HasUserFaults())
    {
      GTEST_SKIP() << "the system refuses userfaultfd";
    }
  }

  static vtkSmartPointer<vtkImageData> Torso(const Shape& shape)
  {
    return varimarch::ProceduralVolume({ varimarch::ProceduralKind::Torso, shape.size, 7 });
  }

  static const short* Voxels(vtkImageData* image)
  {
    return static_cast<const short*>(image->GetScalarPointer());
  }

  std::string ChunkOf(const std::array<int, 3>& index) const
  {
    return "a.zarr/" + std::to_string(index[2]) + "." + std::to_string(index[1]) + "." +
      std::to_string(index[0]);
  }

  void WriteChunk(vtkImageData* image, const Shape& shape, const std::array<int, 3>& index)
  {
    const auto& chunk = shape.chunk;
    std::vector<short> voxels;
    for (int i = 0; i < chunk[0] * chunk[1] * chunk[2]; ++i)
    {
      const std::array<int, 3> at = { index[0] * chunk[0] + i % chunk[0],
        index[1] * chunk[1] + i / chunk[0] % chunk[1],
        index[2] * chunk[2] + i / (chunk[0] * chunk[1]) };
      const bool isInside = at[0] < shape.size[0] && at[1] < shape.size[1] && at[2] < shape.size[2];
      voxels.push_back(isInside
          ? Voxels(image)[(vtkIdType(at[2]) * shape.size[1] + at[1]) * shape.size[0] + at[0]]
          : short(0));
    }
    this->folder.Write(
      this->ChunkOf(index), { reinterpret_cast<const char*>(voxels.data()), 2 * voxels.size() });
  }

  std::string WriteZarr(vtkImageData* image, const Shape& shape, int fill = 0)
  {
    const auto text = [](const std::array<int, 3>& sizes)
    {
      return "[" + std::to_string(sizes[2]) + ", " + std::to_string(sizes[1]) + ", " +
        std::to_string(sizes[0]) + "]";
    };
    this->folder.Write("a.zarr/.zarray",
      R"({"zarr_format": 2, "shape": )" + text(shape.size) + R"(, "chunks": )" + text(shape.chunk) +
        R"(, "dtype": "<i2", "compressor": null, "order": "C", "filters": null, "fill_value": )" +
        std::to_string(fill) + "}");
    for (int k = 0; k * shape.chunk[2] < shape.size[2]; ++k)
    {
      for (int j = 0; j * shape.chunk[1] < shape.size[1]; ++j)
      {
        for (int i = 0; i * shape.chunk[0] < shape.size[0]; ++i)
        {
          this->WriteChunk(image, shape, { i, j, k });
        }
      }
    }
    return this->folder.Path("a.zarr");
  }

  /// A volume of 0, but for one voxel in the middle of each slice.
  static vtkSmartPointer<vtkImageData> Needle(const Shape& shape)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(shape.size.data());
    image->AllocateScalars(VTK_SHORT, 1);
    auto* const voxels = static_cast<short*>(image->GetScalarPointer());
    std::fill_n(voxels, image->GetNumberOfPoints(), short(0));
    for (vtkIdType slice = 0; slice < shape.size[2]; ++slice)
    {
      voxels[Middle(shape, slice)] = 700;
    }
    return image;
  }

  static vtkIdType Middle(const Shape& shape, vtkIdType slice)
  {
    return (slice * shape.size[1] + shape.size[1] / 2) * shape.size[0] + shape.size[0] / 2;
  }

  vtkImageData* Read(const std::string& path, vtkIdType memory = LessThanTheVoxels)
  {
    this->reader->SetFileName(path.c_str());
    this->reader->SetMaximumHostMemory(memory);
    this->reader->Modified();
    this->reader->Update();
    return this->reader->GetOutput();
  }

  TemporaryFolder folder;
  vtkNew<vtkVolumeFileReader> reader;
};

#endif
