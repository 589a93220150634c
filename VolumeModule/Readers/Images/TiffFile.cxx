#include "Readers/Images/TiffFile.h"

#include "Readers/BinaryHeader.h"
#include "Readers/ByteStream.h"
#include "Readers/FileContent.h"
#include "Readers/FileError.h"
#include "Readers/Images/TiffMessages.h"
#include "Readers/Images/TiffTags.h"

#include <vtkType.h>

#include <algorithm>

namespace varimarch
{
namespace
{

/// True unless the samples of a pixel are channels that have nothing to do with each other.
bool HoldsColors(TIFF* file)
{
  const auto photometric = TiffTag<std::uint16_t>(file, TIFFTAG_PHOTOMETRIC);
  if (photometric != PHOTOMETRIC_MINISBLACK && photometric != PHOTOMETRIC_MINISWHITE)
  {
    return true;
  }
  std::uint16_t extraCount = 0;
  std::uint16_t* extra = nullptr;
  TIFFGetFieldDefaulted(file, TIFFTAG_EXTRASAMPLES, &extraCount, &extra);
  return TiffTag<std::uint16_t>(file, TIFFTAG_SAMPLESPERPIXEL) == 2 && extraCount == 1 &&
    extra[0] != EXTRASAMPLE_UNSPECIFIED;
}

double MmPerUnit(TIFF* file)
{
  switch (TiffTag<std::uint16_t>(file, TIFFTAG_RESOLUTIONUNIT))
  {
    case RESUNIT_INCH:
      return 25.4;
    case RESUNIT_CENTIMETER:
      return 10.0;
    default:
      return 0.0;
  }
}

}

std::array<double, 2> PixelSpacingMm(const TiffPage& page)
{
  std::array<double, 2> spacingMm = { 0.0, 0.0 };
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double pixels = page.pixelsPerUnit[axis];
    spacingMm[axis] = pixels > 0.0 ? page.mmPerUnit / pixels : 0.0;
  }
  return spacingMm;
}

TiffFile::TiffFile(const std::string& path)
  : path(path)
  , messages(std::make_unique<Messages>())
{
  ReadableFileSize(path);
  TIFFOpenOptions* const options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, Messages::Take, this->messages.get());
  TIFFOpenOptionsSetWarningHandlerExtR(options, Messages::Ignore, nullptr);
  // The letter m turns off mapping into memory, where a file that another program cuts would end
  // this one by a signal.
  this->file = TIFFOpenExt(path.c_str(), "rm", options);
  TIFFOpenOptionsFree(options);
  if (!this->file)
  {
    this->Fail("a TIFF file");
  }
  const char* text = nullptr;
  if (TIFFGetField(this->file, TIFFTAG_IMAGEDESCRIPTION, &text) && text)
  {
    this->description = text;
  }
  try
  {
    do
    {
      this->AddCurrentPages();
    } while (TIFFReadDirectory(this->file));
    if (!this->messages->first.empty())
    {
      this->Fail("readable pages after page " + std::to_string(this->pages.size()));
    }
  }
  catch (...)
  {
    TIFFClose(this->file);
    throw;
  }
}

TiffFile::~TiffFile()
{
  TIFFClose(this->file);
}

void TiffFile::Fail(const std::string& expected)
{
  const std::string& fault = this->messages->first;
  FailToRead(this->path, expected,
    fault.empty() ? "a damaged one"
                  : "the fault " + Quoted(fault.substr(0, fault.find(". ")), 160));
}

void TiffFile::CheckHoldsDirectory(std::uint64_t offset)
{
  // A header of BigTIFF has the version 43.
  const BinaryHeader begin(FirstBytes(this->path), TIFFIsBigEndian(this->file) != 0);
  const bool isBig = begin.At<unsigned short>(2) == 43;
  std::string count(8, '\0');
  OpenStream(this->path, Compression::None, offset)->Read(count.data(), count.size());
  const BinaryHeader numbers(count, TIFFIsBigEndian(this->file) != 0);
  const double end = double(offset) +
    (isBig ? 16.0 + 20.0 * double(numbers.At<std::uint64_t>(0))
           : 6.0 + 12.0 * double(numbers.At<unsigned short>(0)));
  const double fileBytes = double(ReadableFileSize(this->path));
  if (end > fileBytes)
  {
    FailToRead(this->path, "a directory of a page that ends at " + ByteText(end),
      "a file of " + ByteText(fileBytes));
  }
}

TiffPage TiffFile::CurrentPage()
{
  TiffPage page = {};
  page.layout = { { TiffTag<std::uint32_t>(this->file, TIFFTAG_IMAGEWIDTH),
                    TiffTag<std::uint32_t>(this->file, TIFFTAG_IMAGELENGTH), 1 },
    TypeOfTiffPixels(this->file), TiffTag<std::uint16_t>(this->file, TIFFTAG_SAMPLESPERPIXEL) };
  if (page.layout.scalarType == VTK_VOID)
  {
    char fault[1024] = {};
    if (!TIFFRGBAImageOK(this->file, fault))
    {
      FailToRead(
        this->path, "pixels of 8 to 64 bits or colours", "the fault " + Quoted(fault, 160));
    }
    const bool isGrey = TiffTag<std::uint16_t>(this->file, TIFFTAG_PHOTOMETRIC) <= 1;
    page.layout.scalarType = VTK_UNSIGNED_CHAR;
    page.layout.componentCount = isGrey ? 1 : 3;
  }
  page.isReduced =
    (TiffTag<std::uint32_t>(this->file, TIFFTAG_SUBFILETYPE) & FILETYPE_REDUCEDIMAGE) != 0;
  page.isInverted =
    TiffTag<std::uint16_t>(this->file, TIFFTAG_PHOTOMETRIC) == PHOTOMETRIC_MINISWHITE &&
    TypeOfTiffPixels(this->file) != VTK_VOID;
  page.holdsColors = HoldsColors(this->file);
  page.orientation = TiffTag<std::uint16_t>(this->file, TIFFTAG_ORIENTATION);
  page.directory = TIFFCurrentDirOffset(this->file);
  this->CheckHoldsDirectory(page.directory);
  page.pixelsPerUnit = { double(TiffTag<float>(this->file, TIFFTAG_XRESOLUTION)),
    double(TiffTag<float>(this->file, TIFFTAG_YRESOLUTION)) };
  page.mmPerUnit = MmPerUnit(this->file);
  return page;
}

void TiffFile::AddCurrentPages()
{
  constexpr std::size_t MostPages = 10000000;
  const std::size_t depth =
    std::max<std::uint32_t>(1, TiffTag<std::uint32_t>(this->file, TIFFTAG_IMAGEDEPTH));
  TiffPage page = this->CurrentPage();
  if (depth > MostPages - std::min(MostPages, this->pages.size()))
  {
    FailToRead(this->path, "at most 10000000 pages", std::to_string(depth) + " in one directory");
  }
  const bool isPlanar = page.layout.componentCount > 1 &&
    TiffTag<std::uint16_t>(this->file, TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE;
  const bool isPacked = TiffTag<std::uint16_t>(this->file, TIFFTAG_COMPRESSION) != COMPRESSION_NONE;
  const bool hasDeepTiles =
    TIFFIsTiled(this->file) && TiffTag<std::uint32_t>(this->file, TIFFTAG_TILEDEPTH) > 1;
  const bool isInPieces = TIFFIsTiled(this->file) && !hasDeepTiles;
  if (depth > 1 && !isInPieces && (isPacked || (isPlanar && !hasDeepTiles)))
  {
    FailToRead(this->path,
      "several slices of a directory (ImageDepth) uncompressed or in tiles of one slice",
      isPacked ? "compressed ones" : "planes for each component");
  }
  for (page.slice = 0; page.slice < depth; ++page.slice)
  {
    this->pages.push_back(page);
  }
}

void TiffFile::AddPagesBehindFirst(std::size_t count)
{
  if (TiffTag<std::uint16_t>(this->file, TIFFTAG_COMPRESSION) != COMPRESSION_NONE)
  {
    FailToRead(this->path, std::to_string(count + 1) + " pages", "one compressed page");
  }
  TiffPage page = this->pages.front();
  for (page.slice = 1; page.slice <= count; ++page.slice)
  {
    this->pages.push_back(page);
  }
}

void TiffFile::SplitSamples()
{
  std::vector<TiffPage> split;
  for (std::size_t i = 0; i < this->pages.size(); ++i)
  {
    this->SelectPage(i);
    TiffPage page = this->pages[i];
    const bool isPlanar = TypeOfTiffPixels(this->file) != VTK_VOID &&
      TiffTag<std::uint16_t>(this->file, TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE;
    const std::int64_t count = isPlanar ? page.layout.componentCount : 1;
    page.layout.componentCount /= count;
    page.holdsColors = page.holdsColors && count == 1;
    for (int sample = 0; sample < count; ++sample)
    {
      page.sample = count > 1 ? std::optional(sample) : std::nullopt;
      split.push_back(page);
    }
  }
  this->pages = std::move(split);
}

void TiffFile::SelectPage(std::size_t page)
{
  if (TIFFCurrentDirOffset(this->file) != this->pages[page].directory &&
    !TIFFSetSubDirectory(this->file, this->pages[page].directory))
  {
    this->Fail("a readable page " + std::to_string(page + 1));
  }
}

}
