#include "Viewer/Model/SessionFile.h"

#include "Scene/Files/OutputFile.h"
#include "Scene/Files/SmallFile.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Model/Scene.h"
#include "Scene/Segments/LabelMap.h"

#include <vtkImageData.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <exception>
#include <stdexcept>

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
  const std::string text = SceneText(scene);
  if (text.size() > MostBytesOfSmallFile)
  {
    throw std::runtime_error(path.toStdString() + ": cannot be saved: the session has " +
      std::to_string(text.size() >> 20) +
      " MB, and one of more than 16 MB could not be opened again; delete some of its measurements");
  }
  WriteFileWhole(path.toStdString(), text);
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
  for (OverlaidVolume& overlay : work.overlays)
  {
    if (auto* const file = std::get_if<FileSource>(&overlay.source))
    {
      file->time = 0; // to look at another time is no work
      file->timeSeconds.reset();
    }
  }
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

QString Autosave::SegmentsPath(int file) const
{
  const QString number = file == 0 ? QString() : QStringLiteral(".volume%1").arg(file + 1);
  return this->path.isEmpty() ? QString()
                              : this->path.chopped(int(qstrlen(".json"))) + number + ".seg.nrrd";
}

bool Autosave::IsSegmentsPath(const std::string& candidate) const
{
  for (int file = 0; file < int(MostVolumes); ++file)
  {
    if (this->SegmentsPath(file).toStdString() == candidate)
    {
      return true;
    }
  }
  return false;
}

void Autosave::Remove()
{
  this->delay.stop();
  this->segmentWriting.Cancel();
  QFile::remove(this->path);
  for (int file = 0; file < int(MostVolumes); ++file)
  {
    this->RemoveSegments(file);
  }
}

void Autosave::RemoveSegments(int file)
{
  QFile::remove(this->SegmentsPath(file));
  this->saved[file] = {};
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

// The file that has the labels of a volume already, or one that the last copy does not name.
int Autosave::FileFor(int volume) const
{
  const vtkSmartPointer<vtkImageData> numbers = this->model->StudyOf(volume)->labels->image;
  const auto first = this->saved.begin();
  const auto end = this->saved.end();
  auto file =
    std::find_if(first, end, [&](const SavedLabels& labels) { return labels.numbers == numbers; });
  if (file == end)
  {
    file = std::find_if(first, end, [](const SavedLabels& labels) { return !labels.numbers; });
  }
  if (file == end)
  {
    file = std::find_if(
      first, end, [this](const SavedLabels& labels) { return !this->IsNeeded(labels); });
  }
  return int(file - first);
}

bool Autosave::IsSaved(int volume) const
{
  const SavedLabels& labels = this->saved[this->FileFor(volume)];
  return labels.numbers == this->model->StudyOf(volume)->labels->image &&
    labels.version == this->model->LabelVersion(volume);
}

// True for labels of a volume that is shown, which are in no other file.
bool Autosave::IsNeeded(const SavedLabels& labels) const
{
  for (int volume = 0; volume < VolumeCount(this->model->CurrentScene()); ++volume)
  {
    if (this->model->HasUnsavedLabels(volume) &&
      this->model->StudyOf(volume)->labels->image == labels.numbers)
    {
      return true;
    }
  }
  return false;
}

void Autosave::SaveSegments(int volume)
{
  if (this->segmentWriting.IsRunning())
  {
    this->delay.start();
    return;
  }
  const auto study = this->model->StudyOf(volume);
  const int file = this->FileFor(volume);
  this->segmentWriting.Start(
    [study, segments = SceneLabelsOf(this->model->CurrentScene(), volume)->segments,
      written = this->SegmentsPath(file).toStdString()](const TaskProgress& progress)
    {
      LabelMap labels;
      labels.image = CopyOfLabels(*study);
      WriteSegments(labels, segments, {}, written);
      // The copy may have been removed meanwhile, because the program ends.
      if (!progress(1.0))
      {
        QFile::remove(QString::fromStdString(written));
      }
    },
    [this, volume, file, version = study->labelVersion, numbers = study->labels->image]
    {
      this->saved[file] = { numbers, version };
      this->SaveFrom(volume + 1);
    });
}

// A scene names the file of its segments that is nearest to what is shown.
void Autosave::NameSegments(Scene& scene, int volume) const
{
  auto& labels = SceneLabelsOf(scene, volume);
  if (!labels)
  {
    return;
  }
  const int file = this->FileFor(volume);
  if (this->model->HasUnsavedLabels(volume) &&
    this->saved[file].numbers == this->model->StudyOf(volume)->labels->image)
  {
    labels->path = this->SegmentsPath(file).toStdString();
    labels->series.clear();
  }
  else if (labels->path.empty())
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
  for (int file = 0; file < int(MostVolumes) && !this->segmentWriting.IsRunning(); ++file)
  {
    if (!this->IsNeeded(this->saved[file]))
    {
      this->RemoveSegments(file);
    }
  }
}

QString SavedWork::CurrentWork() const
{
  const auto study = this->model->CurrentStudy();
  if (!study)
  {
    return {};
  }
  const bool hasUnsaved = this->model->VolumeWithUnsavedLabels().has_value();
  return WorkText(this->model->CurrentScene(), *study) +
    (hasUnsaved ? QStringLiteral("voxels") : QString());
}

void SavedWork::ForgetAutosavedFiles(Scene& scene) const
{
  for (int volume = 0; volume < VolumeCount(scene); ++volume)
  {
    auto& labels = SceneLabelsOf(scene, volume);
    if (labels && this->autosave->IsSegmentsPath(labels->path))
    {
      labels->path.clear();
    }
  }
}

}
