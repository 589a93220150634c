#ifndef Varimarch_Viewer_WarningBar_h
#define Varimarch_Viewer_WarningBar_h

#include <QFrame>
#include <QStringList>

class QLabel;

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
  void Show(const QStringList& warnings);

private:
  QLabel* text;
};

}

#endif
