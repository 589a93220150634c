#include "Readers/Dicom/Grouping.h"

#include "Core/Quality/Percentile.h"
#include "Readers/Dicom/AlikeFrames.h"
#include "Readers/Dicom/FrameTimes.h"
#include "Readers/NumberText.h"

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
