#include "Readers/Dicom/Values.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <mutex>
#include <sstream>

namespace varimarch
{
namespace
{

int StoredType(const DicomFrame& frame)
{
  const DicomFile& file = *frame.file;
  if (!file.palette.entries.empty())
  {
    return VTK_UNSIGNED_CHAR;
  }
  if (frame.table)
  {
    return VTK_UNSIGNED_SHORT;
  }
  if (file.isFloat)
  {
    return file.bitsAllocated <= 32 ? VTK_FLOAT : VTK_DOUBLE;
  }
  if (file.bitsAllocated <= 8)
  {
    return file.isSigned ? VTK_SIGNED_CHAR : VTK_UNSIGNED_CHAR;
  }
  if (file.bitsAllocated <= 16)
  {
    return file.isSigned ? VTK_SHORT : VTK_UNSIGNED_SHORT;
  }
  if (file.bitsAllocated <= 32)
  {
    return file.isSigned ? VTK_INT : VTK_UNSIGNED_INT;
  }
  return file.isSigned ? VTK_TYPE_INT64 : VTK_TYPE_UINT64;
}

/// The type that holds the values of both types.
int CommonType(int a, int b)
{
  const auto fitsInt = [](int type)
  {
    const bool isShort = vtkDataArray::GetDataTypeSize(type) <= 2;
    return isShort || type == VTK_INT;
  };
  if (a == b)
  {
    return a;
  }
  return fitsInt(a) && fitsInt(b) ? VTK_INT : VTK_DOUBLE;
}

std::vector<double> RowOf(const DicomFrame& frame, vtkImageData* decoded, int row)
{
  const int samples = decoded->GetNumberOfScalarComponents();
  std::vector<double> values(std::size_t(frame.size.x) * samples);
  const auto copy = [&](const auto* from)
  {
    std::transform(
      from, from + values.size(), values.begin(), [](auto value) { return double(value); });
  };
  const void* const begin =
    decoded->GetScalarPointer(frame.firstPixel.x, frame.firstPixel.y + row, frame.number);
  switch (decoded->GetScalarType())
  {
    vtkTemplateMacro(copy(static_cast<const VTK_TT*>(begin)));
  }
  return values;
}

template <class Entry>
const Entry& EntryOf(const DicomTable<Entry>& table, double stored)
{
  const double last = double(table.entries.size() - 1);
  return table.entries[std::size_t(std::clamp(stored - table.first, 0.0, last))];
}

/// Replaces stored values by the entries of the frame's tables.
std::vector<double> Mapped(const DicomFrame& frame, const std::vector<double>& row)
{
  std::vector<double> mapped;
  for (const double stored : row)
  {
    if (!frame.file->palette.entries.empty())
    {
      const auto& colour = EntryOf(frame.file->palette, stored);
      mapped.insert(mapped.end(), colour.begin(), colour.end());
    }
    else
    {
      mapped.push_back(frame.table ? double(EntryOf(*frame.table, stored)) : stored);
    }
  }
  return mapped;
}

/// Compressed pixels may have another type than their file's attributes promise: values beyond the
/// promised type become its nearest ones.
void PutRow(const std::vector<double>& row, int scalarType, void* begin)
{
  const auto copy = [&](auto* to)
  {
    for (const double value : row)
    {
      vtkMath::RoundDoubleToIntegralIfNecessary(value, to++);
    }
  };
  switch (scalarType)
  {
    vtkTemplateMacro(copy(static_cast<VTK_TT*>(begin)));
  }
}

/// Range of the physical values of a slice that are padding.
std::array<double, 2> PaddingRange(const DicomFrame& frame)
{
  std::array<double, 2> range;
  for (int i = 0; i < 2; ++i)
  {
    const double stored = (*frame.padding)[i];
    range[i] = frame.table ? EntryOf(*frame.table, stored) : frame.slope * stored + frame.intercept;
  }
  std::sort(range.begin(), range.end());
  return range;
}

/// The extremes of the values that are padding, and of the others.
struct PaddingExtremes
{
  double lowestPadding = std::numeric_limits<double>::infinity();
  double lowestOther = std::numeric_limits<double>::infinity();
  double highestOther = -std::numeric_limits<double>::infinity();
  double highestPadding = -std::numeric_limits<double>::infinity();
};

/// Voxels of a volume with padding, slice by slice.
template <class Value>
class PaddedVoxels
{
public:
  PaddedVoxels(const std::vector<DicomFrame>& frames, vtkImageData* image)
    : frames(frames)
    , values(static_cast<Value*>(image->GetScalarPointer()))
    , sliceValues(std::int64_t(image->GetDimensions()[0]) * image->GetDimensions()[1])
  {
  }

  PaddingExtremes Extremes() const
  {
    PaddingExtremes all;
    std::mutex mutex;
    tbb::parallel_for(std::size_t(0), this->frames.size(),
      [&](std::size_t slice)
      {
        PaddingExtremes here;
        this->ForEach(slice,
          [&](Value& value, bool isPadding)
          {
            double& highest = isPadding ? here.highestPadding : here.highestOther;
            highest = std::max(highest, double(value));
            double& lowest = isPadding ? here.lowestPadding : here.lowestOther;
            lowest = std::min(lowest, double(value));
          });
        const std::lock_guard<std::mutex> lock(mutex);
        all.highestPadding = std::max(all.highestPadding, here.highestPadding);
        all.highestOther = std::max(all.highestOther, here.highestOther);
        all.lowestPadding = std::min(all.lowestPadding, here.lowestPadding);
        all.lowestOther = std::min(all.lowestOther, here.lowestOther);
      });
    return all;
  }

  /// Sets padding that is brighter than the image to its lowest value.
  void Darken(const PaddingExtremes& extremes)
  {
    tbb::parallel_for(std::size_t(0), this->frames.size(),
      [&](std::size_t slice)
      {
        this->ForEach(slice,
          [&](Value& value, bool isPadding)
          {
            const bool isBright = isPadding && double(value) > extremes.highestOther;
            value = isBright ? Value(extremes.lowestOther) : value;
          });
      });
  }

private:
  template <class Function>
  void ForEach(std::size_t slice, Function function) const
  {
    const DicomFrame& frame = this->frames[slice];
    const auto range =
      frame.padding ? PaddingRange(frame) : std::array<double, 2>{ 1.0, 0.0 }; // holds no value
    // Rounded as the voxels were.
    const Value first = Value(range[0]);
    const Value last = Value(range[1]);
    const bool hasPadding = frame.padding.has_value();
    Value* const begin = this->values + std::int64_t(slice) * this->sliceValues;
    for (Value* value = begin; value != begin + this->sliceValues; ++value)
    {
      function(*value, hasPadding && first <= *value && *value <= last);
    }
  }

  const std::vector<DicomFrame>& frames;
  Value* values;
  std::int64_t sliceValues;
};

std::string RoundedText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

template <class Value>
std::optional<double> SetToLowest(PaddedVoxels<Value> voxels, std::vector<std::string>& warnings)
{
  const PaddingExtremes extremes = voxels.Extremes();
  const bool hasImage = extremes.lowestOther <= extremes.highestOther;
  if (hasImage && extremes.highestPadding > extremes.highestOther)
  {
    voxels.Darken(extremes);
    warnings.push_back("Voxels that the files mark as outside the image, with values up to " +
      RoundedText(extremes.highestPadding) + ", were set to its lowest value, " +
      RoundedText(extremes.lowestOther) + ".");
  }
  const bool isBelow = hasImage && extremes.lowestPadding < extremes.lowestOther;
  return isBelow ? std::optional<double>(extremes.lowestOther) : std::nullopt;
}

}

VoxelLayout StoredLayout(const std::vector<DicomFrame>& frames)
{
  const DicomFrame& first = frames.front();
  int type = StoredType(first);
  for (const DicomFrame& frame : frames)
  {
    type = CommonType(type, StoredType(frame));
  }
  const bool isPalette = !first.file->palette.entries.empty();
  return { { first.size.x, first.size.y, std::int64_t(frames.size()) }, type,
    isPalette ? 3 : first.file->samples };
}

void PutSlice(const DicomFrame& frame, vtkImageData* decoded, vtkImageData* stored, int slice)
{
  const bool isSame = decoded->GetScalarType() == stored->GetScalarType() && !frame.table &&
    decoded->GetNumberOfScalarComponents() == stored->GetNumberOfScalarComponents();
  const std::size_t rowBytes = std::size_t(frame.size.x) *
    std::size_t(decoded->GetNumberOfScalarComponents()) * std::size_t(decoded->GetScalarSize());
  for (int row = 0; row < frame.size.y; ++row)
  {
    void* const to = stored->GetScalarPointer(0, row, slice);
    if (isSame)
    {
      std::memcpy(to,
        decoded->GetScalarPointer(frame.firstPixel.x, frame.firstPixel.y + row, frame.number),
        rowBytes);
    }
    else
    {
      PutRow(Mapped(frame, RowOf(frame, decoded, row)), stored->GetScalarType(), to);
    }
  }
}

std::vector<Rescale> RescalesOf(const std::vector<DicomFrame>& frames)
{
  std::vector<Rescale> rescales;
  for (const DicomFrame& frame : frames)
  {
    rescales.push_back(frame.table ? Rescale() : Rescale{ frame.slope, frame.intercept });
  }
  return rescales;
}

std::optional<double> SetPaddingToLowest(
  const std::vector<DicomFrame>& frames, vtkImageData* image, std::vector<std::string>& warnings)
{
  const bool isPadded = std::any_of(frames.begin(), frames.end(),
    [](const DicomFrame& frame) { return frame.padding.has_value(); });
  if (!isPadded || image->GetNumberOfScalarComponents() != 1)
  {
    return std::nullopt;
  }
  std::optional<double> lowestInside;
  switch (image->GetScalarType())
  {
    vtkTemplateMacro(lowestInside = SetToLowest(PaddedVoxels<VTK_TT>(frames, image), warnings));
  }
  image->GetPointData()->GetScalars()->Modified(); // discards the cached range
  return lowestInside;
}

}
