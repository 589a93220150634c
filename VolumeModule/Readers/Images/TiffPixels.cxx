// The part of TiffFile that decodes pixels: of colours, of numbers in strips or tiles, and of pages
// without directories.
#include "Readers/ByteStream.h"
#include "Readers/FileError.h"
#include "Readers/Images/TiffFile.h"
#include "Readers/Images/TiffMessages.h"
#include "Readers/Images/TiffTags.h"

#include <vtkByteSwap.h>
#include <vtkDataArray.h>

#include <algorithm>

namespace varimarch
{

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
