#include "Scene/Reference/ReferencePicture.h"

#include "Core/Reference/PathTracer.h"
#include "Scene/Reference/ReferenceMaterial.h"
#include "Scene/Reference/ReferenceRequest.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace varimarch
{

std::optional<ReferencePicture> DrawReferencePicture(
  const Scene& scene, vtkImageData* image, double tolerance, const ProgressFunction& progress)
{
  return DrawReferencePicture(ReferenceRequestFor(scene, image, tolerance), progress);
}

namespace
{

constexpr int CellsPerBrick = 4;

void CheckThatPathsDraw(const ReferenceRequest& request)
{
  if (request.blend != Blend::Composite || !request.lighting ||
    request.interpolation == Interpolation::Cubic)
  {
    throw std::invalid_argument("Path tracer: expected a composite with shading, and linear or "
                                "nearest interpolation, found a scene without");
  }
}

double LargestExtinction(const ReferenceRequest& request)
{
  const glm::dmat3 axes = request.geometry.WorldFromGridDirection();
  return 100.0 / std::min({ glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]) });
}

// Curves between nodes rise or fall.
double LargestExtinctionBetween(const TransferFunction& function, double lowest, double highest)
{
  double largest = std::max(function.Extinction(lowest), function.Extinction(highest));
  for (const OpacityNode& node : function.Opacities())
  {
    if (lowest <= node.value && node.value <= highest)
    {
      largest = std::max(largest, -std::log1p(-node.opacity) / function.OpacityUnitDistanceMm());
    }
  }
  return largest;
}

/// The majorants of a volume's bricks.
class MajorantsOfBricks
{
public:
  explicit MajorantsOfBricks(const ReferenceRequest& request)
    : request(request)
    , voxelCount(request.geometry.dimensions)
    , limit(LargestExtinction(request))
  {
  }

  Majorants All() const
  {
    const glm::ivec3 cells = glm::max(this->voxelCount - 1, glm::ivec3(1));
    Majorants majorants{ CellsPerBrick, (cells + CellsPerBrick - 1) / CellsPerBrick, {} };
    glm::ivec3 brick;
    for (brick.z = 0; brick.z < majorants.brickCount.z; ++brick.z)
    {
      for (brick.y = 0; brick.y < majorants.brickCount.y; ++brick.y)
      {
        for (brick.x = 0; brick.x < majorants.brickCount.x; ++brick.x)
        {
          majorants.extinctions.push_back(std::min(this->Of(brick), this->limit));
        }
      }
    }
    return majorants;
  }

private:
  double Of(glm::ivec3 brick) const
  {
    if (!this->request.regions.empty())
    {
      return this->limit; // opacities of regions depend on gradients
    }
    double lowest = INFINITY;
    double highest = -INFINITY;
    const glm::ivec3 first = CellsPerBrick * brick;
    const glm::ivec3 last = glm::min(first + CellsPerBrick, this->voxelCount - 1);
    for (int z = first.z; z <= last.z; ++z)
    {
      for (int y = first.y; y <= last.y; ++y)
      {
        for (int x = first.x; x <= last.x; ++x)
        {
          const double value = this->ValueAt({ x, y, z });
          if (!std::isfinite(value))
          {
            return this->limit;
          }
          lowest = std::min(lowest, value);
          highest = std::max(highest, value);
        }
      }
    }
    return LargestExtinctionBetween(this->request.transferFunction, lowest, highest);
  }

  double ValueAt(glm::ivec3 voxel) const
  {
    const vtkIdType row = vtkIdType(voxel.z) * this->voxelCount.y + voxel.y;
    return this->request.scalars->GetComponent(row * this->voxelCount.x + voxel.x, 0);
  }

  const ReferenceRequest& request;
  glm::ivec3 voxelCount;
  double limit;
};

// The eye is at infinity in parallel projections.
PathLight AtEye(const ReferenceRequest& request, glm::dvec3 rgb)
{
  const glm::dvec4 eye = request.geometry.worldFromGrid * request.view.rays.eyeGrid;
  const glm::dvec3 place(eye);
  constexpr double Infinitesimal = 1e-9;
  return std::abs(eye.w) > Infinitesimal * glm::length(place)
    ? PathLight{ false, place / eye.w, rgb }
    : PathLight{ true, glm::normalize(place), rgb };
}

std::vector<PathLight> LightsOf(const ReferenceRequest& request)
{
  std::vector<PathLight> lights;
  for (const PlacedLight& light : request.lighting->lights)
  {
    lights.push_back(light.kind == LightKind::Head
        ? AtEye(request, light.rgb)
        : PathLight{ light.kind != LightKind::Positional, light.place, light.rgb,
            glm::radians(light.softnessDegrees) });
  }
  return lights;
}

/// The request without light, and the material that refers to it.
struct TracedScene
{
  ReferenceRequest unlit;
  ReferenceMaterial material;

  explicit TracedScene(const ReferenceRequest& request)
    : unlit(request)
    , material(unlit)
  {
    this->unlit.lighting.reset();
    this->unlit.occlusion = {};
  }
};

ScatteringScene ScatteringSceneOf(const ReferenceRequest& request, const TracedScene& traced)
{
  const Shading& shading = request.lighting->shading;
  const double largestExtinction = LargestExtinction(request);
  ScatteringScene scene;
  scene.boxGrid = request.geometry.boxGrid;
  scene.worldFromGrid = request.geometry.worldFromGrid;
  scene.majorants = MajorantsOfBricks(request).All();
  scene.matter = [&traced, largestExtinction, diffuse = shading.diffuse](glm::dvec3 positionGrid)
  {
    OpticalProperties matter = traced.material.At(positionGrid, Ray());
    matter.extinction = std::min(matter.extinction, largestExtinction);
    matter.rgb = glm::clamp(diffuse * matter.rgb, 0.0, 1.0);
    return matter;
  };
  if (!request.cuts.IsEmpty())
  {
    scene.uncutParts = [&traced](const Ray& rayGrid, Interval inside)
    { return traced.unlit.cuts.PartsOf(rayGrid, inside, traced.unlit.geometry.dimensions); };
  }
  scene.anisotropy = request.lighting->anisotropy;
  scene.lights = LightsOf(request);
  scene.environment = glm::dvec3(shading.diffuse > 0.0 ? shading.ambient / shading.diffuse : 0.0);
  return scene;
}

}

std::optional<ReferencePicture> DrawPathPicture(const Scene& scene, vtkImageData* image,
  const PathSettings& settings, const ProgressFunction& progress)
{
  constexpr double AnyTolerance = 1e-6; // only for integrals, which paths have none of
  const ReferenceRequest request = ReferenceRequestFor(scene, image, AnyTolerance);
  CheckThatPathsDraw(request);
  const TracedScene traced(request);
  ScatteringScene scattering = ScatteringSceneOf(request, traced);
  if (settings.mostScatterings > 0)
  {
    scattering.mostScatterings = settings.mostScatterings;
  }
  const PathTracer tracer(std::move(scattering));
  return PictureOf(DrawPixels([&](const Ray& ray, double, Interval limits, std::size_t pixel)
    { return tracer.Color(ray, limits, settings.paths, pixel); },
    request.view, progress));
}

}
