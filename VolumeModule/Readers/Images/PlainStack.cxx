#include "Readers/FileError.h"
#include "Readers/Images/TiffDescription.h"

namespace varimarch
{

TiffStack PlainStack(const TiffFile& file)
{
  // Pages of the same layout are slices; thumbnails and scout images have another one.
  std::vector<VoxelLayout> layouts;
  std::vector<std::size_t> numbers;
  for (std::size_t page = 0; page < file.Pages().size(); ++page)
  {
    if (!file.Pages()[page].isReduced)
    {
      layouts.push_back(file.Pages()[page].layout);
      numbers.push_back(page);
    }
  }
  if (layouts.empty())
  {
    FailToRead(file.Path(), "pages of full size", "only thumbnails");
  }
  const VoxelLayout& usual = layouts[MostFrequent(layouts)];
  TiffStack stack;
  std::string others;
  for (std::size_t i = 0; i < layouts.size(); ++i)
  {
    if (IsSame(layouts[i], usual))
    {
      stack.planes.push_back({ file.Path(), numbers[i] });
    }
    else
    {
      others += (others.empty() ? "" : ", ") + std::to_string(numbers[i] + 1);
    }
  }
  if (!others.empty())
  {
    stack.warnings.push_back(
      "Pages of another size or type than most were left out: " + others + ".");
  }
  const std::array<double, 2> spacingMm = PixelSpacingMm(file.Pages()[stack.planes[0].page]);
  stack.spacingMm = { spacingMm[0], spacingMm[1], 0.0 };
  return stack;
}

}
