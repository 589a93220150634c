#ifndef Varimarch_Core_Packets_Reach_GatheredLight_h
#define Varimarch_Core_Packets_Reach_GatheredLight_h

// The light that samples reflect, kept until it is known how much of it reaches them. Light counts
// only in proportion to what an eye sees of it, which is known at the end of a stretch of the ray.

#include "Core/Packets/Reach/AbsorbingPieces.h"
#include "Core/Packets/Reach/LitPlaces.h"

namespace varimarch
{

namespace
{

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

}

}

#endif
