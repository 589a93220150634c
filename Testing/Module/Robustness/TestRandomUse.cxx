// Random changes of a scene, one after the other. After each the mapper must draw what a mapper
// made anew draws of the same scene: nothing of an earlier scene may be left in it.
//
// VARIMARCH_RANDOM_ACTIONS is the number of changes, VARIMARCH_RANDOM_SEED the first seed.

#include "Module/Scenes/Dice.h"
#include "Module/Scenes/MapperScene.h"
#include "Scene/Volumes/ProceduralVolume.h"

#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkTransform.h>

#include <gtest/gtest.h>

#include <sstream>

using namespace varimarch;

namespace
{

/// A point of a transfer function: the part of the data's range that is its place, and its value.
struct Node
{
  double place;
  double value;

  bool operator==(const Node& other) const
  {
    return this->place == other.place && this->value == other.value;
  }
};

/// All that the actions change.
struct State
{
  int input = 0;
  std::vector<int> edits; ///< for each edit of voxels the input that it changed
  std::vector<Node> opacities = { { 0.1, 0.0 }, { 0.9, 0.4 } };
  std::vector<Node> reds = { { 0.0, 0.1 }, { 1.0, 1.0 } };
  double unitDistanceMm = 2.0;
  bool shaded = false;
  bool nearest = false;
  bool gradientOpacity = false;
  int blend = vtkVolumeMapper::COMPOSITE_BLEND;
  double tolerance = 0.0;
  bool byProcessor = false;
  int acceleration = vtkVariationFieldVolumeMapper::OpticalField;
  bool cubic = false;
  bool cropped = false;
  int croppedRegions = VTK_CROP_SUBVOLUME;
  bool clipped = false;
  double clippedTurn = 0.0; ///< direction of the clipping plane [degrees]
  bool masked = false;
  bool hasBall = false;
  double turn = 0.0;      ///< azimuth of the camera [degrees]
  double elevation = 0.0; ///< elevation of the camera [degrees]
  double zoom = 1.0;
  bool isParallel = false;
  double volumeTurn = 0.0; ///< turn of the volume about its x axis [degrees]
  int size = 48;
};

constexpr int InputCount = 4;

/// The volumes between which the input changes. Each scene has its own, because edits change them.
std::vector<vtkSmartPointer<vtkImageData>> Inputs()
{
  return { ProceduralVolume({ ProceduralKind::Torso, { 40, 36, 24 }, 7 }),
    ProceduralVolume({ ProceduralKind::Shells, { 33, 33, 33 }, 1 }),
    ProceduralVolume({ ProceduralKind::MarschnerLobb, { 25, 25, 25 }, 1 }),
    ProceduralVolume({ ProceduralKind::Torso, { 20, 52, 31 }, 3 }) };
}

/// A scene that follows a state. Only what differs from the state before is set, as a user does.
class Followed
{
public:
  explicit Followed(vtkHeadlessRenderWindow* window)
    : scene(this->inputs[0], 48, window)
  {
    this->scene.mapper->AutoAdjustSampleDistancesOff();
    this->scene.mapper->SetMaximumAccumulatedPictures(1);
    this->plane->SetOrigin(2.0, -1.0, 3.0);
    this->gradients->AddPoint(0.0, 0.2);
    this->gradients->AddPoint(0.01, 1.0);
    const double aside[3] = { 20.0, -30.0, 10.0 };
    this->ball = Ball(aside, 25.0);
    for (vtkImageData* const image : this->inputs)
    {
      this->ranges.push_back({ image->GetScalarRange()[0], image->GetScalarRange()[1] });
    }
    this->SetInput();
    this->Follow(this->current);
  }

  void Follow(const State& state)
  {
    const State was = this->current;
    this->current = state;
    if (state.edits != was.edits)
    {
      this->Edit();
    }
    if (state.input != was.input)
    {
      this->SetInput();
    }
    if (!(state.opacities == was.opacities && state.reds == was.reds))
    {
      this->SetFunctions();
    }
    this->SetProperty();
    this->SetMapper();
    this->SetView();
  }

  std::vector<float> Draw() { return this->scene.Draw(); }

  void ReleaseGraphics() { this->scene.mapper->ReleaseGraphicsResources(this->scene.window); }

private:
  vtkImageData* Input() { return this->inputs[this->current.input]; }

  double ValueAt(double part)
  {
    const std::array<double, 2> range = this->ranges[this->current.input];
    return range[0] + part * (range[1] - range[0]);
  }

  void SetInput()
  {
    this->scene.mapper->SetInputData(this->Input());
    this->SetFunctions();
    this->mask = nullptr;
  }

  /// Repeats the edits that this scene has not seen. Each sets a box of voxels to 0.
  void Edit()
  {
    for (; this->editCount < this->current.edits.size(); ++this->editCount)
    {
      vtkImageData* const image = this->inputs[this->current.edits[this->editCount]];
      int dimensions[3];
      image->GetDimensions(dimensions);
      for (int step = 0; step < 5 * 5 * 5; ++step)
      {
        const int edge[3] = { step % 5, step / 5 % 5, step / 25 };
        int voxel[3];
        for (int axis = 0; axis < 3; ++axis)
        {
          voxel[axis] = (int(this->editCount) * (axis + 3) + edge[axis]) % dimensions[axis];
        }
        image->SetScalarComponentFromDouble(voxel[0], voxel[1], voxel[2], 0, 0.0);
      }
      image->GetPointData()->GetScalars()->Modified();
      image->Modified();
    }
  }

  void SetFunctions()
  {
    this->scene.opacities->RemoveAllPoints();
    for (const Node& node : this->current.opacities)
    {
      this->scene.opacities->AddPoint(this->ValueAt(node.place), node.value);
    }
    this->scene.colors->RemoveAllPoints();
    for (const Node& node : this->current.reds)
    {
      this->scene.colors->AddRGBPoint(this->ValueAt(node.place), node.value, 0.5, 1.0 - node.value);
    }
  }

  void SetProperty()
  {
    const State& state = this->current;
    vtkVolumeProperty* const property = this->scene.volume->GetProperty();
    property->SetScalarOpacityUnitDistance(state.unitDistanceMm);
    property->SetShade(state.shaded);
    property->SetInterpolationType(
      state.nearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
    property->SetDisableGradientOpacity(!state.gradientOpacity);
    property->SetGradientOpacity(this->gradients);
  }

  void SetMapper()
  {
    const State& state = this->current;
    vtkVariationFieldVolumeMapper* const mapper = this->scene.mapper;
    mapper->SetBlendMode(state.blend);
    mapper->SetErrorTolerance(state.tolerance);
    mapper->SetProcessorMarching(state.byProcessor);
    mapper->SetAccelerationMode(state.acceleration);
    mapper->SetCubicInterpolation(state.cubic);
    mapper->SetCropping(state.cropped);
    mapper->SetCroppingRegionFlags(state.croppedRegions);
    const double* const bounds = this->Input()->GetBounds();
    double planes[6];
    for (int side = 0; side < 6; ++side)
    {
      const double part = side % 2 == 0 ? 0.3 : 0.7;
      planes[side] =
        bounds[side / 2 * 2] + part * (bounds[side / 2 * 2 + 1] - bounds[side / 2 * 2]);
    }
    mapper->SetCroppingRegionPlanes(planes);
    vtkNew<vtkTransform> turn;
    turn->RotateZ(state.clippedTurn);
    double normal[3] = { 1.0, 0.0, 0.3 };
    turn->TransformVector(normal, normal);
    this->plane->SetNormal(normal);
    mapper->RemoveAllClippingPlanes();
    if (state.clipped)
    {
      mapper->AddClippingPlane(this->plane);
    }
    this->SetMask();
  }

  void SetMask()
  {
    if (!this->current.masked)
    {
      this->scene.mapper->SetMaskInput(nullptr);
      return;
    }
    if (!this->mask)
    {
      this->mask = vtkSmartPointer<vtkImageData>::New();
      this->mask->CopyStructure(this->Input());
      this->mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
      auto* const values = static_cast<unsigned char*>(this->mask->GetScalarPointer());
      for (vtkIdType voxel = 0; voxel < this->mask->GetNumberOfPoints(); ++voxel)
      {
        values[voxel] = voxel / 7 % 5 == 0 ? 0 : 255;
      }
    }
    this->scene.mapper->SetMaskInput(this->mask);
  }

  void SetView()
  {
    const State& state = this->current;
    this->scene.size = state.size;
    this->scene.window->SetSize(state.size, state.size);
    this->scene.volume->SetOrientation(state.volumeTurn, 0.0, 0.0);
    vtkCamera* const camera = this->scene.renderer->GetActiveCamera();
    camera->SetParallelProjection(state.isParallel);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetPosition(0.6, -1.0, 0.4);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(30.0);
    camera->Azimuth(state.turn);
    camera->Elevation(state.elevation);
    camera->OrthogonalizeViewUp();
    this->scene.renderer->RemoveActor(this->ball);
    this->scene.renderer->ResetCamera();
    camera->Zoom(state.zoom);
    if (state.hasBall)
    {
      this->scene.renderer->AddActor(this->ball);
    }
  }

  std::vector<vtkSmartPointer<vtkImageData>> inputs = Inputs();
  std::vector<std::array<double, 2>> ranges; ///< ranges of the inputs before all edits
  MapperScene scene;
  State current;
  vtkNew<vtkPlane> plane;
  vtkNew<vtkPiecewiseFunction> gradients;
  vtkSmartPointer<vtkActor> ball;
  vtkSmartPointer<vtkImageData> mask;
  std::size_t editCount = 0; ///< number of the state's edits that were made here
};

std::vector<Node> RandomNodes(Dice& dice, double highest)
{
  std::vector<Node> nodes;
  for (int node = dice.Whole(0, 3); node >= 0; --node)
  {
    nodes.push_back({ dice.Between(-0.1, 1.1), dice.Between(0.0, highest) });
  }
  return nodes;
}

struct Action
{
  const char* name;
  void (*act)(State&, Dice&);
};

const Action actions[] = {
  { "input", [](State& s, Dice& dice) { s.input = dice.Whole(0, InputCount - 1); } },
  { "edit", [](State& s, Dice&) { s.edits.push_back(s.input); } },
  { "opacities", [](State& s, Dice& dice) { s.opacities = RandomNodes(dice, 0.6); } },
  { "colours", [](State& s, Dice& dice) { s.reds = RandomNodes(dice, 1.0); } },
  { "unit distance", [](State& s, Dice& dice) { s.unitDistanceMm = dice.Between(0.5, 20.0); } },
  { "shading", [](State& s, Dice&) { s.shaded = !s.shaded; } },
  { "nearest", [](State& s, Dice&) { s.nearest = !s.nearest; } },
  { "gradient opacity", [](State& s, Dice&) { s.gradientOpacity = !s.gradientOpacity; } },
  { "blend",
    [](State& s, Dice& dice)
    {
      s.blend = dice.OneOf<int>({ vtkVolumeMapper::COMPOSITE_BLEND,
        vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::MINIMUM_INTENSITY_BLEND,
        vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND });
    } },
  { "tolerance",
    [](State& s, Dice& dice) {
      s.tolerance = dice.OneOf<double>({ 0.0, 1.0 / 16.0, 1.0 / 64.0, 1.0 / 255.0 });
    } },
  { "processor", [](State& s, Dice&) { s.byProcessor = !s.byProcessor; } },
  { "acceleration", [](State& s, Dice& dice) { s.acceleration = dice.Whole(0, 2); } },
  { "cubic", [](State& s, Dice&) { s.cubic = !s.cubic; } },
  { "cropping", [](State& s, Dice&) { s.cropped = !s.cropped; } },
  { "cropped regions",
    [](State& s, Dice& dice) { s.croppedRegions = dice.Whole(0, (1 << 27) - 1); } },
  { "clipping", [](State& s, Dice&) { s.clipped = !s.clipped; } },
  { "clipping plane", [](State& s, Dice& dice) { s.clippedTurn = dice.Between(0.0, 360.0); } },
  { "mask", [](State& s, Dice&) { s.masked = !s.masked; } },
  { "ball", [](State& s, Dice&) { s.hasBall = !s.hasBall; } },
  { "turn", [](State& s, Dice& dice) { s.turn = dice.Between(0.0, 360.0); } },
  { "elevation", [](State& s, Dice& dice) { s.elevation = dice.Between(-80.0, 80.0); } },
  { "zoom", [](State& s, Dice& dice) { s.zoom = dice.Between(0.5, 8.0); } },
  { "projection", [](State& s, Dice&) { s.isParallel = !s.isParallel; } },
  { "volume's turn", [](State& s, Dice& dice) { s.volumeTurn = dice.Between(0.0, 360.0); } },
  { "size", [](State& s, Dice& dice) { s.size = 32 + dice.Whole(0, 31); } },
};

/// Largest difference that the tolerance allows two images of one scene: each may be wrong by twice
/// the tolerance in its worst pixel.
double AllowedDifference(double tolerance)
{
  return 4.0 * tolerance + 1e-5;
}

TEST(RandomUse, LeavesNothingOfEarlierScenesInTheMapper)
{
  const long count = NumberFromEnvironment("VARIMARCH_RANDOM_ACTIONS", 120);
  const long seed = NumberFromEnvironment("VARIMARCH_RANDOM_SEED", 1);
  Dice dice(seed, 0);
  State state;
  vtkNew<vtkHeadlessRenderWindow> usedWindow;
  vtkNew<vtkHeadlessRenderWindow> newWindow;
  Followed used(usedWindow);
  std::ostringstream history;
  for (long number = 0; number < count; ++number)
  {
    const Action& action = actions[dice.Whole(0, int(std::size(actions)) - 1)];
    action.act(state, dice);
    history << ' ' << action.name << ',';
    used.Follow(state);
    if (dice.Chance(0.05))
    {
      used.ReleaseGraphics();
      history << " release,";
    }
    const std::vector<float> drawn = used.Draw();

    Followed anew(newWindow);
    anew.Follow(state);
    const std::vector<float> expected = anew.Draw();
    ASSERT_EQ(drawn.size(), expected.size());
    const ImageError error = CompareImages(drawn.data(), expected.data(), expected.size() / 4);
    ASSERT_LE(error.largest, 255.0 * AllowedDifference(state.tolerance))
      << "Seed " << seed << ", action " << number << ", after:" << history.str();
  }
}

}
