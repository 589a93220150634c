#ifndef Varimarch_Viewer_StudyListWindow_h
#define Varimarch_Viewer_StudyListWindow_h

#include "Viewer/Model/BackgroundTask.h"
#include "Viewer/Studies/StudyIndex.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QMenu;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace varimarch
{

/// The studies in folders that the user has named, by patient, study and series. Folders are read
/// in a thread.
class StudyListWindow : public QDialog
{
  Q_OBJECT

public:
  /// @param file  the file of the list, see StudyIndex
  StudyListWindow(const QString& file, QWidget* parent);

  /// Adds a folder to the list, or finds what has changed in it.
  void Read(const QStringList& folders);

signals:
  /// @param path    the folder or the file that the series is in
  /// @param series  see DigestOfSeries
  void SeriesWanted(const QString& path, const QString& series);

private:
  void Connect();
  QWidget* MakeButtons();
  void AddFolder();
  void FindChanges();
  void ListFolders();
  void RemoveAll();
  void Show();
  void ShowState();
  void OpenItem(QTreeWidgetItem* item);
  /// Does something with the list, and shows its failure.
  void Try(const std::function<void()>& action);
  /// Changes the list, and shows it, or the failure.
  void Change(const std::function<void()>& change);

  StudyIndex index;
  BackgroundTask task;
  QLineEdit* search;
  QTreeWidget* tree;
  QLabel* status;
  QProgressBar* progress;
  QPushButton* cancel;
  QMenu* forget;
  int seriesCount = 0;
};

}

#endif
