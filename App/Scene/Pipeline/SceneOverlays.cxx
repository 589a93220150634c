#include "Scene/Pipeline/SceneOverlays.h"

#include "Scene/Looks/LookRegions.h"
#include "Scene/Looks/VolumeProperty.h"
#include "Scene/Segments/LabelMap.h"
#include "Scene/Volumes/ImageOrientation.h"
#include "Scene/Volumes/Placing.h"
#include "Scene/Volumes/VolumeColors.h"

#include <vtkBoundingBox.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkTransform.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <utility>

namespace varimarch
{

namespace
{

// VTK's class takes the bounds of its volumes from a vtkGPUVolumeRayCastMapper, which ours is not.
class vtkBoundedVolumes : public vtkMultiVolume
{
public:
  static vtkBoundedVolumes* New();
  vtkTypeMacro(vtkBoundedVolumes, vtkMultiVolume);

  double* GetBounds() override
  {
    vtkBoundingBox box;
    for (int port = 0; port < this->Mapper->GetNumberOfInputPorts(); ++port)
    {
      auto* const image = this->Mapper->GetNumberOfInputConnections(port) > 0
        ? vtkImageData::SafeDownCast(this->Mapper->GetInputDataObject(port, 0))
        : nullptr;
      if (image && this->GetVolume(port))
      {
        this->AddCorners(image->GetBounds(), this->GetVolume(port)->GetMatrix(), box);
      }
    }
    box.GetBounds(this->Bounds);
    return this->Bounds;
  }

private:
  static void AddCorners(const double* bounds, vtkMatrix4x4* matrix, vtkBoundingBox& box)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const double point[4] = { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)],
        bounds[4 + (corner >> 2)], 1.0 };
      double moved[4];
      matrix->MultiplyPoint(point, moved);
      box.AddPoint(moved);
    }
  }
};

vtkStandardNewMacro(vtkBoundedVolumes);

vtkSmartPointer<vtkMatrix4x4> MatrixOf(const glm::dmat4& transform)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  const glm::dmat4 rows = glm::transpose(transform); // VTK stores matrices by rows
  matrix->DeepCopy(glm::value_ptr(rows));
  return matrix;
}

Look Weakened(Look look, double factor)
{
  for (auto& node : look.opacities)
  {
    node.opacity *= factor;
  }
  for (LookRegion& region : look.regions)
  {
    region.opacity *= factor;
  }
  return look;
}

vtkSmartPointer<vtkVolumeProperty> PropertyOf(const OverlaidVolume& overlay, vtkImageData* image)
{
  const Look look = Weakened(InUnitsOfData(overlay.look, image), overlay.opacity);
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  ApplyLook(look, image, property);
  if (!look.regions.empty() && image->GetNumberOfScalarComponents() == 1)
  {
    ApplyRegions(look.regions, image, property);
  }
  return property;
}

// Light shows surfaces. The inside of a translucent segment has none, and would be dark.
vtkSmartPointer<vtkVolumeProperty> PropertyOf(
  const LabelMap& labels, const std::vector<Segment>& segments, Shading shading)
{
  const bool areOpaque = std::all_of(segments.begin(), segments.end(),
    [](const Segment& segment) { return !segment.visible || segment.opacity >= 1.0; });
  shading.enabled = shading.enabled && areOpaque;
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  ApplyShading(shading, property);
  ApplySegmentsByNumber(labels, segments, property);
  return property;
}

}

bool CanOverlay(MapperKind kind)
{
  return kind != MapperKind::VtkCpu;
}

bool AreAllSegmentsDrawn(const Scene& scene)
{
  std::size_t parts = scene.labels ? 2 : 1;
  for (const OverlaidVolume& overlay : scene.overlays)
  {
    parts += !overlay.visible ? 0 : overlay.labels ? 2 : 1;
  }
  return parts <= MostVolumes;
}

SceneOverlays::SceneOverlays(MapperKind kind, vtkVolumeMapper* mapper, vtkVolume* first)
  : kind(kind)
  , mapper(mapper)
  , first(first)
{
}

vtkVolume* SceneOverlays::Prop() const
{
  return this->Any() ? this->several.Get() : this->first;
}

void SceneOverlays::Set(const std::vector<OverlaidVolume>& overlays,
  const std::vector<OverlayVoxels>& voxels, const FirstSegments& firstSegments)
{
  std::vector<Part> wanted;
  std::vector<Part> ofLabels;
  for (std::size_t i = 0; i < overlays.size() && CanOverlay(this->kind); ++i)
  {
    const OverlaidVolume& overlay = overlays[i];
    if (!overlay.visible || !voxels[i].image)
    {
      continue;
    }
    vtkImageData* const image = voxels[i].image;
    wanted.push_back(
      { image, this->DrawnVoxels(image), PropertyOf(overlay, image), overlay.placement, false });
    if (voxels[i].labels && overlay.labels)
    {
      const LabelMap& labels = *voxels[i].labels;
      ofLabels.push_back({ labels.image, labels.image,
        PropertyOf(labels, overlay.labels->segments, overlay.look.shading), overlay.placement,
        true });
    }
  }
  if (!wanted.empty() && firstSegments.labels)
  {
    ofLabels.insert(ofLabels.begin(),
      { firstSegments.numbers, firstSegments.numbers,
        PropertyOf(*firstSegments.labels, firstSegments.segments, firstSegments.shading), {},
        true });
  }
  for (auto part = ofLabels.begin(); part != ofLabels.end() && wanted.size() + 1 < MostVolumes;
       ++part)
  {
    wanted.push_back(*part);
  }
  this->SetParts(std::move(wanted));
}

// Colours are converted once, while their volume is drawn.
vtkSmartPointer<vtkImageData> SceneOverlays::DrawnVoxels(vtkImageData* source) const
{
  const auto before = std::find_if(this->parts.begin(), this->parts.end(),
    [source](const Part& part) { return part.source == source; });
  return before == this->parts.end() ? ColoredVoxels(source) : before->image;
}

void SceneOverlays::SetParts(std::vector<Part> wanted)
{
  const bool isSame = std::equal(wanted.begin(), wanted.end(), this->parts.begin(),
    this->parts.end(), [](const Part& a, const Part& b) { return a.image == b.image; });
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    wanted[i].volume = isSame ? this->parts[i].volume : vtkSmartPointer<vtkVolume>::New();
  }
  const std::size_t before = std::exchange(this->parts, std::move(wanted)).size();
  if (!isSame)
  {
    this->ConnectParts(before);
  }
  for (const Part& part : this->parts)
  {
    this->ShowPart(part);
  }
  this->SetInterpolationType(this->interpolationType);
}

void SceneOverlays::ConnectParts(std::size_t countBefore)
{
  for (std::size_t i = 0; i < countBefore; ++i)
  {
    this->mapper->RemoveInputConnection(int(i) + 1, 0);
  }
  this->several = nullptr;
  if (this->parts.empty())
  {
    return;
  }
  if (IsOurs(this->kind))
  {
    this->several = vtkSmartPointer<vtkBoundedVolumes>::New();
  }
  else
  {
    this->several = vtkSmartPointer<vtkMultiVolume>::New();
  }
  this->several->SetMapper(this->mapper);
  this->several->SetVolume(this->first, 0);
  for (std::size_t i = 0; i < this->parts.size(); ++i)
  {
    const int port = int(i) + 1;
    const Part& part = this->parts[i];
    vtkNew<vtkTransform> unused; // ShowPart() computes it for every place
    this->mapper->SetInputDataObject(
      port, IsOurs(this->kind) ? part.image : WithoutDirection(RightHanded(part.image), unused));
    this->several->SetVolume(part.volume, port);
  }
}

void SceneOverlays::ShowPart(const Part& part) const
{
  part.volume->SetProperty(part.property);
  vtkNew<vtkTransform> worldFromImage;
  if (!IsOurs(this->kind))
  {
    WithoutDirection(RightHanded(part.image), worldFromImage);
  }
  worldFromImage->PostMultiply();
  worldFromImage->Concatenate(MatrixOf(WorldFromPatient(part.placement, part.image)));
  part.volume->SetUserMatrix(worldFromImage->GetMatrix());
}

void SceneOverlays::SetInterpolationType(int type)
{
  this->interpolationType = type;
  for (const Part& part : this->parts)
  {
    part.property->SetInterpolationType(part.isLabels ? VTK_NEAREST_INTERPOLATION : type);
  }
}

}
