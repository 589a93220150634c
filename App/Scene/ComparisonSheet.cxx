#include "Scene/ComparisonSheet.h"

#include "Scene/Canvas.h"
#include "Scene/DifferencePicture.h"

#include <algorithm>

namespace varimarch
{

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

}
