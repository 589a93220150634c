#ifndef Varimarch_Viewer_PictureExport_h
#define Varimarch_Viewer_PictureExport_h

#include "Scene/Scene.h"

#include <QDialog>
#include <QImage>
#include <QSize>

#include <functional>

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

/// A scene drawn anew, with the notice that it is not for diagnostic use. The settings are in its
/// text "varimarch-scene", without the volume's place, which may name a patient.
/// @param onProgress  told the part that is done, [0, 1)
/// @throws std::runtime_error one sentence
QImage ExportedPicture(const Scene& scene, vtkImageData* image, const ExportOptions& options,
  const std::function<void(double)>& onProgress = nullptr);

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
