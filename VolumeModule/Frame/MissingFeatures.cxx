#include "Frame/MissingFeatures.h"

#include "Frame/FrameBuilder.h"
#include "Frame/MapperInput.h"
#include "Frame/OverlappingVolumes.h"
#include "Frame/PropertyTransferFunction.h"
#include "Frame/UserShaderCode.h"
#include "VtkVersions.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkDataArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <stdexcept>

namespace varimarch
{

namespace
{

int ComponentCount(vtkVariationFieldVolumeMapper* mapper, int port)
{
  const std::optional<MapperInput> input = InputOf(mapper, port);
  return input ? input->scalars->GetNumberOfComponents() : 0;
}

// Sentences about settings that VTK 9.1 does not have.
std::string MissingNewFeatures(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume)
{
  std::string missing;
  if (ShadesByOpacity(mapper))
  {
    missing += "Normals of the opacity (ComputeNormalFromOpacity) are not supported yet. ";
  }
  if (WritesDepth(volume))
  {
    missing +=
      "Depths of a volume in the depth buffer (GLDepthMaskOverride) are not supported yet. ";
  }
  return missing;
}

}

std::string MissingFeatures(vtkVariationFieldVolumeMapper* mapper, vtkVolume* volume)
{
  bool twoValues = false;
  bool labels = false;
  std::string ofFunctions;
  for (const VolumeOfPort& one : VolumesOfPorts(mapper, volume))
  {
    vtkVolumeProperty* const property = one.volume->GetProperty();
    const int components = ComponentCount(mapper, one.port);
    const bool hasComponents = components > 1;
    const int mode = property->GetTransferFunctionMode();
    const int withFunctions =
      property->GetIndependentComponents() ? std::min(components, 4) : std::min(components, 1);
    const std::string ofVolume = MissingFunctionFeatures(property, withFunctions);
    ofFunctions += ofFunctions == ofVolume ? "" : ofVolume;
    twoValues = twoValues ||
      (mode == vtkVolumeProperty::TF_2D &&
        (mapper->GetBlendMode() != vtkVolumeMapper::COMPOSITE_BLEND || hasComponents));
    const bool hasSecondArray = mode == vtkVolumeProperty::TF_2D &&
      mapper->GetTransfer2DYAxisArray() && *mapper->GetTransfer2DYAxisArray();
    labels = labels ||
      (mapper->GetMaskInput() && (hasComponents || hasSecondArray) &&
        mapper->GetMaskType() == vtkVariationFieldVolumeMapper::LabelMapMaskType);
  }
  std::string missing;
  if (twoValues)
  {
    missing +=
      "Transfer functions of two values are supported only for composites of one component. ";
  }
  if (labels)
  {
    missing += "Label maps are supported only for volumes of one component, without a second "
               "array of values. ";
  }
  return missing + ofFunctions + MissingNewFeatures(mapper, volume) + MissingShaderCode(volume);
}

std::string UnsupportedFeature(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  try
  {
    BuildFrame(mapper, renderer, volume);
  }
  catch (const std::invalid_argument&)
  {
    return {}; // No mapper can draw numbers without a meaning, and this one says which they are.
  }
  catch (const std::exception& problem)
  {
    return problem.what();
  }
  return MissingFeatures(mapper, volume);
}

}
