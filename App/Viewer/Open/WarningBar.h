#ifndef Varimarch_Viewer_WarningBar_h
#define Varimarch_Viewer_WarningBar_h

#include <QFrame>
#include <QStringList>

#include <memory>
#include <vector>

class QLabel;
class QPushButton;

namespace varimarch
{

struct LabelGuard;
struct Scene;
struct Study;

/// A warning about one of the volumes of a scene, or about its labels.
struct ScanWarning
{
  std::shared_ptr<LabelGuard> volume; ///< the volume, whatever its name; see Study
  QString sentence;
  QString name; ///< the name of a volume over the first one; empty for others

  /// The sentence after the name.
  QString Text() const;

  /// True for the same warning about the same volume, which may have another name by now.
  bool IsThatOf(const ScanWarning& other) const
  {
    return this->volume == other.volume && this->sentence == other.sentence;
  }
};

/// A bar above the views with warnings about the current volume. It stays until the user closes it
/// or another volume is opened.
class WarningBar : public QFrame
{
  Q_OBJECT

public:
  explicit WarningBar(QWidget* parent = nullptr);

  /// The warnings of all volumes and their labels.
  static std::vector<ScanWarning> WarningsOf(const Scene& scene, const Study& study);

  /// Opens the bar with warnings; hides it if there are none.
  /// @param remedy  label of a button beside them; empty: no button
  void Show(const std::vector<ScanWarning>& warnings, const QString& remedy);

  /// The same, but a bar that the user has closed stays closed, unless one of the warnings is new.
  void Update(const std::vector<ScanWarning>& warnings, const QString& remedy);

  /// The texts that were shown last, also after the user closed the bar.
  QStringList Texts() const;

signals:
  void RemedyWanted();

private:
  void SetWarnings(const std::vector<ScanWarning>& warnings, const QString& remedy);

  std::vector<ScanWarning> shown;
  QLabel* text;
  QPushButton* remedy;
};

}

#endif
