#ifndef Varimarch_Scene_Canvas_h
#define Varimarch_Scene_Canvas_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string>

namespace varimarch
{

/// A byte picture to put pictures and words on. Positions are in pixels from the lower left
/// corner; what lies outside is cut off.
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

  /// One line whose baseline is about at `bottom`, and whose left end, middle or right end is at x.
  /// Too long a line is not broken.
  void Write(const std::string& text, int x, int bottom, int fontSize, Anchor anchor);

  vtkImageData* Picture() { return this->picture; }

private:
  void BlendPixel(int x, int y, const unsigned char* rgba);

  vtkSmartPointer<vtkImageData> picture;
};

}

#endif
