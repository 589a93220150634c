#include "Readers/Pyramids/PlainDataSet.h"

#include "Readers/FileError.h"
#include "Readers/HeaderText.h"
#include "Readers/Pyramids/Hdf5File.h"
#include "Readers/Pyramids/Json.h"
#include "Readers/VolumeFile.h"

#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace varimarch
{
namespace
{

/// True for three axes that are long enough for voxels, and perhaps others before them.
bool IsVolume(const Hdf5Layout& layout)
{
  const std::size_t rank = layout.size.size();
  return layout.scalarType != VTK_VOID && rank >= 3;
}

/// The names of a data set's axes: those of ilastik, the labels of HDF5, or the names of their
/// scales; empty texts if it has none of these.
std::vector<std::string> AxisNames(const Hdf5File& file, const std::string& name, std::size_t rank)
{
  std::vector<std::string> names;
  const nlohmann::json axes =
    nlohmann::json::parse(file.TextAttribute(name, "axistags"), nullptr, false);
  for (const nlohmann::json& axis : ListIn(ValueAt(axes, "axes")))
  {
    names.push_back(TextIn(ValueAt(axis, "key")));
  }
  names = names.size() == rank ? names : file.TextsAttribute(name, "DIMENSION_LABELS");
  if (names.size() != rank)
  {
    names = file.ScalesOf(name);
    std::for_each(
      names.begin(), names.end(), [](std::string& scale) { scale.erase(0, scale.rfind('/') + 1); });
  }
  return names.size() == rank ? names : std::vector<std::string>(rank);
}

/// Places axes by the coordinates in their scales. @returns false if an axis of space has none
bool TakeScales(const Hdf5File& file, const std::string& name, ArrayAxes& axes,
  std::vector<std::string>& warnings)
{
  const std::vector<std::string> scales = file.ScalesOf(name);
  bool areKnown = scales.size() == axes.size();
  for (std::size_t i = 0; areKnown && i < axes.size(); ++i)
  {
    const bool isPlaced = !scales[i].empty() &&
      PlaceAxis(file.Numbers(scales[i]), Trimmed(file.TextAttribute(scales[i], "units")), axes[i],
        warnings);
    areKnown = isPlaced || !axes[i].world;
  }
  return areKnown;
}

/// Takes the sizes of a voxel as ilastik and Fiji write them: one for each axis, or the last three
/// for those of space, z first.
void TakeElementSizes(const Hdf5File& file, const std::string& name, ArrayAxes& axes,
  std::vector<std::string>& warnings)
{
  constexpr double MmPerMicrometre = 1e-3;
  std::vector<double> sizes = file.NumberAttribute(name, "element_size_um");
  std::vector<ArrayAxis*> sized;
  for (ArrayAxis& axis : axes)
  {
    if (axis.world || sizes.size() == axes.size())
    {
      sized.push_back(&axis);
    }
  }
  if (sizes.size() < sized.size() || sizes.size() < 3)
  {
    warnings.push_back(UnknownSpacing);
    return;
  }
  const auto isLength = [](double size) { return std::isnormal(size) && size > 0.0; };
  const auto known = std::find_if(sizes.rbegin(), sizes.rend(), isLength);
  for (std::size_t i = 0; i < sized.size(); ++i)
  {
    const double stated = sizes[sizes.size() - sized.size() + i];
    const double size = isLength(stated) || known == sizes.rend() ? stated : *known;
    sized[i]->scale = isLength(size) ? size : 1.0;
    sized[i]->mmPerUnit = MmPerMicrometre;
    if (sized[i]->world && !isLength(stated))
    {
      char text[160];
      std::snprintf(text, sizeof(text),
        "The file says that voxels are %g um long along %.20s; %g um was assumed.", stated,
        sized[i]->name.c_str(), sized[i]->scale);
      warnings.push_back(text);
    }
  }
}

}

std::string LargestDataSet(const Hdf5File& file)
{
  std::string largest;
  double most = 0.0;
  for (const std::string& name : file.DataSets())
  {
    const Hdf5Layout layout = LayoutOf(file, name);
    double count = IsVolume(layout) ? 1.0 : 0.0;
    for (const std::int64_t size : layout.size)
    {
      count *= double(size);
    }
    if (count > most)
    {
      most = count;
      largest = name;
    }
  }
  if (largest.empty())
  {
    FailToRead(file.Path(), "a data set of numbers with three axes", "none");
  }
  return largest;
}

ArrayAxes AxesOfDataSet(
  const Hdf5File& file, const std::string& name, std::vector<std::string>& warnings)
{
  const std::size_t rank = LayoutOf(file, name).size.size();
  ArrayAxes axes = AxesNamed(file.Path(), AxisNames(file, name, rank));
  if (!TakeScales(file, name, axes, warnings))
  {
    TakeElementSizes(file, name, axes, warnings);
  }
  return axes;
}

}
