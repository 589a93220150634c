#ifndef Varimarch_Testing_TaskHand_h
#define Varimarch_Testing_TaskHand_h

#include <QAction>
#include <QPoint>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <QWidget>

#include <deque>
#include <functional>
#include <vector>

namespace varimarch
{
class MainWindow;
}

/// A user's hand that counts what it does. The seconds are those of the keystroke-level model
/// (S. Card, T. Moran, A. Newell, Communications of the ACM 23, 1980, 396-410): 1.35 s to decide,
/// 1.1 s to point, 0.1 s to press or to release, 0.28 s for a key.
class TaskHand
{
public:
  TaskHand();

  void Click(QWidget* widget) { this->Click(widget, widget->rect().center()); }
  void Click(QWidget* widget, const QPoint& place);
  void Drag(QWidget* widget, const QPoint& from, const QPoint& to);
  /// Two clicks: the menu and its entry.
  void ChooseFromMenu(QAction* entry);
  /// Brings a panel to the front by its tab.
  void RaisePanel(QWidget* window, const QString& name);
  void Type(QWidget* field, const QString& text);
  void PressKey(QWidget* window, Qt::Key key);

  /// Gives the answer to the next dialog that stops the program until it is answered.
  void Expect(std::function<void(QWidget* dialog)> answer);
  void ForgetExpected() { this->answers.clear(); }
  /// Two clicks: an entry of the dialog, and its button.
  void ExpectFile(const QString& path);
  /// One click: the name is proposed, and only the folder is private to this test.
  void ExpectNameToSave(const QString& path);
  /// No click: what changed is discarded when the window closes.
  void ExpectToDiscard();

  int Clicks() const { return this->clicks + this->drags; }
  double Seconds() const;
  /// Begins to count anew.
  void Rest();

private:
  void Answer();

  int clicks = 0;
  int drags = 0;
  int keys = 0;
  std::deque<std::function<void(QWidget*)>> answers;
  QTimer timer;
};

/// The counts of a task.
struct Effort
{
  QString task; ///< as in the table of TenTasks.md
  int clicks;
  double seconds;
};

/// Rows that a table of efforts, such as that of TenTasks.md, should have and has not.
QStringList MissingRows(const QString& path, const std::vector<Effort>& efforts);

/// Waits until something is done. @throws std::runtime_error with the given words if it is not
void Await(const std::function<bool()>& isDone, const char* what);

/// Waits for a whole picture of the volume, and for those of the presets, which come one by one.
void AwaitPictures(varimarch::MainWindow& window);

#endif
