#include "Readers/Dicom/Differences.h"

#include "Readers/NumberText.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>

namespace varimarch
{
namespace
{

/// Names of DicomDifference for warnings.
constexpr std::array<const char*, std::size_t(DicomDifference::Count)> DifferenceNames = {
  "kind of image", "component of complex numbers", "segment", "view", "echo", "inversion time",
  "flip angle", "b-value", "diffusion direction", "energy", "time point", "trigger time",
  "phase of the heart", "phase of the breath", "frame number", "acquisition number",
  "acquisition time", "reconstruction kernel", "stack", "time of day"
};

using FrameSet = std::vector<PlacedFrame>;

std::set<int> PlacesOf(const FrameSet& frames)
{
  std::set<int> places;
  for (const PlacedFrame& frame : frames)
  {
    places.insert(frame.place);
  }
  return places;
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

/// The number of places of the largest set.
std::size_t MostPlaces(const std::vector<FrameSet>& sets)
{
  std::size_t most = 0;
  for (const FrameSet& set : sets)
  {
    most = std::max(most, PlacesOf(set).size());
  }
  return most;
}

/// True for attributes by which frames follow each other in time.
bool IsTime(std::size_t difference)
{
  constexpr std::array<DicomDifference, 8> Times = { DicomDifference::TimePoint,
    DicomDifference::TriggerTime, DicomDifference::CardiacPhase, DicomDifference::RespiratoryPhase,
    DicomDifference::FrameNumber, DicomDifference::AcquisitionNumber,
    DicomDifference::AcquisitionTime, DicomDifference::ContentTime };
  return std::find(Times.begin(), Times.end(), DicomDifference(difference)) != Times.end();
}

/// The warning of sets that are not read: those that are incomplete, or all but one.
std::string WarningOfOthers(
  std::size_t difference, const std::vector<FrameSet>& sets, std::size_t keptCount)
{
  const std::size_t complete = MostPlaces(sets);
  std::vector<std::string> incomplete;
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    const std::size_t count = PlacesOf(sets[i]).size();
    if (count < complete)
    {
      incomplete.push_back("volume " + std::to_string(i + 1) + " has " + std::to_string(count) +
        " of " + std::to_string(complete) + " slices");
    }
  }
  const std::string text = "The series holds " + std::to_string(sets.size()) +
    " volumes that differ in their " + DifferenceNames[difference] + "; only the ";
  const std::string kept = keptCount > 1 ? "complete ones were read"
    : incomplete.empty()                 ? "first was read"
                                         : "first complete one was read";
  return text + kept + (incomplete.empty() ? "." : "; " + NameList(incomplete) + ".");
}

std::vector<FrameSet> SetsFrom(
  std::size_t difference, FrameSet frames, std::vector<std::string>& warnings);

/// The sets of each of several times, which the attributes from one on may separate further; as
/// complete as the first. Only the first warns, since the others are alike.
std::vector<FrameSet> SetsOfEach(
  const std::vector<FrameSet>& times, std::size_t difference, std::vector<std::string>& warnings)
{
  std::vector<FrameSet> all;
  std::vector<std::string> ignored;
  for (const FrameSet& time : times)
  {
    for (FrameSet& set : SetsFrom(difference, time, all.empty() ? warnings : ignored))
    {
      if (all.empty() || PlacesOf(set).size() == PlacesOf(all.front()).size())
      {
        all.push_back(std::move(set));
      }
    }
  }
  return all;
}

/// SetsOfTimes by the attributes from one on.
std::vector<FrameSet> SetsFrom(
  std::size_t difference, FrameSet frames, std::vector<std::string>& warnings)
{
  for (; difference < DifferenceNames.size(); ++difference)
  {
    const std::size_t repeats = MostRepeats(frames);
    if (repeats == 1)
    {
      break;
    }
    const std::vector<FrameSet> sets = SetsBy(difference, frames);
    if (sets.size() == 1 || sets.size() > repeats || !LieOverEachOther(sets))
    {
      continue;
    }
    std::vector<FrameSet> kept;
    std::copy_if(sets.begin(), sets.end(), std::back_inserter(kept),
      [complete = MostPlaces(sets)](const FrameSet& set)
      { return PlacesOf(set).size() == complete; });
    kept.resize(IsTime(difference) ? kept.size() : 1);
    if (kept.size() < sets.size())
    {
      warnings.push_back(WarningOfOthers(difference, sets, kept.size()));
    }
    if (kept.size() > 1)
    {
      return SetsOfEach(kept, difference + 1, warnings);
    }
    frames = kept.front();
  }
  return { frames };
}

}

std::vector<FrameSet> SetsOfTimes(const FrameSet& frames, std::vector<std::string>& warnings)
{
  return SetsFrom(0, frames, warnings);
}

}
