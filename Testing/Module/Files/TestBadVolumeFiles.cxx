// Bad files give one sentence and an empty output, and take little memory.
#include "GoodFiles.h"
#include "PhantomFormats.h"
#include "Support/ExpectedVtkErrors.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkVolumeFileReader.h>
#include <vtkXMLWriter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <unistd.h>

namespace
{

/// Peak address space of this process [kB], as reported by Linux.
double PeakMemoryKB()
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
  {
    if (word == "VmPeak:")
    {
      double kilobytes = 0.0;
      status >> kilobytes;
      return kilobytes;
    }
  }
  return 0.0;
}

/// Requires one sentence that names the file, or the folder of the faulty file.
void ExpectOneSentence(const std::string& message, const std::string& path)
{
  const std::string folder = std::filesystem::path(path).parent_path();
  EXPECT_EQ(message.find("Cannot read \"" + folder), 0u) << message;
  EXPECT_NE(message.find(": expected "), std::string::npos) << message;
  EXPECT_NE(message.find(", found "), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_EQ(message.find(". "), std::string::npos) << message;
  EXPECT_EQ(message.back(), '.') << message;
}

/// Reads a file that may be unreadable; returns true if it was read.
bool ReadsOrFailsWell(vtkVolumeFileReader* reader, const std::string& path)
{
  reader->SetFileName(path.c_str());
  ExpectedVtkErrors errors;
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  reader->Update();
  const std::string printed =
    testing::internal::GetCapturedStderr() + testing::internal::GetCapturedStdout();
  EXPECT_EQ(printed, "");
  const std::string message = reader->GetErrorMessage();
  if (message.empty())
  {
    EXPECT_EQ(errors.Messages().size(), 0u) << errors.Text();
    EXPECT_EQ(reader->GetErrorCode(), 0u);
    EXPECT_GT(reader->GetOutput()->GetNumberOfPoints(), 0);
    return true;
  }
  EXPECT_EQ(errors.Messages().size(), 1u) << errors.Text();
  EXPECT_NE(reader->GetErrorCode(), 0u);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
  ExpectOneSentence(message, path);
  return false;
}

bool ReadsOrFailsWell(const std::string& path)
{
  vtkNew<vtkVolumeFileReader> reader;
  return ReadsOrFailsWell(reader, path);
}

std::string Replaced(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return text.replace(place, from.size(), to);
}

std::string Nrrd()
{
  const StoredVolume volume = phantom::Stored(0);
  return NrrdHeaderText(volume) + "endian: little\nencoding: raw\n\n" + VoxelBytes(volume);
}

std::string GzippedNrrd()
{
  const StoredVolume volume = phantom::Stored(0);
  return NrrdHeaderText(volume) + "endian: little\nencoding: gzip\n\n" +
    Gzipped(VoxelBytes(volume));
}

std::string MetaImage()
{
  const StoredVolume volume = phantom::Stored(0);
  return MetaImageHeaderText(volume) + "ElementDataFile = LOCAL\n" + VoxelBytes(volume);
}

std::string Vti()
{
  const std::string text = VtiText(phantom::Stored(0));
  return text.substr(0, text.size() - 1); // the final line break may be missing
}

std::string Vti(const VtiEncoding& encoding)
{
  const StoredVolume volume = phantom::Stored(0);
  const std::string text = EncodedVti(volume, VoxelBytes(volume), encoding);
  return text.substr(0, text.size() - 1);
}

std::vector<GoodFile> GoodFiles()
{
  const StoredVolume volume = phantom::Stored(0);
  // After the last voxel, gzip has an end mark and 8 bytes of checksums.
  std::vector<GoodFile> files = { { "a.nrrd", Nrrd() }, { "gzip.nrrd", GzippedNrrd(), 12 },
    { "a.mha", MetaImage() }, { "a.vti", Vti() }, { "binary.vti", Vti({ vtkXMLWriter::Binary }) },
    { "raw.vti", Vti({ vtkXMLWriter::Appended, false }) },
    { "zlib.vti", Vti({ vtkXMLWriter::Appended, false, vtkXMLWriter::ZLIB }) },
    { "a.nii", NiftiBytes(volume) }, { "a.nii.gz", Gzipped(NiftiBytes(volume)), 12 },
    { "a.dcm", DicomBytes(volume, 0) } };
  for (const GoodFile& file : MoreGoodFiles())
  {
    files.push_back(file);
  }
  return files;
}

TEST(BadVolumeFiles, TheGoodOnesAreRead)
{
  const TemporaryFolder folder;
  for (const GoodFile& file : GoodFiles())
  {
    EXPECT_TRUE(ReadsOrFailsWell(folder.Write(file.name, file.bytes))) << file.name;
  }
}

TEST(BadVolumeFiles, CutAnywhereTheyAreRefused)
{
  const TemporaryFolder folder;
  for (const GoodFile& file : GoodFiles())
  {
    const std::size_t step = file.bytes.size() / 25 + 1;
    for (std::size_t size = 0; size < file.bytes.size() - file.spareBytes; size += step)
    {
      SCOPED_TRACE(std::string(file.name) + " cut to " + std::to_string(size));
      EXPECT_FALSE(ReadsOrFailsWell(folder.Write(file.name, file.bytes.substr(0, size))));
    }
  }
}

TEST(BadVolumeFiles, WithBytesChangedTheyAreReadOrRefused)
{
  const TemporaryFolder folder;
  std::mt19937 random(20240611);
  for (const GoodFile& file : GoodFiles())
  {
    for (int round = 0; round < 15; ++round)
    {
      std::string bytes = file.bytes;
      for (int change = 0; change < 3; ++change)
      {
        bytes[random() % bytes.size()] = char(random());
      }
      SCOPED_TRACE(std::string(file.name) + " round " + std::to_string(round));
      ReadsOrFailsWell(folder.Write(file.name, bytes));
    }
  }
}

TEST(BadVolumeFiles, RawVtiThatPromisesMoreThanItHoldsIsRefused)
{
  // The byte count is wrong as well, so that VTK would read up to the end of the file.
  StoredVolume promised = phantom::Stored(0);
  promised.dimensions = { 5, 4, 6 };
  promised.values.resize(120);
  const VtiEncoding raw = { vtkXMLWriter::Appended, false };
  std::string bytes = EncodedVti(promised, VoxelBytes(promised), raw);
  bytes.erase(bytes.find("</AppendedData>") - 120, 110);
  const TemporaryFolder folder;
  EXPECT_FALSE(ReadsOrFailsWell(folder.Write("half.vti", bytes)));
}

TEST(BadVolumeFiles, FalseSizesTakeNoMemory)
{
  const TemporaryFolder folder;
  const StoredVolume volume = phantom::Stored(0);
  StoredVolume large = volume;
  large.dimensions = { 30000, 30000, 30000 };
  const std::string nifti = NiftiBytes(volume);
  const std::vector<std::pair<const char*, std::string>> files = {
    { "a.nrrd", Replaced(Nrrd(), "sizes: 5 4 3", "sizes: 2000 2000 1000") },
    { "overflow.nrrd",
      Replaced(Nrrd(), "sizes: 5 4 3", "sizes: 2147483647 2147483647 2147483647") },
    { "int64.nrrd", Replaced(Nrrd(), "sizes: 5 4 3", "sizes: 9223372036854775807 2 2") },
    { "huge.nrrd", Replaced(Nrrd(), "sizes: 5 4 3", "sizes: 99999999999999999999 2 2") },
    { "negative.nrrd", Replaced(Nrrd(), "sizes: 5 4 3", "sizes: -5 -4 3") },
    { "zero.nrrd", Replaced(Nrrd(), "sizes: 5 4 3", "sizes: 0 4 3") },
    { "gzip.nrrd", Replaced(GzippedNrrd(), "sizes: 5 4 3", "sizes: 2000 2000 1000") },
    { "a.mha", Replaced(MetaImage(), "DimSize = 5 4 3", "DimSize = 2000 2000 1000") },
    { "a.nii", NiftiBytes(large).substr(0, 352) + VoxelBytes(volume) },
    { "a.nii.gz", Gzipped(NiftiBytes(large).substr(0, 352) + VoxelBytes(volume)) },
    { "a.vti", VtiText(large) },
    { "a.dcm", DicomBytes(volume, 0, { "1.2", 1.0, 0.0, 65535 }) },
    { "a.mgh", MghBytes(large) },
    { "a.mgz", Gzipped(MghBytes(large)) },
    { "a.gipl", GiplBytes(large) },
    { "a.mrc", MrcBytes(large) },
    { "a.mif", MifHeaderText(large, { 0, 1, 2 }, { false, false, false }) + VoxelBytes(volume) },
    { "a.npy", NpyBytes(volume, { 30000, 30000, 30000 }) },
    { "overflow.npy", NpyBytes(volume, { 2147483647, 2147483647, 2147483647, 2147483647 }) },
    { "a.slc", Replaced(SlcBytes(PhantomOfBytes(), true), "5 4 3", "3000 3000 3000") },
    { "a.pvm", Replaced(PvmBytes(PhantomOfBytes()), "5 4 3", "3000 3000 3000") },
  };
  for (const auto& [name, bytes] : files)
  {
    SCOPED_TRACE(name);
    const double peakBefore = PeakMemoryKB();
    EXPECT_FALSE(ReadsOrFailsWell(folder.Write(name, bytes)));
    EXPECT_LT(PeakMemoryKB() - peakBefore, 100e3);
  }
}

struct BadFile
{
  const char* name;
  std::string bytes;
  const char* fault; ///< words that the error must contain
};

void ExpectFaultsNamed(const std::vector<BadFile>& files)
{
  const TemporaryFolder folder;
  for (const BadFile& file : files)
  {
    SCOPED_TRACE(file.name);
    vtkNew<vtkVolumeFileReader> reader;
    EXPECT_FALSE(ReadsOrFailsWell(reader, folder.Write(file.name, file.bytes)));
    EXPECT_NE(std::string(reader->GetErrorMessage()).find(file.fault), std::string::npos)
      << reader->GetErrorMessage();
  }
}

TEST(BadVolumeFiles, FilesOfAnotherKindAreNamed)
{
  ExpectFaultsNamed({
    { "empty.nrrd", "", "an empty file" },
    { "magic.nrrd", "NEARLY0004\n\n", "NRRD" },
    { "magic.nii", std::string(400, 'x'), "NIfTI" },
    { "magic.vti", "<html></html>", "a web page" },
    { "magic.dcm", std::string(400, 'x'), "DICOM" },
    { "notar.inv3", std::string(2000, 'x'), "tar" },
    { "nomembers.inv3", std::string(10240, '\0'), "tar archive" },
    { "nomembers.gz.inv3", Gzipped(std::string(10240, '\0')), "tar archive" },
    { "unknown.bin", "what is this", "text that begins with \"what is this\"" },
    { "unknown", "\x1a\x2b\x03", "the bytes 1a 2b 03" },
    { "report.dcm", "%PDF-1.4", "a PDF document" },
    { "unset.raw", "voxels", "dimensions" },
    { "no.zip", "no archive", "an archive or a compressed file" },
    { "cut.tar", std::string(300, '\0'), "an archive or a compressed file" },
  });
}

TEST(BadVolumeFiles, FaultsOfHeadersAreNamed)
{
  ExpectFaultsNamed({
    { "type.nrrd", Replaced(Nrrd(), "int16_t", "quaternion"), "\"quaternion\"" },
    { "block.nrrd", Replaced(Nrrd(), "int16_t", "block"), "\"block\"" },
    { "type.mha", Replaced(MetaImage(), "MET_SHORT", "MET_STRANGE"), "\"MET_STRANGE\"" },
    { "encoding.nrrd", Replaced(Nrrd(), "encoding: raw", "encoding: zrl"), "\"zrl\"" },
    { "space.nrrd", Replaced(Nrrd(), "space: LPS", "space: the-moon"), "\"the-moon\"" },
    { "spacing.mha", Replaced(MetaImage(), "ElementSpacing =", "ElementSpacing = nan 1 1\nX ="),
      "spacing" },
    { "infinite.mha", Replaced(MetaImage(), "ElementSpacing =", "ElementSpacing = inf 1 1\nX ="),
      "spacing" },
    { "zero.mha", Replaced(MetaImage(), "ElementSpacing =", "ElementSpacing = 0 1 1\nX ="),
      "spacing" },
    { "flat.mha",
      Replaced(MetaImage(), "TransformMatrix =", "TransformMatrix = 1 0 0 1 0 0 0 0 1\nX ="),
      "span space" },
    { "origin.mha", Replaced(MetaImage(), "Offset =", "Offset = inf 0 0\nX ="), "finite origin" },
    { "nodata.mhd", Replaced(MetaImage(), "LOCAL", "nowhere.raw"), "nowhere.raw" },
    { "words.mha", Replaced(MetaImage(), "DimSize =", "DimSize = five 4 3\nX ="), "\"five\"" },
  });
}

TEST(BadVolumeFiles, HeadersOfAnyLengthAreRefused)
{
  const std::string nrrd =
    NrrdHeaderText(phantom::Stored(0)) + "endian: little\nencoding: raw\ndata file: ";
  const std::string pattern = std::string(100000, 'x') + "%03d.raw 1 3 1";
  const std::string npy = NpyBytes(phantom::Stored(0), { 3, 4, 5 });
  std::string header = npy.substr(10, 118).insert(60, 50000, ' ');
  header.resize(65280, ' ');
  const std::string start = npy.substr(0, 8) + std::string("\x00\xff", 2);
  ExpectFaultsNamed({
    { "pattern.nrrd", nrrd + pattern + "\n", "at most 1000 characters" },
    { "pattern.mhd",
      MetaImageHeaderText(phantom::Stored(0)) + "ElementDataFile = " + pattern + "\n",
      "at most 1000 characters" },
    { "header.npy", start + header + npy.substr(128), "at most 1000 characters" },
    { "numbers.nrrd", nrrd + "%d.raw 9223372036854775807 9223372036854775000 -400\n",
      "1 to 100000 files" },
  });
}

TEST(BadVolumeFiles, CorruptCompressedStreamsAreNamed)
{
  const TemporaryFolder folder;
  std::string bytes = Gzipped(NiftiBytes(phantom::Stored(0)));
  std::fill(bytes.begin() + 40, bytes.end() - 20, '\xff');
  vtkNew<vtkVolumeFileReader> reader;
  EXPECT_FALSE(ReadsOrFailsWell(reader, folder.Write("corrupt.nii.gz", bytes)));
  EXPECT_NE(std::string(reader->GetErrorMessage()).find("compressed stream"), std::string::npos);
}

TEST(BadVolumeFiles, ACompressedFileCutInTheMiddleSaysHowMuchItHeld)
{
  const TemporaryFolder folder;
  StoredVolume volume = phantom::Stored(0);
  volume.dimensions = { 64, 64, 64 };
  std::mt19937 random(20240612);
  std::generate_n(std::back_inserter(volume.values), 64 * 64 * 64 - volume.values.size(),
    [&] { return double(random() % 1000); });
  const std::string bytes = Gzipped(NiftiBytes(volume));
  ASSERT_GT(bytes.size(), 200e3) << "several buffers of the reader";
  vtkNew<vtkVolumeFileReader> reader;
  EXPECT_FALSE(
    ReadsOrFailsWell(reader, folder.Write("cut.nii.gz", bytes.substr(0, bytes.size() / 2))));
  const std::string message = reader->GetErrorMessage();
  EXPECT_NE(message.find("a complete compressed stream"), std::string::npos) << message;
  EXPECT_NE(message.find("decompressed bytes"), std::string::npos) << message;
}

TEST(BadVolumeFiles, FoldersWithoutImagesAndUnreadableFilesAreRefused)
{
  const TemporaryFolder folder;
  folder.Write("folder/readme.txt", "no image");
  vtkNew<vtkVolumeFileReader> reader;
  EXPECT_FALSE(ReadsOrFailsWell(reader, folder.Path("folder")));
  EXPECT_NE(std::string(reader->GetErrorMessage()).find("text that begins with \"no image\""),
    std::string::npos);
  EXPECT_FALSE(ReadsOrFailsWell(folder.Path("missing.mha")));
  const std::string locked = folder.Write("locked.mha", MetaImage());
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  if (geteuid() != 0) // root may read everything
  {
    EXPECT_FALSE(ReadsOrFailsWell(locked));
  }
}

TEST(BadVolumeFiles, BareVoxelsAreNotTakenForDicom)
{
  // A data set in implicit encoding without preamble also begins with the number 8.
  const TemporaryFolder folder;
  const std::string path = folder.Write("small.raw", std::string("\x08\0\5\0\4\0\0\0\3\0\7\0", 12));
  EXPECT_STREQ(vtkVolumeFileReader::GetFormatOfFile(path.c_str()), "raw");
  const std::string dicom("\x08\0\5\0\4\0\0\0ISO \x08\0\x16\0", 16);
  EXPECT_STREQ(vtkVolumeFileReader::GetFormatOfFile(folder.Write("a.raw", dicom).c_str()), "DICOM");
}

TEST(BadVolumeFiles, AreKnownByTheirContentWhateverTheirName)
{
  const TemporaryFolder folder;
  for (const GoodFile& file : GoodFiles())
  {
    for (const std::string& name : { std::string(file.name), std::string("unnamed"),
           std::string("false.nrrd"), std::string("false.hdr"), std::string("false.raw") })
    {
      SCOPED_TRACE(file.name + (" named " + name));
      const std::string path = folder.Write("names/" + name, file.bytes);
      EXPECT_TRUE(vtkVolumeFileReader::CanReadFile(path.c_str()));
      EXPECT_TRUE(ReadsOrFailsWell(path));
      std::filesystem::remove(path);
    }
  }
  EXPECT_TRUE(vtkVolumeFileReader::CanReadFile(folder.Write("unnamed", Nrrd()).c_str()));
  EXPECT_FALSE(vtkVolumeFileReader::CanReadFile(folder.Path("missing.nrrd").c_str()));
  EXPECT_FALSE(vtkVolumeFileReader::CanReadFile(folder.Write("text.nrrd", "a text").c_str()));
  EXPECT_FALSE(vtkVolumeFileReader::CanReadFile(folder.Write("notes.txt", "a text").c_str()));
}

}
