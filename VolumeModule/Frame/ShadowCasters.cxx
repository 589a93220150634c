#include "Frame/ShadowCasters.h"

#include "Frame/RendererVolumes.h"
#include "Frame/VolumeGeometry.h"
#include "VtkVersions.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSetMapper.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace varimarch
{

namespace
{

bool MayCast(vtkProp* prop)
{
  vtkInformation* const keys = prop->GetPropertyKeys();
  vtkInformationIntegerKey* const key = vtkVariationFieldVolumeMapper::CASTS_SHADOWS();
  return prop->GetVisibility() && !(keys && keys->Has(key) && keys->Get(key) == 0);
}

// Wires and points have no faces, and those of a skybox stand for what is infinitely far.
bool HasOpaqueFaces(vtkActor* actor)
{
  return MayCast(actor) && !actor->IsA("vtkSkybox") && actor->GetMapper() &&
    actor->HasOpaqueGeometry() && !actor->HasTranslucentPolygonalGeometry() &&
    actor->GetProperty()->GetRepresentation() == VTK_SURFACE;
}

std::vector<glm::dvec4> PlanesOf(vtkMapper* mapper)
{
  std::vector<glm::dvec4> planes;
  vtkPlaneCollection* const collection = mapper->GetClippingPlanes();
  for (int i = 0; collection && i < collection->GetNumberOfItems(); ++i)
  {
    vtkPlane* const plane = collection->GetItem(i);
    const glm::dvec3 normal = glm::make_vec3(plane->GetNormal());
    planes.emplace_back(normal, -glm::dot(normal, glm::make_vec3(plane->GetOrigin())));
  }
  return planes;
}

// The mapper that draws an actor's faces; null if it draws anything else.
vtkMapper* FaceMapperOf(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  auto* const ofDataSets = vtkDataSetMapper::SafeDownCast(mapper);
  const bool isOfPolygons = ofDataSets && vtkPolyData::SafeDownCast(ofDataSets->GetInput());
  if (ofDataSets && !isOfPolygons)
  {
    mapper = ofDataSets->GetPolyDataMapper(); // it exists from the first drawing on
  }
  const bool isOfFaces = isOfPolygons || vtkPolyDataMapper::SafeDownCast(mapper) ||
    (mapper && mapper->IsA("vtkCompositePolyDataMapper"));
  return isOfFaces ? mapper : nullptr;
}

// True if a mapper takes the colours of data from one of their arrays.
bool HasColors(vtkMapper* mapper, vtkPolyData* data)
{
  int cells = 0;
  return mapper->GetScalarVisibility() &&
    vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cells);
}

// Collects the surfaces of actors.
class Collection
{
public:
  explicit Collection(ShadowCasters& casters)
    : casters(casters)
  {
  }

  void AddProp(vtkProp* prop)
  {
    if (!MayCast(prop))
    {
      return;
    }
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* const node = path->GetLastNode();
      auto* const actor = vtkActor::SafeDownCast(node->GetViewProp());
      if (actor && HasOpaqueFaces(actor))
      {
        vtkMatrix4x4* const own = node->GetMatrix() ? node->GetMatrix() : actor->GetMatrix();
        this->AddActor(actor, FromVtk(own));
      }
    }
  }

private:
  void AddActor(vtkActor* actor, const glm::dmat4& worldFromData)
  {
    if (vtkMapper* const mapper = FaceMapperOf(actor))
    {
      mapper->Update();
      this->AddBlock(mapper, mapper->GetInputDataObject(0, 0),
        { nullptr, actor->GetProperty(), false, worldFromData, PlanesOf(mapper) }, true);
    }
  }

  // Blocks are as visible as the block that they are in, unless they say otherwise.
  void AddBlock(vtkMapper* mapper, vtkDataObject* block, CastingSurface surface, bool isVisible)
  {
    if (vtkCompositeDataDisplayAttributes* const attributes = BlockAttributesOf(mapper))
    {
      isVisible =
        attributes->HasBlockVisibility(block) ? attributes->GetBlockVisibility(block) : isVisible;
      surface.hasColors = surface.hasColors || attributes->HasBlockColor(block);
    }
    if (auto* const tree = vtkDataObjectTree::SafeDownCast(block))
    {
      for (vtkDataObject* part : vtk::Range(tree))
      {
        this->AddBlock(mapper, part, surface, isVisible);
      }
      return;
    }
    auto* const data = vtkPolyData::SafeDownCast(block);
    if (data && isVisible)
    {
      surface.data = data;
      surface.hasColors = surface.hasColors || HasColors(mapper, data);
      this->AddSurface(surface);
    }
  }

  void AddSurface(const CastingSurface& surface)
  {
    vtkPolyData* const data = surface.data;
    const vtkIdType corners = data->GetPolys()->GetNumberOfConnectivityIds() +
      data->GetStrips()->GetNumberOfConnectivityIds();
    const vtkIdType cells = data->GetNumberOfPolys() + data->GetNumberOfStrips();
    if (cells == 0)
    {
      return;
    }
    // Each plane may add a corner to a triangle that it cuts.
    this->casters.triangleCount +=
      std::size_t(std::max<vtkIdType>(corners - 2 * cells, 0)) * (1 + surface.planesWorld.size());
    this->casters.surfaces.push_back(surface);
    std::vector<double>& numbers = this->casters.fingerprint;
    numbers.push_back(double(reinterpret_cast<std::uintptr_t>(data)));
    numbers.push_back(double(data->GetMTime()));
    numbers.insert(numbers.end(), glm::value_ptr(surface.worldFromData),
      glm::value_ptr(surface.worldFromData) + 16);
    for (const glm::dvec4& plane : surface.planesWorld)
    {
      numbers.insert(numbers.end(), glm::value_ptr(plane), glm::value_ptr(plane) + 4);
    }
  }

  ShadowCasters& casters;
};

bool HasTranslucentGeometry(vtkRenderer* renderer)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (prop->GetVisibility() && prop->HasTranslucentPolygonalGeometry())
    {
      return true;
    }
  }
  return false;
}

// True if a mapper that is not ours may draw a volume, whenever it likes.
bool HasVolumesOfOthers(vtkRenderer* renderer)
{
  vtkVolumeCollection* const volumes = renderer->GetVolumes();
  for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
  {
    auto* const volume = vtkVolume::SafeDownCast(volumes->GetItemAsObject(i));
    if (volume->GetVisibility() && volume->GetMapper() && !DrawingMapper(volume))
    {
      return true;
    }
  }
  return false;
}

// A mapper that draws a part of a volume knows nothing of the light that other parts take.
Shadowing ShadowingOf(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  if (DrawingMapper(volume) != mapper || HasTranslucentGeometry(renderer) ||
    HasVolumesOfOthers(renderer))
  {
    return Shadowing::Nothing;
  }
  return VolumesBackToFront(renderer).size() > 1 ? Shadowing::AllVolumes : Shadowing::OneVolume;
}

// A corner of cubes that are as large as the volume, so that it stays while the volume moves a
// little.
glm::dvec3 OriginNear(vtkVolume* volume)
{
  const double length = volume->GetLength();
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return glm::dvec3(0.0);
  }
  const double side = std::exp2(std::ceil(std::log2(length)));
  return side * glm::round(glm::make_vec3(volume->GetCenter()) / side);
}

// Cuts a polygon by a plane, as Sutherland and Hodgman do (Communications of the ACM, 1974).
std::vector<glm::dvec3> CutBy(const glm::dvec4& plane, const std::vector<glm::dvec3>& corners)
{
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const glm::dvec3& from = corners[i];
    const glm::dvec3& to = corners[(i + 1) % corners.size()];
    const double fromAbove = glm::dot(plane, glm::dvec4(from, 1.0));
    const double toAbove = glm::dot(plane, glm::dvec4(to, 1.0));
    if (fromAbove >= 0.0)
    {
      kept.push_back(from);
    }
    if ((fromAbove >= 0.0) != (toAbove >= 0.0))
    {
      kept.push_back(glm::mix(from, to, fromAbove / (fromAbove - toAbove)));
    }
  }
  return kept;
}

// Makes the triangles of surfaces.
class Triangulation
{
public:
  explicit Triangulation(const ShadowCasters& casters)
    : casters(casters)
  {
    this->made.corners.reserve(casters.triangleCount);
    this->made.sources.reserve(casters.triangleCount);
  }

  // Polygons are fans from their first corner, as for polygons without a notch.
  void AddPolygon(std::size_t surface, vtkIdType count, const vtkIdType* ids)
  {
    for (vtkIdType i = 2; i < count; ++i)
    {
      this->Add({ surface, { ids[0], ids[i - 1], ids[i] } });
    }
  }

  void AddStrip(std::size_t surface, vtkIdType count, const vtkIdType* ids)
  {
    for (vtkIdType i = 2; i < count; ++i)
    {
      const vtkIdType turned = i % 2; // every second triangle of a strip runs the other way round
      this->Add({ surface, { ids[i - 2 + turned], ids[i - 1 - turned], ids[i] } });
    }
  }

  CasterTriangles Take() { return std::move(this->made); }

private:
  void Add(const SurfaceTriangle& source)
  {
    const CastingSurface& surface = this->casters.surfaces[source.surface];
    std::vector<glm::dvec3> corners;
    for (const vtkIdType id : source.points)
    {
      const glm::dvec3 place = glm::make_vec3(surface.data->GetPoint(id));
      corners.emplace_back(surface.worldFromData * glm::dvec4(place, 1.0));
    }
    for (const glm::dvec4& plane : surface.planesWorld)
    {
      corners = CutBy(plane, corners);
    }
    const auto cornerAt = [&](std::size_t i)
    { return glm::vec3(corners[i] - this->casters.originWorld); };
    for (std::size_t i = 2; i < corners.size(); ++i)
    {
      this->made.corners.push_back({ cornerAt(0), cornerAt(i - 1), cornerAt(i) });
      this->made.sources.push_back(source);
    }
  }

  const ShadowCasters& casters;
  CasterTriangles made;
};

// Calls add(number of points, points) for each cell.
template <class Add>
void ForEachCell(vtkCellArray* cells, Add add)
{
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(cell, count, ids);
    add(count, ids);
  }
}

}

ShadowCasters ShadowCastersOf(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  ShadowCasters casters;
  Collection collection(casters);
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    collection.AddProp(prop);
  }
  casters.areTooMany = casters.triangleCount > TriangleTree::MostTriangles;
  if (casters.areTooMany)
  {
    casters.surfaces.clear();
  }
  casters.shadowing = ShadowingOf(mapper, renderer, volume);
  casters.originWorld = OriginNear(volume);
  casters.fingerprint.insert(casters.fingerprint.end(), glm::value_ptr(casters.originWorld),
    glm::value_ptr(casters.originWorld) + 3);
  return casters;
}

CasterTriangles TrianglesOf(const ShadowCasters& casters)
{
  Triangulation triangulation(casters);
  for (std::size_t i = 0; i < casters.surfaces.size(); ++i)
  {
    ForEachCell(casters.surfaces[i].data->GetPolys(),
      [&](vtkIdType count, const vtkIdType* ids) { triangulation.AddPolygon(i, count, ids); });
    ForEachCell(casters.surfaces[i].data->GetStrips(),
      [&](vtkIdType count, const vtkIdType* ids) { triangulation.AddStrip(i, count, ids); });
  }
  return triangulation.Take();
}

}
