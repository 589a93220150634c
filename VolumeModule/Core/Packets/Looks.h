#ifndef Varimarch_Core_Packets_Looks_h
#define Varimarch_Core_Packets_Looks_h

// The optical properties of values: tables, and how lanes read them.
// Twin of Classify/OpticalTable.glsl, Classify/PreIntegrated.glsl, ClassifyTwo/Table.glsl,
// GradientOpacity/Table.glsl, GradientOpacity/LabelTables.glsl, Classify/LabelTables.glsl,
// Rows/Tables.glsl and Rows/ValueAndGradient.glsl.

#include "Core/Packets/Lanes.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"

namespace varimarch
{

namespace
{

/// Colour and extinction [1/mm], or emission and extinction.
struct Optical
{
  Lanes3 color;
  Lanes extinction;
};

inline Optical OpticalOf(const Four (&entries)[LaneCount])
{
  const Lanes4 numbers = Transposed(entries);
  return { { numbers.x, numbers.y, numbers.z }, numbers.w };
}

/// The lanes in which any value from one to another, both included, may absorb.
inline LaneMask MayAbsorb(const PacketLook& look, Lanes start, Lanes end)
{
  return LaneMask(Max(start, end) > look.visibleValues.x) &
    LaneMask(Min(start, end) < look.visibleValues.y);
}

/// Interpolates between an entry and the next.
inline Four MixedEntries(const glm::vec4* entry, float part)
{
  const Four first = FourAt(&entry->x);
  return first + part * (FourAt(&entry[1].x) - first);
}

/// Interpolates between four entries of a table of rows.
/// @param size  number of entries along each axis, at least two
/// @param x, y  indices within the table, which need not be whole
inline Optical Interpolated(const glm::vec4* table, glm::ivec2 size, Lanes x, Lanes y)
{
  const Lanes column = EntryBelow(x, All(float(size.x - 1)));
  const Lanes row = EntryBelow(y, All(float(size.y - 1)));
  const IntNumbers index(Truncated(column) + size.x * Truncated(row));
  const Numbers along(x - column);
  const Numbers across(y - row);
  Four entries[LaneCount];
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    const glm::vec4* const entry = table + index.of[lane];
    const Four lower = MixedEntries(entry, along.of[lane]);
    const Four upper = MixedEntries(entry + size.x, along.of[lane]);
    entries[lane] = lower + across.of[lane] * (upper - lower);
  }
  return OpticalOf(entries);
}

inline Optical Classify(const PacketLook& look, Lanes value)
{
  const Lanes last = All(float(look.lastIndex));
  const Lanes place = TableIndex(value, All(look.indexScale), All(look.indexOffset), last);
  const Lanes below = EntryBelow(place, last);
  const IntNumbers index(Truncated(below));
  const Numbers part(place - below);
  Four entries[LaneCount];
  for (int lane = 0; lane < LaneCount; ++lane)
  {
    entries[lane] = MixedEntries(look.table + index.of[lane], part.of[lane]);
  }
  return OpticalOf(entries);
}

/// The extinction alone [1/mm].
inline Lanes ExtinctionOf(const PacketLook& look, Lanes value)
{
  const Lanes last = All(float(look.lastIndex));
  const Lanes place = TableIndex(value, All(look.indexScale), All(look.indexOffset), last);
  const Lanes below = EntryBelow(place, last);
  const IntNumbers index(Truncated(below));
  const Lanes first = LanesOf([&](int lane) { return look.table[index.of[lane]].w; });
  const Lanes next = LanesOf([&](int lane) { return look.table[index.of[lane] + 1].w; });
  return Mix(first, next, place - below);
}

/// The part of ExtinctionSums between places in the table.
inline Lanes SumBetween(const PacketLook& look, Lanes first, Lanes second)
{
  const Lanes last = All(float(look.lastIndex));
  const Lanes below[2] = { EntryBelow(first, last), EntryBelow(second, last) };
  const IntNumbers index[2] = { IntNumbers(Truncated(below[0])), IntNumbers(Truncated(below[1])) };
  const Numbers part[2] = { Numbers(first - below[0]), Numbers(second - below[1]) };
  const auto sumAt = [&](int end, int lane)
  {
    const double* const sums = look.sums + index[end].of[lane];
    return sums[0] + double(part[end].of[lane]) * (sums[1] - sums[0]);
  };
  return LanesOf([&](int lane) { return float(sumAt(1, lane) - sumAt(0, lane)); });
}

/// The mean extinction of values that change linearly from one to another [1/mm].
/// @param most  larger extinctions count as this one
inline Lanes MeanExtinctionOf(const PacketLook& look, Lanes start, Lanes end, Lanes most)
{
  constexpr float FarOutside = 1e9f; // entries
  const Lanes last = All(float(look.lastIndex));
  const auto placeOf = [&](Lanes value)
  {
    return Clamp(
      value * look.indexScale + look.indexOffset, All(-FarOutside), last + All(FarOutside));
  };
  const Lanes from = placeOf(start);
  const Lanes to = placeOf(end);
  const LaneMask isOneEntry = LaneMask(Abs(to - from) < 1.0f);
  const Lanes ofMiddle = Min(ExtinctionOf(look, 0.5f * (start + end)), most);
  if (!Any(~isOneEntry))
  {
    return ofMiddle;
  }
  const Lanes inside = SumBetween(look, Clamp(from, Lanes{}, last), Clamp(to, Lanes{}, last));
  const Lanes below = Min(to, Lanes{}) - Min(from, Lanes{});
  const Lanes above = Max(to, last) - Max(from, last);
  const Lanes sum = inside + below * Min(All(look.table[0].w), most) +
    above * Min(All(look.table[look.lastIndex].w), most);
  return Select(isOneEntry, ofMiddle, sum / Select(isOneEntry, All(1.0f), to - from));
}

inline Optical ClassifyBetween(const PacketLook& look, Lanes startValue, Lanes endValue)
{
  const Lanes last = All(float(look.lastIndex));
  const Lanes start = startValue * look.indexScale + look.indexOffset;
  const Lanes end = endValue * look.indexScale + look.indexOffset;
  Optical emission = Interpolated(look.table, glm::ivec2(look.lastIndex + 1),
    Clamp(start, Lanes{}, last), Clamp(end, Lanes{}, last));
  if (Any(LaneMask(Min(start, end) < 0.0f) | LaneMask(Max(start, end) > last)))
  {
    const Lanes4 mean =
      WithEnds({ emission.color.x, emission.color.y, emission.color.z, emission.extinction }, start,
        end, last, AllOf4(look.emissionBelow), AllOf4(look.emissionAbove));
    emission = { { mean.x, mean.y, mean.z }, mean.w };
  }
  return { (1.0f / Max(emission.extinction, All(1e-30f))) * emission.color, emission.extinction };
}

/// Its arguments are copies, so that those of a march stay in registers.
[[gnu::noinline]] FLATTENED inline Optical ClassifyTwo(
  const PacketScene& scene, Lanes value, Lanes3 gradient)
{
  const VolumeParameters& parameters = scene.parameters;
  const glm::ivec2 size(parameters.twoValueTableSize);
  const auto indexOf = [](Lanes place, int size)
  {
    const Lanes last = All(float(size - 1));
    return TableIndex(place, last, Lanes{}, last);
  };
  const Lanes valuePlace = value * parameters.placeFromScalar.x + parameters.placeFromScalar.y;
  const Lanes gradientPlace = GradientIndex(
    gradient, AllOf3(parameters.spacingFactors), All(parameters.placePerGradient), All(1.0f));
  Optical found = Interpolated(scene.textures.twoValueTable.Texels<glm::vec4>(), size,
    indexOf(valuePlace, size.x), indexOf(gradientPlace, size.y));
  found.extinction = ExtinctionOf(found.extinction, All(parameters.opacityUnitDistancesMm.x));
  return found;
}

/// Multiplies the opacity over a unit distance by a function of the gradient.
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

inline Lanes AtGradient(const PacketScene& scene, Lanes extinction, const Lanes3& gradient)
{
  return WithGradientOpacity(scene, extinction, gradient,
    [&](int, int index)
    { return scene.textures.gradientOpacityTable[index][scene.constituent.component]; });
}

inline Lanes AtGradientOfRows(
  const PacketScene& scene, Lanes extinction, const Lanes3& gradient, const IntNumbers& row)
{
  const int entries = int(scene.parameters.lastGradientEntry) + 1;
  return WithGradientOpacity(scene, extinction, gradient,
    [&](int lane, int index)
    {
      const int table = row.of[lane] / 4;
      return scene.textures.gradientOpacityTable[table * entries + index][row.of[lane] % 4];
    });
}

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
