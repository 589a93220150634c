#include "Readers/Dicom/SeriesWindow.h"

#include "Readers/Dicom/Metadata.h"

#include <algorithm>
#include <cmath>

namespace varimarch
{

namespace
{

/// The window of a frame, in its values.
std::optional<WindowLevel> WindowOf(const DicomFrame& frame)
{
  std::optional<WindowLevel> window = MetadataOf(frame.file->path, frame.number).windowLevel;
  if (window && frame.isRealWorld)
  {
    // The file recommends values that its real-world map has not been applied to.
    window->window *= std::abs(frame.slope);
    window->level = frame.slope * window->level + frame.intercept;
  }
  return window;
}

/// Windows of images spread over a series, since each costs reading a header.
std::vector<WindowLevel> SomeWindows(const std::vector<DicomFrame>& frames)
{
  constexpr std::size_t Most = 9;
  const std::size_t count = std::min(frames.size(), Most);
  std::vector<WindowLevel> windows;
  for (std::size_t i = 0; i < count; ++i)
  {
    const DicomFrame& frame = frames[count > 1 ? i * (frames.size() - 1) / (count - 1) : 0];
    if (const auto window = WindowOf(frame))
    {
      windows.push_back(*window);
    }
  }
  return windows;
}

template <class Member>
double MedianOf(std::vector<WindowLevel> windows, const Member& member)
{
  const auto middle = windows.begin() + windows.size() / 2;
  std::nth_element(windows.begin(), middle, windows.end(),
    [&](const WindowLevel& a, const WindowLevel& b) { return a.*member < b.*member; });
  return (*middle).*member;
}

}

std::optional<WindowLevel> WindowOfSeries(const std::vector<DicomFrame>& frames)
{
  constexpr double MostRatio = 2.0; // between two widths
  constexpr double MostShift = 0.5; // distance of two levels, in widths
  const std::vector<WindowLevel> windows = SomeWindows(frames);
  if (windows.empty())
  {
    return std::nullopt;
  }
  const WindowLevel median = { MedianOf(windows, &WindowLevel::window),
    MedianOf(windows, &WindowLevel::level) };
  const bool agree = std::all_of(windows.begin(), windows.end(),
    [&](const WindowLevel& one)
    {
      const double ratio = one.window / median.window;
      return ratio <= MostRatio && ratio >= 1.0 / MostRatio &&
        std::abs(one.level - median.level) <= MostShift * median.window;
    });
  return agree ? std::optional(median) : std::nullopt;
}

}
