#include "Viewer/Model/SceneModel.h"

#include "Scene/PresetSuggestion.h"
#include "Scene/Presets.h"
#include "Scene/SceneCuts.h"
#include "Scene/SceneFile.h"
#include "Scene/SceneVolumes.h"
#include "Scene/SingleImage.h"
#include "Scene/VolumeProperty.h"

#include <QUndoCommand>

#include <algorithm>
#include <array>
#include <utility>

namespace varimarch
{

namespace
{

std::vector<std::vector<std::array<double, 3>>> TakePoints(std::vector<Measure>& measures)
{
  std::vector<std::vector<std::array<double, 3>>> points;
  for (Measure& measure : measures)
  {
    points.push_back(std::exchange(measure.pointsMm, {}));
  }
  return points;
}

// Outlines have so many points that their text would take longer than a move of the mouse.
bool AreSame(Scene a, Scene b)
{
  return TakePoints(a.measures) == TakePoints(b.measures) && SceneText(a) == SceneText(b);
}

// The labels that a volume has in its own file; empty if it has none.
std::optional<SceneLabels> LabelsOfFile(const VolumeSource& source, const Study& opened)
{
  const auto* const file = std::get_if<FileSource>(&source);
  return opened.labels && file ? std::optional(SceneLabels{ file->path, file->series })
                               : std::nullopt;
}

}

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
    // A step that keeps the study must not keep the voxels of the time that is shown.
    if (this->before.study == this->after.study)
    {
      this->before.study.reset();
      this->after.study.reset();
    }
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
    this->setObsolete(AreSame(this->before.scene, this->after.scene));
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

const MeasureTexts& SceneModel::Texts()
{
  this->texts = MeasureTexts(this->state.scene, *this->state.study, this->texts);
  return this->texts;
}

void SceneModel::Open(const VolumeSource& source, std::shared_ptr<const Study> opened)
{
  Scene first;
  first.volume = source;
  first.render = this->state.scene.render;
  TakePreset(BuiltInPreset(SuggestedPreset(opened->volume, opened->statistics).name), first);
  first.slices.turn = FirstTurnOf(opened->volume.image);
  first.labels = LabelsOfFile(source, *opened);
  if (first.labels)
  {
    first.look = LookOfLabelsOnly();
  }
  this->Restore(first, std::move(opened));
}

void SceneModel::Complete(std::shared_ptr<const Study> whole)
{
  const Study& copy = *this->state.study;
  Scene kept = this->state.scene;
  kept.cuts.box = BoxInOther(kept.cuts.box, copy.volume.image, whole->volume.image);
  kept.labels = LabelsOfFile(kept.volume, *whole);
  // The values of a copy have other percentiles.
  if (IsBuiltInLook(kept.look, copy.statistics))
  {
    kept.look = BuiltInPreset(kept.look.name).look;
  }
  this->Restore(kept, std::move(whole));
}

void SceneModel::Restore(const Scene& saved, std::shared_ptr<const Study> opened)
{
  this->history.clear();
  this->exchanged.reset();
  State restored = { std::move(opened), saved };
  restored.scene.look = InUnitsOfData(saved.look, restored.study->statistics);
  TakeTime(restored, 0);
  TakeOverlays(restored);
  this->edited = 0;
  this->versionsInFiles.clear();
  for (int volume = 0; volume < VolumeCount(restored.scene); ++volume)
  {
    TakeSegments(restored, volume);
    this->TakeVersionOfFile(restored, volume);
  }
  this->Replace({ ScenePart::Volume }, restored);
}

void SceneModel::Exchange(
  const VolumeSource& source, const std::shared_ptr<const Study>& form, const QString& name)
{
  this->exchanged = this->state.study;
  // Labels may have been closed since the form was read.
  const bool isBare = form->labels && !this->state.scene.labels;
  State changed =
    this->WithStudy(WithOverlaysOf(*this->state.study, isBare ? WithoutLabels(*form) : form));
  changed.scene.volume = source;
  TakeSegments(changed, 0);
  this->TakeVersionOfFile(changed, 0);
  changed.scene.cuts.box =
    BoxInOther(changed.scene.cuts.box, this->exchanged->volume.image, changed.study->volume.image);
  this->history.push(
    new EditStep(this, { ScenePart::Volume }, name, std::move(changed), NoGesture));
}

void SceneModel::PushLabels(State changed, const QString& name)
{
  this->history.push(
    new EditStep(this, { ScenePart::Labels }, name, std::move(changed), NoGesture));
}

void SceneModel::AddOverlay(
  const OverlaidVolume& overlay, std::shared_ptr<const Study> added, const QString& name)
{
  Study study = *this->state.study;
  study.overlays.push_back(std::move(added));
  State changed = this->WithStudy(std::make_shared<const Study>(std::move(study)));
  changed.scene.overlays.push_back(overlay);
  const int last = int(changed.scene.overlays.size());
  this->PushOverlays(std::move(changed), name, last);
}

void SceneModel::RemoveOverlay(int overlay, const QString& name)
{
  Study study = *this->state.study;
  study.overlays.erase(study.overlays.begin() + overlay);
  State changed = this->WithStudy(std::make_shared<const Study>(std::move(study)));
  changed.scene.overlays.erase(changed.scene.overlays.begin() + overlay);
  this->PushOverlays(std::move(changed), name, std::min(this->edited, overlay));
}

void SceneModel::MoveOverlay(int from, int to, const QString& name)
{
  Study study = *this->state.study;
  std::swap(study.overlays[from], study.overlays[to]);
  State changed = this->WithStudy(std::make_shared<const Study>(std::move(study)));
  std::swap(changed.scene.overlays[from], changed.scene.overlays[to]);
  this->PushOverlays(std::move(changed), name, to + 1);
}

SceneModel::State SceneModel::WithStudy(std::shared_ptr<const Study> study) const
{
  return { std::move(study), this->state.scene };
}

void SceneModel::PushOverlays(State changed, const QString& name, int newEdited)
{
  this->history.push(
    new EditStep(this, { ScenePart::Overlays }, name, std::move(changed), NoGesture));
  this->SetEditedVolume(newEdited);
}

void SceneModel::SetEditedVolume(int volume)
{
  if (this->edited != volume)
  {
    this->edited = volume;
    emit this->Changed(ScenePart::EditedVolume);
  }
}

std::shared_ptr<const Study> SceneModel::StudyOf(int volume) const
{
  return volume == 0 ? this->state.study : this->state.study->overlays[volume - 1];
}

std::shared_ptr<const Study> SceneModel::EditedStudy() const
{
  return this->StudyOf(this->edited);
}

const std::optional<SceneLabels>& SceneModel::EditedLabels() const
{
  return SceneLabelsOf(this->state.scene, this->edited);
}

std::optional<int> SceneModel::VolumeOf(const Study& study) const
{
  for (int volume = 0; volume < VolumeCount(this->state.scene); ++volume)
  {
    if (this->StudyOf(volume)->labelGuard == study.labelGuard)
    {
      return volume;
    }
  }
  return {};
}

const Look& SceneModel::EditedLook() const
{
  return this->edited == 0 ? this->state.scene.look
                           : this->state.scene.overlays[this->edited - 1].look;
}

Scene SceneModel::EditedScene() const
{
  Scene scene = this->state.scene;
  scene.look = this->EditedLook();
  return scene;
}

void SceneModel::Edit(
  ScenePart part, const QString& name, const std::function<void(Scene&)>& change, int gesture)
{
  this->EditParts({ part }, name, change, gesture);
}

void SceneModel::EditParts(const std::vector<ScenePart>& parts, const QString& name,
  const std::function<void(Scene&)>& change, int gesture)
{
  State changed = this->state;
  change(changed.scene);
  this->history.push(new EditStep(this, parts, name, std::move(changed), gesture));
}

void SceneModel::SetLook(const Look& look, const QString& name, int gesture)
{
  const Look inUnitsOfData = InUnitsOfData(look, this->EditedStudy()->statistics);
  this->Edit(
    ScenePart::Look, name,
    [&](Scene& scene)
    { (this->edited == 0 ? scene.look : scene.overlays[this->edited - 1].look) = inUnitsOfData; },
    gesture);
}

void SceneModel::SetPreset(const Preset& preset, const QString& name)
{
  if (this->edited > 0)
  {
    this->SetLook(preset.look, name);
    return;
  }
  this->EditParts({ ScenePart::Look, ScenePart::Render, ScenePart::Background }, name,
    [&](Scene& scene)
    {
      TakePreset(preset, scene);
      scene.look = InUnitsOfData(preset.look, this->state.study->statistics);
    });
}

// A scene can name its time by seconds; from now on it has a number.
void SceneModel::TakeTime(State& taken, int volume)
{
  Scene& scene = taken.scene;
  VolumeSource& source = volume == 0 ? scene.volume : scene.overlays[volume - 1].source;
  if (auto* const file = std::get_if<FileSource>(&source))
  {
    file->timeSeconds.reset();
    file->time = StudyOfVolume(*taken.study, volume).volume.times.current;
  }
}

int SceneModel::ChosenTime() const
{
  const auto* const file = std::get_if<FileSource>(&this->state.scene.volume);
  return file ? file->time : 0;
}

void SceneModel::ChooseTime(int time, const QString& name, int gesture)
{
  this->Edit(
    ScenePart::Time, name, [time](Scene& scene) { std::get<FileSource>(scene.volume).time = time; },
    gesture);
}

void SceneModel::ShowTime(const LoadedVolume& ofTime, int volume)
{
  const Study& study = *this->state.study;
  const bool isOther = volume == 0 && this->ChosenTime() != ofTime.times.current;
  this->state.study = WithVolume(study, volume, AtTime(StudyOfVolume(study, volume), ofTime));
  TakeTime(this->state, volume);
  emit this->Changed(volume == 0 ? ScenePart::Voxels : ScenePart::Overlays);
  if (isOther)
  {
    emit this->Changed(ScenePart::Time);
  }
  this->CountInThread();
}

void SceneModel::TakeCounts(std::shared_ptr<const ImageStatistics> allTimes)
{
  Study counted = *this->state.study;
  counted.allTimes = std::move(allTimes);
  this->state.study = std::make_shared<const Study>(std::move(counted));
  emit this->Changed(ScenePart::Voxels);
}

// Overlays that could not be read are left out.
void SceneModel::TakeOverlays(State& taken)
{
  if (taken.scene.overlays.empty() && taken.study->overlays.empty())
  {
    return;
  }
  Study study = *taken.study;
  study.overlays.resize(taken.scene.overlays.size());
  for (int i = int(study.overlays.size()) - 1; i >= 0; --i)
  {
    OverlaidVolume& overlay = taken.scene.overlays[i];
    if (study.overlays[i])
    {
      overlay.look = InUnitsOfData(overlay.look, study.overlays[i]->statistics);
    }
    else
    {
      study.overlays.erase(study.overlays.begin() + i);
      taken.scene.overlays.erase(taken.scene.overlays.begin() + i);
    }
  }
  taken.study = std::make_shared<const Study>(std::move(study));
}

// A step that changes the list of volumes can put another one at the place of the edited one.
void SceneModel::Replace(const std::vector<ScenePart>& parts, const State& newState)
{
  const auto before = this->state.study ? this->EditedStudy() : nullptr;
  const auto study = newState.study ? newState.study : this->state.study;
  this->state = newState;
  this->state.study = study;
  this->edited = std::min(this->edited, int(newState.scene.overlays.size()));
  const bool editsOther = before && parts.front() != ScenePart::Volume &&
    this->EditedStudy()->volume.image != before->volume.image;
  for (const ScenePart part : parts)
  {
    emit this->Changed(part);
  }
  if (editsOther)
  {
    emit this->Changed(ScenePart::EditedVolume);
  }
  this->CountInThread();
}

}
