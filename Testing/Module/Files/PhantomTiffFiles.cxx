#include "PhantomLibraryFiles.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <tiffio.h>

#include <algorithm>
#include <fstream>

namespace
{

void SetTags(TIFF* file, const StoredVolume& volume, const TiffOptions& options)
{
  const int type = volume.scalarType;
  const bool isFloat = type == VTK_FLOAT || type == VTK_DOUBLE;
  const bool isSigned = type == VTK_SIGNED_CHAR || type == VTK_SHORT || type == VTK_INT;
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, volume.dimensions[0]);
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, volume.dimensions[1]);
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, 8 * vtkDataArray::GetDataTypeSize(type));
  TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, options.samples);
  TIFFSetField(file, TIFFTAG_SAMPLEFORMAT,
    isFloat      ? SAMPLEFORMAT_IEEEFP
      : isSigned ? SAMPLEFORMAT_INT
                 : SAMPLEFORMAT_UINT);
  TIFFSetField(
    file, TIFFTAG_PHOTOMETRIC, options.samples >= 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
  TIFFSetField(
    file, TIFFTAG_PLANARCONFIG, options.isPlanar ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG);
  TIFFSetField(file, TIFFTAG_COMPRESSION, options.compression);
  TIFFSetField(file, TIFFTAG_ORIENTATION, options.orientation);
  if (options.isTiled)
  {
    TIFFSetField(file, TIFFTAG_TILEWIDTH, 16);
    TIFFSetField(file, TIFFTAG_TILELENGTH, 16);
  }
  else
  {
    TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, 2);
  }
  if (options.pixelsPerCentimetre > 0.0)
  {
    TIFFSetField(file, TIFFTAG_RESOLUTIONUNIT, RESUNIT_CENTIMETER);
    TIFFSetField(file, TIFFTAG_XRESOLUTION, options.pixelsPerCentimetre);
    TIFFSetField(file, TIFFTAG_YRESOLUTION, options.pixelsPerCentimetre);
  }
}

/// Writes one plane of a page: `stored` values of each pixel, from `first` on.
void WritePlane(
  TIFF* file, const StoredVolume& volume, const TiffOptions& options, const char* page, int plane)
{
  const auto width = std::size_t(volume.dimensions[0]);
  const auto height = std::size_t(volume.dimensions[1]);
  const auto valueBytes = std::size_t(vtkDataArray::GetDataTypeSize(volume.scalarType));
  const std::size_t pixelBytes = valueBytes * std::size_t(options.samples);
  const std::size_t storedBytes = options.isPlanar ? valueBytes : pixelBytes;
  // One tile or, for strips, one row.
  const std::size_t blockWidth = options.isTiled ? 16 : width;
  const std::size_t blockHeight = options.isTiled ? 16 : 1;
  for (std::size_t y = 0; y < height; y += blockHeight)
  {
    for (std::size_t x = 0; x < width; x += blockWidth)
    {
      std::string block(blockWidth * blockHeight * storedBytes, '\0');
      for (std::size_t row = y; row < std::min(height, y + blockHeight); ++row)
      {
        for (std::size_t column = x; column < std::min(width, x + blockWidth); ++column)
        {
          std::copy_n(page + (row * width + column) * pixelBytes + std::size_t(plane) * valueBytes,
            storedBytes, block.data() + ((row - y) * blockWidth + column - x) * storedBytes);
        }
      }
      options.isTiled
        ? TIFFWriteTile(
            file, block.data(), std::uint32_t(x), std::uint32_t(y), 0, std::uint16_t(plane))
        : tmsize_t(TIFFWriteScanline(file, block.data(), std::uint32_t(y), std::uint16_t(plane)));
    }
  }
}

}

void WriteTiff(const std::string& path, const StoredVolume& volume, const TiffOptions& options)
{
  const std::string mode =
    std::string("w") + (options.bigEndian ? 'b' : 'l') + (options.isBig ? "8" : "");
  TIFF* const file = TIFFOpen(path.c_str(), mode.c_str());
  const std::string voxels = VoxelBytes(volume);
  const std::size_t pageBytes = voxels.size() / std::size_t(volume.dimensions[2]);
  for (int page = 0; page < volume.dimensions[2]; ++page)
  {
    SetTags(file, volume, options);
    if (page == 0 && !options.description.empty())
    {
      TIFFSetField(file, TIFFTAG_IMAGEDESCRIPTION, options.description.c_str());
    }
    for (int plane = 0; plane < (options.isPlanar ? options.samples : 1); ++plane)
    {
      WritePlane(file, volume, options, voxels.data() + std::size_t(page) * pageBytes, plane);
    }
    TIFFWriteDirectory(file);
  }
  TIFFClose(file);
}

namespace
{

/// A slice as BMP with 256 shades of grey.
std::string GreyBmp(const StoredVolume& volume, int slice)
{
  const auto number = [](std::size_t value, int byteCount)
  {
    std::string bytes;
    for (int i = 0; i < byteCount; ++i)
    {
      bytes += char(value >> (8 * i));
    }
    return bytes;
  };
  const auto width = std::size_t(volume.dimensions[0]);
  const auto height = std::size_t(volume.dimensions[1]);
  const std::size_t rowBytes = (width + 3) / 4 * 4;
  const std::size_t begin = 14 + 40 + 4 * 256;
  std::string bytes = "BM" + number(begin + rowBytes * height, 4) + number(0, 4) +
    number(begin, 4) + number(40, 4) + number(width, 4) + number(height, 4) + number(1, 2) +
    number(8, 2) + std::string(24, '\0');
  for (std::size_t shade = 0; shade < 256; ++shade)
  {
    bytes += std::string(3, char(shade)) + '\0';
  }
  // The lowest row comes first.
  const std::string voxels = VoxelBytes(volume);
  for (std::size_t row = height; row-- > 0;)
  {
    bytes += voxels.substr((std::size_t(slice) * height + row) * width, width);
    bytes.resize((bytes.size() - begin + 3) / 4 * 4 + begin);
  }
  return bytes;
}

}

void WritePicture(const std::string& path, const StoredVolume& volume, int slice)
{
  const std::string extension = std::filesystem::path(path).extension();
  if (extension == ".bmp")
  {
    std::ofstream(path, std::ios::binary) << GreyBmp(volume, slice);
    return;
  }
  vtkNew<vtkImageData> image;
  const int width = volume.dimensions[0];
  const int height = volume.dimensions[1];
  image->SetDimensions(width, height, 1);
  const int samples = int(volume.values.size()) /
    (volume.dimensions[0] * volume.dimensions[1] * volume.dimensions[2]);
  image->AllocateScalars(volume.scalarType, samples);
  for (int row = 0; row < height; ++row)
  {
    for (int value = 0; value < width * samples; ++value)
    {
      // VTK's first row is the lowest.
      image->SetScalarComponentFromDouble(value / samples, height - 1 - row, 0, value % samples,
        volume.values[std::size_t((slice * height + row) * width * samples + value)]);
    }
  }
  vtkNew<vtkPNGWriter> png;
  vtkNew<vtkJPEGWriter> jpeg;
  jpeg->SetQuality(100);
  vtkImageWriter* const writer =
    extension == ".png" ? static_cast<vtkImageWriter*>(png) : jpeg.Get();
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->Write();
}
