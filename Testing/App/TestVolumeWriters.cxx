// Volumes that are written and read again are the same.
#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"
#include "Support/UserFaults.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace varimarch;

namespace
{

/// A folder that is deleted at the end of the test.
class Folder
{
public:
  Folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "varimarch-XXXXXX").string();
    this->path = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(this->path); }

  std::string Path(const std::string& name) const { return (this->path / name).string(); }

private:
  std::filesystem::path path;
};

/// A volume of different values, at an oblique angle, mirrored and sheared.
LoadedVolume VolumeOf(int scalarType, int componentCount)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 4, 3);
  image->SetOrigin(-31.0, 17.5, 120.25);
  image->SetSpacing(0.7, 1.1, 2.5);
  const double direction[9] = { 0.8, 0.6, 0.0, 0.6, -0.8, 0.28, 0.0, 0.0, 0.96 };
  image->SetDirectionMatrix(direction);
  image->AllocateScalars(scalarType, componentCount);
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int component = 0; component < componentCount; ++component)
    {
      values->SetComponent(i, component, double((i + 61 * component) % 100));
    }
  }
  return { image, "CT", {} };
}

void ExpectSameValues(vtkImageData* written, vtkImageData* read)
{
  ASSERT_EQ(written->GetNumberOfPoints(), read->GetNumberOfPoints());
  ASSERT_EQ(written->GetNumberOfScalarComponents(), read->GetNumberOfScalarComponents());
  EXPECT_EQ(written->GetScalarType(), read->GetScalarType());
  vtkDataArray* const expected = written->GetPointData()->GetScalars();
  vtkDataArray* const found = read->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < expected->GetNumberOfValues(); ++i)
  {
    ASSERT_EQ(found->GetVariantValue(i).ToDouble(), expected->GetVariantValue(i).ToDouble()) << i;
  }
}

/// @param toleranceMm  the precision of the format's numbers
void ExpectSamePlace(vtkImageData* written, vtkImageData* read, double toleranceMm)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    double expected[3];
    double found[3];
    const int i = corner % 2 * 4;
    const int j = corner / 2 % 2 * 3;
    const int k = corner / 4 * 2;
    written->TransformIndexToPhysicalPoint(i, j, k, expected);
    read->TransformIndexToPhysicalPoint(i, j, k, found);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(found[axis], expected[axis], toleranceMm);
    }
  }
}

TEST(VolumeWriters, EveryFormatKeepsValuesAndGeometry)
{
  const Folder folder;
  for (const char* const extension : { ".nrrd", ".mha", ".vti", ".nii", ".nii.gz" })
  {
    for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
           VTK_INT, VTK_UNSIGNED_INT, VTK_FLOAT, VTK_DOUBLE })
    {
      for (const int componentCount : { 1, 2, 3, 4 })
      {
        SCOPED_TRACE(extension + std::string(" ") + vtkImageScalarTypeNameMacro(type) + " " +
          std::to_string(componentCount));
        const LoadedVolume volume = VolumeOf(type, componentCount);
        const std::string path = folder.Path(std::string("a") + extension);
        EXPECT_TRUE(WriteVolume(volume, path).empty());
        const LoadedVolume read = LoadVolume(FileSource{ path, std::nullopt });
        ExpectSameValues(volume.image, read.image);
        // NIfTI has floats, with a precision of 24 bits.
        const bool isNifti = std::string(extension).find("nii") != std::string::npos;
        ExpectSamePlace(volume.image, read.image, isNifti ? 2e-5 : 1e-12);
      }
    }
  }
}

/// The values of a volume whose second axis is backwards.
vtkSmartPointer<vtkImageData> WithRowsForwards(vtkImageData* image)
{
  auto turned = vtkSmartPointer<vtkImageData>::New();
  turned->DeepCopy(image);
  int size[3];
  image->GetDimensions(size);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const vtkIdType row = i / size[0] % size[1];
    const vtkIdType from = i + (size[1] - 1 - 2 * row) * size[0];
    turned->GetPointData()->GetScalars()->SetTuple(i, from, image->GetPointData()->GetScalars());
  }
  return turned;
}

TEST(VolumeWriters, TiffKeepsValuesSpacingAndSides)
{
  const Folder folder;
  for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_INT, VTK_UNSIGNED_INT, VTK_FLOAT, VTK_DOUBLE })
  {
    for (const int componentCount : { 1, 2, 3, 4 })
    {
      const LoadedVolume volume = VolumeOf(type, componentCount);
      EXPECT_EQ(WriteVolume(volume, folder.Path("a.tif")).size(), 1u);
      const LoadedVolume read = LoadVolume(FileSource{ folder.Path("a.tif"), std::nullopt });
      ExpectSameValues(WithRowsForwards(volume.image), read.image);
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_DOUBLE_EQ(read.image->GetSpacing()[axis], volume.image->GetSpacing()[axis]);
      }
    }
  }
}

// Voxels are compared where they lie, so any order of axes is right that puts them there.
TEST(VolumeWriters, TiffAndZarrPutEachVoxelOnTheSideWhereItWas)
{
  const Folder folder;
  const double orders[4][9] = { { 1, 0, 0, 0, 1, 0, 0, 0, 1 }, { -1, 0, 0, 0, -1, 0, 0, 0, 1 },
    { 0, 0, -1, 1, 0, 0, 0, -1, 0 }, { 0, 1, 0, 0, 0, 1, 1, 0, 0 } };
  for (const double(&direction)[9] : orders)
  {
    LoadedVolume volume = VolumeOf(VTK_SHORT, 1);
    volume.image->SetDirectionMatrix(direction);
    for (const char* const name : { "a.tif", "a.zarr" })
    {
      WriteVolume(volume, folder.Path(name));
      const LoadedVolume read = LoadVolume(FileSource{ folder.Path(name), std::nullopt });
      ASSERT_EQ(read.image->GetNumberOfPoints(), volume.image->GetNumberOfPoints());
      // TIFF loses the position, so places count from the lowest corner of each.
      double before[6];
      double after[6];
      volume.image->GetBounds(before);
      read.image->GetBounds(after);
      for (vtkIdType i = 0; i < read.image->GetNumberOfPoints(); ++i)
      {
        double place[3];
        read.image->GetPoint(i, place);
        for (int axis = 0; axis < 3; ++axis)
        {
          place[axis] += before[2 * axis] - after[2 * axis];
        }
        const vtkIdType old = volume.image->FindPoint(place);
        ASSERT_GE(old, 0);
        ASSERT_EQ(read.image->GetPointData()->GetScalars()->GetTuple1(i),
          volume.image->GetPointData()->GetScalars()->GetTuple1(old))
          << name << ' ' << i;
      }
    }
  }
}

// The system may refuse to write a file from the addresses of such voxels.
TEST(VolumeWriters, KeepVoxelsThatAreReadFromTheirChunks)
{
  if (!HasUserFaults())
  {
    GTEST_SKIP() << "the system refuses userfaultfd";
  }
  const Folder folder;
  LoadedVolume volume = { vtkSmartPointer<vtkImageData>::New(), "", {} };
  volume.image->SetDimensions(64, 64, 640);
  volume.image->AllocateScalars(VTK_SHORT, 1);
  const vtkIdType count = volume.image->GetNumberOfPoints();
  auto* const voxels = static_cast<short*>(volume.image->GetScalarPointer());
  for (vtkIdType i = 0; i < count; ++i)
  {
    voxels[i] = short(i % 30011);
  }
  WriteVolume(volume, folder.Path("a.zarr"));
  FileSource source{ folder.Path("a.zarr"), std::nullopt };
  source.level = 0;
  source.memoryMegabytes = 9;
  for (const char* const extension : { ".nrrd", ".mha", ".vti", ".nii", ".nii.gz", ".tif" })
  {
    const LoadedVolume inChunks = LoadVolume(source);
    ASSERT_TRUE(inChunks.isOnDisk);
    const std::string path = folder.Path(std::string("b") + extension);
    WriteVolume(inChunks, path);
    const LoadedVolume read = LoadVolume(FileSource{ path, std::nullopt });
    ASSERT_EQ(read.image->GetNumberOfPoints(), count) << extension;
    EXPECT_TRUE(
      std::equal(voxels, voxels + count, static_cast<short*>(read.image->GetScalarPointer())))
      << extension;
  }
}

TEST(VolumeWriters, AFailureLeavesTheOldFile)
{
  const Folder folder;
  std::ofstream(folder.Path("a.tif")) << "old";
  const LoadedVolume volume = VolumeOf(VTK_TYPE_INT64, 1);
  EXPECT_THROW(WriteVolume(volume, folder.Path("a.tif")), std::runtime_error);
  EXPECT_EQ(std::filesystem::file_size(folder.Path("a.tif")), 3u);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.Path("")), {}), 1);
}

}
