#include "Readers/FileError.h"
#include "Readers/Images/TiffDescription.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Parsing/XmlText.h"
#include "Readers/Times.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace varimarch
{
namespace
{

constexpr std::int64_t mostPlanes = 1000000;

/// The dimensions that pages count, by the letter of OME.
using Indices = std::map<char, std::int64_t>;

std::string Attribute(vtkXMLDataElement* element, const char* name)
{
  const char* const value = element->GetAttribute(name);
  return value ? value : "";
}

/// The name of an element without the prefix of its namespace.
std::string NameOf(vtkXMLDataElement* element)
{
  const std::string name = element->GetName() ? element->GetName() : "";
  return name.substr(name.find(':') + 1);
}

std::vector<vtkXMLDataElement*> Children(vtkXMLDataElement* parent, const std::string& name)
{
  std::vector<vtkXMLDataElement*> children;
  for (int i = 0; i < parent->GetNumberOfNestedElements(); ++i)
  {
    if (NameOf(parent->GetNestedElement(i)) == name)
    {
      children.push_back(parent->GetNestedElement(i));
    }
  }
  return children;
}

/// The description of one file set, and the planes that it lists.
class OmeDescription
{
public:
  OmeDescription(const TiffFile& file, vtkSmartPointer<vtkXMLDataElement> root);

  TiffStack Stack(std::int64_t time) const;

private:
  std::int64_t Integer(vtkXMLDataElement* element, const char* name, std::int64_t otherwise) const;
  void TakeSizes();
  void TakePlanes();
  void TakePlanes(vtkXMLDataElement* tiffData);
  std::string FileOf(vtkXMLDataElement* tiffData) const;
  std::int64_t PlaneAt(Indices indices) const;
  double SpacingMm(char axis, std::vector<std::string>& warnings) const;
  std::vector<VolumeChannel> Channels() const;
  VolumeTimes Times() const;

  const TiffFile& file;
  vtkSmartPointer<vtkXMLDataElement> root;
  std::size_t imageCount = 0;
  vtkXMLDataElement* pixels = nullptr;
  std::string order; ///< the dimensions behind X and Y, fastest first
  Indices sizes;
  /// Where the planes of the pixels are, by their number in the order of the dimensions.
  std::map<std::int64_t, TiffPlane> planes;
};

OmeDescription::OmeDescription(const TiffFile& file, vtkSmartPointer<vtkXMLDataElement> root)
  : file(file)
  , root(root)
{
  const std::vector<vtkXMLDataElement*> images = Children(root, "Image");
  this->imageCount = images.size();
  const auto all =
    images.empty() ? std::vector<vtkXMLDataElement*>() : Children(images.front(), "Pixels");
  if (all.empty())
  {
    FailToRead(file.Path(), "a description of an image with its pixels (OME-XML)",
      Children(root, "BinaryOnly").empty() ? "none" : "a reference to another file");
  }
  this->pixels = all.front();
  this->TakeSizes();
  this->TakePlanes();
}

std::int64_t OmeDescription::Integer(
  vtkXMLDataElement* element, const char* name, std::int64_t otherwise) const
{
  const std::string value = Attribute(element, name);
  const std::string what = "0 to 1000000 as " + std::string(name);
  const std::int64_t number =
    value.empty() ? otherwise : IntegerFromText(this->file.Path(), what, value);
  if (number < 0 || number > mostPlanes)
  {
    FailToRead(this->file.Path(), what, value);
  }
  return number;
}

void OmeDescription::TakeSizes()
{
  this->order = Attribute(this->pixels, "DimensionOrder").substr(0, 5);
  std::string sorted = this->order;
  std::sort(sorted.begin(), sorted.end());
  if (sorted != "CTXYZ" || this->order.compare(0, 2, "XY") != 0)
  {
    FailToRead(this->file.Path(), "an order of dimensions such as XYZCT", Quoted(this->order));
  }
  this->order.erase(0, 2);
  // The samples of a pixel, such as red, green and blue, share a page.
  const std::int64_t samples = this->file.Pages().front().layout.componentCount;
  this->sizes = { { 'Z', this->Integer(this->pixels, "SizeZ", 1) },
    { 'C', this->Integer(this->pixels, "SizeC", 1) / std::max<std::int64_t>(samples, 1) },
    { 'T', this->Integer(this->pixels, "SizeT", 1) } };
  double count = 1.0;
  for (const auto& [letter, size] : this->sizes)
  {
    count *= double(size);
    if (size < 1 || count > double(mostPlanes))
    {
      FailToRead(
        this->file.Path(), "1 to 1000000 planes", std::to_string(size) + " as size of " + letter);
    }
  }
}

std::int64_t OmeDescription::PlaneAt(Indices indices) const
{
  std::int64_t plane = 0;
  std::int64_t step = 1;
  for (const char letter : this->order)
  {
    plane += indices[letter] * step;
    step *= this->sizes.at(letter);
  }
  return plane;
}

/// The file that holds the planes; this one if it is not named, or was renamed.
std::string OmeDescription::FileOf(vtkXMLDataElement* tiffData) const
{
  const auto ids = Children(tiffData, "UUID");
  const char* const id = ids.empty() ? nullptr : ids.front()->GetCharacterData();
  const std::string name = ids.empty() ? "" : Attribute(ids.front(), "FileName");
  if (name.empty() || (id && Trimmed(id) == Attribute(this->root, "UUID")))
  {
    return this->file.Path();
  }
  return (std::filesystem::path(this->file.Path()).parent_path() / name).string();
}

void OmeDescription::TakePlanes(vtkXMLDataElement* tiffData)
{
  const bool hasPage = !Attribute(tiffData, "IFD").empty();
  const std::int64_t page = this->Integer(tiffData, "IFD", 0);
  const auto all = std::int64_t(this->file.Pages().size());
  const std::int64_t count = this->Integer(tiffData, "PlaneCount", hasPage ? 1 : all);
  const std::int64_t first = this->PlaneAt({ { 'Z', this->Integer(tiffData, "FirstZ", 0) },
    { 'C', this->Integer(tiffData, "FirstC", 0) }, { 'T', this->Integer(tiffData, "FirstT", 0) } });
  const std::string path = this->FileOf(tiffData);
  for (std::int64_t i = 0; i < count; ++i)
  {
    this->planes[first + i] = { path, std::size_t(page + i) };
  }
}

void OmeDescription::TakePlanes()
{
  const std::vector<vtkXMLDataElement*> lists = Children(this->pixels, "TiffData");
  for (vtkXMLDataElement* const tiffData : lists)
  {
    this->TakePlanes(tiffData);
  }
  for (std::size_t page = 0; lists.empty() && page < this->file.Pages().size(); ++page)
  {
    this->planes[std::int64_t(page)] = { this->file.Path(), page };
  }
}

/// Distance of voxels along an axis; 0 if unknown.
double OmeDescription::SpacingMm(char axis, std::vector<std::string>& warnings) const
{
  const std::string name = std::string("PhysicalSize") + axis;
  const std::string size = Attribute(this->pixels, name.c_str());
  const std::string unit = Attribute(this->pixels, (name + "Unit").c_str());
  if (size.empty() || unit == "pixel" || unit == "reference frame")
  {
    return 0.0;
  }
  return NumberFromText(this->file.Path(), "a number as " + name, size) *
    MmPerUnitOrWarn(unit.empty() ? "um" : unit, warnings);
}

/// The colour of a channel, a signed number with red, green, blue and alpha from its highest byte
/// on; nothing if it is not stated, or white as the default of the format.
std::optional<glm::dvec3> ColorOf(vtkXMLDataElement* channel)
{
  const std::string text = Attribute(channel, "Color");
  char* end = nullptr;
  const auto rgba = std::uint32_t(std::strtoll(text.c_str(), &end, 10));
  if (text.empty() || *end != '\0' || rgba >> 8 == 0xffffff || rgba >> 8 == 0)
  {
    return std::nullopt;
  }
  return glm::dvec3(rgba >> 24 & 255, rgba >> 16 & 255, rgba >> 8 & 255) / 255.0;
}

std::vector<VolumeChannel> OmeDescription::Channels() const
{
  std::vector<VolumeChannel> channels;
  for (vtkXMLDataElement* const channel : Children(this->pixels, "Channel"))
  {
    const std::string name = Attribute(channel, "Name");
    channels.push_back(
      { name.empty() ? "Channel " + std::to_string(channels.size() + 1) : name, ColorOf(channel) });
  }
  return channels;
}

VolumeTimes OmeDescription::Times() const
{
  const std::string step = Attribute(this->pixels, "TimeIncrement");
  const std::string unit = Attribute(this->pixels, "TimeIncrementUnit");
  const double seconds = step.empty()
    ? 0.0
    : NumberFromText(this->file.Path(), "a number as TimeIncrement", step) *
      SecondsPerUnit(unit.empty() ? "s" : unit);
  return EvenTimes(this->sizes.at('T'), 0.0, seconds);
}

TiffStack OmeDescription::Stack(std::int64_t time) const
{
  TiffStack stack;
  stack.channelCount = std::size_t(this->sizes.at('C'));
  stack.channels = this->Channels();
  stack.times = this->Times();
  const auto last = std::int64_t(stack.times.values.size()) - 1;
  const std::int64_t t = std::clamp<std::int64_t>(time, 0, last);
  stack.spacingMm = { this->SpacingMm('X', stack.warnings), this->SpacingMm('Y', stack.warnings),
    this->SpacingMm('Z', stack.warnings) };
  for (std::int64_t z = 0; z < this->sizes.at('Z'); ++z)
  {
    for (std::int64_t c = 0; c < this->sizes.at('C'); ++c)
    {
      const auto plane = this->planes.find(this->PlaneAt({ { 'Z', z }, { 'C', c }, { 'T', t } }));
      if (plane == this->planes.end())
      {
        FailToRead(this->file.Path(),
          "a page for slice " + std::to_string(z) + " of channel " + std::to_string(c) +
            " at time " + std::to_string(t),
          "none");
      }
      stack.planes.push_back(plane->second);
    }
  }
  if (this->imageCount > 1)
  {
    stack.warnings.push_back(
      "The file holds " + std::to_string(this->imageCount) + " images; only the first was read.");
  }
  return stack;
}

}

std::optional<TiffStack> OmeStack(const TiffFile& file, std::int64_t time)
{
  const std::string& text = file.Description();
  if (text.find("<OME") == std::string::npos && text.find(":OME ") == std::string::npos)
  {
    return std::nullopt;
  }
  return OmeDescription(file, XmlFromText(file.Path(), "a description in XML (OME-XML)", text))
    .Stack(time);
}

}
