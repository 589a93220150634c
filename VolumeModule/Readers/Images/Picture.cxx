#include "Readers/Images/Picture.h"

#include "Readers/BinaryHeader.h"
#include "Readers/ByteStream.h"
#include "Readers/FileContent.h"
#include "Readers/FileError.h"
#include "Readers/Formats.h"
#include "Readers/HeaderText.h"
#include "Readers/Images/TiffFile.h"
#include "Readers/Signatures.h"
#include "Readers/VtkMessages.h"

#include <vtkBMPReader.h>
#include <vtkDataArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkJPEGReader.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <zlib.h>

#include <algorithm>
#include <cmath>

namespace varimarch
{
namespace
{

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

}

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

}
