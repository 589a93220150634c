#include "Scene/ReferenceRequest.h"

#include "PropertyTransferFunction.h"
#include "Scene/ScenePipeline.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkVolumeProperty.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace varimarch
{

namespace
{

vtkDataArray* CheckedScalars(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("Reference picture: the volume must have one component, found " +
      std::to_string(scalars ? scalars->GetNumberOfComponents() : 0));
  }
  return scalars;
}

std::optional<HeadLight> LightOf(const Shading& shading, Blend blend)
{
  if (!shading.enabled || blend != Blend::Composite)
  {
    return std::nullopt;
  }
  return HeadLight{ glm::dvec3(shading.ambient), glm::dvec3(shading.diffuse),
    glm::dvec3(shading.specular), shading.specularPower };
}

/// The rays of the pipeline's camera: those of its mapper too.
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

template <class Scalar>
ReferenceScene SceneOf(const ReferenceRequest& request, const Scalar* voxels)
{
  const ScalarGrid<Scalar> grid(voxels, request.geometry.dimensions);
  ReferenceScene scene{ [grid](glm::ivec3 cell) { return CornersOfCell(grid, cell); },
    request.geometry.boxGrid, request.transferFunction, request.blend };
  double range[2];
  request.scalars->GetFiniteRange(range);
  scene.grayRange = { range[0], range[1] };
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
  throw std::invalid_argument(std::string("Reference picture: the volume must have numbers, "
                                          "found ") +
    request.scalars->GetDataTypeAsString());
}

}

ReferenceRequest ReferenceRequestFor(const Scene& scene, vtkImageData* image, double tolerance)
{
  vtkDataArray* scalars = CheckedScalars(image);
  ScenePipeline pipeline(scene, image, MapperKind::Varimarch);
  const VolumeGeometry geometry = VolumeGeometryOf(image, pipeline.Volume());
  return { scalars, geometry, TransferFunctionOf(pipeline.Volume()->GetProperty()),
    LightOf(scene.look.shading, scene.look.blend), scene.look.blend,
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
