#include "Readers/Dicom/Grouping.h"

#include "Core/Quality/Percentile.h"
#include "Readers/Dicom/DicomFrame.h"
#include "Readers/Dicom/Differences.h"
#include "Readers/Parsing/NumberText.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <numeric>

namespace varimarch
{
namespace
{

/// Frames that may be slices of one volume.
struct AlikeFrames
{
  std::string name; ///< their difference from the others: "10 x 6 pixels, sagittal"; or empty
  std::vector<DicomFrame> frames;
};

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

/// Frames of a series by what slices of one volume share: their size, direction, pixel size,
/// whether they have positions, and the station of a moving table. Frames at the same height belong
/// to several stations if they lie more than a quarter of an image beside each other.
/// @param frames  at least one
/// @returns at least one group; most frames first at each step of the division
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

bool Vary(const std::vector<double>& numbers)
{
  const auto [least, most] = std::minmax_element(numbers.begin(), numbers.end());
  return *most > *least;
}

/// Heights that the frames state, by a function that returns none if one does not.
std::vector<double> HeightsBy(const std::vector<DicomFrame>& frames,
  const std::function<std::optional<double>(const DicomFrame&)>& heightOf)
{
  std::vector<double> heights;
  for (const DicomFrame& frame : frames)
  {
    const std::optional<double> height = heightOf(frame);
    if (!height)
    {
      return {};
    }
    heights.push_back(*height);
  }
  return heights;
}

/// Heights of frames without positions: one for each, in the order of their numbers.
std::vector<double> HeightsByNumber(
  const std::vector<DicomFrame>& frames, std::vector<std::string>& warnings)
{
  const DicomFrame& first = frames.front();
  const double distanceMm = std::abs(first.distanceMm.value_or(1.0));
  if (frames.size() > 1 && first.isDistanceThickness)
  {
    warnings.push_back(first.distanceMm
        ? "The files do not say how far apart the slices are; their thickness was taken."
        : "The files do not say how far apart the slices are; 1 mm was taken.");
  }
  std::vector<double> heights(frames.size());
  std::iota(heights.begin(), heights.end(), 0.0);
  std::transform(heights.begin(), heights.end(), heights.begin(),
    [&](double index) { return index * distanceMm; });
  return heights;
}

/// Determines the heights of the frames along their normal [mm].
std::vector<double> HeightsMm(
  const std::vector<DicomFrame>& frames, bool& hasPositions, std::vector<std::string>& warnings)
{
  const std::vector<double> fromPositions = HeightsBy(frames,
    [](const DicomFrame& frame) -> std::optional<double>
    {
      if (!frame.positionMm)
      {
        return std::nullopt;
      }
      const glm::dvec3 normal = frame.axes
        ? glm::normalize(glm::cross((*frame.axes)[0], (*frame.axes)[1]))
        : glm::dvec3(0.0, 0.0, 1.0);
      return glm::dot(*frame.positionMm, normal);
    });
  const std::vector<double> stated =
    HeightsBy(frames, [](const DicomFrame& frame) { return frame.heightMm; });
  const bool shareOne = frames.front().sharesPlace;
  const bool areStated = !stated.empty() && (Vary(stated) || shareOne);
  hasPositions = !fromPositions.empty() && (Vary(fromPositions) || !areStated || shareOne);
  if (hasPositions)
  {
    return fromPositions;
  }
  if (!areStated)
  {
    return HeightsByNumber(frames, warnings);
  }
  if (!fromPositions.empty())
  {
    warnings.push_back("All images state the same position; their slice locations were used "
                       "instead.");
  }
  return stated;
}

/// Frames whose heights differ by less are at the same place [mm].
double PlaceToleranceMm(const DicomFrame& frame)
{
  constexpr double OfPixel = 0.05;
  return OfPixel * (frame.pixelMm ? std::min(frame.pixelMm->x, frame.pixelMm->y) : 1.0);
}

/// Numbers of the places of frames, counted along the normal.
std::vector<int> PlacesOf(const std::vector<double>& heightsMm, double toleranceMm)
{
  std::vector<std::size_t> order(heightsMm.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return heightsMm[a] < heightsMm[b]; });
  std::vector<int> places(heightsMm.size());
  int place = 0;
  double start = heightsMm[order.front()];
  for (const std::size_t frame : order)
  {
    if (heightsMm[frame] - start > toleranceMm)
    {
      ++place;
      start = heightsMm[frame];
    }
    places[frame] = place;
  }
  return places;
}

/// The largest distance of frames beside those that were kept at their heights [mm].
double LargestOffsetMm(const std::vector<PlacedFrame>& sorted)
{
  double largestMm = 0.0;
  const PlacedFrame* kept = &sorted.front();
  for (const PlacedFrame& slice : sorted)
  {
    kept = slice.place == kept->place ? kept : &slice;
    if (slice.frame.positionMm && kept->frame.positionMm)
    {
      largestMm =
        std::max(largestMm, glm::distance(*slice.frame.positionMm, *kept->frame.positionMm));
    }
  }
  return largestMm;
}

/// Puts the frames in order along the normal, and leaves out all but the first of each place.
DicomSlices OnePerPlace(const FrameSet& placed, std::vector<std::string>& warnings)
{
  FrameSet sorted = placed;
  std::stable_sort(sorted.begin(), sorted.end(),
    [](const PlacedFrame& a, const PlacedFrame& b) { return a.place < b.place; });
  DicomSlices slices;
  std::vector<DicomFrame> leftOut;
  int last = -1;
  for (const PlacedFrame& slice : sorted)
  {
    if (slice.place == last)
    {
      leftOut.push_back(slice.frame);
      continue;
    }
    last = slice.place;
    slices.frames.push_back(slice.frame);
    slices.heightsMm.push_back(slice.heightMm);
  }
  if (!leftOut.empty())
  {
    const double offsetMm = LargestOffsetMm(sorted);
    const bool isSamePlace = offsetMm <= PlaceToleranceMm(leftOut.front());
    warnings.push_back("Images were left out because others lie at the same " +
      (isSamePlace ? "place" : "height, up to " + ShortText(offsetMm) + " mm beside them") +
      ", and only the first of each place was read: " + FrameList(leftOut) + ".");
  }
  return slices;
}

/// Slices without a wide gap between them.
struct Part
{
  double lowestMm;
  double highestMm;
  std::size_t count;

  /// The distance of a height from the part [mm].
  double DistanceMm(double heightMm) const
  {
    return std::max({ 0.0, this->lowestMm - heightMm, heightMm - this->highestMm });
  }
};

/// Parts of the slices of a set, those with most slices first.
std::vector<Part> PartsBetweenWideGaps(const FrameSet& set)
{
  constexpr double WideGap = 10.0; // in usual distances
  std::map<int, double> heightsMm;
  for (const PlacedFrame& frame : set)
  {
    heightsMm.insert({ frame.place, frame.heightMm });
  }
  std::vector<double> ascending;
  for (const auto& [place, heightMm] : heightsMm)
  {
    ascending.push_back(heightMm);
  }
  const double wideMm = ascending.size() < 3 ? std::numeric_limits<double>::infinity()
                                             : WideGap * UsualDistanceMm(ascending);
  std::vector<Part> parts;
  for (const double heightMm : ascending)
  {
    if (parts.empty() || heightMm - parts.back().highestMm > wideMm)
    {
      parts.push_back({ heightMm, heightMm, 0 });
    }
    parts.back().highestMm = heightMm;
    ++parts.back().count;
  }
  std::stable_sort(
    parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.count > b.count; });
  return parts;
}

std::string PartName(const Part& part)
{
  return part.count == 1
    ? "slice at " + ShortText(part.lowestMm) + " mm"
    : "slices from " + ShortText(part.lowestMm) + " to " + ShortText(part.highestMm) + " mm";
}

/// The kinds of a kind whose slices have wide gaps, such as two breasts and what lies between them.
/// A part has the times that have slices in it.
std::vector<FrameKind> PartsOf(const FrameKind& kind)
{
  const std::vector<Part> parts = PartsBetweenWideGaps(kind.sets.front());
  if (parts.size() == 1)
  {
    return { kind };
  }
  std::vector<FrameKind> kinds;
  for (const Part& part : parts)
  {
    kinds.push_back(
      { kind.name + (kind.name.empty() ? "" : ", ") + PartName(part), {}, kind.warnings });
  }
  for (const FrameSet& set : kind.sets)
  {
    std::vector<FrameSet> setsOfParts(parts.size());
    for (const PlacedFrame& frame : set)
    {
      const auto nearest = std::min_element(parts.begin(), parts.end(),
        [&](const Part& a, const Part& b)
        { return a.DistanceMm(frame.heightMm) < b.DistanceMm(frame.heightMm); });
      setsOfParts[std::size_t(nearest - parts.begin())].push_back(frame);
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      if (!setsOfParts[i].empty())
      {
        kinds[i].sets.push_back(std::move(setsOfParts[i]));
      }
    }
  }
  return kinds;
}

/// The frames of a group with their places.
FrameSet Placed(const std::vector<DicomFrame>& frames, const std::vector<double>& heightsMm)
{
  const std::vector<int> places = PlacesOf(heightsMm, PlaceToleranceMm(frames.front()));
  FrameSet placed;
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    placed.push_back({ frames[i], heightsMm[i], places[i] });
  }
  return placed;
}

VolumeTimes TimesOfSets(const std::vector<FrameSet>& sets)
{
  std::vector<const DicomFrame*> firstFrames;
  for (const FrameSet& set : sets)
  {
    firstFrames.push_back(&set.front().frame);
  }
  return TimesOf(firstFrames);
}

}

double UsualDistanceMm(const std::vector<double>& heightsMm)
{
  std::vector<double> gaps;
  for (std::size_t i = 1; i < heightsMm.size(); ++i)
  {
    gaps.push_back(heightsMm[i] - heightsMm[i - 1]);
  }
  return Percentile(gaps, 0.5);
}

std::vector<DicomVolumes> KindsOf(const std::vector<DicomFrame>& frames)
{
  std::vector<DicomVolumes> kinds;
  for (const AlikeFrames& group : GroupsOfAlike(frames))
  {
    DicomVolumes ofGroup;
    const std::vector<double> heightsMm =
      HeightsMm(group.frames, ofGroup.hasPositions, ofGroup.warnings);
    for (const FrameKind& whole : SeparatedKinds(Placed(group.frames, heightsMm)))
    {
      for (const FrameKind& kind : PartsOf(whole))
      {
        DicomVolumes volumes = ofGroup;
        volumes.name =
          group.name + (group.name.empty() || kind.name.empty() ? "" : ", ") + kind.name;
        volumes.sets = kind.sets;
        volumes.times = TimesOfSets(kind.sets);
        volumes.warnings.insert(volumes.warnings.end(), kind.warnings.begin(), kind.warnings.end());
        kinds.push_back(volumes);
      }
    }
  }
  return kinds;
}

std::string KindList(const std::vector<DicomVolumes>& kinds)
{
  constexpr std::size_t MostNamed = 12;
  std::string list;
  for (std::size_t i = 0; i < std::min(kinds.size(), MostNamed); ++i)
  {
    std::vector<DicomFrame> frames;
    for (const FrameSet& set : kinds[i].sets)
    {
      std::transform(set.begin(), set.end(), std::back_inserter(frames),
        [](const PlacedFrame& placed) { return placed.frame; });
    }
    list += (i > 0 ? ", " : "") + std::to_string(i + 1) + " (" + kinds[i].name + ": " +
      FrameList(frames) + ")";
  }
  if (kinds.size() > MostNamed)
  {
    list += " and " + std::to_string(kinds.size() - MostNamed) + " more";
  }
  // Attributes may hold what people typed, and the list may be printed to a terminal.
  std::replace_if(
    list.begin(), list.end(), [](unsigned char letter) { return letter < ' '; }, '?');
  return list;
}

DicomSlices SlicesOf(
  const DicomVolumes& volumes, std::int64_t time, std::vector<std::string>& warnings)
{
  DicomSlices slices = OnePerPlace(volumes.sets[std::size_t(time)], warnings);
  slices.hasPositions = volumes.hasPositions;
  return slices;
}

}
