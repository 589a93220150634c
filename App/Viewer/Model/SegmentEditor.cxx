#include "Viewer/Model/SegmentEditor.h"

#include "Scene/Model/Scene.h"
#include "Scene/Volumes/Placing.h"

#include <optional>
#include <utility>

namespace varimarch
{

SegmentEditor::SegmentEditor(SceneModel* model, QObject* parent)
  : QObject(parent)
  , model(model)
{
  connect(model, &SceneModel::Changed, this,
    [this](ScenePart part)
    {
      const bool mayBeOther = IsOtherLookVolume(part) || part == ScenePart::Labels;
      if (mayBeOther && !(this->HasSegment() && this->Numbers() == this->stroked))
      {
        this->TakeBackStroke();
      }
    });
  connect(&this->work, &BackgroundTask::RunningChanged, this, &SegmentEditor::WorkingChanged);
  connect(&this->work, &BackgroundTask::Failed, this, &SegmentEditor::Failed);
}

void SegmentEditor::SetTool(SegmentTool newTool)
{
  this->tool = newTool;
  emit this->ToolChanged();
}

bool SegmentEditor::HasSegment() const
{
  const auto& labels = this->model->EditedLabels();
  return labels && this->segment >= 0 && this->segment < int(labels->segments.size());
}

vtkImageData* SegmentEditor::Numbers() const
{
  return this->model->EditedStudy()->labels->image;
}

// Points are in world space, where the edited volume may have been moved to. The voxels are shared.
vtkSmartPointer<vtkImageData> SegmentEditor::Placed(vtkImageData* image) const
{
  return varimarch::Placed(
    image, PlacementOf(this->model->CurrentScene(), this->model->EditedVolume()));
}

void SegmentEditor::Work(
  const QString& name, std::function<LabelChange(vtkImageData* numbers)> change)
{
  if (!this->HasSegment() || this->IsWorking())
  {
    return;
  }
  this->Release();
  const auto study = this->model->EditedStudy();
  this->work.Start([study, change = std::move(change)](const TaskProgress&)
    { return change(CopyOfLabels(*study)); },
    [this, study, name](const LabelChange& found) { this->Take(*study, found, name); });
}

void SegmentEditor::Take(const Study& before, const LabelChange& change, const QString& name)
{
  const std::optional<int> volume = this->model->VolumeOf(before);
  const auto now = volume ? this->model->StudyOf(*volume) : nullptr;
  const bool areSame = now && now->labels && now->labels->image == before.labels->image &&
    now->labelVersion == before.labelVersion;
  if (!areSame)
  {
    emit this->Failed(tr("The segments were changed meanwhile, so this edit was left out."));
  }
  else if (change.IsEmpty())
  {
    emit this->Unchanged();
  }
  else
  {
    this->model->ChangeLabels(change, name, *volume);
  }
}

void SegmentEditor::AddRegion(const std::array<double, 3>& pointMm)
{
  const auto scan = this->Placed(SharedCopy(this->model->EditedStudy()->volume));
  this->Work(tr("add a region"),
    [scan, pointMm, number = this->Number(), range = this->range](vtkImageData* numbers)
    { return ConnectedRegion(numbers, number, scan, pointMm, range); });
}

void SegmentEditor::Press(
  const std::array<double, 3>& pointMm, const std::array<double, 3>& sliceNormal)
{
  this->Release();
  if (this->tool == SegmentTool::Region)
  {
    this->AddRegion(pointMm);
    return;
  }
  if (this->IsWorking())
  {
    return;
  }
  this->isStroking = true;
  this->stroke = {};
  this->stroked = this->Numbers();
  this->guard = this->model->EditedStudy()->labelGuard;
  this->normal = sliceNormal;
  this->lastMm = pointMm;
  emit this->StrokingChanged(true);
  this->Brush(pointMm);
}

void SegmentEditor::Drag(const std::array<double, 3>& pointMm)
{
  if (this->isStroking)
  {
    this->Brush(pointMm);
  }
}

// The voxels change at once, so that the user sees the stroke; the model hears of it at its end.
void SegmentEditor::Brush(const std::array<double, 3>& toMm)
{
  const BrushStroke line = { this->lastMm, toMm, this->normal, this->radiusMm };
  const auto placed = this->Placed(this->stroked);
  const LabelChange change = this->tool == SegmentTool::Erase
    ? Erased(placed, this->Number(), line)
    : Painted(placed, this->Number(), line);
  WriteLabels(change, true, this->stroked, *this->guard);
  this->stroke = Joined(this->stroke, change, this->stroked);
  this->lastMm = toMm;
  emit this->Stroked();
}

void SegmentEditor::Release()
{
  if (!std::exchange(this->isStroking, false))
  {
    return;
  }
  if (!this->stroke.IsEmpty())
  {
    this->model->ChangeLabels(this->stroke,
      this->tool == SegmentTool::Erase ? tr("erase") : tr("paint"), this->model->EditedVolume());
  }
  emit this->StrokingChanged(false);
}

// The voxels of a stroke that no undo step holds would stay for ever.
void SegmentEditor::TakeBackStroke()
{
  if (std::exchange(this->isStroking, false))
  {
    WriteLabels(this->stroke, false, this->stroked, *this->guard);
    emit this->StrokingChanged(false);
  }
}

void SegmentEditor::KeepLargestIsland()
{
  this->Work(tr("keep the largest part"),
    [number = this->Number()](vtkImageData* numbers) { return LargestIsland(numbers, number); });
}

void SegmentEditor::RemoveSmallIslands(double leastMl)
{
  this->Work(tr("remove small parts"),
    [number = this->Number(), leastMl](vtkImageData* numbers)
    { return WithoutSmallIslands(numbers, number, leastMl); });
}

void SegmentEditor::Smooth(double deviationMm)
{
  this->Work(tr("smooth a segment"),
    [number = this->Number(), deviationMm](vtkImageData* numbers)
    { return Smoothed(numbers, number, deviationMm); });
}

}
