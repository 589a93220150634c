#include "Scene/Reference/ReferenceRequest.h"

#include "Core/Geometry/CellWalk.h"
#include "Core/Geometry/LightCone.h"
#include "Core/Geometry/ScalarGrid.h"
#include "Core/Look/HeadLightShading.h"
#include "Core/Reference/PathTracer.h"
#include "Frame/FiniteRange.h"
#include "Frame/PropertyTransferFunction.h"
#include "Scene/Looks/LookRegions.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Model/WorldVector.h"
#include "Scene/Pipeline/ScenePipeline.h"
#include "Scene/Reference/ReferenceMaterial.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkVolumeProperty.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
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

namespace
{

// Clips an interval of a ray to the positive side of a plane.
Interval PositivePart(const glm::dvec4& plane, const Ray& ray, Interval part)
{
  const double atOrigin = glm::dot(plane, glm::dvec4(ray.origin, 1.0));
  const double perLength = glm::dot(glm::dvec3(plane), ray.direction);
  if (perLength == 0.0)
  {
    return atOrigin >= 0.0 ? part : Interval{ 0.0, 0.0 };
  }
  double& end = perLength > 0.0 ? part.enter : part.exit;
  const double crossing = -atOrigin / perLength;
  end = perLength > 0.0 ? std::max(end, crossing) : std::min(end, crossing);
  return part;
}

// Each voxel of a mask fills the box around it.
std::vector<Interval> KeptParts(
  vtkImageData* mask, const Ray& rayGrid, Interval inside, glm::ivec3 dimensions)
{
  const glm::ivec3 last = glm::make_vec3(mask->GetDimensions()) - 1;
  const glm::dvec3 maskPerGrid = glm::dvec3(last + 1) / glm::dvec3(dimensions);
  const Ray rayMask{ (rayGrid.origin + 0.5) * maskPerGrid, rayGrid.direction * maskPerGrid };
  std::vector<Interval> parts;
  WalkCells(rayMask, inside,
    [&](const CellPart& part)
    {
      const glm::ivec3 voxel = glm::clamp(part.cell, glm::ivec3(0), last);
      const bool isKept =
        *static_cast<const unsigned char*>(mask->GetScalarPointer(voxel.x, voxel.y, voxel.z)) != 0;
      if (isKept && !parts.empty() && parts.back().exit == part.t.enter)
      {
        parts.back().exit = part.t.exit;
      }
      else if (isKept)
      {
        parts.push_back(part.t);
      }
      return true;
    });
  return parts;
}

}

std::vector<Interval> ReferenceCuts::PartsOf(
  const Ray& rayGrid, Interval inside, glm::ivec3 dimensions) const
{
  for (const glm::dvec4& plane : this->planesGrid)
  {
    inside = PositivePart(plane, rayGrid, inside);
  }
  if (inside.IsEmpty())
  {
    return {};
  }
  return this->mask ? KeptParts(this->mask, rayGrid, inside, dimensions)
                    : std::vector<Interval>{ inside };
}

namespace
{

PlacedLight Placed(const SceneLight& light, const glm::dmat3& worldFromView)
{
  const glm::dvec3 rgb = light.intensity * VectorOf(light.rgb);
  switch (light.kind)
  {
    case LightKind::Head:
      return { light.kind, rgb, {}, 0.0 };
    case LightKind::Camera:
      return { light.kind, rgb, worldFromView * glm::normalize(VectorOf(light.direction)),
        light.softnessDegrees };
    case LightKind::Directional:
      return { light.kind, rgb, glm::normalize(VectorOf(light.direction)), light.softnessDegrees };
    default:
      return { light.kind, rgb, VectorOf(light.positionMm), light.softnessDegrees };
  }
}

glm::dvec3 TowardsLight(const PlacedLight& light, const LitPoint& point)
{
  switch (light.kind)
  {
    case LightKind::Head:
      return point.toEye;
    case LightKind::Positional:
      return glm::normalize(light.place - point.positionMm);
    default:
      return light.place;
  }
}

double DistanceMm(const PlacedLight& light, const LitPoint& point)
{
  return light.kind == LightKind::Positional ? glm::length(light.place - point.positionMm)
                                             : std::numeric_limits<double>::infinity();
}

// The unit vector half way between two others; 0 if they are opposite.
glm::dvec3 HalfWay(glm::dvec3 one, glm::dvec3 other)
{
  const glm::dvec3 sum = one + other;
  const double length = glm::length(sum);
  return length > 0.0 ? sum / length : glm::dvec3(0.0);
}

// The mean over the directions that a light comes from.
double Arriving(
  const PlacedLight& light, glm::dvec3 towards, double farMm, const LightReaching& reaching)
{
  if (light.softnessDegrees == 0.0)
  {
    return reaching(towards, farMm);
  }
  double sum = 0.0;
  for (const auto& [direction, weight] :
    DirectionsInCone(towards, glm::radians(light.softnessDegrees)))
  {
    sum += weight * reaching(direction, farMm);
  }
  return sum;
}

/// Columns are the image's axes to the right, upwards and towards the eye.
glm::dmat3 WorldFromView(vtkCamera* camera)
{
  // The matrix of VTK has its rows one after the other: reading them as columns inverts a rotation.
  return glm::dmat3(glm::make_mat4(camera->GetViewTransformMatrix()->GetData()));
}

}

bool ReferenceLighting::IsPlainHeadLight() const
{
  return this->scatteredPart == 0.0 && this->dampingGradient == 0.0 && this->lights.size() == 1 &&
    this->lights[0].kind == LightKind::Head && this->lights[0].rgb == glm::dvec3(1.0);
}

glm::dvec3 ReferenceLighting::Lit(const LitPoint& point, const LightReaching& reaching) const
{
  const auto facing = [&](glm::dvec3 direction)
  {
    const double cosine = glm::dot(point.normal, direction);
    return std::clamp(this->lightsBacks ? std::abs(cosine) : cosine, 0.0, 1.0);
  };
  const double undamped =
    this->dampingGradient > 0.0 ? std::min(point.gradientPerMm / this->dampingGradient, 1.0) : 1.0;
  glm::dvec3 diffuse(0.0);
  glm::dvec3 specular(0.0);
  for (const PlacedLight& light : this->lights)
  {
    const glm::dvec3 towards = TowardsLight(light, point);
    const double cosine = facing(towards);
    if (cosine == 0.0 && this->scatteredPart == 0.0)
    {
      continue;
    }
    const bool isDimmed = reaching && light.kind != LightKind::Head;
    const double arriving =
      isDimmed ? Arriving(light, towards, DistanceMm(light, point), reaching) : 1.0;
    const double onSurfaces =
      (1.0 - this->scatteredPart) * undamped * glm::mix(1.0, arriving, this->surfacesInShadow);
    const double scattered = this->scatteredPart * arriving *
      HenyeyGreenstein(-glm::dot(towards, point.toEye), this->anisotropy);
    const double shining = cosine > 0.0 ? facing(HalfWay(towards, point.toEye)) : 0.0;
    diffuse += (onSurfaces * cosine + scattered) * light.rgb;
    specular += onSurfaces * std::pow(shining, this->shading.specularPower) * light.rgb;
  }
  return point.rgb * (this->shading.ambient + this->shading.diffuse * diffuse) +
    this->shading.specular * specular;
}

ReferenceLighting ReferenceLightingOf(
  const Scene& scene, const Look& look, vtkCamera* camera, const VolumeGeometry& geometry)
{
  const std::vector<SceneLight>& lights = scene.lights;
  const bool hasHeadLightsOnly = std::all_of(lights.begin(), lights.end(),
    [](const SceneLight& light) { return light.kind == LightKind::Head; });
  const bool isComposite = look.blend == Blend::Composite;
  const Scattering scattering = isComposite ? scene.scattering : Scattering();
  const bool dimsScattered = scattering.blending > 0.0 && scattering.reach > 0.0;
  ReferenceLighting lighting{ look.shading, look.dampingGradient, {}, hasHeadLightsOnly,
    isComposite && (scene.shadows > 0.0 || dimsScattered), scene.shadows,
    ShadowReachMm(scene.shadows > 0.0 ? 1.0 : scattering.reach, geometry),
    std::min(scattering.blending, 1.0), scattering.anisotropy };
  const glm::dmat3 worldFromView = WorldFromView(camera);
  for (const SceneLight& light : lights.empty() ? std::vector<SceneLight>(1) : lights)
  {
    lighting.lights.push_back(Placed(light, worldFromView));
  }
  return lighting;
}

}
