#ifndef Varimarch_Viewer_TagsWindow_h
#define Varimarch_Viewer_TagsWindow_h

#include "Scene/Model/Scene.h"
#include "Viewer/Model/BackgroundTask.h"

#include <QDialog>

#include <memory>

class QLabel;
class QLineEdit;
class QSpinBox;
class QTreeWidget;

namespace varimarch
{

class TaggedSeries;

/// Shows all DICOM attributes of the images of a series, which can be searched and copied. They
/// identify the patient: nothing of them is written anywhere.
class TagsWindow : public QDialog
{
  Q_OBJECT

public:
  TagsWindow(const FileSource& source, QWidget* parent);

  /// The selected attributes, or all that are shown if none is selected: a line each with tag,
  /// name, representation and value between tabs.
  QString SelectedText() const;

private:
  void FindFiles(const FileSource& source);
  void ShowSeries(const std::shared_ptr<const TaggedSeries>& found);
  void ReadFile();
  void Copy();

  std::shared_ptr<const TaggedSeries> series; ///< null until it is found
  BackgroundTask task;
  QLineEdit* search;
  QSpinBox* image;
  QLabel* status;
  QTreeWidget* tree;
};

}

#endif
