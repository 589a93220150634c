#ifndef Varimarch_Testing_OccludedScenes_h
#define Varimarch_Testing_OccludedScenes_h

#include "Core/Reference/LightTransmittance.h"
#include "Module/Scenes/LabelledTorso.h"
#include "Module/Scenes/ReferenceMaterials.h"
#include "Module/Scenes/SlabScene.h"
#include "Module/Scenes/UsualSettings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

/// A slab with ambient occlusion, and its closed form. It may have layers: heights are above its
/// lower face, which has height 0 [mm], and its upper face is towards the eye.
class OccludedSlab
{
public:
  static constexpr double HeightMm = 8.0;
  static constexpr double VoxelMm = 1.0; ///< along the height

  OccludedSlab(double opacityPerMm, double strength, double reachMm)
    : strength(strength)
    , reachMm(reachMm)
    , scene(opacityPerMm, ColorRed)
  {
    const double extinction = -std::log1p(-opacityPerMm);
    this->extinctionAt = [extinction](double) { return extinction; };
    this->depthBelow = [extinction](double heightMm) { return extinction * heightMm; };
    this->seenFrom = [](double heightMm) { return heightMm + 2.0 * VoxelMm; };
    this->scene.mapper->SetAmbientOcclusion(strength);
    this->scene.mapper->SetAmbientOcclusionReach(reachMm);
  }

  double RedOf(const std::vector<float>& drawn) const { return drawn[4 * (drawn.size() / 8)]; }
  double DrawnRed() { return this->RedOf(this->scene.DrawByProcessor()); }

  /// The same by shaders, with a sample every so many mm.
  double RedByShaders(double sampleDistanceMm)
  {
    this->scene.mapper->AutoAdjustSampleDistancesOff();
    this->scene.mapper->SetSampleDistance(sampleDistanceMm);
    return this->RedOf(this->scene.Draw());
  }

  /// Each height emits what it keeps of the light that arrives at the place it is seen from.
  double ExpectedRed() const
  {
    constexpr int Parts = 20000;
    constexpr double PartMm = HeightMm / Parts;
    double red = 0.0;
    for (int i = 0; i < Parts; ++i)
    {
      const double heightMm = (i + 0.5) * PartMm;
      red += ColorRed * this->extinctionAt(heightMm) * PartMm *
        std::exp(this->depthBelow(heightMm) - this->depthBelow(HeightMm)) *
        varimarch::KeptLight(this->VisibilityAt(this->seenFrom(heightMm)), this->strength);
    }
    return red;
  }

  double strength;
  double reachMm;
  double widthMm = 20.0; ///< width of its matter to the right of the eye's ray
  std::function<double(double heightMm)> extinctionAt;
  std::function<double(double heightMm)> depthBelow; ///< optical depth from height 0 on
  std::function<double(double heightMm)> seenFrom;   ///< height of the place outside its surface
  SlabScene scene;

private:
  static constexpr double ColorRed = 0.8;

  double VisibilityAt(double heightMm) const
  {
    double sum = 0.0;
    for (const auto& [direction, weight] : varimarch::SphereQuadrature())
    {
      const double toEdgeMm = direction.x > 0.0 ? this->widthMm / direction.x : this->reachMm;
      const double farMm = std::min(this->reachMm, toEdgeMm);
      const auto inside = [](double height) { return std::clamp(height, 0.0, HeightMm); };
      const double depth = this->depthBelow(inside(heightMm + direction.z * farMm)) -
        this->depthBelow(inside(heightMm));
      sum += weight * std::exp(-std::abs(depth / direction.z));
    }
    return sum;
  }
};

/// Gives the voxels of a slab from one height to another a label of another opacity.
/// @param first, last  voxels along the height
inline void LabelFrom(int first, int last, double opacityPerMm, OccludedSlab& slab)
{
  const double others = slab.extinctionAt(0.0);
  const double more = -std::log1p(-opacityPerMm) - others;
  const double lowerMm = first - 0.5;
  const double upperMm = last + 0.5;
  slab.extinctionAt = [=](double heightMm)
  { return others + (heightMm >= lowerMm && heightMm < upperMm ? more : 0.0); };
  slab.depthBelow = [=](double heightMm)
  {
    const double inLabelMm = std::min(heightMm, upperMm) - std::max(lowerMm, 0.0);
    return others * heightMm + more * std::max(inLabelMm, 0.0);
  };
  vtkVolumeProperty* const property = slab.scene.volume->GetProperty();
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, opacityPerMm);
  property->SetLabelScalarOpacity(1, opacities);
  property->SetLabelColor(1, slab.scene.colors);
  slab.scene.mapper->SetMaskInput(MaskOf(
    { 9, 9, 9 }, [=](glm::ivec3 place) { return place.z >= first && place.z <= last ? 1 : 0; },
    VTK_UNSIGNED_CHAR));
}

/// A slab whose lower half has a label that is lit as its own surface, and whose upper half is
/// empty. Within 1.5 voxels of its upper face the label sees what is above it, and farther down
/// what is around each place.
struct LabelOnNothing : OccludedSlab
{
  LabelOnNothing()
    : OccludedSlab(0.0, 0.8, 6.0)
  {
    LabelFrom(0, Last, 0.3, *this);
    this->scene.mapper->LabelSurfacesOn();
    this->scene.mapper->AutoAdjustSampleDistancesOff();
    this->scene.mapper->SetSampleDistance(float(SegmentMm));
  }

  /// Expects a colour within rounding. The segment in which the surface begins has either light.
  void ExpectRed(double drawn)
  {
    EXPECT_GT(drawn, this->RedIfSurfaceBegins(Last - 1.0 + 0.5 * SegmentMm) - HalfByteStep);
    EXPECT_LT(drawn, this->RedIfSurfaceBegins(Last - 1.0 - 0.5 * SegmentMm) + HalfByteStep);
  }

  static constexpr double SegmentMm = 0.25;

private:
  static constexpr int Last = 4; ///< the uppermost voxel of the label

  double RedIfSurfaceBegins(double surfaceMm)
  {
    this->seenFrom = [surfaceMm](double heightMm)
    { return heightMm > surfaceMm ? heightMm + 2.0 * VoxelMm : heightMm; };
    return this->ExpectedRed();
  }
};

/// A turned torso with ambient occlusion under a sun and a lamp.
class OccludedTorso
{
public:
  explicit OccludedTorso(int size)
    : scene(SmallTorso(), size)
  {
    this->scene.volume->GetProperty()->ShadeOn();
    this->scene.mapper->SetAmbientOcclusion(0.5);
    this->scene.mapper->SetErrorTolerance(1.0 / 64.0);
    UseSunAndLamp(this->scene.renderer);
  }

  std::vector<float> Truth(double tolerance)
  {
    return this->scene.TruthOf(OccludedMaterial(this->scene, tolerance), tolerance);
  }

  MapperScene scene;
};

#endif
