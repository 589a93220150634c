#ifndef Varimarch_Viewer_SendDialog_h
#define Varimarch_Viewer_SendDialog_h

#include "Viewer/Archives/ArchiveChoice.h"
#include "Viewer/Model/BackgroundTask.h"

#include <QDialog>
#include <QSize>

class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace varimarch
{

class SceneModel;

/// Renders the image of the scene, and sends it to an archive as a DICOM secondary capture: without
/// data of the patient, or with those of the scan whose look is edited. With those it can send the
/// measurements too, as a structured report.
class SendDialog : public QDialog
{
  Q_OBJECT

public:
  SendDialog(SceneModel* model, QSize pixels, QWidget* parent);

private:
  void ShowPossible();
  void Send();
  void ShowRunning(bool isRunning);

  SceneModel* model;
  QSize pixels;
  BackgroundTask task;
  ArchiveChoice* choice;
  QCheckBox* overlay;
  QCheckBox* identity;
  QCheckBox* report;
  QLabel* status;
  QProgressBar* progress;
  QPushButton* send;
};

}

#endif
