#ifndef Varimarch_Core_Packets_Reach_LitPlaces_h
#define Varimarch_Core_Packets_Reach_LitPlaces_h

// Places at which the part of a light that reaches them is asked for, as far as it counts.

#include "Core/Packets/PacketRays.h"
#include "Core/Packets/PacketScene.h"
#include "Core/Packets/ShaderMath.h"

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

}

}

#endif
