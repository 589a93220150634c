#include "Viewer/Open/LoadController.h"

#include "Scene/Model/Scene.h"
#include "Viewer/Model/Log.h"
#include "Viewer/Model/SessionFile.h"

#include <chrono>
#include <new>
#include <stdexcept>
#include <utility>

namespace varimarch
{

namespace
{

void LogVolume(const LoadedVolume& volume)
{
  const int* const count = volume.image->GetDimensions();
  LogEvent("volume opened",
    { { "columns", double(count[0]) }, { "rows", double(count[1]) }, { "slices", double(count[2]) },
      { "bytes per value", double(volume.image->GetScalarSize()) },
      { "warnings", double(volume.warnings.size()) } });
}

// The segmentations that lie beside a scan.
std::vector<SeriesSummary> SegmentationsBeside(const LoadRequest& request, const LoadResult& found)
{
  if (const auto* const scan = std::get_if<NewScan>(&request))
  {
    return found.series.empty() ? scan->segmentations : SegmentationsAmong(found.series);
  }
  if (const auto* const session = std::get_if<SavedSession>(&request))
  {
    return found.series.empty() ? session->segmentations : SegmentationsAmong(found.series);
  }
  return SegmentationsAmong(found.series);
}

// The number of the volume for which labels were requested.
int LabelledVolume(const LoadRequest& request)
{
  const auto* const dropped = std::get_if<DroppedFile>(&request);
  return dropped ? dropped->volume : std::get<LabelsOverScan>(request).volume;
}

}

LoadController::LoadController(Context newContext, QObject* parent)
  : QObject(parent)
  , context(std::move(newContext))
{
  connect(&this->task, &BackgroundTask::Progress, this, &LoadController::Progress);
  connect(&this->task, &BackgroundTask::Stopped, this, &LoadController::EndCancelled);
  connect(&this->task, &BackgroundTask::Failed, this,
    [this](const QString& reason)
    {
      this->End();
      emit this->Failed(reason);
    });
}

// The thread has more time to stop when the program ends.
LoadController::~LoadController()
{
  this->task.SetPatience(std::chrono::seconds(10));
}

void LoadController::Start(const LoadRequest& request)
{
  if (this->loading)
  {
    this->EndCancelled();
  }
  this->loading = Loading{ request };
  LogEvent("loading");
  emit this->LoadingChanged(true);
  emit this->Began(PathOf(request));
  const auto read = [this, request, read = this->context.read](
                      const TaskProgress& progress, const TaskPost& post)
  {
    const auto show = [&](const VolumeSource& source, std::shared_ptr<const Study> study)
    { post([this, source, study = std::move(study)] { this->Preview(source, study); }); };
    try
    {
      return read(request, progress, show);
    }
    catch (const std::bad_alloc&)
    {
      throw std::runtime_error(tr("There is not enough memory for this volume.").toStdString());
    }
  };
  this->task.StartAfterLast(read, [this](const LoadResult& found) { this->Take(found); });
}

bool LoadController::HasPlaceForScan() const
{
  return this->context.model->CurrentScene().overlays.size() + 1 < MostVolumes;
}

void LoadController::StartLabels(const SceneLabels& labels, int volume)
{
  this->Start(LabelsOverScan{ labels, volume, this->context.model->StudyOf(volume) });
}

void LoadController::StartDropped(const std::string& path)
{
  const SceneModel& model = *this->context.model;
  DroppedFile dropped = { path, model.EditedVolume(), { model.EditedStudy() } };
  for (int volume = 0; volume < VolumeCount(model.CurrentScene()); ++volume)
  {
    if (volume != model.EditedVolume())
    {
      dropped.scans.push_back(model.StudyOf(volume));
    }
  }
  this->Start(dropped);
}

void LoadController::ToggleRectified()
{
  const SceneModel& model = *this->context.model;
  VolumeSource source = model.CurrentScene().volume;
  auto& file = std::get<FileSource>(source);
  file.rectified = model.CurrentStudy()->volume.slices != SliceLayout::Rectified;
  const std::shared_ptr<const Study> known = model.ExchangedStudy();
  // Labels lie on the grid of one form of the scan.
  const std::optional<SceneLabels>& labels = model.CurrentScene().labels;
  if (known && !labels && known->volume.slices != model.CurrentStudy()->volume.slices)
  {
    this->Exchange(source, known);
  }
  else if (!this->loading)
  {
    this->Start(OtherForm{ source, labels });
  }
}

void LoadController::Cancel()
{
  this->task.Stop();
}

LoadController::Loading LoadController::End()
{
  Loading ended = *std::exchange(this->loading, std::nullopt);
  emit this->LoadingChanged(false);
  return ended;
}

void LoadController::EndCancelled()
{
  LogEvent("loading cancelled");
  this->End();
  emit this->Cancelled();
}

void LoadController::Preview(const VolumeSource& source, const std::shared_ptr<const Study>& study)
{
  LogVolume(study->volume);
  this->context.model->Open(source, study);
  this->loading->isPreviewed = true;
  this->context.work->TakeAsSaved();
  emit this->Previewed();
}

void LoadController::Take(const LoadResult& found)
{
  const Loading ended = this->End();
  if (found.study && found.labelled)
  {
    emit this->LabelsFound(ended.request, found);
  }
  else if (found.labelled)
  {
    this->ShowLabels(ended.request, found);
  }
  else if (found.study)
  {
    this->Show(ended, found);
  }
  else
  {
    LogEvent("series to choose from", { { "count", double(found.series.size()) } });
    emit this->SeriesFound(ended.request, found);
  }
}

void LoadController::ShowLabels(const LoadRequest& request, const LoadResult& found)
{
  const std::optional<int> volume = this->context.model->VolumeOf(*found.labelled);
  if (!volume && LabelledVolume(request) == 0)
  {
    // Meanwhile the user chose another form of the scan, with another grid.
    this->StartLabels(found.labels, 0);
  }
  if (!volume)
  {
    return; // the user may have removed the added scan
  }
  const LabelMap& labels = *found.labelled->labels;
  LogEvent("segmentation opened",
    { { "segments", double(labels.segments.size()) },
      { "warnings", double(labels.warnings.size()) } });
  this->context.model->SetEditedVolume(*volume);
  this->context.model->ShowLabels(found.labels, found.labelled, tr("open a segmentation"), *volume);
  emit this->LabelsShown(int(labels.segments.size()));
}

void LoadController::ShowAsScan(const LoadRequest& request, const LoadResult& found)
{
  this->Show({ request }, found);
}

void LoadController::Show(const Loading& ended, const LoadResult& found)
{
  LogVolume(found.study->volume);
  if (std::holds_alternative<OtherForm>(ended.request))
  {
    this->Exchange(found.source, found.study);
  }
  else if (std::holds_alternative<AddedScan>(ended.request))
  {
    this->Add(found);
  }
  else
  {
    this->Open(ended, found);
  }
}

void LoadController::Exchange(const VolumeSource& source, const std::shared_ptr<const Study>& form)
{
  const bool isRectified = form->volume.slices == SliceLayout::Rectified;
  this->context.model->Exchange(
    source, form, isRectified ? tr("rectify slices") : tr("show slices as scanned"));
  emit this->FormShown();
}

void LoadController::Add(const LoadResult& found)
{
  // While it was read, others may have been added, or brought back by redo.
  if (!this->HasPlaceForScan())
  {
    emit this->Failed(
      tr("At most %1 scans are drawn at once: remove one of them, and add the scan again")
        .arg(MostVolumes));
    return;
  }
  SceneModel& model = *this->context.model;
  const OverlaidVolume overlay =
    OverlayOf(found.source, found.study->volume, found.study->statistics);
  const CommonSpace space = SpaceOf(model.CurrentStudy()->volume, found.study->volume);
  LogEvent("scan added", { { "count", double(model.CurrentScene().overlays.size() + 2) } });
  model.AddOverlay(overlay, WithoutLabels(*found.study), tr("add a scan"));
  emit this->Added(QString::fromStdString(overlay.name), space);
}

// The work on a coarse copy is kept and stays unsaved.
void LoadController::Open(const Loading& ended, const LoadResult& found)
{
  SceneModel& model = *this->context.model;
  SavedWork& work = *this->context.work;
  const bool completes = ended.isPreviewed && model.CurrentStudy()->volume.isPreview;
  const bool losesLabels = completes && model.HasUnsavedLabels();
  const bool isUnexpected = std::holds_alternative<DroppedFile>(ended.request) || losesLabels;
  if (isUnexpected && !this->context.mayLeaveScan())
  {
    return;
  }
  const bool isUnsaved = completes && !work.IsSaved();
  const auto* const session = std::get_if<SavedSession>(&ended.request);
  if (session)
  {
    Scene scene = session->scene;
    scene.volume = found.source;
    work.ForgetAutosavedFiles(scene);
    model.Restore(scene, found.study);
  }
  else if (completes)
  {
    model.Complete(found.study);
  }
  else
  {
    model.Open(found.source, found.study);
  }
  if (isUnsaved || (session && session->isAutosaved))
  {
    work.TakeAsUnsaved();
  }
  else
  {
    work.TakeAsSaved();
  }
  emit this->Opened(found.source, SegmentationsBeside(ended.request, found));
}

}
