#ifndef Varimarch_Viewer_SegmentEditor_h
#define Varimarch_Viewer_SegmentEditor_h

#include "Scene/Segments/SegmentEditing.h"
#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Model/SceneModel.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <QObject>

#include <array>
#include <functional>
#include <memory>

namespace varimarch
{

/// The action of the left button on the voxels of segments.
enum class SegmentTool
{
  None,
  Region, ///< adds the connected voxels of a range of values
  Paint,  ///< slices only
  Erase,  ///< slices only
};

/// Edits the voxels of one segment of the volume that the model edits. The panel chooses the
/// segment and the tool, and views pass on the places that the user clicks. A stroke, from press to
/// release, is one undo step. It is taken back if its labels are replaced meanwhile. Regions,
/// islands and smoothing are worked out in a thread; nothing else is edited meanwhile.
class SegmentEditor : public QObject
{
  Q_OBJECT

public:
  explicit SegmentEditor(SceneModel* model, QObject* parent = nullptr);

  SegmentTool Tool() const { return this->tool; }
  void SetTool(SegmentTool newTool);

  /// The edited segment, as an index in the segments of the volume.
  void SetSegment(int index) { this->segment = index; }
  /// Smallest and largest value of a region.
  void SetRange(const std::array<double, 2>& newRange) { this->range = newRange; }
  double RadiusMm() const { return this->radiusMm; }
  void SetRadiusMm(double radius) { this->radiusMm = radius; }

  /// True if the tool takes the left button, in slices or in the 3D view.
  bool TakesSlices() const { return this->HasSegment() && this->tool != SegmentTool::None; }
  bool TakesVolume() const { return this->HasSegment() && this->tool == SegmentTool::Region; }
  bool IsBrush() const { return this->TakesSlices() && !this->TakesVolume(); }

  /// True while a change is worked out.
  bool IsWorking() const { return this->work.IsRunning(); }
  /// Leaves the segments as they are.
  void Cancel() { this->work.Cancel(); }

  /// Adds the region of a point [mm].
  void AddRegion(const std::array<double, 3>& pointMm);

  /// A stroke of the brush, or the region of the first point.
  /// @param normal  unit normal of the slice
  void Press(const std::array<double, 3>& pointMm, const std::array<double, 3>& normal);
  void Drag(const std::array<double, 3>& pointMm);
  void Release();

  void KeepLargestIsland();
  void RemoveSmallIslands(double leastMl);
  void Smooth(double deviationMm);

signals:
  void ToolChanged();
  /// Voxels have changed within a stroke.
  void Stroked();
  /// A stroke begins or ends. Nothing may be undone during one.
  void StrokingChanged(bool isStroking);
  /// Work in a thread begins or ends. Nothing may be undone during it.
  void WorkingChanged(bool isWorking);
  /// An action found nothing to change.
  void Unchanged();
  /// @param reason  one sentence
  void Failed(const QString& reason);

private:
  bool HasSegment() const;
  vtkImageData* Numbers() const;
  vtkSmartPointer<vtkImageData> Placed(vtkImageData* image) const;
  int Number() const { return this->segment + 1; }
  /// @param change  runs in a thread, and gets a copy of the labels
  void Work(const QString& name, std::function<LabelChange(vtkImageData* numbers)> change);
  void Take(const Study& before, const LabelChange& change, const QString& name);
  void Brush(const std::array<double, 3>& toMm);
  void TakeBackStroke();

  SceneModel* model;
  SegmentTool tool = SegmentTool::None;
  int segment = -1;
  std::array<double, 2> range = { 0.0, 0.0 };
  double radiusMm = 5.0;
  std::array<double, 3> lastMm = {};
  std::array<double, 3> normal = {};
  LabelChange stroke;                    ///< so far
  vtkSmartPointer<vtkImageData> stroked; ///< the image that the stroke changes
  std::shared_ptr<LabelGuard> guard;     ///< guards that image
  bool isStroking = false;
  BackgroundTask work;
};

}

#endif
