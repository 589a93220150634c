#include "Readers/Dicom/Mosaic.h"

#include "Readers/Dicom/Attributes.h"
#include "Readers/NumberText.h"

#include <vtkDICOMDictHash.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace varimarch
{
namespace
{

/// Siemens' private header, which begins with "SV10" (nibabel, "Siemens format DICOM with CSA
/// header"). GDCM reads it too, but ends the program if it is malformed.
class SiemensHeader
{
public:
  explicit SiemensHeader(std::string bytes)
    : bytes(std::move(bytes))
  {
  }

  /// Values of an attribute; empty if it is absent.
  std::vector<std::string> Values(const std::string& name)
  {
    constexpr std::size_t SignatureSize = 8;
    this->place = SignatureSize;
    const std::uint32_t attributes = this->bytes.compare(0, 4, "SV10") == 0 ? this->Number() : 0;
    this->Number();
    for (std::uint32_t i = 0; i < attributes && this->place < this->bytes.size(); ++i)
    {
      const bool isIt = this->Text(64) == name;
      const std::vector<std::string> values = this->NextValues();
      if (isIt)
      {
        return values;
      }
    }
    return {};
  }

private:
  /// The values of the attribute whose name was just read. Some are blank.
  std::vector<std::string> NextValues()
  {
    std::vector<std::string> values;
    this->place += 3 * sizeof(std::uint32_t); // multiplicity and type
    const std::uint32_t count = this->Number();
    this->Number();
    for (std::uint32_t i = 0; i < count && this->place < this->bytes.size(); ++i)
    {
      this->Number();
      const std::uint32_t length = this->Number();
      this->place += 2 * sizeof(std::uint32_t);
      values.push_back(this->Text(length));
      this->place += (4 - length % 4) % 4;
    }
    return values;
  }

  std::uint32_t Number()
  {
    std::uint32_t number = 0;
    if (this->place + sizeof(number) <= this->bytes.size())
    {
      std::memcpy(&number, this->bytes.data() + this->place, sizeof(number));
    }
    this->place += sizeof(number);
    return number;
  }

  std::string Text(std::size_t length)
  {
    const std::string text =
      this->place < this->bytes.size() ? this->bytes.substr(this->place, length) : "";
    this->place += length;
    return text.substr(0, text.find('\0'));
  }

  std::string bytes;
  std::size_t place = 0;
};

SiemensHeader HeaderOf(vtkDICOMMetaData* meta)
{
  const vtkDICOMTag tag =
    meta->ResolvePrivateTag(vtkDICOMTag(0x0029, 0x0010), "SIEMENS CSA HEADER");
  const vtkDICOMValue& value = meta->Get(tag);
  const unsigned char* const begin = value.IsValid() ? value.GetUnsignedCharData() : nullptr;
  return SiemensHeader(begin ? std::string(begin, begin + value.GetVL()) : std::string());
}

/// Number and order of the slices of a mosaic.
struct Tiling
{
  int count = 0;             ///< 0 if unknown
  glm::dvec3 direction = {}; ///< unit vector from a slice to the next
};

Tiling TilingOf(vtkDICOMMetaData* meta)
{
  SiemensHeader header = HeaderOf(meta);
  const std::vector<std::string> count = header.Values("NumberOfImagesInMosaic");
  const std::vector<std::string> normal = header.Values("SliceNormalVector");
  Tiling tiling;
  if (!count.empty() && normal.size() >= 3)
  {
    constexpr double MostTiles = 10000.0;
    tiling.count = int(std::clamp(NumberIn(count[0]).value_or(0.0), 0.0, MostTiles));
    for (int axis = 0; axis < 3; ++axis)
    {
      tiling.direction[axis] = NumberIn(normal[std::size_t(axis)]).value_or(0.0);
    }
  }
  return tiling;
}

}

bool IsMosaic(vtkDICOMMetaData* meta)
{
  return DicomAttributes(meta).Text(DC::ImageType).find("MOSAIC") != std::string::npos;
}

std::vector<DicomFrame> MosaicTiles(vtkDICOMMetaData* meta, const std::vector<DicomFrame>& frames)
{
  const Tiling tiling = TilingOf(meta);
  const int tilesPerRow = std::max(1, int(std::ceil(std::sqrt(double(tiling.count)))));
  std::vector<DicomFrame> tiles;
  for (const DicomFrame& frame : frames)
  {
    DicomFrame tile = frame;
    tile.size = frame.size / tilesPerRow;
    tile.heightMm.reset();
    for (int i = 0; i < tiling.count; ++i)
    {
      tile.firstPixel = glm::ivec2(i % tilesPerRow, i / tilesPerRow) * tile.size;
      if (frame.positionMm && frame.axes && frame.pixelMm)
      {
        const glm::dvec2 borderMm = 0.5 * glm::dvec2(frame.size - tile.size) * *frame.pixelMm;
        tile.positionMm = *frame.positionMm + *frame.axes * borderMm +
          double(i) * frame.distanceMm.value_or(1.0) * tiling.direction;
      }
      tiles.push_back(tile);
    }
  }
  return tiles;
}

}
