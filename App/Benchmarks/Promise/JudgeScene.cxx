#include "JudgeScene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkContourValues.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkInformationIntegerKey.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkVariationFieldVolumeMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace varimarch
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

glm::dmat4 MatrixOf(vtkMatrix4x4* matrix)
{
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}

void ReadVoxels(JudgeVolume& read, vtkImageData* image)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  read.size = glm::make_vec3(image->GetDimensions());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    read.voxels.push_back(scalars->GetComponent(i, 0));
  }
}

void ReadPlace(JudgeVolume& read, vtkImageData* image, vtkVolume* volume)
{
  const int* const extent = image->GetExtent();
  const double* const spacing = image->GetSpacing();
  read.dataFromGrid = MatrixOf(image->GetIndexToPhysicalMatrix()) *
    glm::translate(glm::dmat4(1.0), glm::dvec3(extent[0], extent[2], extent[4]));
  read.worldFromGrid = MatrixOf(volume->GetMatrix()) * read.dataFromGrid;
  const double mean = (spacing[0] + spacing[1] + spacing[2]) / 3.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const bool isThin = read.size[axis] == 1;
    read.boxLower[axis] = isThin ? -0.5 : 0.0;
    read.boxUpper[axis] = isThin ? 0.5 : read.size[axis] - 1.0;
    read.magnitudeFactors[axis] = mean / spacing[axis];
  }
}

// The look of each voxel by its label, or -1 where a binary mask hides it.
void ReadMask(JudgeVolume& read, vtkVariationFieldVolumeMapper* mapper, vtkVolumeProperty* property)
{
  vtkImageData* const mask = mapper->GetMaskInput();
  if (!mask)
  {
    return;
  }
  vtkDataArray* const contents = mask->GetPointData()->GetScalars();
  const bool isBinary = mapper->GetMaskType() == vtkVariationFieldVolumeMapper::BinaryMaskType;
  std::vector<int> labels;
  for (const int label : property->GetLabelMapLabels())
  {
    if (!isBinary && label != 0)
    {
      labels.push_back(label);
      read.looks.emplace_back(LabelFunctionsOf(property, label));
    }
  }
  for (vtkIdType i = 0; i < contents->GetNumberOfTuples(); ++i)
  {
    const double content = contents->GetComponent(i, 0);
    const auto label = std::find(labels.begin(), labels.end(), int(content));
    const int ofLabel = label == labels.end() ? 0 : int(label - labels.begin()) + 1;
    read.lookOfVoxel.push_back(isBinary ? (content > 0.0 ? 0 : -1) : ofLabel);
  }
}

void ReadCuts(JudgeVolume& read, vtkVariationFieldVolumeMapper* mapper)
{
  vtkPlaneCollection* const planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    const glm::dvec3 normal = glm::make_vec3(planes->GetItem(i)->GetNormal());
    const glm::dvec3 origin = glm::make_vec3(planes->GetItem(i)->GetOrigin());
    read.clippingPlanes.emplace_back(normal, -glm::dot(normal, origin));
  }
  read.isCropped = mapper->GetCropping() != 0;
  std::copy_n(mapper->GetCroppingRegionPlanes(), 6, read.croppingPlanes.begin());
  read.croppingFlags = mapper->GetCroppingRegionFlags();
}

JudgeVolume VolumeOf(vtkImageData* image, vtkVolume* volume, vtkVariationFieldVolumeMapper* mapper)
{
  JudgeVolume read = {};
  vtkVolumeProperty* const property = volume->GetProperty();
  ReadVoxels(read, image);
  ReadPlace(read, image, volume);
  read.looks.emplace_back(FunctionsOf(property, 0));
  read.unitDistanceMm = property->GetScalarOpacityUnitDistance();
  ReadMask(read, mapper, property);
  ReadCuts(read, mapper);
  read.isNearest = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  read.isShaded = property->GetShade() != 0;
  read.ambient = property->GetAmbient();
  read.diffuse = property->GetDiffuse();
  read.specular = property->GetSpecular();
  read.specularPower = property->GetSpecularPower();
  const bool hasGradientOpacity = std::any_of(read.looks.begin(), read.looks.end(),
    [](const JudgeLook& look) { return look.HasGradientOpacity(); });
  read.Prepare(read.isShaded || hasGradientOpacity || mapper->GetAmbientOcclusion() > 0.0);
  return read;
}

JudgeLamp LampOf(vtkLight* light)
{
  JudgeLamp lamp = {};
  vtkInformationDoubleKey* const softness = vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS();
  const double intensity = light->GetIntensity();
  lamp.isNear = light->GetPositional() != 0;
  lamp.isAtEye = light->LightTypeIsHeadlight() && !lamp.isNear;
  lamp.position = glm::make_vec3(light->GetTransformedPosition());
  lamp.shinesAlong =
    glm::normalize(glm::make_vec3(light->GetTransformedFocalPoint()) - lamp.position);
  lamp.diffuse = intensity * glm::make_vec3(light->GetDiffuseColor());
  lamp.specular = intensity * glm::make_vec3(light->GetSpecularColor());
  lamp.attenuation = glm::make_vec3(light->GetAttenuationValues());
  lamp.coneDegrees = light->GetConeAngle();
  lamp.exponent = light->GetExponent();
  lamp.softnessDegrees =
    light->GetInformation()->Has(softness) ? light->GetInformation()->Get(softness) : 0.0;
  return lamp;
}

// Ambient light is that of the lights, or white if all are at the eye.
void ReadLights(JudgeScene& scene, vtkRenderer* renderer)
{
  bool allAreAtEye = true;
  scene.ambientLight = glm::dvec3(0.0);
  vtkCollectionSimpleIterator iterator;
  renderer->GetLights()->InitTraversal(iterator);
  while (vtkLight* light = renderer->GetLights()->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      scene.lamps.push_back(LampOf(light));
      allAreAtEye = allAreAtEye && scene.lamps.back().isAtEye;
      scene.ambientLight += light->GetIntensity() * glm::make_vec3(light->GetAmbientColor());
    }
  }
  scene.ambientLight = allAreAtEye ? glm::dvec3(1.0) : scene.ambientLight;
  scene.isTwoSided = renderer->GetTwoSidedLighting() != 0;
}

void ReadLightSettings(JudgeScene& scene, vtkVariationFieldVolumeMapper* mapper)
{
  constexpr double Exponent = 0.33;
  constexpr double UsualVoxels = 16.0;
  scene.hasShadows = mapper->GetShadows() != 0;
  scene.shadowStrength = mapper->GetShadowStrength();
  scene.scatteredPart = std::min(mapper->GetVolumetricScatteringBlending(), 1.0);
  scene.anisotropy = std::clamp(mapper->GetScatteringAnisotropy(), -0.99, 0.99);
  const double reach = mapper->GetGlobalIlluminationReach();
  const JudgeVolume& first = scene.volumes.front();
  scene.scatterReachMm = scene.hasShadows || reach >= 1.0
    ? Infinite
    : first.diagonalMm * (1.0 - std::pow(1.0 - reach, Exponent));
  scene.occlusion = mapper->GetAmbientOcclusion();
  const double chosen = mapper->GetAmbientOcclusionReach();
  scene.occlusionReachMm = chosen > 0.0 ? chosen : UsualVoxels * first.smallestSpacingMm;
}

void ReadGeometry(JudgeScene& scene, vtkActor* actor)
{
  vtkInformation* const keys = actor->GetPropertyKeys();
  vtkInformationIntegerKey* const casts = vtkVariationFieldVolumeMapper::CASTS_SHADOWS();
  const bool isCasting = !(keys && keys->Has(casts) && keys->Get(casts) == 0);
  const glm::dmat4 world = MatrixOf(actor->GetMatrix());
  auto* const mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  mapper->Update();
  vtkPolyData* const faces = mapper->GetInput();
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  vtkCellArray* const polygons = faces->GetPolys();
  const auto corner = [&](vtkIdType point)
  { return glm::dvec3(world * glm::dvec4(glm::make_vec3(faces->GetPoint(point)), 1.0)); };
  for (polygons->InitTraversal(); polygons->GetNextCell(count, points);)
  {
    for (vtkIdType i = 2; i < count; ++i)
    {
      const JudgeTriangle triangle = { corner(points[0]), corner(points[i - 1]),
        corner(points[i]) };
      scene.seen.push_back(triangle);
      if (isCasting)
      {
        scene.casting.push_back(triangle);
      }
    }
  }
}

void ReadView(JudgeScene& scene, vtkRenderer* renderer)
{
  vtkCamera* const camera = renderer->GetActiveCamera();
  const int* const size = renderer->GetSize();
  scene.width = size[0];
  scene.height = size[1];
  scene.isParallel = camera->GetParallelProjection() != 0;
  scene.worldFromClip = glm::inverse(MatrixOf(
    camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)));
}

// Values that are shown as black and white by projections: those of the voxels.
void ReadValues(JudgeScene& scene, const JudgedObjects& objects)
{
  vtkContourValues* const contours = objects.volumes.front()->GetProperty()->GetIsoSurfaceValues();
  for (int i = 0; i < contours->GetNumberOfContours(); ++i)
  {
    scene.isovalues.push_back(contours->GetValue(i));
  }
  std::sort(scene.isovalues.begin(), scene.isovalues.end());
  const std::vector<double>& voxels = scene.volumes.front().voxels;
  scene.grayRange[0] = *std::min_element(voxels.begin(), voxels.end());
  scene.grayRange[1] = *std::max_element(voxels.begin(), voxels.end());
  objects.mapper->GetAverageIPScalarRange(scene.averagedRange);
}

}

JudgeScene ReadJudgeScene(const JudgedObjects& objects)
{
  JudgeScene scene = {};
  for (std::size_t i = 0; i < objects.images.size(); ++i)
  {
    scene.volumes.push_back(VolumeOf(objects.images[i], objects.volumes[i], objects.mapper));
  }
  scene.blendMode = objects.mapper->GetBlendMode();
  scene.errorTolerance = objects.mapper->GetErrorTolerance();
  ReadLights(scene, objects.renderer);
  ReadLightSettings(scene, objects.mapper);
  for (vtkActor* const actor : objects.actors)
  {
    ReadGeometry(scene, actor);
  }
  ReadView(scene, objects.renderer);
  ReadValues(scene, objects);
  return scene;
}

}
