#ifndef Varimarch_Viewer_ArchiveChoice_h
#define Varimarch_Viewer_ArchiveChoice_h

#include "Archive/Archive.h"
#include "Viewer/Model/BackgroundTask.h"

#include <QDialog>
#include <QString>
#include <QVector>
#include <QWidget>

#include <optional>
#include <string>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QWidget;

namespace varimarch
{

/// An archive that the user has set up.
struct NamedArchive
{
  QString name; ///< as the user calls it
  ArchiveAddress address;
};

/// The archives in the settings, which only their user can read. Passwords are not kept.
QVector<NamedArchive> KeptArchives();
void KeepArchives(const QVector<NamedArchive>& archives);

/// Asks for the password of an archive's user; an empty one if it has none.
/// @returns nothing if the user cancels
std::optional<std::string> PasswordOf(const NamedArchive& archive, QWidget* parent);

/// A box to choose one of the archives that are set up, with buttons to set up more.
class ArchiveChoice : public QWidget
{
  Q_OBJECT

public:
  explicit ArchiveChoice(QWidget* parent = nullptr);

  /// The chosen archive; nothing if none is set up.
  std::optional<NamedArchive> Chosen() const;

signals:
  void Changed();

private:
  void List(int chosen);
  void KeepChoice();
  void Add();
  void Edit();
  void Remove();
  /// Lets the user edit an archive, and keeps it in this row of the list.
  void EditRow(int row, const NamedArchive& archive);

  QVector<NamedArchive> archives;
  QComboBox* box;
  QPushButton* edit;
  QPushButton* remove;
};

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
