#include "Results.h"

#include "Scene/Files/OutputFile.h"
#include "Scene/Json/JsonCursor.h"

#include <nlohmann/json.hpp>

#include <iomanip>
#include <sstream>

namespace varimarch
{

nlohmann::ordered_json ResultsOf(const std::string& commandText, const LoadedVolume& volume)
{
  vtkImageData* image = volume.image;
  const int* dimensions = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  nlohmann::ordered_json results;
  results["command"] = commandText;
  results["volume"] = { { "dimensions", { dimensions[0], dimensions[1], dimensions[2] } },
    { "type", image->GetScalarTypeAsString() },
    { "spacingMm", { spacing[0], spacing[1], spacing[2] } }, { "modality", volume.modality },
    { "warnings", volume.warnings } };
  return results;
}

void WriteResults(const nlohmann::ordered_json& results, const std::string& path)
{
  if (!path.empty())
  {
    WriteFileWhole(path, TextFromJson(results));
  }
}

std::string Fixed(double number, int digits)
{
  std::ostringstream stream;
  stream << std::fixed << std::setprecision(digits) << number;
  return stream.str();
}

std::string Triple(const double numbers[3], const std::string& separator)
{
  std::ostringstream stream;
  stream << numbers[0] << separator << numbers[1] << separator << numbers[2];
  return stream.str();
}

}
