// Descriptions by which programs say more about a TIFF file than its pages do. The right values are
// those of ImageJ, and of tifffile for the others.
#include "PhantomLibraryFiles.h"
#include "VolumeRead.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace
{

constexpr int shortType = 3;
constexpr int longType = 4;
constexpr int fractionType = 5;

/// An entry of a directory, with the bytes of its values.
struct Entry
{
  int tag;
  int type;
  std::size_t count;
  std::string bytes;
};

template <class Value>
std::string Little(Value value)
{
  std::string bytes(sizeof(value), '\0');
  std::memcpy(bytes.data(), &value, sizeof(value));
  return bytes;
}

Entry Number(int tag, std::uint32_t value)
{
  return { tag, longType, 1, Little(value) };
}

std::string Fraction(std::uint32_t numerator, std::uint32_t denominator)
{
  return Little(numerator) + Little(denominator);
}

/// The offset of what follows the pixels in the files below.
std::size_t EndOfPixels(const StoredVolume& volume)
{
  return 8 + VoxelBytes(volume).size();
}

/// A TIFF file of shorts with one directory, whose strip is the first plane, and with bytes between
/// the pixels and the directory.
std::string TiffOf(
  const StoredVolume& volume, std::vector<Entry> entries, const std::string& between = "")
{
  const auto width = std::uint32_t(volume.dimensions[0]);
  const auto height = std::uint32_t(volume.dimensions[1]);
  for (const Entry& entry :
    { Number(256, width), Number(257, height), Number(258, 16), Number(259, 1), Number(262, 1),
      Number(273, 8), Number(277, 1), Number(278, height), Number(279, 2 * width * height) })
  {
    entries.push_back(entry);
  }
  std::sort(entries.begin(), entries.end(),
    [](const Entry& one, const Entry& other) { return one.tag < other.tag; });
  const std::size_t directory = EndOfPixels(volume) + between.size();
  std::string behind;
  std::string list = Little(std::uint16_t(entries.size()));
  for (Entry entry : entries)
  {
    list += Little(std::uint16_t(entry.tag)) + Little(std::uint16_t(entry.type)) +
      Little(std::uint32_t(entry.count));
    if (entry.bytes.size() > 4)
    {
      const std::size_t offset = directory + 2 + 12 * entries.size() + 4 + behind.size();
      behind += entry.bytes;
      entry.bytes = Little(std::uint32_t(offset));
    }
    entry.bytes.resize(4, '\0');
    list += entry.bytes;
  }
  return std::string("II*\0", 4) + Little(std::uint32_t(directory)) + VoxelBytes(volume) + between +
    list + std::string(4, '\0') + behind;
}

StoredVolume Shorts(int scalarType = VTK_UNSIGNED_SHORT)
{
  StoredVolume volume = phantom::Stored(0);
  volume.scalarType = scalarType;
  return volume;
}

std::vector<double> Mapped(std::vector<double> values, double slope, double intercept)
{
  std::for_each(
    values.begin(), values.end(), [&](double& value) { value = slope * value + intercept; });
  return values;
}

class TiffDescriptions : public testing::Test
{
protected:
  VolumeRead ReadDescribed(const std::string& description, const StoredVolume& volume)
  {
    TiffOptions options;
    options.description = description;
    WriteTiff(this->folder.Path("a.tif"), volume, options);
    return ReadVolumeAt(this->folder.Path("a.tif"));
  }

  VolumeRead ReadBytes(const std::string& bytes)
  {
    return ReadVolumeAt(this->folder.Write("a.tif", bytes));
  }

  TemporaryFolder folder;
};

const std::string imageJ = "ImageJ=1.53t\nimages=3\nslices=3\n";

TEST_F(TiffDescriptions, AStraightLineOfImageJIsApplied)
{
  const StoredVolume volume = Shorts();
  const VolumeRead read =
    this->ReadDescribed(imageJ + "cf=0\nc0=-1024.0\nc1=0.5\nvunit=HU\n", volume);
  EXPECT_EQ(read.error, "");
  EXPECT_EQ(read.values, Mapped(volume.values, 0.5, -1024.0));
}

TEST_F(TiffDescriptions, SignedShortsOfImageJKeepTheirValues)
{
  const std::string calibration = imageJ + "cf=0\nc0=-32768.0\nc1=1.0\n";
  const StoredVolume stored = Shorts();
  EXPECT_EQ(this->ReadDescribed(calibration, stored).values, Mapped(stored.values, 1.0, -32768.0));
  // The numbers of a file that says that they are signed are those values already.
  StoredVolume already = Shorts(VTK_SHORT);
  already.values.front() = -7.0;
  EXPECT_EQ(this->ReadDescribed(calibration, already).values, already.values);
}

TEST_F(TiffDescriptions, OtherFunctionsOfImageJAreNamed)
{
  const StoredVolume volume = Shorts();
  const VolumeRead read = this->ReadDescribed(imageJ + "cf=7\nc0=1\nc1=2\nc2=3\nc3=4\n", volume);
  EXPECT_EQ(read.values, volume.values);
  EXPECT_TRUE(read.WarnsOf("function number 7")) << read.warnings;
  EXPECT_FALSE(this->ReadDescribed(imageJ + "cf=20\n", volume).WarnsOf("function"));
  EXPECT_TRUE(this->ReadDescribed(imageJ + "cf=0\nc0=1\nc1=0\n", volume).WarnsOf("function"));
}

TEST_F(TiffDescriptions, EveryWayToWriteAMicrometreIsOne)
{
  for (const char* const unit :
    { "um", "micron", "\xb5m", "\xc2\xb5m", "\xce\xbcm", "\\u00B5m", "micrometers" })
  {
    TiffOptions options;
    options.description = imageJ + "unit=" + unit + "\nspacing=2\n";
    options.pixelsPerCentimetre = 4.0;
    WriteTiff(this->folder.Path("a.tif"), Shorts(), options);
    const VolumeRead read = ReadVolumeAt(this->folder.Path("a.tif"));
    EXPECT_NEAR(read.spacingMm.x, 0.25e-3, 1e-9) << unit;
    EXPECT_NEAR(read.spacingMm.z, 2e-3, 1e-9) << unit;
    EXPECT_FALSE(read.WarnsOf("unit")) << read.warnings;
  }
}

TEST_F(TiffDescriptions, TifffileNamesChannelsTimesAndSlices)
{
  StoredVolume volume = Shorts();
  volume.dimensions = { 5, 1, 12 };
  const auto value = [&](int page, int x) { return volume.values[std::size_t(5 * page + x)]; };
  VolumeRead read = this->ReadDescribed(R"({"axes": "CZYX", "shape": [2, 6, 1, 5]})", volume);
  ASSERT_EQ(read.values.size(), 60u) << read.error;
  EXPECT_EQ(read.componentCount, 2);
  EXPECT_EQ(read.values[2 * (5 * 4 + 3) + 1], value(6 + 4, 3));
  read = this->ReadDescribed(R"({"shape": [4, 3, 1, 5], "axes": "TZYX"})", volume);
  EXPECT_EQ(read.timeCount, 4);
  EXPECT_EQ(read.values.size(), 15u);
  read = this->ReadDescribed(R"({"shape": [3, 4, 1, 5], "axes": "ZPYX"})", volume);
  ASSERT_EQ(read.values.size(), 15u);
  EXPECT_EQ(read.values[5], value(4, 0));
  EXPECT_TRUE(read.WarnsOf("axis P")) << read.warnings;
  // An axis of no meaning counts slices if no other does.
  read = this->ReadDescribed(R"({"shape": [12, 1, 5], "axes": "QYX"})", volume);
  EXPECT_EQ(read.values, volume.values);
  read = this->ReadDescribed(R"({"shape": [9, 3, 1, 5], "axes": "TZYX"})", volume);
  EXPECT_EQ(read.values, volume.values);
  EXPECT_TRUE(read.WarnsOf("does not fit")) << read.warnings;
}

/// The properties of a stack of MetaMorph: calibrated, in pixels of these sizes.
std::vector<Entry> MetaMorph(const StoredVolume& volume, const std::vector<std::string>& planes,
  const std::string& unit, std::string& between)
{
  const auto place = std::uint32_t(EndOfPixels(volume));
  between = Fraction(1, 2) + Fraction(1, 4) + Little(std::uint32_t(unit.size())) + unit;
  std::string list;
  for (const std::string& plane : planes)
  {
    list += plane;
  }
  return { { 33628, longType, 4,
             Fraction(3, 1) + Fraction(4, place) + Fraction(5, place + 8) +
               Fraction(6, place + 16) },
    { 33629, fractionType, planes.size(), list } };
}

TEST_F(TiffDescriptions, PlanesOfMetaMorphHaveNoDirectories)
{
  const StoredVolume volume = Shorts();
  std::vector<std::string> planes;
  for (std::uint32_t z = 0; z < 3; ++z)
  {
    planes.push_back(Fraction(25 * z, 10) + Fraction(2460000, 1000) + Fraction(2460000, 1000));
  }
  std::string between;
  const std::vector<Entry> entries = MetaMorph(volume, planes, "um", between);
  const std::string bytes = TiffOf(volume, entries, between);
  const VolumeRead read = this->ReadBytes(bytes);
  EXPECT_EQ(read.error, "");
  EXPECT_EQ(read.values, volume.values);
  EXPECT_NEAR(read.spacingMm.x, 0.5e-3, 1e-9);
  EXPECT_NEAR(read.spacingMm.y, 0.25e-3, 1e-9);
  EXPECT_NEAR(read.spacingMm.z, 2.5e-3, 1e-9);
  StoredVolume cut = volume;
  cut.dimensions = { 5, 4, 3 };
  std::vector<Entry> more = entries;
  more.back().count = 300;
  EXPECT_NE(this->ReadBytes(TiffOf(cut, more, between)).error, "");
}

TEST_F(TiffDescriptions, PlanesOfMetaMorphWithoutHeightsAreTimes)
{
  const StoredVolume volume = Shorts();
  std::vector<std::string> planes;
  for (std::uint32_t time = 0; time < 3; ++time)
  {
    planes.push_back(
      Fraction(0, 1) + Fraction(2460000, 1500 * time) + Fraction(2460000, 1500 * time));
  }
  std::string between;
  const std::vector<Entry> entries = MetaMorph(volume, planes, "pixels", between);
  const VolumeRead read = this->ReadBytes(TiffOf(volume, entries, between));
  EXPECT_EQ(read.timeCount, 3);
  EXPECT_EQ(read.values, std::vector<double>(volume.values.begin(), volume.values.begin() + 20));
  EXPECT_TRUE(read.WarnsOf("1 mm")) << read.warnings;
}

TEST_F(TiffDescriptions, ImageDepthCountsTheSlicesOfADirectory)
{
  const StoredVolume volume = Shorts();
  EXPECT_EQ(this->ReadBytes(TiffOf(volume, { Number(32997, 3) })).values, volume.values);
  EXPECT_NE(this->ReadBytes(TiffOf(volume, { Number(32997, 40) })).error, "");
  EXPECT_NE(this->ReadBytes(TiffOf(volume, { Number(32997, 4000000000) })).error, "");
}

TEST_F(TiffDescriptions, ZeissStatesSizesTimesAndVoxels)
{
  StoredVolume volume = Shorts();
  volume.dimensions = { 5, 4, 1 };
  std::string info = Little(0x0400494c) + Little(120) + Little(5) + Little(4) + Little(1) +
    Little(1) + Little(3) + std::string(12, '\0') + Little(2e-7) + Little(3e-7) + Little(5e-7);
  info.resize(112, '\0');
  info += Little(2.5);
  const VolumeRead read =
    this->ReadBytes(TiffOf(Shorts(), { { 34412, 1, info.size(), info }, Number(32997, 3) }));
  EXPECT_EQ(read.timeCount, 3);
  EXPECT_EQ(read.values, std::vector<double>(volume.values.begin(), volume.values.begin() + 20));
  EXPECT_NEAR(read.spacingMm.x, 2e-4, 1e-12);
  EXPECT_NEAR(read.spacingMm.y, 3e-4, 1e-12);
  EXPECT_NEAR(read.spacingMm.z, 5e-4, 1e-12);
}

}
