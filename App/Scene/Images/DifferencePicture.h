#ifndef Varimarch_Scene_DifferencePicture_h
#define Varimarch_Scene_DifferencePicture_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>
#include <vector>

namespace varimarch
{

class Canvas;

/// Shows where two float images differ, as a byte image. The colour of a pixel is the largest
/// difference of its channels on a fixed logarithmic scale from 0.1/255 to 100/255, so that
/// difference images can be compared with each other. The colour map is cividis, which reads alike
/// with any kind of colour vision: J. Nunez, C. Anderton, R. Renslow, "Optimizing colormaps with
/// consideration for color vision deficiency", PLOS ONE 13(7), 2018.
vtkSmartPointer<vtkImageData> DifferencePicture(vtkImageData* floatPicture, vtkImageData* truth);

/// Height of the scale that DrawDifferenceScale draws [pixels].
constexpr int DifferenceScaleHeight = 56;

/// Draws the colour scale of difference images with its labels.
void DrawDifferenceScale(Canvas& canvas, int left, int bottom, int width);

/// Appends the colour scale below a difference image.
vtkSmartPointer<vtkImageData> WithDifferenceScale(vtkImageData* differencePicture);

/// One renderer's column of a comparison sheet. All images of a sheet have the same size.
struct SheetColumn
{
  std::string title;
  std::string subtitle;
  vtkSmartPointer<vtkImageData> picture;    ///< byte image
  vtkSmartPointer<vtkImageData> difference; ///< see DifferencePicture.h; null for the reference
};

/// Draws the columns side by side: titles, rendered images, and below them the difference images.
/// The colour scale of the differences stands below the reference.
vtkSmartPointer<vtkImageData> ComparisonSheet(const std::vector<SheetColumn>& columns);

/// A byte image on which other images and text are drawn. Positions are in pixels from the lower
/// left corner; whatever lies outside the canvas is clipped.
class Canvas
{
public:
  using Rgb = std::array<unsigned char, 3>;

  Canvas(int width, int height, const Rgb& background);

  void Put(vtkImageData* bytePicture, int left, int bottom);
  void SetPixel(int x, int y, const Rgb& color);

  enum class Anchor
  {
    Left,
    Middle,
    Right,
  };

  /// Draws one line of text with its baseline near `bottom`. The anchor says whether x is its left
  /// end, its middle or its right end. Long lines are not broken.
  void Write(const std::string& text, int x, int bottom, int fontSize, Anchor anchor);

  vtkImageData* Picture() { return this->picture; }

private:
  void BlendPixel(int x, int y, const unsigned char* rgba);

  vtkSmartPointer<vtkImageData> picture;
};

}

#endif
