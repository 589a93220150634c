#include "Readers/Dicom/FrameSets.h"

#include "Readers/Dicom/Grouping.h"
#include "Readers/NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace varimarch
{
namespace
{

std::set<int> PlacesOf(const FrameSet& frames)
{
  std::set<int> places;
  for (const PlacedFrame& frame : frames)
  {
    places.insert(frame.place);
  }
  return places;
}

/// Sets of frames with the same value of an attribute: in ascending order if all values are
/// numbers, otherwise in the order of their first frames.
std::vector<FrameSet> SetsBy(std::size_t difference, const FrameSet& frames)
{
  const auto valueOf = [&](const FrameSet& set) -> const std::string&
  { return set.front().frame.differences[difference]; };
  std::vector<FrameSet> sets;
  std::map<std::string, std::size_t> indices;
  for (const PlacedFrame& frame : frames)
  {
    const auto known = indices.insert({ frame.frame.differences[difference], sets.size() }).first;
    sets.resize(indices.size());
    sets[known->second].push_back(frame);
  }
  const auto numberOf = [&](const FrameSet& set) { return NumberIn(valueOf(set)); };
  if (std::all_of(
        sets.begin(), sets.end(), [&](const FrameSet& set) { return numberOf(set).has_value(); }))
  {
    std::stable_sort(sets.begin(), sets.end(),
      [&](const FrameSet& a, const FrameSet& b) { return *numberOf(a) < *numberOf(b); });
  }
  return sets;
}

/// True if at least half of the places of each set but the largest are also those of other sets.
bool LieOverEachOther(const std::vector<FrameSet>& sets)
{
  std::map<int, int> counts;
  std::size_t largest = 0;
  std::vector<std::set<int>> placesOfSets;
  for (const FrameSet& set : sets)
  {
    placesOfSets.push_back(PlacesOf(set));
    largest = std::max(largest, placesOfSets.back().size());
    for (const int place : placesOfSets.back())
    {
      ++counts[place];
    }
  }
  const auto isCovered = [&](const std::set<int>& places)
  {
    const auto shared =
      std::count_if(places.begin(), places.end(), [&](int place) { return counts[place] > 1; });
    return 2 * std::size_t(shared) >= places.size();
  };
  const auto uncovered = std::count_if(placesOfSets.begin(), placesOfSets.end(),
    [&](const std::set<int>& places) { return !isCovered(places); });
  const bool isLargestUncovered = std::any_of(placesOfSets.begin(), placesOfSets.end(),
    [&](const std::set<int>& places) { return places.size() == largest && !isCovered(places); });
  return uncovered == 0 || (uncovered == 1 && isLargestUncovered);
}

/// The heights of the places of frames.
std::map<int, double> HeightsByPlace(const FrameSet& frames)
{
  std::map<int, double> heights;
  for (const PlacedFrame& frame : frames)
  {
    heights.insert({ frame.place, frame.heightMm });
  }
  return heights;
}

std::vector<double> Ascending(const std::map<int, double>& heights)
{
  std::vector<double> ascending;
  for (const auto& [place, heightMm] : heights)
  {
    ascending.push_back(heightMm);
  }
  return ascending;
}

/// The heights of the places of frames, in ascending order.
std::vector<double> HeightsOfPlaces(const FrameSet& frames)
{
  return Ascending(HeightsByPlace(frames));
}

/// True for heights of a stack with even distances, in which slices may be missing.
bool AreOnGrid(const std::vector<double>& heightsMm, double distanceMm)
{
  constexpr double LargestDifference = 0.05;
  for (std::size_t i = 1; i < heightsMm.size(); ++i)
  {
    const double steps = (heightsMm[i] - heightsMm[i - 1]) / distanceMm;
    if (std::lround(steps) < 1 || std::abs(steps - std::round(steps)) > LargestDifference)
    {
      return false;
    }
  }
  return heightsMm.size() > 1;
}

/// True if a set has the slices that another one lacks: slices of one volume, some of which have a
/// value of their own, such as an echo time that was rounded otherwise.
bool FillsGapsOf(const FrameSet& other, const FrameSet& set, double distanceMm)
{
  std::map<int, double> both = HeightsByPlace(other);
  const std::size_t before = both.size();
  const std::map<int, double> added = HeightsByPlace(set);
  both.insert(added.begin(), added.end());
  return 2 * (both.size() - before) >= added.size() && AreOnGrid(Ascending(both), distanceMm);
}

/// True if sets are stacks of equal even distances between each other's slices, such as two phases
/// half a distance apart.
bool AreInterleaved(const std::vector<FrameSet>& sets)
{
  const FrameSet& largest = *std::max_element(sets.begin(), sets.end(),
    [](const FrameSet& a, const FrameSet& b) { return PlaceCount(a) < PlaceCount(b); });
  const std::vector<double> ofLargest = HeightsOfPlaces(largest);
  if (ofLargest.size() < 2)
  {
    return false;
  }
  const double distanceMm = UsualDistanceMm(ofLargest);
  return std::all_of(sets.begin(), sets.end(),
    [&](const FrameSet& set)
    {
      const std::vector<double> heights = HeightsOfPlaces(set);
      const double commonMm =
        std::min(heights.back(), ofLargest.back()) - std::max(heights.front(), ofLargest.front());
      return AreOnGrid(heights, distanceMm) &&
        commonMm >= 0.5 * (heights.back() - heights.front()) &&
        !FillsGapsOf(largest, set, distanceMm);
    });
}

/// True if all frames together have even distances, in which slices may be missing.
bool LieOnOneGrid(const FrameSet& frames)
{
  const std::vector<double> heightsMm = HeightsOfPlaces(frames);
  return AreOnGrid(heightsMm, UsualDistanceMm(heightsMm));
}

/// True if the distance that slices state is that of all frames together rather than that of a set:
/// they were acquired in turns. Where they state none, all together must be even: a second volume
/// would hardly lie half a distance beside the first.
bool WereInTurns(const FrameSet& frames, const std::vector<FrameSet>& sets)
{
  const auto statedMm = frames.front().frame.distanceMm;
  if (!statedMm)
  {
    return LieOnOneGrid(frames);
  }
  const auto differenceMm = [&](const FrameSet& set)
  {
    const std::vector<double> heightsMm = HeightsOfPlaces(set);
    return heightsMm.size() < 2 ? 0.0 : std::abs(std::abs(*statedMm) - UsualDistanceMm(heightsMm));
  };
  return differenceMm(frames) < differenceMm(sets.front());
}

/// True for attributes whose values belong to whole volumes, not to slices acquired together.
bool TellsVolumes(std::size_t difference)
{
  constexpr std::array<DicomDifference, 6> OfSlices = { DicomDifference::Stack,
    DicomDifference::FrameNumber, DicomDifference::TriggerTime, DicomDifference::AcquisitionTime,
    DicomDifference::ContentTime, DicomDifference::Segment };
  return std::find(OfSlices.begin(), OfSlices.end(), DicomDifference(difference)) == OfSlices.end();
}

/// True if sets are volumes between each other's slices, instead of the parts of one. Slices that
/// were acquired together share moments and the like, which tell volumes only where the slices of
/// all would be uneven.
bool AreBetween(std::size_t difference, const FrameSet& frames, const std::vector<FrameSet>& sets)
{
  if (!AreInterleaved(sets))
  {
    return false;
  }
  const bool isVague = DicomDifference(difference) == DicomDifference::AcquisitionNumber;
  return TellsVolumes(difference) ? !(isVague && WereInTurns(frames, sets)) : !LieOnOneGrid(frames);
}

}

std::size_t PlaceCount(const FrameSet& frames)
{
  return PlacesOf(frames).size();
}

std::size_t MostPlaces(const std::vector<FrameSet>& sets)
{
  std::size_t most = 0;
  for (const FrameSet& set : sets)
  {
    most = std::max(most, PlaceCount(set));
  }
  return most;
}

std::size_t MostRepeats(const FrameSet& frames)
{
  std::map<int, std::size_t> counts;
  std::size_t most = 0;
  for (const PlacedFrame& frame : frames)
  {
    most = std::max(most, ++counts[frame.place]);
  }
  return most;
}

bool Varies(std::size_t difference, const FrameSet& frames)
{
  return std::any_of(frames.begin(), frames.end(),
    [&](const PlacedFrame& frame) {
      return frame.frame.differences[difference] != frames.front().frame.differences[difference];
    });
}

std::vector<FrameSet> VolumesBy(std::size_t difference, const FrameSet& frames)
{
  if (!Varies(difference, frames))
  {
    return {};
  }
  std::vector<FrameSet> sets = SetsBy(difference, frames);
  const bool areOver = sets.size() <= MostRepeats(frames) && LieOverEachOther(sets);
  return areOver || AreBetween(difference, frames, sets) ? sets : std::vector<FrameSet>();
}

}
