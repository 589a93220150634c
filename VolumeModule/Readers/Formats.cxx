#include "Readers/Formats.h"

#include "Readers/FileError.h"
#include "Readers/ImageFacts.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Parsing/FileContent.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Pyramids/VoxelPyramid.h"
#include "Readers/Rectify.h"
#include "Readers/Rescale.h"
#include "Readers/Times.h"

#include <vtksys/SystemTools.hxx>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <filesystem>

namespace varimarch
{
namespace
{

bool Contains(const std::string& head, const std::string& text)
{
  return head.find(text) != std::string::npos;
}

/// A MetaImage begins with any of its fields, "Key = Value".
bool IsMetaImage(const std::string& head)
{
  const std::size_t keyEnd = head.find_first_not_of(
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz", head.find_first_not_of(" \t\r\n"));
  const std::size_t sign = head.find_first_not_of(" \t", keyEnd);
  const bool hasField = sign != std::string::npos && (head[sign] == '=' || head[sign] == ':');
  return hasField && Contains(head, "NDims") &&
    (Contains(head, "DimSize") || Contains(head, "ObjectType"));
}

/// True for VTK's XML files of a type.
bool IsVtkXml(const std::string& head, const std::string& type)
{
  return TextAt(0, { "<?xml", "<VTKFile" })(head) && Contains(head, "<VTKFile") &&
    Contains(head, '"' + type + '"');
}

bool IsVti(const std::string& head)
{
  return IsVtkXml(head, "ImageData");
}

bool IsPvti(const std::string& head)
{
  return IsVtkXml(head, "PImageData");
}

bool IsLegacyVtk(const std::string& head)
{
  return TextAt(0, { "# vtk DataFile" })(head) && Contains(head, "STRUCTURED_POINTS");
}

/// BigDataViewer describes its files of HDF5 in XML.
bool IsHdf5OrBigDataViewer(const std::string& head)
{
  return IsHdf5(head) || (TextAt(0, { "<?xml", "<SpimData" })(head) && Contains(head, "<SpimData"));
}

/// An InVesalius project is known as an archive, before its files are.
bool IsNever(const std::string&)
{
  return false;
}

constexpr bool decompresses = true;
constexpr bool unpacked = false; ///< or decompressed before
constexpr Subject patient = Subject::Patient;
constexpr Subject patientOfKnownSides = Subject::PatientIfSidesAreKnown;

// The first row whose signature matches is used, or else the first whose extension matches.
const std::vector<VolumeFormat> formats = {
  { "OME-Zarr", "OME-Zarr and Zarr folders", { ".zarr", ".zattrs", ".zarray", ".zgroup" }, IsZarr,
    ReadZarr, HoldsZarr, unpacked, patientOfKnownSides },
  { "NRRD", "NRRD images", { ".nrrd", ".nhdr" }, TextAt(0, { "NRRD" }), ReadNrrd, nullptr, unpacked,
    patientOfKnownSides },
  { "MetaImage", "MetaImages", { ".mha", ".mhd" }, IsMetaImage, ReadMetaImage, nullptr, unpacked,
    patientOfKnownSides },
  { "NIfTI", "NIfTI and Analyze images", { ".nii", ".nii.gz", ".hdr", ".hdr.gz" }, IsNifti,
    ReadNifti, nullptr, decompresses, patient },
  { "Analyze", "Voxels of NIfTI or Analyze beside a header", { ".img", ".img.gz" }, nullptr,
    ReadNifti, nullptr, decompresses, patient },
  { "VTI", "VTK images", { ".vti" }, IsVti, ReadVti },
  { "PVTI", "VTK images in pieces", { ".pvti" }, IsPvti, ReadPvti },
  { "VTK", "VTK structured points", { ".vtk" }, IsLegacyVtk, ReadLegacyVtk },
  { "DICOM", "DICOM images", { ".dcm", ".dicom", ".ima" }, IsDicom, ReadDicom, HoldsDicom, unpacked,
    patient },
  { "InVesalius", "InVesalius projects", { ".inv3" }, IsNever, ReadInv3, HoldsInv3, unpacked,
    patient },
  { "TIFF", "TIFF images", { ".tif", ".tiff", ".btf", ".tf8", ".stk", ".lsm" }, IsTiff, ReadTiff },
  { "image stack", "Stacks of images", { ".png", ".jpg", ".jpeg", ".bmp" }, IsStackSlice,
    ReadImageStack, HoldsPictures },
  { "NumPy", "NumPy arrays", { ".npy" }, IsNpy, ReadNpy, nullptr, decompresses },
  { "MGH", "FreeSurfer images", { ".mgh", ".mgz", ".mgh.gz" }, IsMgh, ReadMgh, nullptr,
    decompresses, patient },
  { "MINC", "MINC images", { ".mnc" }, IsMinc, ReadMinc, nullptr, unpacked, patient },
  { "HDF5", "HDF5, Imaris and BigDataViewer", { ".h5", ".hdf5", ".hdf", ".ims", ".xml", ".mat" },
    IsHdf5OrBigDataViewer, ReadHdf5, nullptr, unpacked, patientOfKnownSides },
  { "AFNI", "AFNI images", { ".head" }, IsAfni, ReadAfni, nullptr, unpacked, patient },
  { "AFNI voxels", "Voxels of AFNI beside a header", { ".brik", ".brik.gz" }, nullptr, ReadAfni,
    nullptr, decompresses, patient },
  { "MIF", "MRtrix images", { ".mif", ".mih" }, IsMif, ReadMif, nullptr, unpacked, patient },
  { "PAR/REC", "Philips PAR/REC images", { ".par" }, IsPar, ReadParRec, nullptr, unpacked,
    patient },
  { "PAR/REC voxels", "Voxels of Philips PAR/REC beside a header", { ".rec" }, nullptr, ReadParRec,
    nullptr, unpacked, patient },
  { "GIPL", "GIPL images", { ".gipl", ".gipl.gz" }, IsGipl, ReadGipl, nullptr, decompresses,
    patient },
  { "MRC", "MRC and CCP4 maps", { ".mrc", ".mrcs", ".map", ".ccp4" }, IsMrc, ReadMrc, nullptr,
    decompresses },
  { "SLC", "SLC volumes", { ".slc" }, IsSlc, ReadSlc },
  { "PVM", "PVM volumes", { ".pvm" }, IsPvm, ReadPvm },
  { "archive", "Archives and compressed files",
    { ".zip", ".npz", ".tar", ".tar.gz", ".tgz", ".gz", ".bz2", ".xz", ".zst" }, IsArchive,
    ReadPacked, HoldsVolumes },
  { "raw", "Raw voxels", { ".raw", ".raw.gz" }, nullptr, ReadRaw, nullptr, decompresses },
};

const VolumeFormat* FormatOfName(const std::string& path)
{
  const std::string name = LowerCase(std::filesystem::path(path).filename());
  for (const VolumeFormat& format : formats)
  {
    for (const std::string& extension : format.extensions)
    {
      if (vtksys::SystemTools::StringEndsWith(name, extension.c_str()))
      {
        return &format;
      }
    }
  }
  return nullptr;
}

const VolumeFormat* FormatOfContent(const std::string& head)
{
  const auto format = std::find_if(formats.begin(), formats.end(),
    [&](const VolumeFormat& row) { return row.recognises && row.recognises(head); });
  return format == formats.end() ? nullptr : &*format;
}

const VolumeFormat* FormatOfFolder(const std::string& path)
{
  const auto format = std::find_if(formats.begin(), formats.end(),
    [&](const VolumeFormat& row) { return row.recognisesFolder && row.recognisesFolder(path); });
  return format == formats.end() ? nullptr : &*format;
}

const VolumeFormat* FormatOfReader(decltype(VolumeFormat::read) read)
{
  return &*std::find_if(
    formats.begin(), formats.end(), [&](const VolumeFormat& row) { return row.read == read; });
}

/// A list such as "NRRD, MetaImage or raw", without the rows for voxels beside a header.
std::string FormatNames()
{
  std::string names;
  for (const VolumeFormat& format : formats)
  {
    names += format.recognises ? std::string(format.name) + ", " : "";
  }
  return names.substr(0, names.size() - 2) + " or " + formats.back().name;
}

/// The format whose reader explains best what is wrong with a file that no signature matches: that
/// of its name, unless the content is known.
const VolumeFormat& FormatThatExplains(const std::string& path)
{
  const bool isFolder = std::filesystem::is_directory(path);
  const std::string head = isFolder ? "" : FirstBytes(path);
  const VolumeFormat* format = FormatOfName(path);
  if (isFolder || !format || !KnownContent(head).empty())
  {
    FailToRead(path, "a volume of a known format (" + FormatNames() + ")",
      isFolder ? DescribedFolder(path) : DescribedContent(head));
  }
  return *format;
}

/// Slices of tissue under a microscope are DICOM images too.
bool IsMicroscopy(const std::string& modality)
{
  return modality == "SM" || modality == "GM";
}

bool WarnsOfSides(const Volume& volume)
{
  const auto& warnings = volume.warnings;
  return std::find(warnings.begin(), warnings.end(), UnknownSides) != warnings.end();
}

bool IsAboutPatient(Subject subject, const Volume& volume)
{
  return !IsMicroscopy(volume.modality) &&
    (subject == Subject::Patient ||
      (subject == Subject::PatientIfSidesAreKnown && !WarnsOfSides(volume)));
}

/// True for a file that cannot say which side is the patient's left. Archives hold files of other
/// formats, and whoever describes raw voxels knows how they lie.
bool LacksSides(const VolumeFormat& format, const Volume& volume)
{
  return format.subject == Subject::Anything && format.read != ReadPacked &&
    format.read != ReadRaw && !volume.showsPatient;
}

/// Refuses the wish for a level or a channel of a format that has none.
void CheckHasParts(const std::string& path, const VolumeFormat& format, const ReadOptions& options)
{
  const bool hasParts =
    format.read == ReadZarr || format.read == ReadHdf5 || format.read == ReadPacked;
  if (!hasParts && (options.level.value_or(0) > 0 || options.channel > 0))
  {
    FailToRead(path, "a file with levels or channels, such as OME-Zarr, Imaris or BigDataViewer",
      std::string("the format ") + format.name);
  }
}

}

const std::vector<VolumeFormat>& VolumeFormats()
{
  return formats;
}

const VolumeFormat* FormatOfFile(const std::string& path, const ReadOptions& options)
{
  if (std::filesystem::is_directory(path))
  {
    return FormatOfFolder(path);
  }
  const std::string file = Hdf5PathOf(path).file;
  const VolumeFormat* format = FormatOfContent(FirstBytes(file));
  if (!format)
  {
    const VolumeFormat* named = FormatOfName(path);
    const bool isDescribed = options.raw.dimensions[0] > 0;
    format = named && !named->recognises ? named : nullptr;
    format = !format && isDescribed ? FormatOfReader(ReadRaw) : format;
  }
  const bool isPacked = format && !format->decompresses && CompressionOf(file) != Compression::None;
  return isPacked ? FormatOfReader(ReadPacked) : format;
}

const VolumeFormat* FormatOfMember(const std::string& path)
{
  try
  {
    return FormatOfContent(FirstBytes(path));
  }
  catch (const std::runtime_error&)
  {
    return nullptr;
  }
}

const VolumeFormat* FormatIfReadable(const std::string& path)
{
  try
  {
    const bool isEmpty =
      !std::filesystem::is_directory(path) && ReadableFileSize(Hdf5PathOf(path).file) == 0;
    return isEmpty ? nullptr : FormatOfFile(path, ReadOptions());
  }
  catch (const std::runtime_error&)
  {
    return nullptr;
  }
}

bool LooksReadable(const std::string& path)
{
  return std::filesystem::is_directory(path) || FormatIfReadable(path);
}

Volume ReadUnrectified(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  if (options.filesAreTimes)
  {
    return ReadFilesAsTimes(path, options, progress);
  }
  if (!std::filesystem::is_directory(path) && ReadableFileSize(Hdf5PathOf(path).file) == 0)
  {
    FailToRead(path, "a volume", "an empty file");
  }
  const VolumeFormat* found = FormatOfFile(path, options);
  const VolumeFormat& format = found ? *found : FormatThatExplains(path);
  CheckHasParts(path, format, options);
  Volume volume = format.read(path, options, progress);
  volume.showsPatient = volume.showsPatient || IsAboutPatient(format.subject, volume);
  if (LacksSides(format, volume) && !WarnsOfSides(volume))
  {
    volume.warnings.push_back(UnknownSides);
  }
  TakeTimes(path, volume.times, options, volume);
  // ParaView shows such voxels by their magnitude too.
  const int componentCount = volume.image->GetNumberOfScalarComponents();
  if (componentCount > 4)
  {
    TakeMagnitude("The voxels have " + std::to_string(componentCount) + " components", volume);
  }
  return volume;
}

Volume ReadVolume(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  progress.Report(0.0);
  ReadProgress reading = progress.Part(0.0, options.rectify == Rectify::Never ? 1.0 : 0.8);
  ReadProgress rectifying = progress.Part(0.8, 1.0);
  Volume volume = ReadUnrectified(path, options, reading);
  if (options.preview && !options.preview->sentence.empty())
  {
    volume.warnings.push_back(options.preview->sentence);
    glm::dvec3 spacing = glm::make_vec3(volume.image->GetSpacing());
    spacing *= glm::make_vec3(options.preview->steps.data());
    volume.image->SetSpacing(spacing.x, spacing.y, spacing.z);
  }
  if (options.Rectifies(volume))
  {
    volume = Rectified(path, volume, rectifying);
  }
  KeepFacts(volume, volume.image);
  progress.Report(1.0);
  return volume;
}

}
