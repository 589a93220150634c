#include "Viewer/View/VtkPictures.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace varimarch
{

QImage ImageOfBytes(vtkImageData* picture)
{
  const int* const size = picture->GetDimensions();
  return QImage(static_cast<const uchar*>(picture->GetScalarPointer()), size[0], size[1],
    3 * size[0], QImage::Format_RGB888)
    .mirrored();
}

QImage ImageOfFloats(vtkImageData* picture)
{
  const int* const size = picture->GetDimensions();
  QImage image(size[0], size[1], QImage::Format_ARGB32_Premultiplied);
  const auto* rgba = static_cast<const float*>(picture->GetScalarPointer());
  const auto byteOf = [](float channel)
  { return int(std::lround(255.0F * std::clamp(channel, 0.0F, 1.0F))); };
  for (int row = size[1] - 1; row >= 0; --row)
  {
    auto* const pixels = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < size[0]; ++column, rgba += 4)
    {
      pixels[column] = qRgba(byteOf(rgba[0]), byteOf(rgba[1]), byteOf(rgba[2]), byteOf(rgba[3]));
    }
  }
  return image;
}

vtkSmartPointer<vtkImageData> BytesOfImage(const QImage& image)
{
  const QImage bytes = image.convertToFormat(
    image.hasAlphaChannel() ? QImage::Format_RGBA8888 : QImage::Format_RGB888);
  const int componentCount = bytes.depth() / 8;
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(bytes.width(), bytes.height(), 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, componentCount);
  for (int row = 0; row < bytes.height(); ++row)
  {
    std::memcpy(picture->GetScalarPointer(0, bytes.height() - 1 - row, 0), bytes.constScanLine(row),
      std::size_t(componentCount) * bytes.width());
  }
  return picture;
}

}
