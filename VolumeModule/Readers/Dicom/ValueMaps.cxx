#include "Readers/Dicom/ValueMaps.h"

#include <vtkDICOMDictHash.h>
#include <vtkDICOMItem.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{
namespace
{

/// The entries of a table. Those of 8 bits may stand in pairs in words, the first in the lower byte
/// (PS3.3 C.11.1.1.1).
std::vector<std::uint16_t> EntriesOf(const vtkDICOMValue& descriptor, const vtkDICOMValue& data)
{
  constexpr int ByteBits = 8;
  const std::size_t promised =
    descriptor.GetInt(0) == 0 ? 65536 : std::uint16_t(descriptor.GetInt(0));
  const std::size_t words = data.GetNumberOfValues();
  const bool arePairs = descriptor.GetInt(2) <= ByteBits && words < promised;
  std::vector<std::uint16_t> entries;
  for (std::size_t i = 0; i < std::min(promised, arePairs ? 2 * words : words); ++i)
  {
    const std::uint16_t word = data.GetUnsignedShort(arePairs ? i / 2 : i);
    entries.push_back(!arePairs ? word : std::uint16_t(i % 2 ? word >> ByteBits : word & 0xff));
  }
  return entries;
}

/// An attribute that is a table of numbers.
std::shared_ptr<const DicomTable<std::uint16_t>> ModalityTable(
  const DicomAttributes& attributes, bool isSigned)
{
  const vtkDICOMValue& items = attributes.Value(DC::ModalityLUTSequence);
  if (!items.IsValid() || items.GetNumberOfValues() == 0)
  {
    return nullptr;
  }
  const vtkDICOMItem& item = items.GetItem(0);
  const vtkDICOMValue& descriptor = item.Get(DC::LUTDescriptor);
  const vtkDICOMValue& data = item.Get(DC::LUTData);
  if (!descriptor.IsValid() || descriptor.GetNumberOfValues() != 3 || !data.IsValid())
  {
    return nullptr;
  }
  auto table = std::make_shared<DicomTable<std::uint16_t>>();
  const int first = descriptor.GetInt(1);
  table->first = isSigned ? std::int16_t(first) : std::uint16_t(first);
  table->entries = EntriesOf(descriptor, data);
  return table->entries.empty() ? nullptr : table;
}

/// A stored number of the pixels' own type that the header may contain with another sign.
double WithSignOfPixels(const DicomFile& file, double number)
{
  const double range = std::ldexp(1.0, file.bitsStored);
  const double wrapped = number - range * std::floor(number / range);
  return file.isSigned && wrapped >= 0.5 * range ? wrapped - range : wrapped;
}

/// A map to physical quantities beside, or in place of, that of the modality (PS3.3 C.7.6.16.2.11).
struct RealWorldMap
{
  std::string unit; ///< or its label; may be empty
  std::optional<double> slope;
  double intercept = 0.0;
};

/// The first linear map of a frame, or else its first map.
std::optional<RealWorldMap> RealWorldMapOf(const DicomAttributes& attributes)
{
  const vtkDICOMValue& items = attributes.Value(DC::RealWorldValueMappingSequence);
  std::optional<RealWorldMap> found;
  for (std::size_t i = 0; items.IsValid() && i < items.GetNumberOfValues(); ++i)
  {
    const vtkDICOMItem& item = items.GetItem(i);
    const vtkDICOMValue& slope = item.Get(DC::RealWorldValueSlope);
    const vtkDICOMValue& units = item.Get(DC::MeasurementUnitsCodeSequence);
    RealWorldMap map;
    map.unit = units.IsValid() && units.GetNumberOfValues() > 0
      ? units.GetItem(0).Get(DC::CodeValue).AsUTF8String()
      : item.Get(DC::LUTLabel).AsUTF8String();
    if (slope.IsValid() && slope.GetVL() > 0 && std::isfinite(slope.AsDouble()))
    {
      const vtkDICOMValue& intercept = item.Get(DC::RealWorldValueIntercept);
      map.slope = slope.AsDouble();
      map.intercept = intercept.IsValid() && intercept.GetVL() > 0 ? intercept.AsDouble() : 0.0;
    }
    if (!found || (map.slope && !found->slope))
    {
      found = map;
    }
  }
  return found;
}

/// Applies a real-world map to a frame without another one, or names it.
void TakeRealWorldMap(const DicomAttributes& attributes, bool hasOther, DicomFrame& frame)
{
  const auto map = RealWorldMapOf(attributes);
  if (!map)
  {
    return;
  }
  const bool isApplied = !hasOther && map->slope && *map->slope != 0.0;
  if (isApplied)
  {
    frame.slope = *map->slope;
    frame.intercept = map->intercept;
    frame.isRealWorld = true;
    return;
  }
  const bool isSame =
    map->slope && !frame.table && frame.slope == *map->slope && frame.intercept == map->intercept;
  frame.otherMap = isSame ? "" : map->unit.empty() ? "another quantity" : map->unit;
}

}

void TakeValueMap(const DicomAttributes& attributes, DicomFrame& frame)
{
  const double slope = attributes.NumberOr(DC::RescaleSlope, 1.0);
  frame.slope = slope == 0.0 ? 1.0 : slope;
  frame.intercept = attributes.NumberOr(DC::RescaleIntercept, 0.0);
  const auto scaling = attributes.Number(DC::DoseGridScaling);
  if (scaling)
  {
    frame.slope = *scaling;
  }
  if (!frame.file->isFloat)
  {
    frame.table = ModalityTable(attributes, frame.file->isSigned);
    if (const auto padding = attributes.Number(DC::PixelPaddingValue))
    {
      const double other = attributes.NumberOr(DC::PixelPaddingRangeLimit, *padding);
      const double first = WithSignOfPixels(*frame.file, *padding);
      const double last = WithSignOfPixels(*frame.file, other);
      frame.padding = { std::min(first, last), std::max(first, last) };
    }
  }
  const bool hasOther = frame.table || scaling || attributes.Number(DC::RescaleSlope) ||
    attributes.Number(DC::RescaleIntercept);
  TakeRealWorldMap(attributes, hasOther, frame);
}

}
