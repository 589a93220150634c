#include "Viewer/Model/OwnPresets.h"

#include "Scene/Files/OutputFile.h"
#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/LookFiles.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

#include <map>
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

QString PresetTitle(const std::string& name)
{
  static const std::map<std::string, const char*> titles = {
    { "ct-airways", QT_TRANSLATE_NOOP("PresetTitles", "CT airways") },
    { "ct-bone", QT_TRANSLATE_NOOP("PresetTitles", "CT bone") },
    { "ct-implants", QT_TRANSLATE_NOOP("PresetTitles", "CT implants") },
    { "ct-lung", QT_TRANSLATE_NOOP("PresetTitles", "CT lungs") },
    { "ct-maximum", QT_TRANSLATE_NOOP("PresetTitles", "CT maximum") },
    { "ct-skin", QT_TRANSLATE_NOOP("PresetTitles", "CT skin") },
    { "ct-soft-tissue", QT_TRANSLATE_NOOP("PresetTitles", "CT soft tissue") },
    { "ct-vessels", QT_TRANSLATE_NOOP("PresetTitles", "CT vessels") },
    { "mr-angiography", QT_TRANSLATE_NOOP("PresetTitles", "MR angiography") },
    { "mr-head", QT_TRANSLATE_NOOP("PresetTitles", "MR head, T1") },
    { "mr-maximum", QT_TRANSLATE_NOOP("PresetTitles", "MR maximum") },
    { "mr-t2", QT_TRANSLATE_NOOP("PresetTitles", "MR head, T2") },
    { "pet-hot", QT_TRANSLATE_NOOP("PresetTitles", "PET hot") },
    { "pet-maximum", QT_TRANSLATE_NOOP("PresetTitles", "PET maximum") },
  };
  const auto found = titles.find(name);
  return found == titles.end() ? QString::fromStdString(name)
                               : QCoreApplication::translate("PresetTitles", found->second);
}

QString SuggestionText(const PresetSuggestion& suggestion)
{
  static const std::map<SuggestionReason, const char*> texts = {
    { SuggestionReason::Modality, QT_TRANSLATE_NOOP("PresetTitles", "the modality is %1") },
    { SuggestionReason::BodyPart, QT_TRANSLATE_NOOP("PresetTitles", "the body part is %1") },
    { SuggestionReason::TissueWindow,
      QT_TRANSLATE_NOOP(
        "PresetTitles", "the body part is %1, but the file's window is for soft tissue") },
    { SuggestionReason::LittleLung,
      QT_TRANSLATE_NOOP("PresetTitles", "the body part is %1, but few values are those of lungs") },
    { SuggestionReason::ContrastAgent,
      QT_TRANSLATE_NOOP("PresetTitles", "the file mentions a contrast agent") },
    { SuggestionReason::Weighting,
      QT_TRANSLATE_NOOP("PresetTitles", "the sequence times in the file suggest %1") },
    { SuggestionReason::Metal,
      QT_TRANSLATE_NOOP("PresetTitles", "it contains metal, denser than any bone") },
    { SuggestionReason::ValuesOfAir,
      QT_TRANSLATE_NOOP("PresetTitles", "its values reach down to air in CT") },
    { SuggestionReason::OtherValues,
      QT_TRANSLATE_NOOP("PresetTitles", "its values do not look like CT") },
  };
  const QString text = QCoreApplication::translate("PresetTitles", texts.at(suggestion.reason));
  return suggestion.said.empty() ? text : text.arg(QString::fromStdString(suggestion.said));
}

}
