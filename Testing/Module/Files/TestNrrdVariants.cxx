// NRRD's many ways to state axes, places and encodings. Where the format leaves a choice, the right
// value is what teem's unu and Slicer make of the file.
#include "PhantomFiles.h"
#include "VolumeRead.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// A header of 5 x 4 x 3 shorts without sizes, place and kinds, which `more` states.
std::string Header(const std::string& more, const std::string& encoding = "raw")
{
  return "NRRD0005\ntype: short\nendian: little\n" + more + "encoding: " + encoding + "\n\n";
}

const std::string inSpace =
  "space directions: (0.7,0,0) (0,0.8,0) (0,0,2.5)\nspace origin: (-10,-20,30)\n";
const std::string afterOther =
  "space directions: none (0.7,0,0) (0,0.8,0) (0,0,2.5)\nspace origin: (-10,-20,30)\n";

/// Volumes whose values alternate voxel by voxel; the first is the phantom.
StoredVolume Alternating(int count)
{
  StoredVolume all = phantom::Stored(0);
  const std::vector<double> first = all.values;
  all.values.clear();
  for (const double value : first)
  {
    for (int i = 0; i < count; ++i)
    {
      all.values.push_back(value + 100.0 * i);
    }
  }
  return all;
}

class NrrdVariants : public testing::Test
{
protected:
  VolumeRead Read(const std::string& bytes)
  {
    return ReadVolumeAt(this->folder.Write("variant.nrrd", bytes));
  }

  TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
};

TEST_F(NrrdVariants, AListBeforeTheVolumeIsSeveralVolumes)
{
  for (const int count : { 3, 9 })
  {
    for (const char* axis : { "list", "time" })
    {
      const StoredVolume all = Alternating(count);
      const std::string more = "dimension: 4\nsizes: " + std::to_string(count) +
        " 5 4 3\nspace: LPS\nkinds: " + axis + " domain domain domain\n" + afterOther;
      for (const VolumeRead& read : { this->Read(Header(more) + VoxelBytes(all)),
             this->Read(Header(more, "ascii") + VoxelText(all)) })
      {
        EXPECT_EQ(read.error, "");
        EXPECT_EQ(read.values, this->volume.values);
        EXPECT_EQ(read.timeCount, count);
      }
    }
  }
}

TEST_F(NrrdVariants, AShortVectorBeforeTheVolumeIsItsComponents)
{
  const StoredVolume all = Alternating(3);
  const VolumeRead read = this->Read(Header("dimension: 4\nsizes: 3 5 4 3\nspace: LPS\n"
                                            "kinds: vector domain domain domain\n" +
                                       afterOther) +
    VoxelBytes(all));
  EXPECT_EQ(read.componentCount, 3);
  EXPECT_EQ(read.values, all.values);
}

TEST_F(NrrdVariants, TensorsAndComplexNumbersAreReadByTheirMagnitude)
{
  for (const auto& [kind, count] : { std::pair("3D-symmetric-matrix", 6), std::pair("complex", 2) })
  {
    const StoredVolume all = Alternating(count);
    const VolumeRead read =
      this->Read(Header("dimension: 4\nsizes: " + std::to_string(count) +
                   " 5 4 3\nspace: LPS\nkinds: " + kind + " domain domain domain\n" + afterOther) +
        VoxelBytes(all));
    ASSERT_EQ(read.values.size(), 60u) << read.error;
    double squares = 0.0;
    for (int i = 0; i < count; ++i)
    {
      squares += all.values[std::size_t(i)] * all.values[std::size_t(i)];
    }
    EXPECT_FLOAT_EQ(float(read.values.front()), float(std::sqrt(squares)));
    EXPECT_TRUE(read.WarnsOf("magnitude")) << read.warnings;
  }
}

TEST_F(NrrdVariants, AxisMinimaPlaceTheFirstSampleOrItsEdge)
{
  const std::string sizes = "dimension: 3\nsizes: 5 4 3\n";
  const std::string ends = "axis mins: -10 -20 30\naxis maxs: -6 -8 36\n";
  const VolumeRead nodes =
    this->Read(Header(sizes + ends + "centers: node node node\n") + VoxelBytes(this->volume));
  EXPECT_EQ(nodes.spacingMm, glm::dvec3(1, 4, 3));
  EXPECT_EQ(nodes.originMm, glm::dvec3(-10, -20, 30));
  const VolumeRead cells =
    this->Read(Header(sizes + ends + "centers: cell cell cell\n") + VoxelBytes(this->volume));
  EXPECT_EQ(cells.spacingMm, glm::dvec3(0.8, 3, 2));
  EXPECT_EQ(cells.originMm, glm::dvec3(-9.6, -18.5, 31));
}

TEST_F(NrrdVariants, ASpaceWithTimeHasSeveralVolumes)
{
  StoredVolume all = this->volume;
  all.values.insert(all.values.end(), 60, 7.0);
  const VolumeRead read = this->Read(Header("dimension: 4\nsizes: 5 4 3 2\nspace: RAST\n"
                                            "space directions: (0.7,0,0,0) (0,0.8,0,0) "
                                            "(0,0,2.5,0) (0,0,0,1.5)\n"
                                            "space origin: (10,20,30,0)\n") +
    VoxelBytes(all));
  EXPECT_EQ(read.values, this->volume.values) << read.error;
  EXPECT_EQ(read.originMm, glm::dvec3(-10, -20, 30));
  EXPECT_EQ(read.timeCount, 2);
}

TEST_F(NrrdVariants, APlaneIsOneSlice)
{
  StoredVolume slice = this->volume;
  slice.values.resize(20);
  const VolumeRead read = this->Read(Header("dimension: 2\nsizes: 5 4\nspace dimension: 2\n"
                                            "space directions: (0.7,0) (0,0.8)\n"
                                            "space origin: (-10,-20)\n") +
    VoxelBytes(slice));
  EXPECT_EQ(read.values, slice.values) << read.error;
  EXPECT_EQ(read.spacingMm, glm::dvec3(0.7, 0.8, 1));
}

TEST_F(NrrdVariants, UnitsAreKnownByAllTheirNamesOrWarnedOf)
{
  for (const auto& [unit, mm] : { std::pair("microns", 1e-3), std::pair("millimeters", 1.0),
         std::pair("cm", 10.0), std::pair("metres", 1000.0) })
  {
    const std::string quoted = std::string("\"") + unit + "\" ";
    const VolumeRead read = this->Read(Header("dimension: 3\nsizes: 5 4 3\nspace: LPS\n" + inSpace +
                                         "space units: " + quoted + quoted + quoted + "\n") +
      VoxelBytes(this->volume));
    EXPECT_DOUBLE_EQ(read.spacingMm.x, 0.7 * mm) << unit << read.error;
    EXPECT_EQ(read.warnings, "");
  }
  const VolumeRead furlongs =
    this->Read(Header("dimension: 3\nsizes: 5 4 3\nspace: LPS\n" + inSpace +
                 "space units: \"furlong\" \"furlong\" \"furlong\"\n") +
      VoxelBytes(this->volume));
  EXPECT_EQ(furlongs.spacingMm.x, 0.7);
  EXPECT_TRUE(furlongs.WarnsOf("\"furlong\" is not known"));
}

TEST_F(NrrdVariants, Bzip2AndHexadecimalVoxels)
{
  const std::string more = "dimension: 3\nsizes: 5 4 3\nspace: LPS\n" + inSpace;
  const std::string voxels = VoxelBytes(this->volume);
  std::string digits;
  for (const unsigned char byte : voxels)
  {
    char two[4];
    std::snprintf(two, sizeof(two), "%02X%s", byte, digits.size() % 7 == 0 ? "\n" : "");
    digits += two;
  }
  EXPECT_EQ(
    this->Read(Header(more, "bzip2") + Compressed(voxels, "bzip2")).values, this->volume.values);
  EXPECT_EQ(this->Read(Header(more, "hex") + digits).values, this->volume.values);
  EXPECT_NE(this->Read(Header(more, "bzip2") + voxels).error, "");
  EXPECT_NE(this->Read(Header(more, "hex") + digits.substr(2)).error, "");
}

TEST_F(NrrdVariants, BytesAndLinesAreSkippedInEachFile)
{
  const std::string header =
    "NRRD0005\ntype: short\nendian: little\ndimension: 3\nsizes: 5 4 3\nspace: LPS\n" + inSpace;
  const std::string voxels = VoxelBytes(this->volume);
  this->folder.Write("end.gz", Gzipped("352 bytes or so" + voxels));
  for (int slice = 0; slice < 3; ++slice)
  {
    this->folder.Write("slice" + std::to_string(slice) + ".pgm",
      "P5\n#" + std::string(std::size_t(slice), 'x') + "\n" +
        voxels.substr(std::size_t(slice) * 40, 40));
  }
  EXPECT_EQ(this->Read(header + "encoding: gzip\nbyte skip: -1\ndata file: end.gz\n").values,
    this->volume.values);
  EXPECT_EQ(
    this->Read(header + "encoding: raw\nline skip: 2\ndata file: slice%d.pgm 0 2 1\n").values,
    this->volume.values);
}

}
