#ifndef Varimarch_Viewer_ValueAxis_h
#define Varimarch_Viewer_ValueAxis_h

#include <vector>

namespace varimarch
{

/// Maps values of the data to a horizontal range of pixels. It can be zoomed and panned, but never
/// so far that the data leaves the range.
class ValueAxis
{
public:
  /// Sets the range of the data. The visible range is limited to between 1/10000 and four times it.
  void SetData(double smallest, double largest);
  void SetPixels(double left, double right);

  /// Shows the given range with a small margin on both sides.
  void Fit(double first, double last);

  /// @param factor  > 1 zooms in; the value under the pixel stays in place
  void Zoom(double pixel, double factor);

  /// Moves the values with the pointer.
  void Pan(double pixels);

  double First() const { return this->first; }
  double Last() const { return this->last; }

  double ToPixel(double value) const;
  double ToValue(double pixel) const;
  double ValuePerPixel() const;

  /// Rounds a value to a power of ten that is at most `pixels` wide, as suits a position of the
  /// pointer.
  double Rounded(double value, double pixels) const;

  /// Number of decimals that distinguish neighbouring pixels.
  int Decimals() const;

  /// Round numbers that are at least `pixelsApart` apart.
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
