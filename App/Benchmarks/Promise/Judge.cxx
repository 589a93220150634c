#include "Judge.h"

#include <vtkVolumeMapper.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace varimarch
{

Judge::View Judge::ViewOf(glm::dvec2 pixels) const
{
  const double x = 2.0 * pixels.x / this->scene.width - 1.0;
  const double y = 2.0 * pixels.y / this->scene.height - 1.0;
  const glm::dvec4 atNear = this->scene.worldFromClip * glm::dvec4(x, y, -1.0, 1.0);
  const glm::dvec4 atFar = this->scene.worldFromClip * glm::dvec4(x, y, 1.0, 1.0);
  const glm::dvec3 from = glm::dvec3(atNear) / atNear.w;
  const glm::dvec3 way = glm::dvec3(atFar) / atFar.w - from;
  const JudgeRay ray{ from, glm::normalize(way) };
  const double hit = this->scene.seen.empty() ? glm::length(way) : JudgedHit(this->scene.seen, ray);
  return { ray, 0.0, std::min(glm::length(way), hit) };
}

bool Judge::MeetsGeometry(glm::dvec2 pixels) const
{
  const View view = this->ViewOf(pixels);
  return std::isfinite(JudgedHit(this->scene.seen, view.ray));
}

glm::dvec4 Judge::Pixel(glm::dvec2 pixels, int fineness) const
{
  const View view = this->ViewOf(pixels);
  const auto judged =
    this->scene.blendMode == vtkVolumeMapper::COMPOSITE_BLEND ? JudgedComposite : JudgedProjection;
  return judged(this->scene, view.ray, { view.from, view.to }, fineness);
}

}
