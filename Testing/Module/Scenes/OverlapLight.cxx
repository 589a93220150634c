#include "Module/Scenes/OverlapLight.h"

#include "Core/Geometry/LightCone.h"
#include "Core/Geometry/SphereQuadrature.h"
#include "Core/Reference/LightTransmittance.h"
#include "Module/Scenes/UsualSettings.h"

#include <vtkActor.h>
#include <vtkCubeSource.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleKey.h>
#include <vtkLight.h>
#include <vtkPolyDataMapper.h>

#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <limits>
#include <memory>

using namespace varimarch;

namespace
{

constexpr double Diffuse = 0.8;

// Volumes that take light from each other.
class LitMaterials
{
public:
  LitMaterials(std::vector<WorldMaterial> materials, OverlapLight light)
    : materials(std::move(materials))
    , light(std::move(light))
  {
  }

  std::size_t Count() const { return this->materials.size(); }

  OpticalProperties At(std::size_t index, glm::dvec3 positionWorld, glm::dvec3 toEye) const
  {
    const WorldMaterial& material = this->materials[index];
    const std::optional<glm::dvec3> place = material.PlaceOf(positionWorld);
    const double extinction = place ? material.ExtinctionOf(material.ValueAt(*place)) : 0.0;
    if (!(extinction > 0.0))
    {
      return { glm::dvec3(0.0), 0.0 };
    }
    const double lit =
      material.shaded ? this->LightAt(material, *place, positionWorld, toEye) : 1.0;
    return { material.look.color * (lit * this->KeptAt(material, *place)), extinction };
  }

private:
  double LightAt(const WorldMaterial& material, glm::dvec3 placeGrid, glm::dvec3 positionWorld,
    glm::dvec3 toEye) const
  {
    const auto sent = [&](glm::dvec3 towards)
    {
      return this->light.isScattered
        ? 1.0
        : std::abs(glm::dot(material.NormalAt(placeGrid), glm::normalize(towards)));
    };
    double sum = this->light.hasHeadLight ? sent(toEye) : 0.0;
    for (const TestLamp& lamp : this->light.lamps)
    {
      sum +=
        sent(lamp.towards) * (this->light.hasShadows ? this->Reaching(lamp, positionWorld) : 1.0);
    }
    return Diffuse * sum;
  }

  double Reaching(const TestLamp& lamp, glm::dvec3 positionWorld) const
  {
    if (lamp.softnessDegrees == 0.0)
    {
      return this->ReachingAlong({ positionWorld, lamp.towards });
    }
    double mean = 0.0;
    for (const auto& [direction, weight] :
      DirectionsInCone(lamp.towards, glm::radians(lamp.softnessDegrees)))
    {
      mean += weight * this->ReachingAlong({ positionWorld, direction });
    }
    return mean;
  }

  double ReachingAlong(const Ray& rayWorld) const
  {
    if (this->light.opaque)
    {
      const Interval inside = Intersection(rayWorld, *this->light.opaque);
      if (inside.exit > std::max(inside.enter, 0.0))
      {
        return 0.0;
      }
    }
    return std::exp(-this->DepthAlong(rayWorld, std::numeric_limits<double>::infinity()));
  }

  double KeptAt(const WorldMaterial& material, glm::dvec3 placeGrid) const
  {
    if (this->light.occlusion == 0.0)
    {
      return 1.0;
    }
    const double value = material.ValueAt(placeGrid);
    const glm::dvec3 gradient = material.Grid().Gradient(placeGrid);
    const bool isThinnerUp =
      IsThinnerUp(value, gradient, [&](double other) { return material.ExtinctionOf(other); });
    const glm::dvec3 outside(material.geometry.worldFromGrid *
      glm::dvec4(OutsideOf(placeGrid, gradient, isThinnerUp), 1.0));
    double visible = 0.0;
    for (const auto& [direction, weight] : SphereQuadrature())
    {
      visible +=
        weight * std::exp(-this->DepthAlong({ outside, direction }, this->light.occlusionReachMm));
    }
    return KeptLight(visible, this->light.occlusion);
  }

  // The sum over all volumes, by midpoints. In boxes the error of each is less than a part's depth.
  double DepthAlong(const Ray& rayWorld, double farMm) const
  {
    constexpr double LongestPartMm = 0.1;
    double depth = 0.0;
    for (const WorldMaterial& material : this->materials)
    {
      const glm::dmat4 gridFromWorld = glm::inverse(material.geometry.worldFromGrid);
      const Ray ray{ glm::dvec3(gridFromWorld * glm::dvec4(rayWorld.origin, 1.0)),
        glm::dmat3(gridFromWorld) * rayWorld.direction };
      const Interval inside = Intersection(ray, material.geometry.boxGrid);
      const double from = std::max(inside.enter, 0.0);
      const double length = std::min(inside.exit, farMm) - from;
      const int parts = length > 0.0 ? int(std::ceil(length / LongestPartMm)) : 0;
      for (int i = 0; i < parts; ++i)
      {
        const glm::dvec3 place = ray.origin + (from + (i + 0.5) * length / parts) * ray.direction;
        const glm::dvec3 read = material.nearest ? glm::floor(place + 0.5) : place;
        depth += length / parts * material.ExtinctionOf(material.ValueAt(read));
      }
    }
    return depth;
  }

  std::vector<WorldMaterial> materials;
  OverlapLight light;
};

vtkSmartPointer<vtkActor> ActorOf(const Box& box)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(box.lower.x, box.upper.x, box.lower.y, box.upper.y, box.lower.z, box.upper.z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(cube->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

void UseDiffuseLight(vtkVolumeProperty* property)
{
  property->SetAmbient(0.0);
  property->SetDiffuse(Diffuse);
  property->SetSpecular(0.0);
}

}

void UseLight(OverlapScene& scene, const OverlapLight& light)
{
  scene.renderer->AutomaticLightCreationOff();
  scene.renderer->RemoveAllLights();
  for (const TestLamp& lamp : light.lamps)
  {
    vtkLight* const added = AddLight(scene.renderer, 100.0 * lamp.towards, glm::dvec3(0.0));
    if (lamp.softnessDegrees > 0.0)
    {
      added->GetInformation()->Set(
        vtkVariationFieldVolumeMapper::LIGHT_SOFTNESS(), lamp.softnessDegrees);
    }
  }
  if (light.hasHeadLight)
  {
    vtkNew<vtkLight> head;
    head->SetLightTypeToHeadlight();
    scene.renderer->AddLight(head);
  }
  if (light.opaque)
  {
    scene.renderer->AddActor(ActorOf(*light.opaque));
  }
  for (vtkVolume* const volume : scene.Volumes())
  {
    UseDiffuseLight(volume->GetProperty());
  }
  if (light.isScattered)
  {
    scene.UseMapperItself();
  }
  vtkVariationFieldVolumeMapper* const mapper = scene.mapper->GetVariationFieldMapper();
  mapper->SetShadows(light.hasShadows);
  mapper->SetVolumetricScatteringBlending(light.isScattered ? 1.0 : 0.0);
  mapper->SetAmbientOcclusion(light.occlusion);
  mapper->SetAmbientOcclusionReach(light.occlusionReachMm);
}

std::vector<float> TruthInLight(OverlapScene& scene, const OverlapLight& light, double tolerance)
{
  const auto lit = std::make_shared<const LitMaterials>(scene.Materials(), light);
  std::vector<MaterialInWorld> materials;
  for (std::size_t i = 0; i < lit->Count(); ++i)
  {
    materials.emplace_back(
      [lit, i](glm::dvec3 position, glm::dvec3 toEye) { return lit->At(i, position, toEye); });
  }
  return scene.TruthOf(materials, tolerance);
}
