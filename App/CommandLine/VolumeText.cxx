#include "VolumeText.h"

#include "Readers/ImageFacts.h"
#include "Results.h"
#include "Scene/Slices/SliceAxes.h"

#include <vtkMatrix3x3.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <sstream>

namespace varimarch
{

namespace
{

constexpr std::array<double, 7> Percents = { 0.1, 1.0, 25.0, 50.0, 75.0, 99.0, 99.9 };
constexpr double BytesPerMiB = 1024.0 * 1024.0;

std::string Short(double number)
{
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

// The directions of the three voxel axes in the patient, such as "L", "P", "S".
std::array<std::string, 3> AxisLetters(vtkImageData* image)
{
  std::array<std::string, 3> letters;
  for (int axis = 0; axis < 3; ++axis)
  {
    double direction[3];
    for (int row = 0; row < 3; ++row)
    {
      direction[row] = image->GetDirectionMatrix()->GetElement(row, axis);
    }
    letters[axis] = AnatomicalDirection(direction);
  }
  return letters;
}

std::string SlicesText(SliceLayout slices)
{
  switch (slices)
  {
    case SliceLayout::Irregular:
      return "tilted, uneven or missing; --rectify resamples them on an even grid";
    case SliceLayout::Rectified:
      return "tilted, uneven or missing; resampled on an even grid; --as-scanned keeps them";
    default:
      return "even";
  }
}

// Such as "2 channels: DAPI, GFP".
std::string ComponentsText(vtkImageData* image)
{
  const std::string count = std::to_string(image->GetNumberOfScalarComponents());
  if (HoldsColors(image))
  {
    return count + ", a colour";
  }
  std::string names;
  for (const VolumeChannel& channel : ChannelsIn(image))
  {
    names += (names.empty() ? "" : ", ") + channel.name;
  }
  return count + " channels: " + names;
}

std::string LengthsText(double factor)
{
  return factor == 1.0 ? "those of presets, which suit a patient"
                       : "those of presets times " + Short(factor) +
      ", since the volume is not known to show a patient";
}

// A text such as "20, from 0 s to 38 s; this is time 3 (6 s)".
std::string TimesText(const LoadedTimes& times)
{
  const std::string unit = times.areSeconds ? " s" : "";
  const auto text = [&](double value) { return Short(value) + unit; };
  const std::string current = std::to_string(times.current) +
    (times.areSeconds ? " (" + text(times.values[std::size_t(times.current)]) + ")" : "");
  return std::to_string(times.values.size()) + ", from " + text(times.values.front()) + " to " +
    text(times.values.back()) + "; this is time " + current;
}

double Bytes(vtkImageData* image)
{
  return double(image->GetNumberOfPoints()) * image->GetScalarSize() *
    image->GetNumberOfScalarComponents();
}

// A bar per bin. Bars are logarithmic, because air would otherwise dwarf all other bins.
std::string HistogramText(const ImageStatistics& statistics, int bins)
{
  constexpr double LongestBar = 50.0;
  const std::vector<std::int64_t> counts = statistics.Histogram(bins);
  const double most = std::log1p(double(*std::max_element(counts.begin(), counts.end())));
  const double width = (statistics.Largest() - statistics.Smallest()) / bins;
  std::ostringstream text;
  text << "histogram    (bars are logarithmic)\n";
  for (int bin = 0; bin < bins; ++bin)
  {
    const auto bar = std::size_t(std::lround(LongestBar * std::log1p(double(counts[bin])) / most));
    text << std::setw(12) << Short(statistics.Smallest() + bin * width) << " |" << std::left
         << std::setw(int(LongestBar)) << std::string(bar, '#') << std::right << " " << counts[bin]
         << "\n";
  }
  return text.str();
}

}

std::string VolumeText(
  const std::string& name, const LoadedVolume& volume, const ImageStatistics& statistics, int bins)
{
  vtkImageData* image = volume.image;
  const int* dimensions = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  const double size[3] = { dimensions[0] * spacing[0], dimensions[1] * spacing[1],
    dimensions[2] * spacing[2] };
  const std::array<std::string, 3> letters = AxisLetters(image);
  std::ostringstream text;
  text << name << "\n"
       << "modality     " << (volume.modality.empty() ? "unknown" : volume.modality) << "\n"
       << "dimensions   " << dimensions[0] << " x " << dimensions[1] << " x " << dimensions[2]
       << "\n"
       << "type         " << image->GetScalarTypeAsString() << "\n"
       << (image->GetNumberOfScalarComponents() > 1 ? "components   " + ComponentsText(image) + "\n"
                                                    : "")
       << "spacing      " << Triple(spacing, " x ") << " mm\n"
       << "size         " << Triple(size, " x ") << " mm\n"
       << "origin       " << Triple(image->GetOrigin(), ", ") << " mm (LPS)\n"
       << "orientation  " << letters[0] << " " << letters[1] << " " << letters[2]
       << " (directions of the axes in the patient)\n"
       << "slices       " << SlicesText(volume.slices) << "\n"
       << (volume.times.AreSeveral() ? "times        " + TimesText(volume.times) + "\n" : "")
       << "memory       " << Fixed(Bytes(image) / BytesPerMiB, 1) << " MiB"
       << (volume.isOnDisk ? ", drawn from the file" : "") << "\n"
       << "lengths      " << LengthsText(statistics.LengthFactor()) << "\n"
       << "range        " << Short(statistics.Smallest()) << " to " << Short(statistics.Largest())
       << "\n"
       << "percentiles ";
  for (const double percent : Percents)
  {
    text << " " << Short(percent) << " %: " << Short(statistics.Percentile(percent))
         << (percent == Percents.back() ? "\n" : ",");
  }
  return text.str() + HistogramText(statistics, bins);
}

nlohmann::ordered_json VolumeJson(
  const LoadedVolume& volume, const ImageStatistics& statistics, int bins)
{
  vtkImageData* image = volume.image;
  const double* origin = image->GetOrigin();
  const double* direction = image->GetDirectionMatrix()->GetData();
  nlohmann::ordered_json json;
  json["originMm"] = { origin[0], origin[1], origin[2] };
  json["directionRows"] = std::vector<double>(direction, direction + 9);
  json["orientation"] = AxisLetters(image);
  json["irregularSlices"] = volume.slices != SliceLayout::Even;
  json["rectified"] = volume.slices == SliceLayout::Rectified;
  if (volume.times.AreSeveral())
  {
    json["times"] = volume.times.values;
    json["timesInSeconds"] = volume.times.areSeconds;
    json["time"] = volume.times.current;
  }
  json["bytes"] = std::int64_t(Bytes(image));
  json["fromDisk"] = volume.isOnDisk;
  json["lengthFactor"] = statistics.LengthFactor();
  json["range"] = { statistics.Smallest(), statistics.Largest() };
  for (const double percent : Percents)
  {
    json["percentiles"].push_back(
      { { "percent", percent }, { "value", statistics.Percentile(percent) } });
  }
  json["histogram"] = statistics.Histogram(bins);
  return json;
}

}
