#include "Viewer/Model/SceneModel.h"

#include "Scene/PresetSuggestion.h"
#include "Scene/Presets.h"
#include "Scene/SceneCuts.h"
#include "Scene/SceneFile.h"
#include "Scene/VolumeProperty.h"

#include <QUndoCommand>

#include <utility>

namespace varimarch
{

// Scenes are small, so a step stores the whole scene before and after; no edit needs undo code of
// its own.
class SceneModel::EditStep : public QUndoCommand
{
public:
  EditStep(
    SceneModel* model, std::vector<ScenePart> parts, const QString& name, State after, int gesture)
    : QUndoCommand(name)
    , model(model)
    , parts(std::move(parts))
    , before(model->state)
    , after(std::move(after))
    , gesture(gesture)
  {
  }

  void undo() override { this->model->Replace(this->parts, this->before); }
  void redo() override { this->model->Replace(this->parts, this->after); }

  int id() const override { return this->gesture; }

  bool mergeWith(const QUndoCommand* next) override
  {
    const auto* const step = static_cast<const EditStep*>(next);
    if (step->parts != this->parts)
    {
      return false;
    }
    this->after = step->after;
    // Drop the step of a drag that returned to its start.
    this->setObsolete(SceneText(this->before.scene) == SceneText(this->after.scene));
    return true;
  }

private:
  SceneModel* model;
  std::vector<ScenePart> parts;
  State before;
  State after;
  int gesture;
};

SceneModel::SceneModel(QObject* parent)
  : QObject(parent)
{
}

void SceneModel::Open(const VolumeSource& source, std::shared_ptr<const Study> opened)
{
  Scene first;
  first.volume = source;
  first.render = this->state.scene.render;
  TakePreset(BuiltInPreset(SuggestedPreset(opened->volume, opened->statistics).name), first);
  const auto* const file = std::get_if<FileSource>(&source);
  if (opened->labels && file)
  {
    first.labels = { file->path, file->series };
    first.look = LookOfLabelsOnly();
  }
  this->Restore(first, std::move(opened));
}

void SceneModel::Restore(const Scene& saved, std::shared_ptr<const Study> opened)
{
  this->history.clear();
  this->exchanged.reset();
  State restored = { std::move(opened), saved };
  restored.scene.look = InUnitsOfData(saved.look, restored.study->statistics);
  TakeSegments(restored);
  this->Replace({ ScenePart::Volume }, restored);
}

void SceneModel::Exchange(
  const VolumeSource& source, std::shared_ptr<const Study> form, const QString& name)
{
  this->exchanged = this->state.study;
  State changed = { std::move(form), this->state.scene };
  changed.scene.volume = source;
  TakeSegments(changed);
  changed.scene.cuts.box =
    BoxInOther(changed.scene.cuts.box, this->exchanged->volume.image, changed.study->volume.image);
  this->history.push(
    new EditStep(this, { ScenePart::Volume }, name, std::move(changed), NoGesture));
}

void SceneModel::ShowLabels(
  const SceneLabels& labels, std::shared_ptr<const Study> labelled, const QString& name)
{
  State changed = { std::move(labelled), this->state.scene };
  changed.scene.labels = labels;
  TakeSegments(changed);
  this->history.push(
    new EditStep(this, { ScenePart::Labels }, name, std::move(changed), NoGesture));
}

void SceneModel::CloseLabels(const QString& name)
{
  State changed = { WithoutLabels(*this->state.study), this->state.scene };
  TakeSegments(changed);
  this->history.push(
    new EditStep(this, { ScenePart::Labels }, name, std::move(changed), NoGesture));
}

void SceneModel::Edit(
  ScenePart part, const QString& name, const std::function<void(Scene&)>& change, int gesture)
{
  State changed = this->state;
  change(changed.scene);
  this->history.push(new EditStep(this, { part }, name, std::move(changed), gesture));
}

void SceneModel::SetLook(const Look& look, const QString& name, int gesture)
{
  const Look inUnitsOfData = InUnitsOfData(look, this->state.study->statistics);
  this->Edit(
    ScenePart::Look, name, [&](Scene& edited) { edited.look = inUnitsOfData; }, gesture);
}

void SceneModel::SetPreset(const Preset& preset, const QString& name)
{
  State changed = this->state;
  TakePreset(preset, changed.scene);
  changed.scene.look = InUnitsOfData(preset.look, changed.study->statistics);
  this->history.push(
    new EditStep(this, { ScenePart::Look, ScenePart::Render, ScenePart::Background }, name,
      std::move(changed), NoGesture));
}

// The labels of the study have the appearance that the scene gave when they were loaded.
void SceneModel::TakeSegments(State& taken)
{
  if (!taken.study->labels)
  {
    taken.scene.labels.reset();
  }
  else if (taken.scene.labels)
  {
    taken.scene.labels->segments = taken.study->labels->segments;
  }
}

void SceneModel::Replace(const std::vector<ScenePart>& parts, const State& newState)
{
  this->state = newState;
  for (const ScenePart part : parts)
  {
    emit this->Changed(part);
  }
}

}
