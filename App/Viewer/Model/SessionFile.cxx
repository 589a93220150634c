#include "Viewer/Model/SessionFile.h"

#include "Scene/OutputFile.h"
#include "Scene/Presets.h"
#include "Scene/SceneFile.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <exception>

namespace varimarch
{

namespace
{

constexpr int DelayMilliseconds = 2000;

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
  work.distances = scene.distances;
  work.angles = scene.angles;
  work.boxes = scene.boxes;
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

Autosave::Autosave(SceneModel* model, const QString& path, QObject* parent)
  : QObject(parent)
  , model(model)
  , path(path)
{
  QDir().mkpath(QFileInfo(path).path());
  this->delay.setSingleShot(true);
  this->delay.setInterval(DelayMilliseconds);
  connect(&this->delay, &QTimer::timeout, this, &Autosave::Save);
  connect(model, &SceneModel::Changed, this,
    [this]
    {
      if (!this->delay.isActive())
      {
        this->delay.start();
      }
    });
}

bool Autosave::HasCopy() const
{
  return QFile::exists(this->path);
}

void Autosave::Remove()
{
  this->delay.stop();
  QFile::remove(this->path);
}

void Autosave::Save()
{
  try
  {
    WriteScene(this->model->CurrentScene(), this->path);
  }
  catch (const std::exception&)
  {
    // A failed backup is not worth an error message at every edit.
  }
}

}
