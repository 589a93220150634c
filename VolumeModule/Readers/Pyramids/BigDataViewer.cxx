#include "Readers/Pyramids/BigDataViewer.h"

#include "Readers/FileError.h"
#include "Readers/HeaderText.h"
#include "Readers/NumberText.h"
#include "Readers/VolumeFile.h"
#include "Readers/XmlText.h"

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
  return glm::dvec3(numbers[0], numbers[1], numbers[2]) * mmPerUnit;
}

}
