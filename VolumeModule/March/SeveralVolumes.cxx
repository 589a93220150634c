// Several volumes in a renderer, each of which has a mapper of its own.

#include "Frame/FrameBuilder.h"
#include "Frame/RendererVolumes.h"
#include "Frame/VolumeGeometry.h"
#include "Frame/VoxelsOnDisk.h"
#include "Levels/LevelOfDetail.h"
#include "March/MapperInternals.h"
#include "VtkVersions.h"

#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVolume.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

namespace
{

/// A scope in which the framebuffer with the colours and depths of opaque geometry is bound, in the
/// middle of a pass that peels depths into a framebuffer of its own. VTK keeps the other one on the
/// stack of its state until it blends the layers over it.
class OpaqueFramebuffer
{
public:
  explicit OpaqueFramebuffer(vtkRenderer* renderer)
    : state(static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState())
    , viewport(state)
  {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &this->layers);
    glGetIntegerv(GL_BLEND_EQUATION_RGB, &this->blendEquation);
    this->state->PopDrawFramebufferBinding();
    this->state->vtkglBlendEquation(GL_FUNC_ADD);
    const varimarch::Viewport pixels = varimarch::ViewportOf(renderer);
    this->state->vtkglViewport(pixels.left, pixels.bottom, pixels.width, pixels.height);
  }

  ~OpaqueFramebuffer()
  {
    this->state->vtkglBlendEquation(GLenum(this->blendEquation));
    this->state->PushDrawFramebufferBinding();
    this->state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(this->layers));
  }

  OpaqueFramebuffer(const OpaqueFramebuffer&) = delete;
  void operator=(const OpaqueFramebuffer&) = delete;

private:
  vtkOpenGLState* state;
  vtkOpenGLState::ScopedglViewport viewport;
  GLint layers = 0; ///< The framebuffer of the layers.
  GLint blendEquation = 0;
};

bool Casts(const varimarch::Frame& frame)
{
  return frame.settings.casters && frame.casters.shadowing != varimarch::Shadowing::Nothing &&
    !varimarch::Picks(frame.pass.kind);
}

// The frame of the whole image of which layers are drawn. Volumes that VTK does not draw are not
// asked for layers.
varimarch::Frame WithoutLayers(varimarch::Frame frame)
{
  frame.pass = {};
  frame.settings.pass = frame.pass.kind;
  frame.settings.sceneGeometry = true;
  frame.casters.lieBehindTranslucent = false;
  frame.view.viewport = frame.view.inWindow;
  return frame;
}

// True if each of these volumes is drawn into images of its mapper.
bool AreDrawnToImages(const std::vector<vtkVolume*>& volumes)
{
  return std::all_of(volumes.begin(), volumes.end(),
    [](vtkVolume* volume) { return varimarch::DrawingMapper(volume)->GetRenderToImage() != 0; });
}

}

std::optional<vtkVariationFieldVolumeMapper::Internals::Casting>
vtkVariationFieldVolumeMapper::Internals::CastingOf(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  mapper->LockSampleDistance();
  std::optional<varimarch::Frame> frame = varimarch::BuildFrame(mapper, renderer, volume);
  if (!frame || !Casts(*frame))
  {
    return std::nullopt;
  }
  std::optional<varimarch::Frame> coarse =
    this->Levels.CoarseFrameAhead(mapper, volume, *frame, this->Last->AccumulatedImages() > 0);
  const auto quality = this->QualityOf(mapper, volume, *frame);
  return Casting{ mapper, coarse ? std::move(*coarse) : std::move(*frame), quality,
    coarse ? &this->Levels.Marcher() : &this->Marcher };
}

// Faults are those of the drawing that follows, which reports them.
void vtkVariationFieldVolumeMapper::Internals::CastOnGeometry(
  vtkRenderer* renderer, const std::vector<vtkVolume*>& volumes, bool isBetweenLayers)
{
  try
  {
    std::vector<Casting> all;
    for (vtkVolume* volume : volumes)
    {
      vtkVariationFieldVolumeMapper* const mapper = varimarch::DrawingMapper(volume);
      if (std::optional<Casting> casting = mapper->Private->CastingOf(mapper, renderer, volume))
      {
        casting->frame = isBetweenLayers ? WithoutLayers(casting->frame) : casting->frame;
        all.push_back(std::move(*casting));
      }
    }
    varimarch::ReceivedLight light;
    for (const Casting& one : all)
    {
      const varimarch::VoxelsOnDisk onDisk(one.frame, one.mapper->MaximumHostMemory);
      one.frame.view.window->MakeCurrent();
      vtkNew<vtkTimerLog> timer;
      timer->StartTimer();
      one.marcher->CastOnGeometry(one.frame, one.quality, light);
      if (&one == &all.back())
      {
        one.marcher->DimGeometry(one.frame, one.quality, light);
      }
      timer->StopTimer();
      one.mapper->Private->CastSeconds = timer->GetElapsedTime();
    }
  }
  catch (const std::exception&)
  {
    return;
  }
}

void vtkVariationFieldVolumeMapper::Internals::CastBeforeFirst(
  vtkVariationFieldVolumeMapper* mapper, vtkRenderer* renderer, varimarch::RayPass pass)
{
  const std::vector<vtkVolume*> volumes = varimarch::VolumesBackToFront(renderer);
  const bool isBetweenLayers = pass == varimarch::RayPass::PeelOutside;
  const bool isToImages =
    pass == varimarch::RayPass::Whole && volumes.size() > 1 && AreDrawnToImages(volumes);
  if (!isBetweenLayers && !isToImages)
  {
    return;
  }
  const vtkMTimeType time = varimarch::TimeOf(volumes, renderer);
  const DrawnAhead cast = std::exchange(mapper->Private->Cast, {});
  if (cast.Renderer == renderer && cast.Time == time)
  {
    return;
  }
  for (vtkVolume* volume : volumes)
  {
    vtkVariationFieldVolumeMapper* const other = varimarch::DrawingMapper(volume);
    other->Private->Cast = other == mapper ? DrawnAhead{} : DrawnAhead{ renderer, time };
  }
  std::optional<OpaqueFramebuffer> opaque;
  if (isBetweenLayers)
  {
    opaque.emplace(renderer);
  }
  CastOnGeometry(renderer, volumes, isBetweenLayers);
}

namespace
{

/// The volumes of a renderer that are not left to VTK.
struct OurVolumes
{
  std::vector<vtkVolume*> drawnNow; ///< Volumes that are drawn into images wait for their turn.
  bool areAll = true;
};

OurVolumes OurVolumesOf(
  const std::vector<vtkVolume*>& volumes, vtkRenderer* renderer, vtkVolume* first)
{
  OurVolumes ours;
  for (vtkVolume* volume : volumes)
  {
    if (volume != first)
    {
      volume->Update();
    }
    const bool isOurs = volume == first || !varimarch::IsLeftToVtk(volume, renderer);
    ours.areAll = ours.areAll && isOurs;
    if (isOurs && !varimarch::DrawingMapper(volume)->GetRenderToImage())
    {
      ours.drawnNow.push_back(volume);
    }
  }
  return ours;
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
  const OurVolumes ours = OurVolumesOf(volumes, renderer, volume);
  if (ours.areAll)
  {
    CastOnGeometry(renderer, volumes, false);
  }
  for (vtkVolume* next : ours.drawnNow)
  {
    vtkVariationFieldVolumeMapper* const nextMapper = varimarch::DrawingMapper(next);
    if (next != volume)
    {
      nextMapper->Private->Ahead = { renderer, time };
    }
    Draw(nextMapper, renderer, next);
  }
}
