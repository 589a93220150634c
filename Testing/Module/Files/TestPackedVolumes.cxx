// Archives, compressed files and folders are read as what they hold, and leave nothing behind.
#include "PhantomFiles.h"
#include "VolumeRead.h"

#include <gtest/gtest.h>

namespace
{

std::string NrrdText(const StoredVolume& volume)
{
  return NrrdHeaderText(volume) + "endian: little\nencoding: raw\n\n" + VoxelBytes(volume);
}

std::vector<ArchiveEntry> DicomEntries(const StoredVolume& volume, const std::string& folder)
{
  std::vector<ArchiveEntry> entries = { { "README.TXT", "a disc" } };
  for (int slice = 0; slice < volume.dimensions[2]; ++slice)
  {
    entries.push_back({ folder + "/" + std::to_string(slice), DicomBytes(volume, slice) });
  }
  return entries;
}

std::vector<ArchiveEntry> MetaImageEntries(const StoredVolume& volume)
{
  return { { "a/head.mhd", MetaImageHeaderText(volume) + "ElementDataFile = voxels.raw\n" },
    { "a/voxels.raw", VoxelBytes(volume) } };
}

TEST(PackedVolumes, EveryCompressionOfEveryFormatHasTheSameVoxels)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  StoredVolume slice = volume;
  slice.dimensions[2] = 1;
  slice.values.resize(20);
  for (const auto& [bytes, values] : { std::pair(NrrdText(volume), volume.values),
         std::pair(MetaImageHeaderText(volume) + "ElementDataFile = LOCAL\n" + VoxelBytes(volume),
           volume.values),
         std::pair(VtiText(volume), volume.values), std::pair(NiftiBytes(volume), volume.values),
         std::pair(DicomBytes(volume, 0), slice.values) })
  {
    for (const char* filter : { "gzip", "bzip2", "xz", "zstd" })
    {
      SCOPED_TRACE(std::string(filter) + " of " + bytes.substr(0, 8));
      const VolumeRead read = ReadVolumeAt(folder.Write("noname", Compressed(bytes, filter)));
      EXPECT_EQ(read.error, "");
      EXPECT_EQ(read.values, values);
    }
  }
}

TEST(PackedVolumes, AnArchiveIsReadAsAFolder)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  const std::string longFolder(120, 'x');
  for (const auto& [format, filter] : { std::pair("zip", ""), std::pair("pax", "gzip"),
         std::pair("gnutar", "bzip2"), std::pair("v7tar", "") })
  {
    SCOPED_TRACE(format);
    const bool isOld = std::string(format) == "v7tar"; // names of at most 100 characters
    for (const auto& entries :
      { DicomEntries(volume, isOld ? "x" : longFolder), MetaImageEntries(volume) })
    {
      const std::string path = folder.Write("archive.bin", Archived(entries, format, filter));
      const VolumeRead read = ReadVolumeAt(path);
      EXPECT_EQ(read.error, "");
      EXPECT_EQ(read.values, volume.values);
      EXPECT_TRUE(vtkVolumeFileReader::CanReadFile(path.c_str()));
      EXPECT_STREQ(vtkVolumeFileReader::GetFormatOfFile(path.c_str()), "archive");
    }
  }
}

TEST(PackedVolumes, AFolderOfCompressedSlicesIsOneVolume)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  for (int slice = 0; slice < volume.dimensions[2]; ++slice)
  {
    folder.Write("study/" + std::to_string(slice) + ".dcm.gz", Gzipped(DicomBytes(volume, slice)));
  }
  const VolumeRead read = ReadVolumeAt(folder.Path("study"));
  EXPECT_EQ(read.error, "");
  EXPECT_EQ(read.values, volume.values);
}

TEST(PackedVolumes, TheFirstOfSeveralVolumesInAFolderIsReadWithAWarning)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  folder.Write("scans/a.nrrd", NrrdText(volume));
  folder.Write("scans/b.nii", NiftiBytes(phantom::Stored(5)));
  const VolumeRead read = ReadVolumeAt(folder.Path("scans"));
  EXPECT_EQ(read.values, volume.values);
  EXPECT_TRUE(read.WarnsOf("holds 2 volumes; only a.nrrd was read")) << read.warnings;
}

TEST(PackedVolumes, EntriesThatLeadOutOfTheirArchiveAreLeftOut)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  std::string up;
  for (int i = 0; i < 20; ++i)
  {
    up += "../";
  }
  const std::string outside = folder.Path("outside");
  const std::vector<ArchiveEntry> entries = { { up + outside, "evil" }, { outside, "evil" },
    { "link", "", folder.Path(".") }, { "link/outside", "evil" }, { "a.nrrd", NrrdText(volume) } };
  for (const char* format : { "zip", "pax" })
  {
    SCOPED_TRACE(format);
    const VolumeRead read = ReadVolumeAt(folder.Write("evil", Archived(entries, format)));
    EXPECT_EQ(read.values, volume.values) << read.error;
    EXPECT_TRUE(read.WarnsOf("3 of the archive's entries were left out")) << read.warnings;
    EXPECT_FALSE(std::filesystem::exists(outside));
  }
}

TEST(PackedVolumes, AnEntryLargerThanTheMemoryIsRefusedBeforeItIsUnpacked)
{
  // The size is in base 256 in the bytes from 124, and the checksum in octal from 148.
  std::string bytes = Archived({ { "a.nii", "short" } }, "gnutar");
  bytes.replace(124, 12, std::string("\x80\0\0\0\0\0\x40\0\0\0\0\0", 12));
  bytes.replace(148, 8, 8, ' ');
  unsigned sum = 0;
  for (int i = 0; i < 512; ++i)
  {
    sum += static_cast<unsigned char>(bytes[std::size_t(i)]);
  }
  char digits[8];
  std::snprintf(digits, sizeof(digits), "%06o", sum);
  bytes.replace(148, 7, digits, 7);
  const TemporaryFolder folder;
  const VolumeRead read = ReadVolumeAt(folder.Write("bomb.tar", bytes));
  EXPECT_NE(read.error.find("fits in the free memory of"), std::string::npos) << read.error;
}

TEST(PackedVolumes, CutArchivesAreRefused)
{
  const TemporaryFolder folder;
  const auto entries = DicomEntries(phantom::Stored(0), "images");
  for (const char* format : { "zip", "gnutar" })
  {
    const std::string bytes = Archived(entries, format);
    // Tar ends with two empty blocks, and blocks that fill up its last record.
    const std::size_t end = bytes.find_last_not_of('\0') + 1;
    for (std::size_t size = 600; size < end - 600; size += end / 20)
    {
      SCOPED_TRACE(std::string(format) + " cut to " + std::to_string(size));
      EXPECT_NE(ReadVolumeAt(folder.Write("cut", bytes.substr(0, size))).error, "");
    }
  }
}

TEST(PackedVolumes, AZipArchiveCutBetweenTwoEntriesIsRefused)
{
  const TemporaryFolder folder;
  const std::string bytes = Archived(DicomEntries(phantom::Stored(0), "images"), "zip");
  const VolumeRead read =
    ReadVolumeAt(folder.Write("cut.zip", bytes.substr(0, bytes.rfind("PK\3\4"))));
  EXPECT_NE(read.error.find("without its end"), std::string::npos) << read.error;
}

TEST(PackedVolumes, MessagesNameTheArchiveAndNotTheCopy)
{
  const TemporaryFolder folder;
  const std::string path = folder.Write(
    "scan.zip", Archived({ { "a/head.nrrd", NrrdHeaderText(phantom::Stored(0)) + "\n" } }, "zip"));
  const VolumeRead read = ReadVolumeAt(path);
  EXPECT_EQ(read.error.find("Cannot read \"" + path + "/a/head.nrrd\""), 0u) << read.error;
}

TEST(PackedVolumes, SeriesOfABrokenArchiveAreRefusedByItsName)
{
  const TemporaryFolder folder;
  const std::string path = folder.Write(
    "disc.zip", Archived({ { "a.dcm", DicomBytes(phantom::Stored(0), 0).substr(0, 200) } }, "zip"));
  const ExpectedVtkErrors errors;
  vtkNew<vtkVolumeFileReader> reader;
  reader->SetFileName(path.c_str());
  EXPECT_TRUE(reader->ListDICOMSeries().empty());
  EXPECT_EQ(std::string(reader->GetErrorMessage()).find("Cannot read \"" + path), 0u)
    << reader->GetErrorMessage();
}

TEST(PackedVolumes, CopiesOfAnArchiveExistAsLongAsItsReader)
{
  const TemporaryFolder folder;
  const std::string path =
    folder.Write("disc.zip", Archived(DicomEntries(phantom::Stored(0), "images"), "zip"));
  std::string middle;
  {
    vtkNew<vtkVolumeFileReader> reader;
    reader->SetFileName(path.c_str());
    const auto series = reader->ListDICOMSeries();
    ASSERT_EQ(series.size(), 1u) << reader->GetErrorMessage();
    middle = series.front().MiddleFile;
    EXPECT_TRUE(std::filesystem::exists(middle));
  }
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(middle).parent_path()));
}

}
