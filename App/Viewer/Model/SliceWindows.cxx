#include "Viewer/Model/SliceWindows.h"

#include "Scene/Looks/Presets.h"
#include "Scene/Slices/SlicePicture.h"

#include <QCoreApplication>

namespace varimarch
{

namespace
{

// Here lupdate finds the names for the translators.
[[maybe_unused]] constexpr const char* Names[] = {
  QT_TRANSLATE_NOOP("SliceWindows", "Abdomen"),
  QT_TRANSLATE_NOOP("SliceWindows", "Lungs"),
  QT_TRANSLATE_NOOP("SliceWindows", "Mediastinum"),
  QT_TRANSLATE_NOOP("SliceWindows", "Bone"),
  QT_TRANSLATE_NOOP("SliceWindows", "Brain"),
  QT_TRANSLATE_NOOP("SliceWindows", "Subdural"),
  QT_TRANSLATE_NOOP("SliceWindows", "Stroke"),
  QT_TRANSLATE_NOOP("SliceWindows", "Liver"),
  QT_TRANSLATE_NOOP("SliceWindows", "Vessels"),
};

std::vector<WindowPreset> PresetsOf(const SceneModel& model)
{
  const auto study = model.CurrentStudy();
  return study ? WindowPresetsOf(study->volume.modality) : std::vector<WindowPreset>();
}

void SetWindow(SceneModel* model, const std::optional<std::array<double, 2>>& windowLevel)
{
  model->Edit(ScenePart::Slices, QCoreApplication::translate("SliceView", "window and level"),
    [&](Scene& scene) { scene.slices.windowLevel = windowLevel; });
}

}

bool HasWindowOfFile(const SceneModel& model)
{
  const auto study = model.CurrentStudy();
  return study && study->volume.windowLevel;
}

void ChooseAutomaticWindow(SceneModel* model)
{
  if (const auto study = model->CurrentStudy())
  {
    SetWindow(model, AutomaticWindow(study->volume, study->statistics));
  }
}

QStringList WindowTitles(const SceneModel& model)
{
  QStringList titles;
  for (const WindowPreset& preset : PresetsOf(model))
  {
    titles << QCoreApplication::translate("SliceWindows", preset.name.c_str());
  }
  return titles;
}

void ChooseWindow(SceneModel* model, int number)
{
  const std::vector<WindowPreset> presets = PresetsOf(*model);
  if (!model->CurrentStudy() || number < 0 || number > int(presets.size()))
  {
    return;
  }
  std::optional<std::array<double, 2>> windowLevel;
  if (number > 0)
  {
    const WindowPreset& preset = presets[std::size_t(number - 1)];
    windowLevel = { preset.window, preset.level };
  }
  SetWindow(model, windowLevel);
}

}
