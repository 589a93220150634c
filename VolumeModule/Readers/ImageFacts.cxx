#include "Readers/ImageFacts.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace varimarch
{
namespace
{

constexpr const char* PatientFact = "ShowsPatient";
constexpr const char* LowestFact = "LowestInside";
constexpr const char* ColorsFact = "ChannelColors";

constexpr const char* Alpha = "Alpha";

std::vector<std::string> NamesOfColors(int componentCount)
{
  if (componentCount == 2)
  {
    return { "Luminance", Alpha };
  }
  std::vector<std::string> names = { "Red", "Green", "Blue", Alpha };
  names.resize(std::size_t(std::min(componentCount, 4)));
  return names;
}

std::string NameOf(vtkDataArray* scalars, int component)
{
  const char* const name = scalars->GetComponentName(component);
  return name ? name : "";
}

void KeepNumber(const char* name, double number, vtkImageData* image)
{
  vtkNew<vtkDoubleArray> fact;
  fact->SetName(name);
  fact->InsertNextValue(number);
  image->GetFieldData()->AddArray(fact);
}

std::optional<double> NumberOf(vtkImageData* image, const char* name)
{
  vtkDataArray* const fact = image->GetFieldData()->GetArray(name);
  return fact && fact->GetNumberOfValues() > 0 ? std::optional<double>(fact->GetComponent(0, 0))
                                               : std::nullopt;
}

/// The colours of the channels; null if the image has none.
vtkDataArray* ColorsOf(vtkImageData* image)
{
  vtkDataArray* const colors = image->GetFieldData()->GetArray(ColorsFact);
  const bool fits = colors && colors->GetNumberOfComponents() == 3 &&
    colors->GetNumberOfTuples() == image->GetNumberOfScalarComponents();
  return fits ? colors : nullptr;
}

/// Keeps the names, and the colours if the file gives one to each channel.
void KeepChannels(const std::vector<VolumeChannel>& channels, vtkImageData* image)
{
  vtkNew<vtkDoubleArray> colors;
  colors->SetName(ColorsFact);
  colors->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < channels.size(); ++i)
  {
    const VolumeChannel& channel = channels[i];
    if (!channel.name.empty())
    {
      image->GetPointData()->GetScalars()->SetComponentName(vtkIdType(i), channel.name.c_str());
    }
    if (channel.rgb)
    {
      colors->InsertNextTuple(glm::value_ptr(*channel.rgb));
    }
  }
  if (colors->GetNumberOfTuples() == vtkIdType(channels.size()))
  {
    image->GetFieldData()->AddArray(colors);
  }
}

}

void KeepFacts(const Volume& volume, vtkImageData* image)
{
  if (volume.showsPatient)
  {
    KeepNumber(PatientFact, 1.0, image);
  }
  if (volume.lowestInside)
  {
    KeepNumber(LowestFact, *volume.lowestInside, image);
  }
  const int componentCount = image->GetNumberOfScalarComponents();
  if (volume.holdsColors && componentCount > 1)
  {
    const std::vector<std::string> names = NamesOfColors(componentCount);
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      image->GetPointData()->GetScalars()->SetComponentName(vtkIdType(i), names[i].c_str());
    }
  }
  else if (componentCount > 1 && int(volume.channels.size()) == componentCount)
  {
    KeepChannels(volume.channels, image);
  }
}

bool ShowsPatient(vtkImageData* image)
{
  return NumberOf(image, PatientFact).value_or(0.0) != 0.0;
}

std::optional<double> LowestInside(vtkImageData* image)
{
  return NumberOf(image, LowestFact);
}

bool HoldsColors(vtkImageData* image)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  const int componentCount = scalars ? scalars->GetNumberOfComponents() : 0;
  if (componentCount < 2 || componentCount > 4)
  {
    return false;
  }
  if (scalars->HasAComponentName())
  {
    std::vector<std::string> names;
    for (int i = 0; i < componentCount; ++i)
    {
      names.push_back(NameOf(scalars, i));
    }
    return names == NamesOfColors(componentCount);
  }
  return componentCount > 2 && scalars->GetDataType() == VTK_UNSIGNED_CHAR;
}

std::vector<VolumeChannel> ChannelsIn(vtkImageData* image)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  const int componentCount = scalars ? scalars->GetNumberOfComponents() : 0;
  if (componentCount < 2 || HoldsColors(image))
  {
    return {};
  }
  vtkDataArray* const colors = ColorsOf(image);
  std::vector<VolumeChannel> channels;
  for (int i = 0; i < componentCount; ++i)
  {
    VolumeChannel channel = { NameOf(scalars, i), {} };
    if (colors)
    {
      channel.rgb = glm::clamp(glm::dvec3(glm::make_vec3(colors->GetTuple3(i))), 0.0, 1.0);
    }
    channels.push_back(channel);
  }
  return channels;
}

}
