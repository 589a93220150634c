// Several volumes in a renderer, each of which has a mapper of its own.

#include "Frame/FrameBuilder.h"
#include "Frame/RendererVolumes.h"
#include "Frame/VoxelsOnDisk.h"
#include "March/LevelOfDetail.h"
#include "March/MapperInternals.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

namespace
{

/// A volume whose shadows fall on geometry.
struct Casting
{
  vtkVariationFieldVolumeMapper* mapper;
  varimarch::Frame frame;
};

std::optional<varimarch::Frame> FrameOnGeometry(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  std::optional<varimarch::Frame> frame = varimarch::BuildFrame(mapper, renderer, volume);
  const bool casts = frame && frame->settings.casters &&
    frame->casters.shadowing == varimarch::Shadowing::AllVolumes &&
    frame->pass.kind == varimarch::RayPass::Whole && !frame->image.toImages &&
    !varimarch::IsInteractive(mapper, volume, *frame);
  return casts ? std::move(frame) : std::nullopt;
}

}

// Faults are those of the drawing that follows, which reports them.
void vtkVariationFieldVolumeMapper::Internals::CastOnGeometry(
  vtkRenderer* renderer, const std::vector<vtkVolume*>& volumes)
{
  try
  {
    std::vector<Casting> all;
    for (vtkVolume* volume : volumes)
    {
      vtkVariationFieldVolumeMapper* const mapper = varimarch::DrawingMapper(volume);
      mapper->LockSampleDistance();
      if (std::optional<varimarch::Frame> frame = FrameOnGeometry(mapper, renderer, volume))
      {
        all.push_back({ mapper, std::move(*frame) });
      }
    }
    varimarch::ReceivedLight light;
    for (const Casting& one : all)
    {
      const varimarch::VoxelsOnDisk onDisk(one.frame, one.mapper->MaximumHostMemory);
      one.frame.view.window->MakeCurrent();
      one.mapper->Private->Marcher.CastOnGeometry(one.frame, light, &one == &all.back());
    }
  }
  catch (const std::exception&)
  {
    return;
  }
}

// Draws all volumes of the renderer back to front, or only this one if it is not among them.
void vtkVariationFieldVolumeMapper::Internals::DrawInOrder(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  const std::vector<vtkVolume*> volumes = varimarch::VolumesBackToFront(renderer);
  const vtkMTimeType time = varimarch::TimeOf(volumes, renderer);
  const DrawnAhead ahead = std::exchange(mapper->Private->Ahead, {});
  if (ahead.Renderer == renderer && ahead.Time == time)
  {
    return;
  }
  const bool isListed = std::find(volumes.begin(), volumes.end(), volume) != volumes.end();
  if (!isListed || volumes.size() == 1)
  {
    Draw(mapper, renderer, volume);
    return;
  }
  std::vector<vtkVolume*> drawn;
  for (vtkVolume* next : volumes)
  {
    if (next != volume)
    {
      next->Update();
    }
    if (next == volume || !varimarch::IsLeftToVtk(next, renderer)) // else it waits for its turn
    {
      drawn.push_back(next);
    }
  }
  if (drawn.size() == volumes.size())
  {
    CastOnGeometry(renderer, volumes);
  }
  for (vtkVolume* next : drawn)
  {
    vtkVariationFieldVolumeMapper* const nextMapper = varimarch::DrawingMapper(next);
    if (next != volume)
    {
      nextMapper->Private->Ahead = { renderer, time };
    }
    Draw(nextMapper, renderer, next);
  }
}
