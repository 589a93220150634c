// Every type, byte order and encoding of a format must give the same values.
#include "PhantomFiles.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkVolumeFileReader.h>

#include <gtest/gtest.h>

#include <limits>

namespace
{

constexpr int types[] = { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
  VTK_INT, VTK_UNSIGNED_INT, VTK_FLOAT, VTK_DOUBLE };

/// A volume whose values reach the limits of their type.
StoredVolume VolumeOfType(int scalarType)
{
  StoredVolume volume = phantom::Stored(0);
  volume.scalarType = scalarType;
  switch (scalarType)
  {
    vtkTemplateMacro(volume.values.front() = double(std::numeric_limits<VTK_TT>::lowest());
                     volume.values.back() = double(std::numeric_limits<VTK_TT>::max()));
  }
  return volume;
}

void ExpectVoxels(vtkVolumeFileReader* reader, const StoredVolume& volume)
{
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  vtkDataArray* values = reader->GetOutput()->GetPointData()->GetScalars();
  ASSERT_TRUE(values);
  EXPECT_TRUE(values->GetName() && *values->GetName());
  EXPECT_EQ(values->GetDataType(), volume.scalarType);
  ASSERT_EQ(values->GetNumberOfValues(), vtkIdType(volume.values.size()));
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    ASSERT_EQ(values->GetVariantValue(i).ToDouble(), volume.values[std::size_t(i)])
      << "value " << i;
  }
}

void ExpectVoxelsOfFile(const std::string& path, const StoredVolume& volume)
{
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(path.c_str());
  ExpectVoxels(reader, volume);
}

TEST(VolumeFileEncodings, NrrdOfEveryTypeByteOrderAndEncoding)
{
  const TemporaryFolder folder;
  for (const int type : types)
  {
    const StoredVolume volume = VolumeOfType(type);
    for (const bool isBig : { false, true })
    {
      SCOPED_TRACE(vtkImageScalarTypeNameMacro(type));
      const std::string header =
        NrrdHeaderText(volume) + (isBig ? "endian: big\n" : "endian: little\n");
      const std::string voxels = VoxelBytes(volume, isBig);
      ExpectVoxelsOfFile(folder.Write("raw.nrrd", header + "encoding: raw\n\n" + voxels), volume);
      ExpectVoxelsOfFile(
        folder.Write("gzip.nrrd", header + "encoding: gzip\n\n" + Gzipped(voxels)), volume);
      ExpectVoxelsOfFile(
        folder.Write("text.nrrd", header + "encoding: ascii\n\n" + VoxelText(volume)), volume);
    }
  }
}

TEST(VolumeFileEncodings, NrrdWithItsVoxelsElsewhere)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  const std::string header = NrrdHeaderText(volume) + "endian: little\n";
  const std::string voxels = VoxelBytes(volume);
  folder.Write("voxels.raw", voxels);
  folder.Write("behind.raw", "two\nlines\nxyz" + voxels);
  folder.Write("end.raw", "who knows how much" + voxels);
  folder.Write("voxels.gz", Gzipped("xyz" + voxels));
  const std::size_t sliceBytes = voxels.size() / 3;
  for (int slice = 0; slice < 3; ++slice)
  {
    folder.Write(
      "slice0" + std::to_string(slice) + ".raw", voxels.substr(slice * sliceBytes, sliceBytes));
  }
  const char* const tails[] = {
    "encoding: raw\ndata file: voxels.raw\n",
    "encoding: raw\nline skip: 2\nbyte skip: 3\ndata file: behind.raw\n",
    "encoding: raw\nbyteskip: -1\ndatafile: end.raw\n",
    "encoding: gz\nbyte skip: 3\ndata file: voxels.gz\n",
    "encoding: raw\ndata file: LIST\nslice00.raw\nslice01.raw\nslice02.raw\n",
    "encoding: raw\ndata file: slice%02d.raw 0 2 1\n",
  };
  for (const char* tail : tails)
  {
    SCOPED_TRACE(tail);
    ExpectVoxelsOfFile(folder.Write("phantom.nhdr", header + tail), volume);
  }
}

TEST(VolumeFileEncodings, MetaImageOfEveryTypeByteOrderAndEncoding)
{
  const TemporaryFolder folder;
  for (const int type : types)
  {
    const StoredVolume volume = VolumeOfType(type);
    for (const bool isBig : { false, true })
    {
      SCOPED_TRACE(vtkImageScalarTypeNameMacro(type));
      const std::string header =
        MetaImageHeaderText(volume) + "BinaryDataByteOrderMSB = " + (isBig ? "True\n" : "False\n");
      const std::string voxels = VoxelBytes(volume, isBig);
      folder.Write("voxels.raw", voxels);
      folder.Write("voxels.zraw", Zlibbed(voxels));
      ExpectVoxelsOfFile(
        folder.Write("local.mha", header + "ElementDataFile = LOCAL\n" + voxels), volume);
      ExpectVoxelsOfFile(
        folder.Write("raw.mhd", header + "ElementDataFile = voxels.raw\n"), volume);
      ExpectVoxelsOfFile(
        folder.Write("zlib.mha",
          header + "CompressedData = True\nElementDataFile = LOCAL\n" + Zlibbed(voxels)),
        volume);
      ExpectVoxelsOfFile(
        folder.Write("zlib.mhd", header + "CompressedData = True\nElementDataFile = voxels.zraw\n"),
        volume);
      ExpectVoxelsOfFile(
        folder.Write(
          "text.mha", header + "BinaryData = False\nElementDataFile = LOCAL\n" + VoxelText(volume)),
        volume);
    }
  }
}

TEST(VolumeFileEncodings, MetaImageWithTheNamesOfOldFiles)
{
  const TemporaryFolder folder;
  StoredVolume volume = phantom::Stored(0);
  const std::string voxels = VoxelBytes(volume);
  vtkNew<vtkVolumeFileReader> reader;
  const std::string path = folder.Write("old.mhd",
    "NDims = 3\nDimSize = 5 4 3\nElementSpacing = 1 2 3\nPosition = 7 8 9\n"
    "Orientation = 0 1 0 -1 0 0 0 0 1\nElementByteOrderMSB = False\nElementType = MET_SHORT\n"
    "HeaderSize = -1\nElementDataFile = old.raw\n");
  folder.Write("old.raw", "a header of some length" + voxels);
  reader->SetFileName(path.c_str());
  ExpectVoxels(reader, volume);
  double worldMm[3];
  reader->GetOutput()->TransformIndexToPhysicalPoint(1, 1, 1, worldMm);
  EXPECT_DOUBLE_EQ(worldMm[0], 7.0 - 2.0);
  EXPECT_DOUBLE_EQ(worldMm[1], 8.0 + 1.0);
  EXPECT_DOUBLE_EQ(worldMm[2], 9.0 + 3.0);
}

TEST(VolumeFileEncodings, NiftiOfEveryTypeAndByteOrder)
{
  const TemporaryFolder folder;
  for (const int type : types)
  {
    const StoredVolume volume = VolumeOfType(type);
    for (const bool isBig : { false, true })
    {
      SCOPED_TRACE(vtkImageScalarTypeNameMacro(type));
      const std::string bytes = NiftiBytes(volume, NiftiForm::Affine, isBig);
      ExpectVoxelsOfFile(folder.Write("phantom.nii", bytes), volume);
      ExpectVoxelsOfFile(folder.Write("phantom.nii.gz", Gzipped(bytes)), volume);
    }
  }
}

TEST(VolumeFileEncodings, VtiOfEveryType)
{
  const TemporaryFolder folder;
  for (const int type : types)
  {
    SCOPED_TRACE(vtkImageScalarTypeNameMacro(type));
    const StoredVolume volume = VolumeOfType(type);
    ExpectVoxelsOfFile(folder.Write("phantom.vti", VtiText(volume)), volume);
  }
}

TEST(VolumeFileEncodings, BareVoxelsAsTheCallerDescribesThem)
{
  const TemporaryFolder folder;
  for (const int type : types)
  {
    const StoredVolume volume = VolumeOfType(type);
    for (const bool isBig : { false, true })
    {
      SCOPED_TRACE(vtkImageScalarTypeNameMacro(type));
      vtkNew<vtkVolumeFileReader> reader;
      const std::string path = folder.Write("phantom.raw", "head" + VoxelBytes(volume, isBig));
      reader->SetFileName(path.c_str());
      reader->SetRawDimensions(5, 4, 3);
      reader->SetRawScalarType(type);
      reader->SetRawSpacing(0.5, 0.75, 2.0);
      reader->SetRawHeaderBytes(4);
      reader->SetRawBigEndian(isBig);
      ExpectVoxels(reader, volume);
      EXPECT_EQ(reader->GetOutput()->GetSpacing()[1], 0.75);
    }
  }
}

}
