#ifndef Varimarch_Viewer_ArchiveForm_h
#define Varimarch_Viewer_ArchiveForm_h

#include "Viewer/Archives/ArchiveList.h"
#include "Viewer/Model/BackgroundTask.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace varimarch
{

/// Edits what is needed to reach an archive.
class ArchiveForm : public QDialog
{
  Q_OBJECT

public:
  ArchiveForm(const NamedArchive& archive, QWidget* parent);

  /// The archive as it has been edited.
  NamedArchive Edited() const;

private:
  void MakeRows(QFormLayout* rows);
  void Show(const NamedArchive& archive);
  void ShowRows();
  void TryOut();
  void Finish();
  bool IsWeb() const;

  BackgroundTask task;
  QLineEdit* name;
  QComboBox* kind;
  QLineEdit* host;
  QSpinBox* port;
  QLineEdit* title;
  QLineEdit* ownTitle;
  QSpinBox* returnPort;
  QCheckBox* encrypted;
  QLineEdit* url;
  QLineEdit* user;
  QLineEdit* certificate;
  QLineEdit* ownCertificate;
  QFormLayout* rows;
  QLabel* status;
};

}

#endif
