#ifndef Varimarch_Viewer_NumberSlider_h
#define Varimarch_Viewer_NumberSlider_h

#include <QWidget>

class QDoubleSpinBox;
class QSlider;

namespace varimarch
{

/// A slider with a spin box for one number. A drag of the slider is one gesture.
class NumberSlider : public QWidget
{
  Q_OBJECT

public:
  enum class Scale
  {
    Linear,
    Logarithmic, ///< for a range of positive numbers
  };

  NumberSlider(double smallest, double largest, Scale scale, QWidget* parent = nullptr);

  /// Shows a number without emitting Edited. Numbers outside the range are clamped.
  void SetNumber(double number);

  /// Changes the range, and keeps the number.
  void SetRange(double newSmallest, double newLargest);

  /// Sets the suffix of the spin box.
  void SetSuffix(const QString& suffix);

signals:
  void Edited(double number, int gesture);

private:
  double NumberOf(int position) const;
  int PositionOf(double number) const;

  double smallest;
  double largest;
  Scale scale;
  QSlider* slider;
  QDoubleSpinBox* digits;
  int gesture = 0;
};

}

#endif
