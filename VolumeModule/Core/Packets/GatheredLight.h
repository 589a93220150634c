#ifndef Varimarch_Core_Packets_GatheredLight_h
#define Varimarch_Core_Packets_GatheredLight_h

// The light that samples reflect, kept until it is known how much of it reaches them. Light counts
// only in proportion to what an eye sees of it, which is known at the end of a stretch of the ray.

#include "Core/Packets/AnyVoxels.h"
#include "Core/Packets/Materials.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/Rays.h"
#include "Core/Packets/ShaderMath.h"

#include <algorithm>

namespace varimarch
{

namespace
{

inline float LargestOf(const float (&color)[3])
{
  const auto size = [](float number) { return number < 0.0f ? -number : number; };
  const float first = size(color[0]) > size(color[1]) ? size(color[0]) : size(color[1]);
  return first > size(color[2]) ? first : size(color[2]);
}

/// Places along the rays of a packet, front to back, and the part of a light that reaches them.
struct LitPlaces
{
  static constexpr int MostPerRay = 24;

  int count[LaneCount]; ///< number of places of each ray
  float t[MostPerRay][LaneCount];
  float weight[MostPerRay][LaneCount]; ///< influence on the colour
  float light[MostPerRay][LaneCount];  ///< part that reaches the place
  bool isNeeded[MostPerRay][LaneCount];

  /// Light is not needed at places that together have next to no influence.
  /// @param least  error that may come from light that is not asked for
  void ChooseNeeded(int lane, float least)
  {
    float unlit = 0.0f;
    for (int place = 0; place < this->count[lane]; ++place)
    {
      unlit += this->weight[place][lane];
      this->isNeeded[place][lane] = unlit > least;
      unlit = unlit > least ? 0.0f : unlit;
      this->light[place][lane] = 0.5f; // the error is then at most half of the influence
    }
  }

  /// Between the places at which the light is known, it is linear. Places in opaque matter may be
  /// closer than floats tell apart, and one may lie beyond the next, where an interval ends early.
  void SetOthers(int lane)
  {
    int known = -1;
    for (int place = 0; place < this->count[lane]; ++place)
    {
      if (!this->isNeeded[place][lane])
      {
        continue;
      }
      const float found = this->light[place][lane];
      for (int other = known + 1; other < place; ++other)
      {
        const float before = known < 0 ? found : this->light[known][lane];
        const float from = this->t[known < 0 ? other : known][lane];
        const float span = this->t[place][lane] - from;
        const float along = span > 0.0f ? (this->t[other][lane] - from) / span : 1.0f;
        const float inside = along < 0.0f ? 0.0f : along > 1.0f ? 1.0f : along;
        this->light[other][lane] = before + inside * (found - before);
      }
      known = place;
    }
    for (int other = known + 1; other < this->count[lane] && known >= 0; ++other)
    {
      this->light[other][lane] = this->light[known][lane];
    }
  }
};

// Pieces of rays in homogeneous matter that absorb the same: light changes along dense matter, and
// counts where it is seen.

/// Divides parts of rays, each in homogeneous matter, into pieces that absorb the same.
class AbsorbingPieces
{
public:
  /// @param transmittance  in front of the parts
  /// @param times          how many times as many pieces as light asks for
  AbsorbingPieces(Lanes extinction, Lanes transmittance, const RayPart& part, Lanes times)
    : extinction(extinction)
    , enter(part.t - 0.5f * part.lengthMm)
    , lengthMm(part.lengthMm)
    , absorption(Absorption(Min(extinction * part.lengthMm, All(100.0f))))
  {
    const Numbers wanted(float(PiecesOfWhole) * transmittance * this->absorption * times);
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      const float most = std::min(wanted.of[lane], float(LitPlaces::MostPerRay));
      this->count = std::max(this->count, int(__builtin_ceilf(most)));
    }
  }

  int Count() const { return this->count; }

  /// A piece, in whose middle as much light is absorbed in front as behind.
  RayPart At(int piece) const
  {
    const float part = 1.0f / float(this->count);
    const Lanes begin = this->Along(float(piece) * part);
    const Lanes end =
      piece + 1 == this->count ? this->lengthMm : this->Along(float(piece + 1) * part);
    return { this->enter + this->Along((float(piece) + 0.5f) * part), Max(end - begin, Lanes{}) };
  }

private:
  static constexpr int PiecesOfWhole = 4;

  // The length in front of which a part of all that is absorbed is absorbed.
  Lanes Along(float part) const
  {
    constexpr float Thin = 0.01f; // light is absorbed evenly
    const LaneMask isThin = LaneMask(this->absorption < Thin);
    const Lanes depth = -Log(1.0f - part * this->absorption);
    return Select(isThin, part * this->lengthMm,
      Min(depth / Select(isThin, All(1.0f), this->extinction), this->lengthMm));
  }

  Lanes extinction;
  Lanes enter;
  Lanes lengthMm;
  Lanes absorption;
  int count = 1;
};

/// Calls a function with a part of rays, or with its pieces where it is so dense that its middle
/// says nothing about its light.
/// @param transmittance  in front of the part
/// @param add            (part or piece)
template <class Add>
void AddInPieces(Lanes extinction, const Lanes& transmittance, const RayPart& part, Add add)
{
  constexpr float DepthOfDense = 0.5f;
  const LaneMask isDense = LaneMask(extinction * part.lengthMm > DepthOfDense);
  const bool isInPieces = Any(isDense);
  const AbsorbingPieces pieces(
    extinction, transmittance, part, Select(isDense, All(1.0f), Lanes{}));
  const int count = isInPieces ? pieces.Count() : 1;
  for (int piece = 0; piece < count; ++piece)
  {
    add(isInPieces ? pieces.At(piece) : part);
  }
}

/// The light that the samples of a packet's rays would reflect without shadows, in intervals of one
/// length, and shorter ones in dense matter. In each, the optical depth to a light is taken as
/// linear: of a quadratic through the light at both ends and in the middle, where it is the
/// geometric mean, each sample has three coefficients, which are added up.
class GatheredLight
{
public:
  /// @param lightCount  at most MostShadowedLights
  GatheredLight(int lightCount, float intervalMm)
    : lightCount(lightCount)
    , intervalMm(intervalMm)
    , lengthMm(All(intervalMm))
  {
    this->Clear();
  }

  /// See AddInPieces.
  template <class Add>
  static void InPieces(Lanes extinction, const Lanes& transmittance, const RayPart& part, Add add)
  {
    AddInPieces(extinction, transmittance, part, add);
  }

  /// True if samples at t do not fit before a Flush().
  bool IsFullAt(Lanes t, LaneMask mask, Lanes extinction) const
  {
    const LaneMask moves = this->MovesTo(t, mask, extinction);
    return Any(moves & (IntLanesAt(this->count) >= MostIntervals - 1));
  }

  /// Goes to samples. Along each ray t ascends.
  /// @param extinction  of the matter there
  void MoveTo(Lanes t, LaneMask mask, Lanes extinction)
  {
    const LaneMask moves = this->MovesTo(t, mask, extinction);
    if (Any(moves))
    {
      const Lanes to = this->from + this->lengthMm;
      const Lanes nextMm = this->LongestMm(extinction);
      const LaneMask goesOn = moves & this->isOpen & LaneMask(t >= to) & LaneMask(t <= to + nextMm);
      this->Close(moves & this->isOpen);
      this->from = Select(moves, Select(goesOn, to, t), this->from);
      this->lengthMm = Select(moves, nextMm, this->lengthMm);
      this->isOpen |= moves;
    }
    // Rays that see nothing may be far behind an interval of opaque matter, which has no length.
    const Lanes along =
      Select(mask, Clamp((t - this->from) / this->lengthMm, Lanes{}, All(1.0f)), Lanes{});
    this->atStart = (1.0f - along) * (1.0f - 2.0f * along);
    this->inMiddle = 4.0f * along * (1.0f - along);
    this->atEnd = along * (2.0f * along - 1.0f);
  }

  /// Half of the length that a sample of a length stands for [mm].
  static Lanes HalfLengthMm(Lanes lengthMm) { return 0.5f * lengthMm; }

  /// @param color  0 where nothing is seen
  void Add(int light, const Lanes3& color)
  {
    Part& part = this->open[light];
    part.atStart = part.atStart + this->atStart * color;
    part.inMiddle = part.inMiddle + this->inMiddle * color;
    part.atEnd = part.atEnd + this->atEnd * color;
  }

  /// The colours of everything that is gathered, which is then forgotten.
  /// @param least  error that may come from light that is not asked for
  /// @param trace  (light, LitPlaces), which sets the light of the places that need it
  template <class Trace>
  Lanes3 Flush(float least, Trace trace)
  {
    this->Close(this->isOpen);
    Lanes3 sum(0.0f);
    for (int light = 0; light < this->lightCount; ++light)
    {
      LitPlaces places;
      for (int lane = 0; lane < LaneCount; ++lane)
      {
        this->SetPlaces(light, lane, places);
        places.ChooseNeeded(lane, least);
      }
      trace(light, places);
      float color[3][LaneCount] = {};
      for (int lane = 0; lane < LaneCount; ++lane)
      {
        places.SetOthers(lane);
        this->AddColor(light, lane, places, color);
      }
      sum = sum + Lanes3(LanesAt(color[0]), LanesAt(color[1]), LanesAt(color[2]));
    }
    this->Clear();
    return sum;
  }

private:
  static constexpr int MostIntervals = LitPlaces::MostPerRay / 2;

  /// The coefficients of the light at the start of an interval, in its middle and at its end.
  struct Part
  {
    Lanes3 atStart;
    Lanes3 inMiddle;
    Lanes3 atEnd;
  };

  /// The same of one ray.
  struct PartOfRay
  {
    float atStart[3];
    float inMiddle[3];
    float atEnd[3];
  };

  static IntLanes IntLanesAt(const int (&numbers)[LaneCount])
  {
    return IntLanesOf([&](int lane) { return numbers[lane]; });
  }

  void Clear()
  {
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      this->count[lane] = 0;
    }
    for (Part& part : this->open)
    {
      part = { Lanes3(0.0f), Lanes3(0.0f), Lanes3(0.0f) };
    }
    this->isOpen = LaneMask{};
  }

  // The longest interval in which matter lets the light through that a quadratic can follow.
  Lanes LongestMm(Lanes extinction) const
  {
    constexpr float MostDepth = 1.0f;
    return Min(MostDepth / Max(extinction, All(1e-30f)), All(this->intervalMm));
  }

  LaneMask MovesTo(Lanes t, LaneMask mask, Lanes extinction) const
  {
    constexpr float TooLong = 2.0f;
    const LaneMask isInside = LaneMask(t >= this->from) &
      LaneMask(t <= this->from + this->lengthMm) &
      LaneMask(this->lengthMm <= TooLong * this->LongestMm(extinction));
    return mask & ~(this->isOpen & isInside);
  }

  void Close(LaneMask mask)
  {
    const IntNumbers closes(mask);
    const Numbers start(this->from);
    const Numbers length(this->lengthMm);
    for (int light = 0; light < this->lightCount; ++light)
    {
      const Part& part = this->open[light];
      this->CloseVector(closes, part.atStart, light, &PartOfRay::atStart);
      this->CloseVector(closes, part.inMiddle, light, &PartOfRay::inMiddle);
      this->CloseVector(closes, part.atEnd, light, &PartOfRay::atEnd);
      const Lanes3 nothing(0.0f);
      this->open[light] = { Select(mask, nothing, part.atStart),
        Select(mask, nothing, part.inMiddle), Select(mask, nothing, part.atEnd) };
    }
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      if (closes.of[lane] != 0)
      {
        this->lengthsMm[this->count[lane]][lane] = length.of[lane];
        this->starts[this->count[lane]++][lane] = start.of[lane];
      }
    }
    this->isOpen &= ~mask;
  }

  void CloseVector(
    const IntNumbers& closes, const Lanes3& vector, int light, float (PartOfRay::*member)[3])
  {
    const Numbers red(vector.x);
    const Numbers green(vector.y);
    const Numbers blue(vector.z);
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      if (closes.of[lane] != 0)
      {
        float(&closed)[3] = this->parts[light][this->count[lane]][lane].*member;
        closed[0] = red.of[lane];
        closed[1] = green.of[lane];
        closed[2] = blue.of[lane];
      }
    }
  }

  float EndOf(int interval, int lane) const
  {
    return this->starts[interval][lane] + this->lengthsMm[interval][lane];
  }

  // True if an interval begins where the one before it ends.
  bool GoesOn(int interval, int lane) const
  {
    return interval > 0 && this->starts[interval][lane] == this->EndOf(interval - 1, lane);
  }

  void SetPlaces(int light, int lane, LitPlaces& places) const
  {
    int place = -1;
    for (int i = 0; i < this->count[lane]; ++i)
    {
      const PartOfRay& part = this->parts[light][i][lane];
      const float middle = 0.5f * LargestOf(part.inMiddle);
      if (!this->GoesOn(i, lane))
      {
        ++place;
        places.t[place][lane] = this->starts[i][lane];
        places.weight[place][lane] = 0.0f;
      }
      places.weight[place][lane] += LargestOf(part.atStart) + middle;
      ++place;
      places.t[place][lane] = this->EndOf(i, lane);
      places.weight[place][lane] = LargestOf(part.atEnd) + middle;
    }
    places.count[lane] = place + 1;
  }

  void AddColor(int light, int lane, const LitPlaces& places, float (&color)[3][LaneCount]) const
  {
    int place = -1;
    for (int i = 0; i < this->count[lane]; ++i)
    {
      place += this->GoesOn(i, lane) ? 0 : 1;
      const float start = places.light[place][lane];
      const float end = places.light[++place][lane];
      const float middle = __builtin_sqrtf(start * end);
      const PartOfRay& part = this->parts[light][i][lane];
      for (int channel = 0; channel < 3; ++channel)
      {
        color[channel][lane] += start * part.atStart[channel] + middle * part.inMiddle[channel] +
          end * part.atEnd[channel];
      }
    }
  }

  int lightCount;
  float intervalMm; ///< longest interval
  LaneMask isOpen;  ///< the rays that have an interval that is not closed
  Lanes from = {};  ///< where it begins
  Lanes lengthMm;
  Lanes atStart; ///< coefficients of the samples
  Lanes inMiddle;
  Lanes atEnd;
  Part open[MostShadowedLights];
  int count[LaneCount];                   ///< number of closed intervals of each ray
  float starts[MostIntervals][LaneCount]; ///< where they begin
  float lengthsMm[MostIntervals][LaneCount];
  PartOfRay parts[MostShadowedLights][MostIntervals][LaneCount];
};

// The light that samples in boxes reflect, kept until it is known how much of it reaches them.

/// The light that the samples of a packet's rays would reflect without shadows, each of which asks
/// for light by itself. At the faces of boxes the matter jumps, so that the light of one box tells
/// nothing about that of the next.
class GatheredPlaces
{
public:
  /// @param lightCount  at most MostShadowedLights
  GatheredPlaces(int lightCount, float intervalMm)
    : lightCount(lightCount)
    , intervalMm(intervalMm)
  {
  }

  /// Boxes are marched in pieces already.
  template <class Add>
  static void InPieces(Lanes, const Lanes&, const RayPart& part, Add add)
  {
    add(part);
  }

  /// True if samples do not fit before a Flush().
  bool IsFullAt(Lanes, LaneMask mask, Lanes) const
  {
    const IntLanes counts = IntLanesOf([&](int lane) { return this->count[lane]; });
    return Any(mask & (counts >= LitPlaces::MostPerRay));
  }

  /// Goes to samples. Along each ray t ascends.
  void MoveTo(Lanes t, LaneMask mask, Lanes)
  {
    const Numbers place(t);
    const IntNumbers moves(mask);
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      this->isOpen[lane] = moves.of[lane] != 0;
      if (this->isOpen[lane])
      {
        this->t[this->count[lane]++][lane] = place.of[lane];
      }
    }
  }

  /// Half of the length that a sample of a length stands for [mm]: it is a place, which is not in
  /// the middle of that length.
  Lanes HalfLengthMm(Lanes lengthMm) const
  {
    constexpr float PartOfInterval = 1.0f / 64.0f;
    return Min(0.5f * lengthMm, All(PartOfInterval * this->intervalMm));
  }

  void Add(int light, const Lanes3& color)
  {
    const Numbers channels[3] = { Numbers(color.x), Numbers(color.y), Numbers(color.z) };
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      for (int channel = 0; this->isOpen[lane] && channel < 3; ++channel)
      {
        this->colors[light][this->count[lane] - 1][lane][channel] = channels[channel].of[lane];
      }
    }
  }

  /// See GatheredLight.
  template <class Trace>
  Lanes3 Flush(float least, Trace trace)
  {
    Lanes3 sum(0.0f);
    for (int light = 0; light < this->lightCount; ++light)
    {
      LitPlaces places;
      for (int lane = 0; lane < LaneCount; ++lane)
      {
        this->SetPlaces(light, lane, places);
        places.ChooseNeeded(lane, least);
      }
      trace(light, places);
      sum = sum + this->ColorOf(light, places);
    }
    for (int& places : this->count)
    {
      places = 0;
    }
    return sum;
  }

private:
  void SetPlaces(int light, int lane, LitPlaces& places) const
  {
    places.count[lane] = this->count[lane];
    for (int place = 0; place < this->count[lane]; ++place)
    {
      places.t[place][lane] = this->t[place][lane];
      places.weight[place][lane] = LargestOf(this->colors[light][place][lane]);
    }
  }

  Lanes3 ColorOf(int light, LitPlaces& places) const
  {
    float color[3][LaneCount] = {};
    for (int lane = 0; lane < LaneCount; ++lane)
    {
      places.SetOthers(lane);
      for (int place = 0; place < this->count[lane]; ++place)
      {
        for (int channel = 0; channel < 3; ++channel)
        {
          color[channel][lane] +=
            places.light[place][lane] * this->colors[light][place][lane][channel];
        }
      }
    }
    return Lanes3(LanesAt(color[0]), LanesAt(color[1]), LanesAt(color[2]));
  }

  int lightCount;
  float intervalMm;
  bool isOpen[LaneCount] = {}; ///< the rays of the last samples
  int count[LaneCount] = {};   ///< number of places of each ray
  float t[LitPlaces::MostPerRay][LaneCount];
  float colors[MostShadowedLights][LitPlaces::MostPerRay][LaneCount][3];
};

/// How the light of samples is gathered in voxels of a kind.
template <class Voxels>
struct GatheringIn
{
  using Type = GatheredLight;
};

template <>
struct GatheringIn<AnyBoxes>
{
  using Type = GatheredPlaces;
};

// Finds the part of a light that reaches places along the rays of the eye, in full packets of rays
// to the light, whichever rays of the eye they belong to.

/// @tparam Traced  its At(places [grid space of the rays], mask) is the part of the light
template <class Traced>
class TracedPlaces
{
public:
  /// @param rays  of the eye
  TracedPlaces(const PacketRays& rays, const Traced& traced)
    : rays(rays)
    , traced(traced)
  {
  }

  /// Sets the light of the places that need it.
  void Set(LitPlaces& places)
  {
    for (int place = 0; place < LitPlaces::MostPerRay; ++place)
    {
      for (int lane = 0; lane < LaneCount; ++lane)
      {
        if (place >= places.count[lane] || !places.isNeeded[place][lane])
        {
          continue;
        }
        const int next = this->waiting.count++;
        this->waiting.light[next] = &places.light[place][lane];
        this->waiting.lane[next] = lane;
        this->waiting.t[next] = places.t[place][lane];
        this->TraceIfThereAre(LaneCount);
      }
    }
    this->TraceIfThereAre(1);
  }

private:
  /// Places that wait for a packet of rays to the light.
  struct Waiting
  {
    float* light[LaneCount];
    int lane[LaneCount];
    float t[LaneCount] = {};
    int count = 0;
  };

  void TraceIfThereAre(int enough)
  {
    if (this->waiting.count < enough)
    {
      return;
    }
    const LaneMask mask = IntLanesOf([&](int i) { return i < this->waiting.count ? -1 : 0; });
    const Numbers light(this->traced.At(this->PlacesGrid(), mask));
    for (int i = 0; i < this->waiting.count; ++i)
    {
      *this->waiting.light[i] = light.of[i];
    }
    this->waiting.count = 0;
  }

  Lanes3 PlacesGrid() const
  {
    const auto gathered = [&](Lanes numbers)
    {
      const Numbers of(numbers);
      return LanesOf(
        [&](int i) { return of.of[i < this->waiting.count ? this->waiting.lane[i] : 0]; });
    };
    const Lanes3& origin = this->rays.originGrid;
    const Lanes3& direction = this->rays.directionGrid;
    return Lanes3(gathered(origin.x), gathered(origin.y), gathered(origin.z)) +
      LanesAt(this->waiting.t) *
      Lanes3(gathered(direction.x), gathered(direction.y), gathered(direction.z));
  }

  const PacketRays& rays;
  const Traced& traced;
  Waiting waiting;
};

}

}

#endif
