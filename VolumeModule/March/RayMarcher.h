#ifndef Varimarch_March_RayMarcher_h
#define Varimarch_March_RayMarcher_h

#include "Core/Quality/InteractiveQuality.h"
#include "Frame/MarchPlan.h"
#include "March/Device/BoxDrawing.h"
#include "March/Device/ShaderMarcher.h"
#include "March/ImageAccumulator.h"
#include "March/PassMarch.h"
#include "March/Processor/GeometryDimming.h"
#include "March/Processor/PacketMarcher.h"
#include "Resources/SceneResources.h"
#include "Tolerance/AccuracyNotes.h"
#include "Tolerance/ToleranceSearch.h"
#include "Tolerance/TrialImages.h"

#include "vtkWeakPointer.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;

namespace varimarch
{

/// A frame prepared for a search that draws trial images together with other marchers.
struct PreparedTrials
{
  MarchPlan plan;
  SearchFacts facts;
  ToleranceInputs inputs;
};

/// Draws frames: updates the resources of a frame, plans its march, and passes both to the marcher
/// and to the pass that makes the image. Owns everything that takes graphics memory.
class RayMarcher
{
public:
  /// @param quality  the quality of the image while a user interacts; none for a still image
  /// @throws std::runtime_error if the device cannot hold a resource or compile the shader
  void Draw(const Frame& frame, const std::optional<PictureQuality>& quality = {});
  /// Takes the light of a volume's shadows from opaque geometry, before any volume is drawn.
  /// @param quality  the quality of the image while a user interacts; none for a still image
  /// @param light    what the volumes before it leave
  void CastOnGeometry(
    const Frame& frame, const std::optional<PictureQuality>& quality, ReceivedLight& light);
  /// Draws the geometry darker by what all volumes leave, after the last of them has cast its
  /// shadows.
  void DimGeometry(
    const Frame& frame, const std::optional<PictureQuality>& quality, const ReceivedLight& light);
  /// Prepares the trial images of a frame; none if it has no tolerance.
  std::optional<PreparedTrials> PrepareTrials(const Frame& frame);
  /// Draws trial images that differ in their sample distances only.
  /// @param plan  the one that was prepared, or that of the image
  /// @return  premultiplied RGBA of the pixels of each
  std::vector<std::vector<float>> DrawTrials(
    const Frame& frame, const MarchPlan& plan, const std::vector<TrialImage>& images);
  /// Sets the steps of images that are not interactive; none: those of a search.
  void SetCommonSteps(const std::optional<CommonSteps>& steps) { this->commonSteps = steps; }

  /// Sets a function that is told how much of a drawing is done, [0, 1].
  void SetProgress(std::function<void(double)> tell) { this->tellProgress = std::move(tell); }

  /// The pixels of the images of colours and depths that were drawn last; empty if there are none.
  const Viewport& ImagePixels() const { return this->passes.ImagePixels(); }
  std::vector<float> ColorImage() { return this->passes.ColorImage(this->window); }
  std::vector<float> DepthImage() { return this->passes.DepthImage(this->window); }

  void Release(vtkWindow* window);

  VolumeBuilds Builds() const { return this->resources.First().Builds(); }
  int ShaderBuilds() const { return this->boxes.ShaderBuilds(); }
  /// The number of resource builds so far. Tolerance searches are excluded, because every new view
  /// needs one.
  int ResourceBuilds() const { return this->Builds().Sum() + this->ShaderBuilds(); }
  int ToleranceSearches() const { return this->tolerance.Searches(); }
  int BlockUploads() const { return this->resources.First().Blocks().Uploads(); }
  /// The files of the shader that marched last; empty if the processor marched.
  const std::vector<std::string>& ShaderParts() const { return this->boxes.ShaderParts(); }
  /// The number of images in the mean that was drawn last; 0 until the first is complete.
  int AccumulatedImages() const { return this->accumulator.Images(); }
  /// The fraction of all images of an accumulation that is drawn, [0, 1].
  double DrawnPart(int mostImages) const { return this->accumulator.DrawnPart(mostImages); }
  double UsedImageSampleDistance() const { return this->usedImageSampleDistance; }
  double UsedSampleDistanceMm() const { return this->usedSampleDistanceMm; }
  /// The sample distance that the frame requested.
  double WantedSampleDistanceMm() const { return this->wantedSampleDistanceMm; }
  /// The steps that were found for the last image; none if it had no tolerance.
  const std::optional<StepChoice>& FoundStep() const { return this->foundStep; }
  /// True if the steps of the volume and those of its light on geometry keep the error tolerance,
  /// or if there is none. False while a user interacts and the image has fewer rays for that.
  bool KeepsTolerance() const;
  /// The steps that were found for the light of the last image on opaque geometry.
  const std::optional<StepChoice>& FoundStepOfLight() const { return this->dimming.FoundStep(); }
  /// The estimated 99.9th percentile of the errors of these steps, [0, 1]; 0 without a tolerance.
  double EstimatedError() const;
  /// The memory of the lattices of light, of which only pages that are used are taken.
  std::size_t LightBytes() const { return this->resources.LightBytes(); }
  int GeometryShadowBuilds() const { return this->dimming.Tracings(); }
  int LightLatticeBuilds() const { return this->resources.LightLatticeBuilds(); }
  /// The shortcomings of the last image.
  const std::vector<AccuracyNote>& Notes() const { return this->notes; }
  /// True if the image may be wrong by any amount, which no trial image shows.
  bool HasUnknownError() const;
  double FieldBuildSeconds() const { return this->resources.First().FieldBuildSeconds(); }
  std::size_t GraphicsMemoryBytes() const;

private:
  /// The part of the progress of a drawing that is the search for its steps.
  static constexpr double PartOfSearch = 0.5;

  /// Updates the resources of a frame, and plans its march.
  MarchPlan Prepare(const Frame& frame, const std::optional<PictureQuality>& quality);
  void EnterWindow(vtkOpenGLRenderWindow* window);
  /// Chooses the marcher, and updates everything that it reads.
  void UpdateResources(const Frame& frame, MarchPlan& plan);
  void ChooseMarcher(const Frame& frame, MarchPlan& plan, bool shouldMarchByPackets);
  /// Searches the steps of an image, or takes those that were set.
  void TakeSteps(const Frame& frame, MarchPlan& plan);
  void SearchSteps(const Frame& frame, MarchPlan& plan);
  void Search(const Frame& frame, const MarchPlan& plan);
  void TakeCommonSteps(const Frame& frame, MarchPlan& plan);
  ToleranceInputs ToleranceInputsOf(const Frame& frame, const MarchPlan& plan) const;
  /// The question whether a drawing is wanted any more, which tells its progress too.
  /// @param from  and to: the part of the drawing that is about to begin, [0, 1]
  MarchWork::Question QuestionOf(const Frame& frame, double from, double to) const;
  void DrawImage(const Frame& frame, MarchPlan plan);
  FrameMarcher& MarcherOf(const MarchPlan& plan);
  MemoryElsewhere MemoryOfImages() const;

  vtkWeakPointer<vtkOpenGLRenderWindow> window;
  SceneResources resources;
  BoxDrawing boxes{ resources };
  ShaderMarcher shaders{ resources, boxes, [this] { return this->MemoryOfImages(); } };
  PacketMarcher packets{ resources, boxes };
  GeometryDimming dimming{ resources, boxes };
  ToleranceSearch tolerance;
  std::optional<CommonSteps> commonSteps;
  std::optional<StepChoice> foundStep;
  double stepFactor = 1.0; ///< See ErrorBudget.
  bool lacksRays = false;  ///< True if the image has fewer rays because a user interacts.
  ResampledMarch resampled{ resources, boxes };
  ImageAccumulator accumulator{ resources, boxes, resampled };
  PassMarch passes{ resources };
  std::function<void(double)> tellProgress = [](double) {};
  Fingerprint tooLargeBy; ///< Inputs of memory that is too small for the volumes.
  double usedSampleDistanceMm = 0.0;
  double wantedSampleDistanceMm = 0.0;
  double usedImageSampleDistance = 1.0;
  std::vector<AccuracyNote> notes;
};

}

#endif
