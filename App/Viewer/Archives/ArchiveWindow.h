#ifndef Varimarch_Viewer_ArchiveWindow_h
#define Varimarch_Viewer_ArchiveWindow_h

#include "Archive/Archive.h"
#include "Viewer/Archives/ArchiveChoice.h"
#include "Viewer/Model/BackgroundTask.h"

#include <QDialog>

#include <memory>
#include <optional>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace varimarch
{

class PrivateFolder;

/// Searches an archive for studies, and fetches what the user chooses: into a private folder that
/// vanishes, or into one where the user wants to keep it.
class ArchiveWindow : public QDialog
{
  Q_OBJECT

public:
  explicit ArchiveWindow(QWidget* parent);

signals:
  /// A scan was fetched.
  /// @param folder  that it lies in
  /// @param temporary  keeps the folder as long as it lives; null if the user keeps it
  void Fetched(
    const QString& folder, const std::shared_ptr<const varimarch::PrivateFolder>& temporary);

private:
  void Connect();
  QWidget* MakeSearch();
  QWidget* MakeButtons();
  ArchiveQuery Query() const;
  /// Starts work with the chosen archive.
  /// @param work  is given the archive and a TaskProgress
  /// @param done  as in BackgroundTask::Start
  template <class Work, class Done>
  void Start(const QString& activity, Work work, Done done);
  void Cancel();
  void Search();
  void ShowStudies(const std::vector<ArchiveStudy>& studies);
  void ListSeries(QTreeWidgetItem* study);
  void Keep();
  /// @param users  the user's folder in which the scan gets one; empty for a private one
  void Fetch(const QString& users);
  void ShowRunning(bool isRunning);
  void ShowProgress(double part);

  BackgroundTask task;
  ArchiveChoice* choice;
  std::optional<std::string> password; ///< password of the chosen archive, once it was asked for
  QLineEdit* patientName;
  QLineEdit* patientId;
  QLineEdit* dates;
  QLineEdit* modality;
  QTreeWidget* tree;
  QLabel* status;
  QProgressBar* progress;
  QPushButton* cancel;
  QWidget* actions;
};

}

#endif
