#include "Frame/SceneFingerprint.h"

#include "Frame/Frame.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"

namespace varimarch
{

namespace
{

vtkMTimeType TimeOf(vtkObject* object)
{
  return object ? object->GetMTime() : 0;
}

// The choices that the extinction depends on. All are named, so that a new one has to be sorted.
Fingerprint ExtinctionChoices(const RenderSettings& settings)
{
  const auto& [blend, acceleration, shading, sceneGeometry, integration, nearest, cubic, filter,
    uneven, clipping, cropping, clippedGradients, gaps, fillGaps, countFetches, skipsBricks, pass,
    role, damping, lights, shadows, softLights, casters, scattering, occlusion, mask, labelSurfaces,
    functionOf, components, componentCount, gradientOpacity, storedGradients, triesRays, jitter,
    windowLevel, limitsSpan, limitsMean, fromBehind, overlaps, shadowsOthers, occludesOthers,
    others] = settings;
  return Fingerprint(blend, acceleration, nearest, cubic, uneven, clipping, cropping,
    clippedGradients, fillGaps, mask, functionOf, components, componentCount, gradientOpacity);
}

/// The numbers of a material that an image depends on in any view.
struct MaterialNumbers
{
  Fingerprint ofExtinction;
  Fingerprint others;
};

// All are named, so that a new one has to be sorted.
MaterialNumbers NumbersOf(const MaterialRequest& material)
{
  const auto& [functions, reflectances, weights, clippedScalar, labelBlend, isovalues,
    surfaceComponent, dampingGradient, scatteredPart, anisotropy, surfacesInShadow, shadowReachMm,
    occlusion, occlusionReachMm, occluderVoxelMm, occludersMm, slice, averagedRange, gapOptical] =
    material;
  return { Fingerprint(functions.ofProperty, labelBlend, gapOptical.a),
    Fingerprint(reflectances, weights, clippedScalar, isovalues, surfaceComponent, dampingGradient,
      scatteredPart, anisotropy, surfacesInShadow, shadowReachMm, occlusion, occlusionReachMm,
      occluderVoxelMm, occludersMm, slice, averagedRange, glm::dvec3(gapOptical)) };
}

// The lights, if anything is lit.
Fingerprint LightsOf(const Frame& frame)
{
  if (!frame.settings.shading)
  {
    return {};
  }
  const SceneLights& lights = frame.lights;
  return Fingerprint(lights.areTwoSided, lights.head.diffuse, lights.head.specular, lights.ambient,
    lights.lamps.texels);
}

Fingerprint ViewOf(const Frame& frame)
{
  const Viewport& viewport = frame.view.viewport;
  return Fingerprint(viewport.left, viewport.bottom, viewport.width, viewport.height,
    frame.ClipFromGrid(), frame.geometry.worldFromGrid);
}

// The opaque geometry that may end rays, including that of lower layers.
Fingerprint GeometryOf(vtkOpenGLRenderWindow* window)
{
  Fingerprint geometry;
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
        geometry.Add(Fingerprint(prop, prop->GetVisibility(), prop->GetRedrawMTime()));
      }
    }
  }
  return geometry;
}

}

// Another array of the same image has no other time, and another image of the same array may have
// no other either.
Fingerprint VoxelFingerprint(const Frame& frame)
{
  return Fingerprint(frame.voxels.time, frame.voxels.components, frame.geometry.dimensions);
}

Fingerprint ExtinctionFingerprint(const Frame& frame)
{
  const Blanking& blanking = frame.voxels.blanking;
  return Fingerprint(VoxelFingerprint(frame), frame.voxels.mask, blanking, TimeOf(blanking.points),
    TimeOf(blanking.cells), frame.userCode.inputs, ExtinctionChoices(frame.settings),
    NumbersOf(frame.material).ofExtinction, frame.cuts);
}

Fingerprint UnlitFingerprint(const Frame& frame)
{
  return Fingerprint(ExtinctionFingerprint(frame), NumbersOf(frame.material).others);
}

Fingerprint VolumeFingerprint(const Frame& frame)
{
  return Fingerprint(UnlitFingerprint(frame), LightsOf(frame));
}

Fingerprint ImageFingerprint(vtkVariationFieldVolumeMapper* mapper, const Frame& frame)
{
  Fingerprint image(frame.fingerprint, frame.casters.fingerprint, frame.view.renderer,
    TimeOf(mapper), frame.settings.sceneGeometry, ViewOf(frame));
  if (frame.settings.sceneGeometry)
  {
    image.Add(GeometryOf(frame.view.window));
  }
  return image;
}

}
