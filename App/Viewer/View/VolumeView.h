#ifndef Varimarch_Viewer_VolumeView_h
#define Varimarch_Viewer_VolumeView_h

#include "Scene/ScenePipeline.h"
#include "Viewer/Model/SceneModel.h"

#include <QElapsedTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <optional>

class QLabel;
class vtkEventQtSlotConnect;
class vtkGenericOpenGLRenderWindow;

namespace varimarch
{

/// The volume in three dimensions, as one mapper draws it. Listens to the model, and tells it where
/// the user has turned the camera. However many changes come at once, one picture follows.
class VolumeView : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  VolumeView(SceneModel* model, MapperKind kind, QWidget* parent = nullptr);
  ~VolumeView() override;

  /// None before the first volume.
  ScenePipeline* Pipeline() { return this->pipeline ? &*this->pipeline : nullptr; }

  /// Of the last picture, until its last pixel was there [s].
  double PictureSeconds() const { return this->pictureSeconds; }

signals:
  void Drawn();

protected:
  void resizeEvent(QResizeEvent* event) override;

private slots:
  // Called by VTK's events.
  void KeepCamera();
  void BeginPicture();
  void EndPicture();

private:
  void Update(ScenePart part);
  void TakeVolume();
  void TakeCamera();
  void RequestPicture();
  double Aspect() const;

  SceneModel* model;
  MapperKind kind;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkEventQtSlotConnect> events;
  std::optional<ScenePipeline> pipeline;
  QLabel* report;
  QElapsedTimer pictureTimer;
  double pictureSeconds = 0.0;
  bool pictureRequested = false;
};

}

#endif
