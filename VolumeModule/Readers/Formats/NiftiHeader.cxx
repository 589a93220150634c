#include "Readers/Formats/NiftiHeader.h"

#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Parsing/FileContent.h"

#include <vtkByteSwap.h>

#include <cmath>
#include <cstring>

namespace varimarch
{
namespace
{

using namespace std::string_literals;

// sizeof does not apply, because compilers pad the end of nifti_2_header.
constexpr std::size_t bytesOf1 = 348;
constexpr std::size_t bytesOf2 = 540;

bool IsNifti1(const std::string& head)
{
  return TextAt(344, { "n+1\0"s, "ni1\0"s })(head);
}

bool IsNifti2(const std::string& head)
{
  return TextAt(4, { "n+2\0"s, "ni2\0"s })(head);
}

/// Analyze has no mark but the size of its header and, in the same byte order, a number of
/// dimensions.
bool IsAnalyze(const std::string& head)
{
  const auto isRank = [&](char low, char high) { return low >= 1 && low <= 7 && high == 0; };
  return head.size() >= bytesOf1 &&
    ((TextAt(0, { "\x5c\1\0\0"s })(head) && isRank(head[40], head[41])) ||
      (TextAt(0, { "\0\0\1\x5c"s })(head) && isRank(head[41], head[40])));
}

/// Reads header fields of either byte order.
struct FieldReader
{
  bool swaps;

  template <class From, class To>
  void Take(From from, To& to) const
  {
    if (this->swaps)
    {
      vtkByteSwap::SwapVoidRange(&from, 1, sizeof(from));
    }
    to = To(from);
  }

  template <class From, class To, std::size_t Count>
  void Take(const From (&from)[Count], To (&to)[Count]) const
  {
    for (std::size_t i = 0; i < Count; ++i)
    {
      this->Take(from[i], to[i]);
    }
  }
};

/// @tparam Stored  nifti_1_header or nifti_2_header, whose fields have the same names
template <class Stored>
NiftiHeader HeaderFromBytes(const char* bytes, const FieldReader& fields)
{
  Stored stored;
  std::memcpy(&stored, bytes, sizeof(stored));
  NiftiHeader header = {};
  header.kind = stored.magic[1] == '+' ? NiftiKind::OneFile : NiftiKind::Pair;
  fields.Take(stored.dim, header.dim);
  fields.Take(stored.intent_code, header.intent);
  fields.Take(stored.datatype, header.datatype);
  fields.Take(stored.pixdim, header.pixdim);
  fields.Take(stored.vox_offset, header.voxelOffset);
  fields.Take(stored.scl_slope, header.rescale.slope);
  fields.Take(stored.scl_inter, header.rescale.intercept);
  fields.Take(stored.cal_min, header.calibration[0]);
  fields.Take(stored.cal_max, header.calibration[1]);
  fields.Take(stored.toffset, header.timeOffset);
  fields.Take(stored.xyzt_units, header.units);
  fields.Take(stored.qform_code, header.quaternionCode);
  fields.Take(stored.sform_code, header.affineCode);
  fields.Take(stored.quatern_b, header.quaternion[0]);
  fields.Take(stored.quatern_c, header.quaternion[1]);
  fields.Take(stored.quatern_d, header.quaternion[2]);
  fields.Take(stored.qoffset_x, header.quaternionOffset[0]);
  fields.Take(stored.qoffset_y, header.quaternionOffset[1]);
  fields.Take(stored.qoffset_z, header.quaternionOffset[2]);
  fields.Take(stored.srow_x, header.affine[0]);
  fields.Take(stored.srow_y, header.affine[1]);
  fields.Take(stored.srow_z, header.affine[2]);
  return header;
}

/// Removes what NIfTI keeps where Analyze has other fields, and adds SPM's origin.
void MakeAnalyze(const std::string& bytes, const FieldReader& fields, NiftiHeader& header)
{
  constexpr std::size_t originatorOffset = 253;
  header.kind = NiftiKind::Analyze;
  header.intent = 0;
  header.units = 0;
  header.quaternionCode = 0;
  header.affineCode = 0;
  // SPM99 added the slope, but no intercept. A negative offset pads each volume.
  header.rescale.intercept = 0.0;
  header.padsEachVolume = header.voxelOffset < 0.0;
  header.voxelOffset = std::abs(header.voxelOffset);
  std::int16_t originator[3];
  std::memcpy(originator, bytes.data() + originatorOffset, sizeof(originator));
  fields.Take(originator, header.spmOrigin);
}

}

bool IsNifti(const std::string& head)
{
  return IsNifti1(head) || IsNifti2(head) || IsAnalyze(head);
}

NiftiHeader ReadNiftiHeader(const std::string& path)
{
  ReadableFileSize(path);
  std::string bytes = FirstBytes(path);
  if (!IsNifti(bytes))
  {
    FailToRead(path, "a NIfTI or Analyze header",
      bytes.size() < bytesOf1 ? std::to_string(bytes.size()) + " bytes" : DescribedContent(bytes));
  }
  const std::size_t needed = IsNifti2(bytes) ? bytesOf2 : bytesOf1;
  if (bytes.size() < needed)
  {
    FailToRead(
      path, "a NIfTI header of " + std::to_string(needed) + " bytes", std::to_string(bytes.size()));
  }
  // The header begins with its own size, which shows the byte order.
  std::int32_t size;
  std::memcpy(&size, bytes.data(), sizeof(size));
  const FieldReader fields{ size != std::int32_t(needed) };
  bytes.resize(sizeof(nifti_2_header));
  NiftiHeader header = IsNifti2(bytes) ? HeaderFromBytes<nifti_2_header>(bytes.data(), fields)
                                       : HeaderFromBytes<nifti_1_header>(bytes.data(), fields);
  if (!IsNifti1(bytes) && !IsNifti2(bytes))
  {
    MakeAnalyze(bytes, fields, header);
  }
  header.byteCount = needed + 4;
#ifdef VTK_WORDS_BIGENDIAN
  header.bigEndian = !fields.swaps;
#else
  header.bigEndian = fields.swaps;
#endif
  return header;
}

}
