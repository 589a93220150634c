#include "Viewer/Model/SegmentEditor.h"

#include "Scene/Placing.h"
#include "Scene/SceneVolumes.h"

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
      if (IsOtherLookVolume(part) || part == ScenePart::Labels)
      {
        this->TakeBackStroke();
      }
    });
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

void SegmentEditor::Change(const LabelChange& change, const QString& name)
{
  this->Release();
  if (change.IsEmpty())
  {
    emit this->Unchanged();
  }
  else
  {
    this->model->ChangeLabels(change, name);
  }
}

void SegmentEditor::AddRegion(const std::array<double, 3>& pointMm)
{
  this->Change(ConnectedRegion(this->Numbers(), this->Number(),
                 this->Placed(this->model->EditedStudy()->volume.image), pointMm, this->range),
    tr("add a region"));
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
  this->isStroking = true;
  this->stroke = {};
  this->stroked = this->Numbers();
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
  Apply(change, true, this->stroked);
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
    this->model->ChangeLabels(
      this->stroke, this->tool == SegmentTool::Erase ? tr("erase") : tr("paint"));
  }
  emit this->StrokingChanged(false);
}

// The voxels of a stroke that no undo step holds would stay for ever.
void SegmentEditor::TakeBackStroke()
{
  if (std::exchange(this->isStroking, false))
  {
    Apply(this->stroke, false, this->stroked);
    emit this->StrokingChanged(false);
  }
}

void SegmentEditor::KeepLargestIsland()
{
  if (this->HasSegment())
  {
    this->Change(LargestIsland(this->Numbers(), this->Number()), tr("keep the largest part"));
  }
}

void SegmentEditor::RemoveSmallIslands(double leastMl)
{
  if (this->HasSegment())
  {
    this->Change(
      WithoutSmallIslands(this->Numbers(), this->Number(), leastMl), tr("remove small parts"));
  }
}

void SegmentEditor::Smooth(double deviationMm)
{
  if (this->HasSegment())
  {
    this->Change(Smoothed(this->Numbers(), this->Number(), deviationMm), tr("smooth a segment"));
  }
}

}
