#include "March/Processor/GeometryDimming.h"

#include "Core/Packets/PacketMarch.h"
#include "Core/Quality/StepSearch.h"
#include "Core/Quality/TrialRays.h"
#include "Frame/Frame.h"
#include "Frame/FrameMeasures.h"
#include "Frame/Lights.h"
#include "March/Processor/GeometryReceivers.h"
#include "March/Processor/PacketSceneBuilder.h"
#include "Tolerance/SearchFacts.h"
#include "VtkVersions.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkType.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace varimarch
{

std::vector<glm::vec4> TranslucentColors::Draw(
  const FrameView& view, const SceneDepthTexture& depth)
{
  const glm::ivec2 pixels = depth.SizePixels();
  vtkOpenGLState* const state = view.window->GetState();
  const vtkOpenGLState::ScopedglViewport viewport(state);
  const vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  const vtkOpenGLState::ScopedglClearColor clearColor(state);
  std::vector<glm::vec4> colors(std::size_t(pixels.x) * std::size_t(pixels.y));
  state->PushFramebufferBindings();
  this->Bind(view.window, depth);
  state->vtkglViewport(0, 0, pixels.x, pixels.y);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  state->vtkglClear(GL_COLOR_BUFFER_BIT);
  view.renderer->DeviceRenderTranslucentPolygonalGeometry(this->framebuffer);
  this->framebuffer->ActivateReadBuffer(0);
  state->vtkglPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, pixels.x, pixels.y, GL_RGBA, GL_FLOAT, &colors.front().x);
  state->PopFramebufferBindings();
  return colors;
}

void TranslucentColors::Bind(vtkOpenGLRenderWindow* window, const SceneDepthTexture& depth)
{
  const glm::ivec2 pixels = depth.SizePixels();
  this->framebuffer->SetContext(window);
  this->color->SetContext(window);
  if (!this->color->GetHandle() || int(this->color->GetWidth()) != pixels.x ||
    int(this->color->GetHeight()) != pixels.y)
  {
    this->color->Allocate2D(unsigned(pixels.x), unsigned(pixels.y), 4, VTK_FLOAT);
  }
  this->framebuffer->Bind();
  this->framebuffer->AddColorAttachment(0, this->color);
  this->framebuffer->AddDepthAttachment(depth.Texture().onDevice);
  this->framebuffer->Resize(pixels.x, pixels.y); // VTK's passes ask for the size
  this->framebuffer->ActivateDrawBuffer(0);
}

std::size_t TranslucentColors::Bytes() const
{
  const std::size_t pixels = std::size_t(this->color->GetWidth()) * this->color->GetHeight();
  return this->color->GetHandle() ? 4 * sizeof(float) * pixels : 0;
}

void TranslucentColors::Release(vtkWindow* window)
{
  this->framebuffer->ReleaseGraphicsResources(window);
  this->color->ReleaseGraphicsResources(window);
}

namespace
{

/// The light of opaque geometry as VTK's mapper of polygons draws it: ambient light, and diffuse
/// and specular light of each lamp by the model of Phong, both with the lamp's diffuse colour. It
/// tells what of the drawn colours stays where a volume takes a part of the lamps. Surfaces without
/// lighting, and those by physically based rendering, keep all of it. If the data or a block have
/// the colours, these count as white, which is exact without specular light. A texture multiplies
/// all light alike.
class GeometryLight
{
public:
  explicit GeometryLight(const Frame& frame);

  /// The factors of red, green and blue.
  /// @param parts  of each lamp that a volume may take light from, in the order of LightTexels
  template <class Parts>
  glm::dvec3 FactorsAt(const GeometryReceiver& receiver, const Parts& parts) const
  {
    const Look look = this->LookOf(receiver.surface);
    glm::dvec3 whole = look.ambient + this->HeadLightOn(receiver, look);
    glm::dvec3 left = whole;
    for (int lamp = 0; lamp < this->lights.Count(); ++lamp)
    {
      const glm::dvec3 own = this->LampOn(lamp, receiver, look);
      whole += own;
      left += parts(lamp) * own;
    }
    return Ratio(left, whole);
  }

private:
  /// The colours of a surface times its coefficients.
  struct Look
  {
    glm::dvec3 ambient;
    glm::dvec3 diffuse;
    glm::dvec3 specular;
    double power;
  };

  static glm::dvec3 Ratio(glm::dvec3 left, glm::dvec3 whole);
  Look LookOf(std::size_t surface) const;
  glm::dvec3 HeadLightOn(const GeometryReceiver& receiver, const Look& look) const;
  glm::dvec3 LampOn(int lamp, const GeometryReceiver& receiver, const Look& look) const;

  const Frame& frame;
  const LightTexels& lights;
  const HeadLightColors& head;
  glm::dvec3 towardsHeadWorld; ///< against the direction of the camera
};

/// The diffuse and the specular part of a lamp that a surface sends to the eye.
struct Sent
{
  double diffuse;
  double specular;
};

Sent SentBy(const GeometryReceiver& receiver, glm::dvec3 toLight, double power)
{
  const double facing = glm::dot(receiver.normalWorld, toLight);
  if (!(facing > 0.0))
  {
    return { 0.0, 0.0 };
  }
  const glm::dvec3 mirrored = 2.0 * facing * receiver.normalWorld - toLight;
  return { facing,
    std::pow(std::max(glm::dot(mirrored, receiver.toEyeWorld), 0.0), std::max(power, 0.0)) };
}

// The part of a lamp's strength that is left at a distance, and inside its cone.
double StrengthOf(const glm::vec4* lamp, glm::dvec3 toLight, double distanceMm)
{
  const glm::dvec3 attenuation(lamp[3]);
  const double strength =
    1.0 / (attenuation.x + distanceMm * (attenuation.y + distanceMm * attenuation.z));
  const double alongAxis = -glm::dot(toLight, glm::dvec3(lamp[4]));
  return alongAxis < double(lamp[1].w)
    ? 0.0
    : strength * std::pow(std::max(alongAxis, 0.0), double(lamp[2].w));
}

GeometryLight::GeometryLight(const Frame& frame)
  : frame(frame)
  , lights(frame.lights.lamps)
  , head(frame.lights.head)
  , towardsHeadWorld(-frame.view.forwardWorld)
{
}

glm::dvec3 GeometryLight::Ratio(glm::dvec3 left, glm::dvec3 whole)
{
  const auto part = [](double a, double b) { return b > 0.0 ? std::clamp(a / b, 0.0, 1.0) : 1.0; };
  return { part(left.x, whole.x), part(left.y, whole.y), part(left.z, whole.z) };
}

GeometryLight::Look GeometryLight::LookOf(std::size_t surface) const
{
  const CastingSurface& drawn = this->frame.casters.surfaces[surface];
  vtkProperty* const property = drawn.property;
  if (!property->GetLighting() || property->GetInterpolation() == VTK_PBR)
  {
    return { glm::dvec3(1.0), glm::dvec3(0.0), glm::dvec3(0.0), 1.0 };
  }
  const auto colorOf = [&](const double* color)
  { return drawn.hasColors ? glm::dvec3(1.0) : glm::dvec3(glm::make_vec3(color)); };
  return { property->GetAmbient() * colorOf(property->GetAmbientColor()),
    property->GetDiffuse() * colorOf(property->GetDiffuseColor()),
    property->GetSpecular() * glm::make_vec3(property->GetSpecularColor()),
    property->GetSpecularPower() };
}

glm::dvec3 GeometryLight::HeadLightOn(const GeometryReceiver& receiver, const Look& look) const
{
  const Sent sent = SentBy(receiver, this->towardsHeadWorld, look.power);
  return (sent.diffuse * look.diffuse + sent.specular * look.specular) * this->head.diffuse;
}

glm::dvec3 GeometryLight::LampOn(int lamp, const GeometryReceiver& receiver, const Look& look) const
{
  const glm::vec4* const texels = &this->lights.texels[std::size_t(lamp) * LightTexels::PerLight];
  const bool isDistant = lamp < this->lights.distantCount;
  const glm::dvec3 way =
    isDistant ? glm::dvec3(texels[0]) : glm::dvec3(texels[0]) - receiver.placeWorld;
  const double distanceMm = glm::length(way);
  if (!(distanceMm > 0.0))
  {
    return glm::dvec3(0.0);
  }
  const glm::dvec3 toLight = way / distanceMm;
  const double strength = isDistant ? 1.0 : StrengthOf(texels, toLight, distanceMm);
  const Sent sent = SentBy(receiver, toLight, look.power);
  return strength * (sent.diffuse * look.diffuse + sent.specular * look.specular) *
    glm::dvec3(texels[1]);
}

constexpr std::size_t LightsAtOnce = 4; ///< as many as a pixel has numbers

// The longest step of light on geometry, in voxels.
constexpr double CoarsestLightVoxels = 4.0;

// The places of all squares of pixels [grid space], with 1 as fourth number, or 0 where no receiver
// is.
std::vector<glm::vec4> PlacesOf(const Frame& frame, const ReceivedLight& received)
{
  const glm::dmat4 gridFromWorld = glm::inverse(frame.geometry.worldFromGrid);
  const Viewport pixels = received.grid.Pixels();
  std::vector<glm::vec4> places(std::size_t(pixels.width) * std::size_t(pixels.height));
  for (const GeometryReceiver& receiver : received.receivers)
  {
    places[receiver.pixel] = gridFromWorld * glm::dvec4(receiver.placeWorld, 1.0);
  }
  return places;
}

// All that the factors of an image depend on that is accumulated; empty for another image, and for
// overlapping volumes, of which the fingerprint has the first only. VTK's highlights depend on the
// place of the eye in a parallel projection too.
Fingerprint InputsOf(const Frame& frame, const MarchPlan& plan)
{
  const Fingerprint& image = frame.accumulation.fingerprint;
  if (image.IsEmpty() || !frame.others.empty())
  {
    return {};
  }
  return Fingerprint(image, frame.view.eyeWorld, plan.sampleDistanceMm, plan.marcher,
    plan.isInteractive, frame.casters.shadowing, frame.casters.lieBehindTranslucent);
}

// While somebody interacts, a square of pixels has as many rays of the volume as places.
ReceiverGrid GridOf(const MarchPlan& plan)
{
  const double side = plan.isInteractive ? plan.imageSampleDistance : 1.0;
  return { plan.viewport, std::max(int(std::lround(side)), 1) };
}

// Some of the receivers, as an image of their own: as many as a trial image has rays.
ReceivedLight TrialOf(const ReceivedLight& received)
{
  constexpr int Side = 64;
  ReceivedLight trial;
  trial.grid.viewport = { 0, 0, Side, Side };
  for (const std::size_t index :
    TrialIndices(received.receivers.size(), std::size_t(Side) * std::size_t(Side)))
  {
    trial.receivers.push_back(received.receivers[index]);
    trial.receivers.back().pixel = trial.receivers.size() - 1;
  }
  return trial;
}

// The numbers of the receivers alone, one receiver after the other.
std::vector<float> NumbersOf(
  const std::vector<std::vector<float>>& parts, const ReceivedLight& trial)
{
  std::vector<float> numbers;
  for (const std::vector<float>& ofPixels : parts)
  {
    numbers.insert(numbers.end(), ofPixels.begin(),
      ofPixels.begin() + std::ptrdiff_t(4 * trial.receivers.size()));
  }
  return numbers;
}

// The pixels of a plan's viewport, counted from its corner.
Viewport PixelsOf(const MarchPlan& plan)
{
  return { 0, 0, plan.viewport.width, plan.viewport.height };
}

// Multiplies the parts of lamps that other volumes leave by those that a volume leaves.
// @param parts  the parts of the lamps: for each four of them the numbers of all pixels
void Multiply(
  ReceivedLight& light, const std::vector<std::vector<float>>& parts, double shadowStrength)
{
  tbb::parallel_for(std::size_t(0), light.receivers.size(),
    [&](std::size_t i)
    {
      for (std::size_t lamp = 0; lamp < LightsAtOnce * parts.size(); ++lamp)
      {
        const std::vector<float>& group = parts[lamp / LightsAtOnce];
        const double part = group[4 * light.receivers[i].pixel + lamp % LightsAtOnce];
        light.parts[i][lamp] *= float(1.0 - shadowStrength * (1.0 - part));
      }
    });
}

// The factors of all squares of pixels, 1 where no receiver is.
std::vector<glm::vec4> FactorsOfSquares(const Frame& frame, const ReceivedLight& received)
{
  const Viewport squares = received.grid.Pixels();
  const std::size_t pixelCount = std::size_t(squares.width) * std::size_t(squares.height);
  const GeometryLight light(frame);
  std::vector<glm::vec4> factors(pixelCount, glm::vec4(1.0f));
  tbb::parallel_for(std::size_t(0), received.receivers.size(),
    [&](std::size_t i)
    {
      const auto partOf = [&](int lamp)
      { return lamp < MostShadowedLights ? double(received.parts[i][std::size_t(lamp)]) : 1.0; };
      const GeometryReceiver& receiver = received.receivers[i];
      factors[receiver.pixel] = glm::dvec4(light.FactorsAt(receiver, partOf), 1.0);
    });
  return factors;
}

// A box in the grid whose inner faces cover all receivers on the screen, with their squares.
Box CoverOf(const Frame& frame, const ReceivedLight& received)
{
  const glm::dmat4 gridFromWorld = glm::inverse(frame.geometry.worldFromGrid);
  const glm::dvec3 gridPerMm = glm::abs(glm::dvec3(gridFromWorld[0])) +
    glm::abs(glm::dvec3(gridFromWorld[1])) + glm::abs(glm::dvec3(gridFromWorld[2]));
  Box box = frame.geometry.boxGrid;
  for (const GeometryReceiver& receiver : received.receivers)
  {
    const glm::dvec3 place(gridFromWorld * glm::dvec4(receiver.placeWorld, 1.0));
    const glm::dvec3 around = double(received.grid.side - 1) * receiver.pixelMm * gridPerMm;
    box = { glm::min(box.lower, place - around), glm::max(box.upper, place + around) };
  }
  return WithItsEdges(box);
}

}

// A shader sees one block of a volume at a time, and one of several volumes.
bool GeometryDimming::MayDim(const Frame& frame, const MarchPlan& plan) const
{
  const bool sees = plan.marcher == Marcher::Processor ||
    (!this->resources.IsInBlocks() && frame.others.empty() && frame.userCode.IsEmpty());
  return sees && frame.settings.casters && frame.casters.shadowing != Shadowing::Nothing &&
    frame.settings.sceneGeometry && !this->resources.IsNothingDrawn();
}

std::vector<std::vector<float>> GeometryDimming::LightByPackets(
  const Frame& frame, const MarchPlan& plan, const ReceivedLight& received)
{
  const Viewport pixels = received.grid.Pixels();
  const std::vector<glm::vec4> places = PlacesOf(frame, received);
  PacketSurroundings around = {};
  around.drawnBox = this->resources.DrawnBox();
  around.depthPixels = this->resources.Depth().SizePixels();
  around.textures = this->resources.Textures();
  const PacketScenes scenes(MarchOf(frame, plan), this->resources, std::move(around), pixels);
  PacketScene scene = scenes.Scene();
  const int count =
    std::min(scene.parameters.distantCount + scene.parameters.nearCount, MostShadowedLights);
  std::vector<std::vector<float>> parts;
  for (int first = 0; first < count; first += int(LightsAtOnce))
  {
    scene.receivers = { places.data(), pixels, first };
    parts.emplace_back(4 * places.size());
    MarchPackets(scene, pixels, parts.back().data());
  }
  return parts;
}

std::vector<std::vector<float>> GeometryDimming::LightByShader(
  const Frame& frame, const MarchPlan& plan, const ReceivedLight& received)
{
  vtkOpenGLRenderWindow* const window = frame.view.window;
  const Viewport pixels = received.grid.Pixels();
  this->image.Take(window, PlacesOf(frame, received), pixels);
  DrawnBlock drawn = AllThatIsVisible(this->resources.DrawnBox());
  drawn.block = &this->resources.First().Blocks().Take(window, 0);
  drawn.voxels = { glm::ivec3(0), frame.geometry.dimensions };
  drawn.coverGrid = CoverOfView(frame);
  EarlierDrawings earlier;
  earlier.marched = this->image.Texture();
  earlier.marchedPixels = pixels;
  const MarchPlan tracing = plan.WithRole(ShaderRole::LightPlaces).WithViewport(pixels);
  this->light.Draw(window, pixels, [&] { this->boxes.Draw(frame, tracing, drawn, earlier); });
  return { this->light.Read(window, pixels, 0), this->light.Read(window, pixels, 1) };
}

void GeometryDimming::Dim(const Frame& frame, const MarchPlan& plan)
{
  const Fingerprint inputs = InputsOf(frame, plan);
  if (inputs.IsEmpty() || inputs != this->keptFor)
  {
    this->foundStep.reset();
    ReceivedLight received;
    if (frame.casters.shadowing == Shadowing::OneVolume)
    {
      this->TakeLight(frame, plan, received);
    }
    this->TakeFactors(frame, plan, received);
    this->keptFor = inputs;
  }
  this->DrawFactors(frame, plan);
}

void GeometryDimming::TakeLight(const Frame& frame, const MarchPlan& plan, ReceivedLight& received)
{
  this->foundStep.reset();
  if (!this->MayDim(frame, plan))
  {
    return;
  }
  if (received.receivers.empty())
  {
    received.grid = GridOf(plan);
    received.receivers = GeometryReceiversOf(frame, this->resources, received.grid);
    std::array<float, MostShadowedLights> all;
    all.fill(1.0f);
    received.parts.assign(received.receivers.size(), all);
  }
  if (received.receivers.empty())
  {
    return;
  }
  ++this->tracings;
  Multiply(received, this->LightOn(frame, this->WithSteps(frame, plan, received), received),
    frame.material.surfacesInShadow);
}

// The rays of the eye may need other steps: they may see nothing of the volume.
MarchPlan GeometryDimming::WithSteps(
  const Frame& frame, const MarchPlan& plan, const ReceivedLight& received)
{
  MarchPlan stepped = plan;
  if (!(plan.budget.StepTolerance() > 0.0))
  {
    return stepped;
  }
  // Lattices of light would give all trials of this search the same error.
  stepped.light = { 0.0, 0.0 };
  const ReceivedLight trial = TrialOf(received);
  const auto drawAt = [&](double sampleDistanceMm)
  {
    stepped.sampleDistanceMm = sampleDistanceMm;
    return NumbersOf(this->LightOn(frame, stepped, trial), trial);
  };
  const double voxelMm = SmallestSpacingMm(frame);
  const FoundSteps found = FindSampleDistance(drawAt, plan.budget.StepLimit(),
    { CoarsestLightVoxels * voxelMm, FinestStepVoxels * voxelMm }, voxelMm);
  this->foundStep = found.choice;
  stepped.sampleDistanceMm = found.choice.sampleDistance;
  return stepped;
}

std::vector<std::vector<float>> GeometryDimming::LightOn(
  const Frame& frame, const MarchPlan& plan, const ReceivedLight& received)
{
  return plan.marcher == Marcher::Processor ? this->LightByPackets(frame, plan, received)
                                            : this->LightByShader(frame, plan, received);
}

void GeometryDimming::Draw(const Frame& frame, const MarchPlan& plan, const ReceivedLight& received)
{
  this->keptFor = {};
  this->TakeFactors(frame, plan, received);
  this->DrawFactors(frame, plan);
}

void GeometryDimming::TakeFactors(
  const Frame& frame, const MarchPlan& plan, const ReceivedLight& received)
{
  if (received.receivers.empty())
  {
    this->Release(frame.view.window);
    return;
  }
  std::vector<glm::vec4> taken = FactorsOfSquares(frame, received);
  if (received.grid.side > 1)
  {
    this->resources.Depth().Read(frame.view.window);
    const glm::dvec3 origin = frame.casters.originWorld;
    const PixelPlaces places(frame.view, this->resources.Depth(), plan.viewport, origin);
    taken = FactorsBetween(received.grid, received.receivers, taken, places, origin);
  }
  this->image.Take(frame.view.window, taken, PixelsOf(plan));
  this->cover = CoverOf(frame, received);
  this->factors = frame.casters.lieBehindTranslucent ? std::move(taken) : std::vector<glm::vec4>();
}

void GeometryDimming::DrawFactors(const Frame& frame, const MarchPlan& plan)
{
  if (this->image.Bytes() == 0)
  {
    return;
  }
  const MarchPlan dimming = plan.WithRole(ShaderRole::DimGeometry);
  this->DrawImage(frame, dimming, this->image);
  if (frame.casters.lieBehindTranslucent)
  {
    this->AddTranslucent(frame, dimming);
  }
  else
  {
    this->added.Release(frame.view.window);
    this->translucent.Release(frame.view.window);
  }
}

void GeometryDimming::AddTranslucent(const Frame& frame, const MarchPlan& plan)
{
  std::vector<glm::vec4> lacking = this->translucent.Draw(frame.view, this->resources.Depth());
  for (std::size_t i = 0; i < lacking.size(); ++i)
  {
    const glm::vec3 factor(this->factors[i]);
    lacking[i] = glm::vec4((1.0f - factor) * glm::vec3(lacking[i]), 0.0f);
  }
  this->added.Take(frame.view.window, lacking, PixelsOf(plan));
  MarchPlan adding = plan;
  adding.addsUp = true;
  this->DrawImage(frame, adding, this->added);
}

void GeometryDimming::DrawImage(
  const Frame& frame, const MarchPlan& plan, PacketPicture& drawnImage)
{
  DrawnBlock drawn = AllThatIsVisible(this->resources.DrawnBox());
  drawn.coverGrid = this->cover;
  EarlierDrawings earlier;
  earlier.marched = drawnImage.Texture();
  earlier.marchedPixels = PixelsOf(plan);
  this->boxes.Draw(frame, plan, drawn, earlier);
}

void GeometryDimming::Release(vtkWindow* window)
{
  this->image.Release(window);
  this->added.Release(window);
  this->translucent.Release(window);
  this->light.Release(window);
  this->factors.clear();
  this->keptFor = {};
}

}
