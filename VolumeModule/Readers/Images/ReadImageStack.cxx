// Stacks of images: one file per slice, in a folder, in the natural order of their names.
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/ImageGeometry.h"
#include "Readers/Images/TiffFile.h"
#include "Readers/Packed/ByteStream.h"
#include "Readers/Parsing/BinaryHeader.h"
#include "Readers/Parsing/FileContent.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Parsing/VtkMessages.h"
#include "Readers/VoxelLayout.h"

#include <vtkBMPReader.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkJPEGReader.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkSortFileNames.h>
#include <vtkStringArray.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace varimarch
{
namespace
{

/// A file with one picture: PNG, JPEG, BMP, or TIFF of one page.
struct Picture
{
  std::string path;
  VoxelLayout layout;                             ///< one slice
  std::array<double, 2> spacingMm = { 0.0, 0.0 }; ///< 0 if unknown
  int orientation = 1;                            ///< as in StackGeometry
};

/// Fails unless all parts of a PNG file are there with their checksums, since vtkPNGReader of VTK
/// 9.1 crashes on a truncated file.
void CheckPng(const std::string& path, const std::string& bytes)
{
  const BinaryHeader numbers(bytes, true);
  std::size_t place = 8;
  bool isEnd = false;
  while (!isEnd)
  {
    const std::size_t length = numbers.At<unsigned int>(place);
    if (place + 12 > bytes.size() || length > bytes.size() - place - 12)
    {
      FailToRead(
        path, "a complete PNG file", "its end after " + std::to_string(bytes.size()) + " bytes");
    }
    const auto* const content = reinterpret_cast<const Bytef*>(bytes.data() + place + 4);
    if (crc32(0, content, uInt(length + 4)) != numbers.At<unsigned int>(place + 8 + length))
    {
      FailToRead(path, "a PNG file with right checksums", "a wrong one");
    }
    isEnd = bytes.compare(place + 4, 4, "IEND") == 0;
    place += length + 12;
  }
}

/// True if a JPEG file has its end mark. A thumbnail in its header has one too, and is skipped.
bool HasEndOfJpeg(const std::string& bytes)
{
  constexpr unsigned char FirstRestart = 0xd0;
  constexpr unsigned char LastRestart = 0xd7;
  constexpr unsigned char End = 0xd9;
  const BinaryHeader numbers(bytes, true);
  std::size_t place = 2;
  while (place + 1 < bytes.size())
  {
    const auto mark = static_cast<unsigned char>(bytes[place + 1]);
    const bool isOfPixels = bytes[place] != '\xff' || mark == 0 || mark == 0xff ||
      (FirstRestart <= mark && mark <= LastRestart);
    if (!isOfPixels && mark == End)
    {
      return true;
    }
    place += isOfPixels ? 1 : 2 + std::size_t(numbers.At<unsigned short>(place + 2));
  }
  return false;
}

/// Fails if a JPEG file does not end with its mark, because libjpeg makes the missing pixels grey.
void CheckJpeg(const std::string& path, const std::string& bytes)
{
  if (!HasEndOfJpeg(bytes))
  {
    FailToRead(
      path, "a complete JPEG file", "its end after " + std::to_string(bytes.size()) + " bytes");
  }
}

void CheckBmp(const std::string& path, const std::string& bytes)
{
  const BinaryHeader numbers(bytes, false);
  const double width = std::abs(double(numbers.At<int>(18)));
  const double height = std::abs(double(numbers.At<int>(22)));
  const int bits = numbers.At<unsigned short>(28);
  const int compression = numbers.At<int>(30);
  if ((bits != 8 && bits != 24) || compression != 0 || numbers.At<int>(14) < 40)
  {
    FailToRead(path, "a BMP file of 8 or 24 bits per pixel without compression",
      std::to_string(bits) + " bits and compression " + std::to_string(compression));
  }
  // Rows are padded to four bytes; the padding of the last one may be missing.
  const double paddedBytes = 4.0 * std::ceil(width * bits / 32.0);
  const double neededBytes = double(numbers.At<unsigned int>(10)) +
    paddedBytes * std::max(height - 1.0, 0.0) + width * bits / 8.0;
  if (neededBytes > double(bytes.size()))
  {
    FailToRead(path, ByteText(neededBytes) + " of pixels", ByteText(double(bytes.size())));
  }
}

/// True if the colours of a BMP file with 8 bits per pixel are shades of grey.
bool HasGreyPalette(const std::string& bytes)
{
  const BinaryHeader numbers(bytes, false);
  const std::size_t begin = 14 + numbers.At<unsigned int>(14);
  const std::size_t end = std::min<std::size_t>(numbers.At<unsigned int>(10), bytes.size());
  bool isGrey = numbers.At<unsigned short>(28) == 8;
  for (std::size_t entry = begin; entry + 4 <= end; entry += 4)
  {
    isGrey = isGrey && bytes[entry] == bytes[entry + 1] && bytes[entry] == bytes[entry + 2];
  }
  return isGrey;
}

vtkSmartPointer<vtkImageReader2> ReaderFor(const std::string& bytes)
{
  if (IsPng(bytes))
  {
    return vtkSmartPointer<vtkPNGReader>::New();
  }
  if (IsJpeg(bytes))
  {
    return vtkSmartPointer<vtkJPEGReader>::New();
  }
  return vtkSmartPointer<vtkBMPReader>::New();
}

void Check(const std::string& path, const std::string& bytes)
{
  IsPng(bytes)      ? CheckPng(path, bytes)
    : IsJpeg(bytes) ? CheckJpeg(path, bytes)
                    : CheckBmp(path, bytes);
}

Picture InspectedTiff(const std::string& path)
{
  TiffFile file(path);
  if (file.Pages().size() != 1)
  {
    FailToRead(path, "one page, as in other files of a stack", std::to_string(file.Pages().size()));
  }
  file.CheckHoldsPage(0);
  const TiffPage& page = file.Pages().front();
  return { path, page.layout, PixelSpacingMm(page), page.orientation };
}

/// Reads what a file says about its picture.
/// @throws std::runtime_error if the file is damaged
Picture InspectedPicture(const std::string& path)
{
  if (IsTiff(FirstBytes(path)))
  {
    return InspectedTiff(path);
  }
  const std::string bytes = WholeFile(path);
  Check(path, bytes);
  VtkMessages messages;
  const auto reader = ReaderFor(bytes);
  messages.Observe(reader);
  messages.Observe(reader->GetExecutive());
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  const int* const extent = reader->GetDataExtent();
  Picture picture = { path,
    { { extent[1] - extent[0] + 1, extent[3] - extent[2] + 1, 1 }, reader->GetDataScalarType(),
      reader->GetNumberOfScalarComponents() } };
  if (!messages.Errors().empty() || reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    FailToRead(path, "a readable picture", messages.FirstErrorOr("none"));
  }
  if (IsBmp(bytes) && HasGreyPalette(bytes))
  {
    picture.layout.componentCount = 1;
  }
  const double pixelBytes = double(CheckedByteCount(path, picture.layout));
  if (pixelBytes > LargestRatio(Compression::Deflate) * double(bytes.size()))
  {
    FailToRead(path, ByteText(pixelBytes) + " of pixels", ByteText(double(bytes.size())));
  }
  return picture;
}

/// Decodes a picture, top row first, into memory of its layout.
/// @throws std::runtime_error if the file is damaged
void ReadPicture(const Picture& picture, void* destination)
{
  const std::string head = FirstBytes(picture.path);
  if (IsTiff(head))
  {
    TiffFile(picture.path).ReadPage(0, destination);
    return;
  }
  VtkMessages messages;
  const auto reader = ReaderFor(head);
  messages.Observe(reader);
  messages.Observe(reader->GetExecutive());
  reader->SetFileName(picture.path.c_str());
  reader->Update();
  vtkImageData* const image = reader->GetOutput();
  const auto width = std::size_t(picture.layout.dimensions[0]);
  const auto height = std::size_t(picture.layout.dimensions[1]);
  if (!messages.Errors().empty() || reader->GetErrorCode() != vtkErrorCode::NoError ||
    !image->GetScalarPointer() || std::size_t(image->GetNumberOfPoints()) != width * height ||
    image->GetScalarType() != picture.layout.scalarType)
  {
    FailToRead(picture.path, "a readable picture", messages.FirstErrorOr("another size"));
  }
  // VTK's first row is the lowest. A grey palette gives three equal values.
  const auto valueBytes = std::size_t(image->GetScalarSize());
  const auto readCount = std::size_t(image->GetNumberOfScalarComponents());
  const auto keptCount = std::size_t(picture.layout.componentCount);
  const auto* const pixels = static_cast<const char*>(image->GetScalarPointer());
  auto* target = static_cast<char*>(destination);
  for (std::size_t row = height; row-- > 0;)
  {
    for (std::size_t column = 0; column < width; ++column)
    {
      const char* const pixel = pixels + (row * width + column) * readCount * valueBytes;
      target = std::copy_n(pixel, std::min(readCount, keptCount) * valueBytes, target);
    }
  }
}

/// The pictures of a folder that are slices, and what the folder says about them.
struct PictureFolder
{
  std::vector<std::string> slices; ///< paths, from the first slice to the last
  std::string preview;             ///< the name of a picture that shows the scan; or empty
  double voxelMm = 0.0;            ///< side of a cubic voxel; 0 if unknown
};

namespace fs = std::filesystem;

/// A name with the last whole number in it.
struct NumberedName
{
  std::string path;
  std::string before; ///< the text before the number and its sign
  std::string behind;
  double number = 0.0;
  bool hasHyphen = false; ///< true if a hyphen stands before the number
};

std::optional<NumberedName> NumberOf(const std::string& path)
{
  constexpr std::size_t MostDigits = 15;
  const std::string name = fs::path(path).filename().string();
  const auto isDigit = [&](std::size_t place)
  { return std::isdigit(static_cast<unsigned char>(name[place])) != 0; };
  std::size_t end = name.rfind('.') == std::string::npos ? name.size() : name.rfind('.');
  while (end > 0 && !isDigit(end - 1))
  {
    --end;
  }
  std::size_t begin = end;
  while (begin > 0 && isDigit(begin - 1))
  {
    --begin;
  }
  if (begin == end || end - begin > MostDigits)
  {
    return std::nullopt;
  }
  NumberedName numbered = { path, name.substr(0, begin), name.substr(end),
    std::stod(name.substr(begin, end - begin)), begin > 0 && name[begin - 1] == '-' };
  if (numbered.hasHyphen)
  {
    numbered.before.pop_back();
    numbered.number = -numbered.number;
  }
  return numbered;
}

/// The paths in order of signed numbers; nothing unless hyphens are signs, because some of the
/// names, which are otherwise the same, have one and others have none.
std::optional<std::vector<std::string>> InSignedOrder(const std::vector<std::string>& paths)
{
  std::vector<NumberedName> names;
  bool hasHyphens[2] = {};
  for (const std::string& path : paths)
  {
    const std::optional<NumberedName> name = NumberOf(path);
    if (!name ||
      (!names.empty() &&
        (name->before != names.front().before || name->behind != names.front().behind)))
    {
      return std::nullopt;
    }
    hasHyphens[name->hasHyphen ? 1 : 0] = true;
    names.push_back(*name);
  }
  if (!hasHyphens[0] || !hasHyphens[1])
  {
    return std::nullopt;
  }
  std::sort(names.begin(), names.end(),
    [](const NumberedName& one, const NumberedName& other) { return one.number < other.number; });
  std::vector<std::string> sorted;
  for (const NumberedName& name : names)
  {
    sorted.push_back(name.path);
  }
  return sorted;
}

std::vector<std::string> InNaturalOrder(const std::vector<std::string>& paths)
{
  vtkNew<vtkStringArray> names;
  for (const std::string& path : paths)
  {
    names->InsertNextValue(path);
  }
  vtkNew<vtkSortFileNames> sort;
  sort->NumericSortOn();
  sort->IgnoreCaseOn();
  sort->SetInputFileNames(names);
  sort->Update();
  std::vector<std::string> sorted;
  for (vtkIdType i = 0; i < sort->GetFileNames()->GetNumberOfValues(); ++i)
  {
    sorted.push_back(sort->GetFileNames()->GetValue(i));
  }
  return sorted;
}

/// Takes the preview of a SkyScan reconstruction out of the paths.
/// @returns its name, or an empty one
std::string TakenPreview(std::vector<std::string>& paths)
{
  constexpr const char* Mark = "_spr";
  const auto preview = std::find_if(paths.begin(), paths.end(),
    [&](const std::string& path)
    {
      const std::string stem = LowerCase(fs::path(path).stem().string());
      const std::size_t place = stem.rfind(Mark);
      return place != std::string::npos && place + std::string(Mark).size() == stem.size();
    });
  if (preview == paths.end() || paths.size() < 2)
  {
    return "";
  }
  const std::string name = fs::path(*preview).filename().string();
  paths.erase(preview);
  return name;
}

/// The size of a voxel in the log of a reconstruction, the last that it states [mm]; 0 if none.
double VoxelMmOf(const std::string& logPath)
{
  constexpr const char* Key = "pixel size (um)";
  constexpr double MmPerMicrometre = 1e-3;
  double voxelMm = 0.0;
  HeaderLines lines(logPath);
  while (const std::optional<std::string> line = lines.Next())
  {
    const std::size_t equals = line->find('=');
    const bool isSize =
      equals != std::string::npos && LowerCase(Trimmed(line->substr(0, equals))) == Key;
    const double size = isSize ? NumberIn(Trimmed(line->substr(equals + 1))).value_or(0.0) : 0.0;
    voxelMm = size > 0.0 ? size * MmPerMicrometre : voxelMm;
  }
  return voxelMm;
}

/// Finds the pictures of a folder. Numbers in names are in order of their values, negative ones
/// too. Beside the slices of a SkyScan reconstruction lie a preview, "NAME_spr", and a log with the
/// size of a voxel.
PictureFolder PictureFolderAt(const std::string& folder)
{
  PictureFolder found;
  std::set<std::string> logs;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    if (!entry.is_regular_file())
    {
      continue;
    }
    if (LowerCase(entry.path().extension().string()) == ".log")
    {
      logs.insert(entry.path().string());
    }
    else if (IsStackSlice(FirstBytes(entry.path())))
    {
      found.slices.push_back(entry.path().string());
    }
  }
  found.preview = TakenPreview(found.slices);
  found.slices = InSignedOrder(found.slices).value_or(InNaturalOrder(found.slices));
  for (const std::string& log : logs)
  {
    const double voxelMm = VoxelMmOf(log);
    found.voxelMm = voxelMm > 0.0 ? voxelMm : found.voxelMm;
  }
  return found;
}

/// The pictures of a stack, and the names of the files that are not in it.
struct SliceFiles
{
  std::vector<Picture> slices;
  std::string leftOut;

  void LeaveOut(const std::string& path)
  {
    this->leftOut += (this->leftOut.empty() ? "" : ", ");
    this->leftOut += std::filesystem::path(path).filename().string();
  }
};

/// Inspects all files, and leaves out the damaged ones.
SliceFiles Inspected(const std::vector<std::string>& paths, ReadProgress progress)
{
  SliceFiles stack;
  std::string fault;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    progress.Report(double(i) / double(paths.size()));
    try
    {
      stack.slices.push_back(InspectedPicture(paths[i]));
    }
    catch (const std::runtime_error& error)
    {
      stack.LeaveOut(paths[i]);
      fault = fault.empty() ? error.what() : fault;
    }
  }
  if (stack.slices.empty())
  {
    throw std::runtime_error(fault);
  }
  return stack;
}

/// Leaves out pictures of another size or type than most.
SliceFiles OfOneLayout(const SliceFiles& all)
{
  std::vector<VoxelLayout> layouts;
  for (const Picture& picture : all.slices)
  {
    layouts.push_back(picture.layout);
  }
  const VoxelLayout& usual = layouts[MostFrequent(layouts)];
  SliceFiles stack = { {}, all.leftOut };
  for (const Picture& picture : all.slices)
  {
    if (IsSame(picture.layout, usual))
    {
      stack.slices.push_back(picture);
    }
    else
    {
      stack.LeaveOut(picture.path);
    }
  }
  return stack;
}

vtkSmartPointer<vtkImageData> ReadSlices(
  const std::string& path, const std::vector<Picture>& slices, ReadProgress progress)
{
  VoxelLayout layout = slices.front().layout;
  layout.dimensions[2] = std::int64_t(slices.size());
  const std::uint64_t sliceBytes = CheckedByteCount(path, layout) / slices.size();
  auto image = AllocatedImage(layout);
  auto* const voxels = static_cast<char*>(image->GetScalarPointer());
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    progress.Report(double(i) / double(slices.size()));
    ReadPicture(slices[i], voxels + i * sliceBytes);
  }
  return image;
}

}

Volume ReadImageStack(const std::string& path, const ReadOptions& options, ReadProgress& progress)
{
  const bool isFolder = std::filesystem::is_directory(path);
  const PictureFolder pictures =
    isFolder ? PictureFolderAt(path) : PictureFolder{ { path }, "", 0.0 };
  const std::vector<std::string>& paths = pictures.slices;
  if (paths.empty())
  {
    FailToRead(path, "pictures of slices", "none");
  }
  if (paths.size() == 1 && IsTiff(FirstBytes(paths.front())))
  {
    return ReadTiff(paths.front(), options, progress);
  }
  const SliceFiles stack = OfOneLayout(Inspected(paths, progress.Part(0.0, 0.2)));
  const std::vector<Picture>& slices = stack.slices;
  Volume volume;
  volume.image = ReadSlices(path, slices, progress.Part(0.2, 1.0));
  volume.holdsColors = slices.front().layout.componentCount > 1;
  if (!stack.leftOut.empty())
  {
    volume.warnings.push_back("Files were left out because they are damaged or of another size or "
                              "type than most: " +
      stack.leftOut + '.');
  }
  if (!pictures.preview.empty())
  {
    volume.warnings.push_back(
      "The picture " + pictures.preview + " is a preview of the scan; it was left out.");
  }
  const double voxelMm = pictures.voxelMm;
  const std::array<double, 3> spacingMm = voxelMm > 0.0
    ? std::array<double, 3>{ voxelMm, voxelMm, voxelMm }
    : std::array<double, 3>{ slices.front().spacingMm[0], slices.front().spacingMm[1], 0.0 };
  PlaceImage(
    path, StackGeometry(spacingMm, slices.front().orientation, volume.warnings), volume.image);
  return volume;
}

}
