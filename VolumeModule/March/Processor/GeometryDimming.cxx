#include "March/Processor/GeometryDimming.h"

#include "Core/Packets/PacketMarch.h"
#include "March/Processor/GeometryLight.h"
#include "March/Processor/GeometryReceivers.h"
#include "March/Processor/PacketScenes.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace varimarch
{

namespace
{

constexpr std::size_t LightsAtOnce = 4; ///< as many as a pixel has numbers

using Receivers = std::vector<GeometryReceiver>;

// The places of all pixels [grid space], with 1 as fourth number, or 0 where no receiver is.
std::vector<glm::vec4> PlacesOf(
  const Receivers& receivers, const glm::dmat4& gridFromWorld, const Viewport& pixels)
{
  std::vector<glm::vec4> places(std::size_t(pixels.width) * std::size_t(pixels.height));
  for (const GeometryReceiver& receiver : receivers)
  {
    places[receiver.pixel] = gridFromWorld * glm::dvec4(receiver.placeWorld, 1.0);
  }
  return places;
}

// All that the factors of an image depend on that is accumulated; empty for another image, and for
// overlapping volumes, of which the fingerprint has the first only. VTK's highlights depend on the
// place of the eye in a parallel projection too.
std::vector<double> InputsOf(const Frame& frame, const MarchPlan& plan)
{
  std::vector<double> inputs =
    frame.others.empty() ? frame.accumulation.fingerprint : std::vector<double>();
  if (!inputs.empty())
  {
    const double* const eye = frame.view.renderer->GetActiveCamera()->GetPosition();
    inputs.insert(inputs.end(), eye, eye + 3);
    inputs.insert(inputs.end(),
      { plan.sampleDistanceMm, double(plan.marcher), double(plan.isInteractive),
        double(frame.casters.shadowing) });
  }
  return inputs;
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

// The factors of all pixels, 1 where no receiver is.
std::vector<glm::vec4> FactorsOf(
  const Frame& frame, std::size_t pixelCount, const ReceivedLight& received)
{
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

// A box in the grid whose inner faces cover all receivers on the screen.
Box CoverOf(const Box& boxGrid, const glm::dmat4& gridFromWorld, const Receivers& receivers)
{
  Box box = boxGrid;
  for (const GeometryReceiver& receiver : receivers)
  {
    const glm::dvec3 place(gridFromWorld * glm::dvec4(receiver.placeWorld, 1.0));
    box = { glm::min(box.lower, place), glm::max(box.upper, place) };
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
    frame.settings.sceneGeometry && !plan.isInteractive && !this->resources.IsNothingDrawn();
}

std::vector<std::vector<float>> GeometryDimming::LightByPackets(
  const Frame& frame, const MarchPlan& plan, const std::vector<glm::vec4>& places)
{
  const Viewport pixels = PixelsOf(plan);
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

std::vector<std::vector<float>> GeometryDimming::LightByShader(const Frame& frame,
  const MarchPlan& plan, const std::vector<glm::vec4>& places, const Box& coverGrid)
{
  vtkOpenGLRenderWindow* const window = frame.view.window;
  const Viewport pixels = PixelsOf(plan);
  this->image.Take(window, places, pixels);
  DrawnBlock drawn = AllThatIsVisible(this->resources.DrawnBox());
  drawn.block = &this->resources.First().Blocks().Take(window, 0);
  drawn.voxels = { glm::ivec3(0), frame.geometry.dimensions };
  drawn.coverGrid = coverGrid;
  EarlierDrawings earlier;
  earlier.marched = this->image.Texture();
  earlier.marchedPixels = pixels;
  const MarchPlan tracing = plan.WithRole(ShaderRole::LightPlaces).WithViewport(pixels);
  this->light.Draw(window, pixels, [&] { this->boxes.Draw(frame, tracing, drawn, earlier); });
  return { this->light.Read(window, pixels, 0), this->light.Read(window, pixels, 1) };
}

void GeometryDimming::Dim(const Frame& frame, const MarchPlan& plan)
{
  const std::vector<double> inputs = InputsOf(frame, plan);
  if (inputs.empty() || inputs != this->keptFor)
  {
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
  if (!this->MayDim(frame, plan))
  {
    return;
  }
  if (received.receivers.empty())
  {
    received.receivers = GeometryReceiversOf(frame, this->resources, plan.viewport);
    std::array<float, MostShadowedLights> all;
    all.fill(1.0f);
    received.parts.assign(received.receivers.size(), all);
  }
  if (received.receivers.empty())
  {
    return;
  }
  const glm::dmat4 gridFromWorld = glm::inverse(frame.geometry.worldFromGrid);
  const std::vector<glm::vec4> places = PlacesOf(received.receivers, gridFromWorld, PixelsOf(plan));
  const Box box = CoverOf(frame.geometry.boxGrid, gridFromWorld, received.receivers);
  ++this->tracings;
  Multiply(received,
    plan.marcher == Marcher::Processor ? this->LightByPackets(frame, plan, places)
                                       : this->LightByShader(frame, plan, places, box),
    frame.material.surfacesInShadow);
}

void GeometryDimming::Draw(const Frame& frame, const MarchPlan& plan, const ReceivedLight& received)
{
  this->keptFor.clear();
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
  const Viewport pixels = PixelsOf(plan);
  const std::size_t pixelCount = std::size_t(pixels.width) * std::size_t(pixels.height);
  this->image.Take(frame.view.window, FactorsOf(frame, pixelCount, received), pixels);
  this->cover =
    CoverOf(frame.geometry.boxGrid, glm::inverse(frame.geometry.worldFromGrid), received.receivers);
}

void GeometryDimming::DrawFactors(const Frame& frame, const MarchPlan& plan)
{
  if (this->image.Bytes() == 0)
  {
    return;
  }
  DrawnBlock drawn = AllThatIsVisible(this->resources.DrawnBox());
  drawn.coverGrid = this->cover;
  EarlierDrawings earlier;
  earlier.marched = this->image.Texture();
  earlier.marchedPixels = PixelsOf(plan);
  this->boxes.Draw(frame, plan.WithRole(ShaderRole::DimGeometry), drawn, earlier);
}

void GeometryDimming::Release(vtkWindow* window)
{
  this->image.Release(window);
  this->light.Release(window);
  this->keptFor.clear();
}

}
