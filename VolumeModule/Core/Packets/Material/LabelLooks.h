#ifndef Varimarch_Core_Packets_Material_LabelLooks_h
#define Varimarch_Core_Packets_Material_LabelLooks_h

// Twin of Classify/LabelTables.glsl, Rows/Tables.glsl and Rows/ValueAndGradient.glsl.

#include "Core/Packets/ClassifyTwo/Table.h"
#include "Core/Packets/GradientOpacity/LabelTables.h"
#include "Core/Packets/PacketTables.h"

namespace varimarch
{

namespace
{

/// The optical properties of labels, without light.
class LabelLooks
{
public:
  explicit LabelLooks(const PacketScene& scene)
    : scene(scene)
  {
  }

  /// @param rows  the rows of the labels; 0 for places without one
  Optical Of(IntLanes rows, Lanes value, const Lanes3& gradient) const
  {
    const float labelPart = this->scene.parameters.labelPart;
    Optical optical = this->OfRows(rows, value, gradient);
    const LaneMask isMixed = rows > 0;
    if (labelPart < 1.0f && Any(isMixed))
    {
      const Optical plain = this->OfRows(IntLanes{}, value, gradient);
      const Optical mixed = this->Mixed(plain, optical);
      optical.extinction = Select(isMixed, mixed.extinction, optical.extinction);
      optical.color = Select(isMixed, mixed.color, optical.color);
    }
    return optical;
  }

private:
  Optical OfRows(IntLanes rows, Lanes value, const Lanes3& gradient) const
  {
    Optical optical = this->OfTables(rows, value, gradient);
    const LaneMask isPlain = LaneMask(rows == 0);
    if (this->scene.textures.twoValueTable && Any(isPlain))
    {
      const Optical plain = ClassifyTwo(this->scene, value, gradient);
      optical.extinction = Select(isPlain, plain.extinction, optical.extinction);
      optical.color = Select(isPlain, plain.color, optical.color);
    }
    return optical;
  }

  Optical OfTables(IntLanes rows, Lanes value, const Lanes3& gradient) const
  {
    const IntNumbers row(rows);
    const auto lookOf = [&](int lane) -> const PacketRow&
    { return this->scene.labelRows[row.of[lane]]; };
    const Lanes last = LanesOf([&](int lane) { return float(lookOf(lane).lastIndex); });
    const Lanes place =
      TableIndex(value, LanesOf([&](int lane) { return lookOf(lane).indexScale; }),
        LanesOf([&](int lane) { return lookOf(lane).indexOffset; }), last);
    const Lanes below = EntryBelow(place, last);
    const IntNumbers index(Truncated(below));
    const Numbers part(place - below);
    Four entries[LaneCount];
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      entries[lane] = MixedEntries(lookOf(lane).table + index.of[lane], part.of[lane]);
    }
    Optical optical = OpticalOf(entries);
    if (this->scene.textures.gradientOpacityTable)
    {
      optical.extinction = AtGradientOfRows(this->scene, optical.extinction, gradient, row);
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

  const PacketScene& scene;
};

}

}

#endif
