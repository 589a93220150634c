#ifndef Varimarch_Viewer_ValueAxis_h
#define Varimarch_Viewer_ValueAxis_h

#include <vector>

namespace varimarch
{

/// Which values of the data lie where on a horizontal stretch of pixels. It can be zoomed and
/// moved, but not so far that the data is lost.
class ValueAxis
{
public:
  /// The range of the data bounds what can be seen: from a 10000th of it to four times it.
  void SetData(double smallest, double largest);
  void SetPixels(double left, double right);

  /// Shows these values, with a little room on both sides.
  void Fit(double first, double last);

  /// @param factor  > 1 comes nearer; the value under the pixel stays where it is
  void Zoom(double pixel, double factor);

  /// Moves the values with the pointer.
  void Pan(double pixels);

  double First() const { return this->first; }
  double Last() const { return this->last; }

  double ToPixel(double value) const;
  double ToValue(double pixel) const;
  double ValuePerPixel() const;

  /// The value, rounded to a power of ten that is at most so many pixels wide: what a pointer
  /// means.
  double Rounded(double value, double pixels) const;

  /// Decimals that tell two pixels apart.
  int Decimals() const;

  /// Round numbers at least this far apart.
  std::vector<double> Ticks(double pixelsApart) const;

private:
  void Show(double newFirst, double newLast);

  double smallest = 0.0;
  double largest = 1.0;
  double first = 0.0;
  double last = 1.0;
  double left = 0.0;
  double right = 1.0;
};

}

#endif
