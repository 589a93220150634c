#ifndef Varimarch_Viewer_NumberSlider_h
#define Varimarch_Viewer_NumberSlider_h

#include <QWidget>

class QDoubleSpinBox;
class QSlider;

namespace varimarch
{

/// A number by a slider and in digits. From the slider's press to its release is one gesture.
class NumberSlider : public QWidget
{
  Q_OBJECT

public:
  enum class Scale
  {
    Linear,
    Logarithmic, ///< for a range above 0
  };

  NumberSlider(double smallest, double largest, Scale scale, QWidget* parent = nullptr);

  /// Shows a number, and tells nobody. One beyond the range shows as its end.
  void SetNumber(double number);

  /// Of the digits.
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
