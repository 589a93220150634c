#ifndef Varimarch_Viewer_ComparisonView_h
#define Varimarch_Viewer_ComparisonView_h

#include "Core/ImageError.h"
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

/// Our picture, and on demand beside it VTK's of the same scene, with their difference: where it
/// is, how large, and the time of each. Compares when both have been still for a moment.
class ComparisonView : public QWidget
{
  Q_OBJECT

public:
  explicit ComparisonView(SceneModel* model, QWidget* parent = nullptr);

  VolumeView* Ours() { return this->ours; }

  /// None: our picture alone.
  void CompareWith(std::optional<MapperKind> kind);

  /// What the left button does, in all pictures.
  void SetTool(LeftButton button);

  /// Of the last comparison, of VTK's picture from ours.
  std::optional<ImageError> LastDifference() const { return this->lastDifference; }

signals:
  void Compared();

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  void PlaceParts();
  void Compare();
  void ShowDifference(vtkImageData* ourPicture, vtkImageData* theirPicture);

  SceneModel* model;
  VolumeView* ours;
  VolumeView* theirs = nullptr;
  LeftButton tool = LeftButton::Turn;
  QWidget* result;
  QLabel* picture;
  QLabel* numbers;
  QTimer stillness;
  std::optional<ImageError> lastDifference;
};

}

#endif
