#include "Readers/Dicom/Differences.h"

#include "Readers/NumberText.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

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

}
