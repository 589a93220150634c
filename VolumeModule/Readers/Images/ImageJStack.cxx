#include "Readers/FileError.h"
#include "Readers/Images/TiffDescription.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Times.h"

#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace varimarch
{
namespace
{

/// A number above 0 of the description; 1 if it is missing.
std::size_t Count(const std::string& path, const HeaderFields& fields, const std::string& key)
{
  const std::string value = fields.Value({ key });
  const std::int64_t count = value.empty() ? 1 : IntegerFromText(path, "a number as " + key, value);
  if (count < 1 || count > 100000000)
  {
    FailToRead(path, "1 to 100000000 as " + key, std::to_string(count));
  }
  return std::size_t(count);
}

/// The map from stored values to those that ImageJ shows. Of its functions only the straight line
/// is applied; others are named.
Rescale CalibrationOf(
  const HeaderFields& fields, int scalarType, std::vector<std::string>& warnings)
{
  constexpr int StraightLine = 0;
  constexpr int None = 20;
  const auto number = int(NumberIn(fields.Value({ "cf" })).value_or(None));
  const std::optional<double> intercept = NumberIn(fields.Value({ "c0" }));
  const std::optional<double> slope = NumberIn(fields.Value({ "c1" }));
  if (number == None)
  {
    return {};
  }
  if (number != StraightLine || !intercept || !slope || *slope == 0.0)
  {
    warnings.push_back("The file maps its values by ImageJ's function number " +
      std::to_string(number) +
      ", of which only straight lines (0) are known; the stored values were read.");
    return {};
  }
  if (fields.Value({ "zeroclip" }) == "true")
  {
    warnings.push_back(
      "ImageJ shows values below 0 as 0 (zeroclip in the file); they were left as they are.");
  }
  // ImageJ keeps signed shorts as unsigned ones, to which it adds 32768, and maps these.
  constexpr double SignedOffset = 32768.0;
  return { *slope, *intercept + (scalarType == VTK_SHORT ? SignedOffset * *slope : 0.0) };
}

/// Length of the unit [mm]; 0 if it is no length. ImageJ writes the letter mu as an escape.
double LengthOfUnit(
  const HeaderFields& fields, const TiffPage& page, std::vector<std::string>& warnings)
{
  const std::string unit = fields.Value({ "unit" });
  if (unit == "\\u00B5m" || unit == "\\u00b5m")
  {
    return 1e-3;
  }
  const bool isNoLength = unit.empty() || unit == "pixel" || unit == "pixels";
  return isNoLength ? page.mmPerUnit : MmPerUnitOrWarn(unit, warnings);
}

std::array<double, 3> SpacingOf(const std::string& path, const HeaderFields& fields,
  const TiffPage& page, std::vector<std::string>& warnings)
{
  const double mmPerUnit = LengthOfUnit(fields, page, warnings);
  const std::string distance = fields.Value({ "spacing" });
  std::array<double, 3> spacingMm = { 0.0, 0.0,
    distance.empty()
      ? mmPerUnit
      : mmPerUnit * std::abs(NumberFromText(path, "a number as spacing", distance)) };
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double pixels = page.pixelsPerUnit[axis];
    spacingMm[axis] = pixels > 0.0 ? mmPerUnit / pixels : 0.0;
  }
  return spacingMm;
}

/// The lines of a description.
HeaderFields FieldsOf(const std::string& description)
{
  HeaderFields fields;
  std::istringstream lines(description);
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos)
    {
      fields.Set(Trimmed(line.substr(0, equals)), Trimmed(line.substr(equals + 1)));
    }
  }
  return fields;
}

/// The times of frames, between which ImageJ may state an interval.
VolumeTimes TimesOf(const std::string& path, const HeaderFields& fields, std::size_t count)
{
  const std::string interval = fields.Value({ "finterval" });
  const std::string unit = fields.Value({ "tunit" });
  const double seconds = interval.empty()
    ? 0.0
    : NumberFromText(path, "a number as finterval", interval) *
      SecondsPerUnit(unit.empty() ? "s" : unit);
  return EvenTimes(std::int64_t(count), 0.0, seconds);
}

}

std::optional<TiffStack> ImageJStack(TiffFile& file, std::int64_t time)
{
  if (file.Description().compare(0, 7, "ImageJ=") != 0)
  {
    return std::nullopt;
  }
  const HeaderFields fields = FieldsOf(file.Description());
  TiffStack stack;
  const std::string& path = file.Path();
  const std::size_t imageCount = Count(path, fields, "images");
  stack.channelCount = Count(path, fields, "channels");
  // Without further numbers all images are slices.
  const bool hasSlices = fields.Has("slices") || fields.Has("channels") || fields.Has("frames");
  const std::size_t sliceCount = hasSlices ? Count(path, fields, "slices") : imageCount;
  if (sliceCount * stack.channelCount > imageCount)
  {
    FailToRead(path, std::to_string(sliceCount * stack.channelCount) + " images for all slices",
      std::to_string(imageCount));
  }
  const std::size_t pagesOfTime = sliceCount * stack.channelCount;
  const std::size_t timeCount = std::min(Count(path, fields, "frames"), imageCount / pagesOfTime);
  stack.times = TimesOf(path, fields, timeCount);
  if (file.Pages().size() == 1 && imageCount > 1)
  {
    file.AddPagesBehindFirst(imageCount - 1);
  }
  const auto last = std::int64_t(stack.times.values.size()) - 1;
  const std::size_t first = std::size_t(std::clamp<std::int64_t>(time, 0, last)) * pagesOfTime;
  for (std::size_t page = first; page < first + pagesOfTime; ++page)
  {
    stack.planes.push_back({ path, page });
  }
  const TiffPage& page = file.Pages().front();
  stack.spacingMm = SpacingOf(path, fields, page, stack.warnings);
  if (page.layout.componentCount == 1)
  {
    stack.rescale = CalibrationOf(fields, page.layout.scalarType, stack.warnings);
  }
  return stack;
}

}
