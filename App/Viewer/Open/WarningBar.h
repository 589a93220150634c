#ifndef Varimarch_Viewer_WarningBar_h
#define Varimarch_Viewer_WarningBar_h

#include <QFrame>
#include <QStringList>

class QLabel;
class QPushButton;

namespace varimarch
{

/// A strip above the views with what is doubtful about the volume that is shown, until somebody has
/// read it and closes it, or another volume comes.
class WarningBar : public QFrame
{
  Q_OBJECT

public:
  explicit WarningBar(QWidget* parent = nullptr);

  /// None: nothing to be seen.
  /// @param remedy  what a button beside them says; empty: there is none
  void Show(const QStringList& warnings, const QString& remedy);

signals:
  void RemedyWanted();

private:
  QLabel* text;
  QPushButton* remedy;
};

}

#endif
