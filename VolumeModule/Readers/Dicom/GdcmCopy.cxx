#include "Readers/Dicom/GdcmCopy.h"

#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gdcmReader.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmWriter.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>
#include <stdexcept>

#include <sys/mman.h>
#include <unistd.h>

namespace varimarch
{
namespace
{

using CopyFunction = bool (*)(const std::string& from, const std::string& to);

bool Inflate(const std::string& from, const std::string& to)
{
  gdcm::Reader reader;
  reader.SetFileName(from.c_str());
  if (!reader.Read())
  {
    return false;
  }
  gdcm::Writer writer;
  writer.SetFile(reader.GetFile());
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(
    gdcm::TransferSyntax::ExplicitVRLittleEndian);
  writer.SetFileName(to.c_str());
  return writer.Write();
}

bool Uncompress(const std::string& from, const std::string& to)
{
  gdcm::ImageReader reader;
  reader.SetFileName(from.c_str());
  if (!reader.Read())
  {
    return false;
  }
  gdcm::ImageChangeTransferSyntax change;
  change.SetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  change.SetInput(reader.GetImage());
  if (!change.Change())
  {
    return false;
  }
  gdcm::ImageWriter writer;
  writer.SetFile(reader.GetFile());
  writer.SetImage(change.GetOutput());
  writer.SetFileName(to.c_str());
  return writer.Write();
}

std::shared_ptr<const ScratchFile> Copy(const std::string& path, CopyFunction copy)
{
  auto file = std::make_shared<ScratchFile>();
  try
  {
    return copy(path, file->Path()) ? file : nullptr;
  }
  catch (const std::bad_alloc&)
  {
    throw;
  }
  catch (const std::exception&)
  {
    return nullptr;
  }
}

}

ScratchFile::ScratchFile()
  : descriptor(memfd_create("varimarch-copy", MFD_CLOEXEC))
  , path("/proc/self/fd/" + std::to_string(this->descriptor))
{
  if (this->descriptor < 0)
  {
    throw std::runtime_error(
      std::string("Cannot create a file in memory: ") + std::strerror(errno) + '.');
  }
}

ScratchFile::~ScratchFile()
{
  close(this->descriptor);
}

std::shared_ptr<const ScratchFile> InflatedCopy(const std::string& path)
{
  return Copy(path, Inflate);
}

std::shared_ptr<const ScratchFile> UncompressedCopy(const std::string& path)
{
  return Copy(path, Uncompress);
}

std::shared_ptr<const ScratchFile> LengthenedCopy(const std::string& path, double pixelBytes)
{
  namespace fs = std::filesystem;
  auto file = std::make_shared<ScratchFile>();
  std::error_code error;
  fs::copy_file(path, file->Path(), fs::copy_options::overwrite_existing, error);
  if (!error)
  {
    fs::resize_file(file->Path(), fs::file_size(path) + std::uintmax_t(pixelBytes), error);
  }
  return error ? nullptr : file;
}

std::size_t FragmentCount(const std::string& path)
{
  try
  {
    gdcm::Reader reader;
    reader.SetFileName(path.c_str());
    const bool isRead = reader.Read();
    const gdcm::Tag pixelData(0x7fe0, 0x0010);
    const gdcm::SequenceOfFragments* const fragments = isRead
      ? reader.GetFile().GetDataSet().GetDataElement(pixelData).GetSequenceOfFragments()
      : nullptr;
    return fragments ? fragments->GetNumberOfFragments() : 0;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

bool IsKnownSyntax(const std::string& transferSyntax)
{
  return gdcm::TransferSyntax::GetTSType(transferSyntax.c_str()) != gdcm::TransferSyntax::TS_END;
}

}
