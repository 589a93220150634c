#include "Viewer/Model/PresetTitles.h"

#include <QCoreApplication>

#include <map>

namespace varimarch
{

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
