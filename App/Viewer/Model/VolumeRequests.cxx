#include "Viewer/Model/VolumeRequests.h"

#include "Viewer/Model/MemoryLimit.h"
#include "Viewer/Model/RecentScans.h"
#include "Viewer/Open/DroppedFiles.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace varimarch
{

namespace
{

bool IsSegmentation(const SeriesSummary& series)
{
  return series.modality == "SEG";
}

LoadedVolume LoadWithinMemory(
  const VolumeSource& source, const LoadObserver& observe, bool mayBePreview = false)
{
  const auto* const file = std::get_if<FileSource>(&source);
  return LoadVolume(file ? WithinMemory(*file) : source, observe, mayBePreview);
}

Study StudyWithoutLabels(LoadedVolume volume)
{
  ImageStatistics statistics(volume.image);
  return { std::move(volume), std::move(statistics) };
}

// The volume as a study, with labels over it. Labels that cannot be read do not lose the volume.
std::shared_ptr<const Study> StudyOf(LoadedVolume volume, const std::string& path,
  const std::optional<SceneLabels>& labels, const LoadObserver& observe)
{
  Study study = StudyWithoutLabels(std::move(volume));
  try
  {
    if (labels)
    {
      return WithLabels(study, LoadLabels(*labels, study.volume, observe));
    }
    if (!study.volume.segments.empty())
    {
      LabelMap own = LabelMapOf(study.volume, path, study.volume);
      own.warnings.clear(); // they are those of the volume
      return WithLabels(study, std::move(own));
    }
  }
  catch (const std::runtime_error& reason)
  {
    study.volume.warnings.push_back(reason.what());
  }
  return std::make_shared<const Study>(std::move(study));
}

// The volume over another one. It is drawn by its look even if its values are labels.
std::shared_ptr<const Study> OverlayStudy(
  const OverlaidVolume& overlay, const LoadObserver& observe)
{
  LoadedVolume volume = LoadWithinMemory(overlay.source, observe);
  return overlay.labels ? StudyOf(std::move(volume), {}, overlay.labels, observe)
                        : std::make_shared<const Study>(StudyWithoutLabels(std::move(volume)));
}

// The volume with others over it. One that cannot be read is null.
std::shared_ptr<const Study> WithOverlays(const std::shared_ptr<const Study>& first,
  const std::vector<OverlaidVolume>& overlays, const LoadObserver& observe)
{
  Study study = *first;
  for (const OverlaidVolume& overlay : overlays)
  {
    study.overlays.emplace_back();
    try
    {
      study.overlays.back() = OverlayStudy(overlay, observe);
    }
    catch (const std::runtime_error& reason)
    {
      study.volume.warnings.push_back(reason.what());
    }
  }
  return std::make_shared<const Study>(std::move(study));
}

// The only series that fulfils a condition.
template <class Condition>
const SeriesSummary* OnlySeries(const std::vector<SeriesSummary>& series, const Condition& isWanted)
{
  const auto first = std::find_if(series.begin(), series.end(), isWanted);
  return std::count_if(series.begin(), series.end(), isWanted) == 1 ? &*first : nullptr;
}

// The series to open without a question; null if the user has to choose.
const SeriesSummary* SeriesToOpen(const std::vector<SeriesSummary>& series, const QString& digest)
{
  if (!digest.isEmpty())
  {
    return OnlySeries(
      series, [&](const SeriesSummary& one) { return DigestOfSeries(one.uid) == digest; });
  }
  return series.size() == 1 ? &series.front() : OnlySeries(series, std::not_fn(IsSegmentation));
}

// Reads a volume. Its coarse copy, if it has one, is shown before, as a volume of one time: each
// other time would be read whole.
LoadedVolume ReadShowing(
  const VolumeSource& source, const LoadObserver& observe, const ShowPreview& show)
{
  LoadedVolume volume = LoadWithinMemory(source, observe, bool(show));
  if (volume.isPreview)
  {
    volume.times = {};
    show(source, std::make_shared<const Study>(StudyWithoutLabels(std::move(volume))));
    volume = LoadWithinMemory(source, observe);
  }
  return volume;
}

}

Found ReadVolume(const VolumeWish& wish, const LoadObserver& observe, const ShowPreview& show)
{
  Found found;
  found.source = wish.source;
  auto* const file = std::get_if<FileSource>(&found.source);
  if (file && MayHoldSeveralSeries(*file))
  {
    found.series = ListSeries(file->path, observe);
    if (!wish.ofSeries.empty())
    {
      found.series = SeriesOfFiles(found.series, wish.ofSeries, observe);
    }
    std::copy_if(found.series.begin(), found.series.end(), std::back_inserter(found.segmentations),
      IsSegmentation);
    const SeriesSummary* const chosen = SeriesToOpen(found.series, wish.digest);
    if (!chosen && (!found.series.empty() || !wish.digest.isEmpty()))
    {
      return found;
    }
    // The only series of a folder needs no name.
    const bool isOneOfMore =
      found.series.size() > 1 || !wish.digest.isEmpty() || !wish.ofSeries.empty();
    if (chosen && isOneOfMore)
    {
      file->series = chosen->uid;
    }
  }
  const bool isAlone = wish.isForItself && !wish.labels && wish.overlays.empty();
  found.study = StudyOf(ReadShowing(found.source, observe, isAlone ? show : ShowPreview()),
    file ? file->path : std::string(), wish.labels, observe);
  if (!wish.overlays.empty())
  {
    found.study = WithOverlays(found.study, wish.overlays, observe);
  }
  return found;
}

Found ReadTogether(
  const std::vector<std::string>& paths, const LoadObserver& observe, const ShowPreview& show)
{
  const DroppedFiles dropped = TogetherDropped(paths);
  VolumeWish wish;
  wish.source = FileSource{ dropped.path, std::nullopt };
  wish.ofSeries = dropped.ofSeries;
  return ReadVolume(wish, observe, show);
}

Found ReadBeside(const std::string& path, const std::vector<std::shared_ptr<const Study>>& scans,
  const LoadObserver& observe)
{
  Found found;
  found.source = FileSource{ path, std::nullopt };
  found.labels.path = path;
  LoadedVolume volume = LoadWithinMemory(found.source, observe);
  const bool areLabels = !volume.segments.empty();
  try
  {
    found.labelled = WithLabelsOnOne(scans, volume, path);
    if (!areLabels && found.labelled->labels->segments.size() >= std::size_t(MostSegments))
    {
      found.labelled.reset(); // so many values are rather those of a scan
    }
  }
  catch (const std::runtime_error&)
  {
    // They belong to none of the scans.
    if (areLabels)
    {
      throw;
    }
  }
  if (!areLabels)
  {
    found.study = StudyOf(std::move(volume), path, std::nullopt, observe);
  }
  return found;
}

}
