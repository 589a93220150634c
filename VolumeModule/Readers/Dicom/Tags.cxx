#include "Readers/Dicom/Tags.h"

#include "Readers/Dicom/FileHeader.h"
#include "Readers/FileError.h"

#include <vtkDICOMDataElement.h>
#include <vtkDICOMDictEntry.h>
#include <vtkDICOMItem.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace varimarch
{
namespace
{

/// The deepest sequences that are listed. No standard object has more than about ten.
constexpr int MostDepth = 32;

/// The most bytes of a text.
constexpr std::size_t MostTextBytes = 10000;

/// The most bytes of a binary value that are written out.
constexpr unsigned int MostBinaryBytes = 64;

std::string TextOfTag(const vtkDICOMTag& tag)
{
  char text[12];
  std::snprintf(text, sizeof text, "(%04x,%04x)", tag.GetGroup(), tag.GetElement());
  return text;
}

bool IsControl(char letter)
{
  return std::uint8_t(letter) < 0x20 || letter == 0x7f;
}

/// A text that is not cut within a letter of UTF-8.
std::string Cut(std::string text)
{
  std::replace_if(text.begin(), text.end(), IsControl, ' ');
  if (text.size() <= MostTextBytes)
  {
    return text;
  }
  std::size_t end = MostTextBytes;
  while (end > 0 && (std::uint8_t(text[end]) & 0xc0) == 0x80)
  {
    --end;
  }
  return text.substr(0, end) + "...";
}

/// A binary value. Private attributes often hold texts whose representation got lost.
std::string BinaryText(const vtkDICOMValue& value)
{
  const unsigned char* const bytes = value.GetUnsignedCharData();
  const unsigned int count = bytes ? value.GetVL() : 0;
  const auto isPrintable = [](unsigned char byte) { return byte >= 0x20 && byte < 0x7f; };
  const unsigned int letters = count > 0 && bytes[count - 1] == 0 ? count - 1 : count;
  if (letters > 0 && std::all_of(bytes, bytes + letters, isPrintable))
  {
    return Cut(std::string(bytes, bytes + letters));
  }
  if (!bytes || count > MostBinaryBytes)
  {
    return value.GetVL() == 0 ? "" : std::to_string(value.GetVL()) + " bytes";
  }
  std::string text;
  for (unsigned int i = 0; i < count; ++i)
  {
    char digits[4];
    std::snprintf(digits, sizeof digits, i == 0 ? "%02x" : " %02x", bytes[i]);
    text += digits;
  }
  return text;
}

std::string ValueText(const vtkDICOMValue& value)
{
  // The representations of bytes and of words are OB, OD, OF, OL, OV and OW.
  const std::string representation = value.GetVR().GetText();
  const bool isBinary = representation == "UN" || representation[0] == 'O';
  return isBinary ? BinaryText(value) : Cut(value.AsUTF8String());
}

/// Appends the attributes of a file, or of an item of a sequence.
template <class Attributes>
void Append(Attributes& attributes, int depth, std::vector<DicomTag>& tags)
{
  for (auto element = attributes.Begin(); element != attributes.End(); ++element)
  {
    const vtkDICOMTag tag = element->GetTag();
    const vtkDICOMDictEntry entry = attributes.FindDictEntry(tag);
    const vtkDICOMValue& value = element->GetValue();
    const vtkDICOMItem* const items = value.GetSequenceData();
    tags.push_back({ depth, TextOfTag(tag), value.GetVR().GetText(),
      entry.IsValid() ? entry.GetName() : "", items ? "" : ValueText(value) });
    for (std::size_t i = 0; items && depth < MostDepth && i < value.GetNumberOfValues(); ++i)
    {
      tags.push_back({ depth + 1, "", "", "Item " + std::to_string(i + 1), "" });
      Append(items[i], depth + 2, tags);
    }
  }
}

}

std::vector<DicomTag> TagsOf(const std::string& path)
{
  const DicomHeader header = ReadDicomHeader(path);
  if (!header.meta)
  {
    FailToRead(
      path, "a DICOM file", header.fault ? header.fault->found : "a file of another format");
  }
  std::vector<DicomTag> tags;
  Append(*header.meta, 0, tags);
  return tags;
}

}
