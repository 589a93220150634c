#include "Scene/DifferencePicture.h"

#include "Scene/Canvas.h"

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

}
