#ifndef Varimarch_Core_Packets_Reach_GatheredPlaces_h
#define Varimarch_Core_Packets_Reach_GatheredPlaces_h

// The light that samples in boxes reflect, kept until it is known how much of it reaches them.

#include "Core/Packets/Interpolation/AnyVoxels.h"
#include "Core/Packets/Reach/GatheredLight.h"

namespace varimarch
{

namespace
{

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

}

}

#endif
