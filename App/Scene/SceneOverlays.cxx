#include "Scene/SceneOverlays.h"

#include "Scene/ImageOrientation.h"
#include "Scene/LookRegions.h"
#include "Scene/Placing.h"
#include "Scene/VolumeProperty.h"

#include <vtkBoundingBox.h>
#include <vtkMatrix4x4.h>
#include <vtkObjectFactory.h>
#include <vtkTransform.h>
#include <vtkVolumeProperty.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

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

}

bool CanOverlay(MapperKind kind)
{
  return kind != MapperKind::VtkCpu;
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
  const std::vector<vtkSmartPointer<vtkImageData>>& images)
{
  std::vector<const OverlaidVolume*> shown;
  std::vector<vtkSmartPointer<vtkImageData>> shownImages;
  for (std::size_t i = 0; i < overlays.size() && CanOverlay(this->kind); ++i)
  {
    if (overlays[i].visible && images[i])
    {
      shown.push_back(&overlays[i]);
      shownImages.push_back(images[i]);
    }
  }
  this->SetImages(shownImages);
  for (std::size_t i = 0; i < shown.size(); ++i)
  {
    vtkImageData* const image = this->parts[i].image;
    const Look look = Weakened(InUnitsOfData(shown[i]->look, image), shown[i]->opacity);
    vtkNew<vtkVolumeProperty> property;
    ApplyLook(look, MeanSpacingMm(image), property);
    if (!look.regions.empty() && image->GetNumberOfScalarComponents() == 1)
    {
      ApplyRegions(look.regions, image, property);
    }
    property->SetInterpolationType(this->interpolationType);
    vtkVolume* const volume = this->parts[i].volume;
    volume->SetProperty(property);
    vtkNew<vtkTransform> worldFromImage;
    if (!IsOurs(this->kind))
    {
      WithoutDirection(RightHanded(image), worldFromImage);
    }
    worldFromImage->PostMultiply();
    worldFromImage->Concatenate(MatrixOf(WorldFromPatient(shown[i]->placement, image)));
    volume->SetUserMatrix(worldFromImage->GetMatrix());
  }
}

void SceneOverlays::SetImages(const std::vector<vtkSmartPointer<vtkImageData>>& shown)
{
  const bool isSame = std::equal(shown.begin(), shown.end(), this->parts.begin(), this->parts.end(),
    [](const auto& image, const Part& part) { return image == part.image; });
  if (isSame)
  {
    return;
  }
  for (std::size_t i = 0; i < this->parts.size(); ++i)
  {
    this->mapper->RemoveInputConnection(int(i) + 1, 0);
  }
  this->parts.clear();
  this->several = nullptr;
  if (shown.empty())
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
  for (const auto& image : shown)
  {
    const int port = int(this->parts.size()) + 1;
    this->parts.push_back({ image, vtkSmartPointer<vtkVolume>::New() });
    vtkNew<vtkTransform> unused; // Set() computes it for every place
    this->mapper->SetInputDataObject(
      port, IsOurs(this->kind) ? image : WithoutDirection(RightHanded(image), unused));
    this->several->SetVolume(this->parts.back().volume, port);
  }
}

void SceneOverlays::SetInterpolationType(int type)
{
  this->interpolationType = type;
  for (const Part& part : this->parts)
  {
    if (part.volume->GetProperty())
    {
      part.volume->GetProperty()->SetInterpolationType(type);
    }
  }
}

}
