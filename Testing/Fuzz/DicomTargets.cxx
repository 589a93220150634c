// DICOM: single files, folders of slices, indices, and compressed or deflated files. The last have
// a target of their own: GDCM ends the decoder at many of them, which takes time.
#include "Fuzz/FuzzInput.h"
#include "Fuzz/FuzzTarget.h"
#include "Fuzz/ReadInput.h"
#include "Module/Files/PhantomDicom.h"

#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace varimarch
{

namespace
{

using namespace phantom_dicom;

constexpr const char* ImplicitSyntax = "1.2.840.10008.1.2";

Elements Slice(int slice, const DicomOptions& options = {})
{
  return SliceElements(phantom::Stored(0), slice, options);
}

/// Three frames, with positions in the functional groups of an enhanced image.
Elements EnhancedFile()
{
  Elements elements = Slice(0);
  elements[0x00280008] = Text("IS", "3");
  elements[0x00200037] = Decimals({ 1, 0, 0, 0, 1, 0 });
  elements.erase(0x00200032);
  std::vector<Elements> frames;
  for (int frame = 0; frame < 3; ++frame)
  {
    frames.push_back(
      { { 0x00209113, Sequence({ { { 0x00200032, Decimals({ 0, 0, 2.5 * frame }) } } }) } });
  }
  elements[0x52009229] =
    Sequence({ { { 0x00289110, Sequence({ { { 0x00280030, Decimals({ 1, 1 }) } } }) } } });
  elements[0x52009230] = Sequence(frames);
  elements[0x7fe00010] = Pixels(std::vector<int>(60, 7));
  return elements;
}

/// Indices of colours, and the palette.
Elements PaletteFile()
{
  Elements elements = Slice(0);
  elements[0x00280004] = Text("CS", "PALETTE COLOR");
  for (const std::uint32_t channel : { 0u, 1u, 2u })
  {
    elements[0x00281101 + channel] = Shorts({ 4, 0, 16 });
    elements[0x00281201 + channel] = { "OW", Shorts({ 0, 20000, 40000, 65535 }).value };
  }
  return elements;
}

std::vector<std::string> FileSeeds()
{
  Elements scaled = Slice(1, { "1.2.3", 2.0, -1024.0 });
  scaled[0x00281050] = Decimals({ 40 });
  scaled[0x00281051] = Decimals({ 400 });
  const std::string whole = FileBytes(scaled);
  const std::string firstTagOfDataSet("\x08\0\x16\0", 4);
  return { whole, FileBytes(EnhancedFile()), FileBytes(PaletteFile()),
    whole.substr(whole.find(firstTagOfDataSet)) };
}

std::vector<std::string> SlicesOf(const DicomOptions& options)
{
  std::vector<std::string> slices;
  for (int slice = 0; slice < 3; ++slice)
  {
    DicomOptions own = options;
    own.instance = slice + 1;
    slices.push_back(FileBytes(Slice(slice, own)));
  }
  return slices;
}

std::vector<std::string> FolderSeeds()
{
  DicomOptions other;
  other.seriesUid = "1.2.4";
  std::vector<std::string> two = SlicesOf({});
  const std::vector<std::string> second = SlicesOf(other);
  two.insert(two.end(), second.begin(), second.end());
  std::vector<std::string> gap = SlicesOf({});
  gap.erase(gap.begin() + 1);
  return { JoinedFiles(SlicesOf({})), JoinedFiles(two), JoinedFiles(gap) };
}

std::vector<std::string> IndexSeeds()
{
  std::vector<std::string> files = SlicesOf({});
  files.insert(files.begin(), DicomIndexBytes({ "1", "2", "3" }));
  return { JoinedFiles(files) };
}

/// A slice of 16 x 16 pixels: GDCM writes behind its buffer if JPEG 2000 makes pixels longer.
Elements WideSlice()
{
  Elements elements = Slice(0);
  std::vector<int> values(16 * 16);
  std::iota(values.begin(), values.end(), 0);
  elements[0x00280010] = Shorts({ 16 });
  elements[0x00280011] = Shorts({ 16 });
  elements[0x7fe00010] = Pixels(values);
  return elements;
}

/// The same with 8 bits, which is all that the baseline of JPEG has.
Elements ByteSlice()
{
  Elements elements = WideSlice();
  elements[0x00280100] = Shorts({ 8 });
  elements[0x00280101] = Shorts({ 8 });
  elements[0x00280102] = Shorts({ 7 });
  elements[0x00280103] = Shorts({ 0 });
  elements[0x7fe00010] = { "OB", std::string(16 * 16, '\x28') };
  return elements;
}

/// A file in another transfer syntax, which GDCM writes.
std::string CompressedFile(const Elements& elements, gdcm::TransferSyntax::TSType syntax)
{
  std::istringstream plain(FileBytes(elements));
  gdcm::ImageReader reader;
  reader.SetStream(plain);
  Require(reader.Read(), "GDCM does not read a seed");
  gdcm::ImageChangeTransferSyntax change;
  change.SetTransferSyntax(syntax);
  change.SetInput(reader.GetImage());
  Require(change.Change(), "GDCM does not compress a seed");
  std::ostringstream compressed;
  gdcm::ImageWriter writer;
  writer.SetFile(reader.GetFile());
  writer.SetImage(change.GetOutput());
  writer.SetStream(compressed);
  Require(writer.Write(), "GDCM does not write a seed");
  return compressed.str();
}

std::vector<std::string> CompressedSeeds()
{
  using Syntax = gdcm::TransferSyntax;
  std::vector<std::string> seeds = { FileBytes(Slice(0), DeflatedSyntax),
    CompressedFile(ByteSlice(), Syntax::JPEGBaselineProcess1) };
  for (const Syntax::TSType syntax : { Syntax::JPEGLosslessProcess14_1, Syntax::JPEGLSLossless,
         Syntax::JPEG2000Lossless, Syntax::RLELossless })
  {
    seeds.push_back(CompressedFile(WideSlice(), syntax));
  }
  return seeds;
}

bool NeedsGdcm(const std::string& input)
{
  const auto holds = [&](const char* uid) { return input.find(uid) != input.npos; };
  return holds("1.2.840.10008.1.2.4.") || holds(RunLengthSyntax) || holds(DeflatedSyntax);
}

const std::vector<std::string>& Words()
{
  static const std::vector<std::string> words = { "DICM", ImplicitSyntax, ExplicitSyntax,
    "1.2.840.10008.1.2.2", "MONOCHROME1", "MONOCHROME2", "PALETTE COLOR", "RGB", "YBR_FULL",
    "YBR_FULL_422", "ARGB", "SQ", "OB", "OW", "OF", "UN", "DS", "IS", "US", "FD", "MOSAIC",
    "SIEMENS CSA HEADER", "SV10", "ORIGINAL\\PRIMARY", "LOCALIZER", "HFS", "FFP", "\\", "1e400",
    std::string("\xfe\xff\x00\xe0\xff\xff\xff\xff", 8),
    std::string("\xfe\xff\x0d\xe0\x00\x00\x00\x00", 8), FileBoundary };
  return words;
}

bool ReadFiles(
  const std::vector<std::string>& files, const std::string& opens, const std::string& input)
{
  Inputs().Replace(files, input);
  return ReadInput(Inputs().Path(opens));
}

FuzzTarget DicomTarget(const std::string& name, const std::vector<std::string>& files,
  const std::string& opens, std::vector<std::string> (*seeds)())
{
  const auto run = [files, opens](const std::string& input)
  { return !NeedsGdcm(input) && ReadFiles(files, opens, input); };
  return { name, run, seeds, Words() };
}

FuzzTarget CompressedTarget()
{
  const auto run = [](const std::string& input) { return ReadFiles({ "a.dcm" }, "a.dcm", input); };
  std::vector<std::string> words = Words();
  for (const char* syntax : { "50", "51", "57", "70", "80", "81", "90", "91" })
  {
    words.push_back(std::string("1.2.840.10008.1.2.4.") + syntax);
  }
  // Markers of JPEG, JPEG-LS and JPEG 2000: images, frames, tables, scans, restarts, tiles.
  for (const char* marker : { "\xff\xd8", "\xff\xd9", "\xff\xc0", "\xff\xc2", "\xff\xc3",
         "\xff\xc4", "\xff\xda", "\xff\xdb", "\xff\xdd", "\xff\xf7", "\xff\xf8", "\xff\x4f\xff\x51",
         "\xff\x52", "\xff\x5c", "\xff\x90", "\xff\x93" })
  {
    words.emplace_back(marker);
  }
  return { "dicom-compressed", run, CompressedSeeds, words };
}

}

std::vector<FuzzTarget> DicomTargets()
{
  return { DicomTarget("dicom", { "a.dcm" }, "a.dcm", FileSeeds),
    DicomTarget("dicom-folder", { "1", "2", "3", "4", "5", "6" }, "", FolderSeeds),
    DicomTarget("dicomdir", { "DICOMDIR", "1", "2", "3" }, "DICOMDIR", IndexSeeds),
    CompressedTarget() };
}

}
