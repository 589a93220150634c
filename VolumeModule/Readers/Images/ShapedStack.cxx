// TIFF as the Python package tifffile writes it: a description in JSON names the axes of the array
// whose pages the file holds. See https://pypi.org/project/tifffile
#include "Readers/FileError.h"
#include "Readers/Images/TiffDescription.h"
#include "Readers/Pyramids/Json.h"
#include "Readers/Times.h"

#include <algorithm>
#include <map>

namespace varimarch
{
namespace
{

/// An axis along which pages follow each other.
struct PageAxis
{
  char letter;
  std::int64_t size;
};

/// Makes components pages if they are an axis of another meaning. Before 2024 tifffile took arrays
/// of three or four slices for colours in planes of their own, unless it was told otherwise.
void SplitPlaces(const std::string& letters, const std::vector<double>& shape, TiffFile& file)
{
  const std::size_t count = letters.size();
  const auto components = double(file.Pages().front().layout.componentCount);
  const bool arePlaces = count >= 3 && shape.size() == count && components > 1.0 &&
    letters.compare(count - 2, 2, "YX") == 0 && letters[count - 3] != 'S' &&
    letters[count - 3] != 'C' && shape[count - 3] == components;
  if (arePlaces)
  {
    file.SplitSamples();
  }
}

/// The axes along which pages follow each other, slowest first; none if the description does not
/// fit the pages.
std::optional<std::vector<PageAxis>> PageAxes(
  const std::string& letters, const std::vector<double>& shape, const VoxelLayout& page)
{
  const std::size_t y = letters.find('Y');
  const std::size_t x = letters.find('X');
  const bool fits = letters.size() == shape.size() && y != std::string::npos && x == y + 1 &&
    shape[y] == double(page.dimensions[1]) && shape[x] == double(page.dimensions[0]);
  if (!fits)
  {
    return std::nullopt;
  }
  constexpr double MostAlong = 1e7;
  std::vector<PageAxis> axes;
  for (std::size_t i = 0; i < y; ++i)
  {
    // Colours in planes of their own are samples of one page; others follow behind X.
    const bool isInPage = i + 1 == y && x + 1 == letters.size() && page.componentCount > 1 &&
      shape[i] == double(page.componentCount);
    if (!(shape[i] >= 1.0 && shape[i] <= MostAlong))
    {
      return std::nullopt;
    }
    if (!isInPage)
    {
      axes.push_back({ letters[i], std::int64_t(shape[i]) });
    }
  }
  return axes;
}

/// The number of pages that axes need.
double PageCount(const std::vector<PageAxis>& axes)
{
  double count = 1.0;
  for (const PageAxis& axis : axes)
  {
    count *= double(axis.size);
  }
  return count;
}

/// The letter of the axis that counts slices: Z, or else the last one that means nothing else.
char LetterOfSlices(const std::vector<PageAxis>& axes)
{
  char letter = 'Z';
  const auto is = [&](char wanted)
  {
    return std::any_of(
      axes.begin(), axes.end(), [&](const PageAxis& axis) { return axis.letter == wanted; });
  };
  for (const PageAxis& axis : axes)
  {
    letter = !is('Z') && axis.letter != 'C' && axis.letter != 'T' ? axis.letter : letter;
  }
  return letter;
}

/// The stack of one time, at the first place along other axes than those of slices and channels.
TiffStack StackOf(const std::string& path, const std::vector<PageAxis>& axes, std::int64_t time)
{
  const char slices = LetterOfSlices(axes);
  std::map<char, std::int64_t> sizes = { { slices, 1 }, { 'C', 1 }, { 'T', 1 } };
  std::map<char, std::int64_t> steps;
  TiffStack stack;
  std::int64_t step = 1;
  for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis)
  {
    const bool isRead = sizes.count(axis->letter) > 0 && steps.count(axis->letter) == 0;
    if (isRead)
    {
      sizes[axis->letter] = axis->size;
      steps[axis->letter] = step;
    }
    else if (axis->size > 1)
    {
      stack.warnings.push_back(std::string("The axis ") + axis->letter + " has " +
        std::to_string(axis->size) + " places; only the first was read.");
    }
    step *= axis->size;
  }
  stack.channelCount = std::size_t(sizes['C']);
  stack.times = NumberedTimes(sizes['T']);
  const std::int64_t t = std::clamp<std::int64_t>(time, 0, sizes['T'] - 1);
  for (std::int64_t z = 0; z < sizes[slices]; ++z)
  {
    for (std::int64_t c = 0; c < sizes['C']; ++c)
    {
      stack.planes.push_back(
        { path, std::size_t(z * steps[slices] + c * steps['C'] + t * steps['T']) });
    }
  }
  return stack;
}

/// The pages as slices, where the axes do not fit them.
TiffStack StackOfUnfitPages(const TiffFile& file, const std::string& letters)
{
  TiffStack stack = PlainStack(file);
  stack.warnings.push_back("The description of the axes " + Quoted(letters) +
    " does not fit the pages, which were read as slices.");
  return stack;
}

}

std::optional<TiffStack> ShapedStack(TiffFile& file, std::int64_t time)
{
  constexpr std::size_t LongestDescription = 1 << 20;
  const std::string& text = file.Description();
  if (text.compare(0, 1, "{") != 0 || text.size() > LongestDescription)
  {
    return std::nullopt;
  }
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  const std::string letters = TextIn(ValueAt(json, "axes"));
  const std::vector<double> shape = NumbersIn(ValueAt(json, "shape"));
  if (letters.empty())
  {
    return std::nullopt;
  }
  SplitPlaces(letters, shape, file);
  const TiffPage first = file.Pages().front();
  const auto axes = PageAxes(letters, shape, first.layout);
  const double count = axes ? PageCount(*axes) : 0.0;
  const bool isOneDirectory = file.Pages().size() == 1;
  const double pages = isOneDirectory
    ? double(ReadableFileSize(file.Path())) / double(CheckedByteCount(file.Path(), first.layout))
    : double(file.Pages().size());
  if (!axes || count > pages)
  {
    return StackOfUnfitPages(file, letters);
  }
  if (isOneDirectory && count > 1.0)
  {
    file.AddPagesBehindFirst(std::size_t(count) - 1);
  }
  TiffStack stack = StackOf(file.Path(), *axes, time);
  const std::array<double, 2> pixelMm = PixelSpacingMm(first);
  stack.spacingMm = { pixelMm[0], pixelMm[1], 0.0 };
  if (count < double(file.Pages().size()))
  {
    stack.warnings.push_back("The file holds " + std::to_string(file.Pages().size()) +
      " pages; only the " + std::to_string(std::size_t(count)) + " of the first array were read.");
  }
  return stack;
}

}
