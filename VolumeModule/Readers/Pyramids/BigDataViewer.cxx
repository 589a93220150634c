#include "Readers/Pyramids/BigDataViewer.h"

#include "Readers/FileError.h"
#include "Readers/HeaderText.h"
#include "Readers/NumberText.h"
#include "Readers/VolumeFile.h"
#include "Readers/XmlText.h"

#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace varimarch
{
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

}
