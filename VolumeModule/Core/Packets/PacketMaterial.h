#ifndef Varimarch_Core_Packets_PacketMaterial_h
#define Varimarch_Core_Packets_PacketMaterial_h

// The optical properties of a place that depend on its gradient, or on a mask: Shaders/Material/
// OneComponent.glsl, ValueAndGradient.glsl and Labelled.glsl.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketLights.h"
#include "Core/Packets/PacketOptics.h"
#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/PacketVoxels.h"

namespace varimarch
{

namespace
{

/// Shaders/GradientOpacity.
/// @param factorOf  (lane, index) -> the factor of an entry of the table
template <class FactorOf>
Lanes WithGradientOpacity(
  const PacketScene& scene, Lanes extinction, const Lanes3& gradient, FactorOf factorOf)
{
  const VolumeParameters& parameters = scene.parameters;
  const int component = scene.constituent.component;
  const Lanes last = All(parameters.lastGradientEntry);
  const Lanes place = GradientIndex(gradient, AllOf3(parameters.spacingFactors),
    All(parameters.entriesPerGradient[component]), last);
  const Lanes below = EntryBelow(place, last);
  const IntNumbers index(Truncated(below));
  const auto factors = [&](int next)
  { return LanesOf([&](int lane) { return factorOf(lane, index.of[lane] + next); }); };
  return WithOpacityFactor(extinction, All(parameters.opacityUnitDistancesMm[component]),
    Mix(factors(0), factors(1), place - below));
}

/// Shaders/GradientOpacity/Table.glsl.
inline Lanes AtGradient(const PacketScene& scene, Lanes extinction, const Lanes3& gradient)
{
  return WithGradientOpacity(scene, extinction, gradient,
    [&](int, int index)
    { return scene.gradientOpacity.factors[index][scene.constituent.component]; });
}

/// Shaders/GradientOpacity/LabelTables.glsl.
inline Lanes AtGradientOfRows(
  const PacketScene& scene, Lanes extinction, const Lanes3& gradient, const IntNumbers& row)
{
  const int entries = int(scene.parameters.lastGradientEntry) + 1;
  return WithGradientOpacity(scene, extinction, gradient,
    [&](int lane, int index)
    {
      const int table = row.of[lane] / 4;
      return scene.gradientOpacity.factors[table * entries + index][row.of[lane] % 4];
    });
}

/// Shaders/Material/ValueAndGradient.glsl, without light.
inline Optical ClassifyTwo(const PacketScene& scene, Lanes value, const Lanes3& gradient)
{
  const PacketTwoValues& look = scene.twoValues;
  const VolumeParameters& parameters = scene.parameters;
  const auto indexOf = [](Lanes place, int size)
  {
    const Lanes last = All(float(size - 1));
    return TableIndex(place, last, Lanes{}, last);
  };
  const Lanes valuePlace = value * parameters.placeFromScalar.x + parameters.placeFromScalar.y;
  const Lanes gradientPlace = GradientIndex(
    gradient, AllOf3(parameters.spacingFactors), All(parameters.placePerGradient), All(1.0f));
  Optical found = Interpolated(
    look.entries, look.size, indexOf(valuePlace, look.size.x), indexOf(gradientPlace, look.size.y));
  found.extinction = ExtinctionOf(found.extinction, All(parameters.opacityUnitDistancesMm.x));
  return found;
}

/// The optical properties along the rays of a packet.
class PacketMaterial
{
public:
  PacketMaterial(const PacketScene& scene, const PacketRays& rays)
    : scene(scene)
    , rays(rays)
    , directionWorld(Transformed(scene.parameters.worldFromGrid, rays.directionGrid))
  {
  }

  /// True if they do not depend on the surface.
  bool IsPlain() const
  {
    return this->scene.light.shading == PacketShading::None &&
      !this->scene.gradientOpacity.factors && !this->scene.twoValues.entries;
  }

  /// @param gradient  per voxel
  Surface SurfaceOf(const Lanes3& gradient) const
  {
    const Lanes3 normal = Transformed(this->scene.parameters.worldFromGradient, gradient);
    return { gradient, normal, Dot(normal, this->directionWorld) };
  }

  /// @param t  the place along the rays [mm]
  Optical At(Lanes value, const Surface& surface, Lanes t) const
  {
    Optical optical = this->scene.twoValues.entries
      ? ClassifyTwo(this->scene, value, surface.gradient)
      : Classify(this->scene.look, value);
    optical.color = this->Shaded(optical.color, surface, t);
    if (this->scene.gradientOpacity.factors)
    {
      optical.extinction = AtGradient(this->scene, optical.extinction, surface.gradient);
    }
    return optical;
  }

  Lanes3 Shaded(const Lanes3& color, const Surface& surface, Lanes t) const
  {
    switch (this->scene.light.shading)
    {
      case PacketShading::HeadLight:
        return LitByHeadLight(this->scene, color, surface);
      case PacketShading::Lights:
        return PacketLights(this->scene, this->directionWorld)
          .Lit(color, surface, this->WorldAt(t));
      case PacketShading::None:
        break;
    }
    return color;
  }

private:
  Lanes3 WorldAt(Lanes t) const
  {
    const glm::vec3& origin = this->scene.parameters.worldOfGridOrigin;
    return Transformed(this->scene.parameters.worldFromGrid, this->rays.At(t)) + AllOf3(origin);
  }

protected:
  const PacketScene& scene;
  const PacketRays& rays;
  Lanes3 directionWorld;
};

/// Shaders/Material/Labelled.glsl: depends on the row of a mask that the rays are in.
class LabelledMaterial : public PacketMaterial
{
public:
  using PacketMaterial::PacketMaterial;

  Optical At(Lanes value, const Surface& surface, Lanes t) const
  {
    const float labelPart = this->scene.parameters.labelPart;
    Optical optical = this->OfRows(this->rays.region, value, surface);
    const LaneMask isMixed = this->rays.region > 0;
    if (labelPart < 1.0f && Any(isMixed))
    {
      const Optical plain = this->OfRows(IntLanes{}, value, surface);
      const Optical mixed = this->Mixed(plain, optical);
      optical.extinction = Select(isMixed, mixed.extinction, optical.extinction);
      optical.color = Select(isMixed, mixed.color, optical.color);
    }
    optical.color = this->Shaded(optical.color, surface, t);
    return optical;
  }

private:
  Optical OfRows(IntLanes rows, Lanes value, const Surface& surface) const
  {
    const IntNumbers row(rows);
    const Numbers values(value);
    Four entries[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      const PacketRow& look = this->scene.mask.rows[row.of[lane]];
      const float last = float(look.lastIndex);
      const float index = values.of[lane] * look.indexScale + look.indexOffset;
      const float place = index > 0.0f ? (index < last ? index : last) : 0.0f;
      const int below = int(place < last - 1.0f ? place : last - 1.0f);
      entries[lane] = MixedEntries(look.table + below, place - float(below));
    }
    Optical optical = OpticalOf(entries);
    if (this->scene.gradientOpacity.factors)
    {
      optical.extinction = AtGradientOfRows(this->scene, optical.extinction, surface.gradient, row);
    }
    return optical;
  }

  // Mixes colours, and opacities over a unit distance.
  Optical Mixed(const Optical& plain, const Optical& own) const
  {
    const Lanes part = All(this->scene.parameters.labelPart);
    return { Mix(plain.color, own.color, part),
      MixedExtinction(plain.extinction, own.extinction, part,
        All(this->scene.parameters.opacityUnitDistancesMm.x)) };
  }
};

/// The most frequent material, with a head light and nothing else: an image takes a twentieth less
/// time than with PacketMaterial.
class HeadLitMaterial : public PacketMaterial
{
public:
  using PacketMaterial::PacketMaterial;

  static constexpr bool IsPlain() { return false; }

  static bool IsThatOf(const PacketScene& scene)
  {
    return scene.light.shading == PacketShading::HeadLight && !scene.gradientOpacity.factors &&
      !scene.twoValues.entries;
  }

  Optical At(Lanes value, const Surface& surface, Lanes) const
  {
    Optical optical = Classify(this->scene.look, value);
    optical.color = LitByHeadLight(this->scene, optical.color, surface);
    return optical;
  }
};

}

}

#endif
