// The part of SceneModel that edits the voxels of segments.

#include "Viewer/Model/SceneModel.h"

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

}

// Studies of all states share the voxels of the labels. This is safe, because the history is a
// line: a state comes back only after all later changes of the voxels have been taken back.
class SceneModel::LabelStep : public QUndoCommand
{
public:
  LabelStep(SceneModel* model, LabelChange change, const QString& name)
    : QUndoCommand(name)
    , model(model)
    , change(std::move(change))
    , before(model->state.labelVersion)
    , after(++model->lastLabelVersion)
  {
  }

  void undo() override { this->Apply(false); }
  void redo() override { this->Apply(true); }

private:
  void Apply(bool isForward)
  {
    varimarch::Apply(this->change, isForward, this->model->state.study->labels->image);
    this->model->state.labelVersion = isForward ? this->after : this->before;
    this->model->RenewLabels(*this->model->state.study->labels);
  }

  SceneModel* model;
  LabelChange change;
  int before; ///< versions of the labels
  int after;
};

void SceneModel::ChangeLabels(const LabelChange& change, const QString& name)
{
  this->history.push(new LabelStep(this, change, name));
}

// The sizes and statistics of the segments are counted anew.
void SceneModel::RenewLabels(LabelMap map)
{
  map.sizes = SizesOf(map.image, map.segments.size());
  this->state.study = WithLabels(*this->state.study, std::move(map));
  emit this->Changed(ScenePart::Labels);
}

void SceneModel::AddSegment(const QString& segmentName, const QString& name)
{
  LabelMap map = this->state.study->labels ? *this->state.study->labels
                                           : EmptyLabels(this->state.study->volume.image);
  int value = 1;
  for (const Segment& segment : map.segments)
  {
    value = std::max(value, segment.value + 1);
  }
  // They can have other values in the file that they were saved to.
  if (this->state.scene.labels)
  {
    for (const Segment& segment : this->state.scene.labels->segments)
    {
      value = std::max(value, segment.value + 1);
    }
  }
  const Segment added = { value, segmentName.toStdString(), ColorOfLabel(value) };
  map.segments.push_back(added);
  map.sizes.emplace_back();
  State changed = this->WithStudy(WithLabels(*this->state.study, std::move(map)));
  changed.labelVersion = ++this->lastLabelVersion;
  if (!changed.scene.labels)
  {
    changed.scene.labels = SceneLabels();
  }
  changed.scene.labels->segments.push_back(added);
  this->PushLabels(std::move(changed), name);
}

void SceneModel::TakeSavedLabels(
  const std::string& path, const std::vector<Segment>& segments, const QString& name)
{
  this->Edit(ScenePart::Segments, name,
    [&](Scene& scene) {
      scene.labels = { path, {}, segments };
    });
  this->versionsInFiles[path] = this->state.labelVersion;
}

bool SceneModel::HasUnsavedLabels() const
{
  const auto& labels = this->state.scene.labels;
  if (!labels)
  {
    return false;
  }
  const auto inFile = this->versionsInFiles.find(labels->path);
  return inFile == this->versionsInFiles.end() || inFile->second != this->state.labelVersion;
}

// The labels have just been read from the file that the scene names. Without a name they were in no
// file of the user's.
void SceneModel::TakeVersionOfFile(State& taken)
{
  if (!taken.scene.labels)
  {
    return;
  }
  const std::string& path = taken.scene.labels->path;
  taken.labelVersion = ++this->lastLabelVersion;
  if (!path.empty())
  {
    taken.labelVersion = this->versionsInFiles.try_emplace(path, taken.labelVersion).first->second;
  }
}

}
