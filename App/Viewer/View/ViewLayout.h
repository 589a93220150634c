#ifndef Varimarch_Viewer_ViewLayout_h
#define Varimarch_Viewer_ViewLayout_h

#include <QWidget>

#include <vector>

class QSplitter;

namespace varimarch
{

/// Places the view of the volume and the slices, with splitters between them. One of them can be
/// shown alone.
class ViewLayout : public QWidget
{
  Q_OBJECT

public:
  enum class Arrangement
  {
    VolumeLarge, ///< the volume, and the slices in a column beside it
    Equal,       ///< two rows of two
  };

  /// @param slices  three
  /// @param bar     belongs to the slices
  ViewLayout(
    QWidget* volume, const std::vector<QWidget*>& slices, QWidget* bar, QWidget* parent = nullptr);

  Arrangement CurrentArrangement() const { return this->arrangement; }
  void Arrange(Arrangement newArrangement);

  /// Shows a view alone, or all if it is alone already.
  void Toggle(QWidget* view);

  /// The view that is shown alone; null if all are shown.
  QWidget* Alone() const { return this->alone; }
  void ShowAlone(QWidget* view);

  /// Shows or hides all slices. A comparison needs their room.
  void ShowSlices(bool shown);

signals:
  void Changed();

private:
  void ShowParts();

  QWidget* volume;
  std::vector<QWidget*> slices;
  QSplitter* columns;
  QSplitter* left;
  QSplitter* right;
  QWidget* rightColumn; ///< holds right and the bar
  Arrangement arrangement = Arrangement::VolumeLarge;
  QWidget* alone = nullptr;
  bool hasSlices = true;
};

}

#endif
