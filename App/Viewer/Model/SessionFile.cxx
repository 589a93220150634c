#include "Viewer/Model/SessionFile.h"

#include "Scene/OutputFile.h"
#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "Scene/SegmentFiles.h"

#include <vtkImageData.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <exception>
#include <new>

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
        // The segments on the disk are of another scan.
        ++this->volume;
        this->savedLabels = 0;
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

QString Autosave::SegmentsPath() const
{
  return this->path.isEmpty() ? QString() : this->path.chopped(int(qstrlen(".json"))) + ".seg.nrrd";
}

void Autosave::Remove()
{
  this->delay.stop();
  this->segmentWriting.Cancel();
  this->savedLabels = 0;
  QFile::remove(this->path);
  QFile::remove(this->SegmentsPath());
}

void Autosave::Save()
{
  if (this->path.isEmpty())
  {
    return;
  }
  if (this->model->HasUnsavedLabels() && this->model->LabelVersion() != this->savedLabels)
  {
    this->SaveSegments();
  }
  else
  {
    this->SaveScene();
  }
}

// Voxels are edited where they are, so the thread has a copy of them.
void Autosave::SaveSegments()
{
  if (this->segmentWriting.IsRunning())
  {
    this->delay.start();
    return;
  }
  LabelMap labels;
  labels.image = vtkSmartPointer<vtkImageData>::New();
  try
  {
    labels.image->DeepCopy(this->model->CurrentStudy()->labels->image);
  }
  catch (const std::bad_alloc&)
  {
    this->SaveScene(); // the rest
    return;
  }
  this->segmentWriting.Start(
    [labels, segments = this->model->CurrentScene().labels->segments,
      file = this->SegmentsPath().toStdString()](const TaskProgress& progress)
    {
      WriteSegments(labels, segments, {}, file);
      // The copy may have been removed meanwhile, because the program ends.
      if (!progress(1.0))
      {
        QFile::remove(QString::fromStdString(file));
      }
    },
    [this, version = this->model->LabelVersion(), ofVolume = this->volume]
    {
      this->savedLabels = ofVolume == this->volume ? version : 0;
      this->SaveScene();
    });
}

// The scene names the file of its segments that is nearest to what is shown.
void Autosave::SaveScene()
{
  Scene scene = this->model->CurrentScene();
  const bool needsSegments = this->model->HasUnsavedLabels() && this->savedLabels > 0;
  if (needsSegments)
  {
    scene.labels->path = this->SegmentsPath().toStdString();
    scene.labels->series.clear();
  }
  else if (scene.labels && scene.labels->path.empty())
  {
    scene.labels.reset(); // they are in no file
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
  if (!this->model->HasUnsavedLabels() && !this->segmentWriting.IsRunning())
  {
    QFile::remove(this->SegmentsPath());
    this->savedLabels = 0;
  }
}

}
