#include "Readers/SpmMatrix.h"

#include "Readers/ByteStream.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>

namespace varimarch
{
namespace
{

/// The head of a variable in a MATLAB file of version 4 (MAT-File Format, "Level 4").
struct VariableHead
{
  std::int32_t type; ///< 0: little-endian doubles, column by column
  std::int32_t rows;
  std::int32_t columns;
  std::int32_t isComplex;
  std::int32_t nameBytes; ///< with the final zero
};

struct Variable
{
  std::string name;
  std::array<double, 16> numbers; ///< a matrix of 4 x 4, column by column
};

/// The next variable, which must be a real matrix of 4 x 4; nothing for any other.
std::optional<Variable> NextVariable(ByteStream& stream)
{
  VariableHead head = {};
  const bool isMatrix = stream.Read(&head, sizeof(head)) == sizeof(head) && head.type == 0 &&
    head.rows == 4 && head.columns == 4 && head.isComplex == 0 && head.nameBytes > 0 &&
    head.nameBytes < 64;
  if (!isMatrix)
  {
    return std::nullopt;
  }
  Variable variable;
  variable.name.resize(std::size_t(head.nameBytes));
  stream.Read(variable.name.data(), variable.name.size());
  variable.name.pop_back();
  const std::size_t byteCount = sizeof(variable.numbers);
  return stream.Read(variable.numbers.data(), byteCount) == byteCount ? std::optional(variable)
                                                                      : std::nullopt;
}

ImageGeometry GeometryOf(const Variable& variable)
{
  const auto at = [&](int row, int column)
  { return variable.numbers[std::size_t(4 * column + row)]; };
  // "mat" has all in it, "M" leaves out that the first axis points to the patient's left.
  const glm::dvec3 signs(variable.name == "M" ? -1.0 : 1.0, 1.0, 1.0);
  ImageGeometry geometry;
  for (int row = 0; row < 3; ++row)
  {
    geometry.originMm[row] = at(row, 3);
    for (int axis = 0; axis < 3; ++axis)
    {
      geometry.axesMm[axis][row] = at(row, axis);
      geometry.originMm[row] += at(row, axis);
    }
  }
  return InLps(geometry, signs, 1.0);
}

}

std::optional<ImageGeometry> SpmMatrixBeside(
  const std::string& headerPath, std::vector<std::string>& warnings)
{
  const std::filesystem::path path = std::filesystem::path(headerPath).replace_extension(".mat");
  if (!std::filesystem::is_regular_file(path))
  {
    return std::nullopt;
  }
  const auto stream = OpenStream(path.string(), Compression::None);
  std::optional<ImageGeometry> geometry;
  for (auto variable = NextVariable(*stream); variable; variable = NextVariable(*stream))
  {
    const bool isBest = variable->name == "mat";
    if (isBest || (variable->name == "M" && !geometry))
    {
      geometry = GeometryOf(*variable);
    }
    if (isBest)
    {
      break;
    }
  }
  if (!geometry)
  {
    warnings.push_back("The file " + path.filename().string() +
      " beside the header has no matrix in the way of SPM99, and was not used.");
  }
  return geometry;
}

}
