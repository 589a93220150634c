#include "Readers/Images/TiffFile.h"

#include "Readers/FileError.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Parsing/BinaryHeader.h"
#include "Readers/Parsing/FileContent.h"
#include "Readers/VoxelLayout.h"

#include <vtkByteSwap.h>
#include <vtkDataArray.h>
#include <vtkType.h>

#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdint>
#include <cstdio>

namespace varimarch
{

/// Collects libtiff's errors, which it would otherwise print.
struct TiffFile::Messages
{
  std::string first;

  static int Take(TIFF*, void* self, const char*, const char* format, va_list arguments)
  {
    char text[200];
    std::vsnprintf(text, sizeof(text), format, arguments);
    std::string& first = static_cast<Messages*>(self)->first;
    first = first.empty() ? text : first;
    return 1;
  }

  static int Ignore(TIFF*, void*, const char*, const char*, va_list) { return 1; }
};

namespace
{

/// A tag's value in the current directory, or its default according to the TIFF specification.
template <class Value>
Value TiffTag(TIFF* file, std::uint32_t tag)
{
  Value value = 0;
  TIFFGetFieldDefaulted(file, tag, &value);
  return value;
}

/// The VTK type of pixels that are stored as numbers; VTK_VOID for colours of another kind.
int TypeOfTiffPixels(TIFF* file)
{
  const auto photometric = TiffTag<std::uint16_t>(file, TIFFTAG_PHOTOMETRIC);
  const bool isPlain = photometric == PHOTOMETRIC_MINISBLACK ||
    photometric == PHOTOMETRIC_MINISWHITE || photometric == PHOTOMETRIC_RGB;
  const auto bits = TiffTag<std::uint16_t>(file, TIFFTAG_BITSPERSAMPLE);
  const auto format = TiffTag<std::uint16_t>(file, TIFFTAG_SAMPLEFORMAT);
  const NumberKind kind = format == SAMPLEFORMAT_INT ? NumberKind::Signed
    : format == SAMPLEFORMAT_IEEEFP                  ? NumberKind::Float
                                                     : NumberKind::Unsigned;
  const bool isReal = format != SAMPLEFORMAT_COMPLEXINT && format != SAMPLEFORMAT_COMPLEXIEEEFP;
  return isPlain && isReal && bits % 8 == 0 ? ScalarTypeOf(kind, bits / 8) : VTK_VOID;
}

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

/// The pixels of a page in memory, into which decoded rows are put.
struct TiffFile::PixelRows
{
  char* destination;
  std::size_t width;
  std::size_t height;
  std::size_t pixelBytes;  ///< distance of pixels in memory
  std::size_t storedBytes; ///< bytes of a decoded pixel

  void Put(const char* source, std::size_t row, std::size_t column, std::size_t count) const
  {
    char* target = this->destination + (row * this->width + column) * this->pixelBytes;
    for (std::size_t i = 0; i < count; ++i)
    {
      std::copy_n(source + i * this->storedBytes, this->storedBytes, target + i * this->pixelBytes);
    }
  }
};

void TiffFile::CheckHoldsPage(std::size_t page)
{
  this->SelectPage(page);
  const double fileBytes = double(ReadableFileSize(this->path));
  const double pageBytes = double(CheckedByteCount(this->path, this->pages[page].layout));
  double storedBytes = 0.0;
  double endBytes = 0.0;
  const bool isTiled = TIFFIsTiled(this->file) != 0;
  const std::uint32_t count =
    isTiled ? TIFFNumberOfTiles(this->file) : TIFFNumberOfStrips(this->file);
  for (std::uint32_t i = 0; i < count; ++i)
  {
    const double bytes = double(TIFFGetStrileByteCount(this->file, i));
    storedBytes += bytes;
    endBytes = std::max(endBytes, double(TIFFGetStrileOffset(this->file, i)) + bytes);
  }
  if (!isTiled && this->pages[page].slice > 0)
  {
    endBytes =
      double(TIFFGetStrileOffset(this->file, 0)) + pageBytes * double(this->pages[page].slice + 1);
  }
  // The densest method is zstd's, with blocks of 128 kB that repeat one byte. Values of fewer than
  // 8 bits and colours with few samples take less than the page's bytes.
  const bool isCompressed =
    TiffTag<std::uint16_t>(this->file, TIFFTAG_COMPRESSION) != COMPRESSION_NONE;
  const double mostBytes = storedBytes * (isCompressed ? 40000.0 : 24.0);
  if (endBytes > fileBytes || mostBytes < pageBytes)
  {
    FailToRead(this->path, ByteText(pageBytes) + " of pixels in page " + std::to_string(page + 1),
      ByteText(std::max(0.0, std::min(storedBytes, fileBytes))) + " of a file of " +
        ByteText(fileBytes));
  }
}

void TiffFile::ReadPage(std::size_t index, void* destination)
{
  this->SelectPage(index);
  const TiffPage& page = this->pages[index];
  this->messages->first.clear();
  if (page.slice > 0 && !TIFFIsTiled(this->file))
  {
    this->ReadBehindFirst(index, destination);
    return;
  }
  if (TypeOfTiffPixels(this->file) == VTK_VOID)
  {
    this->ReadAsColours(page, destination);
    return;
  }
  const auto valueBytes = std::size_t(vtkDataArray::GetDataTypeSize(page.layout.scalarType));
  const auto pixelBytes = valueBytes * std::size_t(page.layout.componentCount);
  const bool isPlanar =
    TiffTag<std::uint16_t>(this->file, TIFFTAG_PLANARCONFIG) == PLANARCONFIG_SEPARATE;
  const int planeCount = isPlanar ? int(page.layout.componentCount) : 1;
  const int firstPlane = page.sample.value_or(0);
  for (int plane = firstPlane; plane < firstPlane + planeCount; ++plane)
  {
    const auto component = std::size_t(plane - firstPlane);
    const PixelRows rows = { static_cast<char*>(destination) + component * valueBytes,
      std::size_t(page.layout.dimensions[0]), std::size_t(page.layout.dimensions[1]), pixelBytes,
      isPlanar ? valueBytes : pixelBytes };
    TIFFIsTiled(this->file) ? this->ReadTiles(rows, std::uint16_t(plane), page.slice)
                            : this->ReadStrips(rows, std::uint16_t(plane));
  }
}

void TiffFile::ReadBehindFirst(std::size_t index, void* destination)
{
  const TiffPage& page = this->pages[index];
  const std::uint64_t pageBytes = CheckedByteCount(this->path, page.layout);
  const std::uint64_t offset = TIFFGetStrileOffset(this->file, 0) + page.slice * pageBytes;
  const auto stream = OpenStream(this->path, Compression::None, offset);
  if (stream->Read(destination, std::size_t(pageBytes)) < pageBytes)
  {
    this->Fail("complete pixels");
  }
  if (TIFFIsByteSwapped(this->file))
  {
    const int valueBytes = vtkDataArray::GetDataTypeSize(page.layout.scalarType);
    vtkByteSwap::SwapVoidRange(
      destination, std::size_t(pageBytes) / std::size_t(valueBytes), std::size_t(valueBytes));
  }
}

void TiffFile::ReadAsColours(const TiffPage& page, void* destination)
{
  const auto width = std::uint32_t(page.layout.dimensions[0]);
  const auto height = std::uint32_t(page.layout.dimensions[1]);
  std::vector<std::uint32_t> pixels(std::size_t(width) * height);
  if (!TIFFReadRGBAImageOriented(this->file, width, height, pixels.data(), page.orientation, 1))
  {
    this->Fail("complete pixels");
  }
  auto* values = static_cast<unsigned char*>(destination);
  for (const std::uint32_t pixel : pixels)
  {
    const unsigned char colours[3] = { static_cast<unsigned char>(TIFFGetR(pixel)),
      static_cast<unsigned char>(TIFFGetG(pixel)), static_cast<unsigned char>(TIFFGetB(pixel)) };
    values = std::copy_n(colours, page.layout.componentCount, values);
  }
}

void TiffFile::ReadStrips(const PixelRows& rows, std::uint16_t plane)
{
  std::vector<char> row(std::size_t(TIFFScanlineSize64(this->file)));
  for (std::size_t y = 0; y < rows.height; ++y)
  {
    if (row.size() < rows.width * rows.storedBytes ||
      TIFFReadScanline(this->file, row.data(), std::uint32_t(y), plane) != 1)
    {
      this->Fail("complete pixels");
    }
    rows.Put(row.data(), y, 0, rows.width);
  }
}

bool TiffFile::ReadTile(const std::array<std::uint32_t, 3>& place, std::uint16_t plane,
  int valueBytes, std::vector<char>& slice)
{
  const auto [x, y, z] = place;
  const auto depth = std::size_t(TiffTag<std::uint32_t>(this->file, TIFFTAG_TILEDEPTH));
  if (depth <= 1)
  {
    return TIFFReadTile(this->file, slice.data(), x, y, z, plane) >= 0;
  }
  // libtiff decodes only the first slice of such tiles, so they are read as they are stored.
  if (double(depth) * double(slice.size()) > double(ReadableFileSize(this->path)))
  {
    return false;
  }
  std::vector<char> tile(depth * slice.size());
  const std::uint32_t number = TIFFComputeTile(this->file, x, y, z, plane);
  if (TIFFReadRawTile(this->file, number, tile.data(), tmsize_t(tile.size())) <
    tmsize_t(tile.size()))
  {
    return false;
  }
  const auto begin = tile.begin() + std::ptrdiff_t(z % depth * slice.size());
  std::copy_n(begin, slice.size(), slice.begin());
  if (TIFFIsByteSwapped(this->file))
  {
    vtkByteSwap::SwapVoidRange(
      slice.data(), slice.size() / std::size_t(valueBytes), std::size_t(valueBytes));
  }
  return true;
}

void TiffFile::ReadTiles(const PixelRows& rows, std::uint16_t plane, std::uint64_t slice)
{
  const auto tileWidth = std::size_t(TiffTag<std::uint32_t>(this->file, TIFFTAG_TILEWIDTH));
  const auto tileHeight = std::size_t(TiffTag<std::uint32_t>(this->file, TIFFTAG_TILELENGTH));
  const int valueBytes = TiffTag<std::uint16_t>(this->file, TIFFTAG_BITSPERSAMPLE) / 8;
  std::vector<char> tile(std::size_t(TIFFTileSize64(this->file)));
  if (tile.empty() || tile.size() < tileWidth * tileHeight * rows.storedBytes)
  {
    this->Fail("tiles of pixels");
  }
  for (std::size_t y = 0; y < rows.height; y += tileHeight)
  {
    for (std::size_t x = 0; x < rows.width; x += tileWidth)
    {
      if (!this->ReadTile(
            { std::uint32_t(x), std::uint32_t(y), std::uint32_t(slice) }, plane, valueBytes, tile))
      {
        this->Fail("complete pixels");
      }
      for (std::size_t row = 0; row < std::min(tileHeight, rows.height - y); ++row)
      {
        rows.Put(tile.data() + row * tileWidth * rows.storedBytes, y + row, x,
          std::min(tileWidth, rows.width - x));
      }
    }
  }
}

}
