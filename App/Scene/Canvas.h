#ifndef Varimarch_Scene_Canvas_h
#define Varimarch_Scene_Canvas_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

namespace varimarch
{

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
