#include "Frame/ShadowCasters.h"

#include "Frame/VolumeGeometry.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositePolyDataMapper2.h"
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

// Wires and points have no faces.
bool HasOpaqueFaces(vtkActor* actor)
{
  return MayCast(actor) && actor->GetMapper() && actor->HasOpaqueGeometry() &&
    !actor->HasTranslucentPolygonalGeometry() &&
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
    vtkMapper* mapper = actor->GetMapper();
    const bool hasColors = mapper->GetScalarVisibility() || actor->GetTexture();
    // The inner mapper exists from the first drawing on.
    auto* const ofDataSets = vtkDataSetMapper::SafeDownCast(mapper);
    const bool isOfPolygons = ofDataSets && vtkPolyData::SafeDownCast(ofDataSets->GetInput());
    if (ofDataSets && !isOfPolygons)
    {
      mapper = ofDataSets->GetPolyDataMapper();
    }
    if (!isOfPolygons && !vtkPolyDataMapper::SafeDownCast(mapper) &&
      !(mapper && mapper->IsA("vtkCompositePolyDataMapper")))
    {
      return;
    }
    mapper->Update();
    const CastingSurface surface = { nullptr, actor->GetProperty(), hasColors, worldFromData,
      PlanesOf(mapper) };
    vtkDataObject* const input = mapper->GetInputDataObject(0, 0);
    this->AddData(vtkPolyData::SafeDownCast(input), surface);
    auto* const several = vtkCompositeDataSet::SafeDownCast(input);
    auto* const ofSeveral = vtkCompositePolyDataMapper2::SafeDownCast(mapper);
    vtkCompositeDataDisplayAttributes* const attributes =
      ofSeveral ? ofSeveral->GetCompositeDataDisplayAttributes() : nullptr;
    if (!several)
    {
      return;
    }
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(several->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      vtkDataObject* const part = iterator->GetCurrentDataObject();
      if (!attributes || !attributes->HasBlockVisibility(part) ||
        attributes->GetBlockVisibility(part))
      {
        this->AddData(vtkPolyData::SafeDownCast(part), surface);
      }
    }
  }

  void AddData(vtkPolyData* data, const CastingSurface& surface)
  {
    const vtkIdType corners = data ? data->GetPolys()->GetNumberOfConnectivityIds() +
        data->GetStrips()->GetNumberOfConnectivityIds()
                                   : 0;
    const vtkIdType cells = data ? data->GetNumberOfPolys() + data->GetNumberOfStrips() : 0;
    if (cells == 0)
    {
      return;
    }
    this->casters.triangleCount += std::size_t(std::max<vtkIdType>(corners - 2 * cells, 0));
    this->casters.surfaces.push_back(surface);
    this->casters.surfaces.back().data = data;
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

ShadowCasters ShadowCastersOf(vtkRenderer* renderer, vtkVolume* volume)
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
