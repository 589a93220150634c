// All types, byte orders and encodings of a format give the same values.
#include "PhantomFiles.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>
#include <vtkXMLWriter.h>

#include <gtest/gtest.h>

#include <limits>

namespace
{

constexpr int types[] = { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
  VTK_INT, VTK_UNSIGNED_INT, VTK_FLOAT, VTK_DOUBLE };

/// A volume whose values reach the limits of their type.
StoredVolume FullRangeVolume(int scalarType)
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
    const StoredVolume volume = FullRangeVolume(type);
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
    const StoredVolume volume = FullRangeVolume(type);
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

TEST(VolumeFileEncodings, MetaImageOfAPlaneWithNumbersForThreeAxes)
{
  // MetaIO reads as many numbers as there are dimensions.
  const TemporaryFolder folder;
  StoredVolume slice = phantom::Stored(0);
  slice.values.resize(20);
  const std::string path = folder.Write("plane.mha",
    "NDims = 2\nDimSize = 5 4\nElementSpacing = 0.5 2 1\nElementType = MET_SHORT\n"
    "ElementToIntensityFunctionSlope = 2\nElementDataFile = LOCAL\n" +
      VoxelBytes(slice));
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(path.c_str());
  ExpectVoxels(reader, slice);
  EXPECT_EQ(reader->GetOutput()->GetSpacing()[1], 2.0);
  const std::string warning = reader->GetWarnings()->GetValue(1);
  EXPECT_NE(warning.find("was not applied"), std::string::npos) << warning;
}

TEST(VolumeFileEncodings, NiftiOfEveryTypeAndByteOrder)
{
  const TemporaryFolder folder;
  for (const int type : types)
  {
    const StoredVolume volume = FullRangeVolume(type);
    for (const bool isBig : { false, true })
    {
      SCOPED_TRACE(vtkImageScalarTypeNameMacro(type));
      const std::string bytes = NiftiBytes(volume, NiftiForm::Affine, isBig);
      ExpectVoxelsOfFile(folder.Write("phantom.nii", bytes), volume);
      ExpectVoxelsOfFile(folder.Write("phantom.nii.gz", Gzipped(bytes)), volume);
    }
  }
}

TEST(VolumeFileEncodings, Nifti2OfEveryTypeAndByteOrder)
{
  const TemporaryFolder folder;
  for (const int type : types)
  {
    const StoredVolume volume = FullRangeVolume(type);
    for (const bool isBig : { false, true })
    {
      SCOPED_TRACE(vtkImageScalarTypeNameMacro(type));
      ExpectVoxelsOfFile(folder.Write("phantom.nii", Nifti2Bytes(volume, isBig)), volume);
    }
  }
}

TEST(VolumeFileEncodings, NiftiPairByEitherOfItsFiles)
{
  const StoredVolume volume = phantom::Stored(0);
  std::string header = NiftiBytes(volume).substr(0, 348);
  header.replace(108, 4, 4, '\0'); // vox_offset
  header.replace(344, 3, "ni1");
  const std::string voxels = VoxelBytes(volume);
  const TemporaryFolder plain;
  plain.Write("head.hdr", header);
  plain.Write("head.img", voxels);
  const TemporaryFolder gzipped;
  gzipped.Write("head.hdr.gz", Gzipped(header));
  gzipped.Write("head.img.gz", Gzipped(voxels));
  for (const std::string& path : { plain.Path("head.hdr"), plain.Path("head.img"),
         gzipped.Path("head.hdr.gz"), gzipped.Path("head.img.gz") })
  {
    SCOPED_TRACE(path);
    ExpectVoxelsOfFile(path, volume);
  }
}

TEST(VolumeFileEncodings, VtiOfEveryType)
{
  const TemporaryFolder folder;
  for (const int type : types)
  {
    SCOPED_TRACE(vtkImageScalarTypeNameMacro(type));
    const StoredVolume volume = FullRangeVolume(type);
    ExpectVoxelsOfFile(folder.Write("phantom.vti", VtiText(volume)), volume);
  }
}

TEST(VolumeFileEncodings, VtiInEveryWayThatVtkWritesIt)
{
  const TemporaryFolder folder;
  StoredVolume volume = FullRangeVolume(VTK_SHORT);
  const std::string voxels = VoxelBytes(volume);
  for (const VtiEncoding& way :
    { VtiEncoding{ vtkXMLWriter::Ascii }, VtiEncoding{ vtkXMLWriter::Binary },
      VtiEncoding{ vtkXMLWriter::Appended, true }, VtiEncoding{ vtkXMLWriter::Appended, false } })
  {
    for (const int compressor :
      { vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA })
    {
      for (const bool isBig : { false, true })
      {
        for (const int headerBits : { 32, 64 })
        {
          SCOPED_TRACE(testing::Message()
            << "mode " << way.dataMode << " base64 " << way.base64 << " compressor " << compressor
            << " big " << isBig << " header " << headerBits);
          const VtiEncoding encoding = { way.dataMode, way.base64, compressor, isBig, headerBits };
          ExpectVoxelsOfFile(
            folder.Write("phantom.vti", EncodedVti(volume, voxels, encoding)), volume);
        }
      }
    }
  }
}

/// Integers whose neighbours a double cannot distinguish.
template <class Integer>
std::vector<Integer> LongIntegers(std::size_t count)
{
  std::vector<Integer> integers;
  for (std::size_t i = 0; i < count; ++i)
  {
    integers.push_back(i % 2 == 0 ? Integer(std::numeric_limits<Integer>::max() - Integer(i))
                                  : Integer(std::numeric_limits<Integer>::min() + Integer(i)));
  }
  return integers;
}

template <class Integer>
void ExpectLongIntegers(
  vtkVolumeFileReader* reader, const std::string& path, const std::vector<Integer>& integers)
{
  SCOPED_TRACE(path);
  reader->SetFileName(path.c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
  vtkDataArray* values = reader->GetOutput()->GetPointData()->GetScalars();
  ASSERT_EQ(values->GetNumberOfValues(), vtkIdType(integers.size()));
  ASSERT_EQ(values->GetDataTypeSize(), int(sizeof(Integer)));
  const auto* read = static_cast<const Integer*>(values->GetVoidPointer(0));
  EXPECT_EQ(std::vector<Integer>(read, read + integers.size()), integers);
}

/// Checks every format that supports 64-bit integers.
template <class Integer>
void ExpectLongIntegersInEveryFormat(int scalarType)
{
  const TemporaryFolder folder;
  StoredVolume header = phantom::Stored(0);
  header.scalarType = scalarType;
  const std::vector<Integer> integers = LongIntegers<Integer>(header.values.size());
  const std::string voxels(
    reinterpret_cast<const char*>(integers.data()), integers.size() * sizeof(Integer));
  std::string text;
  for (const Integer integer : integers)
  {
    text += std::to_string(integer) + ' ';
  }
  const std::string nrrd = NrrdHeaderText(header) + "endian: little\nencoding: ";
  const std::string metaImage = MetaImageHeaderText(header);
  const VtiEncoding ascii = { vtkXMLWriter::Ascii };
  const VtiEncoding zlib = { vtkXMLWriter::Appended, false, vtkXMLWriter::ZLIB };
  vtkNew<vtkVolumeFileReader> reader;
  for (const std::string& path :
    { folder.Write("raw.nrrd", nrrd + "raw\n\n" + voxels),
      folder.Write("text.nrrd", nrrd + "ascii\n\n" + text),
      folder.Write("raw.mha", metaImage + "ElementDataFile = LOCAL\n" + voxels),
      folder.Write("text.mha", metaImage + "BinaryData = False\nElementDataFile = LOCAL\n" + text),
      folder.Write("1.nii", NiftiBytes(header).substr(0, 352) + voxels),
      folder.Write("2.nii", Nifti2Bytes(header).substr(0, 544) + voxels),
      folder.Write("ascii.vti", EncodedVti(header, voxels, ascii)),
      folder.Write("zlib.vti", EncodedVti(header, voxels, zlib)) })
  {
    ExpectLongIntegers(reader, path, integers);
  }
  reader->SetRawDimensions(5, 4, 3);
  reader->SetRawScalarType(scalarType);
  ExpectLongIntegers(reader, folder.Write("voxels.raw", voxels), integers);
}

TEST(VolumeFileEncodings, IntegersOf64BitsKeepTheirLastBit)
{
  ExpectLongIntegersInEveryFormat<vtkTypeInt64>(VTK_TYPE_INT64);
  ExpectLongIntegersInEveryFormat<vtkTypeUInt64>(VTK_TYPE_UINT64);
}

TEST(VolumeFileEncodings, BareVoxelsAsTheCallerDescribesThem)
{
  const TemporaryFolder folder;
  for (const int type : types)
  {
    const StoredVolume volume = FullRangeVolume(type);
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
