#include "Frame/ShadowCasters.h"

#include "Frame/RendererVolumes.h"
#include "Frame/RequestedPass.h"
#include "Frame/VolumeGeometry.h"
#include "VtkVersions.h"
#include "vtkVariationFieldVolumeMapper.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCuller.h"
#include "vtkCullerCollection.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSetMapper.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
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

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

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

// The inputs of a surface's triangles; its look is none.
Fingerprint TrianglesIn(const CastingSurface& surface)
{
  const auto& [data, time, property, hasColors, worldFromData, planesWorld] = surface;
  return Fingerprint(data, time, worldFromData, planesWorld);
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
        { nullptr, 0, actor->GetProperty(), false, worldFromData, PlanesOf(mapper) }, true);
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
      surface.time = data->GetMTime();
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
    this->casters.fingerprint.Add(TrianglesIn(surface));
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

// A mapper that draws a part of a volume knows nothing of the light that other parts take. Passes
// of the caller, and VTK's with shadow maps, blend translucent geometry in ways of their own.
// Between layers of depths the colours of geometry are still alone, in another framebuffer.
Shadowing ShadowingOf(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  if (DrawingMapper(volume) != mapper)
  {
    return Shadowing::Nothing;
  }
  const bool isBlendedByOthers =
    HasTranslucentGeometry(renderer) && (renderer->GetPass() || renderer->GetUseShadows());
  if (!Peels(PassOfVolume(mapper, renderer, volume).kind) &&
    (isBlendedByOthers || HasVolumesOfOthers(renderer)))
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
  casters.lieBehindTranslucent = HasTranslucentGeometry(renderer);
  casters.originWorld = OriginNear(volume);
  casters.fingerprint.Add(casters.originWorld);
  return casters;
}

namespace
{

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

// The triangles of a surface, before planes cut them. Polygons are fans from their first corner, as
// for polygons without a notch.
std::vector<SurfaceTriangle> WholeTriangles(const ShadowCasters& casters, std::size_t surface)
{
  vtkPolyData* const data = casters.surfaces[surface].data;
  std::vector<SurfaceTriangle> triangles;
  ForEachCell(data->GetPolys(),
    [&](vtkIdType count, const vtkIdType* ids)
    {
      for (vtkIdType i = 2; i < count; ++i)
      {
        triangles.push_back({ surface, { ids[0], ids[i - 1], ids[i] } });
      }
    });
  ForEachCell(data->GetStrips(),
    [&](vtkIdType count, const vtkIdType* ids)
    {
      for (vtkIdType i = 2; i < count; ++i)
      {
        const vtkIdType turned = i % 2; // every second triangle of a strip runs the other way round
        triangles.push_back({ surface, { ids[i - 2 + turned], ids[i - 1 - turned], ids[i] } });
      }
    });
  return triangles;
}

glm::dvec3 CornerWorld(const CastingSurface& surface, vtkIdType point)
{
  glm::dvec3 place;
  surface.data->GetPoint(point, glm::value_ptr(place));
  return glm::dvec3(surface.worldFromData * glm::dvec4(place, 1.0));
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

// The triangles that planes leave.
CasterTriangles CutTriangles(
  const ShadowCasters& casters, std::size_t surface, const std::vector<SurfaceTriangle>& whole)
{
  const CastingSurface& cut = casters.surfaces[surface];
  CasterTriangles left;
  for (const SurfaceTriangle& source : whole)
  {
    std::vector<glm::dvec3> corners;
    for (const vtkIdType point : source.points)
    {
      corners.push_back(CornerWorld(cut, point));
    }
    for (const glm::dvec4& plane : cut.planesWorld)
    {
      corners = CutBy(plane, corners);
    }
    const auto cornerAt = [&](std::size_t i)
    { return glm::vec3(corners[i] - casters.originWorld); };
    for (std::size_t i = 2; i < corners.size(); ++i)
    {
      left.corners.push_back({ cornerAt(0), cornerAt(i - 1), cornerAt(i) });
      left.sources.push_back(source);
    }
  }
  return left;
}

}

CasterTriangles TrianglesOf(const ShadowCasters& casters, std::size_t surface)
{
  const CastingSurface& whole = casters.surfaces[surface];
  CasterTriangles made;
  made.sources = WholeTriangles(casters, surface);
  if (!whole.planesWorld.empty())
  {
    return CutTriangles(casters, surface, made.sources);
  }
  made.corners.resize(made.sources.size());
  tbb::parallel_for(std::size_t(0), made.sources.size(),
    [&](std::size_t i)
    {
      for (std::size_t corner = 0; corner < 3; ++corner)
      {
        made.corners[i][corner] =
          CornerWorld(whole, made.sources[i].points[corner]) - casters.originWorld;
      }
    });
  return made;
}

namespace
{

// Appends volumes that cast shadows to the list of props that earlier cullers have left. The list
// has room for all visible props.
class vtkShadowCuller : public vtkCuller
{
public:
  static vtkShadowCuller* New() { VTK_STANDARD_NEW_BODY(vtkShadowCuller); }
  vtkTypeMacro(vtkShadowCuller, vtkCuller);

  double Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& areTimesKnown) override
  {
    double time = 0.0;
    for (int i = 0; i < count; ++i)
    {
      if (!areTimesKnown)
      {
        props[i]->SetRenderTimeMultiplier(1.0);
      }
      time += props[i]->GetRenderTimeMultiplier();
    }
    areTimesKnown = 1;
    if (renderer->GetSelector())
    {
      return time;
    }
    for (vtkVolume* volume : VolumesBackToFront(renderer))
    {
      vtkVariationFieldVolumeMapper* const mapper = DrawingMapper(volume);
      const bool casts = mapper->GetShadows() && mapper->GetShadowStrength() > 0.0;
      if (casts && std::find(props, props + count, volume) == props + count)
      {
        constexpr double SmallPart = 0.05; // it has no pixels
        volume->SetRenderTimeMultiplier(SmallPart);
        props[count++] = volume;
        time += SmallPart;
      }
    }
    return time;
  }
};

}

void KeepShadowsOutOfView(vtkRenderer* renderer)
{
  vtkCullerCollection* const cullers = renderer->GetCullers();
  vtkCollectionSimpleIterator iterator;
  cullers->InitTraversal(iterator);
  while (vtkCuller* culler = cullers->GetNextCuller(iterator))
  {
    if (vtkShadowCuller::SafeDownCast(culler))
    {
      return;
    }
  }
  if (cullers->GetNumberOfItems() > 0)
  {
    renderer->AddCuller(vtkNew<vtkShadowCuller>());
  }
}

}
