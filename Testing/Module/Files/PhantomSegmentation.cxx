#include "PhantomSegmentation.h"

#include <glm/geometric.hpp>

namespace phantom_dicom
{
namespace
{

constexpr const char* SegmentationClass = "1.2.840.10008.5.1.4.1.1.66.4";
constexpr const char* LabelsClass = "1.2.840.10008.5.1.4.1.1.66.7";

Element SegmentItems(const std::vector<DescribedSegment>& segments)
{
  std::vector<Elements> items;
  for (const DescribedSegment& segment : segments)
  {
    items.push_back({ { 0x00620004, Shorts({ segment.number }) },
      { 0x00620005, Text("LO", segment.label) }, { 0x00620008, Text("CS", "MANUAL") } });
    if (!segment.lab.empty())
    {
      items.back()[0x0062000d] = Shorts(segment.lab);
    }
  }
  return Sequence(items);
}

Element FrameItems(const StoredVolume& grid, const std::vector<SegmentFrame>& frames)
{
  std::vector<Elements> items;
  for (const SegmentFrame& frame : frames)
  {
    const glm::dvec3 position = grid.originMm + double(frame.slice) * grid.axesMm[2];
    items.push_back({ { 0x00209113,
      Sequence({ { { 0x00200032, Decimals({ position.x, position.y, position.z }) } } }) } });
    if (frame.segment != 0)
    {
      items.back()[0x0062000a] = Sequence({ { { 0x0062000b, Shorts({ frame.segment }) } } });
    }
  }
  return Sequence(items);
}

/// Pixels of one bit, the first in the lowest bit, without gaps between frames (PS3.5 8.1.1).
Element Bits(const std::vector<int>& pixels)
{
  std::string bytes((pixels.size() + 7) / 8, '\0');
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    bytes[i / 8] = char(bytes[i / 8] | (pixels[i] != 0) << (i % 8));
  }
  return { "OB", bytes };
}

Element Bytes(const std::vector<int>& pixels)
{
  return { "OB", std::string(pixels.begin(), pixels.end()) };
}

}

Element SharedItems(const StoredVolume& grid, bool hasDistance)
{
  const glm::dvec3 row = glm::normalize(grid.axesMm[0]);
  const glm::dvec3 column = glm::normalize(grid.axesMm[1]);
  const Elements orientation = { { 0x00200037,
    Decimals({ row.x, row.y, row.z, column.x, column.y, column.z }) } };
  Elements measures = { { 0x00180050, Decimals({ glm::length(grid.axesMm[2]) }) },
    { 0x00180088, Decimals({ glm::length(grid.axesMm[2]) }) },
    { 0x00280030, Decimals({ glm::length(grid.axesMm[1]), glm::length(grid.axesMm[0]) }) } };
  if (!hasDistance)
  {
    measures.erase(0x00180088);
  }
  return Sequence(
    { { { 0x00209116, Sequence({ orientation }) }, { 0x00289110, Sequence({ measures }) } } });
}

Elements Segmentation(const StoredVolume& grid, const std::vector<DescribedSegment>& segments,
  const std::vector<SegmentFrame>& frames, SegmentationType type)
{
  const bool isBinary = type == SegmentationType::Binary;
  const int bits = isBinary ? 1 : 8;
  std::vector<int> pixels;
  for (const SegmentFrame& frame : frames)
  {
    pixels.insert(pixels.end(), frame.pixels.begin(), frame.pixels.end());
  }
  return {
    { 0x00080016, Text("UI", type == SegmentationType::Labels ? LabelsClass : SegmentationClass) },
    { 0x00080018, Text("UI", "1.2.66.1") },
    { 0x00080060, Text("CS", "SEG") },
    { 0x0020000d, Text("UI", "1.2") },
    { 0x0020000e, Text("UI", "1.2.66") },
    { 0x00200052, Text("UI", "1.2.52") },
    { 0x00280002, Shorts({ 1 }) },
    { 0x00280004, Text("CS", "MONOCHROME2") },
    { 0x00280008, Text("IS", std::to_string(frames.size())) },
    { 0x00280010, Shorts({ grid.dimensions[1] }) },
    { 0x00280011, Shorts({ grid.dimensions[0] }) },
    { 0x00280100, Shorts({ bits }) },
    { 0x00280101, Shorts({ bits }) },
    { 0x00280102, Shorts({ bits - 1 }) },
    { 0x00280103, Shorts({ 0 }) },
    { 0x00620001,
      Text("CS",
        isBinary                             ? "BINARY"
          : type == SegmentationType::Labels ? "LABELMAP"
                                             : "FRACTIONAL") },
    { 0x00620002, SegmentItems(segments) },
    { 0x0062000e, Shorts({ 200 }) },
    { 0x52009229, SharedItems(grid) },
    { 0x52009230, FrameItems(grid, frames) },
    { 0x7fe00010, isBinary ? Bits(pixels) : Bytes(pixels) },
  };
}

}
