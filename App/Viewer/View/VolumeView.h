#ifndef Varimarch_Viewer_VolumeView_h
#define Varimarch_Viewer_VolumeView_h

#include "Scene/ScenePipeline.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Tools/MouseTools.h"
#include "Viewer/View/Overlay.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <optional>

class vtkEventQtSlotConnect;
class vtkGenericOpenGLRenderWindow;
class vtkVariationFieldVolumeMapper;

namespace varimarch
{

/// The volume in three dimensions, as one mapper draws it. Listens to the model, and tells it where
/// the user has turned the camera. However many changes come at once, one quick picture follows,
/// and a fine one when they have ended, which is then refined.
class VolumeView
  : public QVTKOpenGLNativeWidget
  , public ToolSurface
{
  Q_OBJECT

public:
  VolumeView(SceneModel* model, MapperKind kind, QWidget* parent = nullptr);
  ~VolumeView() override;

  /// None before the first volume.
  ScenePipeline* Pipeline() { return this->pipeline ? &*this->pipeline : nullptr; }

  /// Of the last picture, until its last pixel was there, without what came between its parts [s].
  double PictureSeconds() const { return this->pictureSeconds; }

  /// How the last picture shows the world.
  PictureFrame Frame() const override;

  /// The same picture in float, see CaptureFloatImage.
  vtkSmartPointer<vtkImageData> FloatPicture();

  std::optional<std::array<double, 3>> PointAt(const QPointF& place) const override;

  /// What the left button does.
  void SetTool(LeftButton button);

  /// Whether a picture that stays is refined while nothing else is to be done: ours comes in parts,
  /// lest somebody waits for it, and becomes the mean of several, of which each has its rays
  /// elsewhere in the pixels. Default on. Not while pictures are compared, which is of one.
  void SetRefining(bool refining);

  /// In which upper corner the time and the error stand.
  void SetReportSide(Qt::AlignmentFlag side);

  /// Whether cuts can be grabbed in the picture.
  void ShowCutHandles(bool shown);

signals:
  void Drawn();                  ///< a picture, or its last part
  void Refined(double pictures); ///< that the picture is now the mean of, with parts of the last

  /// The pointer is over something: where and what, for a status bar; empty over nothing.
  void Pointed(const QString& text);

protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private slots:
  // Called by VTK's events.
  void BeginTurning();
  void EndTurning();
  void KeepCamera();
  void BeginPicture();
  void EndPicture();

private:
  class OverlayWidget;

  void Update(ScenePart part);
  void TakeVolume();
  void TakeCamera();
  void PrepareTimers();
  void RequestPicture();
  vtkVariationFieldVolumeMapper* OurMapper(); ///< none where it is VTK's
  void TakeRefining();
  void Refine();
  Camera CurrentCamera() const;
  void Point(const QPointF& place);
  double Aspect() const;

  SceneModel* model;
  MapperKind kind;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkEventQtSlotConnect> events;
  std::optional<ScenePipeline> pipeline;
  OverlayWidget* overlay;
  Qt::AlignmentFlag reportSide = Qt::AlignLeft;
  QTimer quickPicture; ///< while changes come
  QTimer finePicture;  ///< when none has come for a moment
  QTimer refinement;   ///< when the fine one is there, and nothing else is to be done
  bool refines = true;
  bool refining = false; ///< what is drawn now adds to the picture that is there
  bool isWhole = true;   ///< all parts of the last picture are there
  QElapsedTimer pictureTimer;
  double pictureSeconds = 0.0;
  bool capturing = false;
  int turning = SceneModel::NoGesture; ///< the camera's gesture
  bool isTurning = false;
  MouseTools tools;
  MeasureTexts texts; ///< of what was measured
};

}

#endif
