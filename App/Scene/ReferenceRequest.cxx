#include "Scene/ReferenceRequest.h"

#include "Core/Geometry/ScalarGrid.h"
#include "Core/Look/HeadLightShading.h"
#include "Frame/GrayRange.h"
#include "Frame/PropertyTransferFunction.h"
#include "Scene/LookRegions.h"
#include "Scene/ReferenceMaterial.h"
#include "Scene/SceneCuts.h"
#include "Scene/ScenePipeline.h"
#include "Scene/VolumeProperty.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkVolumeProperty.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>

namespace varimarch
{

namespace
{

vtkDataArray* CheckedScalars(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("Reference image: the volume must have one component, found " +
      std::to_string(scalars ? scalars->GetNumberOfComponents() : 0));
  }
  return scalars;
}

// Nothing if colours are not lit; projections show values.
std::optional<ReferenceLighting> LightingOf(
  const Scene& scene, const Look& look, vtkRenderer* renderer, const VolumeGeometry& geometry)
{
  const bool hasColors = look.blend == Blend::Composite || look.blend == Blend::Isosurface;
  return look.shading.enabled && hasColors
    ? std::optional(ReferenceLightingOf(scene, look, renderer->GetActiveCamera(), geometry))
    : std::nullopt;
}

// The interpolation of the mapper, whose isosurfaces are never cubic.
Interpolation InterpolationOf(const Scene& scene)
{
  const bool isLinear =
    scene.look.blend == Blend::Isosurface && scene.render.interpolation == Interpolation::Cubic;
  return isLinear ? Interpolation::Linear : scene.render.interpolation;
}

// Throws std::invalid_argument for the parts of scenes that the reference does not draw.
void CheckThatReferenceDraws(const Scene& scene)
{
  const std::tuple<bool, const char*> parts[] = {
    { scene.labels.has_value(), "a scene without labels" },
    { scene.render.firstDistanceMm > 0.0, "rays from the eye on, found a first distance" },
    { scene.look.blend != Blend::Composite && InterpolationOf(scene) != Interpolation::Linear,
      "linear interpolation, or a composite" },
  };
  for (const auto& [isFound, expected] : parts)
  {
    if (isFound)
    {
      throw std::invalid_argument(std::string("Reference image: expected ") + expected);
    }
  }
}

Occlusion WithReach(const Occlusion& occlusion, const VolumeGeometry& geometry)
{
  return { occlusion.strength, OcclusionReachMm(occlusion.reachMm, geometry) };
}

std::vector<double> IsovaluesOf(const Look& look)
{
  std::vector<double> isovalues;
  for (const Isosurface& surface : look.isosurfaces)
  {
    isovalues.push_back(surface.value);
  }
  return isovalues;
}

std::optional<ValueRange> AveragedRangeOf(const Look& look)
{
  const auto& range = look.averagedRange;
  return range ? std::optional(ValueRange{ (*range)[0], (*range)[1] }) : std::nullopt;
}

/// The rays of the pipeline's camera, which its mapper casts too.
ReferenceView ViewOf(const Scene& scene, vtkRenderer* renderer, const VolumeGeometry& geometry)
{
  const double aspect = double(scene.size[0]) / scene.size[1];
  vtkMatrix4x4* clipFromWorld =
    renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  const glm::dmat4 clipFromGrid = FromVtk(clipFromWorld) * geometry.worldFromGrid;
  return { ComputePixelRays(clipFromGrid, geometry.boxGrid), geometry.WorldFromGridDirection(),
    scene.size[0], scene.size[1] };
}

std::vector<glm::dvec4> PlanesInGrid(
  const std::vector<CutPlane>& planes, const VolumeGeometry& geometry)
{
  std::vector<glm::dvec4> planesGrid;
  for (const CutPlane& plane : planes)
  {
    const glm::dvec3 normal = glm::make_vec3(plane.normal.data());
    const glm::dvec4 planeWorld(normal, -glm::dot(normal, glm::make_vec3(plane.pointMm.data())));
    planesGrid.push_back(planeWorld * geometry.worldFromGrid);
  }
  return planesGrid;
}

HeadLight HeadLightOf(const Shading& shading)
{
  return { glm::dvec3(shading.ambient), glm::dvec3(shading.diffuse), glm::dvec3(shading.specular),
    shading.specularPower };
}

ReferenceScene SceneOf(const ReferenceRequest& request);

// The light that the volume lets through, by its opacities and cuts; null if all of it arrives.
std::shared_ptr<const LightTransmittance> TransmittanceOf(const ReferenceRequest& request)
{
  const bool castsShadows = request.lighting && request.lighting->castsShadows;
  if (!castsShadows && request.occlusion.strength == 0.0)
  {
    return nullptr;
  }
  struct Unlit
  {
    explicit Unlit(const ReferenceRequest& lit)
      : request(WithoutLight(lit))
      , transmittance(SceneOf(this->request), glm::inverse(lit.geometry.WorldFromGridDirection()),
          lit.tolerance)
    {
    }

    static ReferenceRequest WithoutLight(ReferenceRequest request)
    {
      request.lighting.reset();
      request.occlusion = {};
      return request;
    }

    ReferenceRequest request; // the scene of the transmittance refers to it
    LightTransmittance transmittance;
  };
  const auto unlit = std::make_shared<const Unlit>(request);
  return { unlit, &unlit->transmittance };
}

std::shared_ptr<const ReferenceMaterial> MaterialOf(const ReferenceRequest& request)
{
  return std::make_shared<const ReferenceMaterial>(request, TransmittanceOf(request));
}

// A plain light at the eye is integrated exactly; others are sampled, and so are values by their
// gradients and values without linear interpolation.
template <class Scalar>
void SetMaterial(
  const ReferenceRequest& request, const ScalarGrid<Scalar>& grid, ReferenceScene& scene)
{
  if (request.interpolation != Interpolation::Linear || !request.gradientOpacities.empty() ||
    !request.regions.empty())
  {
    const auto material = MaterialOf(request);
    scene.material = [material](glm::dvec3 positionGrid, const Ray& rayGrid)
    { return material->At(positionGrid, rayGrid); };
  }
  else if (request.lighting && request.lighting->IsPlainHeadLight() &&
    request.occlusion.strength == 0.0)
  {
    scene.shade = HeadLightShading(
      HeadLightOf(request.lighting->shading),
      [grid](glm::ivec3 cell) { return GradientsOfCell(grid, cell); },
      request.geometry.WorldFromGridDirection());
  }
  else if (request.lighting || request.occlusion.strength > 0.0)
  {
    const auto material = MaterialOf(request);
    scene.shade = [material](const CellPart& part, const Ray& rayGrid)
    { return material->LightAlong(part, rayGrid); };
  }
}

template <class Scalar>
ReferenceScene SceneOf(const ReferenceRequest& request, const Scalar* voxels)
{
  const ScalarGrid<Scalar> grid(voxels, request.geometry.dimensions);
  ReferenceScene scene{ [grid](glm::ivec3 cell) { return CornersOfCell(grid, cell); },
    request.geometry.boxGrid, request.transferFunction, request.blend };
  scene.averagedRange = request.averagedRange.value_or(scene.averagedRange);
  scene.grayRange = GrayRangeOf({ request.scalars, 0 }, scene.averagedRange);
  scene.isovalues = request.isovalues;
  if (!request.cuts.IsEmpty())
  {
    scene.uncutParts = [&request](const Ray& rayGrid, Interval inside)
    { return request.cuts.PartsOf(rayGrid, inside, request.geometry.dimensions); };
  }
  SetMaterial(request, grid, scene);
  return scene;
}

// The scene refers to the request.
ReferenceScene SceneOf(const ReferenceRequest& request)
{
  switch (request.scalars->GetDataType())
  {
    vtkTemplateMacro(
      return SceneOf(request, static_cast<const VTK_TT*>(request.scalars->GetVoidPointer(0))));
  }
  throw std::invalid_argument(std::string("Reference image: the volume must have numbers, "
                                          "found ") +
    request.scalars->GetDataTypeAsString());
}

}

ReferenceRequest ReferenceRequestFor(const Scene& scene, vtkImageData* image, double tolerance)
{
  CheckThatReferenceDraws(scene);
  vtkDataArray* scalars = CheckedScalars(image);
  ScenePipeline pipeline(scene, image, MapperKind::Varimarch);
  const VolumeGeometry geometry = VolumeGeometryOf(image, pipeline.Volume());
  const Look look = InUnitsOfData(scene.look, image);
  const bool isComposite = look.blend == Blend::Composite;
  return { scalars, geometry, MeanSpacingMm(image), LargestRegionGradient(image),
    InterpolationOf(scene), TransferFunctionOf(pipeline.Volume()->GetProperty()),
    isComposite ? look.gradientOpacities : std::vector<OpacityNode>(),
    isComposite ? look.regions : std::vector<LookRegion>(),
    LightingOf(scene, look, pipeline.Renderer(), geometry),
    isComposite ? WithReach(scene.occlusion, geometry) : Occlusion(), look.blend, IsovaluesOf(look),
    AveragedRangeOf(look), { PlanesInGrid(PlanesOf(scene.cuts, image), geometry), pipeline.Mask() },
    ViewOf(scene, pipeline.Renderer(), geometry), tolerance };
}

ReferenceIntegrator IntegratorOf(const ReferenceRequest& request)
{
  return ReferenceIntegrator(SceneOf(request), request.tolerance);
}

std::optional<ReferencePicture> PictureOf(const std::optional<ReferenceImage>& drawn)
{
  if (!drawn)
  {
    return std::nullopt;
  }
  ReferencePicture picture{ vtkSmartPointer<vtkImageData>::New(), drawn->largestError };
  picture.image->SetDimensions(drawn->width, drawn->height, 1);
  picture.image->AllocateScalars(VTK_FLOAT, 4);
  std::copy(
    drawn->rgba.begin(), drawn->rgba.end(), static_cast<float*>(picture.image->GetScalarPointer()));
  return picture;
}

std::optional<ReferencePicture> DrawReferencePicture(
  const ReferenceRequest& request, const ProgressFunction& progress)
{
  return PictureOf(DrawReference(IntegratorOf(request), request.view, progress));
}

}
