#include "Readers/Dicom/Differences.h"

#include "Readers/Dicom/DicomFrame.h"
#include "Readers/Dicom/Grouping.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Times.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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

namespace
{

/// Names of DicomDifference for warnings.
constexpr std::array<const char*, std::size_t(DicomDifference::Count)> DifferenceNames = {
  "kind of image", "component of complex numbers", "segment", "view", "echo", "inversion time",
  "flip angle", "b-value", "diffusion direction", "energy", "time point", "trigger time",
  "phase of the heart", "phase of the breath", "frame number", "acquisition number",
  "acquisition time", "reconstruction kernel", "stack", "time of day"
};

/// True for attributes by which frames follow each other in time.
bool IsTime(std::size_t difference)
{
  constexpr std::array<DicomDifference, 8> Times = { DicomDifference::TimePoint,
    DicomDifference::TriggerTime, DicomDifference::CardiacPhase, DicomDifference::RespiratoryPhase,
    DicomDifference::FrameNumber, DicomDifference::AcquisitionNumber,
    DicomDifference::AcquisitionTime, DicomDifference::ContentTime };
  return std::find(Times.begin(), Times.end(), DicomDifference(difference)) != Times.end();
}

/// The warning of times that are left out because they are incomplete.
std::string WarningOfIncomplete(
  std::size_t difference, const std::vector<FrameSet>& sets, std::size_t completeCount)
{
  const std::size_t complete = MostPlaces(sets);
  std::vector<std::string> incomplete;
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    const std::size_t count = PlaceCount(sets[i]);
    if (count < complete)
    {
      incomplete.push_back("volume " + std::to_string(i + 1) + " has " + std::to_string(count) +
        " of " + std::to_string(complete) + " slices");
    }
  }
  return "The series holds " + std::to_string(sets.size()) + " volumes that differ in their " +
    DifferenceNames[difference] + "; only the " +
    (completeCount > 1 ? "complete ones were read" : "first complete one was read") + "; " +
    NameList(incomplete) + ".";
}

/// A name such as "echo 20".
std::string NameOf(std::size_t difference, const FrameSet& set)
{
  const std::string& value = set.front().frame.differences[difference];
  const std::size_t begin = value.find_first_not_of(' ');
  return std::string(value.empty() ? "no " : "") + DifferenceNames[difference] +
    (value.empty() ? "" : " " + value.substr(std::min(begin, value.size())));
}

std::string Joined(const std::string& name, const std::string& more)
{
  return name + (name.empty() ? "" : ", ") + more;
}

/// Frames at each place, in the order of a key, so that the first at each place make the first set;
/// none if a place has equal keys, or fewer frames than another.
std::vector<FrameSet> RankedBy(
  const std::function<std::optional<double>(const DicomFrame&)>& keyOf, const FrameSet& frames)
{
  std::map<int, std::map<double, const PlacedFrame*>> ranked;
  for (const PlacedFrame& frame : frames)
  {
    const auto key = keyOf(frame.frame);
    if (!key || !ranked[frame.place].insert({ *key, &frame }).second)
    {
      return {};
    }
  }
  std::vector<FrameSet> sets(ranked.begin()->second.size());
  for (const auto& [place, ofPlace] : ranked)
  {
    if (ofPlace.size() != sets.size())
    {
      return {};
    }
    auto set = sets.begin();
    for (const auto& [key, frame] : ofPlace)
    {
      (set++)->push_back(*frame);
    }
  }
  return sets;
}

/// Times by the rank of frames at their places, for which no attribute has a value that all slices
/// of a time share; the frames themselves if they have no rank.
std::vector<FrameSet> SetsByRank(const FrameSet& frames, std::vector<std::string>& warnings)
{
  constexpr std::size_t ByNumber = DifferenceNames.size();
  for (std::size_t difference = 0; difference <= ByNumber; ++difference)
  {
    if (difference < ByNumber && (!IsTime(difference) || !Varies(difference, frames)))
    {
      continue;
    }
    std::vector<FrameSet> sets = RankedBy(
      [&](const DicomFrame& frame) -> std::optional<double>
      {
        return difference == ByNumber ? std::optional(frame.instanceNumber)
                                      : NumberIn(frame.differences[difference]);
      },
      frames);
    if (sets.size() > 1)
    {
      warnings.push_back("Each place has " + std::to_string(sets.size()) +
        " images, and no value tells which of different places belong together; they were taken "
        "for times in the order of their " +
        (difference == ByNumber ? "number" : DifferenceNames[difference]) + ".");
      return sets;
    }
  }
  return { frames };
}

/// Times of one kind, and those that are incomplete.
class TimeSeparation
{
public:
  explicit TimeSeparation(FrameKind& kind)
    : kind(kind)
  {
  }

  void Separate(const FrameSet& frames)
  {
    this->kind.sets = this->SetsFrom(0, frames, this->kind.warnings);
  }

  /// Incomplete times, as kinds.
  const std::vector<FrameKind>& Incomplete() const { return this->incomplete; }

private:
  /// The sets of each of several times, which the attributes from one on may separate further; as
  /// complete as the first. Only the first warns, since the others are alike.
  std::vector<FrameSet> SetsOfEach(
    const std::vector<FrameSet>& times, std::size_t difference, std::vector<std::string>& warnings)
  {
    std::vector<FrameSet> all;
    std::vector<std::string> ignored;
    for (const FrameSet& time : times)
    {
      for (FrameSet& set : this->SetsFrom(difference, time, all.empty() ? warnings : ignored))
      {
        if (all.empty() || PlaceCount(set) == PlaceCount(all.front()))
        {
          all.push_back(std::move(set));
        }
      }
    }
    return all;
  }

  /// The times by the attributes from one on.
  std::vector<FrameSet> SetsFrom(
    std::size_t difference, const FrameSet& frames, std::vector<std::string>& warnings)
  {
    for (; difference < DifferenceNames.size(); ++difference)
    {
      const std::vector<FrameSet> sets =
        IsTime(difference) ? VolumesBy(difference, frames) : std::vector<FrameSet>();
      if (sets.empty())
      {
        continue;
      }
      std::vector<FrameSet> complete;
      for (const FrameSet& set : sets)
      {
        if (PlaceCount(set) == MostPlaces(sets))
        {
          complete.push_back(set);
        }
        else
        {
          this->incomplete.push_back(
            { Joined(this->kind.name, NameOf(difference, set)) + ", incomplete", { set } });
        }
      }
      if (complete.size() < sets.size())
      {
        warnings.push_back(WarningOfIncomplete(difference, sets, complete.size()));
      }
      return this->SetsOfEach(complete, difference + 1, warnings);
    }
    return MostRepeats(frames) > 1 ? SetsByRank(frames, warnings) : std::vector<FrameSet>{ frames };
  }

  FrameKind& kind;
  std::vector<FrameKind> incomplete;
};

/// Appends the kinds that the attributes from one on separate, and incomplete times.
void AppendKinds(std::size_t difference, const FrameSet& frames, const std::string& name,
  std::vector<FrameKind>& kinds, std::vector<FrameKind>& incomplete)
{
  for (; difference < DifferenceNames.size(); ++difference)
  {
    std::vector<FrameSet> sets =
      IsTime(difference) ? std::vector<FrameSet>() : VolumesBy(difference, frames);
    std::stable_partition(sets.begin(), sets.end(),
      [most = MostPlaces(sets)](const FrameSet& set) { return PlaceCount(set) == most; });
    for (const FrameSet& set : sets)
    {
      AppendKinds(difference + 1, set, Joined(name, NameOf(difference, set)), kinds, incomplete);
    }
    if (!sets.empty())
    {
      return;
    }
  }
  kinds.push_back({ name, {} });
  TimeSeparation times(kinds.back());
  times.Separate(frames);
  incomplete.insert(incomplete.end(), times.Incomplete().begin(), times.Incomplete().end());
}

}

std::vector<FrameKind> SeparatedKinds(const FrameSet& frames)
{
  std::vector<FrameKind> kinds;
  std::vector<FrameKind> incomplete;
  AppendKinds(0, frames, "", kinds, incomplete);
  kinds.insert(kinds.end(), incomplete.begin(), incomplete.end());
  return kinds;
}

namespace
{

constexpr double SecondsPerMs = 1e-3;

/// The seconds of a time such as 134501.25, or of a date and time such as 20240131134501.25; NaN
/// for other texts.
double SecondsOfDicomTime(const std::string& text)
{
  constexpr std::size_t DateDigits = 8;
  constexpr std::size_t ClockDigits = 6;
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const bool hasDate = digits == DateDigits + ClockDigits;
  if (!hasDate && digits != ClockDigits)
  {
    return NAN;
  }
  return hasDate ? *SecondsOfMoment(text.substr(0, DateDigits), text.substr(DateDigits))
                 : *SecondsOfMoment("19700101", text);
}

/// Time after the R wave [s]. A text that begins with a blank is the number of a slot of nuclear
/// medicine.
double TriggerSeconds(const DicomFrame& frame)
{
  const std::string& text = frame.differences[std::size_t(DicomDifference::TriggerTime)];
  const bool isSlot = !text.empty() && text.front() == ' ';
  return isSlot ? NAN : SecondsPerMs * NumberIn(text).value_or(NAN);
}

double ClockSeconds(const DicomFrame& frame, DicomDifference difference)
{
  return SecondsOfDicomTime(frame.differences[std::size_t(difference)]);
}

double StatedSeconds(const DicomFrame& frame)
{
  return frame.timeSeconds.value_or(NAN);
}

double AcquisitionSeconds(const DicomFrame& frame)
{
  return ClockSeconds(frame, DicomDifference::AcquisitionTime);
}

double ContentSeconds(const DicomFrame& frame)
{
  return ClockSeconds(frame, DicomDifference::ContentTime);
}

}

VolumeTimes TimesOf(const std::vector<const DicomFrame*>& frames)
{
  for (const auto secondsOf : { StatedSeconds, TriggerSeconds, AcquisitionSeconds, ContentSeconds })
  {
    const bool isClock = secondsOf == AcquisitionSeconds || secondsOf == ContentSeconds;
    const double start = isClock ? secondsOf(*frames.front()) : 0.0;
    std::vector<double> seconds;
    for (const DicomFrame* frame : frames)
    {
      seconds.push_back(secondsOf(*frame) - start);
    }
    const VolumeTimes times = StatedTimes(seconds);
    if (times.areSeconds)
    {
      return times;
    }
  }
  return NumberedTimes(std::int64_t(frames.size()));
}

}
