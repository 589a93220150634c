#ifndef Varimarch_Core_Packets_Reach_TracedPlaces_h
#define Varimarch_Core_Packets_Reach_TracedPlaces_h

// Finds the part of a light that reaches places along the rays of the eye, in full packets of rays
// to the light, whichever rays of the eye they belong to.

#include "Core/Packets/Reach/GatheredLight.h"

namespace varimarch
{

namespace
{

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
