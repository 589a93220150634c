#ifndef Varimarch_Viewer_VolumeView_h
#define Varimarch_Viewer_VolumeView_h

#include "Scene/Pipeline/ScenePipeline.h"
#include "Viewer/Model/SceneModel.h"
#include "Viewer/Model/SegmentEditor.h"
#include "Viewer/Tools/MouseTools.h"
#include "Viewer/View/Overlay.h"
#include "Viewer/View/PictureReport.h"
#include "Viewer/View/PictureThread.h"
#include "Viewer/View/VtkPictures.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QObject>
#include <QTimer>
#include <QVTKInteractorAdapter.h>
#include <QVTKOpenGLNativeWidget.h>
#include <QWidget>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <memory>
#include <optional>

class vtkEventQtSlotConnect;
class vtkGenericOpenGLRenderWindow;
class vtkInteractorStyle;
class vtkRenderWindow;
class vtkVariationFieldVolumeMapper;

namespace varimarch
{

/// Decides when a view draws. Changes that arrive together cause one quick frame; when they stop, a
/// fine frame follows, then its refinement while the program is idle. Fine frames and refinement
/// take long, so they wait while a mouse button is held: gestures stay smooth.
class FramePacer : public QObject
{
  Q_OBJECT

public:
  explicit FramePacer(QObject* parent = nullptr);

  /// Requests a quick frame and a fine one after it, instead of further refinement.
  void Request();

  /// Requests the fine frame only, for a view whose quick frames are drawn by others.
  void RequestFine();

  /// Requests another step of refinement.
  void RequestRefinement() { this->refinement.start(); }

  void StopRefinement() { this->refinement.stop(); }

signals:
  void QuickFrameDue();
  void FineFrameDue(); ///< the first step of refinement follows by itself
  void RefinementDue();

private:
  QTimer quickFrame;
  QTimer fineFrame;
  QTimer refinement;
};

class VolumeSurface;

/// The volume in 3D, rendered by one mapper. It observes the model and reports back when the user
/// turns the camera. Several changes at once are followed by one quick frame; when the changes
/// stop, it renders a fine frame and then refines it.
class VolumeView
  : public QWidget
  , public ToolSurface
{
  Q_OBJECT

public:
  VolumeView(SceneModel* model, MapperKind kind, QWidget* parent = nullptr);
  ~VolumeView() override;

  /// The window that VTK draws into.
  vtkRenderWindow* RenderWindow();

  /// Null before the first volume.
  ScenePipeline* Pipeline() { return this->pipeline ? &*this->pipeline : nullptr; }

  /// Rendering time of the last frame, without the pauses between its parts [s].
  double PictureSeconds() const { return this->pictureSeconds; }

  /// The text in the corner; empty before the first volume.
  QString Report();

  /// Size of the image that is shown [pixels]: less than that of the view while the user turns it.
  QSize PicturePixels() const;

  /// Projection of the last frame.
  PictureFrame Frame() const override;

  /// The frame as a float image, see CaptureFloatImage. Null while VTK's is incomplete, and until
  /// the thread has drawn the present scene at rest.
  vtkSmartPointer<vtkImageData> FloatPicture();

  std::optional<std::array<double, 3>> PointAt(const QPointF& place) const override;
  void AskForWords(const QPointF& place, const std::function<void(const QString&)>& take) override;

  /// Sets the action of the left button.
  void SetTool(LeftButton button);

  /// The left button adds regions to a segment while that tool of the editor is chosen.
  void SetSegmentEditor(SegmentEditor* newEditor) { this->segmentEditor = newEditor; }

  /// Sets whether a frame is refined while the program is idle. Our mapper then renders the frame
  /// in parts, which keeps the window responsive, and averages several frames with different
  /// subpixel offsets. Default on. Off during comparisons, which need a single frame.
  void SetRefining(bool refining);

  /// Lets a thread draw our pictures, so that this one never waits for them. For an OpenGL that the
  /// processor draws; a graphics card would serve two threads in turn.
  void DrawInThread();

  /// Sets the upper corner that shows time and error.
  void SetReportSide(Qt::AlignmentFlag side);

  /// Sets whether cuts can be grabbed in the view.
  void ShowCutHandles(bool shown);

signals:
  /// A frame, or its last part, is complete.
  void Drawn();

  /// The graphics card was reset. The view draws again when it has a new context.
  void GraphicsLost();

  /// @param pictures  number of frames averaged so far; a fraction counts parts of the last one
  void Refined(double pictures);

  /// The user wants to see this view alone, or all views again.
  void DoubleClicked();

  /// Describes the object under the pointer, for the status bar; empty over nothing.
  void Pointed(const QString& text);

protected:
  bool event(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

private slots:
  // Connected to VTK's events.
  void BeginTurning();
  void EndTurning();
  void KeepCamera();
  void BeginPicture();
  void EndPicture();
  void LoseGraphics();

private:
  static constexpr double PicturesPerSecondWhileMoving = 15.0;

  class OverlayWidget;

  void ConnectWindow();
  void TakeContext();
  void Update(ScenePart part);
  bool Takes(ScenePart part);
  void TakeCuts();
  vtkImageData* Mask() const; ///< the part that is shown; null if nothing is removed
  void FollowCamera();
  void TakeVolume();
  void TakeMeasures();
  bool PressSegment(QEvent* event);
  void TakeCamera();
  void Draw(double framesPerSecond);
  void DrawFinely();
  vtkVariationFieldVolumeMapper* OurMapper(); ///< null if this view uses VTK's mapper
  void ApplyRefining();
  bool IsDrawnInThread() const { return bool(this->thread); }
  bool IsOutOfDate() const; ///< The scene or the size has changed since the thread's picture.
  void Tell(ScenePart part);
  void TakePicture();
  void GiveUpThread();
  std::optional<PictureNumbers> Numbers(); ///< empty if this view uses VTK's mapper
  std::optional<PictureNumbers> NumbersOfMapper();
  void Count(double seconds, bool refines);
  void Refine();
  void ContinueStill();
  Camera CurrentCamera() const;
  vtkInteractorStyle* Style();
  std::optional<std::array<double, 3>> PointOfEdited(const QPointF& place) const;
  void Point(const QPointF& place);
  double Aspect() const;

  SceneModel* model;
  MapperKind kind;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<vtkEventQtSlotConnect> events;
  std::optional<ScenePipeline> pipeline;
  VolumeSurface* surface = nullptr;
  bool hasCuts = true; ///< the pipeline has the cuts of the scene; not while the thread draws
  QWidget* overlay = nullptr; ///< an OverlayWidget
  QVTKInteractorAdapter input;
  Qt::AlignmentFlag reportSide = Qt::AlignLeft;
  FramePacer pacer;
  StillPicture still;                    ///< the fine frame of VTK's GPU mapper
  std::unique_ptr<PictureThread> thread; ///< draws our frames; null if this thread does
  bool refines = true;
  bool refining = false; ///< the current frame adds to the accumulated image
  bool isWhole = true;   ///< all parts of the last frame are complete
  QElapsedTimer pictureTimer;
  double pictureSeconds = 0.0;
  std::string reasonForNothing; ///< for the last frame of this thread, see EmptyPicture.h
  bool capturing = false;
  bool isLost = false; ///< the graphics card was reset, and the context is still the same
  int turning = SceneModel::NoGesture; ///< gesture number of the camera
  bool isTurning = false;
  SegmentEditor* segmentEditor = nullptr; ///< null before it is set
  MouseTools tools;
  MeasureTexts texts; ///< labels of the measurements
};

/// The part of a view that OpenGL draws. Its view, which is its parent, takes the mouse and the
/// keys. While it is visible, Qt composes the whole window by OpenGL, which takes long where the
/// processor does that; so it is hidden where a thread draws the images.
class VolumeSurface : public QVTKOpenGLNativeWidget
{
  Q_OBJECT

public:
  explicit VolumeSurface(QWidget* parent);

signals:
  /// There is an OpenGL context, the first one or another one after a reset of the graphics card.
  void ContextIsNew();

protected:
  void initializeGL() override;
};

}

#endif
