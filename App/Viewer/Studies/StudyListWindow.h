#ifndef Varimarch_Viewer_StudyListWindow_h
#define Varimarch_Viewer_StudyListWindow_h

#include "Viewer/Model/BackgroundTask.h"

#include <QDialog>
#include <QString>
#include <QStringList>
#include <QVector>

#include <functional>

class QLabel;
class QLineEdit;
class QMenu;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace varimarch
{

/// A series in the list of studies. It identifies the patient.
struct IndexedSeries
{
  QString patientName; ///< as stored, "DOE^JANE"
  QString patientId;
  QString studyUid;
  QString studyDate; ///< as stored, "20261126"
  QString studyDescription;
  QString seriesUid;
  int seriesNumber;
  QString seriesDescription;
  QString modality;
  int imageCount;
  QString path; ///< the file of the series, or the folder that all its files lie in
};

/// The list of the DICOM series in folders that the user names. It is a database in a file that
/// only its user can read, from the first folder on until the list is removed. Every function
/// opens the file for itself, so that a thread can update the list while another one shows it. All
/// throw std::runtime_error with one sentence if the file cannot be used.
class StudyIndex
{
public:
  /// @param file  the file of the database
  explicit StudyIndex(const QString& file)
    : file(file)
  {
  }

  QStringList Folders() const;

  /// All series, sorted by patient, the latest study first, and the number of the series.
  QVector<IndexedSeries> Series() const;

  /// Adds a folder and its subfolders, or finds what has changed in it: only files that are new or
  /// have another size or time are read. If it is cancelled, what was read so far stays.
  /// @throws ReadCancelled
  void Update(const QString& folder, const TaskProgress& goesOn) const;

  /// Removes a folder from the list. Its files stay.
  void Forget(const QString& folder) const;

  /// Overwrites and deletes the database.
  void RemoveAll() const;

private:
  bool Exists() const;

  QString file;
};

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
