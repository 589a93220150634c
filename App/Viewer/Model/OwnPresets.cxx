#include "Viewer/Model/OwnPresets.h"

#include "Scene/LookFiles.h"
#include "Scene/OutputFile.h"
#include "Scene/SceneFile.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

#include <stdexcept>

namespace varimarch
{

namespace
{

const QString Ending = QStringLiteral(".json");

[[noreturn]] void Fail(const QString& sentence)
{
  throw std::runtime_error(sentence.toStdString());
}

}

OwnPresets::OwnPresets(const QString& folder)
  : folder(folder)
{
}

QString OwnPresets::PathOf(const QString& name) const
{
  return this->folder + '/' + name + Ending;
}

QStringList OwnPresets::Names() const
{
  QStringList names;
  for (const QFileInfo& file :
    QDir(this->folder).entryInfoList({ '*' + Ending }, QDir::Files, QDir::Name | QDir::IgnoreCase))
  {
    names.append(file.completeBaseName());
  }
  return names;
}

Preset OwnPresets::Read(const QString& name) const
{
  Preset preset = ReadLook(this->PathOf(name).toStdString(), "", LookContext());
  preset.look.name = name.toStdString();
  return preset;
}

QString OwnPresets::Keep(const Preset& preset)
{
  const QString base = QCoreApplication::translate("OwnPresets", "My look %1");
  QDir().mkpath(this->folder);
  int number = 1;
  while (QFile::exists(this->PathOf(base.arg(number))))
  {
    ++number;
  }
  Preset kept = preset;
  kept.look.name = base.arg(number).toStdString();
  WriteFileWhole(this->PathOf(base.arg(number)).toStdString(), PresetText(kept));
  return base.arg(number);
}

void OwnPresets::Rename(const QString& name, const QString& newName)
{
  if (newName.isEmpty() || newName.startsWith('.') || newName.contains('/'))
  {
    Fail(QCoreApplication::translate(
      "OwnPresets", "A preset name must not begin with a dot or contain a slash."));
  }
  if (QFile::exists(this->PathOf(newName)))
  {
    Fail(
      QCoreApplication::translate("OwnPresets", "A preset named %1 already exists.").arg(newName));
  }
  if (!QFile::rename(this->PathOf(name), this->PathOf(newName)))
  {
    Fail(QCoreApplication::translate("OwnPresets", "Cannot rename the preset %1 to %2.")
           .arg(name, newName));
  }
}

void OwnPresets::Remove(const QString& name)
{
  if (!QFile::remove(this->PathOf(name)))
  {
    Fail(QCoreApplication::translate("OwnPresets", "Cannot remove the preset %1.").arg(name));
  }
}

}
