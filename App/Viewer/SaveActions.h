#ifndef Varimarch_Viewer_SaveActions_h
#define Varimarch_Viewer_SaveActions_h

#include <QObject>

#include <exception>

class QMainWindow;
class QMenu;

namespace varimarch
{

class SavedWork;
class ScanLists;
class SceneModel;

/// Saves the user's work, sessions and segmentations, and asks before it is lost.
class SaveActions : public QObject
{
  Q_OBJECT

public:
  /// The work, and the lists that know which scans are deleted at the end.
  struct Context
  {
    SceneModel* model;
    SavedWork* work;
    const ScanLists* lists;
  };

  SaveActions(const Context& context, QMainWindow* window);

  void AddTo(QMenu* menu);

  /// Returns true if the shown scan can be left: its work is saved, or the user gives it up.
  bool MayLeaveScan();

  /// Returns false if the user cancels, or if saving fails.
  bool SaveSession();

  /// Saves the segments of a volume. Returns false if the user cancels, or if saving fails.
  bool SaveSegmentation(int volume);

signals:
  void Saved(const QString& path);

private:
  void ShowFailure(const std::exception& problem);

  Context context;
  QMainWindow* window;
};

}

#endif
