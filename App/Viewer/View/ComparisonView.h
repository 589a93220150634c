#ifndef Varimarch_Viewer_ComparisonView_h
#define Varimarch_Viewer_ComparisonView_h

#include "Core/Quality/ImageError.h"
#include "Scene/Scene.h"
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

/// Our picture, and on demand VTK's of the same scene, with their difference and the time of each:
/// side by side, with a picture of where they differ, or one over the other, with a divider between
/// them that is dragged. Compares when both have been still for a moment.
class ComparisonView : public QWidget
{
  Q_OBJECT

public:
  explicit ComparisonView(SceneModel* model, QWidget* parent = nullptr);

  VolumeView* Ours() { return this->ours; }

  /// None: our picture alone.
  void CompareWith(std::optional<MapperKind> kind);

  /// Whether the pictures lie over each other; else they stand side by side.
  void SetWipe(bool newWipe);

  /// Where the divider is, as a part of the width from the left, [0, 1].
  void MoveDivider(double part);

  /// What the left button does, in all pictures.
  void SetTool(LeftButton button);

  /// Of the last comparison, of VTK's picture from ours.
  std::optional<ImageError> LastDifference() const { return this->lastDifference; }

signals:
  void Compared();

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  class Divider;

  void PlaceParts();
  void PlaceSideBySide();
  void PlaceOverEachOther();
  void Compare();
  void ShowDifference(vtkImageData* ourPicture, vtkImageData* theirPicture);

  SceneModel* model;
  VolumeView* ours;
  VolumeView* theirs = nullptr;
  QWidget* theirPart; ///< shows as much of theirs as is to be seen
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
