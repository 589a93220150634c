#ifndef Varimarch_Viewer_WarningBar_h
#define Varimarch_Viewer_WarningBar_h

#include <QFrame>
#include <QStringList>

class QLabel;
class QPushButton;

namespace varimarch
{

struct Scene;
struct Study;

/// A bar above the views with warnings about the current volume. It stays until the user closes it
/// or another volume is opened.
class WarningBar : public QFrame
{
  Q_OBJECT

public:
  explicit WarningBar(QWidget* parent = nullptr);

  /// The warnings of all volumes and their labels. Those of a volume over the first one begin with
  /// its name.
  static QStringList TextsOf(const Scene& scene, const Study& study);

  /// Shows warnings; hides the bar if there are none.
  /// @param remedy  label of a button beside them; empty: no button
  void Show(const QStringList& warnings, const QString& remedy);

  /// The warnings that were shown last, also after the user closed the bar.
  const QStringList& Texts() const { return this->texts; }

signals:
  void RemedyWanted();

private:
  QStringList texts;
  QLabel* text;
  QPushButton* remedy;
};

}

#endif
