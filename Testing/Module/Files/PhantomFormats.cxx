#include "PhantomFormats.h"
#include "PhantomText.h"

#include <vtkByteSwap.h>
#include <vtkSetGet.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <map>

namespace
{

/// The bytes of numbers of one type.
template <class Number>
std::string Bytes(const std::vector<double>& numbers, bool bigEndian)
{
  std::string bytes;
  for (const double number : numbers)
  {
    auto value = Number(number);
    if (bigEndian)
    {
      vtkByteSwap::SwapVoidRange(&value, 1, sizeof(value));
    }
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  return bytes;
}

glm::dvec3 InRas(const glm::dvec3& lps)
{
  return { -lps.x, -lps.y, lps.z };
}

glm::dvec3 Half(const StoredVolume& volume)
{
  return { 0.5 * volume.dimensions[0], 0.5 * volume.dimensions[1], 0.5 * volume.dimensions[2] };
}

}

std::string MghBytes(const StoredVolume& volume)
{
  const std::map<int, int> codes = { { VTK_UNSIGNED_CHAR, 0 }, { VTK_INT, 1 }, { VTK_FLOAT, 3 },
    { VTK_SHORT, 4 }, { VTK_UNSIGNED_SHORT, 10 } };
  const auto& size = volume.dimensions;
  std::string bytes = Bytes<int>({ 1.0, double(size[0]), double(size[1]), double(size[2]), 1.0,
                                   double(codes.at(volume.scalarType)), 0.0 },
    true);
  bytes += Bytes<short>({ 1.0 }, true);
  std::vector<double> numbers;
  for (int axis = 0; axis < 3; ++axis)
  {
    numbers.push_back(glm::length(volume.axesMm[axis]));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 direction = glm::normalize(InRas(volume.axesMm[axis]));
    numbers.insert(numbers.end(), { direction.x, direction.y, direction.z });
  }
  const glm::dvec3 centre = InRas(volume.originMm + volume.axesMm * Half(volume));
  numbers.insert(numbers.end(), { centre.x, centre.y, centre.z });
  bytes += Bytes<float>(numbers, true);
  bytes.resize(284);
  return bytes + VoxelBytes(volume, true);
}

std::string AfniHeaderText(const StoredVolume& volume, bool bigEndian)
{
  const std::map<int, int> codes = { { VTK_UNSIGNED_CHAR, 0 }, { VTK_SHORT, 1 }, { VTK_INT, 2 },
    { VTK_FLOAT, 3 }, { VTK_DOUBLE, 4 } };
  const auto attribute = [](const char* type, const char* name, int count, const std::string& value)
  {
    return Text(
      "\ntype  = ", type, "-attribute\nname  = ", name, "\ncount = ", count, '\n', value, '\n');
  };
  std::string matrix;
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      matrix += Text(' ', volume.axesMm[axis][row]);
    }
    matrix += Text(' ', volume.originMm[row], '\n');
  }
  const auto& size = volume.dimensions;
  return attribute("string", "TYPESTRING", 15, "'3DIM_HEAD_ANAT~") +
    attribute("integer", "DATASET_RANK", 2, " 3 1") +
    attribute("integer", "DATASET_DIMENSIONS", 3, Text(' ', size[0], ' ', size[1], ' ', size[2])) +
    attribute("integer", "BRICK_TYPES", 1, Text(' ', codes.at(volume.scalarType))) +
    attribute("float", "BRICK_FLOAT_FACS", 1, " 0") +
    attribute("string", "BYTEORDER_STRING", 10, bigEndian ? "'MSB_FIRST~" : "'LSB_FIRST~") +
    attribute("float", "IJK_TO_DICOM_REAL", 12, matrix);
}

std::string MifHeaderText(const StoredVolume& volume, const std::array<int, 3>& places,
  const std::array<bool, 3>& isBackwards)
{
  const std::map<int, std::string> types = { { VTK_SIGNED_CHAR, "Int8" },
    { VTK_UNSIGNED_CHAR, "UInt8" }, { VTK_SHORT, "Int16LE" }, { VTK_UNSIGNED_SHORT, "UInt16LE" },
    { VTK_INT, "Int32LE" }, { VTK_UNSIGNED_INT, "UInt32LE" }, { VTK_FLOAT, "Float32LE" },
    { VTK_DOUBLE, "Float64LE" } };
  std::string sizes;
  std::string spacing;
  std::string layout;
  glm::dvec3 origin = volume.originMm;
  glm::dmat3 direction;
  for (int axis = 0; axis < 3; ++axis)
  {
    const char* const comma = axis ? "," : "";
    const int place = places[axis];
    const int size = volume.dimensions[place];
    const glm::dvec3 step = volume.axesMm[place] * (isBackwards[axis] ? -1.0 : 1.0);
    sizes += Text(comma, size);
    spacing += Text(comma, glm::length(step));
    layout += Text(comma, isBackwards[axis] ? '-' : '+', place);
    direction[axis] = glm::normalize(step);
    origin -= isBackwards[axis] ? step * double(size - 1) : glm::dvec3(0.0);
  }
  std::string transform;
  for (int row = 0; row < 3; ++row)
  {
    const double sign = row < 2 ? -1.0 : 1.0;
    transform += Text("transform: ", sign * direction[0][row], ", ", sign * direction[1][row], ", ",
      sign * direction[2][row], ", ", sign * origin[row], '\n');
  }
  const std::string text = "mrtrix image\ndim: " + sizes + "\nvox: " + spacing +
    "\nlayout: " + layout + "\ndatatype: " + types.at(volume.scalarType) + "\n" + transform;
  // The offset is a multiple of 4, behind the header.
  return (text + "file: . 1024\nEND\n").append(1024 - text.size() - 17, '\0');
}

std::string GiplBytes(const StoredVolume& volume)
{
  const std::map<int, int> codes = { { VTK_SIGNED_CHAR, 7 }, { VTK_UNSIGNED_CHAR, 8 },
    { VTK_SHORT, 15 }, { VTK_UNSIGNED_SHORT, 16 }, { VTK_UNSIGNED_INT, 31 }, { VTK_INT, 32 },
    { VTK_FLOAT, 64 }, { VTK_DOUBLE, 65 } };
  const auto& size = volume.dimensions;
  std::string bytes = Bytes<unsigned short>(
    { double(size[0]), double(size[1]), double(size[2]), 1.0, double(codes.at(volume.scalarType)) },
    true);
  bytes += Bytes<float>({ glm::length(volume.axesMm[0]), glm::length(volume.axesMm[1]),
                          glm::length(volume.axesMm[2]), 0.0 },
    true);
  bytes.resize(204);
  bytes += Bytes<double>({ volume.originMm.x, volume.originMm.y, volume.originMm.z, 0.0 }, true);
  bytes.resize(252);
  return bytes + Bytes<unsigned int>({ 4026526128.0 }, true) + VoxelBytes(volume, true);
}

std::string MrcBytes(const StoredVolume& volume, bool bigEndian)
{
  const std::map<int, int> modes = { { VTK_SIGNED_CHAR, 0 }, { VTK_SHORT, 1 }, { VTK_FLOAT, 2 },
    { VTK_UNSIGNED_SHORT, 6 } };
  std::vector<double> sizes;
  std::vector<double> intervals(3);
  std::vector<double> lengths(3);
  std::vector<double> map;
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3& step = volume.axesMm[axis];
    const glm::dvec3 size = glm::abs(step);
    const int world = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    sizes.push_back(volume.dimensions[axis]);
    intervals[world] = volume.dimensions[axis];
    lengths[world] = glm::length(step) * volume.dimensions[axis] * 1e7;
    map.push_back(world + 1);
  }
  std::string bytes = Bytes<int>(sizes, bigEndian) +
    Bytes<int>({ double(modes.at(volume.scalarType)), 0.0, 0.0, 0.0 }, bigEndian) +
    Bytes<int>(intervals, bigEndian) + Bytes<float>(lengths, bigEndian) +
    Bytes<float>({ 90.0, 90.0, 90.0 }, bigEndian) + Bytes<int>(map, bigEndian);
  bytes.resize(92);
  bytes += Bytes<int>({ 80.0 }, bigEndian);
  bytes.resize(196);
  const glm::dvec3 origin = volume.originMm * 1e7;
  bytes += Bytes<float>({ origin.x, origin.y, origin.z }, bigEndian) + "MAP ";
  bytes.resize(1024 + 80);
  return bytes + VoxelBytes(volume, bigEndian);
}

std::string NpyBytes(
  const StoredVolume& volume, const std::vector<int>& shape, bool isFortran, bool bigEndian)
{
  const std::map<int, std::string> types = { { VTK_SIGNED_CHAR, "i1" }, { VTK_UNSIGNED_CHAR, "u1" },
    { VTK_SHORT, "i2" }, { VTK_UNSIGNED_SHORT, "u2" }, { VTK_INT, "i4" },
    { VTK_UNSIGNED_INT, "u4" }, { VTK_FLOAT, "f4" }, { VTK_DOUBLE, "f8" } };
  std::string text = Text("{'descr': '", bigEndian ? '>' : '<', types.at(volume.scalarType),
    "', 'fortran_order': ", isFortran ? "True" : "False", ", 'shape': (");
  for (const int size : shape)
  {
    text += Text(size, ", ");
  }
  text += "), }";
  text.resize(117, ' ');
  return std::string("\x93NUMPY\x01\x00", 8) + Bytes<unsigned short>({ 118.0 }, false) + text +
    '\n' + VoxelBytes(volume, bigEndian);
}

std::string SlcBytes(const StoredVolume& volume, bool isEncoded)
{
  const auto& size = volume.dimensions;
  std::string bytes = Text("11111\n", size[0], ' ', size[1], ' ', size[2], " 8\n",
    glm::length(volume.axesMm[0]), ' ', glm::length(volume.axesMm[1]), ' ',
    glm::length(volume.axesMm[2]), "\n1 0 0 ", isEncoded ? 1 : 0, "\n2 1 X", "iconXX");
  const std::string voxels = VoxelBytes(volume);
  const std::size_t sliceBytes = std::size_t(size[0] * size[1]);
  for (std::size_t slice = 0; slice < std::size_t(size[2]); ++slice)
  {
    const std::string values = voxels.substr(slice * sliceBytes, sliceBytes);
    // The first three values are a run of literals, the others are runs of one.
    std::string code = char(0x83) + values.substr(0, 3);
    for (std::size_t i = 3; i < sliceBytes; ++i)
    {
      code += std::string("\x01") + values[i];
    }
    code += std::string(1, '\0');
    bytes += isEncoded ? Text(code.size(), " X") + code : values;
  }
  return bytes;
}

std::string PvmBytes(const StoredVolume& volume)
{
  const auto& size = volume.dimensions;
  const int valueBytes = volume.scalarType == VTK_UNSIGNED_CHAR ? 1 : 2;
  const std::string comments("d\0c\0p\0c\0", 8);
  return Text("PVM3\n", size[0], ' ', size[1], ' ', size[2], '\n', glm::length(volume.axesMm[0]),
           ' ', glm::length(volume.axesMm[1]), ' ', glm::length(volume.axesMm[2]), '\n', valueBytes,
           '\n') +
    VoxelBytes(volume, true) + comments;
}

std::string DdsBytes(const std::string& bytes, int planes, int rowBytes)
{
  std::string separated;
  for (int plane = 0; plane < planes; ++plane)
  {
    for (std::size_t i = std::size_t(plane); i < bytes.size(); i += std::size_t(planes))
    {
      separated += bytes[i];
    }
  }
  std::string bits;
  const auto put = [&](int number, int count)
  {
    for (int bit = count - 1; bit >= 0; --bit)
    {
      bits += (number >> bit & 1) != 0 ? '1' : '0';
    }
  };
  put(planes - 1, 2);
  put(rowBytes - 1, 16);
  const auto at = [&](std::size_t i) { return int(static_cast<unsigned char>(separated[i])); };
  for (std::size_t i = 0; i < separated.size(); ++i)
  {
    if (i % 100 == 0)
    {
      put(int(std::min<std::size_t>(100, separated.size() - i)), 7);
      put(7, 3); // differences of 8 bits
    }
    const auto row = std::size_t(rowBytes);
    int difference = at(i) - (i > 0 ? at(i - 1) : 0);
    difference -= rowBytes > 1 && i > row ? at(i - row) - at(i - row - 1) : 0;
    put((difference + 128) & 255, 8);
  }
  put(0, 7);
  std::string result = "DDS v3d\n";
  bits.resize((bits.size() + 31) / 32 * 32, '0');
  for (std::size_t i = 0; i < bits.size(); i += 8)
  {
    result += char(std::stoi(bits.substr(i, 8), nullptr, 2));
  }
  return result;
}

std::string ParText(const StoredVolume& volume, const std::vector<int>& slices, double stepSeconds)
{
  const auto& size = volume.dimensions;
  const glm::dvec3 centre = volume.originMm +
    volume.axesMm * glm::dvec3(0.5 * (size[0] - 1), 0.5 * (size[1] - 1), 0.5 * (size[2] - 1));
  std::string text = Text("# === DATA DESCRIPTION FILE ====\n"
                          "# CLINICAL TRYOUT             Research image export tool     V4.2\n"
                          ".    Max. number of slices/locations    :   ",
    size[2],
    "\n"
    ".    Angulation midslice(ap,fh,rl)[degr]:   0  0  0\n"
    ".    Off Centre midslice(ap,fh,rl) [mm] :   ",
    centre.y, ' ', centre.z, ' ', centre.x, "\n#\n");
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    text += Text(slices[i] + 1, " 1 1 1 0 2 ", i, " 16 100 ", size[0], ' ', size[1],
      " 0 1 1 100 200 0 0 0 0 0 0 ", glm::length(volume.axesMm[2]), " 0 0 1 0 2 ",
      glm::length(volume.axesMm[0]), ' ', glm::length(volume.axesMm[1]), " 0 ",
      double(i / std::size_t(size[2])) * stepSeconds, " 0 0 1 90 0 0 0 1 0\n");
  }
  return text + "# === END OF DATA DESCRIPTION FILE ====\n";
}
