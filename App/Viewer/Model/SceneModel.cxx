#include "Viewer/Model/SceneModel.h"

#include "Scene/Json/SceneFile.h"
#include "Scene/Looks/Presets.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Model/Scene.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Slices/SlicePicture.h"

#include <QUndoCommand>

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

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

// The part of SceneModel that shows segmentations, edits their voxels and counts them.

namespace
{

LabelMap EmptyLabels(vtkImageData* scan)
{
  LabelMap map;
  map.image = vtkSmartPointer<vtkImageData>::New();
  map.image->CopyStructure(scan);
  map.image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  map.image->GetPointData()->GetScalars()->Fill(0.0);
  return map;
}

std::shared_ptr<const Study> WithVersion(Study study, int version)
{
  study.labelVersion = version;
  return std::make_shared<const Study>(std::move(study));
}

// A value larger than those of all segments.
int FreeValue(const std::vector<Segment>& segments)
{
  int value = 1;
  for (const Segment& segment : segments)
  {
    value = std::max(value, segment.value + 1);
  }
  return value;
}

}

// Studies of all states share the voxels of the labels. This is safe, because the history is a
// line: a state comes back only after all later changes of the voxels have been taken back.
class SceneModel::LabelStep : public QUndoCommand
{
public:
  LabelStep(SceneModel* model, LabelChange change, const QString& name, int volume)
    : QUndoCommand(name)
    , model(model)
    , change(std::move(change))
    , volume(volume)
    , before(model->LabelVersion(volume))
    , after(++model->lastLabelVersion)
  {
  }

  void undo() override { this->Apply(false); }
  void redo() override { this->Apply(true); }

private:
  void Apply(bool isForward)
  {
    const Study& study = *this->model->StudyOf(this->volume);
    WriteLabels(this->change, isForward, study.labels->image, *study.labelGuard);
    this->model->RenewLabels(this->volume, isForward ? this->after : this->before);
  }

  SceneModel* model;
  LabelChange change;
  int volume;
  int before; ///< versions of the labels
  int after;
};

// Overlays may have changed while the labels were read.
void SceneModel::ShowLabels(const SceneLabels& labels, const std::shared_ptr<const Study>& labelled,
  const QString& name, int volume)
{
  State changed = this->WithStudy(WithVolume(*this->state.study, volume, labelled));
  SceneLabelsOf(changed.scene, volume) = labels;
  TakeSegments(changed, volume);
  this->TakeVersionOfFile(changed, volume);
  this->PushLabels(std::move(changed), name);
}

void SceneModel::CloseLabels(const QString& name)
{
  State changed = this->WithStudy(
    WithVolume(*this->state.study, this->edited, WithoutLabels(*this->EditedStudy())));
  TakeSegments(changed, this->edited);
  this->PushLabels(std::move(changed), name);
}

// The labels of the study have the appearance that the scene gave when they were loaded.
void SceneModel::TakeSegments(State& taken, int volume)
{
  const Study& study = StudyOfVolume(*taken.study, volume);
  std::optional<SceneLabels>& labels = SceneLabelsOf(taken.scene, volume);
  if (!study.labels)
  {
    labels.reset();
  }
  else if (labels)
  {
    labels->segments = study.labels->segments;
  }
}

void SceneModel::ChangeLabels(const LabelChange& change, const QString& name, int volume)
{
  this->history.push(new LabelStep(this, change, name, volume));
}

void SceneModel::RenewLabels(int volume, int version)
{
  Study renewed = *this->StudyOf(volume);
  renewed.labelVersion = version;
  renewed.areSegmentsCounted = false;
  this->state.study =
    WithVolume(*this->state.study, volume, std::make_shared<const Study>(std::move(renewed)));
  emit this->Changed(ScenePart::Labels);
  this->CountInThread();
}

std::optional<int> SceneModel::VolumeToCount() const
{
  for (int volume = 0; this->state.study && volume < VolumeCount(this->state.scene); ++volume)
  {
    if (!this->StudyOf(volume)->areSegmentsCounted)
    {
      return volume;
    }
  }
  return {};
}

bool SceneModel::AreSegmentsCounted() const
{
  return !this->VolumeToCount();
}

void SceneModel::CountSegments()
{
  while (const std::optional<int> volume = this->VolumeToCount())
  {
    const auto study = this->StudyOf(*volume);
    this->TakeCounted(*volume, WithCounts(*study, study->volume.image));
  }
}

// One volume after the other. What changes meanwhile is counted anew.
void SceneModel::CountInThread()
{
  const std::optional<int> volume = this->VolumeToCount();
  if (!volume || this->counting.IsRunning())
  {
    return;
  }
  const auto study = this->StudyOf(*volume);
  this->counting.Start([study, image = SharedCopy(study->volume)](const TaskProgress&)
    { return WithCounts(*study, image); },
    [this, study](const std::shared_ptr<const Study>& counted)
    {
      const std::optional<int> now = this->VolumeOf(*study);
      if (now && this->StudyOf(*now) == study)
      {
        this->TakeCounted(*now, counted);
      }
      this->CountInThread();
    });
}

void SceneModel::TakeCounted(int volume, const std::shared_ptr<const Study>& counted)
{
  this->state.study = WithVolume(*this->state.study, volume, counted);
  emit this->Changed(ScenePart::Labels);
}

void SceneModel::AddSegment(const QString& segmentName, const QString& name)
{
  const Study& study = *this->EditedStudy();
  LabelMap map = study.labels ? *study.labels : EmptyLabels(study.volume.image);
  State changed = this->WithStudy(nullptr);
  std::optional<SceneLabels>& labels = SceneLabelsOf(changed.scene, this->edited);
  if (!labels)
  {
    labels = SceneLabels();
  }
  // Segments can have other values in the file that they were saved to.
  const int value = std::max(FreeValue(map.segments), FreeValue(labels->segments));
  const Segment added = { value, segmentName.toStdString(), ColorOfLabel(value) };
  map.segments.push_back(added);
  map.sizes.emplace_back();
  labels->segments.push_back(added);
  Study labelled = study;
  labelled.labels = std::make_shared<const LabelMap>(std::move(map));
  labelled.segmentStatistics.emplace_back();
  changed.study = WithVolume(
    *this->state.study, this->edited, WithVersion(std::move(labelled), ++this->lastLabelVersion));
  this->PushLabels(std::move(changed), name);
}

void SceneModel::TakeSavedLabels(
  const std::string& path, const std::vector<Segment>& segments, const QString& name, int volume)
{
  this->Edit(ScenePart::Segments, name,
    [&](Scene& scene) {
      SceneLabelsOf(scene, volume) = { path, {}, segments };
    });
  this->versionsInFiles[path] = this->LabelVersion(volume);
}

int SceneModel::LabelVersion(int volume) const
{
  return this->StudyOf(volume)->labelVersion;
}

bool SceneModel::HasUnsavedLabels(int volume) const
{
  const auto& labels = SceneLabelsOf(this->state.scene, volume);
  if (!labels)
  {
    return false;
  }
  const auto inFile = this->versionsInFiles.find(labels->path);
  return inFile == this->versionsInFiles.end() || inFile->second != this->LabelVersion(volume);
}

std::optional<int> SceneModel::VolumeWithUnsavedLabels() const
{
  for (int volume = 0; volume < VolumeCount(this->state.scene); ++volume)
  {
    if (this->HasUnsavedLabels(volume))
    {
      return volume;
    }
  }
  return {};
}

// The labels have just been read from the file that the scene names. Without a name they were in no
// file of the user's.
void SceneModel::TakeVersionOfFile(State& taken, int volume)
{
  const std::optional<SceneLabels>& labels = SceneLabelsOf(taken.scene, volume);
  if (!labels)
  {
    return;
  }
  int version = ++this->lastLabelVersion;
  if (!labels->path.empty())
  {
    version = this->versionsInFiles.try_emplace(labels->path, version).first->second;
  }
  taken.study =
    WithVolume(*taken.study, volume, WithVersion(StudyOfVolume(*taken.study, volume), version));
}

int NewGesture()
{
  static int last = 0;
  return ++last;
}

}
