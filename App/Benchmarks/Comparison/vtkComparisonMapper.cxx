#include "vtkComparisonMapper.h"

#include "ComparisonMethods.h"
#include "ComparisonProgram.h"
#include "ComparisonVolume.h"
#include "VtkVersions.h"

#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

#include <glm/geometric.hpp>

#include <optional>
#include <stdexcept>
#include <string>

using namespace varimarch;

struct vtkComparisonMapper::Internals
{
  ComparisonVolume volume;
  ComparisonProgram program;
  ComparisonImage image;
  PassMethod passes;
  HalfAngleMethod halfAngle;
  LightVolumeMethod lightVolume;

  void DrawImage(vtkComparisonMapper* mapper, const ComparisonFrame& frame);
  void Show(const ComparedView& view);
};

namespace
{

Slices SlicesOf(int method)
{
  switch (method)
  {
    case vtkComparisonMapper::ObjectSlices:
      return Slices::Object;
    case vtkComparisonMapper::ObjectSlices2D:
      return Slices::Object2D;
    case vtkComparisonMapper::Shells:
      return Slices::Shells;
    default:
      return Slices::View;
  }
}

// The file of the slot Shadow for methods that march in passes; empty for others.
std::optional<std::string> ShadowOfPasses(int method)
{
  switch (method)
  {
    case vtkComparisonMapper::Passes:
      return NoShadow;
    case vtkComparisonMapper::SecondMarch:
      return "Shadow/SecondMarch.glsl";
    case vtkComparisonMapper::VtkShadows:
      return "Shadow/VtkRays.glsl";
    default:
      return std::nullopt;
  }
}

glm::dvec3 ToLightWorld(vtkComparisonMapper* mapper, const ComparedView& view)
{
  const double* const direction = mapper->GetLightDirection();
  const glm::dvec3 right = glm::cross(view.directionWorld, view.upWorld);
  return glm::normalize(
    direction[0] * right + direction[1] * view.upWorld - direction[2] * view.directionWorld);
}

// Scope guard for the OpenGL state and the framebuffer.
class KeptState
{
public:
  explicit KeptState(vtkOpenGLState* state)
    : state(state)
  {
    this->state->Push();
    this->state->PushFramebufferBindings();
  }

  ~KeptState()
  {
    this->state->PopFramebufferBindings();
    this->state->Pop();
  }

private:
  vtkOpenGLState* state;
};

}

void vtkComparisonMapper::Internals::DrawImage(
  vtkComparisonMapper* mapper, const ComparisonFrame& frame)
{
  if (const std::optional<std::string> shadow = ShadowOfPasses(mapper->GetMethod()))
  {
    this->passes.Draw(frame, this->image,
      { mapper->GetStepsPerPass(), mapper->GetEarlyTerminationTransmittance(), *shadow });
    return;
  }
  this->image.Begin(frame.view.window, frame.view.sizePixels, glm::vec4(0.0f));
  if (mapper->GetMethod() == HalfAngle)
  {
    this->halfAngle.Draw(frame, this->image, mapper->GetSpreadDegrees());
    return;
  }
  SetComparisonState(frame.view.window,
    mapper->GetFromBehind() ? ComparisonBlending::Over : ComparisonBlending::Under);
  if (mapper->GetMethod() == LightVolume)
  {
    this->lightVolume.Draw(frame, mapper->GetLightPoints(), mapper->GetFromBehind());
    return;
  }
  DrawSlices(frame, SlicesOf(mapper->GetMethod()), mapper->GetFromBehind());
}

// The framebuffer of the renderer is bound.
void vtkComparisonMapper::Internals::Show(const ComparedView& view)
{
  SetComparisonState(view.window, ComparisonBlending::Over);
  this->program.Use(view.window, "Screen.vert.glsl", { "Show.frag.glsl" });
  this->program.Set("gatheredTexture", this->image.Color());
  this->program.Set("originPixels", glm::vec2(view.originPixels));
  this->program.SetTriangles(
    { { -1.0f, -1.0f, 0.0f }, { 3.0f, -1.0f, 0.0f }, { -1.0f, 3.0f, 0.0f } });
  this->program.DrawAll();
  this->program.DeactivateTextures();
}

vtkStandardNewMacro(vtkComparisonMapper);

vtkComparisonMapper::vtkComparisonMapper()
  : Private(std::make_unique<Internals>())
{
}

vtkComparisonMapper::~vtkComparisonMapper() = default;

void vtkComparisonMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  auto* const image = vtkImageData::SafeDownCast(this->GetInput());
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  try
  {
    const bool isCorrected = this->CorrectedTable && this->Method == Passes;
    this->Private->volume.Update(
      window, image, volume, { this->Storage, isCorrected ? this->SampleDistance : 0.0 });
    const ComparedView view = ComparedViewOf(renderer, this->Private->volume.Geometry());
    {
      const KeptState kept(window->GetState());
      this->Private->DrawImage(this,
        { view, this->Private->volume, this->Private->program, this->SampleDistance,
          ToLightWorld(this, view) });
    }
    const KeptState kept(window->GetState());
    this->Private->Show(view);
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro(<< problem.what());
  }
}

double vtkComparisonMapper::GetGraphicsMemoryBytes()
{
  return double(this->Private->volume.Bytes()) + this->GetLightMemoryBytes();
}

double vtkComparisonMapper::GetLightMemoryBytes()
{
  return double(this->Private->halfAngle.Bytes() + this->Private->lightVolume.Bytes());
}

void vtkComparisonMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Private->volume.Release(window);
  this->Private->program.Release();
  this->Private->image.Release(window);
  this->Private->passes.Release(window);
  this->Private->halfAngle.Release(window);
  this->Private->lightVolume.Release(window);
}

void vtkComparisonMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Storage: " << int(this->Storage) << "\n";
  os << indent << "CorrectedTable: " << this->CorrectedTable << "\n";
  os << indent << "SampleDistance: " << this->SampleDistance << "\n";
  os << indent << "FromBehind: " << this->FromBehind << "\n";
  os << indent << "StepsPerPass: " << this->StepsPerPass << "\n";
  os << indent << "EarlyTerminationTransmittance: " << this->EarlyTerminationTransmittance << "\n";
  os << indent << "LightDirection: " << this->LightDirection[0] << " " << this->LightDirection[1]
     << " " << this->LightDirection[2] << "\n";
  os << indent << "SpreadDegrees: " << this->SpreadDegrees << "\n";
  os << indent << "LightPoints: " << this->LightPoints << "\n";
}
