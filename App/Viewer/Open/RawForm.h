#ifndef Varimarch_Viewer_RawForm_h
#define Varimarch_Viewer_RawForm_h

#include "Scene/Model/Scene.h"
#include "Viewer/Model/BackgroundTask.h"

#include <QDialog>
#include <QImage>

#include <array>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;

namespace varimarch
{

/// Asks for the layout of a file without a header. Previews a slice with that layout, and compares
/// the size that it needs with the size of the file.
class RawForm : public QDialog
{
  Q_OBJECT

public:
  /// Starts with the layout that the file's name and size suggest.
  RawForm(const QString& path, QWidget* parent);

  RawLayout Layout() const;

signals:
  void Chosen(const varimarch::FileSource& source);

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  QFormLayout* MakeForm();
  QLayout* MakePreview();
  QWidget* MakeButtons();
  void SetLayout(const RawLayout& layout);
  void Update();
  void ReadSlice();
  void ShowFit();
  void ShowPicture();

  std::string path;
  std::int64_t fileBytes;
  bool isCompressed;      ///< compressed, so the file size says nothing
  BackgroundTask reading; ///< reads the slice that is previewed
  QImage picture;
  std::array<QSpinBox*, 3> dimensions;
  std::array<QDoubleSpinBox*, 3> spacing;
  QComboBox* type;
  QComboBox* byteOrder;
  QSpinBox* headerBytes;
  QPushButton* takeHeader;
  QLabel* slicePicture;
  QSlider* slice;
  QLabel* fit;
  QPushButton* openButton;
};

}

#endif
