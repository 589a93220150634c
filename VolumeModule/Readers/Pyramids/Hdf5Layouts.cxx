#include "Readers/Pyramids/Hdf5Layouts.h"

#include "Readers/FileError.h"
#include "Readers/Parsing/HeaderText.h"
#include "Readers/Parsing/NumberText.h"
#include "Readers/Parsing/XmlText.h"
#include "Readers/Pyramids/Hdf5File.h"
#include "Readers/Pyramids/Json.h"
#include "Readers/Times.h"

#include <vtkType.h>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <iomanip>
#include <locale>
#include <optional>
#include <sstream>

namespace varimarch
{
namespace
{

/// Seconds of a moment such as "2023-05-17 09:30:00.250" since one that is always the same; none
/// for other texts.
std::optional<double> SecondsOfMoment(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::tm moment = {};
  if (!(stream >> std::get_time(&moment, "%Y-%m-%d %H:%M:%S")))
  {
    return std::nullopt;
  }
  double fraction = 0.0;
  const bool isWhole = !(stream >> fraction);
  return double(timegm(&moment)) + (isWhole ? 0.0 : fraction);
}

/// A number of an Imaris attribute, which is a text.
double NumberOfImaris(const Hdf5File& file, const std::string& object, const std::string& name)
{
  const std::string text = Trimmed(file.TextAttribute(object, name));
  return NumberFromText(file.Path(), "a number as " + name + " of " + object, text);
}

}

ImarisBox ImarisBoxOf(const Hdf5File& file, std::vector<std::string>& warnings)
{
  const std::string info = "/DataSetInfo/Image";
  const double mmPerUnit = MmPerUnitOrWarn(Trimmed(file.TextAttribute(info, "Unit")), warnings);
  ImarisBox box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string number = std::to_string(axis);
    box.lowest[axis] = NumberOfImaris(file, info, "ExtMin" + number) * mmPerUnit;
    box.highest[axis] = NumberOfImaris(file, info, "ExtMax" + number) * mmPerUnit;
  }
  return box;
}

std::array<std::int64_t, 3> ImarisDimensions(const Hdf5File& file, const std::string& group)
{
  std::array<std::int64_t, 3> dimensions;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::string name = std::string("ImageSize") + "XYZ"[axis];
    dimensions[axis] = WholeNumber(NumberOfImaris(file, group, name));
  }
  return dimensions;
}

ImageGeometry ImarisGeometry(const ImarisBox& box, const std::array<std::int64_t, 3>& dimensions)
{
  ImageGeometry geometry;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double stepMm =
      (box.highest[axis] - box.lowest[axis]) / double(dimensions[std::size_t(axis)]);
    geometry.axesMm[axis] = glm::dvec3(0.0);
    geometry.axesMm[axis][axis] = stepMm;
    geometry.originMm[axis] = box.lowest[axis] + 0.5 * stepMm;
  }
  return geometry;
}

VolumeTimes ImarisTimes(const Hdf5File& file, std::size_t count)
{
  std::vector<double> seconds;
  for (std::size_t i = 1; i <= count; ++i)
  {
    const std::optional<double> moment = SecondsOfMoment(
      Trimmed(file.TextAttribute("/DataSetInfo/TimeInfo", "TimePoint" + std::to_string(i))));
    if (!moment)
    {
      return NumberedTimes(std::int64_t(count));
    }
    seconds.push_back(*moment);
  }
  const double first = seconds.empty() ? 0.0 : seconds.front();
  std::transform(seconds.begin(), seconds.end(), seconds.begin(),
    [first](double moment) { return moment - first; });
  return StatedTimes(seconds);
}

std::vector<VolumeChannel> ImarisChannels(const Hdf5File& file, std::size_t count)
{
  std::vector<VolumeChannel> channels;
  for (std::size_t i = 0; count > 1 && count <= 4 && i < count; ++i)
  {
    const std::string group = "/DataSetInfo/Channel " + std::to_string(i);
    const std::string name = Trimmed(file.TextAttribute(group, "Name"));
    VolumeChannel channel = { name.empty() ? "Channel " + std::to_string(i + 1) : name, {} };
    std::istringstream color(file.TextAttribute(group, "Color"));
    color.imbue(std::locale::classic());
    glm::dvec3 rgb;
    if (color >> rgb.r >> rgb.g >> rgb.b)
    {
      channel.rgb = glm::clamp(rgb, 0.0, 1.0);
    }
    channels.push_back(channel);
  }
  return channels;
}

namespace
{

namespace fs = std::filesystem;

vtkSmartPointer<vtkXMLDataElement> Description(const std::string& path)
{
  return XmlFromText(path, "a description of BigDataViewer (XML)", WholeFile(path));
}

/// The text in an element; empty if there is no such element.
std::string TextOf(vtkXMLDataElement* parent, const char* name)
{
  vtkXMLDataElement* const element = parent ? parent->FindNestedElementWithName(name) : nullptr;
  const char* const text = element ? element->GetCharacterData() : nullptr;
  return Trimmed(text ? text : "");
}

/// The setup with this number; null if there is none.
vtkXMLDataElement* SetupOf(vtkXMLDataElement* root, std::size_t number)
{
  vtkXMLDataElement* const setups = root->LookupElementWithName("ViewSetups");
  for (int i = 0; setups && i < setups->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* const setup = setups->GetNestedElement(i);
    const bool isSetup = setup->GetName() && std::string(setup->GetName()) == "ViewSetup";
    if (isSetup && TextOf(setup, "id") == std::to_string(number))
    {
      return setup;
    }
  }
  return nullptr;
}

/// The transform of a setup at the first time, all that the file states one after the other.
glm::dmat4 RegistrationOf(const std::string& path, vtkXMLDataElement* root, std::size_t number)
{
  glm::dmat4 transform(1.0);
  vtkXMLDataElement* const all = root->LookupElementWithName("ViewRegistrations");
  for (int i = 0; all && i < all->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* const view = all->GetNestedElement(i);
    const char* const setup = view->GetAttribute("setup");
    const char* const time = view->GetAttribute("timepoint");
    const bool isWanted =
      setup && setup == std::to_string(number) && (!time || std::string(time) == "0");
    for (int k = 0; isWanted && k < view->GetNumberOfNestedElements(); ++k)
    {
      const std::string text = TextOf(view->GetNestedElement(k), "affine");
      if (text.empty())
      {
        continue;
      }
      const std::vector<double> rows = NumbersFromText(path, "an affine transform", text, 12);
      glm::dmat4 affine(1.0);
      for (int place = 0; place < 12; ++place)
      {
        affine[place % 4][place / 4] = rows[std::size_t(place)];
      }
      transform = transform * affine;
    }
  }
  return transform;
}

/// True if a transform only scales, by the size of a voxel in any unit.
bool OnlyScales(const glm::dmat4& transform, const glm::dvec3& voxel)
{
  constexpr double Rounding = 1e-6;
  const double factor = transform[0][0] / voxel.x;
  double largest = 0.0;
  for (int column = 0; column < 4; ++column)
  {
    for (int row = 0; row < 3; ++row)
    {
      const double scale = column == row ? factor * voxel[row] : 0.0;
      largest = std::max(largest, std::abs(transform[column][row] - scale));
    }
  }
  return factor > 0.0 && largest <= Rounding * factor * std::max({ voxel.x, voxel.y, voxel.z });
}

}

std::string FileOfBigDataViewer(const std::string& path)
{
  if (LowerCase(fs::path(path).extension().string()) != ".xml")
  {
    return path;
  }
  const auto root = Description(path);
  vtkXMLDataElement* const loader = root->LookupElementWithName("ImageLoader");
  const char* const format = loader ? loader->GetAttribute("format") : nullptr;
  const std::string file = TextOf(loader, "hdf5");
  if (!format || std::string(format) != "bdv.hdf5" || file.empty())
  {
    FailToRead(path, "a description of BigDataViewer with voxels in HDF5 (bdv.hdf5)",
      format ? "voxels in " + Quoted(format) : "another one");
  }
  return (fs::path(path).parent_path() / file).string();
}

glm::dvec3 BigDataViewerVoxelMm(
  const std::string& voxelFile, std::size_t setupNumber, std::vector<std::string>& warnings)
{
  const std::string path = fs::path(voxelFile).replace_extension(".xml").string();
  std::error_code unknown;
  const auto root =
    fs::exists(path, unknown) ? Description(path) : vtkSmartPointer<vtkXMLDataElement>();
  vtkXMLDataElement* const setup = root ? SetupOf(root, setupNumber) : nullptr;
  vtkXMLDataElement* const voxel = setup ? setup->FindNestedElementWithName("voxelSize") : nullptr;
  const std::string size = TextOf(voxel, "size");
  if (size.empty())
  {
    warnings.push_back(UnknownSpacing);
    return glm::dvec3(1.0);
  }
  const std::vector<double> numbers = NumbersFromText(path, "the size of a voxel", size, 3);
  const double mmPerUnit = MmPerUnitOrWarn(TextOf(voxel, "unit"), warnings);
  const glm::dvec3 voxelSize(numbers[0], numbers[1], numbers[2]);
  const glm::dmat4 registration = RegistrationOf(path, root, setupNumber);
  if (registration != glm::dmat4(1.0) && !OnlyScales(registration, voxelSize))
  {
    warnings.push_back("The description turns, shifts or stretches the volume (ViewRegistration); "
                       "that was not done.");
  }
  return voxelSize * mmPerUnit;
}

namespace
{

/// True for three axes that are long enough for voxels, and perhaps others before them.
bool IsVolume(const Hdf5Layout& layout)
{
  const std::size_t rank = layout.size.size();
  return layout.scalarType != VTK_VOID && rank >= 3;
}

/// The names of a data set's axes: those of ilastik, the labels of HDF5, or the names of their
/// scales; empty texts if it has none of these.
std::vector<std::string> AxisNames(const Hdf5File& file, const std::string& name, std::size_t rank)
{
  std::vector<std::string> names;
  const nlohmann::json axes =
    nlohmann::json::parse(file.TextAttribute(name, "axistags"), nullptr, false);
  for (const nlohmann::json& axis : ListIn(ValueAt(axes, "axes")))
  {
    names.push_back(TextIn(ValueAt(axis, "key")));
  }
  names = names.size() == rank ? names : file.TextsAttribute(name, "DIMENSION_LABELS");
  if (names.size() != rank)
  {
    names = file.ScalesOf(name);
    std::for_each(
      names.begin(), names.end(), [](std::string& scale) { scale.erase(0, scale.rfind('/') + 1); });
  }
  return names.size() == rank ? names : std::vector<std::string>(rank);
}

/// Places axes by the coordinates in their scales. @returns false if an axis of space has none
bool TakeScales(const Hdf5File& file, const std::string& name, ArrayAxes& axes,
  std::vector<std::string>& warnings)
{
  const std::vector<std::string> scales = file.ScalesOf(name);
  bool areKnown = scales.size() == axes.size();
  for (std::size_t i = 0; areKnown && i < axes.size(); ++i)
  {
    const bool isPlaced = !scales[i].empty() &&
      PlaceAxis(file.Numbers(scales[i]), Trimmed(file.TextAttribute(scales[i], "units")), axes[i],
        warnings);
    areKnown = isPlaced || !axes[i].world;
  }
  return areKnown;
}

/// Takes the sizes of a voxel as ilastik and Fiji write them: one for each axis, or the last three
/// for those of space, z first.
void TakeElementSizes(const Hdf5File& file, const std::string& name, ArrayAxes& axes,
  std::vector<std::string>& warnings)
{
  constexpr double MmPerMicrometre = 1e-3;
  std::vector<double> sizes = file.NumberAttribute(name, "element_size_um");
  std::vector<ArrayAxis*> sized;
  for (ArrayAxis& axis : axes)
  {
    if (axis.world || sizes.size() == axes.size())
    {
      sized.push_back(&axis);
    }
  }
  if (sizes.size() < sized.size() || sizes.size() < 3)
  {
    warnings.push_back(UnknownSpacing);
    return;
  }
  const auto isLength = [](double size) { return std::isnormal(size) && size > 0.0; };
  const auto known = std::find_if(sizes.rbegin(), sizes.rend(), isLength);
  for (std::size_t i = 0; i < sized.size(); ++i)
  {
    const double stated = sizes[sizes.size() - sized.size() + i];
    const double size = isLength(stated) || known == sizes.rend() ? stated : *known;
    sized[i]->scale = isLength(size) ? size : 1.0;
    sized[i]->mmPerUnit = MmPerMicrometre;
    if (sized[i]->world && !isLength(stated))
    {
      char text[160];
      std::snprintf(text, sizeof(text),
        "The file says that voxels are %g um long along %.20s; %g um was assumed.", stated,
        sized[i]->name.c_str(), sized[i]->scale);
      warnings.push_back(text);
    }
  }
}

}

std::string LargestDataSet(const Hdf5File& file)
{
  std::string largest;
  double most = 0.0;
  for (const std::string& name : file.DataSets())
  {
    const Hdf5Layout layout = LayoutOf(file, name);
    double count = IsVolume(layout) ? 1.0 : 0.0;
    for (const std::int64_t size : layout.size)
    {
      count *= double(size);
    }
    if (count > most)
    {
      most = count;
      largest = name;
    }
  }
  if (largest.empty())
  {
    FailToRead(file.Path(), "a data set of numbers with three axes", "none");
  }
  return largest;
}

ArrayAxes AxesOfDataSet(
  const Hdf5File& file, const std::string& name, std::vector<std::string>& warnings)
{
  const std::size_t rank = LayoutOf(file, name).size.size();
  ArrayAxes axes = AxesNamed(file.Path(), AxisNames(file, name, rank));
  if (!TakeScales(file, name, axes, warnings))
  {
    TakeElementSizes(file, name, axes, warnings);
  }
  return axes;
}

}
