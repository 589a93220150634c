// Files that end too early, where one file alone does not show it: headers with a second file of
// voxels, and pictures with a thumbnail.

#include "PhantomFormats.h"
#include "PhantomLibraryFiles.h"
#include "VolumeRead.h"

#include <gtest/gtest.h>

namespace
{

struct NamedBytes
{
  std::string name;
  std::string bytes;
};

/// A header and its voxels.
struct FilePair
{
  NamedBytes header;
  NamedBytes voxels;
  std::size_t spareBytes = 0; ///< redundant bytes at the end of the voxels
};

std::vector<FilePair> FilePairs()
{
  const StoredVolume volume = phantom::Stored(0);
  const std::string voxels = VoxelBytes(volume);
  const std::string nrrd = NrrdHeaderText(volume) + "endian: little\nencoding: raw\n";
  return {
    { { "a+orig.HEAD", AfniHeaderText(volume) }, { "a+orig.BRIK", voxels } },
    { { "b+orig.HEAD", AfniHeaderText(volume) }, { "b+orig.BRIK.gz", Gzipped(voxels) }, 12 },
    { { "a.PAR", ParText(volume, { 0, 1, 2 }) }, { "a.REC", voxels } },
    { { "a.nhdr", nrrd + "data file: a.raw\n" }, { "a.raw", voxels } },
    { { "zarr/.zarray", ZarrArrayText(volume, "null") }, { "zarr/0.0.0", voxels } },
    { { "b.mhd", MetaImageHeaderText(volume) + "ElementDataFile = b.raw\n" }, { "b.raw", voxels } },
  };
}

/// A file that was cut is refused, or what is missing was not needed.
void ExpectRefusedOrWhole(const std::string& path, const VolumeRead& whole)
{
  const VolumeRead cut = ReadVolumeAt(path);
  if (cut.error.empty())
  {
    EXPECT_EQ(cut.values, whole.values);
    EXPECT_EQ(cut.spacingMm, whole.spacingMm);
    EXPECT_EQ(cut.originMm, whole.originMm);
  }
}

}

TEST(CutVolumeFiles, OfVoxelsAreRefusedWhereverTheyEnd)
{
  const TemporaryFolder folder;
  for (const FilePair& pair : FilePairs())
  {
    const std::string header = folder.Write(pair.header.name, pair.header.bytes);
    folder.Write(pair.voxels.name, pair.voxels.bytes);
    ASSERT_EQ(ReadVolumeAt(header).error, "") << header;
    for (std::size_t size = 0; size + pair.spareBytes < pair.voxels.bytes.size(); ++size)
    {
      folder.Write(pair.voxels.name, pair.voxels.bytes.substr(0, size));
      const std::string error = ReadVolumeAt(header).error;
      EXPECT_NE(error.find(pair.voxels.name), std::string::npos)
        << pair.voxels.name << " cut to " << size << ": " << error;
    }
  }
}

TEST(CutVolumeFiles, OfHeadersAreRefusedOrReadAsTheyWere)
{
  const TemporaryFolder folder;
  for (const FilePair& pair : FilePairs())
  {
    folder.Write(pair.voxels.name, pair.voxels.bytes);
    const std::string path = folder.Write(pair.header.name, pair.header.bytes);
    const VolumeRead whole = ReadVolumeAt(path);
    for (std::size_t size = 0; size < pair.header.bytes.size(); ++size)
    {
      SCOPED_TRACE(pair.header.name + " cut to " + std::to_string(size));
      folder.Write(pair.header.name, pair.header.bytes.substr(0, size));
      ExpectRefusedOrWhole(path, whole);
    }
  }
}

// Cameras write a small picture, with its own end mark, into the header.
TEST(CutVolumeFiles, AreRefusedWhereOnlyAThumbnailIsWhole)
{
  const TemporaryFolder folder;
  StoredVolume volume = phantom::Stored(0);
  volume.scalarType = VTK_UNSIGNED_CHAR;
  WritePicture(folder.Path("a.jpg"), volume, 0);
  const std::string picture = folder.Bytes("a.jpg");
  const std::string thumbnail = "Exif" + std::string(2, '\0') + picture;
  const std::size_t length = thumbnail.size() + 2;
  const std::string bytes = picture.substr(0, 2) + "\xff\xe1" + char(length / 256) +
    char(length % 256) + thumbnail + picture.substr(2);
  EXPECT_EQ(ReadVolumeAt(folder.Write("camera.jpg", bytes)).error, "");
  // Each reading starts a decoder, so not all sizes are tried.
  for (std::size_t size = 0; size < bytes.size(); size += 5)
  {
    EXPECT_NE(ReadVolumeAt(folder.Write("camera.jpg", bytes.substr(0, size))).error, "") << size;
  }
}
