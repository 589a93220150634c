// TIFF files, and folders of pictures.
#include "PhantomLibraryFiles.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkVolumeFileReader.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace
{

StoredVolume VolumeOfType(int scalarType)
{
  StoredVolume volume = phantom::Stored(0);
  volume.scalarType = scalarType;
  return volume;
}

void Read(vtkVolumeFileReader* reader, const std::string& path)
{
  reader->SetFileName(path.c_str());
  reader->Update();
  ASSERT_STREQ(reader->GetErrorMessage(), "");
}

void ExpectValues(
  vtkVolumeFileReader* reader, const std::vector<double>& values, double tolerance = 0.0)
{
  vtkDataArray* const scalars = reader->GetOutput()->GetPointData()->GetScalars();
  ASSERT_EQ(scalars->GetNumberOfValues(), vtkIdType(values.size()));
  for (vtkIdType i = 0; i < scalars->GetNumberOfValues(); ++i)
  {
    ASSERT_NEAR(scalars->GetVariantValue(i).ToDouble(), values[std::size_t(i)], tolerance) << i;
  }
}

void ExpectSpacing(vtkVolumeFileReader* reader, double x, double y, double z)
{
  const double* const spacing = reader->GetOutput()->GetSpacing();
  EXPECT_NEAR(spacing[0], x, 1e-6 * x);
  EXPECT_NEAR(spacing[1], y, 1e-6 * y);
  EXPECT_NEAR(spacing[2], z, 1e-6 * z);
}

bool Warns(vtkVolumeFileReader* reader, const std::string& words)
{
  for (vtkIdType i = 0; i < reader->GetWarnings()->GetNumberOfValues(); ++i)
  {
    if (reader->GetWarnings()->GetValue(i).find(words) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}

/// The volume with its 60 values as 20 x 1 x 3 voxels, or in other sizes.
StoredVolume Shaped(const StoredVolume& volume, int x, int y, int z)
{
  StoredVolume shaped = volume;
  shaped.dimensions = { x, y, z };
  return shaped;
}

TEST(ImageStacks, TiffOfEveryTypeAndForm)
{
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.tif");
  for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_INT, VTK_UNSIGNED_INT, VTK_FLOAT, VTK_DOUBLE })
  {
    const StoredVolume volume = VolumeOfType(type);
    for (const bool isOther : { false, true })
    {
      WriteTiff(path, volume, { "", 1, false, isOther, isOther ? 8 : 1, isOther, isOther });
      vtkNew<vtkVolumeFileReader> reader;
      Read(reader, path);
      EXPECT_EQ(reader->GetOutput()->GetScalarType(), type);
      ExpectValues(reader, volume.values);
      EXPECT_TRUE(Warns(reader, "1 mm"));
    }
  }
}

TEST(ImageStacks, TiffColoursAreComponents)
{
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.tif");
  const StoredVolume volume = Shaped(VolumeOfType(VTK_UNSIGNED_CHAR), 5, 2, 2);
  for (const bool isPlanar : { false, true })
  {
    for (const bool isTiled : { false, true })
    {
      WriteTiff(path, volume, { "", 3, isPlanar, isTiled });
      vtkNew<vtkVolumeFileReader> reader;
      Read(reader, path);
      EXPECT_EQ(reader->GetOutput()->GetNumberOfScalarComponents(), 3);
      ExpectValues(reader, volume.values);
    }
  }
}

TEST(ImageStacks, TiffResolutionIsTheSizeOfPixels)
{
  const TemporaryFolder folder;
  TiffOptions options;
  options.pixelsPerCentimetre = 500.0;
  WriteTiff(folder.Path("a.tif"), VolumeOfType(VTK_SHORT), options);
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Path("a.tif"));
  ExpectSpacing(reader, 0.02, 0.02, 0.02);
  EXPECT_TRUE(Warns(reader, "0.02 mm"));
}

TEST(ImageStacks, TheDescriptionOfImageJGivesSpacingChannelsAndTimes)
{
  const TemporaryFolder folder;
  const StoredVolume volume = Shaped(VolumeOfType(VTK_UNSIGNED_SHORT), 5, 1, 12);
  TiffOptions options;
  options.description = "ImageJ=1.53t\nimages=12\nchannels=2\nslices=3\nframes=2\nhyperstack=true\n"
                        "unit=micron\nspacing=3.5\nloop=false\n";
  options.pixelsPerCentimetre = 2.0; // ImageJ's unit replaces the centimetre
  WriteTiff(folder.Path("a.tif"), volume, options);
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Path("a.tif"));
  ExpectSpacing(reader, 0.0005, 0.0005, 0.0035);
  EXPECT_EQ(reader->GetNumberOfTimes(), 2);
  vtkImageData* const image = reader->GetOutput();
  ASSERT_EQ(image->GetNumberOfScalarComponents(), 2);
  ASSERT_EQ(image->GetNumberOfPoints(), 15);
  EXPECT_EQ(image->GetScalarComponentAsDouble(3, 0, 2, 1), volume.values[5 * 5 + 3]);
}

/// A big-endian TIFF file with one directory, whose pixels end the file.
std::string TiffOfOneDirectory(const StoredVolume& volume, const std::string& description)
{
  const auto number = [](std::size_t value, int byteCount)
  {
    std::string bytes;
    for (int i = byteCount - 1; i >= 0; --i)
    {
      bytes += char(value >> (8 * i));
    }
    return bytes;
  };
  constexpr std::size_t shortType = 3;
  constexpr std::size_t longType = 4;
  constexpr std::size_t textBegin = 8 + 2 + 7 * 12 + 4;
  const std::size_t pixelBegin = textBegin + description.size();
  const auto entry = [&](std::size_t tag, std::size_t type, std::size_t value)
  {
    const int valueBytes = type == shortType ? 2 : 4;
    return number(tag, 2) + number(type, 2) + number(1, 4) + number(value, valueBytes) +
      std::string(std::size_t(4 - valueBytes), '\0');
  };
  return std::string("MM\0*", 4) + number(8, 4) + number(7, 2) +
    entry(256, shortType, std::size_t(volume.dimensions[0])) +
    entry(257, shortType, std::size_t(volume.dimensions[1])) + entry(258, shortType, 16) +
    entry(262, shortType, 1) + number(270, 2) + number(2, 2) + number(description.size(), 4) +
    number(textBegin, 4) + entry(273, longType, pixelBegin) +
    entry(279, longType, std::size_t(2 * volume.dimensions[0] * volume.dimensions[1])) +
    number(0, 4) + description + VoxelBytes(volume, true);
}

TEST(ImageStacks, PagesOfImageJWithoutDirectoriesAreRead)
{
  const TemporaryFolder folder;
  const StoredVolume volume = VolumeOfType(VTK_UNSIGNED_SHORT);
  const std::string bytes = TiffOfOneDirectory(volume, "ImageJ=1.53t\nimages=3\nslices=3\n");
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Write("a.tif", bytes));
  ExpectValues(reader, volume.values);
  EXPECT_EQ(reader->GetOutput()->GetDimensions()[2], 3);
}

TEST(ImageStacks, OmeGivesTheOrderOfPagesAndTheSpacing)
{
  const TemporaryFolder folder;
  const StoredVolume volume = Shaped(VolumeOfType(VTK_UNSIGNED_SHORT), 5, 1, 12);
  TiffOptions options;
  options.description =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>"
    "<OME xmlns=\"http://www.openmicroscopy.org/Schemas/OME/2016-06\"><Image ID=\"Image:0\">"
    "<Pixels ID=\"Pixels:0\" DimensionOrder=\"XYTZC\" Type=\"uint16\" SizeX=\"5\" SizeY=\"1\" "
    "SizeZ=\"3\" SizeC=\"2\" SizeT=\"2\" PhysicalSizeX=\"0.5\" PhysicalSizeY=\"0.25\" "
    "PhysicalSizeZ=\"2\" PhysicalSizeZUnit=\"mm\"><TiffData/></Pixels></Image></OME>";
  WriteTiff(folder.Path("a.ome.tif"), volume, options);
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Path("a.ome.tif"));
  ExpectSpacing(reader, 0.0005, 0.00025, 2.0);
  EXPECT_EQ(reader->GetNumberOfTimes(), 2);
  vtkImageData* const image = reader->GetOutput();
  ASSERT_EQ(image->GetNumberOfScalarComponents(), 2);
  // Page of time 0, slice 2, channel 1 in the order of time, slice, channel.
  EXPECT_EQ(
    image->GetScalarComponentAsDouble(3, 0, 2, 1), volume.values[(0 + 2 * (2 + 3 * 1)) * 5 + 3]);
}

TEST(ImageStacks, AFolderOfPicturesIsInTheNaturalOrderOfNames)
{
  for (const char* const extension : { ".png", ".bmp", ".jpg", ".tif" })
  {
    SCOPED_TRACE(extension);
    const TemporaryFolder folder;
    const StoredVolume volume = VolumeOfType(VTK_UNSIGNED_CHAR);
    const int numbers[3] = { 8, 9, 10 };
    for (int slice = 0; slice < 3; ++slice)
    {
      const std::string path = folder.Path("s" + std::to_string(numbers[slice]) + extension);
      if (std::string(extension) == ".tif")
      {
        StoredVolume page = Shaped(volume, 5, 4, 1);
        page.values.assign(
          volume.values.begin() + slice * 20, volume.values.begin() + (slice + 1) * 20);
        WriteTiff(path, page);
      }
      else
      {
        WritePicture(path, volume, slice);
      }
    }
    folder.Write("notes.txt", "of no picture");
    vtkNew<vtkVolumeFileReader> reader;
    Read(reader, folder.Path(""));
    const bool isLossy = std::string(extension) == ".jpg";
    ExpectValues(reader, volume.values, isLossy ? 3.0 : 0.0);
    EXPECT_TRUE(Warns(reader, "1 mm"));
  }
}

TEST(ImageStacks, ColoursOfPicturesAreComponents)
{
  const TemporaryFolder folder;
  const StoredVolume volume = Shaped(VolumeOfType(VTK_UNSIGNED_CHAR), 5, 2, 2);
  WritePicture(folder.Path("1.png"), volume, 0);
  WritePicture(folder.Path("2.png"), volume, 1);
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Path(""));
  EXPECT_EQ(reader->GetOutput()->GetNumberOfScalarComponents(), 3);
  ExpectValues(reader, volume.values);
}

TEST(ImageStacks, OtherPicturesAreNamedAndLeftOut)
{
  const TemporaryFolder folder;
  const StoredVolume volume = VolumeOfType(VTK_UNSIGNED_CHAR);
  for (int slice = 0; slice < 3; ++slice)
  {
    WritePicture(folder.Path("s" + std::to_string(slice) + ".png"), volume, slice);
  }
  WritePicture(folder.Path("scout.png"), Shaped(volume, 4, 5, 3), 0);
  folder.Write("cut.png", folder.Bytes("s1.png").substr(0, 60));
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Path(""));
  ExpectValues(reader, volume.values);
  EXPECT_TRUE(Warns(reader, "scout.png"));
  EXPECT_TRUE(Warns(reader, "cut.png"));
}

TEST(ImageStacks, AreInTheOrderOfTheirNumbersAlsoBelowZero)
{
  const std::array<const char*, 3> below = { "z-10.png", "z-5.png", "z0.png" };
  const std::array<const char*, 3> hyphens = { "z-5.png", "z-10.png", "z-20.png" }; // no signs
  for (const std::array<const char*, 3>& names : { below, hyphens })
  {
    const TemporaryFolder folder;
    const StoredVolume volume = VolumeOfType(VTK_UNSIGNED_CHAR);
    for (int slice = 0; slice < 3; ++slice)
    {
      WritePicture(folder.Path(names[std::size_t(slice)]), volume, slice);
    }
    vtkNew<vtkVolumeFileReader> reader;
    Read(reader, folder.Path(""));
    ExpectValues(reader, volume.values);
  }
}

TEST(ImageStacks, ThePreviewOfSkyScanIsNoSliceAndItsLogHasTheVoxel)
{
  const TemporaryFolder folder;
  const StoredVolume volume = VolumeOfType(VTK_UNSIGNED_CHAR);
  for (int slice = 0; slice < 3; ++slice)
  {
    WritePicture(folder.Path("a_rec0000000" + std::to_string(slice) + ".bmp"), volume, slice);
  }
  WritePicture(folder.Path("a_rec_spr.bmp"), volume, 0);
  folder.Write("a_rec.log",
    "[Acquisition]\r\nImage Pixel Size (um)=7\r\n[Reconstruction]\r\nPixel Size (um)=9.92\r\n");
  vtkNew<vtkVolumeFileReader> reader;
  Read(reader, folder.Path(""));
  ExpectValues(reader, volume.values);
  ExpectSpacing(reader, 9.92e-3, 9.92e-3, 9.92e-3);
  EXPECT_TRUE(Warns(reader, "a_rec_spr.bmp"));
  EXPECT_FALSE(Warns(reader, "1 mm"));
}

}
