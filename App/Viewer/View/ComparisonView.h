#ifndef Varimarch_Viewer_ComparisonView_h
#define Varimarch_Viewer_ComparisonView_h

#include "Core/Quality/ImageError.h"
#include "Scene/Model/Scene.h"
#include "Viewer/Tools/MouseTools.h"

#include <QTimer>
#include <QWidget>

#include <optional>

class QLabel;
class vtkImageData;

namespace varimarch
{

class SceneModel;
class VolumeView;

/// Our image and, on demand, VTK's image of the same scene, with the rendering times and the
/// difference. They stand side by side above a difference image, or one over the other with a
/// divider that can be dragged. The comparison runs when both have not changed for a moment.
class ComparisonView : public QWidget
{
  Q_OBJECT

public:
  explicit ComparisonView(SceneModel* model, QWidget* parent = nullptr);

  VolumeView* Ours() { return this->ours; }

  /// std::nullopt shows only our image.
  void CompareWith(std::optional<MapperKind> kind);

  /// True lays the images over each other; false puts them side by side.
  void SetWipe(bool newWipe);

  /// Moves the divider to a fraction of the width from the left, [0, 1].
  void MoveDivider(double part);

  /// Sets the action of the left button in all views.
  void SetTool(LeftButton button);

  /// Error of VTK's image against ours in the last comparison; empty if VTK cannot draw the scene.
  std::optional<ImageError> LastDifference() const { return this->lastDifference; }

signals:
  void Compared();

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  class Divider;

  void PlaceParts();
  void PlaceInGrid();
  void PlaceOverEachOther();
  void AwaitStillness();
  void Compare();
  void ShowDifference(vtkImageData* ourPicture, vtkImageData* theirPicture);
  void WithholdDifference(const QStringList& leftOut);

  SceneModel* model;
  VolumeView* ours;
  VolumeView* theirs = nullptr;
  MapperKind theirKind = MapperKind::VtkGpu; ///< the mapper of theirs
  QWidget* theirPart;                        ///< clips the visible part of theirs
  Divider* divider;
  bool wipe = false;
  double dividerPart = 0.5;
  LeftButton tool = LeftButton::Turn;
  QWidget* result;
  QLabel* title;
  QLabel* picture;
  QLabel* numbers;
  QTimer stillness;
  std::optional<ImageError> lastDifference;
};

}

#endif
