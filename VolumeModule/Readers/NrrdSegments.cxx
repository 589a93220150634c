#include "Readers/NrrdSegments.h"

#include "Readers/FileError.h"
#include "Readers/NumberText.h"
#include "Readers/SegmentOverlap.h"
#include "Readers/VoxelLayout.h"

#include <cmath>
#include <map>

namespace varimarch
{
namespace
{

/// A segment, and the layer that its voxels have its label in.
struct LayeredSegment
{
  LabelledSegment segment;
  std::int64_t layer;
};

class SegmentPairs
{
public:
  SegmentPairs(const NrrdHeader& header, int segment)
    : header(header)
    , prefix("Segment" + std::to_string(segment) + "_")
  {
  }

  std::string Text(const std::string& key) const
  {
    const auto pair = this->header.pairs.find(this->prefix + key);
    return pair == this->header.pairs.end() ? std::string() : pair->second;
  }

  std::int64_t IntegerOr(const std::string& key, std::int64_t otherwise) const
  {
    const std::string text = this->Text(key);
    return text.empty()
      ? otherwise
      : IntegerFromText(this->header.path, "a whole number as " + this->prefix + key, text);
  }

  std::optional<glm::dvec3> Colour() const
  {
    const std::string text = this->Text("Color");
    if (text.empty())
    {
      return std::nullopt;
    }
    const auto rgb = NumbersFromText(this->header.path, this->prefix + "Color", text, 3);
    return glm::dvec3(rgb[0], rgb[1], rgb[2]);
  }

private:
  const NrrdHeader& header;
  std::string prefix;
};

bool HasPairs(const NrrdHeader& header, int segment)
{
  const std::string prefix = "Segment" + std::to_string(segment) + "_";
  const auto first = header.pairs.lower_bound(prefix);
  return first != header.pairs.end() && first->first.compare(0, prefix.size(), prefix) == 0;
}

/// The segments in their order. Files of before 2020 have a layer for each segment, and do not say
/// so.
std::vector<LayeredSegment> SegmentsOf(const NrrdHeader& header, std::int64_t layerCount)
{
  std::vector<LayeredSegment> segments;
  for (int i = 0; HasPairs(header, i); ++i)
  {
    const SegmentPairs pairs(header, i);
    const std::int64_t layer = pairs.IntegerOr("Layer", layerCount > 1 ? i : 0);
    if (layer < 0 || layer >= layerCount)
    {
      FailToRead(header.path,
        "Segment" + std::to_string(i) + " in one of " + std::to_string(layerCount) +
          " layers, counted from 0",
        "layer " + std::to_string(layer));
    }
    const auto label = int(pairs.IntegerOr("LabelValue", 1));
    segments.push_back({ { label, pairs.Text("Name"), pairs.Colour() }, layer });
  }
  return segments;
}

/// For each layer, the numbers of the segments of its labels.
using NumbersOfLayers = std::vector<std::map<int, std::uint16_t>>;

/// Puts the segments of one layer of some voxels over those of the layers before.
template <class Value>
void PutLayer(const Value* values, std::size_t layer, const NumbersOfLayers& layers,
  std::vector<std::uint16_t>& numbers)
{
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const auto found = layers[layer].find(int(values[i * layers.size() + layer]));
    numbers[i] = found == layers[layer].end() ? std::uint16_t(0) : found->second;
  }
}

void MergeLayers(const NumbersOfLayers& layers, SegmentOverlap& overlap, Volume& volume)
{
  const int* const size = volume.image->GetDimensions();
  const auto merged = AllocatedImage({ { size[0], size[1], size[2] }, VTK_UNSIGNED_SHORT });
  auto* const voxels = static_cast<std::uint16_t*>(merged->GetScalarPointer());
  std::fill_n(voxels, merged->GetNumberOfPoints(), std::uint16_t(0));
  std::vector<std::uint16_t> numbers(std::size_t(size[0]) * std::size_t(size[1]));
  for (int slice = 0; slice < size[2]; ++slice)
  {
    const void* const begin = volume.image->GetScalarPointer(0, 0, slice);
    for (std::size_t layer = 0; layer < layers.size(); ++layer)
    {
      switch (volume.image->GetScalarType())
      {
        vtkTemplateMacro(PutLayer(static_cast<const VTK_TT*>(begin), layer, layers, numbers));
      }
      overlap.Put(numbers, voxels + std::size_t(slice) * numbers.size());
    }
  }
  volume.image = merged;
}

}

bool HoldsSegments(const NrrdHeader& header)
{
  return HasPairs(header, 0);
}

NrrdAxes LayersAsComponents(const NrrdAxes& axes)
{
  NrrdAxes layered = axes;
  layered.planar = axes.planar || (axes.volumeCount > 1 && !axes.areAlternating);
  layered.componentCount *= axes.volumeCount;
  layered.volumeCount = 1;
  layered.areAlternating = false;
  return layered;
}

void TakeSegments(const NrrdHeader& header, Volume& volume)
{
  const std::int64_t layerCount = volume.image->GetNumberOfScalarComponents();
  std::vector<LayeredSegment> segments = SegmentsOf(header, layerCount);
  NumbersOfLayers layers(static_cast<std::size_t>(layerCount));
  std::vector<LabelledSegment> described;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    LabelledSegment& segment = segments[i].segment;
    if (layerCount > 1)
    {
      layers[std::size_t(segments[i].layer)][segment.value] = std::uint16_t(i + 1);
      segment.value = int(i + 1);
    }
    described.push_back(segment);
  }
  if (layerCount > 1)
  {
    SegmentOverlap overlap;
    MergeLayers(layers, overlap, volume);
    overlap.Warn(described, volume.warnings);
  }
  volume.segments = described;
}

}
