#include "Readers/Dicom/AlikeFrames.h"

#include "Readers/Dicom/Grouping.h"
#include "Readers/NumberText.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>
#include <numeric>

namespace varimarch
{
namespace
{

using AreAlike = bool (*)(const DicomFrame&, const DicomFrame&);
using Describe = std::string (*)(const DicomFrame&);

bool HaveOneSize(const DicomFrame& a, const DicomFrame& b)
{
  return a.size == b.size && a.file->samples == b.file->samples &&
    a.file->palette.entries.empty() == b.file->palette.entries.empty();
}

std::string SizeName(const DicomFrame& frame)
{
  const bool isColour = frame.file->samples > 1 || !frame.file->palette.entries.empty();
  return std::to_string(frame.size.x) + " x " + std::to_string(frame.size.y) +
    (isColour ? " coloured pixels" : " pixels");
}

/// Stacks of the discs of a spine are turned by a degree and less against each other; the numbers
/// of one stack are rounded, hardly more.
bool HaveOneDirection(const DicomFrame& a, const DicomFrame& b)
{
  constexpr double LargestDifference = 0.003;
  if (!a.axes || !b.axes)
  {
    return !a.axes && !b.axes;
  }
  return glm::distance((*a.axes)[0], (*b.axes)[0]) < LargestDifference &&
    glm::distance((*a.axes)[1], (*b.axes)[1]) < LargestDifference;
}

/// The plane that a frame is nearest to.
std::string DirectionName(const DicomFrame& frame)
{
  if (!frame.axes)
  {
    return "no direction";
  }
  const glm::dvec3 normal = glm::abs(glm::cross((*frame.axes)[0], (*frame.axes)[1]));
  constexpr double AlmostExact = 0.99;
  const double most = std::max({ normal.x, normal.y, normal.z });
  const char* const plane = most == normal.x ? "sagittal" : most == normal.y ? "coronal" : "axial";
  return std::string(most < AlmostExact ? "oblique " : "") + plane;
}

bool HaveOnePixelSize(const DicomFrame& a, const DicomFrame& b)
{
  constexpr double LargestRelativeDifference = 1e-3;
  if (!a.pixelMm || !b.pixelMm)
  {
    return !a.pixelMm && !b.pixelMm;
  }
  return glm::distance(*a.pixelMm, *b.pixelMm) <
    LargestRelativeDifference * glm::length(*a.pixelMm);
}

std::string PixelSizeName(const DicomFrame& frame)
{
  return frame.pixelMm
    ? "pixels of " + ShortText(frame.pixelMm->x) + " x " + ShortText(frame.pixelMm->y) + " mm"
    : "pixels of unknown size";
}

bool HavePositionOrNot(const DicomFrame& a, const DicomFrame& b)
{
  return a.positionMm.has_value() == b.positionMm.has_value();
}

std::string PositionName(const DicomFrame& frame)
{
  return frame.positionMm ? "with positions" : "without positions";
}

void SortByCount(std::vector<AlikeFrames>& groups)
{
  std::stable_sort(groups.begin(), groups.end(),
    [](const AlikeFrames& a, const AlikeFrames& b) { return a.frames.size() > b.frames.size(); });
}

/// Adds a name to each of several groups.
void AddNames(const std::string& name, const Describe nameOf, std::vector<AlikeFrames>& groups)
{
  for (AlikeFrames& group : groups)
  {
    group.name = name;
    if (groups.size() > 1)
    {
      group.name += (name.empty() ? "" : ", ") + nameOf(group.frames.front());
    }
  }
}

std::vector<AlikeFrames> Divided(const AlikeFrames& all, AreAlike areAlike, Describe nameOf)
{
  std::vector<AlikeFrames> groups;
  for (const DicomFrame& frame : all.frames)
  {
    const auto known = std::find_if(groups.begin(), groups.end(),
      [&](const AlikeFrames& group) { return areAlike(group.frames.front(), frame); });
    known == groups.end() ? groups.push_back({ "", { frame } }) : known->frames.push_back(frame);
  }
  SortByCount(groups);
  AddNames(all.name, nameOf, groups);
  return groups;
}

/// The stations of frames of one direction and size, as lists of their indices. From height to
/// height, the frames of a station lie beside those of others.
class Stations
{
public:
  explicit Stations(const std::vector<DicomFrame>& frames)
  {
    const glm::dmat2x3 axes = *frames.front().axes;
    const glm::dvec3 normal = glm::normalize(glm::cross(axes[0], axes[1]));
    const glm::dvec2 pixelMm = frames.front().pixelMm.value_or(glm::dvec2(1.0));
    constexpr double QuarterOfImage = 0.25;
    this->farMm = QuarterOfImage * glm::dvec2(frames.front().size) * pixelMm;
    for (const DicomFrame& frame : frames)
    {
      this->heightsMm.push_back(glm::dot(*frame.positionMm, normal));
      this->placesMm.emplace_back(
        glm::dot(*frame.positionMm, axes[0]), glm::dot(*frame.positionMm, axes[1]));
    }
    this->otherwiseMm = std::abs(frames.front().distanceMm.value_or(1.0));
    this->Follow();
    this->MergeThoseNotBeside();
  }

  const std::vector<std::vector<std::size_t>>& All() const { return this->stations; }

  /// The mean distance of a station beside the first [mm].
  double BesideFirstMm(std::size_t station) const
  {
    return glm::distance(this->MeanMm(this->stations[station]), this->MeanMm(this->stations[0]));
  }

private:
  /// Follows the stations upwards. A tilted gantry moves each slice a little against the last.
  void Follow()
  {
    std::vector<std::size_t> order(this->heightsMm.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return this->heightsMm[a] < this->heightsMm[b]; });
    for (const std::size_t frame : order)
    {
      const auto known = std::find_if(this->stations.begin(), this->stations.end(),
        [&](const auto& station)
        {
          const glm::dvec2 apartMm =
            glm::abs(this->placesMm[frame] - this->placesMm[station.back()]);
          return apartMm.x <= this->farMm.x && apartMm.y <= this->farMm.y;
        });
      known == this->stations.end() ? this->stations.push_back({ frame }) : known->push_back(frame);
    }
    std::stable_sort(this->stations.begin(), this->stations.end(),
      [](const auto& a, const auto& b) { return a.size() > b.size(); });
  }

  /// Merges slices that have places of their own along the normal: they were only moved.
  void MergeThoseNotBeside()
  {
    std::vector<std::vector<std::size_t>> kept = { this->stations.front() };
    for (std::size_t i = 1; i < this->stations.size(); ++i)
    {
      const std::vector<std::size_t>& station = this->stations[i];
      const auto besides = std::count_if(station.begin(), station.end(),
        [&](std::size_t frame) { return this->IsBeside(frame, kept); });
      if (2 * std::size_t(besides) >= station.size())
      {
        kept.push_back(station);
      }
      else
      {
        kept.front().insert(kept.front().end(), station.begin(), station.end());
      }
    }
    for (std::vector<std::size_t>& station : kept)
    {
      std::sort(station.begin(), station.end()); // the order of their numbers
    }
    this->stations = kept;
  }

  /// True if a frame of a station lies at the height of a frame, or nearly.
  bool IsBeside(std::size_t frame, const std::vector<std::vector<std::size_t>>& others) const
  {
    constexpr double Nearly = 0.45; // part of the distance of slices
    return std::any_of(others.begin(), others.end(),
      [&](const std::vector<std::size_t>& station)
      {
        const double nearMm = Nearly * this->DistanceMm(station);
        return std::any_of(station.begin(), station.end(),
          [&](std::size_t other)
          { return std::abs(this->heightsMm[other] - this->heightsMm[frame]) < nearMm; });
      });
  }

  /// The usual distance of the slices of a station.
  double DistanceMm(const std::vector<std::size_t>& station) const
  {
    constexpr double SameHeightMm = 1e-3;
    std::vector<double> ascending;
    for (const std::size_t frame : station)
    {
      ascending.push_back(this->heightsMm[frame]);
    }
    std::sort(ascending.begin(), ascending.end());
    ascending.erase(std::unique(ascending.begin(), ascending.end(),
                      [](double a, double b) { return b - a < SameHeightMm; }),
      ascending.end());
    return ascending.size() > 1 ? UsualDistanceMm(ascending) : this->otherwiseMm;
  }

  glm::dvec2 MeanMm(const std::vector<std::size_t>& station) const
  {
    glm::dvec2 sum(0.0);
    for (const std::size_t frame : station)
    {
      sum += this->placesMm[frame];
    }
    return sum / double(station.size());
  }

  std::vector<double> heightsMm;      ///< heights of the frames along the normal
  std::vector<glm::dvec2> placesMm;   ///< places of the frames in their plane
  glm::dvec2 farMm = glm::dvec2(0.0); ///< distance from which on frames lie beside each other
  double otherwiseMm = 1.0;           ///< distance of the slices of a station with one height
  std::vector<std::vector<std::size_t>> stations;
};

std::vector<AlikeFrames> DividedByStation(const AlikeFrames& all)
{
  const bool havePlaces = std::all_of(all.frames.begin(), all.frames.end(),
    [](const DicomFrame& frame) { return frame.positionMm && frame.axes; });
  if (!havePlaces)
  {
    return { all };
  }
  const Stations stations(all.frames);
  std::vector<AlikeFrames> groups;
  for (std::size_t i = 0; i < stations.All().size(); ++i)
  {
    AlikeFrames group = { all.name, {} };
    for (const std::size_t frame : stations.All()[i])
    {
      group.frames.push_back(all.frames[frame]);
    }
    if (stations.All().size() > 1)
    {
      group.name += (all.name.empty() ? "station " : ", station ") + std::to_string(i + 1) +
        (i > 0 ? ", " + ShortText(stations.BesideFirstMm(i)) + " mm beside the first" : "");
    }
    groups.push_back(group);
  }
  return groups;
}

}

std::vector<AlikeFrames> GroupsOfAlike(const std::vector<DicomFrame>& frames)
{
  using Divide = std::function<std::vector<AlikeFrames>(const AlikeFrames&)>;
  const auto by = [](AreAlike areAlike, Describe nameOf) -> Divide
  { return [areAlike, nameOf](const AlikeFrames& all) { return Divided(all, areAlike, nameOf); }; };
  std::vector<AlikeFrames> groups = { { "", frames } };
  for (const Divide& divide : { by(HaveOneSize, SizeName), by(HaveOneDirection, DirectionName),
         by(HaveOnePixelSize, PixelSizeName), by(HavePositionOrNot, PositionName),
         Divide(DividedByStation) })
  {
    std::vector<AlikeFrames> divided;
    for (const AlikeFrames& group : groups)
    {
      const std::vector<AlikeFrames> parts = divide(group);
      divided.insert(divided.end(), parts.begin(), parts.end());
    }
    groups = std::move(divided);
  }
  return groups;
}

}
