#include "Viewer/Model/SessionFile.h"

#include "Scene/OutputFile.h"
#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "Scene/SceneVolumes.h"
#include "Scene/SegmentFiles.h"

#include <vtkImageData.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <exception>

namespace varimarch
{

namespace
{

constexpr int DelayMilliseconds = 2000;

// A user does not run more viewers at once.
constexpr int MostCopies = 64;

// Copies that other viewers are writing, or have left, the latest first; then names for new ones.
QStringList CopiesIn(const QString& folder)
{
  QStringList copies;
  for (const QFileInfo& file :
    QDir(folder).entryInfoList({ "autosaved*.json" }, QDir::Files, QDir::Time))
  {
    copies.append(file.filePath());
  }
  for (int i = 1; i <= MostCopies; ++i)
  {
    const QString number = i == 1 ? QString() : QStringLiteral("-%1").arg(i);
    copies.append(folder + "/autosaved" + number + ".json");
  }
  return copies;
}

}

void WriteScene(const Scene& scene, const QString& path)
{
  WriteFileWhole(path.toStdString(), SceneText(scene));
}

QString WorkText(const Scene& scene, const Study& study)
{
  const auto textOf = [](const Scene& work) { return QString::fromStdString(SceneText(work)); };
  Scene work;
  work.cuts = scene.cuts;
  work.measures = scene.measures;
  work.keyImages = scene.keyImages;
  work.lights = scene.lights;
  work.shadows = scene.shadows;
  work.scattering = scene.scattering;
  work.occlusion = scene.occlusion;
  work.overlays = scene.overlays;
  if (!IsBuiltInLook(scene.look, study.statistics))
  {
    work.look = scene.look;
  }
  Scene asLoaded = work;
  if (scene.labels)
  {
    work.labels = scene.labels;
    asLoaded.labels = scene.labels;
    asLoaded.labels->segments = study.labels->segments;
  }
  if (textOf(work) == textOf(asLoaded))
  {
    work.labels.reset();
  }
  return textOf(work) == textOf(Scene()) ? QString() : textOf(work);
}

Autosave::Autosave(SceneModel* model, const QString& folder, QObject* parent)
  : QObject(parent)
  , model(model)
{
  QDir().mkpath(folder);
  QFile::setPermissions(folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  const QStringList copies = CopiesIn(folder);
  const auto free = std::find_if(
    copies.begin(), copies.end(), [this](const QString& copy) { return this->TryToLock(copy); });
  this->path = free == copies.end() ? QString() : *free;
  this->delay.setSingleShot(true);
  this->delay.setInterval(DelayMilliseconds);
  connect(&this->delay, &QTimer::timeout, this, &Autosave::Save);
  // Without the segments, for which the disk may be too small, the rest is still saved.
  connect(&this->segmentWriting, &BackgroundTask::Failed, this, &Autosave::SaveScene);
  connect(model, &SceneModel::Changed, this,
    [this](ScenePart part)
    {
      if (part == ScenePart::Volume)
      {
        this->saved = {}; // the segments on the disk are of another scan
      }
      if (!this->delay.isActive())
      {
        this->delay.start();
      }
    });
}

// Tries to lock a copy for this program. The lock of a program that has ended is replaced.
bool Autosave::TryToLock(const QString& copy)
{
  this->lock = std::make_unique<QLockFile>(copy + ".lock");
  this->lock->setStaleLockTime(0);
  if (this->lock->tryLock(0))
  {
    return true;
  }
  // A program that was killed while it wrote the lock has left one without an owner.
  qint64 process = 0;
  QString host;
  QString program;
  return !this->lock->getLockInfo(&process, &host, &program) && this->lock->removeStaleLockFile() &&
    this->lock->tryLock(0);
}

bool Autosave::HasCopy() const
{
  return QFile::exists(this->path);
}

QString Autosave::SegmentsPath(int volume) const
{
  const QString number = volume == 0 ? QString() : QStringLiteral(".volume%1").arg(volume + 1);
  return this->path.isEmpty() ? QString()
                              : this->path.chopped(int(qstrlen(".json"))) + number + ".seg.nrrd";
}

void Autosave::Remove()
{
  this->delay.stop();
  this->segmentWriting.Cancel();
  QFile::remove(this->path);
  for (int volume = 0; volume < int(MostVolumes); ++volume)
  {
    this->RemoveSegments(volume);
  }
}

void Autosave::RemoveSegments(int volume)
{
  QFile::remove(this->SegmentsPath(volume));
  this->saved[volume] = {};
}

void Autosave::Save()
{
  if (!this->path.isEmpty())
  {
    this->SaveFrom(0);
  }
}

// Saves the segments of this volume and of those after it, one after another, then the scene.
void Autosave::SaveFrom(int volume)
{
  while (volume < VolumeCount(this->model->CurrentScene()) &&
    (!this->model->HasUnsavedLabels(volume) || this->IsSaved(volume)))
  {
    ++volume;
  }
  if (volume < VolumeCount(this->model->CurrentScene()))
  {
    this->SaveSegments(volume);
  }
  else
  {
    this->SaveScene();
  }
}

bool Autosave::IsSaved(int volume) const
{
  return this->saved[volume].version == this->model->LabelVersion(volume);
}

void Autosave::SaveSegments(int volume)
{
  if (this->segmentWriting.IsRunning())
  {
    this->delay.start();
    return;
  }
  const auto study = this->model->StudyOf(volume);
  this->segmentWriting.Start(
    [study, segments = SceneLabelsOf(this->model->CurrentScene(), volume)->segments,
      file = this->SegmentsPath(volume).toStdString()](const TaskProgress& progress)
    {
      LabelMap labels;
      labels.image = CopyOfLabels(*study);
      WriteSegments(labels, segments, {}, file);
      // The copy may have been removed meanwhile, because the program ends.
      if (!progress(1.0))
      {
        QFile::remove(QString::fromStdString(file));
      }
    },
    [this, volume, version = study->labelVersion, numbers = study->labels->image]
    {
      this->saved[volume] = { numbers, version };
      this->SaveFrom(volume + 1);
    });
}

// A scene names the file of its segments that is nearest to what is shown.
void Autosave::NameSegments(Scene& scene, int volume) const
{
  auto& labels = SceneLabelsOf(scene, volume);
  const auto& shown = StudyOfVolume(*this->model->CurrentStudy(), volume).labels;
  if (labels && this->model->HasUnsavedLabels(volume) &&
    this->saved[volume].numbers == shown->image)
  {
    labels->path = this->SegmentsPath(volume).toStdString();
    labels->series.clear();
  }
  else if (labels && labels->path.empty())
  {
    labels.reset(); // they are in no file
  }
}

void Autosave::SaveScene()
{
  Scene scene = this->model->CurrentScene();
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    this->NameSegments(scene, volume);
  }
  try
  {
    WriteScene(scene, this->path);
  }
  catch (const std::exception&)
  {
    // A failed backup is not worth an error message at every edit.
    return;
  }
  for (int volume = 0; volume < int(MostVolumes) && !this->segmentWriting.IsRunning(); ++volume)
  {
    if (volume >= VolumeCount(scene) || !this->model->HasUnsavedLabels(volume))
    {
      this->RemoveSegments(volume);
    }
  }
}

}
