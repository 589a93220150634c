// The formats of PhantomFiles.h with binary headers.
#include "PhantomFiles.h"

#include <vtkByteSwap.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>

namespace
{

/// A header of fixed size whose fields are set at their offsets.
class BinaryHeader
{
public:
  BinaryHeader(std::size_t size, bool bigEndian)
    : bytes(size, '\0')
    , bigEndian(bigEndian)
  {
  }

  template <class Value>
  void Put(std::size_t offset, Value value)
  {
    if (this->bigEndian)
    {
      vtkByteSwap::SwapVoidRange(&value, 1, sizeof(value));
    }
    std::memcpy(this->bytes.data() + offset, &value, sizeof(value));
  }

  void PutText(std::size_t offset, const std::string& text)
  {
    this->bytes.replace(offset, text.size(), text);
  }

  const std::string& Bytes() const { return this->bytes; }

private:
  std::string bytes;
  bool bigEndian;
};

std::int16_t NiftiCode(int scalarType)
{
  static const std::map<int, std::int16_t> codes = {
    { VTK_UNSIGNED_CHAR, 2 },
    { VTK_SHORT, 4 },
    { VTK_INT, 8 },
    { VTK_FLOAT, 16 },
    { VTK_DOUBLE, 64 },
    { VTK_SIGNED_CHAR, 256 },
    { VTK_UNSIGNED_SHORT, 512 },
    { VTK_UNSIGNED_INT, 768 },
    { VTK_TYPE_INT64, 1024 },
    { VTK_TYPE_UINT64, 1280 },
  };
  return codes.at(scalarType);
}

/// Offsets from the NIfTI-1 specification, nifti1.h.
void PutNiftiSizes(const StoredVolume& volume, BinaryHeader& header)
{
  header.Put(0, std::int32_t(348));
  header.Put(40, std::int16_t(3));
  for (int axis = 0; axis < 3; ++axis)
  {
    header.Put(42 + 2 * axis, std::int16_t(volume.dimensions[axis]));
    header.Put(80 + 4 * axis, float(glm::length(volume.axesMm[axis])));
  }
  header.Put(70, NiftiCode(volume.scalarType));
  header.Put(108, 352.0f);  // vox_offset
  header.Put(123, char(2)); // xyzt_units: mm
  header.PutText(344, "n+1");
}

/// A DICOM element with a tag and a value, in explicit VR.
std::string Element(
  std::uint16_t group, std::uint16_t element, const std::string& type, std::string value)
{
  if (value.size() % 2 == 1)
  {
    value += type == "UI" ? '\0' : ' ';
  }
  const bool isLong = type == "OB" || type == "OW" || type == "SQ";
  BinaryHeader header(isLong ? 12 : 8, false);
  header.Put(0, group);
  header.Put(2, element);
  header.PutText(4, type);
  if (isLong)
  {
    header.Put(8, std::uint32_t(value.size()));
  }
  else
  {
    header.Put(6, std::uint16_t(value.size()));
  }
  return header.Bytes() + value;
}

template <class Value>
std::string Bytes(Value value)
{
  return std::string(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// Numbers in DICOM's notation of at most 16 characters each.
std::string Decimals(const std::vector<double>& numbers)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(9);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    text << (i ? "\\" : "") << numbers[i];
  }
  return text.str();
}

std::string DicomFileMeta(const std::string& classUid, const std::string& instanceUid)
{
  const std::string meta = Element(2, 1, "OB", std::string("\0\1", 2)) +
    Element(2, 2, "UI", classUid) + Element(2, 3, "UI", instanceUid) +
    Element(2, 0x10, "UI", "1.2.840.10008.1.2.1") + Element(2, 0x12, "UI", "1.2.3.4");
  return std::string(128, '\0') + "DICM" + Element(2, 0, "UL", Bytes(std::uint32_t(meta.size()))) +
    meta;
}

const std::string ctImageStorage = "1.2.840.10008.5.1.4.1.1.2";

/// An entry of an index, with the file offsets of the next entry and of the first one below it.
std::string IndexRecord(std::uint32_t next, std::uint32_t below, const std::string& type,
  const std::string& imageName, const std::string& keys)
{
  const std::string record = Element(4, 0x1400, "UL", Bytes(next)) +
    Element(4, 0x1410, "US", Bytes(std::uint16_t(0xffff))) +
    Element(4, 0x1420, "UL", Bytes(below)) + Element(4, 0x1430, "CS", type) +
    (imageName.empty() ? "" : Element(4, 0x1500, "CS", imageName)) + keys;
  return Bytes(std::uint16_t(0xfffe)) + Bytes(std::uint16_t(0xe000)) +
    Bytes(std::uint32_t(record.size())) + record;
}

}

std::string NiftiBytes(const StoredVolume& volume, NiftiForm form, bool bigEndian)
{
  BinaryHeader header(352, bigEndian);
  PutNiftiSizes(volume, header);
  const glm::dvec3 rasFromLps(-1.0, -1.0, 1.0);
  const glm::dvec3 origin = rasFromLps * volume.originMm;
  glm::dmat3 axes;
  glm::dmat3 turn;
  for (int axis = 0; axis < 3; ++axis)
  {
    axes[axis] = rasFromLps * volume.axesMm[axis];
    turn[axis] = glm::normalize(axes[axis]);
  }
  if (form == NiftiForm::Affine)
  {
    header.Put(254, std::int16_t(1)); // sform_code
    for (int row = 0; row < 3; ++row)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        header.Put(280 + 16 * row + 4 * axis, float(axes[axis][row]));
      }
      header.Put(280 + 16 * row + 12, float(origin[row]));
    }
    return header.Bytes() + VoxelBytes(volume, bigEndian);
  }

  // A quaternion cannot mirror, so the third axis is reversed, which qfac records.
  const double handedness = glm::determinant(turn) < 0 ? -1.0 : 1.0;
  turn[2] *= handedness;
  glm::dquat quaternion = glm::normalize(glm::quat_cast(turn));
  quaternion = quaternion.w < 0 ? -quaternion : quaternion;
  header.Put(252, std::int16_t(1)); // qform_code
  header.Put(76, float(handedness));
  header.Put(256, float(quaternion.x));
  header.Put(260, float(quaternion.y));
  header.Put(264, float(quaternion.z));
  for (int row = 0; row < 3; ++row)
  {
    header.Put(268 + 4 * row, float(origin[row]));
  }
  return header.Bytes() + VoxelBytes(volume, bigEndian);
}

std::string Nifti2Bytes(const StoredVolume& volume, bool bigEndian)
{
  // Offsets from the NIfTI-2 specification, nifti2.h.
  BinaryHeader header(544, bigEndian);
  header.Put(0, std::int32_t(540));
  header.PutText(4, std::string("n+2\0\r\n\x1a\n", 8));
  header.Put(12, NiftiCode(volume.scalarType));
  header.Put(16, std::int64_t(3));
  header.Put(168, std::int64_t(544)); // vox_offset
  header.Put(348, std::int32_t(1));   // sform_code
  header.Put(500, std::int32_t(2));   // xyzt_units: mm
  const glm::dvec3 rasFromLps(-1.0, -1.0, 1.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    header.Put(24 + 8 * axis, std::int64_t(volume.dimensions[axis]));
    header.Put(112 + 8 * axis, glm::length(volume.axesMm[axis]));
    header.Put(424 + 32 * axis, rasFromLps[axis] * volume.originMm[axis]);
    for (int row = 0; row < 3; ++row)
    {
      header.Put(400 + 32 * row + 8 * axis, rasFromLps[row] * volume.axesMm[axis][row]);
    }
  }
  return header.Bytes() + VoxelBytes(volume, bigEndian);
}

// Acquisition parameters that the options contain.
static std::string AcquisitionElements(const DicomOptions& options)
{
  const auto text = [](int element, const std::string& kind, const std::string& value)
  { return value.empty() ? "" : Element(0x18, element, kind, value); };
  const auto number = [&](int element, double value)
  { return value > 0.0 ? Element(0x18, element, "DS", Decimals({ value })) : ""; };
  return text(0x10, "LO", options.contrastAgent) + text(0x15, "CS", options.bodyPart) +
    text(0x25, "CS", options.isAngiography ? "Y" : "") + number(0x80, options.repetitionMs) +
    number(0x81, options.echoMs);
}

std::string DicomBytes(const StoredVolume& volume, int slice, const DicomOptions& options)
{
  const std::string instanceUid =
    options.seriesUid + "." + std::to_string(slice + 1 + options.instance);
  const glm::dvec3 position = volume.originMm + volume.axesMm[2] * double(slice);
  const glm::dvec3 row = glm::normalize(volume.axesMm[0]);
  const glm::dvec3 column = glm::normalize(volume.axesMm[1]);
  const auto us = [](int number) { return Bytes(std::uint16_t(number)); };
  const std::size_t sliceValues = std::size_t(volume.dimensions[0]) * volume.dimensions[1];
  StoredVolume pixels = volume;
  pixels.values.assign(volume.values.begin() + std::ptrdiff_t(slice * sliceValues),
    volume.values.begin() + std::ptrdiff_t((slice + 1) * sliceValues));
  return DicomFileMeta(ctImageStorage, instanceUid) + Element(8, 0x16, "UI", ctImageStorage) +
    Element(8, 0x18, "UI", instanceUid) + Element(8, 0x60, "CS", options.modality) +
    (options.description.empty() ? "" : Element(8, 0x103e, "LO", options.description)) +
    Element(0x10, 0x10, "PN", "Doe^Jane") + AcquisitionElements(options) +
    Element(0x20, 0xd, "UI", "1.2") + Element(0x20, 0xe, "UI", options.seriesUid) +
    // The numbers contradict the order of the positions: readers must not rely on them.
    Element(0x20, 0x13, "IS", std::to_string((slice * 7) % 5)) +
    Element(0x20, 0x32, "DS",
      options.position.empty() ? Decimals({ position.x, position.y, position.z })
                               : options.position) +
    Element(0x20, 0x37, "DS", Decimals({ row.x, row.y, row.z, column.x, column.y, column.z })) +
    Element(0x28, 2, "US", us(1)) + Element(0x28, 4, "CS", "MONOCHROME2") +
    Element(0x28, 0x10, "US", us(options.rows ? options.rows : volume.dimensions[1])) +
    Element(0x28, 0x11, "US", us(volume.dimensions[0])) +
    Element(0x28, 0x30, "DS",
      Decimals({ glm::length(volume.axesMm[1]), glm::length(volume.axesMm[0]) })) +
    Element(0x28, 0x100, "US", us(16)) + Element(0x28, 0x101, "US", us(16)) +
    Element(0x28, 0x102, "US", us(15)) + Element(0x28, 0x103, "US", us(1)) +
    Element(0x28, 0x1050, "DS", "40") + Element(0x28, 0x1051, "DS", "400") +
    Element(0x28, 0x1052, "DS", Decimals({ options.intercept })) +
    Element(0x28, 0x1053, "DS", Decimals({ options.slope })) +
    (options.lossy ? Element(0x28, 0x2110, "CS", "01") : "") +
    Element(0x7fe0, 0x10, "OW", VoxelBytes(pixels));
}

std::string DicomIndexBytes(const std::vector<std::string>& imageNames)
{
  const std::string meta = DicomFileMeta("1.2.840.10008.1.3.10", "1.2.3.9");
  // The offsets of the first and last record, a meaningless element, and the header of the sequence
  // lie between the file's meta information and its first record.
  const auto first = std::uint32_t(meta.size() + 12 + 12 + 10 + 12);
  const auto end = [&](const std::string& records)
  { return std::uint32_t(first + records.size()); };

  std::string records;
  const auto addParent = [&](const std::string& type, const std::string& keys)
  {
    const std::string unplaced = IndexRecord(0, 0, type, "", keys);
    records += IndexRecord(0, end(records + unplaced), type, "", keys);
  };
  addParent("PATIENT", Element(0x10, 0x10, "PN", "Doe^Jane"));
  addParent("STUDY", Element(0x20, 0xd, "UI", "1.2"));
  addParent("SERIES", Element(8, 0x60, "CS", "CT") + Element(0x20, 0xe, "UI", "1.2.3"));
  for (const std::string& name : imageNames)
  {
    const std::string unplaced = IndexRecord(0, 0, "IMAGE", name, "");
    const bool isLast = &name == &imageNames.back();
    records += IndexRecord(isLast ? 0 : end(records + unplaced), 0, "IMAGE", name, "");
  }
  return meta + Element(4, 0x1200, "UL", Bytes(first)) + Element(4, 0x1202, "UL", Bytes(first)) +
    Element(4, 0x1212, "US", Bytes(std::uint16_t(0))) + Element(4, 0x1220, "SQ", records);
}
