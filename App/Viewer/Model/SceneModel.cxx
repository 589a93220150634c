#include "Viewer/Model/SceneModel.h"

#include "Scene/Presets.h"
#include "Scene/SceneFile.h"
#include "Scene/VolumeProperty.h"

#include <QUndoCommand>

#include <utility>

namespace varimarch
{

// Scenes are small, so that a step keeps both whole: what is to be undone needs no code of its own.
class SceneModel::EditStep : public QUndoCommand
{
public:
  EditStep(SceneModel* model, ScenePart part, const QString& name, Scene after, int gesture)
    : QUndoCommand(name)
    , model(model)
    , part(part)
    , before(model->scene)
    , after(std::move(after))
    , gesture(gesture)
  {
  }

  void undo() override { this->model->Replace(this->part, this->before); }
  void redo() override { this->model->Replace(this->part, this->after); }

  int id() const override { return this->gesture; }

  bool mergeWith(const QUndoCommand* next) override
  {
    const auto* const step = static_cast<const EditStep*>(next);
    if (step->part != this->part)
    {
      return false;
    }
    this->after = step->after;
    // A drag that was taken back is nothing that anybody wants to undo.
    this->setObsolete(SceneText(this->before) == SceneText(this->after));
    return true;
  }

private:
  SceneModel* model;
  ScenePart part;
  Scene before;
  Scene after;
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
  first.look = Preset(SuggestedPreset(opened->volume).name);
  first.render = this->scene.render;
  first.background = this->scene.background;
  this->Restore(first, std::move(opened));
}

void SceneModel::Restore(const Scene& saved, std::shared_ptr<const Study> opened)
{
  this->history.clear();
  this->study = std::move(opened);
  Scene restored = saved;
  restored.look = InUnitsOfData(saved.look, this->study->statistics);
  this->Replace(ScenePart::Volume, restored);
}

void SceneModel::Edit(
  ScenePart part, const QString& name, const std::function<void(Scene&)>& change, int gesture)
{
  Scene changed = this->scene;
  change(changed);
  this->history.push(new EditStep(this, part, name, std::move(changed), gesture));
}

void SceneModel::SetLook(const Look& look, const QString& name, int gesture)
{
  const Look inUnitsOfData = InUnitsOfData(look, this->study->statistics);
  this->Edit(
    ScenePart::Look, name, [&](Scene& edited) { edited.look = inUnitsOfData; }, gesture);
}

void SceneModel::Replace(ScenePart part, const Scene& newScene)
{
  this->scene = newScene;
  emit this->Changed(part);
}

}
