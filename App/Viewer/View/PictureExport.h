#ifndef Varimarch_Viewer_PictureExport_h
#define Varimarch_Viewer_PictureExport_h

#include "Scene/OffscreenView.h"
#include "Scene/Scene.h"

#include <QDialog>
#include <QImage>
#include <QSize>

#include <functional>
#include <optional>

class QCheckBox;
class QProgressBar;
class QSpinBox;
class vtkImageData;

namespace varimarch
{

class SceneModel;

struct ExportOptions
{
  QSize pixels;
  bool transparent = false; ///< in place of the scene's background
  bool overlay = true;      ///< letters and distances
};

/// Draws a scene anew, of any size and without a window, with the notice that it is not for
/// diagnostic use.
class PictureMaker
{
public:
  /// @param image  the scene's volume; must outlive this
  /// @throws std::runtime_error one sentence, where there is no OpenGL
  PictureMaker(const Scene& scene, vtkImageData* image, const ExportOptions& options);
  ~PictureMaker();
  PictureMaker(const PictureMaker&) = delete;
  PictureMaker& operator=(const PictureMaker&) = delete;

  /// The settings are in the picture's text "varimarch-scene", without what may tell of a patient:
  /// the volume's place and series, and names of the user's own.
  /// @param onProgress  told the part that is done, [0, 1)
  QImage Draw(const std::function<void(double)>& onProgress = nullptr);

  /// Turns the eye about the picture's vertical.
  void Turn(double degrees);

private:
  Scene scene;
  vtkImageData* image;
  ExportOptions options;
  std::optional<OffscreenView> view;
};

/// Asks for the size and what else to know, and where to; draws and writes the picture.
class ExportDialog : public QDialog
{
  Q_OBJECT

public:
  ExportDialog(SceneModel* model, QSize viewSize, QWidget* parent);

private:
  void Export();

  SceneModel* model;
  QSpinBox* width;
  QSpinBox* height;
  QCheckBox* transparent;
  QCheckBox* overlay;
  QProgressBar* progress;
};

}

#endif
