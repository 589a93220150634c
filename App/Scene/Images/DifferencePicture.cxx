#include "Scene/Images/DifferencePicture.h"

#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

constexpr double Darkest = 0.1; // in 1/255
constexpr double Decades = 3.0;

// Cividis at five equal steps; linear interpolation between them is close enough.
constexpr std::array<std::array<double, 3>, 5> Cividis = { { { 0, 34, 78 }, { 65, 77, 107 },
  { 124, 123, 120 }, { 188, 175, 111 }, { 254, 232, 56 } } };

// Colour at a position on the scale, from 0 to 1.
Canvas::Rgb ScaleColor(double position)
{
  const double scaled = std::clamp(position, 0.0, 1.0) * (Cividis.size() - 1);
  const std::size_t lower = std::min(std::size_t(scaled), Cividis.size() - 2);
  Canvas::Rgb color;
  for (int channel = 0; channel < 3; ++channel)
  {
    const double mixed = Cividis[lower][channel] +
      (scaled - lower) * (Cividis[lower + 1][channel] - Cividis[lower][channel]);
    color[channel] = static_cast<unsigned char>(std::lround(mixed));
  }
  return color;
}

}

vtkSmartPointer<vtkImageData> DifferencePicture(vtkImageData* floatPicture, vtkImageData* truth)
{
  const int* size = floatPicture->GetDimensions();
  Canvas canvas(size[0], size[1], {});
  const auto* rgba = static_cast<const float*>(floatPicture->GetScalarPointer());
  const auto* right = static_cast<const float*>(truth->GetScalarPointer());
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      double largest = 0.0;
      for (int channel = 0; channel < 4; ++channel)
      {
        largest = std::max(largest, std::abs(double(*rgba++) - *right++));
      }
      const double position = std::log10(std::max(255.0 * largest, Darkest) / Darkest) / Decades;
      canvas.SetPixel(x, y, ScaleColor(position));
    }
  }
  return canvas.Picture();
}

void DrawDifferenceScale(Canvas& canvas, int left, int bottom, int width)
{
  constexpr int Margin = 20;
  constexpr int FontSize = 13;
  const int length = std::max(width - 2 * Margin, 1);
  for (int x = 0; x < length; ++x)
  {
    for (int y = 22; y < 34; ++y)
    {
      canvas.SetPixel(left + Margin + x, bottom + y, ScaleColor(double(x) / length));
    }
  }
  const std::array<const char*, 4> labels = { "≤ 0.1", "1", "10", "≥ 100" };
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const auto anchor = i == 0 ? Canvas::Anchor::Left
      : i + 1 == labels.size() ? Canvas::Anchor::Right
                               : Canvas::Anchor::Middle;
    const int x = left + Margin + int(i * length / (labels.size() - 1));
    canvas.Write(labels[i], x, bottom + 4, FontSize, anchor);
  }
  canvas.Write("largest difference of a channel, in 1/255", left + width / 2, bottom + 38, FontSize,
    Canvas::Anchor::Middle);
}

vtkSmartPointer<vtkImageData> WithDifferenceScale(vtkImageData* differencePicture)
{
  const int* size = differencePicture->GetDimensions();
  Canvas canvas(size[0], size[1] + DifferenceScaleHeight, { 255, 255, 255 });
  canvas.Put(differencePicture, 0, DifferenceScaleHeight);
  DrawDifferenceScale(canvas, 0, 0, size[0]);
  return canvas.Picture();
}

vtkSmartPointer<vtkImageData> ComparisonSheet(const std::vector<SheetColumn>& columns)
{
  constexpr int Gap = 8;
  constexpr int TitleHeight = 48;
  constexpr int NarrowestColumn = 340; // so that the texts fit
  const int* size = columns.front().picture->GetDimensions();
  const int columnWidth = std::max(size[0], NarrowestColumn);
  const int width = Gap + int(columns.size()) * (columnWidth + Gap);
  const int lowerRow = std::max(size[1], DifferenceScaleHeight);
  const int height = 3 * Gap + TitleHeight + size[1] + lowerRow;

  Canvas canvas(width, height, { 255, 255, 255 });
  int left = Gap;
  for (const SheetColumn& column : columns)
  {
    const int middle = left + columnWidth / 2;
    canvas.Write(column.title, middle, height - 24, 16, Canvas::Anchor::Middle);
    canvas.Write(column.subtitle, middle, height - 44, 13, Canvas::Anchor::Middle);
    canvas.Put(column.picture, middle - size[0] / 2, 2 * Gap + lowerRow);
    if (column.difference)
    {
      canvas.Put(column.difference, middle - size[0] / 2, Gap);
    }
    else
    {
      DrawDifferenceScale(canvas, left, Gap + (lowerRow - DifferenceScaleHeight) / 2, columnWidth);
    }
    left += columnWidth + Gap;
  }
  return canvas.Picture();
}

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
