#include "Scene/ReferenceRequest.h"

#include "Frame/GrayRange.h"
#include "Frame/PropertyTransferFunction.h"
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

std::optional<HeadLight> LightOf(const Shading& shading, Blend blend)
{
  if (!shading.enabled || (blend != Blend::Composite && blend != Blend::Isosurface))
  {
    return std::nullopt;
  }
  return HeadLight{ glm::dvec3(shading.ambient), glm::dvec3(shading.diffuse),
    glm::dvec3(shading.specular), shading.specularPower };
}

// Throws std::invalid_argument for the parts of scenes that the reference does not draw.
void CheckThatReferenceDraws(const Scene& scene)
{
  const bool shaded = LightOf(scene.look.shading, scene.look.blend).has_value();
  const std::tuple<bool, const char*> parts[] = {
    { !scene.cuts.scissors.empty(), "cuts by planes or the box only, found cuts by scissors" },
    { !scene.look.gradientOpacities.empty(), "a look without gradient opacity" },
    { !scene.look.regions.empty(), "a look without regions" },
    { shaded && !scene.lights.empty(), "the light at the eye only, found the key \"lights\"" },
    { shaded && scene.look.dampingGradient > 0.0, "a look without damping" },
    { scene.render.interpolation != Interpolation::Linear, "linear interpolation" },
  };
  for (const auto& [isFound, expected] : parts)
  {
    if (isFound)
    {
      throw std::invalid_argument(std::string("Reference image: expected ") + expected);
    }
  }
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
  const glm::dmat4 clipFromGrid =
    glm::transpose(glm::make_mat4(clipFromWorld->GetData())) * geometry.worldFromGrid;
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

template <class Scalar>
ReferenceScene SceneOf(const ReferenceRequest& request, const Scalar* voxels)
{
  const ScalarGrid<Scalar> grid(voxels, request.geometry.dimensions);
  ReferenceScene scene{ [grid](glm::ivec3 cell) { return CornersOfCell(grid, cell); },
    request.geometry.boxGrid, request.transferFunction, request.blend };
  scene.averagedRange = request.averagedRange.value_or(scene.averagedRange);
  scene.grayRange = GrayRangeOf({ request.scalars, 0 }, scene.averagedRange);
  scene.isovalues = request.isovalues;
  if (!request.cutPlanesGrid.empty())
  {
    scene.uncutParts = [planes = request.cutPlanesGrid](const Ray& rayGrid, Interval inside)
    {
      for (const glm::dvec4& plane : planes)
      {
        inside = PositivePart(plane, rayGrid, inside);
      }
      return inside.IsEmpty() ? std::vector<Interval>() : std::vector<Interval>{ inside };
    };
  }
  if (request.light)
  {
    scene.shade = HeadLightShading(
      *request.light, [grid](glm::ivec3 cell) { return GradientsOfCell(grid, cell); },
      request.geometry.WorldFromGridDirection());
  }
  return scene;
}

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
  return { scalars, geometry, TransferFunctionOf(pipeline.Volume()->GetProperty()),
    LightOf(scene.look.shading, scene.look.blend), scene.look.blend,
    IsovaluesOf(InUnitsOfData(scene.look, image)),
    AveragedRangeOf(InUnitsOfData(scene.look, image)),
    PlanesInGrid(PlanesOf(scene.cuts, image), geometry),
    ViewOf(scene, pipeline.Renderer(), geometry), tolerance };
}

std::optional<ReferencePicture> DrawReferencePicture(
  const ReferenceRequest& request, const ProgressFunction& progress)
{
  const ReferenceIntegrator integrator(SceneOf(request), request.tolerance);
  const std::optional<ReferenceImage> drawn = DrawReference(integrator, request.view, progress);
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

}
