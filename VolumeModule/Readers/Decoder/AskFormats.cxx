// The formats that other libraries parse, as a decoder reads them.
#include "Readers/Decoder/Conversation.h"
#include "Readers/Decoder/Fields.h"
#include "Readers/Decoder/ImageForm.h"
#include "Readers/Dicom/Segmentation.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/MappedVti.h"

namespace varimarch
{
namespace
{

Volume TakeVolume(const std::string& path, Conversation& conversation)
{
  Volume volume;
  ImageForm form;
  TakeValues(conversation.Result(), volume, form);
  if (!IsNumberType(form.layout.scalarType))
  {
    throw DecoderFailure{ "voxels of the decoder that are no numbers" };
  }
  if (volume.times.values.empty())
  {
    throw DecoderFailure{ "a volume of the decoder without a time" };
  }
  const std::uint64_t byteCount = CheckedByteCount(path, form.layout);
  volume.image = AllocatedImage(form.layout);
  form.Place(volume.image);
  conversation.TakeBytes(volume.image->GetScalarPointer(), byteCount);
  conversation.Finish();
  return volume;
}

Volume ReadByDecoder(const std::string& format, const std::string& path, const ReadOptions& options,
  ReadProgress& progress)
{
  try
  {
    Conversation conversation(path, progress);
    conversation.Give(Packed(Job::ReadFormat, FreeJobMemory(), format, path, options));
    return TakeVolume(path, conversation);
  }
  catch (const DecoderFailure& failure)
  {
    FailToDecode(path, failure);
  }
}

}

Volume ReadImageStack(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadByDecoder("image stack", path, options, progress);
}

Volume ReadInv3(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadByDecoder("InVesalius", path, options, progress);
}

Volume ReadMinc(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadByDecoder("MINC", path, options, progress);
}

Volume ReadPvti(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadByDecoder("PVTI", path, options, progress);
}

Volume ReadSegmentation(const std::string& path, ReadProgress& progress)
{
  return ReadByDecoder("DICOM segmentation", path, {}, progress);
}

Volume ReadTiff(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  return ReadByDecoder("TIFF", path, options, progress);
}

Volume ReadVti(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  std::optional<Volume> mapped = MappedVti(path, options, progress);
  return mapped ? *mapped : ReadByDecoder("VTI", path, options, progress);
}

}
