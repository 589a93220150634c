#ifndef Varimarch_Viewer_PictureExport_h
#define Varimarch_Viewer_PictureExport_h

#include "Scene/Images/OffscreenView.h"
#include "Scene/Model/Scene.h"
#include "Viewer/Model/Study.h"

#include <QDialog>
#include <QImage>
#include <QSize>

#include <functional>
#include <optional>

class QCheckBox;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace varimarch
{

class SceneModel;

struct ExportOptions
{
  QSize pixels;
  bool transparent = false; ///< replaces the scene's background
  bool overlay = true;      ///< directions and measurements
};

/// Renders a scene at any size, without a window, with the notice that it is not for diagnostic
/// use.
class PictureMaker
{
public:
  /// @param study  the scene's volume and labels
  /// @throws std::runtime_error with one sentence if there is no OpenGL
  PictureMaker(const Scene& scene, const Study& study, const ExportOptions& options);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  /// Renders an image. Its text entry "varimarch-scene" holds the settings without data that may
  /// identify a patient: path and series of the volume, and names given by the user.
  /// @param onProgress  receives the fraction done, [0, 1); may let windows draw, and returns false
  ///                    to cancel
  /// @return null if cancelled
  QImage Draw(const std::function<bool(double)>& onProgress = nullptr);

  /// Draws the volumes at another time from now on.
  void ShowTime(const Study& ofTime);

  /// Draws the first volume with another look, or with other cuts, from now on.
  void SetLook(const Look& look);
  void SetCuts(const SceneCuts& cuts);

  /// Turns the eye about the vertical of the image.
  void Turn(double degrees);

private:
  Scene scene;
  Study study;
  ExportOptions options;
  std::optional<OffscreenView> view;
};

/// Writes a PNG file in place. Returns false if a part of it could not be written; errno then says
/// why.
bool SaveAsPng(const QImage& picture, const std::string& path);

/// Asks for size, options and file, then renders and writes the image.
class ExportDialog : public QDialog
{
  Q_OBJECT

public:
  ExportDialog(SceneModel* model, QSize viewSize, QWidget* parent);

  /// The file that was written, once the dialog is accepted.
  QString Path() const { return this->path; }

  /// Cancels the export that goes on, or closes the dialog.
  void reject() override;

private:
  void Export();
  void Write();
  /// Shows the fraction done and lets the user cancel; returns false then.
  bool GoesOn(double part);

  SceneModel* model;
  bool exports = false; ///< true while an image is rendered
  QSpinBox* width;
  QSpinBox* height;
  QCheckBox* transparent;
  QCheckBox* overlay;
  QProgressBar* progress;
  QPushButton* save;
  QString path;
};

}

#endif
