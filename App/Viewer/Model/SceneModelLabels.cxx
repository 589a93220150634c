// The part of SceneModel that shows segmentations, edits their voxels and counts them.

#include "Viewer/Model/SceneModel.h"

#include "Scene/SceneVolumes.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <QUndoCommand>

#include <algorithm>
#include <utility>

namespace varimarch
{

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

}
