#include "Scene/Canvas.h"

#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>

namespace varimarch
{

Canvas::Canvas(int width, int height, const Rgb& background)
  : picture(vtkSmartPointer<vtkImageData>::New())
{
  this->picture->SetDimensions(width, height, 1);
  this->picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      this->SetPixel(x, y, background);
    }
  }
}

void Canvas::SetPixel(int x, int y, const Rgb& color)
{
  const int* size = this->picture->GetDimensions();
  if (x >= 0 && y >= 0 && x < size[0] && y < size[1])
  {
    std::copy(color.begin(), color.end(),
      static_cast<unsigned char*>(this->picture->GetScalarPointer(x, y, 0)));
  }
}

void Canvas::BlendPixel(int x, int y, const unsigned char* rgba)
{
  const int* size = this->picture->GetDimensions();
  if (x < 0 || y < 0 || x >= size[0] || y >= size[1])
  {
    return;
  }
  auto* pixel = static_cast<unsigned char*>(this->picture->GetScalarPointer(x, y, 0));
  for (int channel = 0; channel < 3; ++channel)
  {
    const int mixed = rgba[channel] * rgba[3] + pixel[channel] * (255 - rgba[3]);
    pixel[channel] = static_cast<unsigned char>((mixed + 127) / 255);
  }
}

void Canvas::Put(vtkImageData* bytePicture, int left, int bottom)
{
  const int* size = bytePicture->GetDimensions();
  const auto* rgb = static_cast<const unsigned char*>(bytePicture->GetScalarPointer());
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x, rgb += 3)
    {
      this->SetPixel(left + x, bottom + y, { rgb[0], rgb[1], rgb[2] });
    }
  }
}

void Canvas::Write(const std::string& text, int x, int bottom, int fontSize, Anchor anchor)
{
  constexpr int PointsPerInch = 72; // makes the font size a number of pixels
  vtkNew<vtkTextProperty> font;
  font->SetFontFamilyToArial();
  font->SetFontSize(fontSize);
  font->SetColor(0.1, 0.1, 0.1);
  const auto words = vtkSmartPointer<vtkImageData>::New();
  int size[2];
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (!renderer->RenderString(
        font, vtkStdString(text), words, size, PointsPerInch, vtkTextRenderer::FreeType))
  {
    return;
  }
  const int shift = anchor == Anchor::Left ? 0 : anchor == Anchor::Middle ? size[0] / 2 : size[0];
  for (int row = 0; row < size[1]; ++row)
  {
    for (int column = 0; column < size[0]; ++column)
    {
      const int* extent = words->GetExtent();
      const auto* rgba = static_cast<unsigned char*>(
        words->GetScalarPointer(extent[0] + column, extent[2] + row, 0));
      this->BlendPixel(x - shift + column, bottom + row, rgba);
    }
  }
}

}
