#include "Scene/Images/EmptyPicture.h"

#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Model/SceneCuts.h"
#include "Scene/Volumes/ImageStatistics.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <vector>

namespace varimarch
{

namespace
{

// Faintest opacity of a whole volume that changes a byte of the picture.
constexpr double FaintestOpacity = 0.5 / 255.0;

std::string Text(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

// A grid of points from the first voxel to the last.
std::vector<glm::dvec3> GridOfPoints(vtkImageData* image)
{
  constexpr int Steps = 32;
  std::vector<glm::dvec3> points;
  for (int z = 0; z <= Steps; ++z)
  {
    for (int y = 0; y <= Steps; ++y)
    {
      for (int x = 0; x <= Steps; ++x)
      {
        points.push_back(PointAtParts(glm::dvec3(x, y, z) / double(Steps), image));
      }
    }
  }
  return points;
}

bool IsSeen(const glm::dvec3& point, const std::array<double, 24>& frustum)
{
  for (std::size_t plane = 0; plane < frustum.size(); plane += 4)
  {
    if (glm::dot(point, glm::make_vec3(&frustum[plane])) + frustum[plane + 3] < 0.0)
    {
      return false;
    }
  }
  return true;
}

std::string ReasonOfPlace(const ScenePipeline& pipeline, const SceneCuts& cuts)
{
  const std::vector<CutPlane> planes = PlanesOf(cuts, pipeline.Image());
  std::array<double, 24> frustum;
  pipeline.Renderer()->GetActiveCamera()->GetFrustumPlanes(
    pipeline.Renderer()->GetTiledAspectRatio(), frustum.data());
  const std::vector<glm::dvec3> points = GridOfPoints(pipeline.Image());
  const auto isKept = [&](const glm::dvec3& point) { return IsKept(point, planes); };
  if (std::none_of(points.begin(), points.end(), isKept) ||
    (pipeline.Mask() && pipeline.Mask()->GetScalarRange()[1] == 0.0))
  {
    return "the cuts remove all of the volume; take one away";
  }
  const auto isSeen = [&](const glm::dvec3& point)
  { return isKept(point) && IsSeen(point, frustum); };
  if (std::none_of(points.begin(), points.end(), isSeen))
  {
    return "the volume, or what the cuts leave of it, lies outside of the view; move the camera "
           "or its clipping range";
  }
  return {};
}

// The largest opacity of the values that occur.
double LargestOpacity(const Look& look, const ImageStatistics& statistics)
{
  const TransferFunction function(look.colors, look.opacities, look.opacityUnitDistanceMm);
  double largest =
    std::max(function.Opacity(statistics.Smallest()), function.Opacity(statistics.Largest()));
  for (const OpacityNode& node : look.opacities)
  {
    if (node.value >= statistics.Smallest() && node.value <= statistics.Largest())
    {
      largest = std::max(largest, node.opacity);
    }
  }
  return largest;
}

// The values where the opacities are above 0, such as ", and above 0 only between 3 and 5".
std::string OpaqueValues(const std::vector<OpacityNode>& nodes)
{
  const auto isOpaque = [](const OpacityNode& node) { return node.opacity > 0.0; };
  const auto first = std::find_if(nodes.begin(), nodes.end(), isOpaque);
  if (first == nodes.end())
  {
    return {};
  }
  const auto afterLast = std::find_if(nodes.rbegin(), nodes.rend(), isOpaque).base();
  const std::string from = first == nodes.begin() ? "" : Text(std::prev(first)->value);
  const std::string to = afterLast == nodes.end() ? "" : Text(afterLast->value);
  return ", and above 0 only " +
    (to.empty()        ? "above " + from
        : from.empty() ? "below " + to
                       : "between " + from + " and " + to);
}

std::string ReasonOfOpacity(const ScenePipeline& pipeline)
{
  const ImageStatistics statistics(pipeline.Image());
  const std::size_t count = std::max<std::size_t>(statistics.Channels().size(), 1);
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    largest = std::max(
      largest, LargestOpacity(LookOfChannel(pipeline.DrawnLook(), i), statistics.OfChannel(i)));
  }
  if (largest == 0.0)
  {
    return "the opacity is 0 at all values of the volume, " + Text(statistics.Smallest()) + " to " +
      Text(statistics.Largest()) + OpaqueValues(pipeline.DrawnLook().opacities) +
      "; choose another preset, or opacities above 0 at values that occur";
  }
  const double longest = pipeline.Image()->GetLength();
  const double unit = pipeline.DrawnLook().opacityUnitDistanceMm;
  if (1.0 - std::pow(1.0 - std::min(largest, 1.0), longest / unit) < FaintestOpacity)
  {
    return "the opacity is at most " + Text(largest) + " over " + Text(unit) +
      " mm, and the volume is only " + Text(longest) +
      " mm long; choose a shorter unit distance of opacity";
  }
  return {};
}

bool HasFiniteValues(vtkImageData* image)
{
  double range[2];
  image->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
  return range[0] <= range[1];
}

// A byte that was rounded the other way is a half away, and the next level is one.
bool IsEmpty(vtkImageData* bytes, const std::array<double, 3>& background)
{
  const auto* pixel = static_cast<const unsigned char*>(bytes->GetScalarPointer());
  const int components = bytes->GetNumberOfScalarComponents();
  for (vtkIdType i = 0; i < bytes->GetNumberOfPoints(); ++i, pixel += components)
  {
    for (int c = 0; c < 3; ++c)
    {
      if (std::abs(pixel[c] - 255.0 * background[c]) > 1.5)
      {
        return false;
      }
    }
  }
  return true;
}

}

vtkSmartPointer<vtkImageData> BytesOf(vtkRenderWindow* window)
{
  const int* const size = window->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, false, pixels);
  auto bytes = vtkSmartPointer<vtkImageData>::New();
  bytes->SetDimensions(size[0], size[1], 1);
  bytes->GetPointData()->SetScalars(pixels);
  return bytes;
}

std::string ReasonForNothing(vtkImageData* bytes, const ScenePipeline& pipeline, const Scene& scene)
{
  // The mapper has reported a volume without values.
  const bool hasValues = pipeline.Image()->GetPointData()->GetScalars() != nullptr;
  if (!hasValues || !IsEmpty(bytes, scene.background))
  {
    return {};
  }
  if (!HasFiniteValues(pipeline.Image()))
  {
    return "no value of the volume is a finite number";
  }
  const std::string ofPlace = ReasonOfPlace(pipeline, scene.cuts);
  const std::string reason = ofPlace.empty() ? ReasonOfOpacity(pipeline) : ofPlace;
  return !reason.empty() ? reason
                         : "all that is drawn has the colour of the background; choose another "
                           "background, light or preset";
}

}
