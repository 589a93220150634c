#include "Readers/Dicom/Grouping.h"

#include "Core/Quality/Percentile.h"
#include "Readers/Dicom/FrameTimes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>
#include <numeric>

namespace varimarch
{
namespace
{

using AreAlike = bool (*)(const DicomFrame&, const DicomFrame&);

bool HaveOneSize(const DicomFrame& a, const DicomFrame& b)
{
  return a.size == b.size && a.file->samples == b.file->samples &&
    a.file->palette.entries.empty() == b.file->palette.entries.empty();
}

bool HaveOneDirection(const DicomFrame& a, const DicomFrame& b)
{
  constexpr double LargestDifference = 0.01;
  if (!a.axes || !b.axes)
  {
    return !a.axes && !b.axes;
  }
  return glm::distance((*a.axes)[0], (*b.axes)[0]) < LargestDifference &&
    glm::distance((*a.axes)[1], (*b.axes)[1]) < LargestDifference;
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

bool HavePositionOrNot(const DicomFrame& a, const DicomFrame& b)
{
  return a.positionMm.has_value() == b.positionMm.has_value();
}

/// Keeps the largest group of frames that are alike, and warns of the others.
void KeepMostFrequent(std::vector<DicomFrame>& frames, AreAlike areAlike, const std::string& reason,
  std::vector<std::string>& warnings)
{
  std::vector<std::vector<DicomFrame>> groups;
  for (const DicomFrame& frame : frames)
  {
    const auto known = std::find_if(groups.begin(), groups.end(),
      [&](const auto& group) { return areAlike(group.front(), frame); });
    known == groups.end() ? groups.push_back({ frame }) : known->push_back(frame);
  }
  const auto most = std::max_element(
    groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  std::vector<DicomFrame> leftOut;
  for (auto group = groups.begin(); group != groups.end(); ++group)
  {
    if (group != most)
    {
      leftOut.insert(leftOut.end(), group->begin(), group->end());
    }
  }
  if (!leftOut.empty())
  {
    warnings.push_back("Images were left out because " + reason + ": " + FrameList(leftOut) + ".");
  }
  frames = *most;
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

/// Puts the frames in order along the normal, and leaves out all but the first of each place.
DicomSlices OnePerPlace(const std::vector<PlacedFrame>& placed, std::vector<std::string>& warnings)
{
  std::vector<PlacedFrame> sorted = placed;
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
    warnings.push_back("Images were left out because others lie at the same place, and only the "
                       "first of each place was read: " +
      FrameList(leftOut) + ".");
  }
  return slices;
}

/// Consecutive slices without a wide gap.
struct Part
{
  std::size_t begin;
  std::size_t end;
  std::size_t Size() const { return this->end - this->begin; }
};

std::vector<Part> PartsBetweenWideGaps(const std::vector<double>& heightsMm)
{
  constexpr double WideGap = 10.0; // in usual distances
  const double wideMm = WideGap * UsualDistanceMm(heightsMm);
  std::vector<Part> parts = { { 0, 1 } };
  for (std::size_t i = 1; i < heightsMm.size(); ++i)
  {
    if (heightsMm[i] - heightsMm[i - 1] > wideMm)
    {
      parts.push_back({ i, i });
    }
    parts.back().end = i + 1;
  }
  return parts;
}

/// Leaves out a few slices far from the others, such as a scout view of the same direction.
void LeaveOutFarSlices(DicomSlices& slices, std::vector<std::string>& warnings)
{
  constexpr std::size_t ManyTimes = 4; // as many slices in the largest part as in a small one
  if (slices.frames.size() < 3)
  {
    return;
  }
  const std::vector<Part> parts = PartsBetweenWideGaps(slices.heightsMm);
  const Part largest = *std::max_element(
    parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.Size() < b.Size(); });
  DicomSlices kept;
  std::vector<DicomFrame> leftOut;
  for (const Part& part : parts)
  {
    const bool isKept = part.Size() * ManyTimes > largest.Size();
    for (std::size_t i = part.begin; i < part.end; ++i)
    {
      (isKept ? kept.frames : leftOut).push_back(slices.frames[i]);
      if (isKept)
      {
        kept.heightsMm.push_back(slices.heightsMm[i]);
      }
    }
  }
  if (!leftOut.empty())
  {
    warnings.push_back(
      "Images were left out because they lie far from the others: " + FrameList(leftOut) + ".");
    slices = kept;
  }
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

DicomVolumes VolumesOf(std::vector<DicomFrame> frames, std::vector<std::string>& warnings)
{
  KeepMostFrequent(frames, HaveOneSize, "their size differs from that of the others", warnings);
  KeepMostFrequent(
    frames, HaveOneDirection, "their direction differs from that of the others", warnings);
  KeepMostFrequent(
    frames, HaveOnePixelSize, "the size of their pixels differs from that of the others", warnings);
  KeepMostFrequent(
    frames, HavePositionOrNot, "they do not say where they lie, as others do", warnings);
  DicomVolumes volumes;
  const std::vector<double> heightsMm = HeightsMm(frames, volumes.hasPositions, warnings);
  const std::vector<int> places = PlacesOf(heightsMm, PlaceToleranceMm(frames.front()));
  std::vector<PlacedFrame> placed;
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    placed.push_back({ frames[i], heightsMm[i], places[i] });
  }
  volumes.sets = SetsOfTimes(placed, warnings);
  std::vector<const DicomFrame*> firstFrames;
  for (const std::vector<PlacedFrame>& set : volumes.sets)
  {
    firstFrames.push_back(&set.front().frame);
  }
  volumes.times = TimesOf(firstFrames);
  return volumes;
}

DicomSlices SlicesOf(
  const DicomVolumes& volumes, std::int64_t time, std::vector<std::string>& warnings)
{
  DicomSlices slices = OnePerPlace(volumes.sets[std::size_t(time)], warnings);
  LeaveOutFarSlices(slices, warnings);
  slices.hasPositions = volumes.hasPositions;
  return slices;
}

}
