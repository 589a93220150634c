#ifndef Varimarch_March_Processor_GeometryDimming_h
#define Varimarch_March_Processor_GeometryDimming_h

#include "Core/Packets/PacketScene.h"
#include "Core/Quality/StepSearch.h"
#include "Frame/Frame.h"
#include "March/Device/BoxDrawing.h"
#include "March/Processor/GeometryReceivers.h"
#include "March/Processor/PacketPicture.h"
#include "Resources/FloatFramebuffer.h"
#include "Resources/SceneDepthTexture.h"

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace varimarch
{

/// The light that translucent geometry adds to the colours behind it. VTK blends translucent
/// geometry over opaque geometry before it draws volumes, and blending is linear in the colour
/// behind: if opaque geometry keeps a factor f of its light, then a colour F in the framebuffer, to
/// which translucent geometry has added C, becomes f F + (1 - f) C.
class TranslucentColors
{
public:
  /// Draws the translucent geometry of a renderer again, over black, behind the same opaque depths.
  /// It draws no volumes.
  /// @returns C for each pixel of the depths, row by row from below
  std::vector<glm::vec4> Draw(const FrameView& view, const SceneDepthTexture& depth);

  std::size_t Bytes() const;
  void Release(vtkWindow* window);

private:
  void Bind(vtkOpenGLRenderWindow* window, const SceneDepthTexture& depth);

  vtkNew<vtkTextureObject> color;
  vtkNew<vtkOpenGLFramebufferObject> framebuffer;
};

/// The opaque geometry that pixels show, and what volumes leave of the lamps' light on it.
struct ReceivedLight
{
  ReceiverGrid grid;
  std::vector<GeometryReceiver> receivers;
  /// For each receiver the parts of the lamps that may cast shadows, [0, 1].
  std::vector<std::array<float, MostShadowedLights>> parts;
};

/// Lets opaque geometry receive the shadows of volumes: before a volume is drawn, the colours of
/// the geometry in the framebuffer are multiplied by what volumes leave of their light. The
/// processor finds the places that are seen. Whoever marches a volume traces the lights from
/// there: packets of rays or a shader. While somebody interacts, there are as many places as the
/// volume has rays. Translucent geometry, which VTK has blended over the colours, keeps its light.
class GeometryDimming
{
public:
  GeometryDimming(SceneResources& resources, BoxDrawing& boxes)
    : resources(resources)
    , boxes(boxes)
  {
  }

  /// Dims geometry in the current framebuffer by the one volume of the renderer, if the frame has
  /// shadows and geometry that may receive them.
  void Dim(const Frame& frame, const MarchPlan& plan);

  /// Takes the light of a volume's shadows from geometry, if the frame has both.
  /// @param light  what other volumes leave; without receivers, if this is the first one
  void TakeLight(const Frame& frame, const MarchPlan& plan, ReceivedLight& light);

  /// Dims geometry in the current framebuffer.
  void Draw(const Frame& frame, const MarchPlan& plan, const ReceivedLight& light);

  /// How often the light on geometry was traced. Images of one volume that are accumulated
  /// share it.
  int Tracings() const { return this->tracings; }
  /// The steps that were found for the light on geometry in the last image; none without any.
  const std::optional<StepChoice>& FoundStep() const { return this->foundStep; }
  std::size_t Bytes() const
  {
    return this->image.Bytes() + this->light.Bytes() + this->added.Bytes() +
      this->translucent.Bytes();
  }
  void Release(vtkWindow* window);

private:
  bool MayDim(const Frame& frame, const MarchPlan& plan) const;
  /// The plan with steps that keep the error tolerance of the light on receivers.
  MarchPlan WithSteps(const Frame& frame, const MarchPlan& plan, const ReceivedLight& received);
  /// The parts of the lamps that a volume leaves: for each four of them the numbers of all squares.
  std::vector<std::vector<float>> LightOn(
    const Frame& frame, const MarchPlan& plan, const ReceivedLight& received);
  std::vector<std::vector<float>> LightByPackets(
    const Frame& frame, const MarchPlan& plan, const ReceivedLight& received);
  std::vector<std::vector<float>> LightByShader(
    const Frame& frame, const MarchPlan& plan, const ReceivedLight& received);

  void TakeFactors(const Frame& frame, const MarchPlan& plan, const ReceivedLight& light);
  void DrawFactors(const Frame& frame, const MarchPlan& plan);
  void AddTranslucent(const Frame& frame, const MarchPlan& plan);
  void DrawImage(const Frame& frame, const MarchPlan& plan, PacketPicture& drawn);

  SceneResources& resources;
  BoxDrawing& boxes;
  PacketPicture image;            ///< First places, then factors.
  PacketPicture added;            ///< The light of translucent geometry that was dimmed, too.
  TranslucentColors translucent;  ///< The light of translucent geometry.
  FloatFramebuffer light{ 2 };    ///< The light on places, by a shader.
  Box cover = {};                 ///< A box in the grid that covers all pixels with factors.
  std::vector<glm::vec4> factors; ///< The factors in the image, if there is translucent geometry.
  Fingerprint keptFor;            ///< All that the factors depend on; empty if they are not kept.
  std::optional<StepChoice> foundStep;
  int tracings = 0;
};

}

#endif
