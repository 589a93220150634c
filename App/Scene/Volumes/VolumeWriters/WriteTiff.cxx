// OME-TIFF: a page for each slice, and a description in XML. See
// https://docs.openmicroscopy.org/ome-model/latest/ome-tiff/specification.html
#include "Scene/Volumes/VolumeWriters/VolumeWriters.h"
#include "Scene/Volumes/VolumeWriters/WrittenImage.h"

#include <tiffio.h>

#include <cerrno>
#include <memory>
#include <stdexcept>

namespace varimarch
{

namespace
{

/// Files beyond this size need BigTIFF [bytes].
constexpr std::size_t LargestTiffBytes = std::size_t(4000) << 20;

std::string Attribute(const std::string& name, const std::string& value)
{
  return ' ' + name + "=\"" + value + '"';
}

std::string DescriptionOf(const WrittenImage& image, const ZarrInput& input)
{
  const std::string spacing = TextOf(input.spacingMm);
  const std::size_t second = spacing.find(' ') + 1;
  const std::size_t third = spacing.rfind(' ') + 1;
  const std::string count = std::to_string(image.ComponentCount());
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>"
                     "<OME xmlns=\"http://www.openmicroscopy.org/Schemas/OME/2016-06\">"
                     "<Image ID=\"Image:0\"><Pixels ID=\"Pixels:0\" DimensionOrder=\"XYCZT\"";
  text += Attribute("Type", image.Type().ome) +
    Attribute("SizeX", std::to_string(input.dimensions[0])) +
    Attribute("SizeY", std::to_string(input.dimensions[1])) +
    Attribute("SizeZ", std::to_string(input.dimensions[2])) + Attribute("SizeC", count) +
    Attribute("SizeT", "1") + Attribute("PhysicalSizeX", spacing.substr(0, second - 1)) +
    Attribute("PhysicalSizeY", spacing.substr(second, third - 1 - second)) +
    Attribute("PhysicalSizeZ", spacing.substr(third)) + Attribute("PhysicalSizeXUnit", "mm") +
    Attribute("PhysicalSizeYUnit", "mm") + Attribute("PhysicalSizeZUnit", "mm");
  return text + "><Channel ID=\"Channel:0:0\"" + Attribute("SamplesPerPixel", count) +
    "/><TiffData IFD=\"0\"" + Attribute("PlaneCount", std::to_string(input.dimensions[2])) +
    "/></Pixels></Image></OME>";
}

int FormatOf(const WrittenImage& image)
{
  const std::string name = image.Type().ome;
  return name == "float" || name == "double" ? SAMPLEFORMAT_IEEEFP
    : name.front() == 'u'                    ? SAMPLEFORMAT_UINT
                                             : SAMPLEFORMAT_INT;
}

void SetTags(TIFF* file, const WrittenImage& image, const ZarrInput& input)
{
  const int count = image.ComponentCount();
  const int colourCount = count >= 3 ? 3 : 1;
  TIFFSetField(file, TIFFTAG_IMAGEWIDTH, int(input.dimensions[0]));
  TIFFSetField(file, TIFFTAG_IMAGELENGTH, int(input.dimensions[1]));
  TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, int(8 * image.ValueBytes()));
  TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, count);
  TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, FormatOf(image));
  TIFFSetField(
    file, TIFFTAG_PHOTOMETRIC, colourCount == 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK);
  TIFFSetField(file, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(file, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  if (count > colourCount)
  {
    const std::uint16_t kinds[4] = {};
    TIFFSetField(file, TIFFTAG_EXTRASAMPLES, count - colourCount, kinds);
  }
  TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, int(input.dimensions[1]));
}

/// Ignores libtiff's message, which it would print; the system's reason is reported.
int Ignore(TIFF*, void*, const char*, const char*, va_list)
{
  return 1;
}

std::unique_ptr<TIFF, void (*)(TIFF*)> NewTiff(const std::string& path, bool isBig)
{
  TIFFOpenOptions* const options = TIFFOpenOptionsAlloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options, Ignore, nullptr);
  TIFFOpenOptionsSetWarningHandlerExtR(options, Ignore, nullptr);
  TIFF* const file = TIFFOpenExt(path.c_str(), isBig ? "w8" : "w", options);
  TIFFOpenOptionsFree(options);
  return { file, TIFFClose };
}

}

bool WriteTiffFile(const LoadedVolume& volume, const std::string& path, bool)
{
  const WrittenImage image(path, volume.image);
  if (!*image.Type().ome)
  {
    throw std::runtime_error(path +
      ": expected voxels of 8 to 32 bits or floats, as OME-TIFF "
      "allows, found integers of 64 bits; NRRD holds them");
  }
  const auto file = NewTiff(path, image.ByteCount() > LargestTiffBytes);
  if (!file)
  {
    return false;
  }
  const ZarrInput input = InLpsOrder(ZarrInputOf(volume));
  const auto [width, height, sliceCount] = input.dimensions;
  std::vector<char> values(image.ByteCount() / std::size_t(sliceCount));
  for (std::int64_t slice = 0; slice < sliceCount; ++slice)
  {
    SetTags(file.get(), image, input);
    if (slice == 0)
    {
      TIFFSetField(file.get(), TIFFTAG_IMAGEDESCRIPTION, DescriptionOf(image, input).c_str());
    }
    input.read({ 0, 0, slice }, { width, height, slice + 1 }, values.data());
    if (TIFFWriteEncodedStrip(file.get(), 0, values.data(), tmsize_t(values.size())) < 0 ||
      !TIFFWriteDirectory(file.get()))
    {
      return false;
    }
  }
  return TIFFFlush(file.get()) == 1;
}

}
