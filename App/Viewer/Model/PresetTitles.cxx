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
  };
  const auto found = titles.find(name);
  return found == titles.end() ? QString::fromStdString(name)
                               : QCoreApplication::translate("PresetTitles", found->second);
}

}
