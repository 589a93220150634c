#include "Viewer/SaveActions.h"

#include "DicomSegments/DicomSegments.h"
#include "Readers/Dicom/TaggedSeries.h"
#include "Scene/Model/Scene.h"
#include "Scene/Segments/LabelMap.h"
#include "Viewer/Dialogs.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/SessionFile.h"
#include "Viewer/ScanLists.h"

#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>

#include <exception>

namespace varimarch
{

namespace
{

// Only DICOM has frames of reference.
bool IsDicom(const Study& study)
{
  return !study.volume.frameOfReference.empty();
}

/// Segments to save, and the volume that they lie on.
struct SegmentsToSave
{
  const Scene& scene;
  std::shared_ptr<const Study> first; ///< may be replaced in the model while a dialog is open
  int volume;

  const SceneLabels& Labels() const { return *SceneLabelsOf(this->scene, this->volume); }
  const Study& Scan() const { return StudyOfVolume(*this->first, this->volume); }
};

struct SavedSegments
{
  std::vector<Segment> segments; ///< with the values that they have in the file
  QStringList losses;            ///< sentences about what the format does not hold
};

std::vector<VolumeSource> SourcesOf(const Scene& scene)
{
  std::vector<VolumeSource> sources;
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    sources.push_back(VolumeSourceOf(scene, volume));
  }
  return sources;
}

// DICOM numbers segments from 1 on.
SavedSegments SaveDicomSegments(const SegmentsToSave& segments, const std::string& path)
{
  RequireNoFileOf(SourcesOf(segments.scene), path);
  const auto& scan = std::get<FileSource>(VolumeSourceOf(segments.scene, segments.volume));
  ReadProgress progress([](double) { return true; });
  const TaggedSeries images(scan.path, scan.series, progress);
  SavedSegments saved = { segments.Labels().segments, {} };
  WriteDicomSegments(*segments.Scan().labels, saved.segments, images.Files(), path);
  for (std::size_t i = 0; i < saved.segments.size(); ++i)
  {
    saved.segments[i].value = int(i) + 1;
  }
  return saved;
}

SavedSegments SaveSegments(const SegmentsToSave& segments, const std::string& path)
{
  if (IsDicom(segments.Scan()) &&
    QString::fromStdString(path).endsWith(".dcm", Qt::CaseInsensitive))
  {
    return SaveDicomSegments(segments, path);
  }
  SavedSegments saved = { segments.Labels().segments, {} };
  for (const std::string& loss :
    WriteSegments(*segments.Scan().labels, saved.segments, SourcesOf(segments.scene), path))
  {
    saved.losses.append(QString::fromStdString(loss));
  }
  return saved;
}

}

SaveActions::SaveActions(const Context& context, QMainWindow* window)
  : QObject(window)
  , context(context)
  , window(window)
{
}

void SaveActions::AddTo(QMenu* menu)
{
  menu->addAction(tr("&Save the session…"), this, &SaveActions::SaveSession, QKeySequence::Save);
}

bool SaveActions::MayLeaveScan()
{
  if (this->context.work->IsSaved())
  {
    return true;
  }
  const QMessageBox::StandardButton answer = QMessageBox::question(this->window, tr("Varimarch"),
    tr("Your measurements, cuts, look and segments are not saved. Save the session?"),
    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && this->SaveSession());
}

// A session names the file of its segments, so they are saved first.
bool SaveActions::SaveSession()
{
  const auto* const file = std::get_if<FileSource>(&this->context.model->CurrentScene().volume);
  if (file && this->context.lists->IsTemporary(file->path))
  {
    QMessageBox::information(this->window, tr("Cannot save"),
      tr("This scan was fetched from an archive and is deleted at the end, so a session could not "
         "find it again. Fetch it with \"Keep in…\" first."));
    return false;
  }
  while (const std::optional<int> unsaved = this->context.model->VolumeWithUnsavedLabels())
  {
    if (!this->SaveSegmentation(*unsaved))
    {
      return false;
    }
  }
  const QString path = this->context.model->CurrentStudy()
    ? ChosenFileToSave(this->window, tr("Save the session"), { tr("Sessions (*.json)") }, "session")
    : QString();
  if (path.isEmpty())
  {
    return false;
  }
  try
  {
    WriteScene(this->context.model->CurrentScene(), path);
  }
  catch (const std::exception& problem)
  {
    this->ShowFailure(problem);
    return false;
  }
  this->context.work->TakeAsSaved();
  emit this->Saved(path);
  return true;
}

bool SaveActions::SaveSegmentation(int volume)
{
  QStringList filters = { tr("Segmentation of 3D Slicer (*.seg.nrrd)"), tr("NIfTI (*.nii.gz)") };
  if (IsDicom(*this->context.model->StudyOf(volume)))
  {
    filters.append(tr("DICOM segmentation (*.dcm)"));
  }
  const QString name =
    volume == 0 ? "segmentation" : QStringLiteral("segmentation-%1").arg(volume + 1);
  const QString path = ChosenFileToSave(this->window, tr("Save the segmentation"), filters, name);
  if (path.isEmpty())
  {
    return false;
  }
  SavedSegments saved;
  try
  {
    const WaitCursor waiting;
    saved = SaveSegments(
      { this->context.model->CurrentScene(), this->context.model->CurrentStudy(), volume },
      path.toStdString());
  }
  catch (const std::exception& problem)
  {
    this->ShowFailure(problem);
    return false;
  }
  this->context.model->TakeSavedLabels(
    path.toStdString(), saved.segments, tr("save the segmentation"), volume);
  emit this->Saved(path);
  if (!saved.losses.isEmpty())
  {
    QMessageBox::information(this->window, tr("Saved %1").arg(path), saved.losses.join('\n'));
  }
  return true;
}

void SaveActions::ShowFailure(const std::exception& problem)
{
  QMessageBox::warning(this->window, tr("Cannot save"), QString::fromStdString(problem.what()));
}

}
