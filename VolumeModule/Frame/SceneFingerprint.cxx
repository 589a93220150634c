#include "Frame/SceneFingerprint.h"

#include "Frame/Frame.h"
#include "Frame/Lights.h"
#include "Frame/PropertyTransferFunction.h"
#include "Frame/VolumeGeometry.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkImplicitFunction.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLUniforms.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkShaderProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <glm/gtc/type_ptr.hpp>

#include <cstdint>

namespace varimarch
{

namespace
{

using Numbers = std::vector<double>;

void Append(Numbers& numbers, const Numbers& more)
{
  numbers.insert(numbers.end(), more.begin(), more.end());
}

double TimeOf(vtkObject* object)
{
  return object ? double(object->GetMTime()) : 0.0;
}

// A number that tells one object from another.
double AddressOf(const void* object)
{
  return double(reinterpret_cast<std::uintptr_t>(object));
}

// The lights, if anything is lit.
Numbers LightsOf(const Frame& frame)
{
  if (!frame.settings.shading)
  {
    return {};
  }
  vtkRenderer* const renderer = frame.view.renderer;
  const HeadLightColors head = HeadLightColorsOf(renderer);
  const glm::dvec3 ambient = AmbientLightOf(renderer);
  Numbers numbers = { double(renderer->GetTwoSidedLighting()) };
  for (const glm::dvec3& color : { head.diffuse, head.specular, ambient })
  {
    numbers.insert(numbers.end(), glm::value_ptr(color), glm::value_ptr(color) + 3);
  }
  for (const glm::vec4& texel : LightTexelsOf(renderer).texels)
  {
    numbers.insert(numbers.end(), glm::value_ptr(texel), glm::value_ptr(texel) + 4);
  }
  return numbers;
}

Numbers ViewOf(const Frame& frame)
{
  const glm::dmat4 clipFromGrid = ClipFromWorld(frame.view.renderer) * frame.geometry.worldFromGrid;
  const Viewport& viewport = frame.view.viewport;
  Numbers numbers = { double(viewport.left), double(viewport.bottom), double(viewport.width),
    double(viewport.height) };
  numbers.insert(numbers.end(), glm::value_ptr(clipFromGrid), glm::value_ptr(clipFromGrid) + 16);
  const glm::dmat4& world = frame.geometry.worldFromGrid;
  numbers.insert(numbers.end(), glm::value_ptr(world), glm::value_ptr(world) + 16);
  return numbers;
}

// The modification times of a property, and of its functions whose changes it does not report.
Numbers FunctionsOf(vtkVolumeProperty* property)
{
  Numbers numbers = { TimeOf(property), TimeOf(property->GetSliceFunction()) };
  for (const int label : LabelsOf(property))
  {
    Append(numbers,
      { double(label), TimeOf(property->GetLabelColor(label)),
        TimeOf(property->GetLabelScalarOpacity(label)),
        TimeOf(property->GetLabelGradientOpacity(label)) });
  }
  return numbers;
}

// The opaque geometry that may end rays, including that of lower layers.
Numbers GeometryOf(vtkOpenGLRenderWindow* window)
{
  Numbers numbers;
  vtkRendererCollection* const renderers = window->GetRenderers();
  vtkCollectionSimpleIterator iterator;
  renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(iterator))
  {
    vtkPropCollection* const props = renderer->GetViewProps();
    vtkCollectionSimpleIterator propIterator;
    props->InitTraversal(propIterator);
    while (vtkProp* prop = props->GetNextProp(propIterator))
    {
      if (!vtkVolume::SafeDownCast(prop))
      {
        Append(numbers,
          { AddressOf(prop), double(prop->GetVisibility()), double(prop->GetRedrawMTime()) });
      }
    }
  }
  return numbers;
}

}

// Another array of the same image has no other time.
std::vector<double> VoxelFingerprint(const VoxelInput& voxels)
{
  Numbers numbers = { double(voxels.time) };
  for (const VoxelComponent& component : voxels.components)
  {
    Append(numbers, { AddressOf(component.array), double(component.index) });
  }
  return numbers;
}

std::vector<double> ExtinctionFingerprint(const Frame& frame)
{
  vtkShaderProperty* const shader = frame.view.prop->GetShaderProperty();
  auto* const uniforms = vtkOpenGLUniforms::SafeDownCast(shader->GetFragmentCustomUniforms());
  const VoxelInput& voxels = frame.voxels;
  Numbers numbers = VoxelFingerprint(voxels);
  Append(numbers,
    { AddressOf(voxels.mask.labels), double(voxels.mask.time), double(frame.settings.mask),
      TimeOf(voxels.blanking.points), TimeOf(voxels.blanking.cells) });
  Append(numbers,
    { double(shader->GetShaderMTime()), uniforms ? double(uniforms->GetUniformListMTime()) : 0.0 });
  Append(numbers, frame.material.NumbersOfExtinction());
  Append(numbers, frame.cuts.Numbers());
  Append(numbers, FunctionsOf(frame.material.property));
  return numbers;
}

std::vector<double> VolumeFingerprint(const Frame& frame)
{
  Numbers numbers = ExtinctionFingerprint(frame);
  Append(numbers, frame.material.OtherNumbers());
  Append(numbers, LightsOf(frame));
  return numbers;
}

std::vector<double> ImageFingerprint(vtkVariationFieldVolumeMapper* mapper, const Frame& frame)
{
  Numbers numbers = frame.fingerprint;
  Append(numbers, frame.casters.fingerprint);
  Append(numbers,
    { AddressOf(frame.view.renderer), TimeOf(mapper), double(frame.settings.sceneGeometry) });
  Append(numbers, ViewOf(frame));
  if (frame.settings.sceneGeometry)
  {
    Append(numbers, GeometryOf(frame.view.window));
  }
  return numbers;
}

}
